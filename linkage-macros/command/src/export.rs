//! The verb `export`: solvers in other languages and formats.

use std::fs;
use std::path::{Path, PathBuf};

use linkage_compiler::{File, Options, compile};
use proc_macro2::TokenStream;

use crate::arguments::{Export, Format, Sines};
use crate::output::{self, Failure};
use crate::program::Program;
use crate::{fmu, mjcf};

pub(crate) fn run(arguments: &Export) -> Result<(), Failure> {
    // The flags that some formats alone have.
    let texts = &[Format::C, Format::St];
    let flags: [(&str, bool, &[Format]); 7] = [
        ("--only", !arguments.only.is_empty(), texts),
        ("--prefix", arguments.prefix.is_some(), texts),
        ("--sines", arguments.sines.is_some(), &[Format::St]),
        ("--kinematic", arguments.kinematic, &[Format::Fmu]),
        ("--plane", arguments.plane.is_some(), &[Format::Mjcf]),
        ("--tree", arguments.tree, &[Format::Mjcf]),
        ("--between", !arguments.between.is_empty(), &[Format::Mjcf]),
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
        Format::St => st(arguments, &program),
        Format::Fmu => fmu(arguments, &program),
        Format::Mjcf => mjcf::export(arguments, &program),
        Format::Rust => rust(arguments, &program),
    }
}

/// Writes the C of all declarations into a folder, or of none.
fn c(arguments: &Export, program: &Program) -> Result<(), Failure> {
    let (only, prefix) = (only(arguments), arguments.prefix.as_deref());
    let printed = program.all(|declaration| linkage_compiler::c(declaration, &only, prefix))?;
    let folder = folder(arguments);
    let mut files: Vec<File> = printed.into_iter().flatten().collect();
    for sets in program.machines()?.into_iter().filter(|sets| sets.len() > 1) {
        let tokens: Vec<_> = sets.iter().map(|set| set.tokens.clone()).collect();
        let carried = linkage_compiler::c_transfers(&tokens, &only, prefix);
        // The mistakes of the solvers were told with each.
        files.extend(carried.unwrap_or_default());
    }
    if !arguments.target.stale {
        leaves_others_alone(&folder, &files)?;
    }
    let files = files.into_iter().map(|file| (file.name, file.text));
    output::files(&folder, files, arguments.target.stale)
}

/// Writes the structured text of all declarations into a folder, or of none.
fn st(arguments: &Export, program: &Program) -> Result<(), Failure> {
    let (only, prefix) = (only(arguments), arguments.prefix.as_deref());
    let by_controller = arguments.sines == Some(Sines::Controller);
    let printed = program
        .all(|declaration| linkage_compiler::st(declaration, &only, prefix, by_controller))?;
    let files = printed.into_iter().flatten().map(|file| (file.name, file.text));
    output::files(&folder(arguments), files, arguments.target.stale)
}

fn only(arguments: &Export) -> Vec<&str> {
    arguments.only.iter().map(String::as_str).collect()
}

/// The folder of several files: the source's where none is given.
fn folder(arguments: &Export) -> PathBuf {
    let beside = || arguments.file.parent().unwrap_or(Path::new("")).to_path_buf();
    arguments.target.output.clone().unwrap_or_else(beside)
}

/// The beginning of the line by which a source asks for the run-time that it was printed with.
const RUN_TIME: &str = "#if LINKAGE_RUN_TIME != ";

/// Refuses a folder in which another source was printed with another run-time, which would be overwritten.
fn leaves_others_alone(folder: &Path, files: &[File]) -> Result<(), Failure> {
    let run_time = |text: &str| {
        let mut lines = text.lines();
        let name =
            lines.find(|line| line.starts_with("#include \"") && line.contains("linkage_run.h"));
        let hash = lines.find_map(|line| line.strip_prefix(RUN_TIME));
        name.zip(hash).map(|(name, hash)| (name.to_string(), hash.to_string()))
    };
    let own = files.iter().find_map(|file| run_time(&file.text));
    let Some((own, hash)) = own else { return Ok(()) };
    let Ok(entries) = fs::read_dir(folder) else { return Ok(()) };
    for path in entries.flatten().map(|entry| entry.path()) {
        let is_written =
            files.iter().any(|file| path.file_name().is_some_and(|name| *name == *file.name));
        let is_source = path.extension().is_some_and(|ending| ending == "c");
        let Some(text) =
            (is_source && !is_written).then(|| fs::read_to_string(&path).ok()).flatten()
        else {
            continue;
        };
        if run_time(&text).is_some_and(|(name, other)| name == own && other != hash) {
            return Err(Failure::Unusable(format!(
                "`{}` was printed by another version, whose run-time would be overwritten: remove it, to print it anew, or give \
                 another folder by `-o` or names of your own by `--prefix`",
                path.display()
            )));
        }
    }
    Ok(())
}

/// Writes the FMU of the only mechanism of a file, or of the chosen one.
fn fmu(arguments: &Export, program: &Program) -> Result<(), Failure> {
    let printed =
        program.all(|declaration| linkage_compiler::fmu(declaration, arguments.kinematic))?;
    let are_sets = !program.machines()?.is_empty();
    let [files] = <[Vec<File>; 1]>::try_from(printed).map_err(|several| {
        Failure::Unusable(format!(
            "`{}` holds {} mechanisms, and an FMU is one: choose it by `--machine NAME`{}",
            arguments.file.display(),
            several.len(),
            if are_sets { ", or its inputs by `--inputs SET`" } else { "" }
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
