//! `linkage`: the compiler of mechanisms without a Rust compiler.
//!
//! The exit status is 0 where all is well, 1 where a declaration has a mistake, 2 where the arguments or a file have
//! one.

mod arguments;
mod fmu;
mod messages;
mod program;
mod zip;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use linkage_compiler::{Options, compile};
use proc_macro2::TokenStream;

use crate::arguments::{Arguments, Command};
use crate::program::{Failure, Program};

fn main() -> ExitCode {
    match run(Arguments::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Mistakes) => ExitCode::from(1),
        Err(Failure::Unusable(why)) => {
            eprintln!("error: {why}");
            ExitCode::from(2)
        }
    }
}

fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Check { files } => check(&files),
        Command::Expand { file } => expand(&file),
        Command::C { file, output, only } => print_c(&file, &output, &only),
        Command::Fmu { file, output, kinematic } => print_fmu(&file, &output, kinematic),
    }
}

fn check(files: &[PathBuf]) -> Result<(), Failure> {
    let mut is_clean = true;
    for file in files {
        let program = Program::read(file)?;
        for declaration in program.declarations()? {
            let found = compile(declaration, &Options::default()).diagnostics;
            is_clean &= found.is_empty();
            program.report(&found);
        }
    }
    if is_clean { Ok(()) } else { Err(Failure::Mistakes) }
}

/// Prints what each declaration expands to.
fn expand(file: &Path) -> Result<(), Failure> {
    let program = Program::read(file)?;
    let compiled = |declaration: TokenStream| {
        let output = compile(declaration, &Options::default());
        if output.diagnostics.is_empty() { Ok(output.tokens) } else { Err(output.diagnostics) }
    };
    for tokens in program.all(compiled)? {
        let parsed = syn::parse2(tokens).expect("what is generated is code");
        program::print(&prettyplease::unparse(&parsed))?;
    }
    Ok(())
}

/// Writes the C of all declarations into a folder, or of none.
fn print_c(file: &Path, output: &Path, only: &[String]) -> Result<(), Failure> {
    let program = Program::read(file)?;
    let only: Vec<&str> = only.iter().map(String::as_str).collect();
    let printed = program.all(|declaration| linkage_compiler::c(declaration, &only))?;
    program::write(output, printed.into_iter().flatten())
}

/// Writes the FMU of the only mechanism of a file.
fn print_fmu(file: &Path, output: &Path, is_kinematic: bool) -> Result<(), Failure> {
    let program = Program::read(file)?;
    let printed = program.all(|declaration| linkage_compiler::fmu(declaration, is_kinematic))?;
    match <[_; 1]>::try_from(printed) {
        Ok([files]) => fmu::write(output, files),
        Err(several) => Err(Failure::Unusable(format!(
            "`{}` holds {} mechanisms, and an FMU is one: give it a file of its own",
            file.display(),
            several.len()
        ))),
    }
}
