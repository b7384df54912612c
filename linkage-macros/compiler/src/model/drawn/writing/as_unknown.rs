//! Searches: a group of class III as an unknown, what it drives, and the link that was left out as the
//! equation. A group that no single unknown solves as a driver a body, and the points that close its loops.

use proc_macro2::{Ident, Span};

use crate::chain::cutting::{Closing, DyadLeg, Found, Pair, SearchedGroup, TrackedGroup};
use crate::chain::machine::{Driven, InputRates};
use crate::chain::plane::Complex;
use crate::syntax::tree::{
    CloseStatement, Expr, ExprKind, GroupFieldValue, InputStatement, PointPlace, PointStatement,
    Solve, StatementKind, TrackStatement, UnknownStatement,
};

use crate::model::as_drawn::{SearchFollowed, Stretch};
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::figures::sum;
use crate::model::drawn::outline::frames::{DrawnFrame, Heading, Origin};
use crate::model::drawn::writing::bars::DrawnBar;
use crate::model::drawn::writing::followed::{DrawnValues, Fitted, traced_names};
use crate::model::drawn::writing::group_statement::{group_of, named};
use crate::model::drawn::writing::writer::Writer;
use crate::model::mechanism::StandsFor;
use crate::model::solved_at_once::{TrackedFit, TrackedUnknown};

impl Writer<'_, '_> {
    /// The unknown that drives a body.
    pub(in crate::model::drawn) fn unknown(&self, body: usize) -> Expr {
        let span = self.frames.name(body).span();
        let named = |name: &Ident| named(&Ident::new(&name.to_string(), span));
        if let Some((_, name)) = self.together.iter().find(|(own, _)| *own == body) {
            return named(name);
        }
        match self.searches.last() {
            Some(SearchFollowed { unknown, traced: Some(traced), .. }) => {
                sum(named(unknown), named(traced))
            }
            Some(SearchFollowed { unknown, .. }) => named(unknown),
            None => named(&Ident::new("phi", span)),
        }
    }

    /// Writes a group that is solved by all its unknowns at once.
    pub(in crate::model::drawn) fn together(&mut self, tracked: &TrackedGroup) {
        let bodies = tracked.bodies();
        let behind = self.behind(bodies.iter().copied(), None);
        let (begin, key) = (self.written.len(), self.next_key());
        let Some((_, drive)) = self.bodies.drives.first() else { return };
        let (drive, drawn) = (drive.value.clone(), self.bodies.drawn_value(0));
        let unknowns: Vec<TrackedUnknown> =
            tracked.unknowns().map(|step| self.tracked_unknown(step)).collect();
        let names: Vec<_> = self.together.iter().map(|(_, name)| name.clone()).collect();
        let group = self.links.tracked.len();
        let unknown_names = names.clone();
        self.put(
            behind,
            StatementKind::Track(TrackStatement { unknowns: unknown_names, drive, group }),
        );
        tracked.steps.iter().for_each(|step| self.step(step));
        let points = tracked.closings.iter().map(|closing| self.closing(closing)).collect();
        let bends = tracked.closings.iter().map(|closing| closing.bend).collect();
        let close = CloseStatement { unknowns: names, points, bends };
        self.put(behind, StatementKind::Close(close));
        let machine = &self.bodies.machine;
        let mut sorted = bodies.clone();
        sorted.sort_unstable();
        let links = sorted.iter().map(|&body| self.frames.name(body).clone()).collect();
        let fit = TrackedFit {
            unknowns,
            drawn,
            is_turned: machine.drives[0].kind == Driven::Angle,
            closes: tracked.closes,
            pieces: tracked.pieces.clone(),
            size: tracked.size,
        };
        self.links.tracked.push((links, fit));
        self.together.clear();
        for written in &mut self.written[begin..] {
            (written.search, written.behind) = (Some(key), behind);
        }
    }

    /// The unknown of a step, with a name that nobody has written.
    fn tracked_unknown(&mut self, step: &Found) -> TrackedUnknown {
        let (Found::Crank { body, .. } | Found::Slider { body, .. }) = *step else {
            unreachable!("every step of such a group is a driver")
        };
        let is_angle = matches!(step, Found::Crank { .. });
        let link = self.frames.name(body).clone();
        let ending = if is_angle { "_angle" } else { "_slide" };
        let name = self.names.made(format!("{link}{ending}"), "_", link.span());
        self.hide(name.clone(), &[body]);
        let unknown = TrackedUnknown { name: name.to_string(), is_angle, drawn: self.drawn(step) };
        self.together.push((body, name));
        unknown
    }

    /// A pin, and the point of another body that is to be there.
    fn closing(&mut self, &Closing { pin, body, .. }: &Closing) -> [Ident; 2] {
        let (made, link) = (self.bodies.pins[pin].name.clone(), self.frames.name(body).clone());
        let name = self.names.made(format!("{made}_on_{link}"), "_", link.span());
        let frame = self.frames.own_frame(body);
        let place = PointPlace::Cartesian(self.place_in(body, pin, &frame, &name));
        self.links.placed.insert(name.clone());
        let point = PointStatement { name: name.clone(), on: Some(link), place };
        self.put(0, StatementKind::Point(point));
        self.pin_is_elsewhere(body, pin);
        [made, name]
    }

