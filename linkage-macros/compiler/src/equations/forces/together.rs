//! Sums over all masses and springs: energy, shaking force and moment, centre of mass.
//!
//! ```text
//! T = ½ Σ (m v² + J ω²)      V = −Σ m g·r_G + Σ ½ k (L − L₀)² + Σ ½ k φ²
//! shaking: −Σ m a_G, and about the origin −Σ (r_G × m a_G + J α)
//! centre of mass: Σ m r_G / Σ m
//! ```
//!
//! Shaking is inertia's alone: weight and applied forces are left out, and so is what holds the ground.

use crate::equations::forces::elastic;
use crate::equations::forces::loads::{Centre, Inertia, Masses, gravity, of_masses};
use crate::equations::forces::reduced::Reduced;
use crate::equations::forces::unit_rate::at_unit_rate;
use crate::equations::kinematics::Kinematics;
use crate::equations::motion::Frame;
use crate::equations::symbol::{Sym, Vector};

/// Kinetic and potential energy. Of a single input T = ½ M q̇², M at its unit rate.
pub(super) fn energy<'s>(kinematics: &Kinematics<'s>) -> [Sym<'s>; 2] {
    let masses = Reduced::of(kinematics);
    let kinetic = match &kinematics.inputs[..] {
        [only] => {
            let unit = at_unit_rate(kinematics, 0);
            masses.inertia(&unit, &unit) * only.jet.rate.squared()
        }
        _ => masses.inertia(kinematics, kinematics),
    };
    let lifted = moments(kinematics, kinematics.builder.integer(1))[0].dot(gravity(kinematics));
    let kinetic = kinetic.half();
    let [first, rest @ ..] = elastic::EVERY.map(|kind| (kind.energy)(kinematics));
    let stored = rest.into_iter().fold(first, |sum, energy| sum + energy);
    [kinetic, stored - lifted]
}

/// The force on the ground, and the couple about the origin.
pub(super) fn shaking<'s>(kinematics: &Kinematics<'s>) -> [Sym<'s>; 3] {
    let (masses, none) = (Masses::of(kinematics), kinematics.builder.zero_vector());
    let (mut force, mut couple) = (none, kinematics.builder.zero());
    let mut act = |at: Vector<'s>, by: Vector<'s>, moment: Sym<'s>| {
        force = force + by;
        couple = couple + (at.cross(by) + moment);
    };
    for (link, inertia) in masses.by_link() {
        let own = of_masses(kinematics, link, inertia, none);
        act(kinematics.link(link).frame.origin.position(), own.force, own.moment);
    }
    for &(point, mass) in &masses.points {
        let motion = kinematics.point(point);
        act(motion.position(), -(mass * motion.acceleration), kinematics.builder.zero());
    }
    for moving in &masses.moving {
        let alpha = kinematics.link(moving.link).frame.direction.alpha;
        let back = -(moving.mass * moving.motion.acceleration);
        act(moving.motion.position(), back, -(moving.inertia * alpha));
    }
    [force.x, force.y, couple]
}

/// Position, velocity and acceleration of the centre of all masses.
pub(in crate::equations) fn centre_of_mass<'s>(kinematics: &Kinematics<'s>) -> [Vector<'s>; 3] {
    let masses = Masses::of(kinematics);
    let zero = kinematics.builder.zero();
    let of_links = masses.by_link().into_iter().map(|(_, inertia)| inertia.mass);
    let of_points = masses.points.iter().map(|(_, mass)| *mass);
    let of_moving = masses.moving.iter().map(|moving| moving.mass);
    let total = of_links.chain(of_points).chain(of_moving).fold(zero, |sum, mass| sum + mass);
    moments(kinematics, total.recip())
}

/// Σ m r of all masses, and its velocity and acceleration, in shares.
fn moments<'s>(kinematics: &Kinematics<'s>, share: Sym<'s>) -> [Vector<'s>; 3] {
    let masses = Masses::of(kinematics);
    let mut sums = [kinematics.builder.zero_vector(); 3];
    let mut add = |mass: Sym<'s>, rates: [Vector<'s>; 3]| {
        for (sum, rate) in sums.iter_mut().zip(rates) {
            *sum = *sum + mass * rate;
        }
    };
    for (link, inertia) in masses.by_link() {
        let first = inertia.first.map(|moment| share * moment);
        let own = Inertia { mass: share * inertia.mass, first, ..inertia };
        let moment = Centre::of(kinematics, link, own).first_moment();
        let Frame { origin, direction } = kinematics.link(link).frame;
        add(own.mass, [origin.position(), origin.velocity, origin.acceleration]);
        let turned = direction.alpha * moment.normal() - direction.omega.squared() * moment;
        add(kinematics.builder.integer(1), [moment, direction.omega * moment.normal(), turned]);
    }
    let points = masses.points.iter().map(|&(point, mass)| (mass, kinematics.point(point)));
    let moving = masses.moving.iter().map(|moving| (moving.mass, moving.motion));
    for (mass, motion) in points.chain(moving) {
        add(share * mass, [motion.position(), motion.velocity, motion.acceleration]);
    }
    sums
}
