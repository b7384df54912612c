//! The names of a drawing: its pins, links, guides and drives, and the machine that they are.

use proc_macro2::{Ident, Span};

use crate::chain::machine::{Driven, Driving, GROUND, Machine, Slide};
use crate::chain::plane::Complex;
use crate::chain::redrawn::Displacement;
use crate::syntax::tree::{Declaration, DriveStatement, Expr, ExprKind, PointPlace, StatementKind};

use crate::model::drawn::outline::frames::{DrawnFrame, DrawnLine};
use crate::model::figures::Figure;
use crate::model::mechanism::Dimension;
use crate::model::names::listed;

/// A point of the ground, a pin, or a point that is declared on a link.
pub struct PinPlace<'t> {
    pub name: Ident,
    pub at: [Figure; 2],
    /// Where it is declared on a link: the place, which the link's frame gives.
    pub on: Option<(usize, &'t PointPlace)>,
    /// Constant distances by which it is declared, and what they are between, where they do not meet.
    pub apart: Option<[f64; 3]>,
}

/// A link of the drawing.
pub struct LinkOutline<'t> {
    pub name: &'t Ident,
    /// Through which it goes, in the order of its statement.
    pub pins: Vec<usize>,
    /// Those that are declared on it.
    pub points: Vec<usize>,
    /// Its guides.
    pub on: Vec<usize>,
    /// The length that is declared, and its value where that is known.
    pub length: Option<(&'t Expr, Option<Figure>)>,
    /// Its statement.
    pub statement: usize,
    /// True if a group that is declared makes it.
    pub is_given: bool,
}

impl<'t> LinkOutline<'t> {
    /// The length that is declared, as it is written.
    pub(in crate::model::drawn) fn declared_length(&self) -> Option<Figure> {
        let (length, _) = self.length.as_ref()?;
        Some(Figure::written((*length).clone(), Some(Dimension::LENGTH)))
    }

    /// A link that a statement of a group makes.
    pub(in crate::model::drawn) fn given(
        name: &'t Ident,
        pins: Vec<usize>,
        statement: usize,
    ) -> Self {
        let (points, on) = (Vec::new(), Vec::new());
        Self { name, pins, points, on, length: None, statement, is_given: true }
    }
}

/// A guide of the drawing.
pub struct GuideLine<'t> {
    pub name: &'t Ident,
    /// The body that it is on.
    pub on: usize,
    /// The angle that it is given by.
    pub along: Option<&'t Expr>,
    /// The pin that it is said to run through.
    pub through: Option<usize>,
    pub line: DrawnLine,
}

/// All of a drawing by its names.
pub struct Bodies<'t> {
    pub(in crate::model::drawn) tree: &'t Declaration,
    pub(in crate::model::drawn) pins: Vec<PinPlace<'t>>,
    /// Body `i + 1` is link `i`.
    pub(in crate::model::drawn) links: Vec<LinkOutline<'t>>,
    pub(in crate::model::drawn) guides: Vec<GuideLine<'t>>,
    pub(in crate::model::drawn) drives: Vec<(usize, &'t DriveStatement)>,
    /// The frames that links are written in.
    pub(in crate::model::drawn) frames: Vec<DrawnFrame>,
    pub(in crate::model::drawn) machine: Machine,
    /// The motions of the bodies from the drawing to the pose in which lengths are as declared.
    pub(in crate::model::drawn) displacements: Vec<Displacement>,
    /// Links that two pins hold to the ground, each behind those on which its pins are.
    pub(in crate::model::drawn) fixed: Vec<usize>,
    /// The values of the drives in that pose, with whole turns.
    pub(in crate::model::drawn) driven: Vec<f64>,
}

impl<'t> Bodies<'t> {
    /// The name of a body, as messages quote it.
    pub(in crate::model::drawn) fn name(&self, body: usize) -> String {
        match body {
            GROUND => "the ground".to_string(),
            _ => format!("`{}`", self.links[body - 1].name),
        }
    }

    /// True of the ground and of links that are written; others stand for quantities.
    pub(in crate::model::drawn) fn is_written(&self, body: usize) -> bool {
        body == GROUND || !self.tree.unwritten.names.contains(self.link(body).name)
    }

