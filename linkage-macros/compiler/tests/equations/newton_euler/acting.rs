//! Loads on the parts: weight and inertia of each mass for itself, forces, torques and springs, each
//! written down as in a textbook, in ground axes.

use super::stops::stops;
use super::{Applied, Part, ids, is_moving, part_of, part_of_carrier, part_of_point};
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::{Sym, Vector};
use crate::function::Function;
use crate::ir::graph::Id;
use crate::model::acting::{Axes, Ends, Force, MassPlace, Spring};
use crate::model::mechanism::{Carrier, PointId, Scalar};

pub(super) fn acting(kinematics: &Kinematics<'_>) -> Vec<Applied<Id>> {
    let (masses, applied) = (masses(kinematics), applied(kinematics));
    let (springs, stops) = (springs(kinematics), stops(kinematics));
    masses.into_iter().chain(applied).chain(springs).chain(stops).collect()
}

/// Weight and inertia of every mass: m (g − a_G) at G and −J α.
fn masses(kinematics: &Kinematics<'_>) -> Vec<Applied<Id>> {
    let (builder, mechanism) = (kinematics.builder, kinematics.mechanism);
    let value = |expr: &Scalar| kinematics.jet(expr).value;
    let g = match &mechanism.dynamics.gravity {
        Some([x, y]) => Vector { x: value(x), y: value(y) },
        None => builder.zero_vector(),
    };
    let of = |(index, declared): (usize, &crate::model::acting::Mass)| {
        let mass = value(&declared.mass.value);
        let (link, part, at, inertia) = match &declared.place {
            MassPlace::Pin(point) => {
                let motion = kinematics.point(*point);
                return vec![Applied {
                    part: Part::Pin(*point),
                    at: ids(motion.position()),
                    force: ids(mass * (g - motion.acceleration)),
                    couple: builder.zero().id,
                    velocity: ids(motion.velocity),
                    omega: builder.zero().id,
                }];
            }
            MassPlace::Point(link, point) => {
                let carrier = Carrier::Link(*link);
                let at = kinematics.coordinates(carrier, *point);
                let part = part_of_point(kinematics, carrier, *point);
                (*link, part, at, value(&declared.inertia.value))
            }
            MassPlace::At(link, at) => {
                let part = match is_moving(mechanism, at) {
                    true => Part::Mass(index),
                    false => Part::Link(*link),
                };
                (*link, part, kinematics.jets(at), value(&declared.inertia.value))
            }
            MassPlace::Uniform(link, length) => {
                let length = kinematics.jet(length);
                let zero = kinematics.jet(&Scalar::zero());
                let inertia = mass * length.value * length.value / builder.integer(12);
                let at = [length.times(builder.integer(1).half()), zero];
                (*link, Part::Link(*link), at, inertia)
            }
        };
        let frame = kinematics.link(link).frame;
        let motion = frame.place(at[0], at[1]);
        let weight = Applied {
            part,
            at: ids(motion.position()),
            force: ids(mass * (g - motion.acceleration)),
            couple: builder.zero().id,
            velocity: ids(motion.velocity),
            omega: frame.direction.omega.id,
        };
        // Its couple is the link's, with which it turns.
        let turned = turn(kinematics, Carrier::Link(link), -(inertia * frame.direction.alpha));
        vec![weight, turned]
    };
    mechanism.dynamics.masses.iter().enumerate().flat_map(of).collect()
}

/// The declaration's forces and torques.
fn applied(kinematics: &Kinematics<'_>) -> Vec<Applied<Id>> {
    let dynamics = &kinematics.mechanism.dynamics;
    let value = |expr: &Scalar| kinematics.jet(expr).value;
    let force = |point: PointId, value: Vector<'_>| force(kinematics, point, value);
    let mut all = Vec::new();
    for declared in &dynamics.forces {
        match declared {
            Force::At { point, value: [x, y], axes } => {
                let (x, y) = (value(x), value(y));
                let u = match axes {
                    Axes::Body(carrier) => kinematics.carrier(*carrier).direction.u,
                    Axes::Guide(guide) => kinematics.guide(*guide).direction.u,
                };
                all.push(force(*point, x * u + y * u.normal()));
            }
            Force::Between { points: [p, q], value: push } => {
                let d = kinematics.point(*q).position() - kinematics.point(*p).position();
                let along = value(push) / (d.x * d.x + d.y * d.y).sqrt();
                all.push(force(*p, -(along * d)));
                all.push(force(*q, along * d));
            }
        }
    }
    for torque in &dynamics.torques {
        let couple = value(&torque.value);
        all.push(turn(kinematics, torque.on, couple));
        all.extend(torque.against.map(|against| turn(kinematics, against, -couple)));
    }
    all
}

/// A force on a point, and so on the part that it belongs to.
pub(super) fn force(kinematics: &Kinematics<'_>, point: PointId, force: Vector<'_>) -> Applied<Id> {
    let (motion, zero) = (kinematics.point(point), kinematics.builder.zero().id);
    Applied {
        part: part_of(kinematics, point),
        at: ids(motion.position()),
        force: ids(force),
        couple: zero,
        velocity: ids(motion.velocity),
        omega: zero,
    }
}

pub(super) fn turn(kinematics: &Kinematics<'_>, carrier: Carrier, couple: Sym<'_>) -> Applied<Id> {
    let zero = kinematics.builder.zero().id;
    Applied {
        part: part_of_carrier(carrier),
        at: [zero; 2],
        force: [zero; 2],
        couple: couple.id,
        velocity: [zero; 2],
        omega: kinematics.carrier(carrier).direction.omega.id,
    }
}

/// Springs and dampers, from absolute positions, velocities and unit vectors.
fn springs(kinematics: &Kinematics<'_>) -> Vec<Applied<Id>> {
    let of = |spring: &Spring| {
        let [k, c, free] = [&spring.stiffness, &spring.damping, &spring.free]
            .map(|number| kinematics.jet(&number.value).value);
        match spring.ends {
            Ends::Points([p, q]) => {
                let [a, b] = [p, q].map(|point| kinematics.point(point));
                let (d, v) = (b.position() - a.position(), b.velocity - a.velocity);
                let length = (d.x * d.x + d.y * d.y).sqrt();
                let pull = k * (length - free) + c * ((d.x * v.x + d.y * v.y) / length);
                let on_p = (pull / length) * d;
                [force(kinematics, p, on_p), force(kinematics, q, -on_p)]
            }
            Ends::Bodies([a, b]) => {
                let [u, v] = [a, b].map(|body| kinematics.carrier(body).direction);
                let (cos, sin) = (free.cos(), free.sin());
                let slack = [u.u.x * cos - u.u.y * sin, u.u.x * sin + u.u.y * cos];
                let sine = v.u.y * slack[0] - v.u.x * slack[1];
                let turned = sine.apply2(Function::Atan2, v.u.x * slack[0] + v.u.y * slack[1]);
                let back = k * turned + c * (v.omega - u.omega);
                [turn(kinematics, a, back), turn(kinematics, b, -back)]
            }
        }
    };
    kinematics.mechanism.dynamics.springs.iter().flat_map(of).collect()
}
