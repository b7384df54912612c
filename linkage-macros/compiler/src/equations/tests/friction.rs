//! Friction against Newton's and Euler's equations of every part in a hundred digits.
//!
//! The amounts that the formulas find are put on the parts as loads of known size. The full matrix then gives
//! every reaction, and these must be the formulas' own; and each amount must be its share of the
//! reaction that presses it. Together that is the fixed point, of the whole machine at once.

use std::fmt::Write;

use crate::equations::forces::{Walk, slip};
use crate::equations::kinematics::{InputMotion, Kinematics};
use crate::equations::symbol::GraphBuilder;
use crate::equations::tests::declarations::VARIANTS;
use crate::equations::tests::forces::topologies::random_mechanism;
use crate::equations::tests::forces::{evaluated, loaded, read, readings, with_every_input_asked};
use crate::equations::tests::newton_euler::{Matrix, Motion};
use crate::exact::Exact;
use crate::ir::graph::Id;
use crate::ir::interpret::Number;
use crate::model::dynamics::{Contact, Effort};
use crate::model::mechanism::{
    AngleSum, Body, Carrier, Drive, Expr, Group, GuideDirection, Mechanism, PointId, Slideway,
};
use crate::oracle::{Digits, mechanism};
use crate::passes;

/// Reference of a pose.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Against {
    /// The full matrix. It does not know that what drives a slot or turns a guide takes part of the friction
    /// along it: there, nothing rubs.
    Matrix,
    /// The virtual power of all that acts, for the efforts of inputs.
    Power,
}

/// The declaration with friction at every joint: of each pin and guide another coefficient, and of every
/// second guide the couple counts.
fn rubbing(source: &str, against: Against) -> String {
    let plain = mechanism(source);
    let name = |carrier: Carrier| plain.body_name(carrier);
    let mut added = String::new();
    for (nth, group) in plain.group_steps().enumerate() {
        let mu = 0.02 + 0.01 * nth as f64;
        for (index, joint) in group.outer.iter().enumerate() {
            let link = name(Carrier::Link(group.links[index]));
            let is_given = match &joint.drive {
                Some(Drive::Angle { angle, .. }) => {
                    angle.links.is_empty() && !plain.moves(&angle.rest)
                }
                Some(Drive::Slide(slide)) => !plain.moves(slide),
                None => false,
            };
            let turns = joint.guide().is_some_and(|guide| match plain.course(guide) {
                Some((_, GuideDirection::Along(turn))) => moves(&plain, turn),
                _ => true,
            });
            if is_given || against == Against::Matrix && turns {
                continue;
            }
            let _ = match joint.point() {
                None => write!(added, "friction {mu} on {link}"),
                Some(point) => match plain.owner(point) {
                    Some(Body::Pin(pin)) if other_at(&plain, pin).is_some() => {
                        let other = name(other_at(&plain, pin).expect("it was asked"));
                        let point = &plain.points[point.index()].name;
                        write!(
                            added,
                            "friction {mu} between {link} and {other} at {point} radius 0.01"
                        )
                    }
                    _ => {
                        let point = &plain.points[point.index()].name;
                        write!(added, "friction {mu} on {link} at {point} radius 0.02")
                    }
                },
            };
            let has_couple = joint.point().is_none() && nth % 2 == 0;
            added += if has_couple { " length 0.3;" } else { ";" };
        }
        match (group.pin, &group.links[..]) {
            (Some(pin), &[first, _]) => {
                let (link, pin) = (name(Carrier::Link(first)), &plain.points[pin.index()].name);
                let _ = write!(added, "friction {mu} on {link} at {pin} radius 0.015;");
            }
            (None, &[first, _]) if against == Against::Power || !has_moving_slot(&plain, group) => {
                let _ =
                    write!(added, "friction {mu} on {} length 0.2;", name(Carrier::Link(first)));
            }
            _ => {}
        }
    }
    let (body, _) = source.rsplit_once('}').expect("a declaration ends with a brace");
    format!("{body} {added} }}")
}

