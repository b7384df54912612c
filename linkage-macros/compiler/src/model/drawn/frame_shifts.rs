//! Links whose group gave them another frame than their statement: what else is written in their frames is
//! shifted to those of the groups, a statement by its own rules.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::chain::machine::GROUND;
use crate::exact::Exact;
use crate::syntax::tree::{
    Course, Expr, ExprKind, GuideAnchor, GuideStatement, PointPlace, Statement,
};

use crate::model::drawn::bodies::{Bodies, GuideLine};
use crate::model::drawn::figures::{Figure, Pen, sum};
use crate::model::drawn::frames::{DrawnFrame, Heading, Origin};
use crate::model::drawn_links::TurnedFrame;
use crate::model::frames_of_groups::FramesOfGroups;
use crate::model::statements::rules_mut;

/// The written frame of a link in that of its group.
struct FrameShift {
    link: Ident,
    /// Its angle, where it is turned.
    angle: Option<Figure>,
    /// The cosine and the sine of that angle.
    axis: [Figure; 2],
    origin: [Expr; 2],
    is_reversed: bool,
}

/// Those of all such links of a drawing.
pub(super) struct FrameShifts<'b, 't> {
    bodies: &'b Bodies<'t>,
    pen: Pen,
    by_link: HashMap<String, FrameShift>,
    /// Links, each with a pin that their group gives them.
    joined: HashSet<[String; 2]>,
}

impl<'b, 't> FrameShifts<'b, 't> {
    pub(super) fn new(bodies: &'b Bodies<'t>, pen: &Pen) -> Self {
        Self { bodies, pen: pen.clone(), by_link: HashMap::new(), joined: HashSet::new() }
    }

    /// Remembers that a link's group gives it a pin.
    pub(super) fn join(&mut self, link: &Ident, pin: &Ident) {
        self.joined.insert([link.to_string(), pin.to_string()]);
    }

    /// The body of a guide of the drawing, where a point that its statement names is none of what the groups have made of
    /// that body: the drawing says where it is.
    fn drawn_guide(
        &self,
        guide: &GuideStatement,
        point: &Ident,
    ) -> Option<(usize, &GuideLine<'t>)> {
        let body = guide.on.as_ref().map_or(Some(GROUND), |on| self.bodies.body(on))?;
        let is_made = match &guide.on {
            None => {
                let pins = &self.bodies.machine.bodies[GROUND].pins;
                let pin = self.bodies.pins.iter().position(|pin| pin.name == *point);
                pin.is_none_or(|pin| pins.contains(&pin))
            }
            Some(on) => self.joined.contains(&[on.to_string(), point.to_string()]),
        };
        let is_given = body != GROUND && self.bodies.link(body).is_given;
        let known = self.bodies.guides.iter().find(|known| known.name == &guide.name)?;
        (!is_made && !is_given).then_some((body, known))
    }

    /// Remembers a link whose group gave it this frame, at this angle in the drawing.
    pub(super) fn note(
        &mut self,
        link: &Ident,
        written: &DrawnFrame,
        (own, counted): (&DrawnFrame, f64),
        length: Option<&Expr>,
    ) {
        if written.is(own) {
            return;
        }
        let pen = self.pen.at(link.span());
        let is_reversed = match (written.points, own.points) {
            (Heading::Pins(a, b), Heading::Pins(c, d)) => (a, b) == (d, c),
            _ => false,
        };
        let (angle, axis) = match () {
            () if written.points == own.points => (None, pen.x_axis()),
            () if is_reversed => {
                let axis = pen.x_axis().map(|part| pen.neg(&part));
                (Some(pen.turn(&axis, counted)), axis)
            }
            () => {
                let along = own.local_direction(&pen, &written.axis);
                let size = pen.size(&along);
                let axis = along.each_ref().map(|part| pen.div(part, &size));
                (Some(pen.turn(&along, counted)), axis)
            }
        };
        let origin = match (length, written.points) {
            (Some(length), Heading::Pins(_, far)) if own.begins == Origin::Pin(far) => {
                self.near_end(&pen, length, &axis)
            }
            _ => own.local(&pen, &written.origin).map(|number| number.text),
        };
        let turn = FrameShift { link: link.clone(), angle, axis, origin, is_reversed };
        self.by_link.insert(link.to_string(), turn);
    }

    /// The near end of a declared length, from the far end in a frame in which the link has this direction.
    pub(super) fn near_end(&self, pen: &Pen, length: &Expr, axis: &[Figure; 2]) -> [Expr; 2] {
        let length = Figure::length(self.expr(length), f64::NAN, None);
        match axis[0].exact.as_ref().and_then(Exact::to_integer) {
            Some(-1) => [length.text, pen.zero().text],
            Some(1) => [length.text.negated(), pen.zero().text],
            _ => axis.each_ref().map(|part| pen.neg(&pen.mul(&length, part)).text),
        }
    }

    /// The links whose directions are other ones.
    pub(super) fn directions(self) -> Vec<TurnedFrame> {
        let turned = self.by_link.into_values();
        let turned = turned.filter_map(|FrameShift { link, angle, .. }| {
            Some(TurnedFrame { link, angle: angle?.text })
        });
        let mut turned: Vec<_> = turned.collect();
        turned.sort_by_key(|turned| turned.link.to_string());
        turned
    }

