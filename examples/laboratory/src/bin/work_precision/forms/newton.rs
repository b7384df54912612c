//! Newton's iteration on the loop equations, dyad by dyad, with nalgebra's 2×2 matrices, from
//! where the last pose left off; velocity and acceleration from the same Jacobian.

use laboratory::hand::guides::Turning;
use laboratory::hand::{Dyad, Moving, Vector};
use laboratory::number::Number;
use linkage_core::Real;
use nalgebra::{Matrix2, RealField, Vector2};

use super::{Block, Form, crank, unit, vector};

/// Numbers that nalgebra can solve with.
pub(crate) trait Field: Number + Real + RealField {}
impl Field for f32 {}
impl Field for f64 {}

/// Every group's two unknowns, as the last pose left them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Newton<F, const GROUPS: usize> {
    unknowns: [Vector2<F>; GROUPS],
}

/// More than any start that converges needs.
const MOST_STEPS: usize = 20;

fn column<F: Field>(v: Vector<F>) -> Vector2<F> {
    Vector2::new(v.x, v.y)
}

/// Takes steps until one is so small that the next would change nothing, as its error is the step's square; the
/// inverse Jacobian at the solution.
fn settle<F: Field>(
    unknowns: &mut Vector2<F>,
    equations: impl Fn(&Vector2<F>) -> (Vector2<F>, Matrix2<F>),
) -> Option<Matrix2<F>> {
    for _ in 0..MOST_STEPS {
        let (residual, jacobian) = equations(unknowns);
        let step = jacobian.try_inverse()? * residual;
        *unknowns -= step;
        if step.amax() < F::num(F::EPSILON.sqrt()) {
            return equations(unknowns).1.try_inverse();
        }
    }
    None
}

impl<F: Field, const GROUPS: usize> Newton<F, GROUPS> {
    /// From the unknowns at a first pose, to a digit or two.
    pub(crate) fn starting_at(unknowns: [[f64; 2]; GROUPS]) -> Self {
        Self { unknowns: unknowns.map(|[a, b]| Vector2::new(F::num(a), F::num(b))) }
    }
}

/// B + l₂ u(φ₂) = D + l₃ u(φ₃).
impl<F: Field, const GROUPS: usize> Form<F> for Newton<F, GROUPS> {
    type Link = Turning<F>;

    fn crank(&self, input: [F; 3], length: f64) -> Moving<F> {
        crank(input, length)
    }

    fn dyad(&mut self, nth: usize, pin: Moving<F>, dyad: Dyad) -> Option<[Turning<F>; 2]> {
        let ([l2, l3], d) = (dyad.lengths.map(F::num), vector(dyad.pivot));
        let angles = &mut self.unknowns[nth];
        let inverse = settle(angles, |angles| {
            let (r2, r3) = (unit(angles.x) * l2, unit(angles.y) * l3);
            let (n2, n3) = (r2.normal(), r3.normal());
            let residual = pin.position + r2 - d - r3;
            (column(residual), Matrix2::new(n2.x, -n3.x, n2.y, -n3.y))
        })?;
        let u = [unit(angles.x), unit(angles.y)];
        let omega = inverse * column(-pin.velocity);
        let g =
            u[0] * (l2 * omega.x * omega.x) - u[1] * (l3 * omega.y * omega.y) - pin.acceleration;
        let alpha = inverse * column(g);
        Some([0, 1].map(|k| Turning { u: u[k], omega: omega[k], alpha: alpha[k] }))
    }
}

/// B = D + s u(φ), unknowns φ and s.
impl<F: Field, const GROUPS: usize> Block<F> for Newton<F, GROUPS> {
    fn block(&mut self, pin: Moving<F>, pivot: [f64; 2]) -> Option<(Turning<F>, [F; 3])> {
        let (d, unknowns) = (vector(pivot), &mut self.unknowns[0]);
        let inverse = settle(unknowns, |x| {
            let u = unit(x.x);
            let across = u.normal() * x.y;
            (column(d + u * x.y - pin.position), Matrix2::new(across.x, u.x, across.y, u.y))
        })?;
        let (u, slide) = (unit(unknowns.x), unknowns.y);
        let rates = inverse * column(pin.velocity);
        let (w, v) = (rates.x, rates.y);
        let rest = pin.acceleration + u * (slide * w * w) - u.normal() * (F::num(2.0) * w * v);
        let seconds = inverse * column(rest);
        Some((Turning { u, omega: w, alpha: seconds.x }, [slide, v, seconds.y]))
    }
}