fn has_moving_slot(plain: &Mechanism, group: &Group) -> bool {
    group.inner.iter().any(|joint| match joint.slideway() {
        Some(Slideway::Slot { across, angle, .. }) => plain.moves(across) || moves(plain, angle),
        _ => false,
    })
}

fn moves(plain: &Mechanism, turn: &AngleSum) -> bool {
    plain.moves(&turn.rest) || !turn.links.is_empty()
}

/// The second of the two links that are joined by a pin.
fn other_at(plain: &Mechanism, pin: PointId) -> Option<Carrier> {
    let mut groups = plain.group_steps();
    let group = groups.find(|group| group.pin == Some(pin) && group.links.len() == 2)?;
    Some(Carrier::Link(group.links[1]))
}

/// A contact as the formulas have it.
struct Rubbed<T> {
    amount: T,
    /// The slip, and its rate where the motion is just starting.
    slip: [T; 2],
}

/// Amounts and reactions agree to a hundred digits; their share is taken in doubles. At rest and in motion.
const SETTLED: f64 = 1e-13;

fn check(
    name: &str,
    source: &str,
    inputs: &[[f64; 3]],
    (against, at_rest): (Against, bool),
) -> usize {
    let source = &rubbing(source, against);
    let mechanism = with_every_input_asked(mechanism(source));
    let frictions = &mechanism.dynamics.frictions;
    let builder = GraphBuilder::new(passes::RULES);
    let free = InputMotion::free(&mechanism, &builder);
    let moving = Kinematics::of(&builder, &mechanism, free.clone());
    let resting = Kinematics::of(&builder, &mechanism, InputMotion::at_rest(&free, &builder));
    let state = if at_rest { &resting } else { &moving };
    let walk = if at_rest { Walk::creeping(state, &moving) } else { Walk::of(state) };
    let ids = (0..frictions.len()).map(|nth| {
        let slip = slip(&moving, frictions[nth].contact).map(|slip| slip.id);
        let amount = walk.amounts.get(&nth).copied().unwrap_or(builder.zero());
        Rubbed { amount: amount.id, slip }
    });
    let ids: Vec<Rubbed<Id>> = ids.collect();
    let found = walk.found();
    let found: Vec<(Effort, Vec<Id>)> =
        found.map(|(effort, sums)| (effort, sums.iter().map(|sum| sum.id).collect())).collect();
    let (losses, motion) = (walk.losses.id, Motion::of(state));
    // Slips and motions at a unit rate of each input.
    let units = (0..mechanism.inputs.len()).map(|moving| {
        let unit = InputMotion::one_moving(&free, &builder, moving);
        let unit = Kinematics::of(&builder, &mechanism, unit);
        let slips = frictions.iter().map(|friction| slip(&unit, friction.contact)[0].id);
        (slips.collect::<Vec<_>>(), Motion::of(&unit))
    });
    let units: Vec<_> = units.collect();
    let efforts: Vec<_> = walk.input_efforts().iter().map(|effort| effort.id).collect();
    let readings = readings(&mechanism, state);
    let (given, values) = evaluated(&mechanism, builder.graph(), inputs);
    let value = |id: &Id| values[id.index()].clone();
    let mut motion = motion.values(&values);
    let zero = Digits::exact(&Exact::integer(0));
    let mut power = zero.clone();
    let mut brakings = Vec::new();
    for rubbed in &ids {
        let [slip, starting] = rubbed.slip.each_ref().map(value);
        let [slip, starting] = [&slip, &starting].map(|slip| (slip.to_f64(), slip));
        let way = if slip.0 != 0.0 || at_rest { slip.1 } else { starting.1 };
        let amount = value(&rubbed.amount);
        let braking = match way.to_f64() {
            way if way > 0.0 => amount.clone(),
            way if way < 0.0 => amount.neg(),
            _ => zero.clone(),
        };
        brakings.push(braking.clone());
        power = power.add(&braking.mul(slip.1));
    }
    let virtual_power = |(slips, unit): &(Vec<Id>, Motion<Id>)| {
        let unit = unit.values(&values);
        let pairs = motion.applied.iter().zip(&unit.applied);
        let applied = pairs.fold(zero.clone(), |sum, (now, unit)| sum.add(&now.power_at(unit)));
        let slips = slips.iter().zip(&brakings);
        slips.fold(applied, |sum, (slip, braking)| sum.sub(&braking.mul(&value(slip))))
    };
    let powers: Vec<_> = units.iter().map(virtual_power).collect();
    for (friction, braking) in frictions.iter().zip(&brakings) {
        motion.brake(state, friction.contact, braking);
    }
    let reading = |expr: &Expr| read(expr, &given, &readings, &values);
    let expected = match against {
        Against::Matrix => Matrix::solved(state, &motion, &reading),
        Against::Power => Vec::new(),
    };
    let largest = expected.iter().flat_map(|(_, numbers)| numbers).map(|n| n.to_f64().abs());
    let scale = largest.fold(1.0, f64::max);
    let close = |what: &str, found: &Digits, truth: &Digits, tolerance: f64| {
        let apart = found.sub(truth).to_f64().abs() / scale;
        let (found, truth) = (found.to_f64(), truth.to_f64());
        assert!(apart < tolerance, "{name}: {what} is {found} and should be {truth}\n{source}");
    };
    for (effort, numbers) in &expected {
        let known = found.iter().find(|(known, _)| known == effort);
        let (_, ids) = known.unwrap_or_else(|| panic!("{name}: no {effort:?}"));
        for (id, truth) in ids.iter().zip(numbers) {
            close(&format!("{effort:?}"), &value(id), truth, 1e-40);
        }
    }
    close("losses", &value(&losses), &power, 1e-40);
    for (effort, power) in efforts.iter().zip(&powers) {
        close("effort of an input", &value(effort), &power.neg(), 1e-40);
    }
    let pressed = ids.iter().zip(frictions).filter(|_| against == Against::Matrix);
    for (rubbed, friction) in pressed {
        let number = |quantity: &Expr| match quantity {
            Expr::Constant(constant) => constant.to_f64(),
            _ => unreachable!("the tests write numbers"),
        };
        let coefficient = number(&friction.coefficient.value);
        let radius = friction.radius.as_ref().map(|radius| number(&radius.value));
        let length = friction.length.as_ref().map(|length| number(&length.value));
        let effort = friction.contact.pressed_by();
        let (_, pressing) =
            expected.iter().find(|(known, _)| *known == effort).expect("it is known");
        let [x, y] = [0, 1].map(|part| pressing[part].to_f64());
        let amount = match friction.contact {
            Contact::Pin { .. } => coefficient * radius.expect("a pin has one") * x.hypot(y),
            Contact::Guide(_) => {
                coefficient * length.map_or(x.abs(), |b| x.abs().max(2.0 * y.abs() / b))
            }
        };
        let what = format!("friction at {:?}", friction.contact);
        let rubs = value(&rubbed.amount).to_f64() != 0.0;
        let amount = if rubs { amount } else { 0.0 };
        close(&what, &value(&rubbed.amount), &Digits::float(amount), SETTLED);
    }
    frictions.len()
}

#[test]
fn friction_in_every_variant_agrees_with_newton_and_euler() {
    for variant in VARIANTS {
        let source = loaded(variant.source);
        for against in [Against::Matrix, Against::Power] {
            for at_rest in [false, true] {
                let count = check(variant.name, &source, variant.inputs, (against, at_rest));
                assert!(count > 0, "{}", variant.name);
            }
        }
    }
}

const POSE: [[f64; 3]; 2] = [[0.7, 1.3, -0.6], [0.41, -0.4, 0.9]];

#[test]
fn friction_in_random_topologies_agrees_with_newton_and_euler() {
    let mut counts = [0, 0];
    for seed in 0..8 {
        let (source, _) = random_mechanism(seed, false, &POSE);
        for against in [Against::Matrix, Against::Power] {
            let how = (against, seed % 2 == 1);
            counts[against as usize] += check(&format!("seed {seed}"), &source, &POSE, how);
        }
    }
    assert!(counts[0] > 80 && counts[1] > counts[0], "{counts:?}");
}
