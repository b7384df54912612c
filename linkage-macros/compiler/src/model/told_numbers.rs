//! Numbers of a drawing where groups are made of them: the expressions in them are resolved.

use proc_macro2::Span;

use crate::model::dimension::Measure;
use crate::model::expr::{AngleSum, Operator, Scalar};
use crate::model::figures::{Figure, WrittenPart};
use crate::model::resolved_expr::ResolvedExpr;
use crate::model::scope::Scope;
use crate::model::{expressions, fits, literals};

impl Figure {
    /// A number without link angles.
    pub(super) fn number(&self, scope: &mut Scope<'_>) -> Option<Scalar> {
        self.plain(scope, &self.number)
    }

    /// A length that messages find at this place.
    pub(super) fn length(&self, scope: &mut Scope<'_>, at: Span) -> Option<Scalar> {
        let length = self.number(scope)?;
        if scope.facts.longest_with_unit.is_none() {
            let bare = ResolvedExpr::plain(Measure::Bare, length.clone());
            literals::bare_length_is_as_others(scope, at.into(), &bare)?;
        }
        Some(length)
    }

    /// An angle, link angles included.
    pub(super) fn turn(&self, scope: &mut Scope<'_>) -> Option<AngleSum> {
        self.sum(scope, &self.number).map(ResolvedExpr::turn)
    }

    fn plain(&self, scope: &mut Scope<'_>, number: &Scalar) -> Option<Scalar> {
        number.with_leaves(&mut |leaf| {
            let Scalar::Let(id) = leaf else { return None };
            let leaf = &self.leaves[id.index()];
            let quantity = leaf.resolved(scope)?;
            fits::no_link_angle(scope, &leaf.written, &quantity)?;
            Some(quantity.rest)
        })
    }

    /// The sum of link angles and a number.
    fn sum(&self, scope: &mut Scope<'_>, number: &Scalar) -> Option<ResolvedExpr> {
        let is_sum =
            |(operator, _): &(Operator, _)| [Operator::Add, Operator::Sub].contains(operator);
        match number {
            Scalar::Let(id) => self.leaves[id.index()].resolved(scope),
            Scalar::Negate(inner) => {
                let mut sum = self.sum(scope, inner)?;
                sum.scale_links(-1)?;
                Some(ResolvedExpr { rest: sum.rest.negated(), ..sum })
            }
            Scalar::Chain(first, rest) if rest.iter().all(is_sum) => {
                let first = self.sum(scope, first)?;
                rest.iter().try_fold(first, |mut sum, (operator, operand)| {
                    let operand = self.sum(scope, operand)?;
                    let sign = if *operator == Operator::Add { 1 } else { -1 };
                    sum.add_links(&operand.links, sign)?;
                    Some(ResolvedExpr { rest: sum.rest.combined(*operator, operand.rest)?, ..sum })
                })
            }
            _ => Some(ResolvedExpr::plain(Measure::NUMBER, self.plain(scope, number)?)),
        }
    }
}

impl WrittenPart {
    fn resolved(&self, scope: &mut Scope<'_>) -> Option<ResolvedExpr> {
        let quantity = expressions::quantity(scope, &self.written)?;
        if let Some(wanted) = self.wanted {
            fits::dimension_fits(scope, &self.written, &quantity, wanted)?;
        }
        Some(quantity)
    }
}

/// Two lengths that messages find at this place.
pub(super) fn lengths(
    scope: &mut Scope<'_>,
    [first, second]: &[Figure; 2],
    at: Span,
) -> Option<[Scalar; 2]> {
    let (first, second) = (first.length(scope, at), second.length(scope, at));
    Some([first?, second?])
}
