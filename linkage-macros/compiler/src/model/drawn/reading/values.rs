//! Values of the numbers of a drawing: the numbers of a declaration are resolved with its pins
//! as points that stand still, so that the rules and the messages of the ground's points are theirs.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::diagnostics::{Diagnostics, Extent};
use crate::exact::Exact;
use crate::function::Function;
use crate::syntax::tree::{
    Declaration, Expr, ExprKind, GroundStatement, LetStatement, ParamStatement, PinStatement,
    StatementKind,
};

use crate::model::expr::Scalar as Resolved;
use crate::model::figures::Figure;
use crate::model::items::{Item, items};
use crate::model::mechanism::{Dimension, InputId, Mechanism, ParamKind};
use crate::model::names::Entity;
use crate::model::statements::ground::ground;
use crate::model::statements::param::report_no_constant;
use crate::model::{Scope, begun, expressions, fits, numbers, order};

/// The length from which on products of four lengths may end beyond what `f64` holds.
const FARTHEST: f64 = 1e60;

/// The values of the numbers of a drawing.
pub struct Measured<'d> {
    pub scope: Scope<'d>,
    /// By name, where the points of the ground and the pins are.
    pub places: HashMap<String, [Figure; 2]>,
}

/// Resolves the numbers of a drawing, its pins as points that stand still. The mistakes of a named expression that reads
/// pins or links are reported where these move: a pin that stands still has no rate, and a number of its place may be
/// out of a function's range. Those that a place is made of are reported here.
fn numbers_of_a_drawing(scope: &mut Scope<'_>, items: &[Item<'_>]) {
    let places = names_in_places(items);
    for (index, item) in items.iter().enumerate() {
        scope.names.go_to(index);
        let (mistakes, early) = (scope.diagnostics.count(), scope.names.too_early.len());
        match item.written {
            Some(StatementKind::Pin(PinStatement { points })) => {
                scope.names.pins.extend(points.iter().map(|(name, _)| name.to_string()));
                ground(scope, &[], points);
            }
            Some(StatementKind::Input(_) | StatementKind::Ground(_)) => {
                item.rules.resolve(scope, &[]);
            }
            Some(StatementKind::Param(ParamStatement { name, default, .. })) => {
                item.rules.resolve(scope, &[]);
                // A link is not made here, and nothing was said of it.
                let moves = fits::moving_part(scope, default).is_some();
                if moves && scope.names.made(name).is_none() && scope.diagnostics.count() == 0 {
                    report_no_constant(scope, name, default);
                }
            }
            Some(StatementKind::Let(LetStatement { name, .. })) => {
                item.rules.resolve(scope, &[]);
                let moves = |used: &Ident| {
                    let symbol = scope.names.symbol(used);
                    scope.names.is_of_pins(used)
                        || symbol.is_some_and(|symbol| !is_number(&items[symbol.statement]))
                };
                let moves = item.rules.names_used().iter().any(moves);
                if moves {
                    scope.names.pins.insert(name.to_string());
                }
                if !places.contains(name) {
                    scope.names.too_early.truncate(early);
                    if moves {
                        scope.diagnostics.forget_since(mistakes);
                    }
                }
            }
            _ => {}
        }
    }
    scope.names.go_to(items.len());
    // Links are not made here: what reads them has no value.
    scope.names.too_early.retain(|use_| is_number(&items[use_.maker]));
}

fn is_number(item: &Item<'_>) -> bool {
    use StatementKind::{Ground, Input, Let, Param, Pin};
    matches!(item.written, Some(Ground(_) | Input(_) | Let(_) | Param(_) | Pin(_)))
}