    /// True of links that are written as such.
    pub(in crate::model::drawn) fn is_drawn(&self, body: usize) -> bool {
        let is_point = |kind: &StatementKind| matches!(kind, StatementKind::Point(_));
        let statement = |body| &self.tree.statements[self.link(body).statement].kind;
        body != GROUND && self.is_written(body) && !is_point(statement(body))
    }

    /// The names of bodies in words, the ground last.
    pub(in crate::model::drawn) fn listed(&self, those: &[usize]) -> String {
        let written: Vec<_> = those.iter().copied().filter(|&body| self.is_written(body)).collect();
        let those = if written.is_empty() { those } else { &written };
        let (ground, links): (Vec<usize>, Vec<_>) = those.iter().partition(|&&body| body == GROUND);
        let names: Vec<_> = links.into_iter().chain(ground).map(|body| self.name(body)).collect();
        listed(&names, "and")
    }

    /// The last link of those, where a message stands.
    pub(in crate::model::drawn) fn last_link(&self, those: &[usize]) -> Option<&Ident> {
        those.iter().rev().find(|&&body| body != GROUND).map(|&body| self.link(body).name)
    }

    pub(in crate::model::drawn) fn link(&self, body: usize) -> &LinkOutline<'t> {
        &self.links[body - 1]
    }

    /// The angle of a link's frame in the pose with the declared lengths.
    pub(in crate::model::drawn) fn drawn_angle(&self, body: usize) -> f64 {
        let [x, y] = &self.frames[body].axis;
        let turn = self.displacements.get(body).map_or(0.0, |displacement| displacement.turn);
        Complex::new(x.value, y.value).angle() + turn
    }

    /// The origin of its frame there.
    pub(in crate::model::drawn) fn drawn_origin(&self, body: usize) -> Complex {
        let [x, y] = &self.frames[body].origin;
        let drawn = Complex::new(x.value, y.value);
        self.displacements.get(body).map_or(drawn, |displacement| displacement.of(drawn))
    }

    /// What a drive is in the drawing.
    pub(in crate::model::drawn) fn drawn_value(&self, drive: usize) -> f64 {
        let Driving { kind, bodies: [body, to], .. } = &self.machine.drives[drive];
        match kind {
            Driven::Angle => {
                Complex::turned(self.drawn_angle(*body) - self.drawn_angle(*to)).angle()
            }
            Driven::Slide(slide) => {
                let Slide { through, along, .. } = self.machine.slides[*slide];
                along.dot(self.drawn_origin(*body) - through)
            }
        }
    }

    /// The expression with the angles and slides of links as they are drawn, angles turned on by these angles.
    pub(in crate::model::drawn) fn as_drawn(&self, expr: &Expr, turns: &[f64]) -> Expr {
        expr.replaced(&|part| match &part.kind {
            ExprKind::Member(link, member) if member == "angle" => {
                let body = self.body(link)?;
                let turn = turns.get(body).copied().unwrap_or(0.0);
                Some(float(self.drawn_angle(body) + turn, "rad"))
            }
            ExprKind::Member(link, member) if member == "slide" => {
                let body = self.body(link)?;
                let slide = self.machine.slides.iter().find(|slide| slide.body == body)?;
                let from = self.drawn_origin(body) - slide.through;
                Some(float(slide.along.dot(from), "m"))
            }
            _ => None,
        })
    }

    /// A pin by its name.
    pub(in crate::model::drawn) fn pin(&self, name: &Ident) -> Option<usize> {
        self.pins.iter().position(|pin| pin.name == *name)
    }

    /// The body that a link's name stands for.
    pub(in crate::model::drawn) fn body(&self, name: &Ident) -> Option<usize> {
        self.links.iter().position(|link| link.name == name).map(|index| index + 1)
    }
}

/// A float with its unit.
fn float(value: f64, unit: &str) -> Expr {
    let (digits, span) = (format!("{:?}", value.abs()), Span::call_site().into());
    let kind = ExprKind::Number { digits, units: vec![(unit.to_string(), 1)] };
    let number = Expr { kind, span };
    if value < 0.0 { number.negated() } else { number }
}
