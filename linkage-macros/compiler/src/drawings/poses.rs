//! The poses of machines beside their drawings.

use super::cases;
use super::machine::{Places, machine};
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

#[test]
fn every_pin_is_where_it_is_drawn_and_every_body_stays_rigid() {
    let (mut dyads, mut searched) = (0, 0);
    for case in cases() {
        let Ok(machine) = machine(&case.declaration()) else { continue };
        if !machine.mechanism.unknowns.is_empty() {
            // In a hundred digits a search takes a second.
            searched += 1;
            if searched % 4 != 1 {
                continue;
            }
        }
        let inputs = machine.mechanism.drawn.clone().expect("drives determine the inputs");
        let now = machine.pins(&inputs);
        for (name, at) in machine.drawn(false) {
            let found = place(&now, &name);
            for i in 0..2 {
                let off = found[i].sub(&at[i]).to_f64().abs();
                // The inputs are floats of the drawing's angles.
                assert!(off < 1e-12, "{}: {name} is off by {off:e}", case.name);
            }
        }
        let drawn = [machine.drawn(true), machine.drawn(false)].concat();
        let beside: &[i32] = match machine.mechanism.unknowns.is_empty() {
            true => &[-5, -4, -3, -2, -1, 1, 2, 3, 4, 5],
            false => &[1],
        };
        for &step in beside {
            let inputs: Vec<_> =
                inputs.iter().map(|input| input + 1e-6 * f64::from(step)).collect();
            let now = machine.pins(&inputs);
            for (_, link) in machine.links() {
                let [first, rest @ ..] = &link[..] else { continue };
                for (i, a) in rest.iter().enumerate() {
                    for b in &rest[i..] {
                        let [was, is] = [&drawn, &now]
                            .map(|pins| product(between(pins, first, a), between(pins, first, b)));
                        for (was, is) in was.iter().zip(is) {
                            let off = (was - is).abs();
                            assert!(off < 1e-14, "{}: {a}, {b} off by {off:e}", case.name);
                        }
                    }
                }
            }
        }
        dyads += usize::from(machine.mechanism.unknowns.is_empty());
    }
    assert_eq!([dyads, searched], [25, 22]);
}
