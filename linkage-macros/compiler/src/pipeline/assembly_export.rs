//! The list of all assemblies, where a declaration asks for it.

use proc_macro2::TokenStream;

use linkage_assemblies::{ClosureDegree, PinnedGroup};

use super::{Options, code, program};
use crate::chain::assemblies::degree::degree;
use crate::codegen::c;
use crate::codegen::c::provenance::Provenance;
use crate::codegen::c::selection::Selection;
use crate::codegen::listing::Listing;
use crate::codegen::with_any;
use crate::diagnostics::Diagnostics;
use crate::ir::program::Program;
use crate::model::any_assembly::{Unlisted, any_assembly, assemblies_cannot_be_listed};
use crate::model::mechanism::Mechanism;
use crate::{equations, lower, passes};

/// The kind of the first group that is searched, and the program of its numbers.
pub(super) struct PinnedKind {
    program: Program,
    group: PinnedGroup,
    degree: ClosureDegree,
}

impl PinnedKind {
    pub(super) fn listing(&self, mechanism: &Mechanism) -> Listing<'_> {
        let pinned = lower::lower_pinned(mechanism, &self.program);
        Listing { pinned, group: &self.group, degree: &self.degree }
    }
}

/// The kind of group; none where nothing asks for it.
pub(super) fn kind(mechanism: &Mechanism) -> Option<PinnedKind> {
    mechanism.export_assemblies.as_ref()?;
    found(mechanism).ok()
}

fn found(mechanism: &Mechanism) -> Result<PinnedKind, Unlisted> {
    let derived = equations::assembling::derive(mechanism, passes::RULES)?;
    let degree = degree(&derived.group).ok_or(Unlisted::TooMany)?;
    let program = passes::optimise(&derived.program);
    Ok(PinnedKind { program, group: derived.group, degree })
}

/// False where a list is asked for and cannot be made, which is reported.
pub(super) fn can_be_listed(mechanism: &Mechanism, diagnostics: &mut Diagnostics) -> bool {
    let Some(word) = &mechanism.export_assemblies else { return true };
    match found(mechanism) {
        Ok(_) => true,
        Err(cause) => {
            assemblies_cannot_be_listed(word, cause, diagnostics);
            false
        }
    }
}

/// The solver of any assembly, and what makes it of the machine's own; nothing where nobody asks for it.
pub(super) fn solver_of_any(mechanism: &Mechanism, options: &Options) -> TokenStream {
    if mechanism.export_assemblies.is_none() {
        return TokenStream::new();
    }
    let any = any_assembly(mechanism.clone());
    let solver = code(&any.mechanism, &program(&any.mechanism), None, options);
    [solver, with_any(mechanism, &any)].into_iter().collect()
}

/// The list of a mechanism and the solver of any assembly in C: names and texts of files, none where nobody asks for them.
pub(super) fn in_c(selection: &Selection, provenance: &Provenance<'_>) -> Vec<(String, String)> {
    let mechanism = provenance.mechanism;
    let Some(kind) = kind(mechanism) else { return Vec::new() };
    let any = any_assembly(mechanism.clone());
    // Its entry points are those of the mechanism.
    let program = selection.apply(program(&any.mechanism));
    let lowered = lower::lower(&any.mechanism, &program);
    let own =
        Provenance { mechanism: &any.mechanism, prefix: provenance.prefix.clone(), ..*provenance };
    let solver = c::generate(&any.mechanism, &lowered, selection, &own);
    let listing = kind.listing(mechanism);
    let lists = c::printed_list::generate(&listing, &any, &selection.widths, provenance);
    // Both have the same run-time, which is printed with the mechanism's own.
    solver.into_iter().take(2).chain(lists).collect()
}
