//! Machines with known assemblies, and such that are not like others of their kind.

use std::f64::consts::{PI, TAU};

use super::*;

fn at(place: Complex) -> [f64; 2] {
    [place.x, place.y]
}

/// A corner of a triangle about zero.
fn corner(index: usize, radius: f64) -> Complex {
    Complex::turned(TAU * index as f64 / 3.0 - PI / 2.0).times(radius)
}

/// The triad with a platform turned by an angle about its first pin, which is on three circles about the ground's pins moved
/// back: where the lines through their intersections meet.
fn posed(ground: [Complex; 3], platform: [Complex; 3], legs: [f64; 3], angle: f64) -> Machine {
    let turned = platform.map(|pin| Complex::turned(angle) * (pin - platform[0]));
    let centers = [0, 1, 2].map(|leg| ground[leg] - turned[leg]);
    let row = |leg: usize| {
        let way = centers[leg] - centers[0];
        let square = |leg: usize| centers[leg].dot(centers[leg]) - legs[leg] * legs[leg];
        (way, (square(leg) - square(0)) / 2.0)
    };
    let ((a, c), (b, d)) = (row(1), row(2));
    let first = Complex::new(c * b.y - d * a.y, a.x * d - b.x * c).times(1.0 / a.cross(b));
    let pins = turned.map(|pin| at(first + pin));
    let ground = ground.map(at);
    triad([ground[0], ground[1], ground[2], pins[0], pins[1], pins[2]])
}

/// The three-prism with legs of 1.75, 1.97 and 2.70 under a triangle of sides 2.2, 2.9 and 2.15, whose base has sides of 2. Six
/// turns of the platform are published for each of its sides; two of them are 5.5e-4 rad apart. Every cut lists all six, with the
/// differences of the driven leg's direction that follow from the published turns.
#[test]
fn a_three_prism_has_six_assemblies_on_each_side() {
    let six = [
        [
            -1.767436588183,
            -0.044400397269,
            0.054530917647,
            0.055081713169,
            0.881370233718,
            2.082888542149,
        ],
        [
            -2.159752845749,
            -2.158650981042,
            0.071923216431,
            0.323133845898,
            1.008582878621,
            1.652729464609,
        ],
    ];
    let legs = [1.75, 1.97, 2.70];
    let ground = [[0.0, 0.0], [2.0, 0.0], [1.0, 3.0_f64.sqrt()]].map(|[x, y]| Complex::new(x, y));
    let x = (2.2 * 2.2 + 2.9 * 2.9 - 2.15 * 2.15) / 4.4;
    let y = (2.9_f64 * 2.9 - x * x).sqrt();
    for (turns, side) in six.into_iter().zip([1.0, -1.0]) {
        let platform = [[0.0, 0.0], [2.2, 0.0], [x, side * y]].map(|[x, y]| Complex::new(x, y));
        let machines = turns.map(|turn| posed(ground, platform, legs, turn));
        for search in cuts(&machines[0]) {
            let Found::Crank { body, pivot, .. } = search.steps[0] else {
                panic!("a leg is driven")
            };
            let direction = |machine: &Machine| {
                let [from, to] = machine.bodies[body].pins[..] else { panic!("it is a leg") };
                assert_eq!(from, pivot);
                (machine.pins[to] - machine.pins[from]).angle()
            };
            let wrapped = |angle: f64| angle - TAU * (angle / TAU).round();
            let list = of_triad(&machines[0], &search);
            assert_eq!((list.outcome, list.list.len()), (Outcome::Proved, 6), "{search:?}");
            let drawn = direction(&machines[0]);
            let mut wanted = machines.each_ref().map(|other| wrapped(direction(other) - drawn));
            wanted.sort_by(f64::total_cmp);
            for (found, wanted) in list.list.iter().zip(wanted) {
                // Twelve digits are published; between the pair a direction changes as little as the square root of that.
                assert!((found.unknown - wanted).abs() < 1e-7, "{} for {wanted}", found.unknown);
            }
        }
    }
}

