//! Searches: a group of class III as an unknown, what it drives, and the link that was left out as the
//! equation. A group that no single unknown solves as a driver a body, and the points that close its loops.

use proc_macro2::{Ident, Span};

use crate::chain::cutting::{Closing, DyadLeg, Found, Pair, SearchedGroup, TrackedGroup};
use crate::chain::machine::{Driven, InputRates};
use crate::chain::plane::Complex;
use crate::syntax::tree::{InputStatement, StatementKind};

use crate::model::as_drawn::{SearchFollowed, Stretch};
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::drawn::outline::frames::{DrawnFrame, Heading, Origin};
use crate::model::drawn::writing::bars::LinksOfBar;
use crate::model::drawn::writing::followed::{DrawnValues, Fitted, traced_names};
use crate::model::drawn::writing::writer::{Writer, offsets};
use crate::model::figures::{self, Figure};
use crate::model::mechanism::{Dimension, Sign, StandsFor};
use crate::model::parts_of_groups::GroupNumbers;
use crate::model::solved_at_once::{TrackedFit, TrackedUnknown};
use crate::model::statements::closed_loops::{made_closing, made_tracking};
use crate::model::statements::points::made_point;
use crate::model::statements::solves::made_equation;
use crate::model::statements::unknowns::made_unknown;

impl Writer<'_, '_> {
    /// The unknown that drives a body.
    pub(in crate::model::drawn) fn unknown(&self, body: usize) -> Figure {
        if let Some((_, name)) = self.together.iter().find(|(own, _)| *own == body) {
            return Figure::named(name);
        }
        match self.links.searches.last() {
            Some(SearchFollowed { unknown, traced: Some(traced), .. }) => {
                Figure::named(unknown).plus(&Figure::named(traced))
            }
            Some(SearchFollowed { unknown, .. }) => Figure::named(unknown),
            None => Figure::zero(),
        }
    }

