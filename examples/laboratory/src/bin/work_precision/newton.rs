//! Newton's iteration on the loop equations, dyad by dyad, with nalgebra's 2×2 matrices, from
//! where the last pose left off; velocity and acceleration from the same Jacobian.

use nalgebra::{Matrix2, RealField, Vector2};

use crate::mechanisms::{CHAIN_DYADS, Dyad, ROCKER, STEPHENSON_DYADS};
use crate::number::Number;
use crate::plane::{Link, Moving, Vector, crank};

/// Numbers that nalgebra can solve with.
pub(crate) trait Field: Number + RealField {}
impl Field for f32 {}
impl Field for f64 {}

/// Every dyad's two unknowns, as the last pose left them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Newton<F, const DYADS: usize> {
    unknowns: [Vector2<F>; DYADS],
}

/// More than any start that converges needs.
const MOST_STEPS: usize = 20;

fn unit<F: Field>(angle: F) -> Vector<F> {
    let (sin, cos) = Number::sin_cos(angle);
    Vector { x: cos, y: sin }
}

fn column<F: Field>(v: Vector<F>) -> Vector2<F> {
    Vector2::new(v.x, v.y)
}

/// Takes steps until one is so small that the next would change nothing; the inverse Jacobian at
/// the solution.
fn settle<F: Field>(
    unknowns: &mut Vector2<F>,
    equations: impl Fn(&Vector2<F>) -> (Vector2<F>, Matrix2<F>),
) -> Option<Matrix2<F>> {
    for _ in 0..MOST_STEPS {
        let (residual, jacobian) = equations(unknowns);
        let step = jacobian.try_inverse()? * residual;
        *unknowns -= step;
        if step.amax() < F::SETTLED {
            return equations(unknowns).1.try_inverse();
        }
    }
    None
}

/// B + l₂ u(φ₂) = D + l₃ u(φ₃).
fn dyad<F: Field>(
    angles: &mut Vector2<F>,
    pin: Moving<F>,
    Dyad { pivot, lengths }: Dyad,
) -> Option<[Link<F>; 2]> {
    let (l2, l3) = (F::of(lengths.0), F::of(lengths.1));
    let d = Vector::of(pivot.0, pivot.1);
    let inverse = settle(angles, |angles| {
        let (r2, r3) = (unit(angles.x) * l2, unit(angles.y) * l3);
        let (n2, n3) = (r2.normal(), r3.normal());
        let residual = pin.position + r2 - d - r3;
        (column(residual), Matrix2::new(n2.x, -n3.x, n2.y, -n3.y))
    })?;
    let u = [unit(angles.x), unit(angles.y)];
    let omega = inverse * column(-pin.velocity);
    let g = u[0] * (l2 * omega.x * omega.x) - u[1] * (l3 * omega.y * omega.y) - pin.acceleration;
    let alpha = inverse * column(g);
    Some([0, 1].map(|k| Link { u: u[k], omega: omega[k], alpha: alpha[k] }))
}

impl<F: Field, const DYADS: usize> Newton<F, DYADS> {
    /// From the unknowns at a first pose, to a digit or two.
    pub(crate) fn starting_at(unknowns: [(f64, f64); DYADS]) -> Self {
        Self { unknowns: unknowns.map(|(a, b)| Vector2::new(F::of(a), F::of(b))) }
    }
}

/// The unknowns at the crank angle 0.
pub(crate) const FOUR_BAR_START: [(f64, f64); 1] = [(0.77, 1.69)];
pub(crate) const SIX_BAR_START: [(f64, f64); 1] = [(1.19, 1.08)];
pub(crate) const STEPHENSON_START: [(f64, f64); 2] = [(0.96, 1.53), (0.58, 1.98)];
pub(crate) const CHAIN_START: [(f64, f64); 4] =
    [(0.96, 1.53), (0.26, 1.70), (0.28, 1.82), (0.29, 1.90)];