    pub(in crate::model::drawn) fn search(&mut self, search: &SearchedGroup) {
        let links = search.bodies();
        let behind = self.behind(links.iter().copied(), None);
        let begin = self.written.len();
        let is_angle = matches!(search.steps[0], Found::Crank { .. });
        let span = self.frames.name(search.left_out).span();
        let unknown = self.free_name(span);
        let drawn = self.drawn(&search.steps[0]);
        let traced = search.following.as_ref().and_then(|following| {
            let drive = self.bodies.drives.first()?.1.value.clone();
            let drawn = DrawnValues { drive: self.bodies.drawn_value(0), unknown: drawn };
            let names = traced_names(&mut self.names, &unknown);
            let fitted = Fitted { pen: &self.frames.pen, following, drive, drawn, is_angle };
            fitted.statements(&names).into_iter().for_each(|kind| self.put(behind, kind));
            Some(names.traced)
        });
        let from = if traced.is_some() { 0.0 } else { drawn };
        self.hide(unknown.clone(), &links);
        let ends = search.between.map(|end| self.end(from + end, is_angle));
        let stretches = self.stretches(search);
        let assemblies = search.assemblies.clone();
        let sought = SearchFollowed { unknown: unknown.clone(), traced, stretches, assemblies };
        self.searches.push(sought);
        let kind = Ident::new(if is_angle { "angle" } else { "length" }, span);
        let (name, kind) = (unknown.clone(), Some(kind));
        self.put(
            behind,
            StatementKind::Unknown(UnknownStatement { name, kind, between: Some(ends) }),
        );
        search.steps.iter().for_each(|step| self.step(step));
        match search.joints {
            [Pair::Pin(first), Pair::Pin(second)] => {
                self.distance(search, &unknown, [first, second]);
            }
            [Pair::Pin(first), Pair::Slide(slide)] => {
                self.offset_of(search, &unknown, first, slide);
            }
            [Pair::Slide(_), _] => {}
        }
        let key = self.next_key();
        for written in &mut self.written[begin..] {
            (written.search, written.behind) = (Some(key), behind);
        }
    }

    /// The stretches that were followed: of each input that moves anything, or of the first drive.
    fn stretches(&self, search: &SearchedGroup) -> Vec<Stretch> {
        let Bodies { tree, machine, .. } = self.bodies;
        if machine.motions.is_empty() {
            let is_angle = machine.drives.first().is_none_or(|drive| drive.kind == Driven::Angle);
            let of_drive = |&ends| Stretch { input: None, ends, is_angle };
            return search.stretches.iter().map(of_drive).collect();
        }
        let inputs = tree.statements.iter().flat_map(|statement| match &statement.kind {
            StatementKind::Input(InputStatement { names, kind, .. }) => {
                let is_angle = kind.as_ref().is_none_or(|kind| kind == "angle");
                names.iter().map(|name| (name, is_angle)).collect()
            }
            _ => Vec::new(),
        });
        let moving = machine.motions.iter().map(InputRates::moves);
        let stretches = inputs.zip(&search.stretches).zip(moving).filter(|(_, moves)| *moves);
        let stretches = stretches.map(|(stretch, _)| stretch);
        let of_input = |((name, is_angle), ends): ((&Ident, bool), &[f64; 2])| Stretch {
            input: Some(name.clone()),
            ends: *ends,
            is_angle,
        };
        stretches.map(of_input).collect()
    }

    /// The value of what the unknown drives, in the drawing.
    pub(in crate::model::drawn) fn drawn(&self, step: &Found) -> f64 {
        match step {
            Found::Crank { body, reference, .. } => {
                let [turn, from] = [*body, *reference].map(|body| self.bodies.drawn_angle(body));
                Complex::turned(turn - from).angle()
            }
            Found::Slider { body, slide, .. } => {
                let slide = self.bodies.machine.slides[*slide];
                slide.along.dot(self.bodies.drawn_origin(*body) - slide.through)
            }
            _ => 0.0,
        }
    }

    /// An end of an interval, to a thousandth of a degree or seven digits.
    fn end(&self, value: f64, is_angle: bool) -> Expr {
        match is_angle {
            true => self.frames.pen.float((value.to_degrees() * 1e3).round() / 1e3, "deg"),
            false => {
                let unit = 10_f64.powi(value.abs().max(1e-9).log10().floor() as i32 - 6);
                self.frames.pen.float((value / unit).round() * unit, "m")
            }
        }
    }