    /// The angle of a link's frame against that of its group, in the drawing.
    pub(super) fn turn_of(&self, link: &Ident) -> f64 {
        let turn = self.of(link).and_then(|turn| turn.angle.as_ref());
        turn.map_or(0.0, |turn| turn.value)
    }

    fn of(&self, link: &Ident) -> Option<&FrameShift> {
        self.by_link.get(&link.to_string())
    }

    /// The statement with everything in the frames of groups.
    pub(super) fn statement(&self, statement: &Statement) -> Statement {
        let mut shifted = statement.clone();
        rules_mut(&mut shifted).shift(self);
        shifted
    }
}

impl FramesOfGroups for FrameShifts<'_, '_> {
    fn expr(&self, expr: &Expr) -> Expr {
        expr.replaced(&|part| match &part.kind {
            ExprKind::Member(link, member) if member == "angle" => {
                Some(self.added(link, part.clone()))
            }
            _ => None,
        })
    }

    fn added(&self, link: &Ident, angle: Expr) -> Expr {
        match self.of(link).and_then(|turn| turn.angle.as_ref()) {
            Some(turn) => sum(angle, turn.text.clone()),
            None => angle,
        }
    }

    fn components(&self, link: &Ident, local: &[Expr; 2]) -> [Expr; 2] {
        let local = self.pair(local);
        let Some(turn) = self.of(link).filter(|turn| turn.angle.is_some()) else { return local };
        let pen = self.pen.at(link.span());
        let [x, y] = local.map(|text| Figure::length(text, f64::NAN, None));
        let [cos, sin] = &turn.axis;
        [
            pen.sub(&pen.mul(cos, &x), &pen.mul(sin, &y)).text,
            pen.add(&pen.mul(sin, &x), &pen.mul(cos, &y)).text,
        ]
    }

    fn place(&self, link: &Ident, local: &[Expr; 2]) -> [Expr; 2] {
        let turned = self.components(link, local);
        let Some(turn) = self.of(link) else { return turned };
        let [x, y] = turned;
        let [dx, dy] = turn.origin.clone();
        [sum_of(dx, x), sum_of(dy, y)]
    }

    fn point(&self, on: Option<&Ident>, place: &PointPlace) -> PointPlace {
        let Some((on, turn)) = on.and_then(|on| Some((on, self.of(on)?))) else {
            return match place {
                PointPlace::Cartesian(place) => PointPlace::Cartesian(self.pair(place)),
                PointPlace::Polar(place) => PointPlace::Polar(self.pair(place)),
                PointPlace::Distances(distances, side) => {
                    PointPlace::Distances(self.pair(distances), side.clone())
                }
                PointPlace::Mistake => PointPlace::Mistake,
            };
        };
        let pen = self.pen.at(on.span());
        match place {
            PointPlace::Cartesian(place) => PointPlace::Cartesian(self.place(on, place)),
            PointPlace::Polar([radius, angle]) => {
                let radius = Figure::length(self.expr(radius), f64::NAN, None);
                let angle = Figure::plain(self.expr(angle), f64::NAN, None);
                let local =
                    [pen.mul(&radius, &pen.cos(&angle)), pen.mul(&radius, &pen.sin(&angle))];
                PointPlace::Cartesian(self.place(on, &local.map(|number| number.text)))
            }
            PointPlace::Distances([first, second], side) if turn.is_reversed => {
                let word = if side == "left" { "right" } else { "left" };
                let side = Ident::new(word, side.span());
                PointPlace::Distances([self.expr(second), self.expr(first)], side)
            }
            place => place.clone(),
        }
    }

    fn through(&self, guide: &GuideStatement) -> Option<[Expr; 2]> {
        let point = match &guide.through {
            GuideAnchor::At(place) => return Some(self.place(guide.on.as_ref()?, place)),
            GuideAnchor::Point(point) => point,
            GuideAnchor::Mistake => return None,
        };
        let (body, GuideLine { line, through, .. }) = self.drawn_guide(guide, point)?;
        let Some(on) = &guide.on else {
            return Some(line.through.clone().map(|number| number.text));
        };
        let (pen, link) = (self.pen.at(point.span()), self.bodies.link(body));
        let local = match (&link.length, &link.pins[..]) {
            // The far end is where the declared length puts it.
            (Some((length, _)), &[_, far]) if *through == Some(far) => {
                [(*length).clone(), pen.zero().text]
            }
            _ => self.bodies.frames[body].local(&pen, &line.through).map(|number| number.text),
        };
        Some(self.place(on, &local))
    }

    fn towards(&self, guide: &GuideStatement) -> Option<Expr> {
        let Course::Towards(point) = &guide.course else { return None };
        let (body, GuideLine { line, .. }) = self.drawn_guide(guide, point)?;
        let pen = self.pen.at(point.span());
        let along = self.bodies.frames[body].local_direction(&pen, &line.along);
        let angle = pen.angle(&along).text;
        Some(guide.on.as_ref().map_or(angle.clone(), |on| self.added(on, angle)))
    }
}

/// The sum, without a zero in front.
fn sum_of(first: Expr, second: Expr) -> Expr {
    let is_zero = |expr: &Expr| matches!(&expr.kind, ExprKind::Number { digits, .. } if digits.bytes().all(|d| d == b'0'));
    match (is_zero(&first), is_zero(&second)) {
        (true, _) => second,
        (_, true) => first,
        _ => sum(first, second),
    }
}