impl<F: Field> Newton<F, 1> {
    pub(crate) fn four_bar(&mut self, [angle, omega, alpha]: [F; 3]) -> Option<[F; 14]> {
        let b = crank(Number::sin_cos(angle), omega, alpha, 0.1016);
        let [bc, dc] = dyad(&mut self.unknowns[0], b, ROCKER)?;
        let p = bc.carry(b, 0.15, 0.05);
        let [x, y, z] = [p.position, p.velocity, p.acceleration];
        #[rustfmt::skip]
        let out = [
            x.x, x.y, bc.u.x, bc.u.y, dc.u.x, dc.u.y,
            y.x, y.y, bc.omega, dc.omega, z.x, z.y, bc.alpha, dc.alpha,
        ];
        Some(out)
    }

    /// B = D + s u(φ), unknowns φ and s; the yoke's equations are solved as they stand.
    pub(crate) fn six_bar(&mut self, [angle, omega, alpha]: [F; 3]) -> Option<[F; 13]> {
        let b = crank(Number::sin_cos(angle), omega, alpha, 0.4);
        let d = Vector::of(0.0, -1.0);
        let unknowns = &mut self.unknowns[0];
        let inverse = settle(unknowns, |x| {
            let u = unit(x.x);
            let across = u.normal() * x.y;
            (column(d + u * x.y - b.position), Matrix2::new(across.x, u.x, across.y, u.y))
        })?;
        let (u, slide) = (unit(unknowns.x), unknowns.y);
        let rates = inverse * column(b.velocity);
        let (w, v) = (rates.x, rates.y);
        let rest = b.acceleration + u * (slide * w * w) - u.normal() * (F::of(2.0) * w * v);
        let seconds = inverse * column(rest);
        let e = Link { u, omega: w, alpha: seconds.x }.end_about((0.0, -1.0), 1.6);
        let [x, y, z] = [e.position, e.velocity, e.acceleration];
        #[rustfmt::skip]
        let out = [
            u.x, u.y, slide, x.x, x.y - F::of(0.8),
            w, v, y.x, y.y, seconds.x, seconds.y, z.x, z.y,
        ];
        Some(out)
    }
}

impl<F: Field> Newton<F, 2> {
    pub(crate) fn stephenson(&mut self, [angle, omega, alpha]: [F; 3]) -> Option<[F; 16]> {
        let [first, second] = &mut self.unknowns;
        let b = crank(Number::sin_cos(angle), omega, alpha, 0.04);
        let [bc, _] = dyad(first, b, STEPHENSON_DYADS[0])?;
        let p = bc.carry(b, 0.07, 0.05);
        let [_, fe] = dyad(second, p, STEPHENSON_DYADS[1])?;
        let e = fe.end_about(STEPHENSON_DYADS[1].pivot, 0.1);
        let [x, y, z] = [p.position, p.velocity, p.acceleration];
        let [a, b, c] = [e.position, e.velocity, e.acceleration];
        #[rustfmt::skip]
        let out = [
            x.x, x.y, a.x, a.y, fe.u.x, fe.u.y,
            y.x, y.y, b.x, b.y, fe.omega, z.x, z.y, c.x, c.y, fe.alpha,
        ];
        Some(out)
    }
}

impl<F: Field> Newton<F, 4> {
    pub(crate) fn chain(&mut self, [angle, omega, alpha]: [F; 3]) -> Option<[F; 10]> {
        let [one, two, three, four] = &mut self.unknowns;
        let [d1, d2, d3, d4] = CHAIN_DYADS;
        let b = crank(Number::sin_cos(angle), omega, alpha, 0.04);
        let [_, rocker] = dyad(one, b, d1)?;
        let [_, rocker] = dyad(two, rocker.carry_about(d1.pivot, 0.06, 0.02), d2)?;
        let [_, rocker] = dyad(three, rocker.carry_about(d2.pivot, 0.06, 0.02), d3)?;
        let [_, last] = dyad(four, rocker.carry_about(d3.pivot, 0.06, 0.02), d4)?;
        let e = last.end_about(d4.pivot, d4.lengths.1);
        let (u, [x, y, z]) = (last.u, [e.position, e.velocity, e.acceleration]);
        Some([x.x, x.y, u.x, u.y, y.x, y.y, last.omega, z.x, z.y, last.alpha])
    }
}
