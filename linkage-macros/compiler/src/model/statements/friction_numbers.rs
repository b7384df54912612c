//! The numbers of a statement about friction: the coefficient, the radius of a pin, the length of a block.

use crate::syntax::tree::{Expr, FrictionStatement};

use crate::exact::Exact;
use crate::model::acting::Magnitude;
use crate::model::folding::shown;
use crate::model::loads_in_forces;
use crate::model::mechanism::{Dimension, Length, Scalar};
use crate::model::scope::Scope;
use crate::model::statements::{acts, mass};

/// No pair of bodies rubs by more: rubber on rubber comes to about 4.
const MOST: i64 = 5;

/// The coefficient, which is no percentage.
pub(super) fn coefficient(scope: &mut Scope<'_>, written: &Expr, name: &str) -> Option<Magnitude> {
    let what = "a coefficient of friction";
    let value = acts::acting(scope, written, Dimension::NUMBER)?;
    loads_in_forces::is_free_of_pull(scope, written, &value)?;
    if let Scalar::Constant(constant) = &value
        && constant.cmp_value(&Exact::integer(MOST)).is_gt()
    {
        let part = constant.div(&Exact::integer(100)).expect("100 is not zero");
        let message = format!("{what} of {}", shown(constant));
        let reason = format!(
            "nothing rubs by more than about 4: if per cent are meant, write `{}`",
            shown(&part)
        );
        scope.diagnostics.error_because(written.span, message, reason);
        return None;
    }
    mass::not_below_zero(scope, value, written.span, what, name.to_string())
}

pub(super) fn radius<'t>(
    scope: &mut Scope<'_>,
    written: &'t FrictionStatement,
) -> Option<&'t Expr> {
    if written.radius.is_none() {
        let message = "a pin's friction needs its radius: `… radius 8mm`";
        let reason = "the couple is coefficient × radius × load; of what slides, write `friction 0.1 on \
                      ram`";
        scope.diagnostics.error_because(written.at, message, reason);
    }
    written.radius.as_ref()
}

pub(super) fn has_no(scope: &mut Scope<'_>, part: &Option<Expr>, message: &str) -> Option<()> {
    let Some(part) = part else { return Some(()) };
    let reason = "`length` is that of a block that touches its guide at both ends";
    scope.diagnostics.error_because(part.span, message, reason);
    None
}

/// A number of the machine that is divided by.
pub(super) fn above_zero(
    scope: &mut Scope<'_>,
    expr: &Expr,
    measure: Dimension,
    what: &str,
) -> Option<Length> {
    let name = format!("friction, {what}");
    let Magnitude { value, name } = mass::not_negative(scope, expr, measure, what, name)?;
    if let Scalar::Constant(constant) = &value
        && constant.is_zero()
    {
        let message = format!("{what} of {}; make it greater than zero", shown(constant));
        scope.diagnostics.error(expr.span, message);
        return None;
    }
    Some(Length { value, name })
}
