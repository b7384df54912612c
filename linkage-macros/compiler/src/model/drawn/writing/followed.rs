//! The value that an unknown is measured from, where its interval follows the drive: a fit as `let`
//! statements.

use proc_macro2::{Ident, Span};

use crate::chain::fit::{DeadEnds, Following, NearDead, Terms};
use crate::syntax::tree::{BinaryOp, Expr, ExprKind, LetStatement, StatementKind};

use crate::model::drawn::outline::figures::{Figure, Pen, root_of, sum};
use crate::model::drawn::writing::free_names::FreeNames;

/// The names of an unknown's fit.
pub(in crate::model::drawn) struct TracedNames {
    /// The argument of its polynomials, and the sine in front of the odd one.
    argument: Ident,
    sine: Ident,
    pub traced: Ident,
}

/// Names that nothing has.
pub(in crate::model::drawn) fn traced_names(names: &mut FreeNames, unknown: &Ident) -> TracedNames {
    let mut free = |ending: &str| names.made(format!("{unknown}_{ending}"), "_", unknown.span());
    TracedNames { argument: free("u"), sine: free("s"), traced: free("traced") }
}

/// The values in the drawing.
pub(in crate::model::drawn) struct DrawnValues {
    pub drive: f64,
    pub unknown: f64,
}

/// The fit of an unknown over the first drive.
pub(in crate::model::drawn) struct Fitted<'f> {
    pub pen: &'f Pen,
    pub following: &'f Following,
    /// The value of the drive.
    pub drive: Expr,
    pub drawn: DrawnValues,
    /// True if the unknown is an angle.
    pub is_angle: bool,
}

impl Fitted<'_> {
    /// The statements of the fit, the value itself last.
    pub(in crate::model::drawn) fn statements(&self, names: &TracedNames) -> Vec<StatementKind> {
        let Self { pen, following, drive, drawn, is_angle } = self;
        let [from, drawn] = [drawn.drive, drawn.unknown];
        let writing = Writing(names.traced.span());
        let value = || drive.clone();
        let middle = from + following.middle;
        let unit = pen.float(1.0, if *is_angle { "rad" } else { "m" });
        let mut lets = Vec::new();
        let traced = match &following.terms {
            Terms::Turning { center, reach, even, odd, turns } => {
                let (sin, cos) = middle.sin_cos();
                let angle = Figure::plain(value(), f64::NAN, None);
                let pen = pen.at(writing.0);
                let [across, along] = [pen.sin(&angle), pen.cos(&angle)].map(|part| part.text);
                let shifted = |[a, b]: [f64; 2]| {
                    let along = writing.times(along.clone(), a);
                    sum(along, writing.times(across.clone(), b))
                };
                let argument = shifted([cos / reach, sin / reach]);
                let argument = sum(argument, writing.number(-center / reach));
                lets.push((&names.argument, argument));
                lets.push((&names.sine, shifted([-sin, cos])));
                let mut even = even.clone();
                even[0] += drawn;
                let odd = writing.polynomial(odd, &names.argument);
                let odd = writing.product(writing.name(&names.sine), odd);
                let fit = sum(writing.polynomial(&even, &names.argument), odd);
                let falling = sum(writing.number(1.0), writing.name(&names.argument));
                let fit = writing.with_ends(fit, following.ends, falling, &names.sine);
                let bends = following.near.iter().map(|near| writing.bend(near, middle, shifted));
                let fit = bends.fold(fit, sum);
                let fit = writing.product(unit, fit);
                match *turns {
                    0 => fit,
                    turns => {
                        let from_middle = sum(value(), pen.float(-middle, "rad"));
                        sum(fit, writing.times(from_middle, f64::from(turns)))
                    }
                }
            }
            Terms::Sliding { reach, powers } => {
                let from_middle = sum(value(), pen.float(-middle, "m"));
                let reach = pen.float(*reach, "m");
                let argument = writing.chain(from_middle, BinaryOp::Div, reach);
                lets.push((&names.argument, argument));
                let fit = writing.along_a_slide(&names.argument, (powers, drawn), following.ends);
                writing.product(unit, fit)
            }
        };
        lets.push((&names.traced, traced));
        let named = |(name, value): (&Ident, Expr)| LetStatement { name: name.clone(), value };
        lets.into_iter().map(named).map(StatementKind::Let).collect()
    }
}

