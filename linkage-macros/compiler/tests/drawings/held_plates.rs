//! Links that a drive holds together, one of them a plate whose frame is not along the two pins of the pair.

use super::machine::{Machine, machine};

/// Sums of a few products of lengths of five, and a square root beside them.
const CLOSED: f64 = 1e-12;

/// The place of a pin of what is known.
fn place(pins: &[(String, [f64; 2])], pin: &str) -> [f64; 2] {
    pins.iter().find(|(name, _)| name == pin).expect("a pin").1
}

fn angle(pins: &[(String, [f64; 2])], [from, to]: [&str; 2]) -> f64 {
    let [from, to] = [from, to].map(|pin| place(pins, pin));
    (to[1] - from[1]).atan2(to[0] - from[0])
}

/// A four-bar whose coupler, or rocker, or both are plates of three pins whose first two are not those of the pair: at the
/// drawn angle it is where it is drawn, and beside it the angle between the first two pins of both links is the input.
#[test]
fn a_plate_in_a_held_pair_is_where_it_is_drawn() {
    let plates = [
        ("BC(B, C), DC(D, Z, C)", ["B", "C"], ["D", "Z"]),
        ("BC(Z, B, C), DC(D, C)", ["Z", "B"], ["D", "C"]),
        ("BC(Z, B, C), DC(C, Y, D)", ["Z", "B"], ["C", "Y"]),
    ];
    for (links, coupler, rocker) in plates {
        for [first, second] in [["BC", "DC"], ["DC", "BC"]] {
            let pins = [("Z", "Z(4.3, 1.4)"), ("Y", "Y(4.9, 1.1)")];
            let named = pins.iter().filter(|(pin, _)| links.contains(pin)).map(|(_, place)| *place);
            let named = named.collect::<Vec<_>>().join(", ");
            let source = format!(
                "pub struct M {{ input q: angle; ground A(0, 0), D(4, 0); pin B(0.5, 0.9), C(3.2, 2.6), {named}; \
                 link AB(A, B), {links}; drive {first}.angle - {second}.angle = q; }}"
            );
            let held: Machine =
                machine(&source).unwrap_or_else(|told| panic!("{source}: {told:?}"));
            let drawn = held.drawn::<f64>(false);
            let sides = if first == "BC" { [coupler, rocker] } else { [rocker, coupler] };
            let ground = held.drawn::<f64>(true);
            let all = [drawn.clone(), ground].concat();
            let at = angle(&all, sides[0]) - angle(&all, sides[1]);
            for change in [-0.03, 0.0, 0.02] {
                let now = held.rigid(&[at + change], CLOSED);
                let now = now.unwrap_or_else(|| panic!("{source} at {change}"));
                let off = (angle(&now, sides[0]) - angle(&now, sides[1]) - at - change).sin();
                assert!(off.abs() < CLOSED, "{source} at {change}: {off:e}");
                let moved = drawn.iter().map(|(pin, [x, y])| {
                    let [now_x, now_y] = place(&now, pin);
                    (now_x - x).hypot(now_y - y)
                });
                let moved = moved.fold(0.0, f64::max);
                assert!(moved < if change == 0.0 { CLOSED } else { 0.2 }, "{source}: {moved:e}");
            }
        }
    }
}
