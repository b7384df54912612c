//! Groups that no single unknown solves, by all their angles and slides at once.
//!
//! [`hung_bodies`] hangs every body of the group on what is placed: it turns about a pin by an angle of its own, or slides by a
//! length of its own, or a drive says where it is. The pins that are left close loops, two equations each. [`loop_equations`]
//! has these equations and their derivatives, [`follow`] goes from the drawing as far as the equations are regular,
//! and [`fitted_pieces`] fits every unknown over the drive.
//!
//! At run time Newton's method begins at the fit. The theorem of Newton and Kantorovich says there whether it
//! finds the one root nearby: with the inverse R of the derivatives at the fit, η the length of the first step and K a
//! bound on R times the second derivatives, h = K η ≤ 1/2. The step that follows has h/(1 − h) squared, halved, in the
//! place of h: where h is at most [`LIMIT`], three steps leave less than rounding. Since the fit goes on without a jump, and a
//! root that is alone near it as well, a root that is certified all along is the one of the drawing.

mod fitted_pieces;
mod follow;
mod hung_bodies;
mod loop_equations;

use super::cutting::{Found, Placed, TrackedGroup};
use super::machine::Machine;
use loop_equations::System;

/// The greatest product h of Newton and Kantorovich at run time: behind 1/32 follow 5.2e-4, 1.4e-7, 9e-15 and 4e-29, so that the
/// fourth step is one at a root, and its derivatives are those of the root.
pub(crate) const LIMIT: f64 = 0.03125;

/// The reasons why a group is not tracked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Untracked {
    /// The group is none that can be: it hangs together by slides, or several inputs or parameters move it.
    Other,
    /// Something has mass or acts.
    Loaded,
    /// Its equations are singular in the drawing, or next to it.
    DeadPoint,
}

/// The way to solve a group by all its unknowns.
pub(super) fn tracked(
    machine: &Machine,
    before: &[Found],
    known: &Placed,
    group: &[usize],
) -> Result<TrackedGroup, Untracked> {
    if !machine.has_one_motion() {
        return Err(Untracked::Other);
    }
    let hung = hung_bodies::hung(machine, known, group).ok_or(Untracked::Other)?;
    if machine.is_loaded {
        return Err(Untracked::Loaded);
    }
    let system = System::of(machine, before, known, hung);
    let motion = follow::motion(&system).ok_or(Untracked::DeadPoint)?;
    fitted_pieces::fitted(system, &motion).ok_or(Untracked::DeadPoint)
}
