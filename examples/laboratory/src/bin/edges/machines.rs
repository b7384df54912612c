//! The machines, each in the forms that are compared.

use laboratory::race::{Race, Run, angles, calls, swept};
use linkage_core::{Record, Series, mechanism};

use crate::map::map;

/// A line of the table for one machine: the time of the first way over that of the second.
pub(crate) struct Pair {
    pub(crate) what: &'static str,
    pub(crate) aim: f64,
    race: Race,
}

impl Pair {
    pub(crate) fn new(what: &'static str, aim: f64, [first, second]: [Run; 2]) -> Self {
        let mut race = Race::default();
        race.enter("without", second);
        race.enter("with", first);
        Self { what, aim, race }
    }

    /// The ratio and the first way's time.
    pub(crate) fn measure(&mut self, rounds: usize) -> [f64; 2] {
        let first = &self.race.run(rounds, |_| {})[1];
        [first.ratio, first.nanoseconds]
    }
}

/// Poses of a round, few enough for the first cache.
const POSES: usize = 240;

/// Steps across a map.
const ACROSS: u32 = 64;

const OK: &str = "all slices are of one length";

/// All over a turn.
fn turn() -> Vec<f64> {
    angles().take(POSES).collect()
}

macro_rules! sweep_of {
    ($solver:ident, $record:ident, $sweep:ident, $angles:expr $(, $rate:literal)*) => {{
        let angles: Vec<f64> = $angles;
        swept(angles.len(), move |out, status| {
            let out: $record<&mut [f64]> = Record::from_array(out);
            $solver::new().$sweep(&angles, $($rate,)* out, status, ()).expect(OK);
        })
    }};
}

