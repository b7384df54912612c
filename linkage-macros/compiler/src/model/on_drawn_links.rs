//! Masses on links of a drawing whose group has no such bar, or no such point: bars that a search left out, and bars that
//! lie in the frame of their statement.

use proc_macro2::Ident;

use crate::model::acting::{Magnitude, Mass, MassPlace};
use crate::model::drawn_links::BarFound;
use crate::model::figures::Figure;
use crate::model::mechanism::{LinkId, Operator, Scalar};
use crate::model::scope::Scope;
use crate::model::{told_numbers, uses};

/// A link of a drawing as a bar, where its group has no such bar.
pub(in crate::model) fn bar_as_drawn<'d>(scope: &Scope<'d>, link: &Ident) -> Option<&'d BarFound> {
    scope.drawn?.bars.iter().find(|bar| bar.link == *link && bar.middle.is_some())
}

/// The place on a link of a pin that its group makes elsewhere.
pub(in crate::model) fn place_as_drawn<'d>(
    scope: &Scope<'d>,
    link: &Ident,
    pin: &Ident,
) -> Option<&'d [Figure; 2]> {
    let mut pins = scope.drawn?.pins.iter();
    pins.find(|found| found.link == *link && found.pin == *pin).map(|found| &found.at)
}

/// A uniform bar: its mass in the middle, and m l²/12.
pub(in crate::model) fn uniform_as_drawn(
    scope: &mut Scope<'_>,
    name: &Ident,
    mass: Magnitude,
    bar: &BarFound,
) -> Option<Mass> {
    let link: LinkId = uses::link(scope, name)?;
    let at = name.span();
    let (middle, length) =
        (told_numbers::lengths(scope, bar.middle.as_ref()?, at)?, bar.length.length(scope, at)?);
    let twelve = Scalar::Constant(crate::exact::Exact::integer(12));
    let inertia =
        [(Operator::Mul, length.clone()), (Operator::Mul, length), (Operator::Div, twelve)];
    let inertia = inertia
        .into_iter()
        .try_fold(mass.value.clone(), |product, (operator, by)| product.combined(operator, by))?;
    let inertia = Magnitude { value: inertia, name: format!("inertia on {name}") };
    Some(Mass { place: MassPlace::At(link, middle), mass, inertia })
}
