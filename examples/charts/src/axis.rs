//! Ends and ticks of axes: one rule for all panels.

/// From where to where an axis goes, and how far its ticks are apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Axis {
    pub ends: [f64; 2],
    pub step: f64,
}

/// True if the label of an axis says degrees.
pub(crate) fn is_angle(label: &str) -> bool {
    label == "deg" || label.ends_with(" deg") || label.ends_with(" degrees")
}

impl Axis {
    /// Four to eight steps of 1, 2 or 5 times a power of ten; of parts of a turn for degrees.
    pub(crate) fn over(values: impl Iterator<Item = f64>, label: &str) -> Self {
        let [low, high] = values
            .filter(|value| value.is_finite())
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
                [value.min(low), value.max(high)]
            });
        let [low, high] = match () {
            () if low < high => [low, high],
            // One value, or none.
            () if low.is_finite() => [low - 1.0, low + 1.0],
            () => [0.0, 1.0],
        };
        let size = high - low;
        let power = 10_f64.powf((size / 8.0).log10().floor());
        let decimal = [1.0, 2.0, 5.0, 10.0].map(|step| step * power);
        let turns = [15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0];
        let fits = |most: f64| move |step: &f64| size / step <= most + 1e-9;
        let step = match is_angle(label) && size >= 60.0 {
            true => turns.into_iter().find(fits(7.0)),
            false => decimal.into_iter().find(fits(8.0)),
        };
        Self { ends: [low, high], step: step.unwrap_or(10.0 * power) }
    }

    /// The ends at whole steps.
    pub(crate) fn round(self) -> [f64; 2] {
        let [low, high] = self.ends.map(|end| end / self.step);
        // An end within a billionth of a step is at it.
        let [low, high] = [(low + 1e-9).floor(), (high - 1e-9).ceil()];
        [low * self.step, high.max(low + 1.0) * self.step]
    }
}

/// A tick's number, with as many digits as it has and a true minus; powers of ten where it is very large
/// or small.
pub(crate) fn written(value: f64) -> String {
    let size = value.abs();
    let text = match size {
        0.0 => return "0".to_owned(),
        size if !(1e-4..1e6).contains(&size) => {
            let power = size.log10().floor();
            let mantissa = size / 10_f64.powf(power);
            let raised: String = format!("{power}").chars().map(superscript).collect();
            match (mantissa * 1e6).round() / 1e6 {
                1.0 => format!("10{raised}"),
                mantissa => format!("{mantissa}·10{raised}"),
            }
        }
        size => {
            let text = format!("{size:.6}");
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        }
    };
    if value < 0.0 { format!("−{text}") } else { text }
}

fn superscript(letter: char) -> char {
    match letter {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => {
            digit.to_digit(10).and_then(|digit| char::from_u32(0x2070 + digit)).unwrap_or(digit)
        }
    }
}

/// An angle in degrees in pieces between its jumps by nearly half a turn or more.
pub(crate) fn pieces(points: &[(f64, f64)]) -> Vec<&[(f64, f64)]> {
    const JUMP: f64 = 170.0;
    let mut pieces = Vec::new();
    let mut start = 0;
    for end in 1..points.len() {
        if (points[end].1 - points[end - 1].1).abs() > JUMP {
            pieces.push(&points[start..end]);
            start = end;
        }
    }
    pieces.push(&points[start..]);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_neither_few_nor_many() {
        for exponent in -6..7 {
            for mantissa in [1.0, 1.3, 2.0, 3.1, 4.9, 7.7] {
                let size = mantissa * 10_f64.powi(exponent);
                let axis = Axis::over([-0.3 * size, 0.7 * size].into_iter(), "x in m");
                let steps = size / axis.step;
                assert!((3.0..=8.0 + 1e-6).contains(&steps), "{size}: {steps}");
                let [low, high] = axis.round();
                assert!(low <= -0.3 * size + 1e-9 * size && high >= 0.7 * size - 1e-9 * size);
                assert!(high - low < size + 2.0 * axis.step);
            }
        }
        assert_eq!(Axis::over([0.0, 360.0].into_iter(), "crank in deg").step, 60.0);
        assert_eq!(Axis::over([-180.0, 180.0].into_iter(), "deg").round(), [-180.0, 180.0]);
        assert_eq!(Axis::over([3.0].into_iter(), "m").ends, [2.0, 4.0]);
    }

    #[test]
    fn numbers_are_written_one_way() {
        let all = [0.0, -0.0, 2.0, 2.5, -100.0, 1e-5, -2e7, 0.125].map(written);
        assert_eq!(all, ["0", "0", "2", "2.5", "−100", "10⁻⁵", "−2·10⁷", "0.125"]);
    }

    #[test]
    fn an_angle_that_leaves_a_turn_is_cut() {
        let points = [(0.0, 170.0), (1.0, 179.0), (2.0, -179.0), (3.0, -20.0), (4.0, 60.0)];
        assert_eq!(pieces(&points), [&points[..2], &points[2..]]);
        assert_eq!(pieces(&points[..1]), [&points[..1]]);
    }
}
