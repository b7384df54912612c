//! The functions that expressions call: a row each.
//!
//! A row holds the name in declarations and in generated code, what the function takes and gives, and
//! what is known of its values. Exact values stand in `exact::angle`, rates in `equations::functions`.

/// A function of one number or two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Function {
    Sqrt,
    Hypot,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    /// The angle of the vector (second argument, first argument).
    Atan2,
    Abs,
    /// −1, 0 or 1.
    Sign,
    Min,
    Max,
}

/// The dimensions of arguments and value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measures {
    /// Half the powers of the argument's units.
    Root,
    /// An angle's number.
    OfAngle,
    /// The angle that belongs to a number.
    OfNumber,
    /// The common dimension of the arguments.
    Common,
    /// A number of any argument.
    Number,
    /// The angle of a vector, whose components have a common dimension.
    Direction,
}

/// A function's row.
struct Row {
    function: Function,
    name: &'static str,
    arity: usize,
    measures: Measures,
    /// The largest magnitude of a value that no argument exceeds, rounding aside.
    largest: Option<f64>,
    /// True if the function has no corner, at which a rate would jump.
    is_smooth: bool,
    /// The reason where constants have no value.
    domain: &'static str,
}

/// The order of [`Function`].
const ROWS: [Row; 13] = {
    use Function::{Abs, Acos, Asin, Atan, Atan2, Cos, Hypot, Max, Min, Sign, Sin, Sqrt, Tan};
    use Measures::{Common, Direction, Number, OfAngle, OfNumber, Root};
    const fn row(
        (function, name, arity): (Function, &'static str, usize),
        measures: Measures,
        largest: Option<f64>,
        domain: &'static str,
    ) -> Row {
        Row { function, name, arity, measures, largest, is_smooth: true, domain }
    }
    const fn cornered(name: (Function, &'static str, usize), measures: Measures) -> Row {
        Row { is_smooth: false, ..row(name, measures, None, "") }
    }
    const SIGNED: &str = "a square root needs a number that is not negative";
    const SINE: &str = "a sine or a cosine lies between -1 and 1";
    const POLE: &str = "the tangent is infinite where the cosine is zero";
    const ZERO: &str = "the zero vector has no direction";
    [
        row((Sqrt, "sqrt", 1), Root, None, SIGNED),
        row((Hypot, "hypot", 2), Common, None, ""),
        row((Sin, "sin", 1), OfAngle, Some(1.0), ""),
        row((Cos, "cos", 1), OfAngle, Some(1.0), ""),
        row((Tan, "tan", 1), OfAngle, None, POLE),
        row((Asin, "asin", 1), OfNumber, Some(3.2), SINE),
        row((Acos, "acos", 1), OfNumber, Some(3.2), SINE),
        row((Atan, "atan", 1), OfNumber, Some(3.2), ""),
        row((Atan2, "atan2", 2), Direction, Some(3.2), ZERO),
        cornered((Abs, "abs", 1), Common),
        cornered((Sign, "sign", 1), Number),
        cornered((Min, "min", 2), Common),
        cornered((Max, "max", 2), Common),
    ]
};

impl Function {
    const fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    pub(crate) fn named(name: &str) -> Option<Self> {
        ROWS.iter().find(|row| row.name == name).map(|row| row.function)
    }

    /// The names of all functions.
    pub(crate) fn names() -> impl Iterator<Item = &'static str> {
        ROWS.iter().map(|row| row.name)
    }

    pub(crate) const fn name(self) -> &'static str {
        self.row().name
    }

    /// The number of arguments.
    pub(crate) const fn arity(self) -> usize {
        self.row().arity
    }

    pub(crate) const fn measures(self) -> Measures {
        self.row().measures
    }

    /// The largest magnitude of a value, rounding aside; `None` where it depends on the argument.
    pub(crate) const fn largest(self) -> Option<f64> {
        self.row().largest
    }

    /// True if a dimension may depend on the function.
    pub(crate) const fn is_smooth(self) -> bool {
        self.row().is_smooth
    }

    /// The reason why constants may have no value.
    pub(crate) const fn domain(self) -> &'static str {
        self.row().domain
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_stands_where_its_function_points() {
        for (place, row) in ROWS.iter().enumerate() {
            assert_eq!(row.function as usize, place);
            assert_eq!(Function::named(row.name), Some(row.function));
        }
    }
}
