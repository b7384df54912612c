//! Both ways lead to the same numbers.

use laboratory::generated::FourBar;
use linkage_core::Record;
use linkage_tests::double_double::DoubleDouble;

use crate::kernels::{self, Call, Contest, OtherPoint, TURN, Visit};
use crate::race::{self, RATES};

/// All over the ranges of the inputs: the inputs, and rates and accelerations.
fn poses(ranges: [[f64; 2]; 2]) -> impl Iterator<Item = [[f64; 2]; 3]> {
    let [[v, a], [w, b]] = RATES;
    race::poses(ranges).into_iter().map(move |pose| [pose, [v, w], [a, b]])
}

/// The largest difference of each number, in ε of its largest value.
fn largest<const N: usize>(
    ranges: [[f64; 2]; 2],
    mut made: impl FnMut([[f64; 2]; 3]) -> [f64; N],
    mut by_hand: impl FnMut([[f64; 2]; 3]) -> [f64; N],
) -> f64 {
    let (mut sizes, mut errors) = ([0.0_f64; N], [0.0_f64; N]);
    for input in poses(ranges) {
        let (made, by_hand) = (made(input), by_hand(input));
        for k in 0..N {
            sizes[k] = sizes[k].max(made[k].abs());
            let error = (made[k] - by_hand[k]).abs();
            // NaN counts as an infinite error.
            errors[k] = if error.is_nan() { f64::INFINITY } else { errors[k].max(error) };
        }
    }
    (0..N).map(|k| errors[k] / sizes[k] / f64::EPSILON).fold(0.0, f64::max)
}

fn called<const N: usize>(
    call: Call<N>,
    [[q, r], [v, w], [a, b]]: [[f64; 2]; 3],
) -> Option<[f64; N]> {
    let mut out = [0.0; N];
    let is_solved = match call {
        Call::One(call) => call(q, v, a, &mut out),
        Call::Two(call) => call(q, r, v, w, a, b, &mut out),
    };
    is_solved.then_some(out)
}

fn answer<const N: usize>(call: Call<N>) -> impl FnMut([[f64; 2]; 3]) -> [f64; N] {
    move |input| called(call, input).unwrap_or_else(|| panic!("{input:?}"))
}

/// Each way is within 5 ε of the truth on S1, position to acceleration. The error of a first loop's pin
/// acts on the second's bars with at most 1/sin 25° a division, of which an acceleration has three.
struct Agreement;

impl Visit for Agreement {
    fn contest<const N: usize>(&mut self, name: &str, call: &str, contest: &Contest<N>) {
        // So do slides of guides that cross: the acceleration has the rate and the slide in it.
        let with_three = ["six", "shaper", "press", "rocker", "excavator", "arm", "crossed"];
        let has_three = with_three.iter().any(|start| name.starts_with(start));
        let allowed = 2.0 * 5.0 * if has_three { 2.4 * 2.4 * 2.4 } else { 2.4 };
        let found = largest(contest.ranges, answer(contest.made), answer(contest.by_hand));
        assert!(found <= allowed, "{name}, {call}: {found:.1} ε");
    }
}

#[test]
fn the_hand_forms_are_right() {
    kernels::reported(&mut Agreement);
    crate::drawn::every(&mut Agreement);
}

/// On numbers of two words the generated code is the truth of both ways.
#[test]
fn the_hand_form_is_within_five_last_places_of_the_truth() {
    type Wide = DoubleDouble;
    let exact = |[[t, _], [w, _], [a, _]]: [[f64; 2]; 3]| {
        let (motion, _) =
            FourBar::<Wide>::default().solve_motion(Wide::new(t), Wide::new(w), Wide::new(a));
        motion.into_array().map(|number| number.high)
    };
    let found = largest([TURN; 2], exact, answer(kernels::s1_motion::CONTEST.by_hand));
    assert!(found <= 5.5, "{found:.1} ε");
    let exact = |[[t, _], [w, _], [a, _]]: [[f64; 2]; 3]| {
        let (motion, _) =
            OtherPoint::<Wide>::default().solve_motion(Wide::new(t), Wide::new(w), Wide::new(a));
        let (x, v, a) = (motion.position, motion.velocity, motion.acceleration);
        [
            [x.C.x, x.C.y, x.P.x, x.P.y, v.BC.omega, v.DC.omega],
            [v.P.x, v.P.y, a.BC.alpha, a.DC.alpha, a.P.x, a.P.y],
        ]
        .map(|numbers| numbers.map(|number| number.high))
        .concat()
        .try_into()
        .expect("twelve numbers")
    };
    let found = largest::<12>([TURN; 2], exact, answer(kernels::other_motion::CONTEST.by_hand));
    assert!(found <= 5.5, "{found:.1} ε");
}

#[test]
fn out_of_reach_is_an_answer() {
    // The hand forms and the generated solvers both refuse what is no angle.
    let input = [[f64::NAN; 2], [1.0; 2], [1.0; 2]];
    assert_eq!(called(kernels::s1_motion::CONTEST.by_hand, input), None);
    assert_eq!(called(kernels::s1_motion::CONTEST.made, input), None);
}

/// The mechanisms are drawn while the package is built. Those that were measured end with these, each drawn behind all
/// others of its table: another generator, or another library's sine, would draw others.
#[test]
fn the_mechanisms_are_those_that_were_measured() {
    macro_rules! table {
        ($name:literal) => {
            include_str!(concat!(env!("OUT_DIR"), "/", $name, ".rs"))
        };
    }
    let tables = [table!("bars"), table!("machines"), table!("twins"), table!("edges")];
    let last = [
        "drawn! { six_bar_10: crank 0.083, D(0.443, 0.054), lengths 0.257 0.322 left, P(0.276, 0.046), Q(0.16, 0.08), \
         F(0.374, 0.048), second P F lengths 0.398 0.133 left, output [C E] [DC XE] }",
        "excavator([0.283, -0.104], (0.32, -1.0), [[0.268, 0.184], [0.61, -0.09]], (0.375, 1.0), [0.09, -0.035]) \
         -> Excavator }",
        "(e2 = -0.015082836151123046875) (across = 0.072998441755771636962890625)]",
        "hand 0.305 0.58 0.339 0.375 E(0.21, -0.043), map (-0.033, 0.357) 0.08 0.575 }",
    ];
    for (table, last) in tables.into_iter().zip(last) {
        assert!(table.contains(last), "{last}");
    }
}