    /// The equation of a bar, and the bar behind it.
    fn distance(&mut self, search: &SearchedGroup, unknown: &Ident, [first, second]: [usize; 2]) {
        let body = search.left_out;
        let leg = DyadLeg {
            bodies: [body].into_iter().chain(search.held.map(|(body, _)| body)).collect(),
            outer: search.joints[0],
            held: search.held.map(|(_, held)| held),
        };
        let bar = self.bar(&leg, [first, second]);
        let name = self.bar_name(&bar);
        let [p, q] = [first, second].map(|pin| self.bodies.pins[pin].name.clone());
        self.solve(search, unknown, ("distance", [&p, &q]), bar.length());
        self.rod(0, (name, body), [first, second]);
        match bar {
            DrawnBar::Link { body, pins: [from, to], .. } => {
                self.bar_is_placed(body, from, to);
                self.pin_is_elsewhere(body, to);
            }
            held @ DrawnBar::Held(_) => self.settle_bar(held),
        }
    }

    /// The equation of a block, and the block behind it.
    fn offset_of(&mut self, search: &SearchedGroup, unknown: &Ident, pin: usize, slide: usize) {
        let body = search.left_out;
        let guide = self.frames.guide_of(slide);
        let (offset, rail) = (self.frames.offset(guide, pin), self.rail(slide, body));
        let name = self.bodies.pins[pin].name.clone();
        self.solve(search, unknown, ("offset", [&name, &rail]), offset.text.clone());
        let block = self.block(body, self.frames.name(body));
        let pen = self.frames.pen.at(self.frames.name(body).span());
        let slot = pen.float(90.0, "deg");
        let mut fields = vec![("slot", GroupFieldValue::One(slot))];
        fields.extend(self.offsets([offset.clone(), pen.zero()]));
        let group = group_of(
            "rpp",
            vec![(block, name), (self.frames.name(body).clone(), rail)],
            None,
            fields,
        );
        self.put(0, StatementKind::Group(group));
        // The link's frame begins at the foot of its pin on the rail.
        let line = self.bodies.guides[guide].line.clone();
        let (begins, origin) = match offset.is_zero() {
            true => (Origin::Pin(pin), self.frames.place(pin).clone()),
            false => {
                let from = pen.minus(self.frames.place(pin), &line.through);
                let [along, _] = pen.seen_from(&line.along, &from);
                let axis = DrawnFrame {
                    begins: Origin::Guide(guide),
                    points: Heading::Guide(guide),
                    origin: line.through.clone(),
                    axis: line.along.clone(),
                };
                (Origin::Guide(guide), axis.placed(&pen, &[along, pen.zero()]))
            }
        };
        let counted = self.frames.counted_on_rail(slide, body);
        let frame = DrawnFrame { begins, points: line.points, origin, axis: line.along };
        self.settle(body, frame, counted);
        self.slide_is_made(slide, body, None);
        self.pin_is_elsewhere(body, pin);
    }

    fn solve(
        &mut self,
        search: &SearchedGroup,
        unknown: &Ident,
        (function, of): (&str, [&Ident; 2]),
        wanted: Expr,
    ) {
        let span = unknown.span();
        let name = |name: &Ident| Expr { kind: ExprKind::Name(name.clone()), span: span.into() };
        let left = ExprKind::Call(Ident::new(function, span), of.map(name).to_vec());
        let mode = Ident::new(if search.rises { "rising" } else { "falling" }, span);
        let solve = Solve {
            unknown: unknown.clone(),
            equation: Some([Expr { kind: left, span: span.into() }, wanted]),
            mode: Some(mode),
            near: None,
            end: span,
            is_read: true,
        };
        self.put(0, StatementKind::Solve(solve));
    }

    /// Writes a bar, or what stands for the body, that lies between two pins: a rod from the first through a
    /// block at the second.
    pub(in crate::model::drawn) fn rod(
        &mut self,
        behind: usize,
        (name, body): (Ident, usize),
        pins: [usize; 2],
    ) {
        let [from, to] = pins.map(|pin| self.bodies.pins[pin].name.clone());
        let block = self.block(body, &name);
        let fields = vec![self.mode(body, "ahead")];
        self.frames.turns.join(&name, &from);
        let group = group_of("rpr", vec![(block, to), (name, from)], None, fields);
        self.put(behind, StatementKind::Group(group));
    }

    /// The name of the block that holds a link in place at a joint.
    fn block(&mut self, body: usize, link: &Ident) -> Ident {
        let name = self.names.made(format!("{link}_end"), "_end", link.span());
        let end = StandsFor::EndOf(self.frames.name(body).clone());
        self.links.hidden.push((name.clone(), end));
        name
    }

    /// Remembers the links that something stands for whose name nobody has written.
    pub(in crate::model::drawn) fn hide(&mut self, name: Ident, links: &[usize]) {
        let links = links.iter().map(|&body| self.frames.name(body).clone()).collect();
        self.links.hidden.push((name, StandsFor::Links(links)));
    }

    /// A name for an unknown that nothing has.
    fn free_name(&mut self, span: Span) -> Ident {
        let letters = ["phi", "psi", "chi", "xi"].map(String::from).into_iter();
        let more = (1..).map(|number| format!("phi{number}"));
        self.names.first(letters.chain(more), span)
    }
}
