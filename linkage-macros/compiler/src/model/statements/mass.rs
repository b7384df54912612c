//! Masses and inertias: their values and their places. A mass on the ground is refused.

use proc_macro2::{Ident, Span};
use syn::Attribute;

use crate::diagnostics::Extent;
use crate::syntax::tree::{Expr, InertiaStatement, MassSite as Written, MassStatement};

use crate::model::acting::{Magnitude, Mass, MassPlace};
use crate::model::drawn_sliding;
use crate::model::folding::shown;
use crate::model::mechanism::{Body, Carrier, Dimension, LinkId, PointId, Scalar};
use crate::model::names::Kind;
use crate::model::scope::Scope;
use crate::model::statements::{Rules, acts, guides};
use crate::model::{meant, numbers, on_drawn_links, told_numbers, uses};

impl Rules for MassStatement {
    fn builds_on(&self) -> Vec<&Ident> {
        match &self.place {
            Written::Point(point) => vec![&self.on, point],
            _ => vec![&self.on],
        }
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.value);
        if let Written::At(place) = &self.place {
            place.iter().for_each(&mut *f);
        }
        self.inertia.iter().for_each(f);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        let mass = mass(scope, &self.value, &self.on, &self.place, self.inertia.as_ref());
        scope.mechanism.dynamics.masses.extend(mass);
    }
}

impl Rules for InertiaStatement {
    fn builds_on(&self) -> Vec<&Ident> {
        vec![&self.on]
    }

    fn each_expression(&self, f: &mut dyn FnMut(&Expr)) {
        f(&self.value);
    }

    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        let mass = inertia(scope, &self.value, &self.on);
        scope.mechanism.dynamics.masses.extend(mass);
    }
}

/// The inertia of a uniform bar.
const OF_A_BAR: &str = "`uniform` means m l²/12";

fn mass(
    scope: &mut Scope<'_>,
    value: &Expr,
    on: &Ident,
    place: &Written,
    inertia: Option<&Expr>,
) -> Option<Mass> {
    let name = format!("mass on {on}");
    let mass = not_negative(scope, value, Dimension::MASS, "a mass", name);
    let inertia = match inertia {
        Some(inertia) => {
            let name = format!("inertia on {on}");
            let value =
                not_negative(scope, inertia, Dimension::INERTIA, "a moment of inertia", name);
            Some((inertia, value))
        }
        None => None,
    };
    if let Written::Uniform(_) = place
        && let Some(bar) = on_drawn_links::bar_as_drawn(scope, on)
    {
        return match inertia {
            Some((written, _)) => inertia_is_superfluous(scope, written, OF_A_BAR),
            None => on_drawn_links::uniform_as_drawn(scope, on, mass?, bar),
        };
    }
    let place = mass_place(scope, on, place)?;
    let mass = mass?;
    let inertia = match (inertia, &place) {
        (None, _) => Magnitude::zero(),
        (Some((written, _)), MassPlace::Uniform(..)) => {
            return inertia_is_superfluous(scope, written, OF_A_BAR);
        }
        (Some((written, _)), MassPlace::Pin(_)) => {
            let reason = "a mass on a pin is a point; what turns is a link: `mass … on BC at C`";
            return inertia_is_superfluous(scope, written, reason);
        }
        (Some((_, inertia)), _) => inertia?,
    };
    Some(Mass { place, mass, inertia })
}

fn inertia_is_superfluous<T>(scope: &mut Scope<'_>, inertia: &Expr, reason: &str) -> Option<T> {
    scope.diagnostics.error_because(inertia.span, "leave this inertia out", reason);
    None
}

fn inertia(scope: &mut Scope<'_>, value: &Expr, on: &Ident) -> Option<Mass> {
    let name = format!("inertia on {on}");
    let inertia = not_negative(scope, value, Dimension::INERTIA, "a moment of inertia", name);
    let place = MassPlace::At(uses::link(scope, on)?, [Scalar::zero(), Scalar::zero()]);
    Some(Mass { place, mass: Magnitude::zero(), inertia: inertia? })
}

/// A mass, an inertia or a number of a spring, made of constants and parameters; a constant one is
/// not below zero.
pub(in crate::model) fn not_negative(
    scope: &mut Scope<'_>,
    expr: &Expr,
    dimension: Dimension,
    what: &str,
    name: String,
) -> Option<Magnitude> {
    let fixed = acts::changes_with_no_input(scope, expr, what);
    let value = numbers::scalar(scope, expr, dimension)?;
    fixed?;
    not_below_zero(scope, value, expr.span, what, name)
}

