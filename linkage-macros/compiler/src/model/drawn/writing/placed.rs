//! Links that a group has placed: their frames, and the pins that come with them.

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Expr, PointPlace, PointStatement, StatementKind};

use crate::model::drawn::outline::bodies::{Bodies, PinPlace};
use crate::model::drawn::outline::figures::Figure;
use crate::model::drawn::outline::frames::{DrawnFrame, Heading, Origin};
use crate::model::drawn::outline::lengths::in_words;
use crate::model::drawn::writing::writer::Writer;
use crate::model::drawn_links::BarFound;

/// Reports points whose place on their link needs the link to be placed first, where the link is placed from them:
/// those at distances, and those beside the far end of a declared length.
pub(in crate::model::drawn) fn report_places_of_unplaced(
    bodies: &Bodies<'_>,
    points: &[Ident],
    diagnostics: &mut Diagnostics,
) -> Option<()> {
    let mut is_well = Some(());
    for point in points {
        let Some(PinPlace { name, on: Some((body, place)), .. }) =
            bodies.pins.iter().find(|pin| pin.name == *point)
        else {
            continue;
        };
        let link = bodies.link(*body);
        let instead = match place {
            PointPlace::Distances(..) => {
                format!("write `point {name} on {} at (x, y);`", link.name)
            }
            _ => format!("draw it, `pin {name}(x, y);`, and name it in `link {}`", link.name),
        };
        let message = format!("`{}` is placed from `{name}`; {instead}", link.name);
        let reason = "distances, and places on a link whose length is declared, are measured where the \
                      link is placed already";
        diagnostics.error_because(name.span(), message, reason);
        is_well = None;
    }
    is_well
}

/// Reports constant distances that do not meet, from pins between which no group has a bar.
pub(in crate::model::drawn) fn report_distances_apart(
    bodies: &Bodies<'_>,
    bars: &[BarFound],
    diagnostics: &mut Diagnostics,
) -> Option<()> {
    let mut is_well = Some(());
    for pin in &bodies.pins {
        let (Some((body, _)), Some(lengths)) = (pin.on, pin.apart) else { continue };
        let (link, [a, b, long]) = (bodies.link(body).name, lengths.map(in_words));
        if bars.iter().any(|bar| bar.link == *link && bar.middle.is_some()) {
            let message = format!("no point has the distances of `{}`; change them", pin.name);
            let reason = format!("`{link}` is {long}, and the distances are {a} and {b}");
            diagnostics.error_because(pin.name.span(), message, reason);
            is_well = None;
        }
    }
    is_well
}

impl Writer<'_, '_> {
    pub(in crate::model::drawn) fn bar_is_placed(&mut self, body: usize, from: usize, to: usize) {
        let origin = self.frames.place(from).clone();
        let axis =
            self.frames.pen.at(self.frames.name(body).span()).minus(self.frames.place(to), &origin);
        let (begins, points) = (Origin::Pin(from), Heading::Pins(from, to));
        let counted = self.frames.uncounted(body, &axis);
        self.settle(body, DrawnFrame { begins, points, origin, axis }, counted);
    }

    /// A block with its pin on a rail.
    pub(in crate::model::drawn) fn block_on_rail(&mut self, slide: usize, body: usize, pin: usize) {
        let counted = self.frames.counted_on_rail(slide, body);
        self.block_is_placed(body, pin, (self.frames.guide_of(slide), counted));
    }

    pub(in crate::model::drawn) fn block_is_placed(
        &mut self,
        body: usize,
        pin: usize,
        (guide, counted): (usize, f64),
    ) {
        let line = self.bodies.guides[guide].line.clone();
        let origin = self.frames.place(pin).clone();
        let frame =
            DrawnFrame { begins: Origin::Pin(pin), points: line.points, origin, axis: line.along };
        self.settle(body, frame, counted);
    }

    /// Remembers the frame that a group gave a link, at this angle in the drawing, and makes the link's other pins.
    pub(in crate::model::drawn) fn settle(&mut self, body: usize, frame: DrawnFrame, counted: f64) {
        let (bodies, link) = (self.bodies, self.bodies.link(body));
        let length = link.length.as_ref().map(|(length, _)| *length);
        self.frames.own[body] = Some(frame.clone());
        self.frames.counted[body] = Some(counted);
        self.frames.turns.note(link.name, &bodies.frames[body], (&frame, counted), length);
        let ends: Option<[usize; 2]> = length.and_then(|_| link.pins[..].try_into().ok());
        for &pin in &link.points {
            let place = &bodies.pins[pin];
            if !std::mem::replace(&mut self.made[pin], true) {
                self.frames.turns.join(link.name, &place.name);
            } else {
                self.replaced.push(place.name.clone());
                let is_at_distances = matches!(place.on, Some((_, PointPlace::Distances(..))));
                if is_at_distances || ends.is_some_and(|[_, far]| frame.stands_on(far)) {
                    self.misplaced.push(place.name.clone());
                }
            }
        }
        for &pin in &link.pins {
            if std::mem::replace(&mut self.made[pin], true) {
                continue;
            }
            let name = bodies.pins[pin].name.clone();
            let place = self.place_in(body, pin, &frame, &name);
            let (on, place) = (Some(link.name.clone()), PointPlace::Cartesian(place));
            self.frames.turns.join(link.name, &name);
            self.links.placed.insert(name.clone());
            let kind = StatementKind::Point(PointStatement { name, on, place });
            self.put(link.statement, kind);
        }
    }

    /// The place of a pin in the frame of its link, as its group gave it.
    pub(in crate::model::drawn) fn place_in(
        &mut self,
        body: usize,
        pin: usize,
        frame: &DrawnFrame,
        name: &Ident,
    ) -> [Expr; 2] {
        let bodies = self.bodies;
        let link = bodies.link(body);
        let length = link.length.as_ref().map(|(length, _)| *length);
        let ends: Option<[usize; 2]> = length.and_then(|_| link.pins[..].try_into().ok());
        match (length, ends) {
            (Some(length), Some(ends)) if !frame.stands_on(ends[1]) => {
                self.far_end(frame, ends, length)
            }
            (Some(length), Some([near, far])) => {
                let pen = self.frames.pen.at(name.span());
                let along = pen.minus(self.frames.place(far), self.frames.place(near));
                let along = frame.local_direction(&pen, &along);
                let size = pen.size(&along);
                let axis = match frame.points {
                    Heading::Pins(from, to) if [from, to] == [near, far] => pen.x_axis(),
                    _ => along.map(|part| pen.div(&part, &size)),
                };
                self.frames.turns.near_end(&pen, length, &axis)
            }
            _ => frame
                .local(&self.frames.pen.at(name.span()), self.frames.place(pin))
                .map(|number| number.text),
        }
    }

    /// The place of the far end of a declared length, in a frame that does not depend on it.
    fn far_end(&self, frame: &DrawnFrame, [near, far]: [usize; 2], length: &Expr) -> [Expr; 2] {
        let pen = self.frames.pen.at(self.bodies.pins[far].name.span());
        let along = pen.minus(self.frames.place(far), self.frames.place(near));
        let along = frame.local_direction(&pen, &along);
        let size = pen.size(&along);
        let length = Figure::length(length.clone(), f64::NAN, None);
        let way = along.map(|part| pen.mul(&length, &pen.div(&part, &size)));
        pen.plus(&frame.local(&pen, self.frames.place(near)), &way).map(|number| number.text)
    }
}
