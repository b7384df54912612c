//! The mechanisms as a hand composes them from a dyad's solution, whatever its form, and what the
//! outputs are, in the order of the tables of `truth`.
//!
//! Only what is common to all forms stands here; how a dyad is solved is each form's own.

use crate::number::Number;
use crate::plane::{Link, Moving, Vector, crank};
use crate::truth::{self, Words};

/// Two bars from a moving pin and from a pivot to their common pin, left of the line between them.
#[derive(Clone, Copy)]
pub(crate) struct Dyad {
    pub(crate) pivot: (f64, f64),
    pub(crate) lengths: (f64, f64),
}

/// A form of the formulas: an angle's sine and cosine, and the solution of a dyad.
pub(crate) trait Form {
    fn sin_cos<F: Number>(angle: F) -> (F, F);
    fn dyad<F: Number>(pin: Moving<F>, dyad: Dyad) -> Option<[Link<F>; 2]>;
}

/// A mechanism: how it moves in the tables, and how many numbers it gives.
pub(crate) struct Mechanism<const N: usize> {
    pub(crate) name: &'static str,
    pub(crate) rate: f64,
    pub(crate) second: f64,
    /// The number of positions and of velocities; the rest are accelerations.
    pub(crate) orders: (usize, usize),
    /// The sizes of the vectors that an error is a fraction of: a point's two coordinates and a
    /// direction's two components belong together.
    pub(crate) vectors: &'static [usize],
    pub(crate) truth: &'static [[Words; N]],
}

pub(crate) const FOUR_BAR: Mechanism<14> = Mechanism {
    name: "S1",
    rate: 250.0,
    second: 1000.0,
    orders: (6, 4),
    vectors: &[2, 2, 2, 2, 1, 1, 2, 1, 1],
    truth: &truth::FOUR_BAR,
};

pub(crate) const SIX_BAR: Mechanism<13> = Mechanism {
    name: "S5",
    rate: 10.0,
    second: 4.0,
    orders: (5, 4),
    vectors: &[2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1],
    truth: &truth::SIX_BAR,
};

pub(crate) const STEPHENSON: Mechanism<16> = Mechanism {
    name: "Stephenson III",
    rate: 30.0,
    second: 100.0,
    orders: (6, 5),
    vectors: &[2, 2, 2, 2, 2, 1, 2, 2, 1],
    truth: &truth::STEPHENSON,
};

pub(crate) const CHAIN: Mechanism<10> = Mechanism {
    name: "ten links",
    rate: 30.0,
    second: 100.0,
    orders: (4, 3),
    vectors: &[2, 2, 2, 1, 2, 1],
    truth: &truth::CHAIN,
};

pub(crate) const ROCKER: Dyad = Dyad { pivot: (0.3048, 0.0), lengths: (0.254, 0.1778) };
pub(crate) const STEPHENSON_DYADS: [Dyad; 2] = [
    Dyad { pivot: (0.1, 0.0), lengths: (0.11, 0.09) },
    Dyad { pivot: (0.18, 0.06), lengths: (0.12, 0.1) },
];
pub(crate) const CHAIN_DYADS: [Dyad; 4] = [
    Dyad { pivot: (0.1, 0.0), lengths: (0.11, 0.09) },
    Dyad { pivot: (0.2, 0.0), lengths: (0.11, 0.09) },
    Dyad { pivot: (0.3, 0.0), lengths: (0.11, 0.09) },
    Dyad { pivot: (0.4, 0.0), lengths: (0.11, 0.09) },
];

#[inline(always)]
pub(crate) fn four_bar<S: Form, F: Number>([angle, omega, alpha]: [F; 3]) -> Option<[F; 14]> {
    let b = crank(S::sin_cos(angle), omega, alpha, 0.1016);
    let [bc, dc] = S::dyad(b, ROCKER)?;
    let p = bc.carry(b, 0.15, 0.05);
    let [x, y, z] = [p.position, p.velocity, p.acceleration];
    #[rustfmt::skip]
    let out = [
        x.x, x.y, bc.u.x, bc.u.y, dc.u.x, dc.u.y,
        y.x, y.y, bc.omega, dc.omega, z.x, z.y, bc.alpha, dc.alpha,
    ];
    Some(out)
}

#[inline(always)]
pub(crate) fn stephenson<S: Form, F: Number>([angle, omega, alpha]: [F; 3]) -> Option<[F; 16]> {
    let b = crank(S::sin_cos(angle), omega, alpha, 0.04);
    let [bc, _] = S::dyad(b, STEPHENSON_DYADS[0])?;
    let p = bc.carry(b, 0.07, 0.05);
    let [_, fe] = S::dyad(p, STEPHENSON_DYADS[1])?;
    let e = fe.end_about(STEPHENSON_DYADS[1].pivot, STEPHENSON_DYADS[1].lengths.1);
    let ([x, y, z], [a, b, c]) = (orders(p), orders(e));
    #[rustfmt::skip]
    let out = [
        x.x, x.y, a.x, a.y, fe.u.x, fe.u.y,
        y.x, y.y, b.x, b.y, fe.omega, z.x, z.y, c.x, c.y, fe.alpha,
    ];
    Some(out)
}

#[inline(always)]
pub(crate) fn chain<S: Form, F: Number>([angle, omega, alpha]: [F; 3]) -> Option<[F; 10]> {
    let b = crank(S::sin_cos(angle), omega, alpha, 0.04);
    let [_, first] = S::dyad(b, CHAIN_DYADS[0])?;
    let b = first.carry_about(CHAIN_DYADS[0].pivot, 0.06, 0.02);
    let [_, second] = S::dyad(b, CHAIN_DYADS[1])?;
    let b = second.carry_about(CHAIN_DYADS[1].pivot, 0.06, 0.02);
    let [_, third] = S::dyad(b, CHAIN_DYADS[2])?;
    let b = third.carry_about(CHAIN_DYADS[2].pivot, 0.06, 0.02);
    let [_, last] = S::dyad(b, CHAIN_DYADS[3])?;
    let [x, y, z] = orders(last.end_about(CHAIN_DYADS[3].pivot, CHAIN_DYADS[3].lengths.1));
    Some([x.x, x.y, last.u.x, last.u.y, y.x, y.y, last.omega, z.x, z.y, last.alpha])
}

fn orders<F: Number>(point: Moving<F>) -> [Vector<F>; 3] {
    [point.position, point.velocity, point.acceleration]
}
