//! Numbers of a report, as an engineer reads them.

/// Three digits, and a power of ten where it is far from one.
pub(super) fn short(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_string();
    }
    let power = value.abs().log10().floor();
    if !(-3.0..5.0).contains(&power) {
        return format!("{value:.*e}", digits - 1);
    }
    let after = (digits as f64 - 1.0 - power).max(0.0);
    format!("{value:.*}", after as usize)
}

/// A number with its unit; of lengths, and what is made of one, in the unit of its size.
pub(super) fn with_unit(value: f64, unit: &str) -> String {
    scaled(value, unit, 2)
}

/// The same with so many digits.
pub(super) fn scaled(value: f64, unit: &str, digits: usize) -> String {
    let Some(rest) = unit.strip_prefix('m').filter(|rest| rest.is_empty() || rest.starts_with('/'))
    else {
        return match unit {
            "1" => short(value, digits),
            _ => format!("{} {unit}", short(value, digits)),
        };
    };
    let size = value.abs();
    let (factor, prefix) = match size {
        _ if size == 0.0 || size >= 1.0 => (1.0, ""),
        _ if size >= 1e-3 => (1e3, "m"),
        _ if size >= 1e-7 => (1e6, "µ"),
        _ if size >= 1e-10 => (1e9, "n"),
        _ => (1.0, ""),
    };
    format!("{} {prefix}m{rest}", short(value * factor, digits))
}

/// A place of a range: an angle in degrees.
pub(super) fn place(value: f64, unit: &str) -> String {
    match unit {
        "rad" => format!("{:.1}°", value.to_degrees()),
        _ => scaled(value, unit, 4),
    }
}

/// The same with all the digits that tell a limit.
pub(super) fn exact_place(value: f64, unit: &str) -> String {
    match unit {
        "rad" => format!("{:.6}°", value.to_degrees()),
        _ => scaled(value, unit, 8),
    }
}

/// Correct digits of the largest value.
pub(super) fn digits(within: f64, largest: f64) -> Option<f64> {
    (within > 0.0 && largest > 0.0).then(|| -(within / largest).log10())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_as_an_engineer_writes_them() {
        assert_eq!(scaled(0.46471, "m", 4), "464.7 mm");
        assert_eq!(with_unit(1.94e-7, "m"), "0.19 µm");
        assert_eq!(with_unit(4.2e-16, "m"), "4.2e-16 m");
        assert_eq!(scaled(0.2277, "rad/s", 4), "0.2277 rad/s");
        assert_eq!(with_unit(2.71e-7, "1"), "2.7e-7");
        assert_eq!(place(core::f64::consts::PI, "rad"), "180.0°");
        assert_eq!(short(123.0, 2), "123");
    }
}
