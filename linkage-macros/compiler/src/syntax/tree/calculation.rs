//! Expressions as written.

use proc_macro2::Ident;

use crate::diagnostics::Extent;

/// A unit and its power.
pub type UnitPower = (String, i32);

#[derive(Clone)]
pub struct Expr {
    pub kind: ExprKind,
    /// From the first to the last token.
    pub span: Extent,
}

#[derive(Clone)]
pub enum ExprKind {
    /// The digits as written (underscores removed) and the powers of units behind them, none where
    /// the number is bare. Letters behind the digits that are no unit stand there too.
    Number {
        digits: String,
        units: Vec<UnitPower>,
    },
    Name(Ident),
    /// `ram.slide`, `BC.angle`
    Member(Ident, Ident),
    /// `BC.C.x`, `ram.bed.friction`: a part of what a joint exerts, in outputs.
    Part(Box<[Ident; 3]>),
    Negate(Box<Expr>),
    /// `a - b + c`: operands of one precedence, from left to right. They stand side by side, not
    /// one inside the other, so that a long sum is not a deep one.
    Chain(Box<Expr>, Vec<(BinaryOp, Expr)>),
    Call(Ident, Vec<Expr>),
    /// Left by a part that could not be parsed and was already reported.
    Mistake,
}

impl Expr {
    pub(crate) fn mistake(at: impl Into<Extent>) -> Self {
        Self { kind: ExprKind::Mistake, span: at.into() }
    }

    /// The parts of the expression, from left to right.
    pub(crate) fn parts<'e>(&'e self) -> Box<dyn Iterator<Item = &'e Expr> + 'e> {
        match &self.kind {
            ExprKind::Negate(operand) => Box::new(std::iter::once(&**operand)),
            ExprKind::Chain(first, rest) => {
                Box::new(std::iter::once(&**first).chain(rest.iter().map(|(_, operand)| operand)))
            }
            ExprKind::Call(_, arguments) => Box::new(arguments.iter()),
            ExprKind::Number { .. }
            | ExprKind::Name(_)
            | ExprKind::Member(..)
            | ExprKind::Part(..)
            | ExprKind::Mistake => Box::new(std::iter::empty()),
        }
    }

    /// Calls `f` with the expression and every part of it, outer parts first.
    pub(crate) fn each_part(&self, f: &mut impl FnMut(&Self)) {
        f(self);
        self.parts().for_each(|part| part.each_part(f));
    }

    /// Calls `f` with every name in the expression.
    pub(crate) fn each_name(&self, f: &mut dyn FnMut(&Ident)) {
        self.each_part(&mut |part| match &part.kind {
            ExprKind::Name(name) | ExprKind::Member(name, _) => f(name),
            ExprKind::Part(path) => path[..2].iter().for_each(&mut *f),
            _ => {}
        });
    }

    /// The expression with each part that the function gives another for replaced by that, outer parts
    /// first; what is given is not looked into.
    pub(crate) fn replaced(&self, by: &impl Fn(&Self) -> Option<Self>) -> Self {
        if let Some(other) = by(self) {
            return other;
        }
        let inside = |part: &Self| part.replaced(by);
        let kind = match &self.kind {
            ExprKind::Negate(inner) => ExprKind::Negate(Box::new(inside(inner))),
            ExprKind::Chain(first, rest) => ExprKind::Chain(
                Box::new(inside(first)),
                rest.iter().map(|(operator, operand)| (*operator, inside(operand))).collect(),
            ),
            ExprKind::Call(function, arguments) => {
                ExprKind::Call(function.clone(), arguments.iter().map(inside).collect())
            }
            kind => kind.clone(),
        };
        Self { kind, span: self.span }
    }

    pub(crate) fn negated(self) -> Self {
        Self { span: self.span, kind: ExprKind::Negate(Box::new(self)) }
    }

    pub(crate) fn is_mistake(&self) -> bool {
        matches!(self.kind, ExprKind::Mistake)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
}
