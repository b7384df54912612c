//! Machines of class III whose crank turns fully: how many of them are followed over all of the turn.
//!
//! A machine turns fully if Newton's method on the places of all pins at once follows it there in small steps. That
//! knows no groups, no options and no intervals.

use std::f64::consts::{PI, TAU};

use super::chains_of_eight::{Driven, all, drawing};
use super::eight_bars::{class, kinematic};
use super::following::all_of_the_stretch_is_solved;
use super::freely_placed::solved;
use super::machine::machine;
use super::variants::Random;
use crate::chain::cut;
use crate::chain::cutting::Found;
use crate::chain::machine::{GROUND, Machine};
use crate::chain::plane::Complex;

/// The equations of a machine of pins whose first drive turns a link of the ground, over the places of the pins that
/// neither of the two holds.
struct AllPins<'m> {
    machine: &'m Machine,
    /// The unknown of each pin: its x; y is the next.
    unknowns: Vec<Option<usize>>,
    count: usize,
    driven: usize,
}

impl<'m> AllPins<'m> {
    fn of(machine: &'m Machine) -> Self {
        let [a, b] = machine.drives[0].bodies;
        let driven = if a == GROUND { b } else { a };
        let is_known = |pin: usize| {
            [GROUND, driven].iter().any(|&body| machine.bodies[body].pins.contains(&pin))
        };
        let mut count = 0;
        let unknown = |pin| {
            (!is_known(pin)).then(|| {
                count += 2;
                count - 2
            })
        };
        let unknowns = (0..machine.pins.len()).map(unknown).collect();
        Self { machine, unknowns, count, driven }
    }

    fn drawn(&self) -> Vec<f64> {
        let moving = (0..self.machine.pins.len()).filter(|&pin| self.unknowns[pin].is_some());
        moving.flat_map(|pin| [self.machine.pins[pin].x, self.machine.pins[pin].y]).collect()
    }

    fn at(&self, pin: usize, places: &[f64], turned: f64) -> Complex {
        let drawn = self.machine.pins[pin];
        match self.unknowns[pin] {
            Some(x) => Complex::new(places[x], places[x + 1]),
            None if self.machine.bodies[GROUND].pins.contains(&pin) => drawn,
            None => {
                let is_pivot = |pin: &&usize| self.machine.bodies[GROUND].pins.contains(pin);
                let pivot = self.machine.bodies[self.driven]
                    .pins
                    .iter()
                    .find(is_pivot)
                    .expect("it is at the ground");
                let pivot = self.machine.pins[*pivot];
                pivot + Complex::turned(turned) * (drawn - pivot)
            }
        }
    }

    /// The equations, rows of their slopes over the unknowns with the values last: the first two pins of a link keep
    /// their distance, and the others their places from these.
    fn rows(&self, places: &[f64], turned: f64) -> Vec<Vec<f64>> {
        let mut rows = Vec::new();
        let mut row = |value: f64, slopes: &[(usize, Complex)]| {
            let mut row = vec![0.0; self.count + 1];
            for &(pin, slope) in slopes {
                if let Some(x) = self.unknowns[pin] {
                    row[x] += slope.x;
                    row[x + 1] += slope.y;
                }
            }
            row[self.count] = value;
            rows.push(row);
        };
        for (body, of) in self.machine.bodies.iter().enumerate() {
            if [GROUND, self.driven].contains(&body) {
                continue;
            }
            let [p, q, rest @ ..] = &of.pins[..] else { continue };
            let [from, to] = [*p, *q].map(|pin| self.at(pin, places, turned));
            let drawn = self.machine.pins[*q] - self.machine.pins[*p];
            let now = to - from;
            row((now.dot(now) - drawn.dot(drawn)) / 2.0, &[(*p, -now), (*q, now)]);
            for &pin in rest {
                // In the frame of the first two: (z − p) − w (q − p), w = a + i b.
                let arm = self.machine.pins[pin] - self.machine.pins[*p];
                let w = (arm * drawn.conjugate()).times(1.0 / drawn.dot(drawn));
                let missed = self.at(pin, places, turned) - from - w * now;
                let [x, y] = [Complex::new(w.x, -w.y), Complex::new(w.y, w.x)];
                let [e, f] = [Complex::new(1.0, 0.0), Complex::new(0.0, 1.0)];
                row(missed.x, &[(pin, e), (*p, x - e), (*q, -x)]);
                row(missed.y, &[(pin, f), (*p, y - f), (*q, -y)]);
            }
        }
        rows
    }

    /// The pose beside one, with the sign of its determinant: `None` where Newton's method does not find it within a
    /// part of the machine's size.
    fn beside(&self, from: &[f64], turned: f64) -> Option<(bool, Vec<f64>)> {
        let mut places = from.to_vec();
        for _ in 0..12 {
            let (is_positive, step) = solved(self.rows(&places, turned))?;
            places.iter_mut().zip(&step).for_each(|(place, step)| *place -= step);
            let size = step.iter().fold(0.0_f64, |most, step| most.max(step.abs()));
            let moved =
                places.iter().zip(from).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            if moved.is_nan() || moved > 0.03 * self.machine.size() {
                return None;
            }
            if size < 1e-12 * self.machine.size() {
                return Some((is_positive, places));
            }
        }
        None
    }

