//! The verb `export`: solvers in other languages and formats.

use std::path::Path;

use linkage_compiler::{File, Options, compile};
use proc_macro2::TokenStream;

use crate::arguments::{Export, Format};
use crate::fmu;
use crate::output::{self, Failure};
use crate::program::Program;

pub(crate) fn run(arguments: &Export) -> Result<(), Failure> {
    // The flags that some formats alone have.
    let flags: [(&str, bool, &[Format]); 2] = [
        ("--only", !arguments.only.is_empty(), &[Format::C]),
        ("--kinematic", arguments.kinematic, &[Format::Fmu]),
    ];
    let own = |formats: &[Format]| formats.contains(&arguments.format);
    if let Some((flag, _, formats)) =
        flags.iter().find(|(_, given, formats)| *given && !own(formats))
    {
        let formats: Vec<_> =
            formats.iter().map(|format| format!("`export {}`", format.word())).collect();
        let why = format!("`{flag}` belongs to {}: leave it out here", formats.join(" and "));
        return Err(Failure::Unusable(why));
    }
    let program = Program::read(&arguments.file, &arguments.chosen)?;
    match arguments.format {
        Format::C => c(arguments, &program),
        Format::Fmu => fmu(arguments, &program),
        Format::Rust => rust(arguments, &program),
    }
}

/// Writes the C of all declarations into a folder, or of none.
fn c(arguments: &Export, program: &Program) -> Result<(), Failure> {
    let only: Vec<&str> = arguments.only.iter().map(String::as_str).collect();
    let printed = program.all(|declaration| linkage_compiler::c(declaration, &only))?;
    let beside = || arguments.file.parent().unwrap_or(Path::new("")).to_path_buf();
    let folder = arguments.target.output.clone().unwrap_or_else(beside);
    let files = printed.into_iter().flatten().map(|file| (file.name, file.text));
    output::files(&folder, files, arguments.target.stale)
}

/// Writes the FMU of the only mechanism of a file, or of the chosen one.
fn fmu(arguments: &Export, program: &Program) -> Result<(), Failure> {
    let printed =
        program.all(|declaration| linkage_compiler::fmu(declaration, arguments.kinematic))?;
    let [files] = <[Vec<File>; 1]>::try_from(printed).map_err(|several| {
        Failure::Unusable(format!(
            "`{}` holds {} mechanisms, and an FMU is one: choose it by `--machine NAME`",
            arguments.file.display(),
            several.len()
        ))
    })?;
    let beside = || arguments.file.with_extension("fmu");
    let path = arguments.target.output.clone().unwrap_or_else(beside);
    fmu::write(&path, files, arguments.target.stale)
}

/// Prints what each declaration expands to.
fn rust(arguments: &Export, program: &Program) -> Result<(), Failure> {
    let compiled = |declaration: TokenStream| {
        let output = compile(declaration, &Options::default());
        if output.diagnostics.is_empty() { Ok(output.tokens) } else { Err(output.diagnostics) }
    };
    let mut text = String::new();
    for tokens in program.all(compiled)? {
        let parsed = syn::parse2(tokens).expect("what is generated is code");
        text.push_str(&prettyplease::unparse(&parsed));
    }
    output::text(arguments.target.output.as_deref(), &text, arguments.target.stale)
}
