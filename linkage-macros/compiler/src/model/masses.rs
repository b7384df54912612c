//! Masses and inertias: their values and their places. A mass on the ground is refused.

use proc_macro2::{Ident, Span};

use crate::diagnostics::Extent;
use crate::syntax::tree;
use crate::syntax::tree::MassSite as Written;

use super::Resolver;
use super::acting::{Magnitude, Mass, MassPlace};
use super::folding::shown;
use super::mechanism::{Body, Carrier, Dimension, LinkId, ParamKind, PointId, Scalar};
use super::names::Kind;

impl Resolver<'_> {
    pub(super) fn mass(
        &mut self,
        value: &tree::Expr,
        on: &Ident,
        place: &Written,
        inertia: Option<&tree::Expr>,
    ) -> Option<Mass> {
        let name = format!("mass on {on}");
        let mass = self.not_negative(value, Dimension::MASS, "a mass", name);
        let inertia = match inertia {
            Some(inertia) => {
                let name = format!("inertia on {on}");
                let value =
                    self.not_negative(inertia, Dimension::INERTIA, "a moment of inertia", name);
                Some((inertia, value))
            }
            None => None,
        };
        let place = self.mass_place(on, place)?;
        let mass = mass?;
        let inertia = match (inertia, &place) {
            (None, _) => Magnitude::zero(),
            (Some((written, _)), MassPlace::Uniform(..)) => {
                return self.inertia_is_superfluous(written, "`uniform` means m l²/12");
            }
            (Some((written, _)), MassPlace::Pin(_)) => {
                let reason =
                    "a mass on a pin is a point; what turns is a link: `mass … on BC at C`";
                return self.inertia_is_superfluous(written, reason);
            }
            (Some((_, inertia)), _) => inertia?,
        };
        Some(Mass { place, mass, inertia })
    }

    fn inertia_is_superfluous<T>(&mut self, inertia: &tree::Expr, reason: &str) -> Option<T> {
        self.diagnostics.error_because(inertia.span, "leave this inertia out", reason);
        None
    }

    pub(super) fn inertia(&mut self, value: &tree::Expr, on: &Ident) -> Option<Mass> {
        let name = format!("inertia on {on}");
        let inertia = self.not_negative(value, Dimension::INERTIA, "a moment of inertia", name);
        let place = MassPlace::At(self.link(on)?, [Scalar::zero(), Scalar::zero()]);
        Some(Mass { place, mass: Magnitude::zero(), inertia: inertia? })
    }

    /// A mass, an inertia or a number of a spring, made of constants and parameters; a constant one is
    /// not below zero.
    pub(super) fn not_negative(
        &mut self,
        expr: &tree::Expr,
        dimension: Dimension,
        what: &str,
        name: String,
    ) -> Option<Magnitude> {
        let fixed = self.changes_with_no_input(expr, what);
        let value = self.scalar(expr, dimension)?;
        fixed?;
        self.not_below_zero(value, expr.span, what, name)
    }

    /// The number; a constant or a parameter below zero is reported.
    pub(super) fn not_below_zero(
        &mut self,
        value: Scalar,
        span: Extent,
        what: &str,
        name: String,
    ) -> Option<Magnitude> {
        let (constant, span) = match &value {
            Scalar::Constant(constant) => (constant, span),
            Scalar::Param(id) => match &self.mechanism.params[id.index()].kind {
                ParamKind::Number { default, .. } => (default, self.facts.params[id.index()].span),
                _ => return None,
            },
            _ => return Some(Magnitude { value, name }),
        };
        if constant.signum().is_lt() {
            let message = format!("{what} of {}; make it zero or greater", shown(constant));
            self.diagnostics.error(span, message);
            return None;
        }
        Some(Magnitude { value, name })
    }

    fn mass_place(&mut self, on: &Ident, place: &Written) -> Option<MassPlace> {
        match place {
            Written::Here => self.point_mass(on),
            Written::At(place) => {
                let (link, place) = (self.link(on), self.lengths(place));
                Some(MassPlace::At(link?, place?))
            }
            Written::Point(point) => {
                let link = self.link(on);
                let id = self.point(point);
                let (link, id) = (link?, id?);
                self.point_is_on_link(point, id, link)?;
                Some(MassPlace::Point(link, id))
            }
            Written::Uniform(at) => {
                let link = self.link(on)?;
                Some(MassPlace::Uniform(link, self.bar_is_uniform(on, link, *at)?))
            }
        }
    }

    /// A mass without a place is a point mass on a pin or a driven point, or on a point of a link.
    fn point_mass(&mut self, on: &Ident) -> Option<MassPlace> {
        if self.names.kind(on) == Some(Kind::Link) {
            self.link(on)?;
            let message = format!("say where on `{on}` the mass is");
            let reason = format!("`… on {on} at (x, y)`, `… on {on} at G` or `… on {on} uniform`");
            self.diagnostics.error_because(on.span(), message, reason);
            return None;
        }
        let point = self.point(on)?;
        match self.mechanism.owner(point)? {
            Body::Ground => self.ground_moves_nothing(on, "mass"),
            Body::Link(link) => Some(MassPlace::Point(link, point)),
            Body::Pin(point) => Some(MassPlace::Pin(point)),
        }
    }

    /// A place by name is a point of the link.
    fn point_is_on_link(&mut self, name: &Ident, point: PointId, link: LinkId) -> Option<()> {
        let carrier = Carrier::Link(link);
        if self.facts.belongs_to(point, carrier) {
            return Some(());
        }
        if !self.facts.links[link.index()].has_its_joints {
            return None;
        }
        self.no_point_of(name, link);
        None
    }

    /// Mass is spread evenly over a bar of constant length alone.
    fn bar_is_uniform(&mut self, name: &Ident, link: LinkId, at: Span) -> Option<Scalar> {
        let facts = &self.facts.links[link.index()];
        let (is_bar, length) = (facts.is_bar, facts.length.clone());
        let message = match &length {
            _ if !is_bar => format!("`{name}` is no bar with two joints, and cannot be `uniform`"),
            Some(length) if self.mechanism.moves(length) => {
                format!("the length of `{name}` changes, and it cannot be `uniform`")
            }
            _ => return length,
        };
        let reason = format!("give its centre: `… on {name} at (x, y) inertia …`");
        self.diagnostics.error_because(at, message, reason);
        None
    }
}

impl Magnitude {
    pub(super) fn zero() -> Self {
        Self { value: Scalar::zero(), name: String::new() }
    }
}
