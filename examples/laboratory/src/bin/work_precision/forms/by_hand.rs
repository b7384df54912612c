//! The closed form as one tunes it when it matters, that of `laboratory::hand`.

use laboratory::hand::{Bar, CrankDyad, Dyad, Joint, Moving, Vector, crank_dyad, dyad};
use laboratory::number::Number;

use super::{Form, Link};

#[derive(Clone, Copy)]
pub(crate) struct ByHand;

impl<F: Number> Form<F> for ByHand {
    type Link = Bar<F>;

    #[inline(always)]
    fn crank(&self, [angle, omega, alpha]: [F; 3], length: f64) -> Moving<F> {
        let [x, y] = angle.cos_sin();
        Moving::about([0.0; 2], Vector { x, y } * F::of(length), omega, alpha)
    }

    #[inline(always)]
    fn dyad(&mut self, _: usize, pin: Moving<F>, form: Dyad) -> Option<[Bar<F>; 2]> {
        dyad(pin, Joint::Ground(form.pivot), form.lengths, form.side)
    }

    #[inline(always)]
    fn crank_dyad(
        &mut self,
        [angle, omega, alpha]: [F; 3],
        form: CrankDyad,
    ) -> Option<(Moving<F>, [Bar<F>; 2])> {
        crank_dyad(form, angle.cos_sin(), [omega, alpha])
    }
}

impl<F: Number> Link<F> for Bar<F> {
    type Point = Moving<F>;

    #[inline(always)]
    fn on(self, pin: Moving<F>, at: [f64; 2]) -> Moving<F> {
        self.point(pin, at)
    }

    #[inline(always)]
    fn about(self, pivot: [f64; 2], at: [f64; 2]) -> Moving<F> {
        if at == [self.length, 0.0] { self.end_about(pivot) } else { self.point_about(pivot, at) }
    }

    #[inline(always)]
    fn direction(self) -> ([F; 2], F, F) {
        let Vector { x, y } = Bar::direction(self);
        ([x, y], self.omega, self.alpha)
    }
}
