//! The same calls twice, generated and by hand, as functions that the disassembly shows one by one:
//! angle and rates in registers, an array of numbers out.

use laboratory::generated::{FourBar, SixBar};
use laboratory::hand::{Bar, CrankDyad, Dyad, Moving, cos_sin, crank_dyad, swinging_block};
use linkage_core::{Record, mechanism};

/// Inputs, rates and accelerations in registers, numbers out: an array of what has just been written would be
/// read in words of two numbers, which wait for both to be stored.
#[derive(Clone, Copy)]
pub(crate) enum Call<const N: usize> {
    One(fn(f64, f64, f64, &mut [f64; N]) -> bool),
    /// Both inputs, both rates, both accelerations.
    Two(fn(f64, f64, f64, f64, f64, f64, &mut [f64; N]) -> bool),
}

/// A mechanism: the ways to what is asked of it.
pub(crate) struct Contest<const N: usize> {
    pub(crate) made: Call<N>,
    pub(crate) by_hand: Call<N>,
    /// The lower and upper bound of each input.
    pub(crate) ranges: [[f64; 2]; 2],
}

/// The range of an angle that turns fully.
pub(crate) const TURN: [f64; 2] = [0.0, std::f64::consts::TAU];

/// An operation on every mechanism.
pub(crate) trait Visit {
    fn contest<const N: usize>(&mut self, name: &str, call: &str, contest: &Contest<N>);
}

/// S1 as the report asks and as another does, and S5.
pub(crate) fn reported(visit: &mut impl Visit) {
    visit.contest("s1", "motion", &s1_motion::CONTEST);
    visit.contest("s1", "position", &s1_position::CONTEST);
    visit.contest("other_point", "motion", &other_motion::CONTEST);
    visit.contest("other_point", "position", &other_position::CONTEST);
    visit.contest("s5", "motion", &s5_motion::CONTEST);
}

/// Hands the numbers of a motion over, if there is one.
#[inline(always)]
pub(crate) fn put<M, const N: usize>(
    motion: Option<M>,
    out: &mut [f64; N],
    numbers: impl Fn(M) -> [f64; N],
) -> bool {
    let Some(motion) = motion else { return false };
    *out = numbers(motion);
    true
}

/// S1: the four-bar, its pin's and its bars' motion.
pub(crate) struct FourBarMotion {
    pub(crate) b: Moving,
    pub(crate) bars: [Bar; 2],
}

const S1: CrankDyad = CrankDyad {
    crank: 0.1016,
    dyad: Dyad { pivot: [0.3048, 0.0], lengths: [0.254, 0.1778], side: 1.0 },
};

#[inline(always)]
pub(crate) fn four_bar(form: CrankDyad, [angle, omega, alpha]: [f64; 3]) -> Option<FourBarMotion> {
    let (b, bars) = crank_dyad(form, cos_sin(angle), [omega, alpha])?;
    Some(FourBarMotion { b, bars })
}

mechanism! {
    /// S1 with another coupler point, of which pins and bars are asked.
    pub(crate) struct OtherPoint {
        input theta: angle;

        ground A(0, 0), D(304.8mm, 0);

        crank AB(A) -> B        { length: 101.6mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }

        point P on BC at (127mm, 76.2mm);
        output C, P, BC, DC;
    }
}

/// Two functions under the name of the mechanism and the call: what moves, and its numbers.
macro_rules! ways {
    ($module:ident: $n:literal, $made:expr, $of_made:expr, $by_hand:expr, $of_hand:expr) => {
        pub(crate) mod $module {
            use super::*;

            #[inline(never)]
            pub(crate) fn made(t: f64, w: f64, a: f64, out: &mut [f64; $n]) -> bool {
                put($made([t, w, a]), out, $of_made)
            }

            #[inline(never)]
            pub(crate) fn by_hand(t: f64, w: f64, a: f64, out: &mut [f64; $n]) -> bool {
                put($by_hand([t, w, a]), out, $of_hand)
            }

            pub(crate) const CONTEST: Contest<$n> =
                Contest { made: Call::One(made), by_hand: Call::One(by_hand), ranges: [TURN; 2] };
        }
    };
}

ways!(s1_motion: 14,
|[t, w, a]: [f64; 3]| FourBar::new().motion(t, w, a).ok(),
Record::into_array,
|input| four_bar(S1, input),
|FourBarMotion { b, bars: [bc, dc] }| {
    let (p, u2, u3) = (bc.point(b, [0.15, 0.05]), bc.direction(), dc.direction());
    let (x, v, a) = (p.position, p.velocity, p.acceleration);
    [
        x.x, x.y, u2.x, u2.y, u3.x, u3.y, v.x, v.y, bc.omega, dc.omega,
        a.x, a.y, bc.alpha, dc.alpha,
    ]
});

ways!(s1_position: 6,
|[t, _, _]: [f64; 3]| FourBar::new().position(t).ok(),
Record::into_array,
|[t, _, _]: [f64; 3]| four_bar(S1, [t, 0.0, 0.0]),
|FourBarMotion { b, bars: [bc, dc] }| {
    let (p, u2, u3) = (bc.point(b, [0.15, 0.05]).position, bc.direction(), dc.direction());
    [p.x, p.y, u2.x, u2.y, u3.x, u3.y]
});

ways!(other_motion: 12,
|[t, w, a]: [f64; 3]| OtherPoint::new().motion(t, w, a).ok(),
|m: OtherPointMotion<f64>| {
    let (x, v, a) = (m.position, m.velocity, m.acceleration);
    [
        x.C.x, x.C.y, x.P.x, x.P.y, v.BC.omega, v.DC.omega, v.P.x, v.P.y, a.BC.alpha,
        a.DC.alpha, a.P.x, a.P.y,
    ]
},
|input| four_bar(S1, input),
|FourBarMotion { b, bars: [bc, dc] }| {
    let (c, p) = (b.position + bc.r, bc.point(b, [0.127, 0.0762]));
    let (x, v, a) = (p.position, p.velocity, p.acceleration);
    [c.x, c.y, x.x, x.y, bc.omega, dc.omega, v.x, v.y, bc.alpha, dc.alpha, a.x, a.y]
});

ways!(other_position: 4,
|[t, _, _]: [f64; 3]| OtherPoint::new().position(t).ok(),
|x: OtherPointPosition<f64>| [x.C.x, x.C.y, x.P.x, x.P.y],
|[t, _, _]: [f64; 3]| four_bar(S1, [t, 0.0, 0.0]),
|FourBarMotion { b, bars: [bc, _] }| {
    let (c, p) = (b.position + bc.r, bc.point(b, [0.127, 0.0762]).position);
    [c.x, c.y, p.x, p.y]
});

ways!(s5_motion: 13,
    |[t, w, a]: [f64; 3]| SixBar::new().motion(t, w, a).ok(),
    Record::into_array,
    swinging_block,
    |numbers| numbers);
