//! Values of the numbers of a drawing: the numbers of a declaration are resolved with its pins
//! as points that stand still, so that the rules and the messages of the ground's points are theirs.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::exact::Exact;
use crate::syntax::tree::{
    Declaration, Expr, GroundStatement, LetStatement, PinStatement, Statement, StatementKind,
    Unwritten,
};

use crate::model::expr::{Axis, Scalar as Resolved};
use crate::model::figures::Figure;
use crate::model::items::{Item, items};
use crate::model::mechanism::{InputId, Mechanism, ParamKind};
use crate::model::names::{Entity, Names};
use crate::model::references::names_used;
use crate::model::statements::declared_by;
use crate::model::{Scope, begun, expressions, numbers, order};

/// The values of the numbers of a drawing.
pub(in crate::model::drawn) struct Measured<'d> {
    pub scope: Scope<'d>,
    /// By name, where the points of the ground and the pins are.
    pub places: HashMap<String, [Figure; 2]>,
}

/// The statements whose numbers say where a drawing's pins are, its pins as points of the ground.
fn numbers_of(tree: &Declaration) -> Declaration {
    let mut known = HashSet::new();
    let mut statements = Vec::new();
    for statement in &tree.statements {
        let uses_known =
            || names_used(statement).iter().all(|name| known.contains(&name.to_string()));
        let kind = match &statement.kind {
            kind @ (StatementKind::Input(_) | StatementKind::Param(_)) => kind.clone(),
            kind @ StatementKind::Let(_) if uses_known() => kind.clone(),
            StatementKind::Ground(GroundStatement { points })
            | StatementKind::Pin(PinStatement { points }) => {
                StatementKind::Ground(GroundStatement { points: points.clone() })
            }
            _ => continue,
        };
        known.extend(declared_by(statement).iter().map(|(name, _)| name.to_string()));
        statements.push(Statement { docs: Vec::new(), kind });
    }
    Declaration {
        docs: Vec::new(),
        visibility: tree.visibility.clone(),
        name: tree.name.clone(),
        statements,
        unread: crate::syntax::tree::Unread::Words(HashSet::new()),
        is_damaged: false,
        unwritten: Unwritten::default(),
    }
}

/// The mistakes that are not reported.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Forgetting {
    /// Those of named expressions that read pins: a pin that stands still has no rate, and a number of its place may be
    /// out of a function's range. They are resolved once more where pins move.
    OfPins,
    Nothing,
}

fn numbers_of_a_drawing(scope: &mut Scope<'_>, numbers: &[Item<'_>], forgetting: Forgetting) {
    if forgetting == Forgetting::Nothing {
        let pins = std::mem::take(&mut scope.names.pins);
        scope.names = Names { pins, ..begun::names(numbers) };
    }
    let mut reading = scope.names.pins.clone();
    for (index, item) in numbers.iter().enumerate() {
        scope.names.go_to(index);
        let before = scope.diagnostics.count();
        item.rules.resolve(scope, item.docs);
        let Some(StatementKind::Let(LetStatement { name, .. })) = item.written else { continue };
        if item.rules.names_used().iter().any(|used| reading.contains(&used.to_string())) {
            reading.insert(name.to_string());
            if forgetting == Forgetting::OfPins {
                scope.diagnostics.forget_since(before);
            }
        }
    }
    scope.names.go_to(numbers.len());
}

fn pins_of(tree: &Declaration) -> impl Iterator<Item = &Ident> {
    let points = tree.statements.iter().flat_map(|statement| match &statement.kind {
        StatementKind::Pin(PinStatement { points }) => &points[..],
        _ => &[],
    });
    points.map(|(name, _)| name)
}

impl<'d> Measured<'d> {
    /// The numbers of a drawing; `None` where one of them is in error, which was reported.
    pub(in crate::model::drawn) fn of(
        tree: &'d Declaration,
        diagnostics: &'d mut Diagnostics,
    ) -> Option<Self> {
        let before = diagnostics.count();
        let numbers = numbers_of(tree);
        let items = items(&numbers);
        let mut scope = begun::scope(&numbers, &items, &tree.unread, diagnostics);
        scope.names.pins = pins_of(tree).map(ToString::to_string).collect();
        scope.facts.longest_with_unit = begun::longest_with_unit(tree);
        numbers_of_a_drawing(&mut scope, &items, Forgetting::OfPins);
        order::items_are_in_order(&mut scope, &items);
        if scope.diagnostics.count() != before {
            return None;
        }
        let mut values = Self { scope, places: HashMap::new() };
        for statement in &numbers.statements {
            let StatementKind::Ground(GroundStatement { points }) = &statement.kind else {
                continue;
            };
            for (name, _) in points {
                let Some(place) = values.place(name) else {
                    // The reason is among the mistakes that were not reported.
                    numbers_of_a_drawing(&mut values.scope, &items, Forgetting::Nothing);
                    return None;
                };
                values.places.insert(name.to_string(), place);
            }
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

    /// A resolved number of the drawing, the coordinates of pins in it as they are drawn.
    fn figure(&self, resolved: &Resolved) -> Option<Figure> {
        let Mechanism { inputs, params, .. } = self.mechanism();
        Figure::of(resolved, value(resolved, self.mechanism(), &[])?, &|part| {
            let name = match part {
                Resolved::Input(id) => inputs[id.index()].name.clone(),
                Resolved::Param(id) => params[id.index()].name.clone(),
                Resolved::Let(id) => self.scope.names.name_of(Entity::Let(*id))?,
                Resolved::Coordinate(point, axis) => {
                    let name = self.mechanism().points[point.index()].name.to_string();
                    return Some(self.places.get(&name)?[usize::from(*axis == Axis::Y)].clone());
                }
                _ => return None,
            };
            Some(Figure::named(&name))
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

    /// True if lengths or angles are in error by themselves, which is reported.
    pub(in crate::model::drawn) fn are_in_error(
        &mut self,
        lengths: &[&Expr],
        angles: &[&Expr],
    ) -> bool {
        let before = self.scope.diagnostics.count();
        lengths.iter().for_each(|length| drop(numbers::length(&mut self.scope, length)));
        angles.iter().for_each(|angle| drop(numbers::plain_angle(&mut self.scope, angle)));
        self.scope.diagnostics.count() > before
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
pub(crate) fn value(expr: &Resolved, mechanism: &Mechanism, inputs: &[f64]) -> Option<f64> {
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
        Resolved::Let(id) => folded(&mechanism.lets[id.index()].rest, mechanism, inputs),
        Resolved::Coordinate(point, axis) => {
            let at = mechanism.ground_place(*point)?;
            folded(&at[usize::from(*axis == Axis::Y)], mechanism, inputs)
        }
        _ => None,
    })
}
