//! The accelerations of the inputs under given drives, where joints rub.
//!
//! All amounts depend on each other: with W the power of a unit of each friction at the unit rates,
//!
//! ```text
//! q̈ = M⁻¹ (τ + Q + W x)      G = G⁰ + (∂G/∂q̈) q̈ + A x
//! ```
//!
//! so that G is affine in the amounts alone, with A + (∂G/∂q̈) M⁻¹ W: the equation of the
//! [`system`](super::system), of the whole mechanism at once. Each part is a walk under nothing but itself: all that
//! acts at q̈ = 0, the inertia of a unit of each acceleration, a unit of each friction.
//!
//! # At rest
//! Where q̇ is zero, friction acts against the motion that is just starting. One input starts in the direction
//! in which its drive leaves the band of the two creeps, and inside the band it stays: q̈ = 0. With several inputs
//! it is not known what sticks, so signs have to be smooth there.

use std::cell::OnceCell;

use super::{Rubbing, pressed, slip};
use crate::equations::forces::dynamics::{Equations, drive_at};
use crate::equations::forces::unit_rate::at_unit_rate;
use crate::equations::forces::walk::{Rubs, Walk};
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::slip_rounding::SlipRounding;
use crate::equations::symbol::Sym;
use crate::ir::graph::Id;
use crate::model::acting::Contact;
use crate::model::mechanism::Mechanism;

use super::amount::Row;
use super::system::solved;

/// The most amounts that may depend on each other: the code that is written down grows with their cube.
const MOST: usize = 8;

/// True if accelerations are known beside the mechanism's friction.
pub(in crate::equations) fn is_offered(mechanism: &Mechanism) -> bool {
    let frictions = &mechanism.dynamics.frictions;
    let is_smooth = frictions.iter().all(|friction| friction.smooth.is_some());
    frictions.len() <= MOST && (mechanism.inputs.len() == 1 || is_smooth)
}

/// The accelerations of the inputs.
pub(in crate::equations::forces) fn accelerations(kinematics: &Kinematics<'_>) -> Vec<Id> {
    let equations = Equations::of(kinematics);
    let (builder, count) = (kinematics.builder, kinematics.inputs.len());
    let drive = |input| drive_at(kinematics, input);
    let right = equations.force.iter().enumerate().map(|(input, force)| *force + drive(input));
    let coasting = equations.solve(kinematics, right.collect());
    let starts = Start::of(kinematics);
    let units: Vec<_> = (0..count).map(|input| at_unit_rate(kinematics, input)).collect();
    let inputs = InputMotion::without_second_rates(&kinematics.inputs, builder);
    let still = Kinematics::of(builder, kinematics.mechanism, inputs);
    let contacts = contacts(&still, &units[0], starts.as_ref());
    // M⁻¹ W, by friction.
    let braked = contacts.iter().map(|contact| {
        let power = units.iter().map(|unit| -(contact.way * slip(unit, contact.contact)[0]));
        equations.solve(kinematics, power.collect())
    });
    let braked: Vec<Vec<Sym<'_>>> = braked.collect();
    let rows = rows(kinematics, &still, &contacts, &coasting, &braked);
    let amounts = solved(&rows);
    let second_rate = |input: usize| {
        let braked = braked.iter().zip(&amounts);
        braked.fold(coasting[input], |sum, (by, amount)| sum + by[input] * *amount)
    };
    let second_rates = (0..count).map(|input| match &starts {
        Some(start) => start.held(second_rate(input)).id,
        None => second_rate(input).id,
    });
    second_rates.collect()
}

/// The signs of slips in a state.
struct Signs<'k, 's> {
    state: &'k Kinematics<'s>,
    rounding: OnceCell<SlipRounding<'s>>,
}

impl<'k, 's> Signs<'k, 's> {
    fn of(state: &'k Kinematics<'s>) -> Self {
        Self { state, rounding: OnceCell::new() }
    }

    /// The sign of a slip; another where it is below its rounding.
    fn sign_or(&self, contact: Contact, other: Sym<'s>) -> Sym<'s> {
        let [slip, _] = slip(self.state, contact);
        if slip.is_multiple_of_input() {
            return slip.sign_or(other);
        }
        let [least, _] =
            self.rounding.get_or_init(|| SlipRounding::of(self.state)).of_slip(contact);
        least.at_least(slip.magnitude(), other, slip.sign_or(slip.builder().zero()))
    }
}

/// The contacts at these rates, with the signs of their slips, which are those of the start where nothing
/// moves. `unit` is the state at a unit rate of the first input.
fn contacts<'s>(
    moving: &Kinematics<'s>,
    unit: &Kinematics<'s>,
    start: Option<&Start<'s>>,
) -> Vec<Rubbing<'s>> {
    let (builder, mechanism) = (moving.builder, moving.mechanism);
    let walk = Walk::start(moving, Rubs::Never);
    let mut contacts = walk.contacts();
    let Some(start) = start else { return contacts };
    let [moving, unit] = [moving, unit].map(Signs::of);
    for contact in &mut contacts {
        if mechanism.dynamics.frictions[contact.friction].smooth.is_none() {
            let by_unit = unit.sign_or(contact.contact, builder.zero());
            contact.way = moving.sign_or(contact.contact, by_unit * start.way);
        }
    }
    contacts
}