macro_rules! machine {
    ($name:ident: crank $crank:tt, D($gx:tt, $($gy:tt)+), lengths $l:tt $m:tt,
     P($u:tt, $($v:tt)+), rise $rise:tt,
     long $long:tt D($lx:tt, $($ly:tt)+) lengths $ll:tt $lm:tt, ram $r:tt $rod:tt,
     hand $a:tt $b:tt $c:tt $d:tt E($ex:tt, $($ey:tt)+), map ($x:expr, $y:expr) $near:tt $far:tt) => {
        pub(crate) mod $name {
            use super::*;

            four_bar! { Plain, [$crank $gx, ($($gy)+), $l $m, $u, ($($v)+)], { output P; } }
            four_bar! { WithDistance, [$crank $gx, ($($gy)+), $l $m, $u, ($($v)+)],
                { output P, reach = distance(A, P); } }
            four_bar! { WithMargin, [$crank $gx, ($($gy)+), $l $m, $u, ($($v)+)],
                { output P, DC.margin; } }
            four_bar! { WithAsin, [$crank $gx, ($($gy)+), $l $m, $u, ($($v)+)],
                { output P, rise = asin(P.y / (1m * $rise)); } }
            four_bar! { WithAtan2, [$crank $gx, ($($gy)+), $l $m, $u, ($($v)+)],
                { output P, seen = atan2(P.y, P.x); } }
            four_bar! { Everything, [$crank $gx, ($($gy)+), $l $m, $u, ($($v)+)], { output P, BC, DC; } }
            four_bar! { Long, [$long $lx, ($($ly)+), $ll $lm, $u, ($($v)+)], { output C, BC, DC; } }

            mechanism! {
                struct Hand {
                    input x, y: length;
                    ground A(0, 0), E($ex, $($ey)+);
                    point P at (x, y);
                    rrr AB(A), BP(P) -> B { lengths: ($a, $b), mode: left }
                    rrr EC(E), CP(P) -> C { lengths: ($c, $d), mode: right }
                    output AB, EC;
                }
            }

            mechanism! {
                struct Ram {
                    input x: length;
                    ground A(0, 0);
                    guide bed through (0, 0) along 0deg;
                    unknown theta: angle between (0, 180deg);
                    crank AB(A) -> B           { length: $r, angle: theta }
                    rrp   BC(B), ram(bed) -> C { length: $rod, mode: ahead }
                    solve theta { ram.slide = x, mode: falling }
                    output theta, AB;
                }
            }

            /// Angles at which the long crank's bars meet, or do not.
            fn of_long(is_met: bool) -> Vec<f64> {
                let of_long = |angle: &f64| Long::new().position(*angle).is_ok() == is_met;
                angles().filter(of_long).take(POSES).collect()
            }

            fn points(half: f64) -> Vec<[f64; 2]> {
                map([$x, $y], half, ACROSS).collect()
            }

            fn over_map(half: f64) -> Run {
                let points = points(half);
                let [x, y]: [Vec<f64>; 2] =
                    [0, 1].map(|axis| points.iter().map(|point| point[axis]).collect());
                swept(points.len(), move |out, status| {
                    let out: HandPosition<&mut [f64]> = Record::from_array(out);
                    Hand::new().sweep_position([Series::from(&x), Series::from(&y)], out, status, ()).expect(OK);
                })
            }

            /// The stroke and back, or the same beyond it.
            fn stroke(is_met: bool) -> Vec<f64> {
                let middle = if is_met { $rod } else { $rod + 2.0 * $r };
                (0..POSES)
                    .map(|k| middle + 0.95 * $r * (k as f64 * std::f64::consts::TAU / POSES as f64).sin())
                    .collect()
            }

            fn along_stroke(is_met: bool) -> Run {
                let slides = stroke(is_met);
                swept(POSES, move |out, status| {
                    let out: RamPosition<&mut [f64]> = Record::from_array(out);
                    Ram::new().sweep_position(&slides, out, status, ()).expect(OK);
                })
            }

            pub(crate) fn pairs() -> Vec<Pair> {
                let pair = Pair::new;
                let narrow = || angles().take(POSES).collect::<Vec<f32>>();
                vec![
                    pair("1 out of reach, sweep", 3.0, [false, true].map(|met| {
                        sweep_of!(Long, LongPosition, sweep_position, of_long(met))
                    })),
                    pair("1 out of reach, position", 3.0, [false, true].map(|met| {
                        calls(of_long(met), |angle| Long::new().position(angle))
                    })),
                    pair("1 out of reach, motion", 3.0, [false, true].map(|met| {
                        calls(of_long(met), |angle| Long::new().motion(angle, 2.0, 1.0))
                    })),
                    pair("2 map, 43 % reached", 3.0, [$far, $near].map(over_map)),
                    pair("2 the same, calls", 3.5, [$far, $near].map(|half| {
                        calls(points(half), |at| Hand::new().position(at))
                    })),
                    pair("3 distance, sweep", 1.3, [
                        sweep_of!(WithDistance, WithDistancePosition, sweep_position, turn()),
                        sweep_of!(Plain, PlainPosition, sweep_position, turn()),
                    ]),
                    pair("3 margin, sweep", 1.3, [
                        sweep_of!(WithMargin, WithMarginPosition, sweep_position, turn()),
                        sweep_of!(Plain, PlainPosition, sweep_position, turn()),
                    ]),
                    pair("3 margin, sweep of motion", 1.3, [
                        sweep_of!(WithMargin, WithMarginMotion, sweep_motion, turn(), 2.0, 1.0),
                        sweep_of!(Plain, PlainMotion, sweep_motion, turn(), 2.0, 1.0),
                    ]),
                    pair("3 asin, sweep", 2.0, [
                        sweep_of!(WithAsin, WithAsinPosition, sweep_position, turn()),
                        sweep_of!(Plain, PlainPosition, sweep_position, turn()),
                    ]),
                    pair("3 atan2, sweep", 2.0, [
                        sweep_of!(WithAtan2, WithAtan2Position, sweep_position, turn()),
                        sweep_of!(Plain, PlainPosition, sweep_position, turn()),
                    ]),
                    pair("4 distance, a call", 1.2, [
                        calls(turn(), |angle| WithDistance::new().position(angle)),
                        calls(turn(), |angle| Plain::new().position(angle)),
                    ]),
                    pair("5 jacobian, f64", 1.2, [
                        calls(turn(), |angle| Everything::new().jacobian(angle)),
                        calls(turn(), |angle| Everything::new().coefficients(angle)),
                    ]),
                    pair("5 jacobian, f32", 1.2, [
                        calls(narrow(), |angle| Everything::<f32>::default().jacobian(angle)),
                        calls(narrow(), |angle| Everything::<f32>::default().coefficients(angle)),
                    ]),
                    // Over a sweep of positions: nanoseconds are what counts.
                    pair("6 search in a sweep", f64::NAN, [
                        along_stroke(true),
                        sweep_of!(Plain, PlainPosition, sweep_position, turn()),
                    ]),
                    pair("6 no root, a call", 1.0, [false, true].map(|met| {
                        calls(stroke(met), |x| Ram::new().position(x))
                    })),
                    pair("6 no root, sweep", 3.0, [false, true].map(along_stroke)),
                ]
            }
        }
    };
}

macro_rules! four_bar {
    ($solver:ident, [$crank:tt $gx:tt, ($($gy:tt)+), $l:tt $m:tt, $u:tt, ($($v:tt)+)],
     { $($output:tt)* }) => {
        mechanism! {
            struct $solver {
                input theta: angle;
                ground A(0, 0), D($gx, $($gy)+);
                crank AB(A) -> B        { length: $crank, angle: theta }
                rrr   BC(B), DC(D) -> C { lengths: ($l, $m), mode: left }
                point P on BC at ($u, $($v)+);
                $($output)*
            }
        }
    };
}

// Behind the macros that it uses.
pub(crate) mod rubbing;

macro_rules! machines {
    ($($name:ident)*) => {
        /// Every machine's lines.
        pub(crate) fn all() -> Vec<Vec<Pair>> {
            vec![$($name::pairs()),*]
        }
    };
}

// The four-bar S1 of this package, the crank of 2 m that leaves the bars of 2 m and 2.5 m at a third of its
// turn, a press, and a five-bar robot.
machine! { named: crank 0.1016, D(0.3048, 0.0), lengths 0.254 0.1778, P(0.15, 0.05), rise 1,
long 2 D(4, 0) lengths 2 2.5, ram 0.08 0.25,
hand 0.3 0.4 0.3 0.4 E(0.2, 0.0), map (0.1, 0.4) 0.08 0.65 }

include!(concat!(env!("OUT_DIR"), "/edges.rs"));
