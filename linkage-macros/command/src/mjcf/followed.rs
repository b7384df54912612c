//! Joints that follow the only one that is driven, by polynomials: a model without loops.

use std::f64::consts::{PI, TAU};

use linkage_compiler::{DrawnPose, PlanarQuantity, drawing, page};

use super::driven::InModel;
use super::tree::{Joint, Machine, Node};
use crate::pose::PoseConditions;
use crate::program::Declaration;
use crate::values::{FlagValue, known};

/// The joints that follow, and the one that is driven.
pub(super) struct Followed {
    pub driver: String,
    /// A joint, its polynomial by rising powers, and its worst error in rad or m.
    pub joints: Vec<(String, [f64; 5], f64)>,
}

/// The poses at which polynomials are fitted, and ten times as many at which they are compared.
const FITTED: usize = 33;

/// The worst error that is written, in rad, or in sizes of the machine.
const WORST: f64 = 1e-3;

/// # Errors
/// Several inputs, one that is no joint, a range without all its poses, and joints that no such polynomial follows.
pub(super) fn fitted(
    machine: &Machine,
    declaration: &Declaration,
    between: &[String],
) -> Result<Followed, String> {
    let [input] = &machine.parts.inputs[..] else {
        return Err("`--tree` follows one input; choose a set with one by `--inputs`".to_string());
    };
    let of = input.of.as_ref().map(|(of, factor)| (machine.in_model(of), *factor));
    let Some((Ok(InModel::Joint(driver)), factor)) = of else {
        return Err(format!("`--tree` follows a joint, and `{}` is none", input.name));
    };
    let ends = ends(machine, declaration, between, (&driver, factor))?;
    let at = |value: f64| poses(machine, declaration, value);
    // An input is a factor times the joint's number and a constant.
    let joint = |value: f64| (value - input.drawn) / factor;
    let (middle, half) = ((ends[0] + ends[1]) / 2.0, (ends[1] - ends[0]) / 2.0);
    let nodes = (0..FITTED).map(|k| middle + half * (PI * (k as f64 + 0.5) / FITTED as f64).cos());
    let mut samples = Vec::new();
    for value in nodes {
        samples.push((joint(value), at(value)?));
    }
    let mut joints = Vec::new();
    for (place, node) in machine.nodes.iter().enumerate() {
        let name = machine.joint_name(node);
        if name == driver {
            continue;
        }
        let points: Vec<[f64; 2]> = samples.iter().map(|(x, pose)| [*x, pose[place]]).collect();
        joints.push((place, name, least_squares(&points)));
    }
    let mut worst = vec![0.0_f64; joints.len()];
    for k in 0..=10 * FITTED {
        let value = ends[0] + (ends[1] - ends[0]) * k as f64 / (10 * FITTED) as f64;
        let (x, pose) = (joint(value), at(value)?);
        for ((place, _, coefficients), worst) in joints.iter().zip(&mut worst) {
            let fitted = coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c);
            *worst = worst.max((fitted - pose[*place]).abs());
        }
    }
    for ((place, name, _), worst) in joints.iter().zip(&worst) {
        let size = match machine.nodes[*place].joint {
            Joint::Hinge(_) => 1.0,
            Joint::Slide(_) => machine.size(),
        };
        if *worst > WORST * size {
            return Err(format!(
                "`{name}` is off by {worst:.1e} from a polynomial of degree 4; give a shorter range by `--between {}=…`",
                input.name
            ));
        }
    }
    let joints = joints.into_iter().zip(worst);
    Ok(Followed { driver, joints: joints.map(|((_, name, c), worst)| (name, c, worst)).collect() })
}