/// A robot of three equal legs in its symmetric pose: of the six complex assemblies two are real, which two cuts tell.
#[test]
fn a_symmetric_robot_has_two_assemblies() {
    // 1² + 0.5² − 2 · 0.5 cos = 0.8².
    let turn = Complex::turned(0.61_f64.acos());
    let [a, b, c] = [0, 1, 2].map(|leg| at(corner(leg, 1.0)));
    let [d, e, f] = [0, 1, 2].map(|leg| at(turn * corner(leg, 0.5)));
    for (count, outcome) in counts(&triad([a, b, c, d, e, f])) {
        assert_eq!((count, outcome), (2, Outcome::Proved));
    }
}

/// Equal and parallel legs move: every angle is an assembly, and nothing is proved within the budget. Another length of one leg
/// makes a truss of it.
#[test]
fn a_group_that_moves_is_open() {
    let shift = Complex::turned(0.3).times(0.8);
    for longer in [0.0, 1e-5] {
        let [a, b, c] = [0, 1, 2].map(|leg| at(corner(leg, 1.0)));
        let [d, e, f] = [0, 1, 2].map(|leg| {
            let corner = corner(leg, 1.0);
            at(corner + shift.times(if leg == 2 { 1.0 + longer } else { 1.0 }))
        });
        for search in cuts(&triad([a, b, c, d, e, f])) {
            let (list, pieces) = counted_triad(&triad([a, b, c, d, e, f]), &search);
            println!("{longer}: {:?} {} {pieces}", list.outcome, list.list.len());
            if longer == 0.0 {
                assert!(matches!(list.outcome, Outcome::Open { .. }), "{:?}", list.outcome);
            }
        }
    }
}

/// The lines of three bars meet in one point where the plate's first pin is at (1, 1): two assemblies come together. Beside it the
/// other is as far as the first pin is from there, times a constant, and next to it nothing is said.
#[test]
fn assemblies_that_come_together_are_told_or_left_open() {
    let ratio = |off: f64| {
        let machine =
            triad([[0.0, 0.0], [4.0, 0.0], [2.0, 5.0], [1.0 + off, 1.0], [3.0, 1.0], [2.0, 3.5]]);
        let lists = cuts(&machine).into_iter().map(|search| of_triad(&machine, &search));
        let proved: Vec<_> = lists.filter(Assemblies::is_proved).collect();
        let all = proved.iter().map(|list| list.nearest_other().expect("there are two") / off);
        (proved.iter().map(|list| list.list.len()).collect::<Vec<_>>(), all.collect::<Vec<_>>())
    };
    let (counts, far) = ratio(1e-3);
    assert!(counts.len() == 6 && counts.iter().all(|count| *count == counts[0]), "{counts:?}");
    for (off, cuts) in
        [(-1e-3, 6), (1e-4, 2), (-1e-4, 2), (1e-5, 0), (1e-7, 0), (-1e-8, 0), (1e-12, 0)]
    {
        let (same, near) = ratio(off);
        assert!(
            same.len() >= cuts && same.iter().all(|count| *count == counts[0]),
            "{off}: {same:?}"
        );
        for near in near {
            // A part as large as the distance itself is of the second order.
            assert!((near / far[0] - 1.0).abs() < 0.01, "{off}: {near} and {far:?}");
        }
    }
    assert!(ratio(0.0).0.is_empty());
}

/// The list is the same, but for its order, whatever the unit, the side and the order of pins are.
#[test]
fn lists_do_not_depend_on_how_a_machine_is_drawn() {
    let mut numbers = Numbers(3);
    for _ in 0..40 {
        let places = [(); 6].map(|()| [numbers.next(), numbers.next()]);
        let counted = counts(&triad(places));
        let mirrored = counts(&triad(places.map(|[x, y]| [-x, y])));
        let large = counts(&triad(places.map(|[x, y]| [1e3 * x, 1e3 * y])));
        let small = counts(&triad(places.map(|[x, y]| [1e-3 * x + 0.01, 1e-3 * y])));
        let [a, b, c, d, e, f] = places;
        let shuffled = counts(&triad([c, a, b, f, d, e]));
        let count = counted[0];
        for (others, how) in [
            (counted, "cut"),
            (mirrored, "mirrored"),
            (large, "large"),
            (small, "small"),
            (shuffled, "shuffled"),
        ] {
            assert!(others.iter().all(|other| *other == count), "{how}: {others:?} at {places:?}");
        }
    }
}

