//! The ways to write a mechanism's formulas: what a point and a link are to each, and how it solves a dyad.

pub(crate) mod by_hand;
pub(crate) mod dual;
pub(crate) mod half_angle;
pub(crate) mod newton;
pub(crate) mod straightforward;

use laboratory::hand::guides::Turning;
use laboratory::hand::{CrankDyad, Dyad, Moving, Vector};
use laboratory::number::Number;

/// A form of the formulas.
pub(crate) trait Form<F> {
    type Link: Link<F>;

    /// The pin of a crank on the origin, at its angle, rate and acceleration.
    fn crank(&self, input: [F; 3], length: f64) -> Pin<F, Self>;

    /// Two bars from a pin and a pivot, the `nth` of the mechanism.
    fn dyad(&mut self, nth: usize, pin: Pin<F, Self>, dyad: Dyad) -> Option<Bars<F, Self>>;

    /// A crank's pin and the two bars behind it.
    #[inline(always)]
    fn crank_dyad(
        &mut self,
        input: [F; 3],
        CrankDyad { crank, dyad }: CrankDyad,
    ) -> Option<(Pin<F, Self>, Bars<F, Self>)> {
        let pin = self.crank(input, crank);
        Some((pin, self.dyad(0, pin, dyad)?))
    }
}

/// A form that solves a block on a rod too.
pub(crate) trait Block<F>: Form<F> {
    /// The rod about a pivot through a pin, and the pin's distance from the pivot with its rates.
    fn block(&mut self, pin: Pin<F, Self>, pivot: [f64; 2]) -> Option<(Self::Link, [F; 3])>;
}

pub(crate) type Bars<F, S> = [<S as Form<F>>::Link; 2];

pub(crate) type Pin<F, S> = <<S as Form<F>>::Link as Link<F>>::Point;

pub(crate) trait Link<F>: Copy {
    type Point: Point<F>;

    /// The point at (x, y) of the link's axes, whose origin is the pin.
    fn on(self, pin: Self::Point, at: [f64; 2]) -> Self::Point;

    /// The same for a link that turns about a point of the ground.
    fn about(self, pivot: [f64; 2], at: [f64; 2]) -> Self::Point;

    /// The unit vector, its rate and its acceleration.
    fn direction(self) -> ([F; 2], F, F);
}

pub(crate) trait Point<F>: Copy {
    /// Position, velocity and acceleration.
    fn orders(self) -> [[F; 2]; 3];
}

impl<F: Number> Point<F> for Moving<F> {
    #[inline(always)]
    fn orders(self) -> [[F; 2]; 3] {
        [self.position, self.velocity, self.acceleration].map(|Vector { x, y }| [x, y])
    }
}

/// A link as textbooks have it, no operation fused.
impl<F: Number> Link<F> for Turning<F> {
    type Point = Moving<F>;

    #[inline(always)]
    fn on(self, pin: Moving<F>, at: [f64; 2]) -> Moving<F> {
        let swung = self.swung(self.vector(at));
        Moving {
            position: pin.position + swung.position,
            velocity: pin.velocity + swung.velocity,
            acceleration: pin.acceleration + swung.acceleration,
        }
    }

    #[inline(always)]
    fn about(self, pivot: [f64; 2], at: [f64; 2]) -> Moving<F> {
        let swung = self.swung(self.vector(at));
        Moving { position: vector(pivot) + swung.position, ..swung }
    }

    #[inline(always)]
    fn direction(self) -> ([F; 2], F, F) {
        ([self.u.x, self.u.y], self.omega, self.alpha)
    }
}

/// What links as textbooks have them are made of.
trait Swinging<F> {
    /// The vector at (x, y) of the link's axes.
    fn vector(self, at: [f64; 2]) -> Vector<F>;

    /// The motion of a vector that is fixed in the link.
    fn swung(self, r: Vector<F>) -> Moving<F>;
}

impl<F: Number> Swinging<F> for Turning<F> {
    #[inline(always)]
    fn vector(self, [x, y]: [f64; 2]) -> Vector<F> {
        let along = self.u * F::of(x);
        if y == 0.0 { along } else { along + self.u.normal() * F::of(y) }
    }

    #[inline(always)]
    fn swung(self, r: Vector<F>) -> Moving<F> {
        Moving {
            position: r,
            velocity: r.normal() * self.omega,
            acceleration: r.normal() * self.alpha - r * (self.omega * self.omega),
        }
    }
}

#[inline(always)]
fn vector<F: Number>([x, y]: [f64; 2]) -> Vector<F> {
    Vector { x: F::of(x), y: F::of(y) }
}

#[inline(always)]
fn dot<F: Number>(a: Vector<F>, b: Vector<F>) -> F {
    a.x * b.x + a.y * b.y
}

#[inline(always)]
fn cross<F: Number>(a: Vector<F>, b: Vector<F>) -> F {
    a.x * b.y - a.y * b.x
}

/// A crank's pin by the standard library's sine.
#[inline(always)]
fn crank<F: Number>([angle, omega, alpha]: [F; 3], length: f64) -> Moving<F> {
    let u = unit(angle);
    let crank = Turning { u, omega, alpha };
    crank.swung(u * F::of(length))
}

#[inline(always)]
fn unit<F: Number>(angle: F) -> Vector<F> {
    let [x, y] = angle.library_cos_sin();
    Vector { x, y }
}
