//! The functions that expressions call: a row each.
//!
//! A row holds the name in declarations and in generated code, what the function takes and gives, and
//! what is known of its values. Exact values stand in `exact::angle`, rates in `equations::functions`; a function that no
//! processor has is a variant of `LibraryFunction` in the run-time crate, and a line in the run-times of C and of a page.

/// A function of one number or two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
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
    Exp,
    /// The natural logarithm.
    Ln,
    Tanh,
    /// A power. One by an integer is a product, and no call.
    Pow,
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
    /// A number of a number.
    Plain,
    /// The power of the first argument's unit, if the second is a known integer; otherwise a number of numbers.
    Power,
    /// The angle of a vector, whose components have a common dimension.
    Direction,
}

/// A function's row.
pub struct FunctionRow {
    pub function: Function,
    pub name: &'static str,
    arity: usize,
    measures: Measures,
    /// The largest magnitude of a value that no argument exceeds, rounding aside.
    largest: Option<f64>,
    /// The error that the run-time promises in units in the last place, in double and in single precision, fused or
    /// not; nothing where a library computes the value.
    last_places: Option<[f64; 2]>,
    /// True if the function has no corner, at which a rate would jump.
    is_smooth: bool,
    /// The reason where constants have no value.
    domain: &'static str,
}

/// The largest error of a sine and a cosine that a target brings: the fast path asks what any within it need.
pub(crate) const HOOKED_SINE: f64 = 1.0 / 1024.0;

/// The order of [`Function`].
pub const ROWS: [FunctionRow; 17] = {
    use Function::{
        Abs, Acos, Asin, Atan, Atan2, Cos, Exp, Hypot, Ln, Max, Min, Pow, Sign, Sin, Sqrt, Tan,
        Tanh,
    };
    use Measures::{Common, Direction, Number, OfAngle, OfNumber, Plain, Power, Root};
    const fn row(
        (function, name, arity): (Function, &'static str, usize),
        measures: Measures,
        largest: Option<f64>,
        domain: &'static str,
    ) -> FunctionRow {
        let last_places = promised(function);
        FunctionRow {
            function,
            name,
            arity,
            measures,
            largest,
            last_places,
            is_smooth: true,
            domain,
        }
    }
    const fn promised(function: Function) -> Option<[f64; 2]> {
        match function {
            // Rounded as IEEE 754 asks.
            Sqrt => Some([0.5; 2]),
            // The root of the squares, where the fast path may use it.
            Hypot => Some([1.5; 2]),
            // The kernel for near arguments.
            Sin | Cos => Some([1.71, 0.85]),
            Asin | Acos | Atan | Atan2 => Some([1.5; 2]),
            Abs | Sign | Min | Max => Some([0.0; 2]),
            Tan | Exp | Ln | Tanh | Pow => None,
        }
    }
    const fn cornered(name: (Function, &'static str, usize), measures: Measures) -> FunctionRow {
        FunctionRow { is_smooth: false, ..row(name, measures, None, "") }
    }
    const SIGNED: &str = "a square root needs a number that is not negative";
    const SINE: &str = "a sine or a cosine lies between -1 and 1";
    const POLE: &str = "the tangent is infinite where the cosine is zero";
    const ZERO: &str = "the zero vector has no direction";
    const EXPONENT: &str = "e to a power beyond 700 is beyond floating point";
    const ABOVE_ZERO: &str = "a logarithm needs a number above zero";
    const BASE: &str = "a power that is no integer needs a number above zero";
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
        row((Exp, "exp", 1), Plain, None, EXPONENT),
        // Of the least subnormal and the largest number of double precision.
        row((Ln, "ln", 1), Plain, Some(746.0), ABOVE_ZERO),
        row((Tanh, "tanh", 1), Plain, Some(1.0), ""),
        row((Pow, "pow", 2), Power, None, BASE),
    ]
};

impl Function {
    /// The largest integer that [`Self::Pow`] takes as an exponent.
    pub(crate) const LARGEST_POWER: i64 = 64;

    /// The argument that has to be above zero, if one has: the first of a logarithm, and of a power by no
    /// integer.
    pub(crate) const fn needs_positive(self) -> bool {
        matches!(self, Self::Ln | Self::Pow)
    }

    const fn row(self) -> &'static FunctionRow {
        &ROWS[self as usize]
    }

    pub fn named(name: &str) -> Option<Self> {
        ROWS.iter().find(|row| row.name == name).map(|row| row.function)
    }

    /// The names of all functions.
    pub(crate) fn names() -> impl Iterator<Item = &'static str> {
        ROWS.iter().map(|row| row.name)
    }

    pub const fn name(self) -> &'static str {
        self.row().name
    }

    /// The number of arguments.
    pub const fn arity(self) -> usize {
        self.row().arity
    }

    pub(crate) const fn measures(self) -> Measures {
        self.row().measures
    }

    /// The largest magnitude of a value, rounding aside; `None` where it depends on the argument.
    pub(crate) const fn largest(self) -> Option<f64> {
        self.row().largest
    }

    /// The error that the run-time promises in units in the last place, in double and in single precision; `None`
    /// where a library computes the value.
    pub const fn last_places(self) -> Option<[f64; 2]> {
        self.row().last_places
    }

    /// True if the argument is reduced by turns, which takes words of π.
    pub(crate) const fn reduces_turns(self) -> bool {
        matches!(self, Self::Sin | Self::Cos)
    }

    /// True if the value is a square root.
    pub(crate) const fn takes_a_root(self) -> bool {
        matches!(self, Self::Sqrt | Self::Hypot)
    }

    /// True if a dimension may depend on the function.
    pub(crate) const fn is_smooth(self) -> bool {
        self.row().is_smooth
    }

    /// True for the functions whose value is as many times as large as all of their arguments are: an absolute value, and
    /// the length of a vector.
    pub(crate) const fn is_a_size(self) -> bool {
        matches!(self, Self::Abs | Self::Hypot)
    }

    /// The reason why constants may have no value.
    pub(crate) const fn domain(self) -> &'static str {
        self.row().domain
    }
}

/// A number of the standard library.
pub(crate) trait Floating: Copy {
    /// The value of a function; one of a single argument takes x.
    fn of(function: Function, x: Self, y: Self) -> Self;
}

macro_rules! floating {
    ($($float:ident)+) => {$(
impl Floating for $float {
    fn of(function: Function, x: Self, y: Self) -> Self {
        use Function::{
            Abs, Acos, Asin, Atan, Atan2, Cos, Exp, Hypot, Ln, Max, Min, Pow, Sign, Sin, Sqrt, Tan, Tanh,
        };
        match function {
            Sqrt => x.sqrt(),
            Hypot => x.hypot(y),
            Sin => x.sin(),
            Cos => x.cos(),
            Tan => x.tan(),
            Asin => x.asin(),
            Acos => x.acos(),
            Atan => x.atan(),
            Atan2 => x.atan2(y),
            Exp => x.exp(),
            Ln => x.ln(),
            Tanh => x.tanh(),
            Pow => x.powf(y),
            Abs | Sign | Min | Max => unreachable!("a corner is made of comparisons"),
        }
    }
}
    )+};
}

floating! { f64 f32 }
