//! A drawing with rounded places and the lengths that were meant: the pose in which the machine has them is the assembly
//! next to the drawing.

use super::*;
use crate::chain::redrawn::{Resized, redrawn};

/// The pins of a triad's plate in an assembly with the driven bar turned: of both poses of the plate on two bars, the one
/// that closes with the third.
fn plate(machine: &Machine, [driven, other, last]: [usize; 3], turned: f64) -> [Complex; 3] {
    let [ground, drawn] = [[0, 1, 2], [3, 4, 5]].map(|pins| pins.map(|pin| machine.pins[pin]));
    let pin = ground[driven] + Complex::turned(turned) * (drawn[driven] - ground[driven]);
    let side = drawn[other] - drawn[driven];
    let (near, far) = (side.length(), (drawn[other] - ground[other]).length());
    let base = ground[other] - pin;
    let along = (base.dot(base) + near * near - far * far) / (2.0 * base.length());
    let across = (near * near - along * along).max(0.0).sqrt();
    let poses = [across, -across].map(|across| {
        let to = base.unit() * Complex::new(along, across);
        let turn = (to * side.conjugate()).times(1.0 / side.dot(side));
        drawn.map(|place| pin + turn * (place - drawn[driven]))
    });
    let bar = (drawn[last] - ground[last]).length();
    let off = |pose: &[Complex; 3]| ((pose[last] - ground[last]).length() - bar).abs();
    let [one, two] = poses;
    if off(&one) < off(&two) { one } else { two }
}

/// Drawings whose places are rounded to a thousandth. Of all assemblies that have the bars' lengths, the walk from the drawing
/// comes to that with the least distance of the plate's pins from where they are drawn. It refuses where two assemblies come
/// together on the way.
#[test]
fn the_pose_with_the_lengths_is_the_nearest_assembly() {
    let mut numbers = Numbers(23);
    let (mut nearest, mut refused) = (0, 0);
    while nearest + refused < 400 {
        let meant = [(); 6].map(|()| [numbers.next(), numbers.next()]);
        let drawing = triad(meant.map(|place| place.map(|x| (x * 1e3).round() / 1e3)));
        let bar = |body: usize| {
            let pins = [body - 2, body + 1];
            let [from, to] = pins.map(|pin| meant[pin]);
            Resized { body, pins, length: (to[0] - from[0]).hypot(to[1] - from[1]) }
        };
        let Some(pose) = redrawn(&drawing, &[2, 3, 4].map(bar)) else {
            refused += 1;
            continue;
        };
        let search = &cuts(&pose.machine)[0];
        let list = of_triad(&pose.machine, search);
        let Some(own) = list.drawn.filter(|_| list.is_proved()) else {
            refused += 1;
            continue;
        };
        let Found::Crank { body, .. } = search.steps[0] else { panic!("a bar is driven") };
        let (driven, last) = (body - 2, search.left_out - 2);
        let order = [driven, 3 - driven - last, last];
        let off = |at: &ListedAssembly| {
            let pins = plate(&pose.machine, order, at.unknown).into_iter().zip(&drawing.pins[3..]);
            pins.map(|(pin, drawn)| (pin - *drawn).length()).fold(0.0, f64::max)
        };
        let least = list.list.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let least = least.expect("the drawing is one");
        assert_eq!(*least, list.list[own], "{meant:?}");
        nearest += 1;
    }
    println!("{nearest} nearest, {refused} refused");
    assert!(refused <= 20, "{refused}");
}
