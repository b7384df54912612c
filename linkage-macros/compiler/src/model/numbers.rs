//! Expressions of one kind: a length, an angle, a fixed number.

use proc_macro2::Ident;

use crate::syntax::tree;

use crate::model::mechanism::{Dimension, Scalar};
use crate::model::reads::Allowed;
use crate::model::scope::Scope;
use crate::model::{expressions, fits};

/// A length of either sign.
pub(super) fn length(scope: &mut Scope<'_>, expr: &tree::Expr) -> Option<Scalar> {
    scalar(scope, expr, Dimension::LENGTH)
}

/// Two lengths of either sign.
pub(super) fn lengths(
    scope: &mut Scope<'_>,
    [first, second]: &[tree::Expr; 2],
) -> Option<[Scalar; 2]> {
    let (first, second) = (length(scope, first), length(scope, second));
    Some([first?, second?])
}

/// An angle without link angles.
pub(super) fn plain_angle(scope: &mut Scope<'_>, expr: &tree::Expr) -> Option<Scalar> {
    scalar(scope, expr, Dimension::ANGLE)
}

pub(super) fn scalar(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    wanted: Dimension,
) -> Option<Scalar> {
    scalar_where(scope, expr, wanted, Allowed::IN_DIMENSIONS)
}

pub(super) fn scalar_where(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    wanted: Dimension,
    allowed: Allowed,
) -> Option<Scalar> {
    let quantity = expressions::expression(scope, expr, allowed)?;
    fits::dimension_fits(scope, expr, &quantity, wanted)?;
    fits::no_link_angle(scope, expr, &quantity)?;
    Some(quantity.rest)
}

/// A point of the ground is fixed: its coordinates depend on no input.
pub(super) fn depends_on_no_input(
    scope: &mut Scope<'_>,
    expr: &tree::Expr,
    point: &Ident,
) -> Option<()> {
    let Some(span) = fits::moving_part(scope, expr) else {
        return Some(());
    };
    let (message, reason) = match scope.names.is_of_pins(point) {
        true => (
            format!("`{point}` is drawn in one pose; its place there cannot depend on an input"),
            "the input drives a link, `drive LINK.angle = …;`, and the pins move with it".into(),
        ),
        false => (
            "a ground point is fixed; it cannot depend on an input".into(),
            format!("a point that is driven is declared `point {point} at (x, y);`"),
        ),
    };
    scope.diagnostics.error_because(span, message, reason);
    None
}
