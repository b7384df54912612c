//! `linkage`: the compiler of mechanisms without a Rust compiler.
//!
//! The exit status is 0 where all is well, 1 where a machine has a mistake or a file is stale, 2 where the arguments
//! or a file cannot be used.

mod arguments;
mod export;
mod fmu;
mod import;
mod messages;
mod output;
mod program;
mod zip;

use std::path::PathBuf;
use std::process::ExitCode;

use linkage_compiler::{Options, compile};

use crate::arguments::Command;
use crate::output::Failure;
use crate::program::Program;

fn main() -> ExitCode {
    match run(arguments::parsed().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Told) => ExitCode::from(1),
        Err(Failure::Unusable(why)) => {
            eprintln!("error: {why}");
            ExitCode::from(2)
        }
    }
}

fn run(command: Command) -> Result<(), Failure> {
    match command {
        Command::Check { files, machine } => check(&files, machine.as_deref()),
        Command::Import(arguments) => import::run(&arguments),
        Command::Export(arguments) => export::run(&arguments),
    }
}

fn check(files: &[PathBuf], machine: Option<&str>) -> Result<(), Failure> {
    let mut is_clean = true;
    for file in files {
        let program = Program::read(file)?;
        for declaration in program.declarations(machine)? {
            let found = compile(declaration, &Options::default()).diagnostics;
            is_clean &= found.is_empty();
            program.report(&found);
        }
    }
    if is_clean { Ok(()) } else { Err(Failure::Told) }
}
