//! The verb `check`: mistakes and notes.

use std::path::PathBuf;

use linkage_compiler::Diagnostic;
use serde_json::{Value, json};

use crate::arguments::Check;
use crate::messages::{self, Place};
use crate::output::{self, Failure};
use crate::program::Program;
use crate::report::Report;

/// Looks at every declaration of the files, after all of them were found.
pub(crate) fn run(arguments: &Check) -> Result<(), Failure> {
    let read = |file: &PathBuf| Program::read(file, &arguments.chosen);
    let programs = arguments.files.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    let mut all = Vec::new();
    for program in &programs {
        let declarations = program.declarations()?;
        all.extend(declarations.into_iter().map(|declaration| (program, declaration)));
    }
    let (mut report, mut values) = (Report::default(), Vec::new());
    let mut told: Vec<(&PathBuf, Diagnostic)> = Vec::new();
    for (program, declaration) in &all {
        let mut found = linkage_compiler::check(declaration.tokens.clone());
        // A mistake that sets of inputs share is told once, and of those that they find at one place the first.
        let is_told = |one: &Diagnostic| {
            told.iter().any(|(path, other)| *path == &program.path && one.is_told_by(other))
        };
        found.retain(|one| !is_told(one));
        told.extend(found.iter().map(|one| (&program.path, one.clone())));
        if arguments.json {
            let told = found.iter().map(|one| value(one, &program.place(declaration, one)));
            values.push(json!({
                "file": program.path,
                "mechanism": declaration.name(),
                "messages": told.collect::<Vec<_>>(),
            }));
            report.count(declaration, &found);
        } else {
            report.tell(program, declaration, &found);
        }
    }
    if !arguments.json {
        return report.close_with_counts();
    }
    output::print(&format!("{:#}\n", Value::from(values)))?;
    report.result()
}

/// A message as JSON; lines and columns count from one, and the end is behind the last token.
fn value(found: &Diagnostic, place: &Place<'_>) -> Value {
    json!({
        "level": messages::word(found.level),
        "message": found.message,
        "help": found.note,
        "in": place.name,
        "from": [place.from.line, place.from.column + 1],
        "to": [place.to.line, place.to.column + 1],
    })
}
