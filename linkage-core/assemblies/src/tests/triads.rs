//! Triads: a plate on three bars.

use std::f64::consts::TAU;
use std::vec::Vec;

use super::{Complex, Numbers};
use crate::{
    Assembly, BodyPin, Budget, ClosureDegree, HungBar, List, Outcome, PinnedDyad, PinnedGroup,
    Placed, STANDING, TURNED,
};

const DEGREE: ClosureDegree = ClosureDegree { powers: [1, 0, 0, 0], half: 3 };
const BUDGET: Budget = Budget { samples: 20_000, pieces: 4000 };

/// The first bar is driven, the plate and the second bar are the dyad, the third bar is left out. Places 0 to 2 are the pins of the
/// ground, 3 to 5 those of the plate, each in the coordinates of the drawing.
const GROUP: PinnedGroup = PinnedGroup {
    pivot: [0, 0],
    dyads: [
        Some(PinnedDyad {
            bars: [
                HungBar { body: 2, outer: BodyPin { body: TURNED, place: 3 }, ends: [3, 4] },
                HungBar { body: 3, outer: BodyPin { body: STANDING, place: 1 }, ends: [1, 4] },
            ],
        }),
        None,
        None,
        None,
    ],
    equation: [BodyPin { body: 2, place: 5 }, BodyPin { body: STANDING, place: 2 }],
};

/// The pins of the ground, then those of the plate.
type Triad = [Complex; 6];

fn drawn(numbers: &mut impl FnMut() -> f64) -> Triad {
    loop {
        let pins = [(); 6].map(|()| Complex::new(numbers(), numbers()));
        let pairs = [(0, 3), (1, 4), (2, 5), (0, 1), (0, 2), (1, 2), (3, 4), (3, 5), (4, 5)];
        if pairs.iter().all(|&(a, b)| pins[a] != pins[b]) {
            return pins;
        }
    }
}

/// The triad with its bars in another order: another bar is driven, and another left out.
fn reordered(pins: Triad, order: [usize; 3]) -> Triad {
    let of = |part: usize| order.map(|bar| pins[part + bar]);
    let ([a, b, c], [d, e, f]) = (of(0), of(3));
    [a, b, c, d, e, f]
}