/// The ends of the input: those that are given, or those of its stop.
fn ends(
    machine: &Machine,
    declaration: &Declaration,
    between: &[String],
    (driver, factor): (&str, f64),
) -> Result<[f64; 2], String> {
    let input = &machine.parts.inputs[0];
    if let Some(text) = between.last() {
        let parts = page(declaration.tokens.clone()).map_err(|_| "it has mistakes".to_string())?;
        let inputs = known(&parts.inputs);
        let why = |failure| match failure {
            crate::output::Failure::Unusable(why) => why,
            crate::output::Failure::Told => String::new(),
        };
        let given = FlagValue::read("between", text).map_err(why)?;
        let nth = given.of(&inputs, "input").map_err(why)?;
        let ends = given.ends(inputs[nth]).map_err(why)?;
        return Ok([*ends.start(), *ends.end()]);
    }
    let of = input.of.as_ref().map(|(of, _)| of);
    let is_of = |quantity: &PlanarQuantity| Some(quantity) == of;
    let stop = machine.parts.stops.iter().find(|stop| is_of(&stop.of));
    let node = machine.nodes.iter().find(|node| machine.joint_name(node) == driver);
    let drawn = node.map_or(0.0, |node| machine.drawn(node));
    // The stop is that of the joint, of which the input is a factor and a constant.
    let of_input = |end: f64| input.drawn + factor * (end - drawn);
    let sorted = |ends: [f64; 2]| if ends[0] < ends[1] { ends } else { [ends[1], ends[0]] };
    stop.map(|stop| sorted(stop.ends.map(of_input))).ok_or_else(|| {
        format!("`{0}` has no stop; give its range by `--between {0}=FROM..TO`", input.name)
    })
}

/// The numbers of all joints less those of the drawing, at a value of the input.
fn poses(machine: &Machine, declaration: &Declaration, value: f64) -> Result<Vec<f64>, String> {
    let mut conditions = PoseConditions::new();
    let pose = drawing(declaration.tokens.clone(), &[value], &mut conditions)
        .map_err(|_| "it has mistakes".to_string())?;
    conditions.first().map_err(|error| format!("at {value:?}: {error}"))?;
    let turns: Vec<f64> =
        (0..machine.parts.bodies.len()).map(|body| turned(machine, &pose, body)).collect();
    let of = |node: &Node| match node.joint {
        Joint::Hinge(_) => {
            let turn = turns[node.body] - node.parent.map_or(0.0, |parent| turns[parent]);
            turn - TAU * (turn / TAU).round()
        }
        Joint::Slide(guide) => {
            let own = machine.body(node.body);
            let Some((pin, [x, y])) = own.pins.first() else { return 0.0 };
            let (sin, cos) = machine.parts.guides[guide].along.sin_cos();
            let [now_x, now_y] = point(&pose, pin).unwrap_or([*x, *y]);
            cos * (now_x - x) + sin * (now_y - y)
        }
    };
    Ok(machine.nodes.iter().map(of).collect())
}

fn point(pose: &DrawnPose, name: &str) -> Option<[f64; 2]> {
    let at = pose.plan.points.iter().position(|point| point == name)?;
    Some([pose.numbers[2 * at], pose.numbers[2 * at + 1]])
}

/// The turn of a body from the drawing.
fn turned(machine: &Machine, pose: &DrawnPose, body: usize) -> f64 {
    let own = machine.body(body);
    let [(first, from), .., (last, to)] = &own.pins[..] else { return 0.0 };
    let (Some(here), Some(there)) = (point(pose, first), point(pose, last)) else { return 0.0 };
    let angle = |p: [f64; 2], q: [f64; 2]| (q[1] - p[1]).atan2(q[0] - p[0]);
    angle(here, there) - angle(*from, *to)
}

/// The polynomial of degree four with the least squares, by the orthogonal polynomials of the points.
fn least_squares(points: &[[f64; 2]]) -> [f64; 5] {
    let (mut basis, mut sum): (Vec<[f64; 5]>, [f64; 5]) = (Vec::new(), [0.0; 5]);
    let value =
        |polynomial: &[f64; 5], x: f64| polynomial.iter().rev().fold(0.0, |sum, c| sum * x + c);
    let scale = points.iter().fold(0.0_f64, |most, [x, _]| most.max(x.abs()));
    let dot = |p: &[f64; 5], f: &dyn Fn(usize, f64) -> f64| -> f64 {
        points.iter().enumerate().map(|(nth, [x, _])| value(p, x / scale) * f(nth, x / scale)).sum()
    };
    for degree in 0..5 {
        let mut own = [0.0; 5];
        own[degree] = 1.0;
        // Twice is enough.
        for _ in 0..2 {
            for other in &basis {
                let share = dot(&own, &|_, x| value(other, x));
                own.iter_mut().zip(other).for_each(|(own, other)| *own -= share * other);
            }
        }
        let length = dot(&own, &|_, x| value(&own, x)).sqrt();
        own.iter_mut().for_each(|own| *own /= length);
        let share = dot(&own, &|nth, _| points[nth][1]);
        sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += share * own);
        basis.push(own);
    }
    let mut power = 1.0;
    sum.map(|c| {
        let own = c / power;
        power *= scale;
        own
    })
}
