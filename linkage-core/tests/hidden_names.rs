//! Generated code names the hidden module and nothing else: it must compile without a prelude and
//! beside a `core` that is not the core library.

#![allow(unused_qualifications, reason = "every name comes from the hidden module, as generated")]
#![allow(unreachable_pub, reason = "a generated struct is as public as its declaration says")]

mod core {}

#[no_implicit_prelude]
mod generated {
    use ::linkage_core::private as p;

    /// A crank with a pin, as it could be generated.
    pub struct Crank<T = p::f64> {
        pub radius: T,
        pub elbow: p::Side,
        pub use_new_: p::PhantomData<T>,
    }

    impl<T: p::Scalar> p::Copy for Crank<T> {}

    impl<T: p::Scalar> p::Clone for Crank<T> {
        fn clone(&self) -> Self {
            *self
        }
    }

    impl<T: p::Scalar> p::Debug for Crank<T> {
        fn fmt(&self, f: &mut p::Formatter<'_>) -> p::fmt::Result {
            f.debug_struct("Crank").field("radius", &self.radius).finish()
        }
    }

    impl<T: p::Scalar> p::Default for Crank<T> {
        fn default() -> Self {
            Self { radius: T::lit(0.25, 0.25), elbow: p::Side::Left, use_new_: p::PhantomData }
        }
    }

    impl Crank<p::f64> {
        pub const OUTPUTS: [&'static p::str; 2] = ["B.x", "B.y"];
        pub const COST: p::Cost = p::cost(&[[0, 3, 0, 0, 1], [0; 5], [0; 5]], &[]);
    }

    impl<T: p::Scalar> Crank<T> {
        pub fn solve_position(&self, theta: T) -> (p::Point<T>, T::Mask) {
            let (sin, cos) = p::Scalar::sin_cos_near(theta);
            let side = p::Side::sign::<T>(self.elbow);
            let y = side * self.radius * sin;
            (p::Point { x: self.radius * cos, y }, p::Scalar::is_near(theta))
        }
    }

    impl<T: p::Real> Crank<T> {
        pub fn position(&self, theta: T) -> p::Result<p::Point<T>, p::SolveError> {
            let (position, usable) = self.solve_position(theta);
            if p::Mask::all(usable) {
                return p::Ok(position);
            }
            let (cos, sin) = p::from_angle(theta, "theta", |cos, sin| p::Ok((cos, sin)))?;
            let mut first_error = p::FirstError::new();
            let radius =
                p::Checks::guard(&mut first_error, self.radius, p::Positive("AB", "radius"));
            first_error.first()?;
            let y = p::Side::sign::<T>(self.elbow) * radius * sin;
            p::Ok(p::Point { x: radius * cos, y })
        }

        pub fn lift<U: p::Scalar>(&self) -> Crank<U> {
            let radius = p::Real::value(self.radius);
            let radius = U::lit(radius, radius as p::f32);
            Crank { radius, elbow: self.elbow, use_new_: p::PhantomData }
        }
    }

    p::with_ad! {
        impl<T: p::Differentiable> Crank<T> {
            pub fn jacobian(&self, theta: T) -> p::Result<p::SMatrix<T, 2, 1>, p::SolveError> {
                let lifted = self.lift();
                p::differentiate([theta], |[theta]| {
                    let position = lifted.position(theta)?;
                    p::Ok([position.x, position.y])
                })
            }
        }
    }
}

use generated::Crank;
use linkage_core::{Lanes, Side, SolveError};

#[test]
fn the_solver_runs_on_every_number() {
    let crank = Crank::<f64>::default();
    let pin = crank.position(0.0).unwrap();
    assert_eq!((pin.x, pin.y), (0.25, 0.0));
    let right = Crank { elbow: Side::Right, ..crank };
    assert_eq!(right.position(1.0).unwrap().y, -crank.position(1.0).unwrap().y);
    assert_eq!(crank.lift::<f32>().position(0.0).unwrap().x, 0.25);
    let (pins, usable) = crank.lift().solve_position(Lanes::<f64, 2>::from([0.0, 1e9]));
    assert_eq!((pins.x.to_array()[0], usable.to_array()), (0.25, [true, false]));
    assert_eq!(Crank::OUTPUTS.len(), 2);
    assert_eq!(Crank::COST.position.total(), 4);
    assert_eq!(format!("{crank:?}"), "Crank { radius: 0.25 }");
}

#[test]
fn the_slow_path_explains_itself() {
    let crank = Crank::<f64>::default();
    assert!(crank.position(1e9).is_ok());
    assert_eq!(crank.position(f64::NAN), Err(SolveError::NotFinite { name: "theta" }));
    let nothing = Crank { radius: 0.0, ..crank };
    let invalid = SolveError::Invalid { group: "AB", name: "radius" };
    assert_eq!(nothing.position(1e9), Err(invalid));
}

#[cfg(feature = "ad")]
#[test]
fn the_jacobian_is_there_with_the_feature() {
    let jacobian = Crank::<f64>::default().jacobian(0.0).unwrap();
    assert_eq!((jacobian[(0, 0)], jacobian[(1, 0)]), (0.0, 0.25));
}
