//! The poses of machines beside their drawings.

use super::machine::{Machine, Places};
use crate::ir::interpret::Number;
use crate::oracle::Digits;

fn place<'p>(pins: &'p Places<Digits>, name: &str) -> &'p [Digits; 2] {
    &pins.iter().find(|(known, _)| known == name).expect("every pin is an output").1
}

/// The product of the conjugate of the first vector with the second: the cosine and the sine
/// between them times their lengths.
fn product(a: [Digits; 2], b: [Digits; 2]) -> [f64; 2] {
    let [dot, cross] =
        [a[0].mul(&b[0]).add(&a[1].mul(&b[1])), a[0].mul(&b[1]).sub(&a[1].mul(&b[0]))];
    [dot.to_f64(), cross.to_f64()]
}

fn between(pins: &Places<Digits>, from: &str, to: &str) -> [Digits; 2] {
    let [from, to] = [place(pins, from), place(pins, to)];
    [to[0].sub(&from[0]), to[1].sub(&from[1])]
}

/// The units in the last place of the machine's size by which a drawn pose may be off, and by which the distances in a
/// body may: 1e-12 and 1e-11 in double precision.
const DRAWN: f64 = 1e-12 / f64::EPSILON;
const RIGID: f64 = 1e-11 / f64::EPSILON;

/// In single precision the pins are where they are drawn, and ten poses beside it keep the bodies rigid, in as many
/// units in the last place as in double precision. The count of poses.
pub(super) fn single_precision_stands_where_it_is_drawn(name: &str, machine: &Machine) -> usize {
    let drawn = [machine.drawn::<f64>(true), machine.drawn::<f64>(false)].concat();
    let size = drawn.iter().flat_map(|(_, at)| at).fold(0.0_f64, |size, x| size.max(x.abs()));
    let unit = f64::from(f32::EPSILON) * size;
    let inputs = machine.drawn_inputs();
    // The input is rounded: compared with double precision at the same one.
    let rounded: Vec<_> = inputs.iter().map(|input| f64::from(*input as f32)).collect();
    let now = widened(machine.pins::<f32>(&rounded));
    let wide = machine.pins::<f64>(&rounded);
    for ((pin, found), (_, wanted)) in now.iter().zip(&wide) {
        for (found, wanted) in found.iter().zip(wanted) {
            let off = (found - wanted).abs() / unit;
            assert!(off < DRAWN, "{name}: {pin} is off by {off} units");
        }
    }
    let mut poses = 0;
    for step in [-5, -4, -3, -2, -1, 1, 2, 3, 4, 5] {
        let beside: Vec<_> = inputs.iter().map(|input| input + 1e-3 * f64::from(step)).collect();
        // An interval may end next to the drawing.
        if machine.rigid(&beside, 1e-11).is_none() {
            continue;
        }
        let now = widened(machine.pins::<f32>(&beside));
        for (_, link) in machine.links() {
            for (i, a) in link.iter().enumerate() {
                for b in &link[..i] {
                    let [was, is] = [&drawn, &now].map(|pins| distance(pins, a, b));
                    let off = (was - is).abs() / unit;
                    assert!(off < RIGID, "{name}: {a}, {b} off by {off} units");
                }
            }
        }
        poses += 1;
    }
    poses
}

fn widened<T: Into<f64> + Copy>(pins: Vec<(String, [T; 2])>) -> Vec<(String, [f64; 2])> {
    pins.into_iter().map(|(name, at)| (name, at.map(Into::into))).collect()
}

fn distance(pins: &Places<f64>, a: &str, b: &str) -> f64 {
    let at = |name: &str| pins.iter().find(|(known, _)| known == name).expect("a pin").1;
    let [p, q] = [a, b].map(at);
    (q[0] - p[0]).hypot(q[1] - p[1])
}

/// In a hundred digits every pin is where it is drawn, and beside it every body stays rigid.
pub(super) fn every_pin_is_where_it_is_drawn_and_every_body_stays_rigid(
    name: &str,
    machine: &Machine,
) {
    let inputs = machine.drawn_inputs();
    let now = machine.pins(&inputs);
    for (pin, at) in machine.drawn(false) {
        let found = place(&now, &pin);
        for i in 0..2 {
            let off = found[i].sub(&at[i]).to_f64().abs();
            // The inputs are floats of the drawing's angles.
            assert!(off < 1e-12, "{name}: {pin} is off by {off:e}");
        }
    }
    let drawn = [machine.drawn(true), machine.drawn(false)].concat();
    let beside: &[i32] = match machine.mechanism.unknowns.is_empty() {
        true => &[-5, -1, 2, 4],
        // A search takes a second.
        false => &[1],
    };
    for &step in beside {
        let inputs: Vec<_> = inputs.iter().map(|input| input + 1e-6 * f64::from(step)).collect();
        let now = machine.pins(&inputs);
        for (_, link) in machine.links() {
            let [first, rest @ ..] = &link[..] else { continue };
            for (i, a) in rest.iter().enumerate() {
                for b in &rest[i..] {
                    let [was, is] = [&drawn, &now]
                        .map(|pins| product(between(pins, first, a), between(pins, first, b)));
                    for (was, is) in was.iter().zip(is) {
                        let off = (was - is).abs();
                        assert!(off < 1e-14, "{name}: {a}, {b} off by {off:e}");
                    }
                }
            }
        }
    }
}