/// The number; a constant or a parameter below zero is reported.
pub(in crate::model) fn not_below_zero(
    scope: &mut Scope<'_>,
    value: Scalar,
    span: Extent,
    what: &str,
    name: String,
) -> Option<Magnitude> {
    let constant = scope.constant_or_default(&value, span);
    if let Some((constant, span)) = constant.filter(|(constant, _)| constant.signum().is_lt()) {
        let message = format!("{what} of {}; make it zero or greater", shown(constant));
        scope.diagnostics.error(span, message);
        return None;
    }
    Some(Magnitude { value, name })
}

fn mass_place(scope: &mut Scope<'_>, on: &Ident, place: &Written) -> Option<MassPlace> {
    match place {
        Written::Here => point_mass(scope, on),
        Written::At(place) => {
            let (link, place) = (uses::link(scope, on), numbers::lengths(scope, place));
            let place = scope.mechanism.placed(Carrier::Link(link?), place?);
            Some(MassPlace::At(link?, place))
        }
        Written::Point(point) => {
            let link = uses::link(scope, on);
            let id = uses::point(scope, point);
            let (link, id) = (link?, id?);
            if let Some(place) = on_drawn_links::place_as_drawn(scope, on, point) {
                return Some(MassPlace::At(link, told_numbers::lengths(scope, place, on.span())?));
            }
            point_is_on_link(scope, point, id, link)?;
            Some(MassPlace::Point(link, id))
        }
        Written::Uniform(at) => {
            let link = uses::link(scope, on)?;
            Some(MassPlace::Uniform(link, bar_is_uniform(scope, on, link, *at)?))
        }
    }
}

/// A mass without a place is a point mass on a pin or a driven point, or on a point of a link.
fn point_mass(scope: &mut Scope<'_>, on: &Ident) -> Option<MassPlace> {
    if scope.names.kind(on) == Some(Kind::Link) {
        let link = uses::link(scope, on)?;
        let message = format!("say where on `{on}` the mass is");
        let is_bar = bar_as_written(scope, on, link);
        let point = meant::point_on(scope, link).unwrap_or("G".to_string());
        let uniform = if is_bar { format!("`… on {on} uniform`, ") } else { String::new() };
        let reason = format!("{uniform}`… on {on} at {point}` or `… on {on} at (x, y)`");
        scope.diagnostics.error_because(on.span(), message, reason);
        return None;
    }
    let point = uses::point(scope, on)?;
    match scope.mechanism.owner(point)? {
        Body::Ground => acts::ground_moves_nothing(scope, on, "mass"),
        // A joint between links is a body of its own, as in a dyad.
        Body::Link(_) if drawn_sliding::is_joint_of_a_drawing(scope, on) => {
            Some(MassPlace::Pin(point))
        }
        Body::Link(link) => Some(MassPlace::Point(link, point)),
        Body::Pin(point) => Some(MassPlace::Pin(point)),
    }
}

/// True if mass can be spread evenly over the link.
fn bar_as_written(scope: &Scope<'_>, name: &Ident, link: LinkId) -> bool {
    let facts = &scope.facts.links[link.index()];
    let moves = |length: &Scalar| scope.mechanism.moves(length);
    let is_bar = facts.is_bar && !facts.length.as_ref().is_some_and(moves);
    is_bar || on_drawn_links::bar_as_drawn(scope, name).is_some()
}

/// A place by name is a point of the link.
fn point_is_on_link(
    scope: &mut Scope<'_>,
    name: &Ident,
    point: PointId,
    link: LinkId,
) -> Option<()> {
    let carrier = Carrier::Link(link);
    if scope.facts.belongs_to(point, carrier) {
        return Some(());
    }
    if !scope.facts.links[link.index()].has_its_joints {
        return None;
    }
    guides::no_point_of(scope, name, link);
    None
}

/// Mass is spread evenly over a bar of constant length alone.
fn bar_is_uniform(scope: &mut Scope<'_>, name: &Ident, link: LinkId, at: Span) -> Option<Scalar> {
    let facts = &scope.facts.links[link.index()];
    let (is_bar, length) = (facts.is_bar, facts.length.clone());
    let message = match &length {
        _ if !is_bar => format!("`{name}` is no bar with two joints, and cannot be `uniform`"),
        Some(length) if scope.mechanism.moves(length) => {
            format!("the length of `{name}` changes, and it cannot be `uniform`")
        }
        _ => return length,
    };
    let reason = format!("give its centre: `… on {name} at (x, y) inertia …`");
    scope.diagnostics.error_because(at, message, reason);
    None
}

impl Magnitude {
    pub(in crate::model) fn zero() -> Self {
        Self { value: Scalar::zero(), name: String::new() }
    }
}
