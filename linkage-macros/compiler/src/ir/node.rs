//! The nodes of the expression graph, and what each is made from.

use crate::function::Function;

/// A node of a graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Id(pub u32);

impl Id {
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// An interned exact constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ConstantId(pub u32);

/// A condition, see `graph::Guard`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct GuardId(pub u32);

/// Equations that are solved at run time, see `implicit::Implicit`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ImplicitId(pub u32);

/// Selection of the operands that are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Path {
    /// Operands of the fast path: the guarded value, and what it is compared with.
    Fast,
    /// Operands of the slow path as well.
    Slow,
    /// Operands of the fast path, looking through guards.
    Unchecked,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    Constant(ConstantId),
    /// An input (`order` 0), its rate (1) or its acceleration (2).
    Input {
        input: u32,
        order: u8,
    },
    /// The cosine of an input, where an `_at` entry is given it: with `InputSin` a point of the unit
    /// circle, which rewrites may take for granted. The run-time crate divides the amplitude out
    /// of what a resolver gives before any formula sees it.
    InputCos(u32),
    /// The sine of an input, where an `_at` entry is given it.
    InputSin(u32),
    /// A numeric parameter.
    Param(u32),
    /// A load: a force, a torque or a number that a call is given.
    Load(u32),
    /// The effort that drives an input, where a call is given it.
    Drive(u32),
    /// A mode parameter as +1 or −1.
    Mode(u32),
    Neg(Id),
    Add(Id, Id),
    Sub(Id, Id),
    Mul(Id, Id),
    Div(Id, Id),
    /// A function of one number. Sine and cosine of the same angle are one call in the generated code.
    Apply(Function, Id),
    /// A function of two numbers.
    Apply2(Function, Id, Id),
    /// a·b − c·d, rounded as if it were one operation; opaque to simplification except where it
    /// collapses to a single product.
    Det([Id; 4]),
    /// `Select([a, b, x, y])`: x where a ≥ b, y elsewhere. Both must be numbers.
    Select([Id; 4]),
    /// The rounding error of a product: zero in real arithmetic.
    MulErr(Id, Id),
    /// The rounding error of a sum: zero in real arithmetic.
    AddErr(Id, Id),
    /// The low word of a constant: what rounding it to a number of the working width leaves.
    Low(ConstantId),
    /// a·b + c, fused where the number has a fused operation.
    Fused(Id, Id, Id),
    /// The value, provided that the guard's condition holds.
    Guard(Id, GuardId),
    /// A value at which the equation of an unknown is tried. What depends on it is computed inside
    /// the search alone.
    Trial(u32),
    /// One of the numbers that come out of equations solved at run time, and the value that it stands
    /// on, if there is one: of an amount of friction the one that straight-line code has found, of a
    /// root's size the root.
    Solved(ImplicitId, u32, Option<Id>),
}

/// Specification of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct RootSearch {
    pub unknown: u32,
    pub wanted: Target,
    /// The sign of the slope at the root.
    pub trend: Trend,
    pub between: [Id; 2],
    pub near: Option<Id>,
    /// For a root, both sides at the trial and the slope of their difference; for an end, their difference,
    /// its slope and its curvature.
    pub sides: [Id; 3],
}

/// Target of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Target {
    Root,
    /// The lower (0) or upper (1) end of the stretch on which the equation has the trend.
    End(u8),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Trend {
    Rising,
    Falling,
    /// As this mode parameter says.
    Param(u32),
}

impl Trend {
    /// The sign of the slope, unless a parameter chooses it.
    pub fn sign(self) -> Option<f64> {
        match self {
            Self::Rising => Some(1.0),
            Self::Falling => Some(-1.0),
            Self::Param(_) => None,
        }
    }

    /// The mode parameter that chooses.
    pub(crate) fn param(self) -> Option<u32> {
        match self {
            Self::Param(param) => Some(param),
            Self::Rising | Self::Falling => None,
        }
    }

    /// The directions in which the equation can pass its root, true where it rises.
    pub(crate) const fn rises(self) -> &'static [bool] {
        match self {
            Self::Rising => &[true],
            Self::Falling => &[false],
            Self::Param(_) => &[true, false],
        }
    }
}

impl Node {
    /// Calls `f` with every operand that stands in the node itself: `Graph::for_operands` knows the others.
    pub fn for_operands(self, f: &mut impl FnMut(Id)) {
        self.map_operands(&mut |operand| {
            f(operand);
            operand
        });
    }

    /// The same node on other operands; those of a guard and of what is solved are not among them.
    pub(crate) fn map_operands(self, f: &mut impl FnMut(Id) -> Id) -> Self {
        match self {
            Self::Constant(_)
            | Self::Input { .. }
            | Self::InputCos(_)
            | Self::InputSin(_)
            | Self::Param(_)
            | Self::Load(_)
            | Self::Drive(_)
            | Self::Mode(_)
            | Self::Trial(_)
            | Self::Low(_) => self,
            Self::Solved(solve, output, on) => Self::Solved(solve, output, on.map(f)),
            Self::Neg(a) => Self::Neg(f(a)),
            Self::Apply(function, a) => Self::Apply(function, f(a)),
            Self::Guard(a, guard) => Self::Guard(f(a), guard),
            Self::Add(a, b) => Self::Add(f(a), f(b)),
            Self::Sub(a, b) => Self::Sub(f(a), f(b)),
            Self::Mul(a, b) => Self::Mul(f(a), f(b)),
            Self::Div(a, b) => Self::Div(f(a), f(b)),
            Self::Apply2(function, a, b) => Self::Apply2(function, f(a), f(b)),
            Self::MulErr(a, b) => Self::MulErr(f(a), f(b)),
            Self::AddErr(a, b) => Self::AddErr(f(a), f(b)),
            Self::Fused(a, b, c) => Self::Fused(f(a), f(b), f(c)),
            Self::Det(operands) => Self::Det(operands.map(f)),
            Self::Select(operands) => Self::Select(operands.map(f)),
        }
    }
}