    /// The places after half a turn from the drawing, a way: steps that miss are halved.
    fn after_half_a_turn(&self, way: f64) -> Option<Vec<f64>> {
        const STEP: f64 = TAU / 1440.0;
        let (sign, mut places) = self.beside(&self.drawn(), 0.0)?;
        let (mut turned, mut step) = (0.0, STEP);
        while turned < PI {
            let to = (turned + step).min(PI);
            match self.beside(&places, way * to) {
                Some((same, found)) if same == sign => {
                    (turned, places) = (to, found);
                    step = (2.0 * step).min(STEP);
                }
                _ if step > 1e-4 * STEP => step /= 2.0,
                _ => return None,
            }
        }
        Some(places)
    }

    fn turn_fully(&self) -> bool {
        let ends = [-1.0, 1.0].map(|way| self.after_half_a_turn(way));
        let [Some(back), Some(ahead)] = ends else { return false };
        back.iter().zip(&ahead).all(|(a, b)| (a - b).abs() < 1e-8 * self.machine.size())
    }
}

/// The crank of a machine shorter than its other links, that more of them turn fully; none where it has more than two
/// joints.
pub(super) fn places_with_short_crank(
    driven: &Driven,
    random: &mut Random,
) -> Option<Vec<[f64; 2]>> {
    let mut places = drawing(random);
    places.truncate(driven.joints.len());
    let [a, b] = driven.joints[driven.drive];
    let crank = if a == driven.ground { b } else { a };
    let tip: Vec<_> = (0..driven.joints.len())
        .filter(|&joint| joint != driven.drive && driven.joints[joint].contains(&crank))
        .collect();
    let [tip] = tip[..] else { return None };
    let (length, angle) = (50 + random.below(150), random.below(628));
    let arm = Complex::turned(angle as f64 / 100.0).times(length as f64 / 1000.0);
    places[tip] = [places[driven.drive][0] + arm.x, places[driven.drive][1] + arm.y];
    Some(places)
}

fn with_short_crank(driven: &Driven, random: &mut Random) -> Option<Machine> {
    Some(kinematic(driven, &places_with_short_crank(driven, random)?))
}

/// Six-bars of Stephenson's second kind.
fn six_bars(count: usize) -> Vec<(String, Machine)> {
    let joints = vec![[0, 1], [0, 5], [1, 2], [2, 3], [2, 4], [3, 5], [4, 5]];
    let driven = Driven { joints, ground: 0, drive: 0 };
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let named = |nth| Some((format!("six-bar {nth}"), with_short_crank(&driven, &mut random)?));
    (0..count).filter_map(named).collect()
}

fn eight_bars(count: usize) -> Vec<(String, Machine)> {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let at_ground = all().iter().filter(|driven| driven.is_at_the_ground());
    let named = |(nth, driven)| {
        let machine = with_short_crank(driven, &mut random)?;
        matches!(class(&machine), (3.., true)).then(|| (format!("eight-bar {nth}"), machine))
    };
    at_ground.cycle().enumerate().filter_map(named).take(count).collect()
}

/// Nine eight-bars of class III in random drawings, to three digits: the ground, the driven link, and the joints with
/// their places.
const NINE: [(usize, usize, &str); 9] = [
    (
        1,
        7,
        "01:0.789:0.304 05:0.326:0.572 17:0.603:0.18 25:0.655:0.835 27:0.324:0.929 36:0.81:0.838 37:0.554:0.589 46:0.015:0.486 47:0.999:0.972 56:0.052:0.978",
    ),
    (
        7,
        4,
        "01:0.843:0.998 04:0.892:0.017 15:0.706:0.48 24:0.111:0.157 26:0.406:0.53 36:0.907:0.456 37:0.06:0.401 47:0.205:0.007 56:0.928:0.185 57:0.209:0.442",
    ),
    (
        0,
        5,
        "01:0.98:0.863 05:0.416:0.891 17:0.188:0.711 23:0.051:0.249 26:0.834:0.473 37:0.865:0.161 45:0.946:0.319 47:0.704:0.339 56:0.014:0.511 67:0.421:0.504",
    ),
    (
        0,
        1,
        "01:0.469:0.567 04:0.358:0.3 15:0.737:0.451 24:0.549:0.853 26:0.722:0.258 36:0.209:0.752 37:0.508:0.409 47:0.229:0.066 56:0.397:0.125 57:0.595:0.698",
    ),
    (
        2,
        4,
        "01:0.205:0.868 04:0.486:0.267 15:0.304:0.171 24:0.045:0.196 26:0.854:0.078 36:0.951:0.263 37:0.993:0.813 47:0.724:0.162 56:0.616:0.378 57:0.513:0.996",
    ),
    (
        2,
        4,
        "04:0.031:0.728 05:0.845:0.896 14:0.841:0.003 16:0.626:0.068 24:0.364:0.706 27:0.283:0.115 35:0.527:0.872 36:0.774:0.396 57:0.168:0.916 67:0.888:0.611",
    ),
    (
        5,
        1,
        "05:0.484:0.332 06:0.158:0.181 15:0.469:0.086 17:0.11:0.998 25:0.967:0.044 27:0.32:0.945 36:0.928:0.517 37:0.554:0.976 46:0.612:0.155 47:0.067:0.031",
    ),
    (
        6,
        4,
        "01:0.165:0.408 04:0.84:0.617 15:0.86:0.021 26:0.787:0.419 27:0.584:0.891 36:0.246:0.821 37:0.272:0.152 45:0.92:0.888 46:0.963:0.453 57:0.471:0.727",
    ),
    (
        0,
        4,
        "01:0.007:0.673 04:0.566:0.898 15:0.807:0.102 23:0.033:0.366 26:0.933:0.964 37:0.475:0.286 46:0.807:0.504 47:0.297:0.587 56:0.677:0.685 57:0.637:0.148",
    ),
];

