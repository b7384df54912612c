//! The mechanisms as a hand composes them from a dyad's solution, whatever its form.

use laboratory::generated as g;
use laboratory::hand::{CrankDyad, Dyad};
use laboratory::number::Number;
use linkage_core::Record;
use linkage_tests::double_double::DoubleDouble;

use crate::forms::straightforward::Straightforward;
use crate::forms::{Block, Form, Link, Point};

/// A mechanism: how it moves, and which numbers it gives.
pub(crate) struct Mechanism<const N: usize> {
    pub(crate) name: &'static str,
    pub(crate) rate: f64,
    pub(crate) second: f64,
    /// The names of the positions, the velocities and the accelerations.
    pub(crate) labels: [&'static [&'static str]; 3],
    /// The straightforward form on numbers of two words, with all decimal digits of the dimensions.
    pub(crate) truth: fn([DoubleDouble; 3]) -> Option<[DoubleDouble; N]>,
}

macro_rules! labels {
    ($($record:ident)+) => {
        [$(g::$record::<f64>::LABELS),+]
    };
}

pub(crate) const FOUR_BAR: Mechanism<14> = Mechanism {
    name: "S1",
    rate: 250.0,
    second: 1000.0,
    labels: labels!(FourBarPosition FourBarVelocity FourBarAcceleration),
    truth: |input| four_bar(&mut Straightforward, input),
};

pub(crate) const SIX_BAR: Mechanism<13> = Mechanism {
    name: "S5",
    rate: 10.0,
    second: 4.0,
    labels: labels!(SixBarPosition SixBarVelocity SixBarAcceleration),
    truth: |input| six_bar(&mut Straightforward, input),
};

pub(crate) const STEPHENSON: Mechanism<16> = Mechanism {
    name: "Stephenson III",
    rate: 30.0,
    second: 100.0,
    labels: labels!(StephensonPosition StephensonVelocity StephensonAcceleration),
    truth: |input| stephenson(&mut Straightforward, input),
};

pub(crate) const CHAIN: Mechanism<10> = Mechanism {
    name: "ten links",
    rate: 30.0,
    second: 100.0,
    labels: labels!(ChainPosition ChainVelocity ChainAcceleration),
    truth: |input| chain(&mut Straightforward, input),
};

/// Two bars to a pivot, their pin left of the line to it.
const fn dyad(pivot: [f64; 2], lengths: [f64; 2]) -> Dyad {
    Dyad { pivot, lengths, side: 1.0 }
}

const S1: CrankDyad = CrankDyad { crank: 0.1016, dyad: dyad([0.3048, 0.0], [0.254, 0.1778]) };
const FIRST: CrankDyad = CrankDyad { crank: 0.04, dyad: dyad([0.1, 0.0], [0.11, 0.09]) };
const SECOND: Dyad = dyad([0.18, 0.06], [0.12, 0.1]);

#[inline(always)]
pub(crate) fn four_bar<F: Number, S: Form<F>>(form: &mut S, input: [F; 3]) -> Option<[F; 14]> {
    let (b, [bc, dc]) = form.crank_dyad(input, S1)?;
    let [x, v, a] = bc.on(b, [0.15, 0.05]).orders();
    let ((u2, w2, a2), (u3, w3, a3)) = (bc.direction(), dc.direction());
    #[rustfmt::skip]
    let out = [
        x[0], x[1], u2[0], u2[1], u3[0], u3[1], v[0], v[1], w2, w3, a[0], a[1], a2, a3,
    ];
    Some(out)
}

#[inline(always)]
pub(crate) fn six_bar<F: Number, S: Block<F>>(form: &mut S, input: [F; 3]) -> Option<[F; 13]> {
    const PIVOT: [f64; 2] = [0.0, -1.0];
    let pin = form.crank(input, 0.4);
    let (rod, [slide, rate, second]) = form.block(pin, PIVOT)?;
    let ([x, v, a], (u, w, turning)) = (rod.about(PIVOT, [1.6, 0.0]).orders(), rod.direction());
    #[rustfmt::skip]
    let out = [
        u[0], u[1], slide, x[0], x[1] - F::of(0.8),
        w, rate, v[0], v[1], turning, second, a[0], a[1],
    ];
    Some(out)
}

#[inline(always)]
pub(crate) fn stephenson<F: Number, S: Form<F>>(form: &mut S, input: [F; 3]) -> Option<[F; 16]> {
    let (b, [bc, _]) = form.crank_dyad(input, FIRST)?;
    let p = bc.on(b, [0.07, 0.05]);
    let [_, fe] = form.dyad(1, p, SECOND)?;
    let e = fe.about(SECOND.pivot, [SECOND.lengths[1], 0.0]).orders();
    let (p, (u, omega, alpha)) = (p.orders(), fe.direction());
    #[rustfmt::skip]
    let out = [
        p[0][0], p[0][1], e[0][0], e[0][1], u[0], u[1],
        p[1][0], p[1][1], e[1][0], e[1][1], omega, p[2][0], p[2][1], e[2][0], e[2][1], alpha,
    ];
    Some(out)
}

/// Four dyads of the same bars, each begun at a point of the last one's rocker.
#[inline(always)]
pub(crate) fn chain<F: Number, S: Form<F>>(form: &mut S, input: [F; 3]) -> Option<[F; 10]> {
    const PIVOTS: [[f64; 2]; 3] = [[0.2, 0.0], [0.3, 0.0], [0.4, 0.0]];
    let Dyad { pivot, lengths, .. } = FIRST.dyad;
    let at = [0.06, 0.02];
    let (_, [_, first]) = form.crank_dyad(input, FIRST)?;
    let [_, second] = form.dyad(1, first.about(pivot, at), dyad(PIVOTS[0], lengths))?;
    let [_, third] = form.dyad(2, second.about(PIVOTS[0], at), dyad(PIVOTS[1], lengths))?;
    let [_, last] = form.dyad(3, third.about(PIVOTS[1], at), dyad(PIVOTS[2], lengths))?;
    let [x, v, a] = last.about(PIVOTS[2], [lengths[1], 0.0]).orders();
    let (u, omega, alpha) = last.direction();
    Some([x[0], x[1], u[0], u[1], v[0], v[1], omega, a[0], a[1], alpha])
}