fn placed<R>(pins: Triad, of: impl FnOnce(&Placed<'_>) -> R) -> R {
    let places = pins.map(|pin| [pin.x, pin.y]);
    let way = pins[5] - pins[2];
    of(&Placed::new(&GROUP, &DEGREE, (&places, [way.x, way.y])).expect("bars have lengths"))
}

fn list(pins: Triad, budget: Budget) -> List<6> {
    placed(pins, |placed| placed.assemblies(budget))
}

/// The plate's pins in an assembly, by the cosine theorem.
fn plate(pins: Triad, assembly: &Assembly) -> [Complex; 3] {
    let first = pins[0] + Complex::turned(assembly.unknown) * (pins[3] - pins[0]);
    let [a, b] = [pins[4] - pins[3], pins[4] - pins[1]].map(Complex::length);
    let base = pins[1] - first;
    let far = base.length();
    let along = (far * far + a * a - b * b) / (2.0 * far);
    let across = ((a - along) * (a + along)).max(0.0).sqrt();
    let across = if assembly.sides == 1 { across } else { -across };
    let second = first + base.times(1.0 / far) * Complex::new(along, across);
    let turn = (second - first).over(pins[4] - pins[3]);
    [first, second, first + turn * (pins[5] - pins[3])]
}

/// Every listed pose keeps the length of the bar that was left out, the drawing is one of them, and the list of another pose is the
/// same machine's.
#[test]
fn listed_poses_close_and_hold_the_drawing() {
    let mut numbers = Numbers(5);
    let (mut poses, mut halved, mut widest) = (0, 0, 0.0_f64);
    for _ in 0..300 {
        let pins = drawn(&mut || numbers.next());
        let list = list(pins, BUDGET);
        assert_eq!(list.outcome, Outcome::Proved, "{pins:?}");
        assert!(list.len().is_multiple_of(2));
        let length = (pins[5] - pins[2]).length();
        for assembly in &list {
            let off = (plate(pins, assembly)[2] - pins[2]).length() - length;
            // Roundings of a few operations on numbers up to two, times what a dyad near its limit grows them by.
            assert!(off.abs() < 1e-12, "{off:e} at {assembly:?} of {pins:?}");
            let [from, to] = assembly.between;
            assert!(from < assembly.unknown && assembly.unknown < to && assembly.room > 0.0);
            widest = widest.max(to - from);
            // Where a search about it ends the dyad assembles, and twice as far it does not or meets another assembly's half.
            let angles = |within: f64| [assembly.unknown - within, assembly.unknown + within];
            let assembles = |angle: &f64| {
                placed(pins, |placed| placed.missed(*angle, assembly.sides)).is_some()
            };
            assert!(angles(assembly.within).iter().all(assembles), "{assembly:?}");
            let is_whole = assembly.within == assembly.room;
            assert!(is_whole || !angles(2.0 * assembly.within).iter().all(assembles));
            halved += usize::from(!is_whole);
            poses += 1;
        }
        let nearest = list.nearest(0.0).expect("the drawing is one");
        assert!(nearest.off < 1e-11, "{nearest:?}");
    }
    assert!(poses > 800 && halved > 100 && widest < 1e-6, "{poses}, {halved}, {widest:e}");
}

#[derive(Debug, Default)]
struct Compared {
    equal: usize,
    not_proved: usize,
    differing: usize,
    most: (u32, u32),
}

/// Counts by two orders of the bars, of coordinates that a function rounds.
fn compared(count: usize, round: impl Fn(f64) -> f64) -> Compared {
    let mut numbers = Numbers(23);
    let mut compared = Compared::default();
    for _ in 0..count {
        let pins = drawn(&mut || round(numbers.next()));
        let lists = [[0, 1, 2], [1, 2, 0]].map(|order| list(reordered(pins, order), BUDGET));
        for list in &lists {
            assert!(!list.is_proved() || list.len().is_multiple_of(2), "{pins:?}");
            compared.most.0 = compared.most.0.max(list.samples);
            compared.most.1 = compared.most.1.max(list.pieces);
        }
        let is_equal = lists[0].len() == lists[1].len();
        match lists.iter().all(List::is_proved) {
            true if is_equal => compared.equal += 1,
            true => compared.differing += 1,
            false => compared.not_proved += 1,
        }
    }
    std::println!("{compared:?}");
    compared
}

/// Lengths of any kind, those of `f32`, and those on a grid, which make assemblies double. No two lists that are proved differ.
#[test]
fn two_orders_of_bars_have_one_count() {
    let any = compared(1500, |number| number);
    assert_eq!((any.not_proved, any.differing), (0, 0));
    assert!(any.most.0 < 3000 && any.most.1 < 500, "{:?}", any.most);
    let narrow = compared(1000, |number| f64::from(number as f32));
    assert_eq!((narrow.not_proved, narrow.differing), (0, 0));
    let grid = compared(1500, |number| (number * 10.0).floor() / 10.0);
    assert!(grid.equal > 1200 && grid.differing == 0, "{grid:?}");
}

/// A budget is never exceeded, and a list that lacks it says so.
#[test]
fn lists_keep_to_their_budget() {
    let mut numbers = Numbers(41);
    for _ in 0..200 {
        let pins = drawn(&mut || numbers.next());
        let whole = list(pins, BUDGET);
        for part in 1..8 {
            let budget =
                Budget { samples: whole.samples * part / 8, pieces: whole.pieces * (9 - part) / 8 };
            let part = list(pins, budget);
            assert!(part.samples <= budget.samples && part.pieces <= budget.pieces);
            assert_eq!(part.outcome, Outcome::OutOfBudget);
            assert!(part.len() <= whole.len());
        }
        let exact = Budget { samples: whole.samples, pieces: whole.pieces };
        assert_eq!(list(pins, exact), whole);
    }
    // Equal and parallel bars move: every angle is an assembly.
    let ground = [0.0, 2.1, 4.4].map(Complex::turned);
    let [d, e, f] = ground.map(|pin| pin + Complex::turned(0.3).times(0.8));
    let [a, b, c] = ground;
    let moving = list([a, b, c, d, e, f], BUDGET);
    assert!(matches!(moving.outcome, Outcome::Open { .. }), "{:?}", moving.outcome);
    assert!(moving.samples < BUDGET.samples);
}

/// Numbers that are none, and bars without length, are no group.
#[test]
fn bars_have_lengths() {
    let places = [[0.0, 0.0], [4.0, 0.0], [2.0, 5.0], [1.0, 1.0], [3.0, 1.0], [2.0, 3.5]];
    let is_one = |places: [[f64; 2]; 6], left_out: [f64; 2]| {
        Placed::new(&GROUP, &DEGREE, (&places, left_out)).is_some()
    };
    assert!(is_one(places, [0.0, 1.5]));
    assert!(!is_one(places, [f64::NAN, 1.5]));
    for place in 0..6 {
        let mut with = places;
        with[place][1] = f64::INFINITY;
        assert!(!is_one(with, [0.0, 1.5]), "{place}");
    }
    let mut with = places;
    with[4] = with[3];
    assert!(!is_one(with, [0.0, 1.5]));
    let few = &places[..5];
    assert!(Placed::new(&GROUP, &DEGREE, (few, [0.0, 1.5])).is_none());
}

/// The nearest assembly and the runner-up, over whole turns, by the unknown and by another angle.
#[test]
fn the_nearest_is_what_is_measured() {
    let mut numbers = Numbers(61);
    let lists: Vec<_> = (0..40).map(|_| drawn(&mut || numbers.next())).collect();
    let mut told = 0;
    for pins in lists {
        let list = list(pins, BUDGET);
        for one in &list {
            let nearest =
                list.nearest(one.unknown + 3.0 * TAU + 0.9 * one.room).expect("it is one");
            assert!((nearest.off - 0.9 * one.room).abs() < 1e-13, "{nearest:?}");
            // It is nearer than half way to any other.
            assert_eq!(nearest.assembly, *one);
            assert!(nearest.runner_up.is_some_and(|other| other >= 1.1 * one.room - 1e-13));
            let turn = |assembly: &Assembly| {
                let [first, second, _] = plate(pins, assembly);
                Some((second - first).angle())
            };
            let by_plate =
                list.nearest_by_angle(turn(one).unwrap() - TAU, turn).expect("it is one");
            assert!(by_plate.off < 1e-12);
            told += usize::from(by_plate.assembly == *one);
            let nothing = list.nearest_by(|other| (other == one).then_some(2.0));
            assert_eq!(nothing.map(|it| (it.off, it.runner_up)), Some((2.0, None)));
        }
        assert_eq!(list.nearest_by(|_| None), None);
        assert_eq!(list.nearest_by(|_| Some(f64::NAN)), None);
    }
    assert!(told > 80, "{told}");
}
