//! The verb `export`: solvers in other languages and formats.

use std::path::Path;

use linkage_compiler::{File, Options, compile};
use proc_macro2::TokenStream;

use crate::arguments::{Export, Format};
use crate::fmu;
use crate::output::{self, Failure};
use crate::program::Program;

pub(crate) fn run(arguments: &Export) -> Result<(), Failure> {
    let belongs = |flag, format| {
        Failure::Unusable(format!("`{flag}` belongs to `export {format}`: leave it out here"))
    };
    if !arguments.only.is_empty() && arguments.format != Format::C {
        return Err(belongs("--only", "c"));
    }
    if arguments.kinematic && arguments.format != Format::Fmu {
        return Err(belongs("--kinematic", "fmu"));
    }
    match arguments.format {
        Format::C => c(arguments),
        Format::Fmu => fmu(arguments),
        Format::Rust => rust(arguments),
    }
}

/// Writes the C of all declarations into a folder, or of none.
fn c(arguments: &Export) -> Result<(), Failure> {
    let program = Program::read(&arguments.file)?;
    let only: Vec<&str> = arguments.only.iter().map(String::as_str).collect();
    let printed = program
        .all(arguments.machine.as_deref(), |declaration| linkage_compiler::c(declaration, &only))?;
    let beside = || arguments.file.parent().unwrap_or(Path::new("")).to_path_buf();
    let folder = arguments.output.clone().unwrap_or_else(beside);
    output::files(&folder, printed.into_iter().flatten(), arguments.stale)
}

/// Writes the FMU of the only mechanism of a file, or of the chosen one.
fn fmu(arguments: &Export) -> Result<(), Failure> {
    let program = Program::read(&arguments.file)?;
    let printed = program.all(arguments.machine.as_deref(), |declaration| {
        linkage_compiler::fmu(declaration, arguments.kinematic)
    })?;
    let [files] = <[Vec<File>; 1]>::try_from(printed).map_err(|several| {
        Failure::Unusable(format!(
            "`{}` holds {} mechanisms, and an FMU is one: choose it by `--machine NAME`",
            arguments.file.display(),
            several.len()
        ))
    })?;
    let path = arguments.output.clone().unwrap_or_else(|| arguments.file.with_extension("fmu"));
    fmu::write(&path, files, arguments.stale)
}

/// Prints what each declaration expands to.
fn rust(arguments: &Export) -> Result<(), Failure> {
    let program = Program::read(&arguments.file)?;
    let compiled = |declaration: TokenStream| {
        let output = compile(declaration, &Options::default());
        if output.diagnostics.is_empty() { Ok(output.tokens) } else { Err(output.diagnostics) }
    };
    let mut text = String::new();
    for tokens in program.all(arguments.machine.as_deref(), compiled)? {
        let parsed = syn::parse2(tokens).expect("what is generated is code");
        text.push_str(&prettyplease::unparse(&parsed));
    }
    output::text(arguments.output.as_deref(), &text, arguments.stale)
}