/// A square beyond a dead point, so small that its root is a hundredth of the least room of a search.
const NEXT_TO_ZERO: f64 = 1e-10;

/// Writes expressions at a place that messages about them point to.
struct Writing(Span);

impl Writing {
    fn expr(&self, kind: ExprKind) -> Expr {
        Expr { kind, span: self.0.into() }
    }

    fn name(&self, name: &Ident) -> Expr {
        self.expr(ExprKind::Name(name.clone()))
    }

    /// A plain number to ten digits behind the point: what it decides is where a search looks, to a
    /// thousandth.
    fn number(&self, value: f64) -> Expr {
        let digits = format!("{:.10}", value.abs());
        let digits = digits.trim_end_matches('0').trim_end_matches('.').to_string();
        let number = self.expr(ExprKind::Number { digits, units: Vec::new() });
        match value < 0.0 {
            true => self.expr(ExprKind::Negate(Box::new(number))),
            false => number,
        }
    }

    fn chain(&self, a: Expr, operator: BinaryOp, b: Expr) -> Expr {
        self.expr(ExprKind::Chain(Box::new(a), vec![(operator, b)]))
    }

    fn product(&self, a: Expr, b: Expr) -> Expr {
        self.chain(a, BinaryOp::Mul, b)
    }

    fn times(&self, a: Expr, factor: f64) -> Expr {
        self.product(a, self.number(factor))
    }

    /// The sum of a fit and the square roots towards dead points.
    fn with_ends(&self, fit: Expr, ends: Option<DeadEnds>, falling: Expr, odd: &Ident) -> Expr {
        let Some(DeadEnds { mean, skew }) = ends else { return fit };
        let factor = sum(self.number(mean), self.times(self.name(odd), skew));
        // Beyond a dead point it is next to zero, (x + |x|)/2: the search then finds no root, where a root of a negative
        // number would be none itself. Next to zero, a root has a slope.
        let size = root_of(self.product(falling.clone(), falling.clone()), self.0);
        let falling = sum(self.times(sum(falling, size), 0.5), self.number(NEXT_TO_ZERO));
        sum(fit, self.product(root_of(falling, self.0), factor))
    }

    /// The fit over a slide.
    fn along_a_slide(
        &self,
        argument: &Ident,
        (powers, drawn): (&[f64], f64),
        ends: Option<DeadEnds>,
    ) -> Expr {
        let mut powers = powers.to_vec();
        powers[0] += drawn;
        let fit = self.polynomial(&powers, argument);
        let square = self.product(self.name(argument), self.name(argument)).negated();
        let falling = sum(self.number(1.0), square);
        self.with_ends(fit, ends, falling, argument)
    }

    /// The bend next to a dead point, where `shifted` is a sum of the cosine and the sine of the drive.
    fn bend(&self, near: &NearDead, middle: f64, shifted: impl Fn([f64; 2]) -> Expr) -> Expr {
        let (sin, cos) = (middle + near.at).sin_cos();
        let square = self.number(2.0 + near.width * near.width);
        let bend = root_of(sum(square, shifted([-2.0 * cos, -2.0 * sin])), self.0);
        let factor = sum(self.number(near.even), shifted([-near.odd * sin, near.odd * cos]));
        self.product(bend, factor)
    }

    /// A polynomial by Horner's rule.
    fn polynomial(&self, powers: &[f64], argument: &Ident) -> Expr {
        let [rest @ .., last] = powers else { return self.number(0.0) };
        rest.iter().rev().fold(self.number(*last), |inner, &power| {
            sum(self.number(power), self.product(self.name(argument), inner))
        })
    }
}
