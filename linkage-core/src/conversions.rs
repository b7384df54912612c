//! Points and directions as other crates' types, each behind the feature of that crate's name.

#[cfg(feature = "mint")]
mod for_mint {
    use crate::Point;

    impl<T> From<mint::Point2<T>> for Point<T> {
        #[inline]
        fn from(mint::Point2 { x, y }: mint::Point2<T>) -> Self {
            Self { x, y }
        }
    }

    impl<T> From<mint::Vector2<T>> for Point<T> {
        #[inline]
        fn from(mint::Vector2 { x, y }: mint::Vector2<T>) -> Self {
            Self { x, y }
        }
    }

    impl<T> From<Point<T>> for mint::Point2<T> {
        #[inline]
        fn from(Point { x, y }: Point<T>) -> Self {
            Self { x, y }
        }
    }

    impl<T> From<Point<T>> for mint::Vector2<T> {
        #[inline]
        fn from(Point { x, y }: Point<T>) -> Self {
            Self { x, y }
        }
    }

    impl<T> mint::IntoMint for Point<T> {
        type MintType = mint::Point2<T>;
    }
}

#[cfg(feature = "nalgebra")]
mod for_nalgebra {
    use approx::{AbsDiffEq, RelativeEq, UlpsEq};
    use nalgebra::{Complex, Point2, UnitComplex, Vector2};

    use crate::{Direction, Point};

    impl<T: nalgebra::Scalar> From<Point2<T>> for Point<T> {
        #[inline]
        fn from(point: Point2<T>) -> Self {
            <[T; 2]>::from(point).into()
        }
    }

    impl<T: nalgebra::Scalar> From<Vector2<T>> for Point<T> {
        #[inline]
        fn from(vector: Vector2<T>) -> Self {
            <[T; 2]>::from(vector).into()
        }
    }

    impl<T: nalgebra::Scalar> From<Point<T>> for Point2<T> {
        #[inline]
        fn from(Point { x, y }: Point<T>) -> Self {
            Self::new(x, y)
        }
    }

    impl<T: nalgebra::Scalar> From<Point<T>> for Vector2<T> {
        #[inline]
        fn from(Point { x, y }: Point<T>) -> Self {
            Self::new(x, y)
        }
    }

    impl<T: nalgebra::SimdRealField> From<Direction<T>> for UnitComplex<T> {
        #[inline]
        fn from(Direction { cos, sin }: Direction<T>) -> Self {
            Self::new_unchecked(Complex::new(cos, sin))
        }
    }

    impl<T: nalgebra::SimdRealField> From<UnitComplex<T>> for Direction<T> {
        #[inline]
        fn from(unit: UnitComplex<T>) -> Self {
            let Complex { re: cos, im: sin } = unit.into_inner();
            Self { cos, sin }
        }
    }

    /// Comparison component by component.
    macro_rules! approximately {
        ($record:ident { $first:ident, $second:ident }) => {
            impl<T: AbsDiffEq<Epsilon: Clone>> AbsDiffEq for $record<T> {
                type Epsilon = T::Epsilon;

                fn default_epsilon() -> T::Epsilon {
                    T::default_epsilon()
                }

                fn abs_diff_eq(&self, other: &Self, epsilon: T::Epsilon) -> bool {
                    self.$first.abs_diff_eq(&other.$first, epsilon.clone())
                        && self.$second.abs_diff_eq(&other.$second, epsilon)
                }
            }

            impl<T: RelativeEq<Epsilon: Clone>> RelativeEq for $record<T> {
                fn default_max_relative() -> T::Epsilon {
                    T::default_max_relative()
                }

                fn relative_eq(&self, other: &Self, epsilon: T::Epsilon, most: T::Epsilon) -> bool {
                    self.$first.relative_eq(&other.$first, epsilon.clone(), most.clone())
                        && self.$second.relative_eq(&other.$second, epsilon, most)
                }
            }

            impl<T: UlpsEq<Epsilon: Clone>> UlpsEq for $record<T> {
                fn default_max_ulps() -> u32 {
                    T::default_max_ulps()
                }

                fn ulps_eq(&self, other: &Self, epsilon: T::Epsilon, most: u32) -> bool {
                    self.$first.ulps_eq(&other.$first, epsilon.clone(), most)
                        && self.$second.ulps_eq(&other.$second, epsilon, most)
                }
            }
        };
    }

    approximately! { Point { x, y } }
    approximately! { Direction { cos, sin } }
}

#[cfg(test)]
mod tests {
    #[cfg(feature = "mint")]
    #[test]
    fn mint_carries_both_components() {
        let point = crate::Point::new(1.0, 2.0);
        assert_eq!(crate::Point::from(mint::Point2::from(point)), point);
        assert_eq!(crate::Point::from(mint::Vector2::from(point)), point);
        assert_eq!(mint::Vector2::from(point).y, 2.0);
    }

    #[cfg(feature = "nalgebra")]
    #[test]
    fn nalgebra_carries_both_components() {
        use crate::{Direction, Point};
        use approx::{assert_abs_diff_eq, assert_relative_eq, assert_ulps_ne};
        use nalgebra::{Point2, UnitComplex, Vector2};

        let point = Point::new(1.0, 2.0);
        assert_eq!(Point2::from(point), Point2::new(1.0, 2.0));
        assert_eq!(Point::from(Point2::from(point)), point);
        assert_eq!(Point::from(Vector2::new(1.0, 2.0)), point);
        let turn = UnitComplex::from(Direction::from_angle(0.3));
        // A sine and a cosine, and the arc tangent of both: two roundings.
        assert_abs_diff_eq!(turn.angle(), 0.3, epsilon = 1e-15);
        assert_abs_diff_eq!(Direction::from(turn), Direction::from_angle(0.3));
        assert_relative_eq!(point, Point::new(1.0, 2.0 + 1e-9), max_relative = 1e-9);
        assert_ulps_ne!(point, Point::new(1.0 + 1e-9, 2.0));
    }

    #[cfg(feature = "serde")]
    #[test]
    fn serde_knows_fields_and_modes_by_their_names() {
        use crate::{Direction, Point, Side, SlidingDirection, SolveError};
        use serde::de::value::{Error, MapDeserializer};
        use serde::{Deserialize, Serialize};

        let fields = [("x", 1.5), ("y", -2.0)].into_iter();
        let point = Point::<f64>::deserialize(MapDeserializer::<_, Error>::new(fields));
        assert_eq!(point.unwrap(), Point::new(1.5, -2.0));

        struct Text<T>(T);
        impl<T: Serialize> core::fmt::Display for Text<T> {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                self.0.serialize(f)
            }
        }
        assert_eq!(std::format!("{}", Text(Side::Left)), "Left");

        fn both<T: Serialize + for<'de> Deserialize<'de>>() {}
        both::<Point<f32>>();
        both::<Direction<f64>>();
        both::<SlidingDirection<f64>>();
        fn written<T: Serialize>() {}
        written::<SolveError>();
    }
}