fn nine() -> Vec<(String, Machine)> {
    let named = |(nth, (ground, driven, text)): (usize, &(usize, usize, &str))| {
        let numbers: Vec<Vec<f64>> = text
            .split(' ')
            .map(|joint| joint.split(':').map(|part| part.parse().expect("a number")).collect())
            .collect();
        let joints: Vec<_> =
            numbers.iter().map(|joint| [joint[0] as usize / 10, joint[0] as usize % 10]).collect();
        let is_driven = |joint: &[usize; 2]| joint.contains(ground) && joint.contains(driven);
        let drive = joints.iter().position(is_driven).expect("it is at the ground");
        let places: Vec<_> = numbers.iter().map(|joint| [joint[1], joint[2]]).collect();
        let driven = Driven { joints, ground: *ground, drive };
        (format!("{} of nine", nth + 1), kinematic(&driven, &places))
    };
    NINE.iter().enumerate().map(named).collect()
}

/// The stretch that a machine with one search holds, and whether nothing stands beside that but the crank; an empty one
/// where it is refused.
fn searched(machine: &Machine) -> ([f64; 2], bool) {
    let Ok(steps) = cut(machine) else { return ([0.0; 2], false) };
    let mut searches = steps.iter().filter_map(|step| match step {
        Found::Search(search) => Some(search.stretches[0]),
        _ => None,
    });
    let stretch = searches.next().expect("it is of class III");
    (stretch, steps.len() == 2)
}

/// The count of machines that are followed over a full turn, and of those that turn fully. The others are printed.
fn followed(machines: Vec<(String, Machine)>) -> [usize; 2] {
    let mut counts = [0; 2];
    for (name, machine) in machines {
        let ([from, to], is_alone) = searched(&machine);
        let (turns, is_whole) = (AllPins::of(&machine).turn_fully(), to - from > TAU - 1e-6);
        if turns && !is_whole {
            println!("{name} turns fully: {:?}", [from, to].map(f64::to_degrees));
        }
        // A group behind the search may end where that goes on.
        assert!(turns || !is_whole || !is_alone, "{name} is said to turn fully");
        counts[0] += usize::from(turns && is_whole);
        counts[1] += usize::from(turns);
    }
    println!("{} of {} are followed over the whole turn", counts[0], counts[1]);
    counts
}

/// The first machines of those that `.ci/nightly` takes.
#[test]
fn machines_that_turn_fully_are_followed_over_the_whole_turn() {
    let [whole, full] = followed([six_bars(30), eight_bars(3)].concat());
    assert!(whole + 1 == full && full > 10, "{whole} of {full}");
}

/// Nine eight-bars, and 200 random machines: 72 of 73 are. Six-bar 3 is followed from -72° to 12°.
#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn of_two_hundred_machines_that_turn_fully_nearly_all_are_followed_over_the_whole_turn() {
    let [whole, full] = followed([nine(), six_bars(150), eight_bars(50)].concat());
    assert!(50 * whole >= 49 * full && full > 60, "{whole} of {full}");
}

/// A six-bar that goes next to two dead points within a turn: the fit has a bend at each, and all of the turn is solved.
#[test]
fn a_turn_next_to_dead_points_is_followed_with_bends() {
    let statements = "input t: angle; ground A(0.626, 0.934), F(0.115, 0.267);
        pin B(0.6808699332611984, 1.1242453427128025), C(0.929, 0.306), D(0.015, 0.58), E(0.42, 0.072),
        G(0.613, 0.782); link AB(A, B), BCD(B, C, D), CE(C, E), DG(D, G), FEG(F, E, G); drive AB.angle = t;";
    let machine = machine(&format!("pub struct M {{ {statements} }}")).expect("it is a machine");
    let docs = machine.docs();
    assert!(docs.contains("-180.0° to 180.0°") && docs.contains("sqrt"), "{docs}");
    assert!(all_of_the_stretch_is_solved("next to dead points", &machine));
}
