//! The conditions that values stand under: a row each.

use crate::exact::Exact;

/// A condition on a value. The fast path makes the comparison of its row; the slow path looks at the
/// operands and decides, by the type of the run-time crate that the row names.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Check {
    /// Circles of radii l₁ and l₂ about points d = (dx, dy) apart must meet. Operands dx, dy, l₁, l₂, a
    /// unit and the spread, a number that rounding changes the value in the last places of. The value is
    /// (d² − (l₁ − l₂)²) ((l₁ + l₂)² − d²)/(4 l₁ l₂)² in squares of the unit. Where rounding could have
    /// changed its sign, the slow path computes it without rounding; at the limit it is 0.
    ReachCircles,
    /// Where the `ReachCircles` of the first operand, its value, is decided without rounding, so is
    /// this, (d² + l₁² − l₂²)/2d²; at the limit it is ± l₁/|d|. The other operands are those of
    /// `ReachCircles` but for the unit.
    ShareOfCentres,
    /// A point must have the distances r₁ and r₂ from (0, 0) and (l, 0). Operands l, r₁, r₂ and the
    /// spread. The value is the square of the point's y, replaced as that of `ReachCircles` is.
    ReachDistances,
    /// |t| ≤ l. Operands t, l. At the limit the value is replaced by 0.
    ReachLine,
    /// |e| ≤ |(bx, by)|. Operands bx, by, e. At the limit the value is replaced by 0.
    ReachOffset,
    /// Zero is `Singular`.
    Nonzero,
    /// Zero or negative is `Invalid` with this name.
    Positive(String),
    /// Negative is `Invalid` with this name.
    NotNegative(String),
    /// An equation's left − right in the final pose, in this unit. Operand: the size of its sides.
    /// Both paths ask whether it is closed; `NoSolution`, where it is not, bears the group's name.
    Closed(String),
    /// The slope of an equation at its root, in the wanted way, or a pivot of a mass matrix; `Singular`
    /// where rounding could have made it positive. Operand: the spread.
    Moving,
    /// The start of Newton's method is below the limit of its certificate, by the value; `NotCertified` where it is not.
    Certified,
    /// A squared length below the smallest of full precision is refused, as `Singular` where it is the
    /// square of zero.
    Square,
    /// `Square` of d with the first four operands of `ReachCircles`: out of reach where these circles do
    /// not meet.
    SquareOfCentres,
}

/// The comparison of a value with a threshold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// value > threshold
    Above,
    /// value ≥ threshold
    AtLeast,
    /// |value| > threshold
    Away,
}

/// The threshold that the condition itself asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Least {
    Zero,
    /// The rounding of the last operand, a spread.
    Rounding,
    /// The smallest number of full precision.
    Normal,
    /// The smallest square of full precision.
    Square,
}

/// A condition's row.
#[derive(Clone, Copy, Debug)]
pub struct CheckRow {
    /// The condition's type in the run-time crate.
    pub diagnosis: &'static str,
    /// The comparison of the fast path, if it makes one.
    pub comparison: Option<(Comparison, Least)>,
    /// True if the slow path reads the operands; otherwise they are computed first, and the value decides.
    pub reads_operands: bool,
    /// True for a constant that passes in every width.
    pub holds: fn(&Exact) -> bool,
}

/// Triangles of dyads: two bars, a bar and a guide, a block and its bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TransmissionTriangle {
    Bars,
    Guide,
    Block,
}

impl Check {
    pub fn row(&self) -> CheckRow {
        use Comparison::{Above, AtLeast, Away};
        let row = |diagnosis, comparison, reads_operands, holds| CheckRow {
            diagnosis,
            comparison,
            reads_operands,
            holds,
        };
        let [above_zero, above_rounding] =
            [Least::Zero, Least::Rounding].map(|least| Some((Above, least)));
        let [at_least_zero, normal, full_square] =
            [Least::Zero, Least::Normal, Least::Square].map(|least| Some((AtLeast, least)));
        match self {
            Self::ReachCircles => row("ReachCircles", above_rounding, true, is_positive),
            // A constant is not rounded before it is known.
            Self::ShareOfCentres => row("ShareOfCentres", None, true, |_| true),
            Self::ReachDistances => row("ReachDistances", above_rounding, true, is_positive),
            Self::ReachLine => row("ReachLine", normal, true, is_positive),
            Self::ReachOffset => row("ReachOffset", at_least_zero, true, is_positive),
            Self::Nonzero => row("Nonzero", Some((Away, Least::Zero)), false, |x| !x.is_zero()),
            Self::Positive(_) => row("Positive", above_zero, false, is_positive),
            Self::NotNegative(_) => {
                row("NotNegative", at_least_zero, false, |x| x.signum().is_ge())
            }
            // An equation that nothing moves is left to run time.
            Self::Closed(_) => row("Closed", None, true, |_| false),
            Self::Moving => row("Moving", above_rounding, true, is_positive),
            Self::Certified => row("Certified", above_zero, false, is_positive),
            Self::Square => row("Square", full_square, false, is_square),
            Self::SquareOfCentres => row("SquareOfCentres", full_square, true, is_square),
        }
    }

    /// The name of a length that has to be positive, or the unit of an equation.
    pub(crate) fn word(&self) -> Option<&str> {
        match self {
            Self::Positive(word) | Self::NotNegative(word) | Self::Closed(word) => Some(word),
            _ => None,
        }
    }

    /// True if both paths look at the operands, and neither puts anything in the value's place.
    pub(crate) fn is_of_both_paths(&self) -> bool {
        matches!(self, Self::Closed(_))
    }

    /// True if the last operand is a spread, which the fast path compares the value with.
    pub(crate) fn has_spread(&self) -> bool {
        matches!(self.row().comparison, Some((_, Least::Rounding)))
    }

    /// The triangle whose sine of transmission follows from the value.
    pub(crate) fn triangle(&self) -> Option<TransmissionTriangle> {
        match self {
            Self::ReachCircles => Some(TransmissionTriangle::Bars),
            Self::ReachLine => Some(TransmissionTriangle::Guide),
            Self::ReachOffset => Some(TransmissionTriangle::Block),
            _ => None,
        }
    }

    /// True if every value that passes is above zero.
    pub(crate) fn keeps_above_zero(&self) -> bool {
        matches!(self.row().comparison, Some((Comparison::Above, _)))
    }
}

fn is_positive(value: &Exact) -> bool {
    value.signum().is_gt()
}

/// Far inside the range of squares that both widths hold with full precision.
fn is_square(value: &Exact) -> bool {
    (1e-24..1e24).contains(&value.to_f64())
}
