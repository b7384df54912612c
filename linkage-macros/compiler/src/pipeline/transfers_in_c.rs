//! The C that carries poses over between the solvers of one machine.

use proc_macro2::TokenStream;

use super::printed::prefix_of;
use super::{File, program, understood};
use crate::blocks::machine_and_set;
use crate::codegen::c::selection::Selection;
use crate::codegen::c::transfers::{SetInC, Transfers};
use crate::diagnostics::{Diagnostic, Diagnostics, Failure};
use crate::exact::AtomScope;

/// Prints what carries poses over between the solvers of one machine in C99: a header and a source beside those that
/// [`c`](crate::c) prints of each. The declarations are those of one machine that [`by_set`](crate::by_set) finds, marked each
/// with its set. Nothing is printed where `only` leaves out the positions.
///
/// # Errors
/// As of [`c`](crate::c).
///
/// ```
/// let source = "pub struct Arm { ground A(0, 0); pin B(1, 1); link AB(A, B);
///               input motor { a = AB.angle } input hand { y = B.y } }";
/// let sets = linkage_compiler::by_set(source.parse().expect("these are tokens"));
/// let files = linkage_compiler::c_transfers(&sets, &[], None).expect("there is no mistake");
/// assert_eq!(files[0].name, "arm.h");
/// assert!(files[1].text.contains("LinkageStatus arm_hand_to_motor("));
/// ```
pub fn c_transfers(
    sets: &[TokenStream],
    only: &[&str],
    prefix: Option<&str>,
) -> Result<Vec<File>, Vec<Diagnostic>> {
    let _atoms = AtomScope::begin();
    let mut diagnostics = Diagnostics::new();
    let mut known = Vec::new();
    for source in sets {
        let Some([machine, set]) = machine_and_set(source) else { continue };
        let (mut mechanism, _) = understood(source.clone())?;
        let prefix = prefix_of(&mechanism, prefix, &mut diagnostics);
        let selection = Selection::of(&mechanism, &program(&mechanism), only, &mut diagnostics);
        mechanism.name = prefix.named(&mechanism.name);
        let interface = selection.interface(&mechanism);
        known.push((prefix.named(&machine), set, mechanism, interface, selection.widths, prefix));
    }
    diagnostics.finish().map_err(|Failure(mistakes)| mistakes)?;
    let Some((machine, .., widths, prefix)) = known.first() else { return Ok(Vec::new()) };
    let in_c =
        known.iter().map(|(_, set, mechanism, interface, ..)| SetInC { set, mechanism, interface });
    let transfers = Transfers {
        machine: machine.clone(),
        sets: in_c.collect(),
        widths: widths.clone(),
        prefix: prefix.clone(),
    };
    Ok(transfers.files().into_iter().map(|(name, text)| File { name, text }).collect())
}