/// The equations of the amounts; `still` has no accelerations.
fn rows<'s>(
    kinematics: &Kinematics<'s>,
    still: &Kinematics<'s>,
    contacts: &[Rubbing<'s>],
    coasting: &[Sym<'s>],
    braked: &[Vec<Sym<'s>>],
) -> Vec<Row<'s>> {
    let (builder, mechanism) = (kinematics.builder, kinematics.mechanism);
    let free = pressed(&Walk::under(still, |walk| walk.load()), contacts);
    // ∂G/∂q̈, by input.
    let by_inertia = (0..kinematics.inputs.len()).map(|input| {
        let state = InputMotion::one_starting(&kinematics.inputs, builder, input);
        let state = Kinematics::of(builder, mechanism, state);
        pressed(&Walk::under(&state, |walk| walk.load_masses(builder.zero_vector())), contacts)
    });
    let by_inertia: Vec<_> = by_inertia.collect();
    let by_friction = contacts.iter().map(|contact| {
        pressed(&Walk::under(still, |walk| walk.brake(contact, builder.integer(1))), contacts)
    });
    let by_friction: Vec<_> = by_friction.collect();
    let with = |j: usize, start: [Sym<'s>; 2], second_rates: &[Sym<'s>]| {
        by_inertia.iter().zip(second_rates).fold(start, |sum, (by, second_rate)| {
            [0, 1].map(|axis| sum[axis] + by[j][axis] * *second_rate)
        })
    };
    let row = |(j, contact): (usize, &Rubbing<'s>)| {
        let changes = by_friction.iter().zip(braked).map(|(by, braked)| with(j, by[j], braked));
        contact.row(mechanism, with(j, free[j], coasting), changes)
    };
    contacts.iter().enumerate().map(row).collect()
}

/// The start of the only input from rest.
struct Start<'s> {
    rate: Sym<'s>,
    /// The sign of its acceleration where it is at rest; zero where friction holds it, and in motion.
    way: Sym<'s>,
}

impl<'s> Start<'s> {
    /// None if all signs are smooth: a motion of zero then has no friction.
    fn of(kinematics: &Kinematics<'s>) -> Option<Self> {
        let (builder, mechanism) = (kinematics.builder, kinematics.mechanism);
        let is_dry = mechanism.dynamics.frictions.iter().any(|friction| friction.smooth.is_none());
        let [input] = &kinematics.inputs[..] else { return None };
        if !is_dry {
            return None;
        }
        let rate = input.jet.rate;
        let [zero, one] = [0, 1].map(|value| builder.integer(value));
        // In motion the band is not asked: without friction it does not jam.
        let at_rest = rate.at_least(zero, zero.at_least(rate, one, zero), zero);
        let resting = InputMotion::at_rest(&kinematics.inputs, builder);
        let resting = Kinematics::of(builder, mechanism, resting);
        let end = |way| {
            let creep = input.with_rates(builder.integer(way), zero);
            let creeping = Kinematics::of(builder, mechanism, vec![creep]);
            Walk::against(&resting, Rubs::Sticking(&creeping, at_rest)).input_efforts()[0]
        };
        let drive = drive_at(kinematics, 0);
        let beyond = |end: Sym<'s>, way: Sym<'s>, other| end.at_least(drive, other, way);
        let [backwards, forwards] = [-1, 1].map(end);
        let leaves_backwards = drive.at_least(backwards, zero, -one);
        let way = at_rest * beyond(forwards, one, leaves_backwards);
        Some(Self { rate, way })
    }

    /// The acceleration, or none where friction holds.
    fn held(&self, second_rate: Sym<'s>) -> Sym<'s> {
        let zero = self.rate.builder().zero();
        // 0 ≥ |way| and 0 ≥ |q̇|
        let rests = zero.at_least(self.way.magnitude(), zero, second_rate);
        zero.at_least(self.rate.magnitude(), rests, second_rate)
    }
}
