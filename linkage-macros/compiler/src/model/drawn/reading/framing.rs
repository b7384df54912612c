//! Finds the frames of links and the lines of guides, each from what is known before it.

use proc_macro2::Ident;

use crate::chain::machine::GROUND;
use crate::chain::plane::root;
use crate::syntax::tree::{
    Course, ExprKind, GuideAnchor, GuideStatement, PointPlace, StatementKind,
};

use crate::model::drawn::outline::frames::{DrawnFrame, DrawnLine, Heading, Origin};
use crate::model::drawn::reading::reader::Reader;
use crate::model::figures::{self, Figure};
use crate::model::statements::guides::guide_points;

/// The part of a distance by which rounding may miss another.
const MISSED: f64 = 1e-12;

/// The frames of all links as they are written, and the lines of all guides. `None` where they
/// stand on each other in a circle, which is reported.
pub fn written(reader: &mut Reader<'_, '_, '_>) -> Option<Vec<DrawnFrame>> {
    let mut frames = vec![None; reader.links.len() + 1];
    frames[GROUND] = Some(DrawnFrame::ground());
    let mut lines = vec![false; reader.guides.len()];
    let mut pins: Vec<_> = reader.pins.iter().map(|pin| pin.on.is_none()).collect();
    loop {
        let mut grew = false;
        for pin in 0..reader.pins.len() {
            if !pins[pin]
                && let Some(at) = point_of_link(reader, pin, &frames)
            {
                reader.values.places.insert(reader.pins[pin].name.to_string(), at.clone());
                reader.pins[pin].at = at;
                (pins[pin], grew) = (true, true);
            }
        }
        for link in 0..reader.links.len() {
            let of_frame = || reader.links[link].pins.iter().take(2);
            if frames[link + 1].is_none() && of_frame().all(|&pin| pins[pin]) {
                frames[link + 1] = frame_of(reader, link, &frames, &lines);
                grew |= frames[link + 1].is_some();
            }
        }
        for (guide, is_known) in lines.iter_mut().enumerate().filter(|(_, is_known)| !**is_known) {
            if let Some(line) = line_of(reader, guide, &frames) {
                reader.guides[guide].line = line;
                (*is_known, grew) = (true, true);
            }
        }
        if !grew {
            break;
        }
    }
    if let Some(pin) = pins.iter().position(|is_known| !is_known) {
        let name = reader.pins[pin].name.clone();
        let (lengths, angles) = match reader.pins[pin].on.map(|(_, place)| place) {
            Some(PointPlace::Cartesian([x, y])) => (vec![x, y], vec![]),
            Some(PointPlace::Polar([radius, angle])) => (vec![radius], vec![angle]),
            Some(PointPlace::Distances([first, second], _)) => (vec![first, second], vec![]),
            Some(PointPlace::Mistake) | None => (vec![], vec![]),
        };
        let reason = "its place on the link depends on an input, or on the point itself";
        reader.values.report_unplaced(&name, (&lengths, &angles), reason);
        return None;
    }
    if let Some(guide) = lines.iter().position(|is_known| !is_known) {
        report_line(reader, guide);
        return None;
    }
    frames.into_iter().collect()
}

/// Reports a guide whose line is not known.
fn report_line(reader: &mut Reader<'_, '_, '_>, guide: usize) {
    let point = reader.guides[guide].along.and_then(|angle| match &angle.kind {
        ExprKind::Name(point) if reader.pin_of.contains_key(&point.to_string()) => Some(point),
        _ => None,
    });
    if let Some(point) = point {
        let message = format!("`{point}` is a point; a guide runs along an angle");
        reader.report(point, message, format!("or towards a point: `towards {point}`"));
        return;
    }
    let written = written_line(reader, guide);
    let named = written.map(guide_points);
    if named.into_iter().flatten().flatten().any(|point| reader.pin(point).is_none()) {
        return;
    }
    let through = match written.map(|guide| &guide.through) {
        Some(GuideAnchor::At([x, y])) => vec![x, y],
        _ => Vec::new(),
    };
    let along: Vec<_> = reader.guides[guide].along.into_iter().collect();
    let reason = "a guide goes through a point and along an angle or towards a point, on a link \
                  whose own guide does not stand on it";
    let name = reader.guides[guide].name;
    reader.values.report_unplaced(name, (&through, &along), reason);
}

/// The place in the drawing of a point that is declared on a link.
fn point_of_link(
    reader: &mut Reader<'_, '_, '_>,
    pin: usize,
    frames: &[Option<DrawnFrame>],
) -> Option<[Figure; 2]> {
    let (body, place) = reader.pins[pin].on?;
    let frame = frames[body].clone()?;
    let local = match place {
        PointPlace::Cartesian([x, y]) => [reader.values.length(x)?, reader.values.length(y)?],
        PointPlace::Polar([radius, angle]) => {
            let (radius, angle) = (reader.values.length(radius)?, reader.values.angle(angle)?);
            [radius.times(&angle.cos()), radius.times(&angle.sin())]
        }
        PointPlace::Distances([first, second], side) => {
            let distances = [reader.values.length(first)?, reader.values.length(second)?];
            let is_constant = distances.iter().all(|distance| distance.exact().is_some());
            let [a, b] = distances.map(|distance| distance.value);
            let long = match &reader.links[body - 1].length {
                Some((_, Some(length))) => length.value,
                _ => frame.axis[0].value.hypot(frame.axis[1].value),
            };
            let x = (long + (a - b) * (a + b) / long) / 2.0;
            let square = (a - x) * (a + x);
            reader.pins[pin].apart =
                (is_constant && square < -MISSED * a * a).then_some([a, b, long]);
            // Where the distances do not meet is said where the link is placed.
            let y = root(square.max(0.0));
            [x, if side == "left" { y } else { -y }].map(Figure::float)
        }
        PointPlace::Mistake => return None,
    };
    Some(frame.placed(&local))
}

