//! A declaration with several sets of inputs: a solver each, and the struct of their parameters.

use proc_macro2::TokenStream;

use super::parsed::Parsed;
use super::{Options, Output, common_range, resolved, solver, stub, text};
use crate::codegen::{DrivenSet, generate_sets};
use crate::diagnostics::{Diagnostic, Diagnostics, Failure};
use crate::model::mechanism::Mechanism;
use crate::model::{DrivenBySet, Stub};

/// Compiles the declaration once a set.
pub(super) fn compile(
    parsed: &Parsed,
    (source, options): (&TokenStream, &Options),
    mut diagnostics: Diagnostics,
) -> Output {
    let Parsed { tree, drivings, .. } = parsed;
    let resolved = resolved_all(parsed, &mut diagnostics);
    let notes = diagnostics.take_notes();
    let failed = diagnostics.finish().err();
    let text = options.page.then(|| text(source));
    let mut tokens = TokenStream::new();
    let mut sets = Vec::new();
    let diagnostics = failed.map_or(Vec::new(), |Failure(mistakes)| mistakes);
    tokens.extend(diagnostics.iter().map(Diagnostic::compile_error));
    for (driving, resolved) in drivings.iter().zip(&resolved) {
        let mechanism: &Mechanism = match resolved {
            Ok(mechanism) => mechanism,
            Err(Stub(mechanism)) => mechanism,
        };
        tokens.extend(match resolved {
            Ok(mechanism) if diagnostics.is_empty() => solver(mechanism, text.as_deref(), options),
            _ => stub(&driving.tree, mechanism, options),
        });
        sets.push(DrivenSet { set: &driving.set, mechanism });
    }
    let has_page = text.is_some() && diagnostics.is_empty();
    let shared = if diagnostics.is_empty() { common_range::lines(&sets) } else { Vec::new() };
    tokens.extend(generate_sets(&tree.name, &sets, (&shared, has_page)));
    let notes = if diagnostics.is_empty() { notes } else { Vec::new() };
    Output { tokens, diagnostics, notes }
}

/// The meanings of all sets. Of the mistakes that they find at one place the first is told, and it names its set where
/// another set finds none there.
pub(super) fn resolved_all(
    Parsed { drivings, are_well, .. }: &Parsed,
    diagnostics: &mut Diagnostics,
) -> Vec<Result<Mechanism, Stub>> {
    let before = diagnostics.count();
    let resolved = drivings.iter().map(|driving| {
        let resolved = resolved(&driving.tree, diagnostics);
        (resolved, diagnostics.take_since(before))
    });
    let (resolved, found): (Vec<_>, Vec<_>) = resolved.unzip();
    for (nth, (driving, own)) in drivings.iter().zip(&found).enumerate() {
        let before = || found[..nth].iter().flatten();
        let is_new = |mistake: &&Diagnostic| !before().any(|other| mistake.is_told_by(other));
        let told = own.iter().filter(is_new).map(|mistake| {
            let is_of_all =
                found.iter().all(|other| other.iter().any(|other| other.is_at(mistake)));
            if is_of_all { mistake.clone() } else { where_driven(mistake, driving) }
        });
        diagnostics.add_new(told.collect());
    }
    if !are_well {
        // More mistakes would only follow from those of the sets.
        diagnostics.forget_since(before);
    }
    resolved
}

/// The mistake with the name of the set of inputs with which it is one.
fn where_driven(mistake: &Diagnostic, driving: &DrivenBySet) -> Diagnostic {
    let set = &driving.set;
    if mistake.text().contains(&format!("`{set}`")) || mistake.is_within(driving.written) {
        return mistake.clone();
    }
    let place = format!("it is so where `{set}` drives");
    let note = mistake.note.as_ref().map_or(place.clone(), |note| format!("{note}; {place}"));
    Diagnostic { note: Some(note), ..mistake.clone() }
}
