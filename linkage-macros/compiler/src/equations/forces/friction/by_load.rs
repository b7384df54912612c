//! Friction where a load drives an input.
//!
//! The load p that leaves nothing to a drive at the input depends on all amounts x, and all reactions on p. With τ⁰ the effort
//! of the input without the load and without friction, b what a unit of the load changes in it, a what a unit of each friction
//! does, and g what a unit of the load changes in the reactions that press,
//!
//! ```text
//! p = −(τ⁰ + a·x)/b      G = G⁰ − g τ⁰/b + (A − g a/b) x
//! ```
//!
//! the equation of the [`system`](super::system), of the whole mechanism at once. Each part is a walk under nothing but
//! itself; the last walk is under everything, with p and x known.

use super::system::solved;
use super::{Rubbing, pressed};
use crate::equations::forces::pull;
use crate::equations::forces::walk::{Rubs, Walk};
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::Sym;

/// Calls `f` with the walk under everything, and the load.
pub(in crate::equations::forces) fn walked<'s, R>(
    kinematics: &Kinematics<'s>,
    rubs: Rubs<'_, 's>,
    f: impl FnOnce(&Walk<'_, 's>, Sym<'s>) -> R,
) -> R {
    let mechanism = kinematics.mechanism;
    let (input, _) = mechanism.dynamics.driven().expect("a load drives");
    let idle = pull::under(kinematics, kinematics.builder.zero());
    let contacts = Walk::start(&idle, rubs).contacts();
    let alone = |act: &dyn Fn(&mut Walk<'_, 's>)| {
        let walk = Walk::under(&idle, act);
        (walk.input_efforts()[input.index()], pressed(&walk, &contacts))
    };
    let one = kinematics.builder.integer(1);
    let (effort, free) = alone(&|walk| walk.load());
    let (by_load, pressed_by_load) = alone(&|walk| pull::put_unit_on(walk));
    let by_load = pull::provided(mechanism, by_load);
    let by_friction: Vec<_> =
        contacts.iter().map(|contact| alone(&|walk| walk.brake(contact, one))).collect();
    // The load without friction, and what each amount adds.
    let start = -(effort / by_load);
    let shares: Vec<_> = by_friction.iter().map(|(effort, _)| -(*effort / by_load)).collect();
    let with = |j: usize, own: [Sym<'s>; 2], load: Sym<'s>| {
        [0, 1].map(|axis| own[axis] + pressed_by_load[j][axis] * load)
    };
    let row = |(j, contact): (usize, &Rubbing<'s>)| {
        let changes =
            by_friction.iter().zip(&shares).map(|((_, by), share)| with(j, by[j], *share));
        contact.row(mechanism, with(j, free[j], start), changes)
    };
    let rows: Vec<_> = contacts.iter().enumerate().map(row).collect();
    let amounts = solved(&rows);
    let load = shares.iter().zip(&amounts).fold(start, |sum, (share, x)| sum + *share * *x);
    let driven = pull::under(kinematics, load);
    let mut walk = Walk::start(&driven, rubs);
    walk.load();
    for (contact, amount) in contacts.iter().zip(amounts) {
        walk.brake(contact, amount);
    }
    // All friction is on.
    walk.rubs = Rubs::Never;
    walk.back();
    f(&walk, load)
}