fn frame_of(
    reader: &mut Reader<'_, '_, '_>,
    link: usize,
    frames: &[Option<DrawnFrame>],
    lines: &[bool],
) -> Option<DrawnFrame> {
    let place = |reader: &Reader<'_, '_, '_>, pin: usize| reader.pins[pin].at.clone();
    let own = reader.links[link].on.first().copied();
    match (&reader.links[link].pins[..], own) {
        (&[first, second, ..], _) => {
            let origin = place(reader, first);
            let axis = figures::minus(&place(reader, second), &origin);
            let (begins, points) = (Origin::Pin(first), Heading::Pins(first, second));
            Some(DrawnFrame { begins, points, origin, axis })
        }
        (&[pin], Some(guide)) if lines[guide] => {
            let line = &reader.guides[guide].line;
            let (axis, points) = (line.along.clone(), line.points);
            Some(DrawnFrame { begins: Origin::Pin(pin), points, origin: place(reader, pin), axis })
        }
        (&[pin], None) => {
            let origin = place(reader, pin);
            Some(DrawnFrame { begins: Origin::Pin(pin), origin, ..frames[GROUND].clone()? })
        }
        (&[], Some(guide)) if lines[guide] => frame_without_pins(reader, link, guide),
        (&[], None) => frames[GROUND].clone(),
        _ => None,
    }
}

/// A link without pins begins where the first guide on it crosses its own guide, if that one goes
/// through a pin; else at the point of its own guide.
fn frame_without_pins(
    reader: &mut Reader<'_, '_, '_>,
    link: usize,
    guide: usize,
) -> Option<DrawnFrame> {
    let own = reader.guides[guide].line.clone();
    let frame = DrawnFrame {
        begins: Origin::Guide(guide),
        points: own.points,
        origin: own.through,
        axis: own.along,
    };
    let carried = reader.guides.iter().position(|guide| guide.on == link + 1);
    let Some(carried) = carried else { return Some(frame) };
    let Some(GuideStatement { through: GuideAnchor::Point(pin), course, .. }) =
        written_line(reader, carried)
    else {
        return Some(frame);
    };
    let at = reader.values.places.get(&pin.to_string()).cloned()?;
    let along = direction(reader, course, &frame, &at)?.0;
    let across = figures::cross(&frame.axis, &along);
    if across.is_zero() {
        return Some(frame);
    }
    let share = figures::cross(&figures::minus(&at, &frame.origin), &along).over(&across);
    let way = frame.axis.each_ref().map(|part| part.times(&share));
    let origin = figures::plus(&frame.origin, &way);
    Some(DrawnFrame { begins: Origin::Guide(carried), origin, ..frame })
}

/// The guide's statement.
fn written_line<'t>(reader: &Reader<'t, '_, '_>, guide: usize) -> Option<&'t GuideStatement> {
    let wanted = reader.guides[guide].name;
    reader.tree.statements.iter().find_map(|statement| match &statement.kind {
        StatementKind::Guide(guide) if guide.name == *wanted => Some(guide),
        _ => None,
    })
}

fn line_of(
    reader: &mut Reader<'_, '_, '_>,
    guide: usize,
    frames: &[Option<DrawnFrame>],
) -> Option<DrawnLine> {
    let statement @ GuideStatement { through: spot, course, .. } = written_line(reader, guide)?;
    let on = reader.guides[guide].on;
    let frame = frames[on].clone();
    let through = match spot {
        GuideAnchor::Point(point) => reader.values.places.get(&point.to_string()).cloned()?,
        GuideAnchor::At([x, y]) => {
            let local = [reader.values.length(x)?, reader.values.length(y)?];
            frame.clone()?.placed(&local)
        }
        GuideAnchor::Mistake => return None,
    };
    let pin = |point: Option<&Ident>| reader.pin_of.get(&point?.to_string()).copied();
    let [from, towards] = guide_points(statement).map(pin);
    let frame = match course {
        Course::Along(_) => frame?,
        // Not needed.
        _ => DrawnFrame::ground(),
    };
    let (along, is_axis) = direction(reader, course, &frame, &through)?;
    let points = match (from, towards) {
        (Some(from), Some(towards)) => Heading::Pins(from, towards),
        _ if is_axis => frame.points,
        _ => Heading::Guide(guide),
    };
    // The ground's axis is nobody else's.
    let points = if points == Heading::X { Heading::Guide(guide) } else { points };
    let angle = match course {
        Course::Along(angle) => reader.values.angle(angle).map(|angle| angle.value),
        _ => None,
    };
    Some(DrawnLine { through, along, points, angle })
}

/// The direction of a guide in the drawing, and whether it is that of the frame.
fn direction(
    reader: &mut Reader<'_, '_, '_>,
    course: &Course,
    frame: &DrawnFrame,
    through: &[Figure; 2],
) -> Option<([Figure; 2], bool)> {
    match course {
        Course::Along(angle) => {
            let angle = reader.values.angle(angle)?;
            if angle.is_zero() {
                return Some((frame.axis.clone(), true));
            }
            let local = [angle.cos(), angle.sin()];
            Some((frame.direction(&local), false))
        }
        Course::Towards(point) => {
            let to = reader.values.places.get(&point.to_string()).cloned()?;
            Some((figures::minus(&to, through), false))
        }
        Course::Mistake => None,
    }
}
