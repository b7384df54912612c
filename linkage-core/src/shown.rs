//! Numbers in the texts of errors: a few digits, and lengths in the unit that suits them.

use core::fmt;

/// A length in metres, shown with three digits in m, mm or µm.
pub(crate) struct Length(pub f64);

impl fmt::Display for Length {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(metres) = *self;
        // A tenth of a millimetre is still thought of in millimetres; below a tenth of a
        // micrometre it is rounding that is meant, and its power of ten says most.
        let (value, unit) = match metres.abs() {
            size if size >= 0.9995 => (metres, "m"),
            size if size >= 0.99950e-4 => (metres * 1e3, "mm"),
            size if size >= 0.99950e-7 => (metres * 1e6, "µm"),
            _ => (metres, "m"),
        };
        write!(f, "{} {unit}", Digits(value))
    }
}

/// A number in a unit: lengths in the one that suits them, angles in degrees.
pub(crate) struct Measured {
    pub value: f64,
    /// `m`, `rad`, `m²`, or `1` for a plain number.
    pub unit: &'static str,
}

impl fmt::Display for Measured {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { value, unit } = *self;
        // Letter by letter: comparing strings at once is a call to the C library.
        match unit.as_bytes() {
            [b'm'] => Length(value).fmt(f),
            [b'r', b'a', b'd'] => write!(f, "{}°", Digits(value.to_degrees())),
            [b'1'] => Digits(value).fmt(f),
            _ => write!(f, "{} {unit}", Digits(value)),
        }
    }
}

/// A number with three digits.
pub(crate) struct Digits(pub f64);

impl fmt::Display for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = *self;
        // A value that would round up to the next power of ten has one decimal less.
        match value.abs() {
            0.0 => f.write_str("0"),
            size if size >= 999.5e3 => write!(f, "{value:.2e}"),
            size if size >= 99.95 => write!(f, "{value:.0}"),
            size if size >= 9.995 => write!(f, "{value:.1}"),
            size if size >= 0.9995 => write!(f, "{value:.2}"),
            size if size >= 0.09995 => write!(f, "{value:.3}"),
            size if size >= 0.009_995 => write!(f, "{value:.4}"),
            _ => write!(f, "{value:.2e}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn a_length_has_three_digits_and_a_fitting_unit() {
        for (metres, text) in [
            (0.000_121_230_529_915_555_83, "0.121 mm"),
            (0.25, "250 mm"),
            (2.9, "2.90 m"),
            (12.34, "12.3 m"),
            (1234.4, "1234 m"),
            (0.9999, "1.00 m"),
            (0.012_34, "12.3 mm"),
            (0.000_099_96, "0.100 mm"),
            (0.000_012_34, "12.3 µm"),
            (4.4e-16, "4.40e-16 m"),
            (1e9, "1.00e9 m"),
            (f64::MAX, "1.80e308 m"),
            (0.0, "0 m"),
            (-0.5, "-500 mm"),
            (f64::INFINITY, "inf m"),
        ] {
            assert_eq!(Length(metres).to_string(), text, "{metres}");
        }
    }

    #[test]
    fn a_number_has_three_digits() {
        for (value, text) in
            [(0.873_2, "0.873"), (9.996, "10.0"), (0.01, "0.0100"), (1e-3, "1.00e-3")]
        {
            assert_eq!(Digits(value).to_string(), text);
        }
    }

    #[test]
    fn what_is_measured_has_a_unit() {
        for (value, unit, text) in [
            (0.012_34, "m", "12.3 mm"),
            (core::f64::consts::FRAC_PI_6, "rad", "30.0°"),
            (-1e-6, "rad", "-5.73e-5°"),
            (0.5, "1", "0.500"),
            (0.25, "m²", "0.250 m²"),
            (2.0, "1/m", "2.00 1/m"),
        ] {
            assert_eq!(Measured { value, unit }.to_string(), text);
        }
    }
}
