//! The numbers of the forms that a hand writes: with the standard library's functions, and with a hand's own sine.

use linkage_core::Scalar;
use linkage_tests::double_double::DoubleDouble;

use crate::hand::sine;

/// `f32`, `f64`, and for the truth two words.
pub trait Number: Scalar<Mask = bool> {
    /// A decimal number of up to ten places, rounded once.
    #[inline(always)]
    #[must_use]
    fn of(value: f64) -> Self {
        Self::num(value)
    }

    /// Cosine and sine by the standard library.
    #[must_use]
    fn library_cos_sin(self) -> [Self; 2];

    /// The angle of the vector (x, self) by the standard library.
    #[must_use]
    fn library_atan2(self, x: Self) -> Self;

    /// Cosine and sine by the polynomials of [`sine`].
    #[must_use]
    fn cos_sin(self) -> [Self; 2];
}

macro_rules! number {
    ($t:ident, $cos_sin:path) => {
        impl Number for $t {
            #[inline(always)]
            fn library_cos_sin(self) -> [Self; 2] {
                let (sin, cos) = $t::sin_cos(self);
                [cos, sin]
            }
            #[inline(always)]
            fn library_atan2(self, x: Self) -> Self {
                $t::atan2(self, x)
            }
            #[inline(always)]
            fn cos_sin(self) -> [Self; 2] {
                $cos_sin(self)
            }
        }
    };
}

number!(f64, sine::cos_sin);
number!(f32, sine::cos_sin_single);

impl Number for DoubleDouble {
    fn of(value: f64) -> Self {
        const PLACES: f64 = 1e10;
        Self::new((value * PLACES).round()) / Self::new(PLACES)
    }
    fn library_cos_sin(self) -> [Self; 2] {
        let (sin, cos) = Scalar::sin_cos(self);
        [cos, sin]
    }
    fn library_atan2(self, x: Self) -> Self {
        Scalar::atan2(self, x)
    }
    fn cos_sin(self) -> [Self; 2] {
        self.library_cos_sin()
    }
}