/// Each assembly is drawn, by intersections of circles: its bar has its length, and its list is that of the first drawing, seen from
/// there.
#[test]
fn every_assembly_that_is_drawn_has_the_same_list() {
    let mut numbers = Numbers(17);
    let mut drawn = 0;
    for _ in 0..60 {
        let places = [(); 6].map(|()| [numbers.next(), numbers.next()]);
        let machine = triad(places);
        let search = cuts(&machine).swap_remove(0);
        let list = of_triad(&machine, &search);
        let own = list.drawn.expect("the drawing is an assembly");
        for (index, assembly) in list.list.iter().enumerate() {
            let pins = drawn_at(&machine, &search, *assembly);
            let length = |pins: &[Complex]| {
                let [a, b] = machine.bodies[search.left_out].pins[..] else {
                    panic!("it is a bar")
                };
                (pins[a] - pins[b]).length()
            };
            let off = length(&pins) - length(&machine.pins);
            // Roundings of a few operations on numbers up to two, times what a dyad near its limit grows them by.
            assert!(off.abs() < 1e-12, "{off:e} at {assembly:?} of {places:?}");
            let there = of_triad(&Machine { pins, ..machine.clone() }, &search);
            assert_eq!((there.list.len(), there.outcome), (list.list.len(), Outcome::Proved));
            assert_eq!(there.drawn.map(|at| there.list[at].sides), Some(assembly.sides), "{index}");
            drawn += usize::from(index != own);
        }
        assert!(list.list[own].unknown.abs() < 1e-12);
    }
    assert!(drawn > 60, "{drawn}");
}

/// The pins of a triad in an assembly: the driven bar is turned, and the dyad's inner pin is on its side of the line between the outer ones.
fn drawn_at(machine: &Machine, search: &SearchedGroup, assembly: ListedAssembly) -> Vec<Complex> {
    let mut pins = machine.pins.clone();
    let [Found::Crank { body, pivot, .. }, Found::Dyad(dyad)] = &search.steps[..] else {
        panic!("{search:?}")
    };
    for &pin in &machine.bodies[*body].pins {
        let way = machine.pins[pin] - machine.pins[*pivot];
        pins[pin] = machine.pins[*pivot] + Complex::turned(assembly.unknown) * way;
    }
    let legs = dyad.legs.each_ref();
    let [Pair::Pin(first), Pair::Pin(second)] = legs.map(|leg| leg.outer) else {
        panic!("{dyad:?}")
    };
    let Pair::Pin(inner) = dyad.inner else { panic!("{dyad:?}") };
    let [a, b] = [first, second].map(|pin| (machine.pins[inner] - machine.pins[pin]).length());
    let base = pins[second] - pins[first];
    let far = base.length();
    // The cosine theorem.
    let along = (far * far + a * a - b * b) / (2.0 * far);
    let side = if assembly.sides == 1 { 1.0 } else { -1.0 };
    let across = side * ((a - along) * (a + along)).sqrt();
    pins[inner] = pins[first] + base.unit() * Complex::new(along, across);
    // The plate's other pin.
    let plate = legs.iter().find(|leg| machine.bodies[leg.bodies[0]].pins.len() == 3);
    let plate = &machine.bodies[plate.expect("a leg is the plate").bodies[0]];
    let outer = if plate.pins.contains(&first) { first } else { second };
    let way = |pins: &[Complex]| pins[inner] - pins[outer];
    let turn = way(&pins) * way(&machine.pins).conjugate();
    let turn = turn.times(1.0 / way(&machine.pins).dot(way(&machine.pins)));
    for &pin in &plate.pins {
        if pin != inner && pin != outer {
            pins[pin] = pins[outer] + turn * (machine.pins[pin] - machine.pins[outer]);
        }
    }
    pins
}