/// The names that stand in the places of pins and of points of the ground, themselves or in named expressions.
fn names_in_places(items: &[Item<'_>]) -> HashSet<Ident> {
    let mut names = HashSet::new();
    for item in items.iter().rev() {
        let is_in_a_place = match item.written {
            Some(StatementKind::Ground(_) | StatementKind::Pin(_)) => true,
            Some(StatementKind::Let(LetStatement { name, .. })) => names.contains(name),
            _ => false,
        };
        names.extend(item.rules.names_used().into_iter().filter(|_| is_in_a_place));
    }
    names
}

/// The points of the ground and the pins of a drawing, with their coordinates.
pub(super) fn drawn_points(tree: &Declaration) -> impl Iterator<Item = &(Ident, [Expr; 2])> {
    tree.statements.iter().flat_map(|statement| match &statement.kind {
        StatementKind::Ground(GroundStatement { points })
        | StatementKind::Pin(PinStatement { points }) => &points[..],
        _ => &[],
    })
}

impl<'d> Measured<'d> {
    /// The numbers of a drawing; `None` where one of them is in error, which was reported.
    pub fn of(tree: &'d Declaration, diagnostics: &'d mut Diagnostics) -> Option<Self> {
        let before = diagnostics.count();
        let items = items(tree);
        let mut scope = begun::scope(tree, &items, &tree.unread, diagnostics);
        numbers_of_a_drawing(&mut scope, &items);
        order::items_are_in_order(&mut scope, &items);
        if scope.diagnostics.count() != before {
            return None;
        }
        let mut values = Self { scope, places: HashMap::new() };
        for (name, at) in drawn_points(tree) {
            let Some(place) = values.place(name) else {
                let reason = "a pin is drawn where numbers say, and links move after that";
                values.report_unplaced(name, (&at.each_ref(), &[]), reason);
                return None;
            };
            values.places.insert(name.to_string(), place);
        }
        Some(values)
    }

    /// Where a point that was resolved is.
    fn place(&self, name: &Ident) -> Option<[Figure; 2]> {
        let Some(Entity::Point(id)) = self.scope.names.entity(name) else { return None };
        let [x, y] = self.mechanism().ground_place(id)?;
        Some([self.figure(x)?, self.figure(y)?])
    }

    pub(in crate::model::drawn) fn mechanism(&self) -> &Mechanism {
        &self.scope.mechanism
    }

    /// A resolved number of the drawing.
    fn figure(&self, resolved: &Resolved) -> Option<Figure> {
        let mechanism = self.mechanism();
        let value = value(resolved, mechanism, &[]).filter(|value| value.abs() < FARTHEST)?;
        Figure::of(resolved, value, &|part| {
            let name = match part {
                Resolved::Input(id) => Some(mechanism.inputs[id.index()].name.clone()),
                Resolved::Param(id) => Some(mechanism.params[id.index()].name.clone()),
                Resolved::Let(id) => self.scope.names.name_of(Entity::Let(*id)),
                _ => None,
            };
            match name.filter(|name| !self.scope.names.is_of_pins(name)) {
                Some(name) => Some(Figure::named(&name)),
                // Pins stand still here, and move where names are resolved.
                None => self.figure(&meaning(part, mechanism)?),
            }
        })
    }

    /// The length that an expression of constants and parameters is; `None` where it is in error,
    /// which is reported where the groups are resolved.
    pub(in crate::model::drawn) fn length(&mut self, expr: &Expr) -> Option<Figure> {
        let resolved = self.quietly(|scope| numbers::length(scope, expr))?;
        self.figure(&resolved)
    }

    /// The same for an angle.
    pub(in crate::model::drawn) fn angle(&mut self, expr: &Expr) -> Option<Figure> {
        let resolved = self.quietly(|scope| numbers::plain_angle(scope, expr))?;
        self.figure(&resolved)
    }

    /// The length of a link; `None` where an input changes it, or it is in error. Where it is no number, that is reported.
    pub(in crate::model::drawn) fn declared_length(&mut self, expr: &Expr) -> Option<Figure> {
        let resolved = self.quietly(|scope| numbers::length(scope, expr))?;
        let length = self.figure(&resolved);
        if length.is_none() && fits::moving_part(&self.scope, expr).is_none() {
            self.report_no_number(expr, &resolved);
        }
        length
    }

    /// The value of an expression at these inputs.
    pub(in crate::model::drawn) fn at_inputs(
        &mut self,
        expr: &Expr,
        inputs: &[f64],
    ) -> Option<f64> {
        value(&self.by_inputs(expr)?, self.mechanism(), inputs)
    }

    /// The number that an expression is, whatever the inputs are.
    pub(in crate::model::drawn) fn by_inputs(&mut self, expr: &Expr) -> Option<Resolved> {
        let resolved = self.quietly(|scope| expressions::quantity(scope, expr))?;
        resolved.links.is_empty().then_some(resolved.rest)
    }

    /// Reports why something has no place in the drawing: mistakes in its lengths and angles, or those of them that are
    /// no numbers there; else, at its name, this reason.
    pub(in crate::model::drawn) fn report_unplaced(
        &mut self,
        name: &Ident,
        (lengths, angles): (&[&Expr], &[&Expr]),
        reason: &str,
    ) {
        let mut at = Extent::from(name.span());
        let lengths = lengths.iter().map(|expr| (*expr, Dimension::LENGTH));
        for (expr, of) in lengths.chain(angles.iter().map(|expr| (*expr, Dimension::ANGLE))) {
            match numbers::scalar(&mut self.scope, expr, of) {
                Some(resolved) if self.figure(&resolved).is_none() => {
                    match fits::moving_part(&self.scope, expr) {
                        Some(moving) => at = moving,
                        None => self.report_no_number(expr, &resolved),
                    }
                }
                Some(_) => {}
                None => {
                    let is_unknown = |scope: &Scope<'_>, part: &Expr| match &part.kind {
                        ExprKind::Name(name) | ExprKind::Member(name, _) => {
                            scope.names.entity(name).is_none()
                        }
                        _ => false,
                    };
                    at = fits::first(&self.scope, expr, &is_unknown).unwrap_or(expr.span);
                }
            }
        }
        // Tokens that were not read may hold the reason.
        if self.scope.diagnostics.count() == 0 {
            let message = format!("`{name}` has no place in the drawing");
            self.scope.diagnostics.error_because(at, message, reason);
        }
    }

    /// Reports an expression of constants and parameters that is no number for a drawing.
    fn report_no_number(&mut self, expr: &Expr, resolved: &Resolved) {
        let (message, reason) = match value(resolved, self.mechanism(), &[]) {
            Some(_) => (
                "a number too large for a drawing; change its exponent",
                "a drawing multiplies lengths with each other, and `f64` ends at 1e308",
            ),
            None => (
                "this is no number where every parameter is its default; change one of these",
                "a machine is drawn with the defaults of its parameters",
            ),
        };
        self.scope.diagnostics.error_because(expr.span, message, reason);
    }

    /// What the rules make of something, whose mistakes are reported later.
    fn quietly<T>(&mut self, f: impl FnOnce(&mut Scope<'_>) -> Option<T>) -> Option<T> {
        let before = self.scope.diagnostics.count();
        let found = f(&mut self.scope);
        self.scope.diagnostics.forget_since(before);
        found
    }
}

/// The value of a number at the defaults of the parameters.
pub fn value(expr: &Resolved, mechanism: &Mechanism, inputs: &[f64]) -> Option<f64> {
    let value = folded(expr, mechanism, inputs)?.constant()?.to_f64();
    value.is_finite().then_some(value)
}

/// The number as the constant that it is at the defaults of the parameters.
fn folded(expr: &Resolved, mechanism: &Mechanism, inputs: &[f64]) -> Option<Resolved> {
    expr.with_leaves(&mut |leaf| match leaf {
        Resolved::Input(InputId(id)) => {
            Some(Resolved::Constant(Exact::float(*inputs.get(*id as usize)?)?))
        }
        Resolved::Param(id) => match &mechanism.params[id.index()].kind {
            ParamKind::Number { default, .. } => Some(Resolved::Constant(default.clone())),
            ParamKind::Mode { .. } => None,
        },
        _ => folded(&meaning(leaf, mechanism)?, mechanism, inputs),
    })
}

/// The number that a named expression is, or a distance of points that stand still.
fn meaning(leaf: &Resolved, mechanism: &Mechanism) -> Option<Resolved> {
    match leaf {
        Resolved::Let(id) => Some(mechanism.lets[id.index()].rest.clone()),
        Resolved::Distance([from, to]) => {
            let (from, to) = (mechanism.ground_place(*from)?, mechanism.ground_place(*to)?);
            let parts = [0, 1].map(|i| to[i].clone().minus(from[i].clone()));
            Resolved::call(Function::Hypot, parts.into())
        }
        _ => None,
    }
}
