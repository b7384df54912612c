//! Links that a group has placed: their frames, and the pins that come with them.

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::PointPlace;

use crate::model::drawn::outline::bodies::{Bodies, PinPlace};
use crate::model::drawn::outline::frames::{DrawnFrame, Heading, Origin};
use crate::model::drawn::outline::lengths::in_words;
use crate::model::drawn::writing::writer::Writer;
use crate::model::drawn_links::BarFound;
use crate::model::figures::{self, Figure};
use crate::model::statements::points::made_point;

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
        let axis = figures::minus(self.frames.place(to), &origin);
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
        let length = link.declared_length();
        self.frames.own[body] = Some(frame.clone());
        self.frames.counted[body] = Some(counted);
        self.frames.note(link.name, &bodies.frames[body], (&frame, counted), length.as_ref());
        let ends: Option<[usize; 2]> = length.and_then(|_| link.pins[..].try_into().ok());
        for &pin in &link.points {
            let place = &bodies.pins[pin];
            if !std::mem::replace(&mut self.made[pin], true) {
                self.frames.join(link.name, &place.name);
            } else {
                self.replaced.push(place.name.clone());
                let is_at_distances = matches!(place.on, Some((_, PointPlace::Distances(..))));
                if is_at_distances || ends.is_some_and(|[_, far]| frame.stands_on(far)) {
                    self.links.misplaced.push(place.name.clone());
                }
            }
        }
        for &pin in &link.pins {
            if std::mem::replace(&mut self.made[pin], true) {
                continue;
            }
            let name = bodies.pins[pin].name.clone();
            let (on, at) = (link.name.clone(), self.place_in(body, pin, &frame));
            self.frames.join(link.name, &name);
            self.put(link.statement, made_point(name, on, at));
        }
    }

    /// The place of a pin in the frame of its link, as its group gave it.
    pub(in crate::model::drawn) fn place_in(
        &self,
        body: usize,
        pin: usize,
        frame: &DrawnFrame,
    ) -> [Figure; 2] {
        let link = self.bodies.link(body);
        let length = link.declared_length();
        let ends: Option<[usize; 2]> = link.pins[..].try_into().ok();
        match (&length, ends) {
            (Some(length), Some(ends)) if !frame.stands_on(ends[1]) => {
                self.far_end(frame, ends, length)
            }
            (Some(length), Some([near, far])) => {
                let along = figures::minus(self.frames.place(far), self.frames.place(near));
                let axis = match frame.points {
                    Heading::Pins(from, to) if [from, to] == [near, far] => figures::x_axis(),
                    _ => figures::unit_vector(&frame.local_direction(&along)),
                };
                self.frames.near_end(length, &axis)
            }
            _ => frame.local(self.frames.place(pin)),
        }
    }

    /// The place of the far end of a declared length, in a frame that does not depend on it.
    fn far_end(&self, frame: &DrawnFrame, [near, far]: [usize; 2], length: &Figure) -> [Figure; 2] {
        let along = figures::minus(self.frames.place(far), self.frames.place(near));
        let along = frame.local_direction(&along);
        let way = figures::along(length, &along);
        figures::plus(&frame.local(self.frames.place(near)), &way)
    }
}