    /// Writes a group that is solved by all its unknowns at once.
    pub(in crate::model::drawn) fn together(&mut self, tracked: &TrackedGroup) {
        let bodies = tracked.bodies();
        let behind = self.behind(bodies.iter().copied(), None);
        let begin = self.written.len();
        let Some((_, drive)) = self.bodies.drives.first() else { return };
        let (drive, drawn) = (drive.value.clone(), self.bodies.drawn_value(0));
        let fitted: Vec<TrackedUnknown> =
            tracked.unknowns().map(|step| self.tracked_unknown(step)).collect();
        let unknowns: Vec<_> = self.together.iter().map(|(_, name)| name.clone()).collect();
        let fit = TrackedFit {
            unknowns: fitted,
            drawn,
            is_turned: self.bodies.machine.drives[0].kind == Driven::Angle,
            closes: tracked.closes,
            pieces: tracked.pieces.clone(),
            size: tracked.size,
        };
        let mut sorted = bodies.clone();
        sorted.sort_unstable();
        let links = sorted.iter().map(|&body| self.frames.name(body).clone()).collect();
        self.put(behind, made_tracking(unknowns.clone(), drive, (links, fit)));
        tracked.steps.iter().for_each(|step| self.step(step));
        let pairs = tracked.closings.iter().map(|closing| (self.closing(closing), closing.bend));
        let closing = made_closing(unknowns, pairs.collect());
        self.put(behind, closing);
        self.together.clear();
        self.are_one_search(begin, behind);
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
        let at = self.place_in(body, pin, &frame);
        self.put(0, made_point(name.clone(), link, at));
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
            let drive = Figure::written(self.bodies.drives.first()?.1.value.clone(), None);
            let drawn = DrawnValues { drive: self.bodies.drawn_value(0), unknown: drawn };
            let names = traced_names(&mut self.names, &unknown);
            let traced = names.traced.clone();
            let fitted = Fitted { following, drive, drawn, is_angle }.numbers(names);
            fitted.into_iter().for_each(|part| self.put(behind, part));
            Some(traced)
        });
        let from = if traced.is_some() { 0.0 } else { drawn };
        self.hide(unknown.clone(), &links);
        let between = search.between.map(|end| end_of_interval(from + end, is_angle));
        let stretches = self.stretches(search);
        let assemblies = search.assemblies.clone();
        let sought = SearchFollowed { unknown: unknown.clone(), traced, stretches, assemblies };
        self.links.searches.push(sought);
        let of = if is_angle { Dimension::ANGLE } else { Dimension::LENGTH };
        self.put(behind, made_unknown(unknown.clone(), of, between));
        search.steps.iter().for_each(|step| self.step(step));
        match search.joints {
            [Pair::Pin(first), Pair::Pin(second)] => {
                self.distance(search, unknown, [first, second]);
            }
            [Pair::Pin(first), Pair::Slide(slide)] => {
                self.offset_of(search, unknown, first, slide);
            }
            [Pair::Slide(_), _] => {}
        }
        self.are_one_search(begin, behind);
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

    /// The equation of a bar, and the bar behind it.
    fn distance(&mut self, search: &SearchedGroup, unknown: Ident, [first, second]: [usize; 2]) {
        let body = search.left_out;
        let leg = DyadLeg {
            bodies: [body].into_iter().chain(search.held.map(|(body, _)| body)).collect(),
            outer: search.joints[0],
            held: search.held.map(|(_, held)| held),
        };
        let bar = self.bar(&leg, [first, second]);
        let between = [first, second].map(|pin| self.bodies.pins[pin].name.clone());
        self.put(0, made_equation(unknown, between, bar.length.clone(), trend(search)));
        self.rod(0, (bar.name.clone(), body), [first, second]);
        match bar.links {
            LinksOfBar::One(body) => {
                self.bar_is_placed(body, first, second);
                self.pin_is_elsewhere(body, second);
            }
            LinksOfBar::Held { .. } => self.settle_bar(bar),
        }
    }

    /// The equation of a block, and the block behind it.
    fn offset_of(&mut self, search: &SearchedGroup, unknown: Ident, pin: usize, slide: usize) {
        let body = search.left_out;
        let guide = self.frames.guide_of(slide);
        let (offset, rail) = (self.frames.offset(guide, pin), self.rail(slide, body));
        let name = self.bodies.pins[pin].name.clone();
        let between = [name.clone(), rail.clone()];
        self.put(0, made_equation(unknown, between, offset.clone(), trend(search)));
        let block = self.block(body, self.frames.name(body));
        let given = GroupNumbers {
            slot: Some(Figure::degrees(90.0)),
            offsets: offsets([offset.clone(), Figure::zero()]),
            ..GroupNumbers::default()
        };
        let legs = vec![[block, name], [self.frames.name(body).clone(), rail]];
        self.put_group(0, "rpp", legs, None, given);
        // The link's frame begins at the foot of its pin on the rail.
        let line = self.bodies.guides[guide].line.clone();
        let (begins, origin) = match offset.is_zero() {
            true => (Origin::Pin(pin), self.frames.place(pin).clone()),
            false => {
                let from = figures::minus(self.frames.place(pin), &line.through);
                let [along, _] = figures::seen_from(&line.along, &from);
                let axis = DrawnFrame {
                    begins: Origin::Guide(guide),
                    points: Heading::Guide(guide),
                    origin: line.through.clone(),
                    axis: line.along.clone(),
                };
                (Origin::Guide(guide), axis.placed(&[along, Figure::zero()]))
            }
        };
        let counted = self.frames.counted_on_rail(slide, body);
        let frame = DrawnFrame { begins, points: line.points, origin, axis: line.along };
        self.settle(body, frame, counted);
        self.slide_is_made(slide, body, None);
        self.pin_is_elsewhere(body, pin);
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
        let legs = vec![[block, to], [name, from]];
        self.put_group(behind, "rpr", legs, None, GroupNumbers::default());
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

/// The way in which the equation of a search passes its root.
fn trend(search: &SearchedGroup) -> Sign {
    if search.rises { Sign::Plus } else { Sign::Minus }
}

/// An end of an interval, to a thousandth of a degree or seven digits.
fn end_of_interval(value: f64, is_angle: bool) -> Figure {
    match is_angle {
        true => Figure::degrees((value.to_degrees() * 1e3).round() / 1e3),
        false => {
            let unit = 10_f64.powi(value.abs().max(1e-9).log10().floor() as i32 - 6);
            Figure::float((value / unit).round() * unit)
        }
    }
}
