//! The points at which bodies are joined, in the plane.

use super::super::Mistake;
use super::model::Model;
use super::planar::Plane;
use super::space::Vector;

/// A point, and the bodies through it; of these nothing is the ground.
#[derive(Clone, Debug)]
pub(super) struct Point {
    pub name: String,
    pub at: [f64; 2],
    pub on: Vec<Option<usize>>,
}

/// The hinges, the ties of loops, and what sites are read for.
pub(super) fn points(model: &Model, plane: &Plane) -> Result<Vec<Point>, Mistake> {
    let mut points = Points { model, plane, found: Vec::new() };
    // Sites named after their body are its points, in their order.
    for (name, at) in &model.sites {
        if name.split_once('.').is_some_and(|(body, _)| body == "ground") {
            points.put(*at, &[None], name);
        }
    }
    for (nth, body) in model.bodies.iter().enumerate() {
        for (name, at) in &body.sites {
            if name.split_once('.').is_some_and(|(own, _)| own == body.name) {
                points.put(*at, &[Some(nth)], name);
            }
        }
    }
    for (nth, body) in model.bodies.iter().enumerate() {
        if !body.joint.is_slide {
            points.put(body.joint.anchor, &[Some(nth), body.parent], &body.joint.name);
        }
    }
    for tie in model.equalities.iter().filter(|tie| tie.name == "connect") {
        let (at, bodies) = tied(model, tie)?;
        points.put(at, &bodies, tie.attribute("name").unwrap_or("tie"));
    }
    Ok(points.found)
}

/// The place of a loop's pin, and its bodies.
fn tied(model: &Model, tie: &super::xml::Element) -> Result<(Vector, [Option<usize>; 2]), Mistake> {
    if let (Some(first), Some(second)) = (tie.attribute("site1"), tie.attribute("site2")) {
        let site =
            |name: &str| model.site(name).ok_or_else(|| format!("there is no site `{name}`"));
        let ((at, own), (_, other)) = (site(first)?, site(second)?);
        return Ok((at, [own, other]));
    }
    let body = |name: Option<&str>| match name {
        None | Some("world") => Ok((super::space::Frame::WORLD, None)),
        Some(name) => {
            let found = model.frames.iter().find(|(own, ..)| own == name);
            found
                .map(|(_, frame, moving)| (*frame, *moving))
                .ok_or_else(|| format!("there is no body `{name}`"))
        }
    };
    let ((frame, own), (_, other)) = (body(tie.attribute("body1"))?, body(tie.attribute("body2"))?);
    Ok((frame.place(tie.list("anchor", [0.0; 3])?), [own, other]))
}

struct Points<'m> {
    model: &'m Model,
    plane: &'m Plane,
    found: Vec<Point>,
}

impl Points<'_> {
    /// Joins these bodies at a place. Points of one place are one where a body is on both, or where one is named as the
    /// other.
    fn put(&mut self, at: Vector, bodies: &[Option<usize>], name: &str) {
        let place = self.plane.place(at);
        let short = name.rsplit_once('.').map_or(name, |(_, short)| short);
        let is_joint = |name: &str| self.model.bodies.iter().any(|body| body.joint.name == name);
        let name = if is_joint(name) {
            format!("{}_pin", name.replace('.', "_"))
        } else {
            short.to_string()
        };
        let is_it = |point: &Point| {
            let near =
                (point.at[0] - place[0]).hypot(point.at[1] - place[1]) <= 1e-9 * self.plane.size;
            near && (point.name == name || bodies.iter().any(|body| point.on.contains(body)))
        };
        let same: Vec<usize> =
            (0..self.found.len()).filter(|&nth| is_it(&self.found[nth])).collect();
        let Some((&first, others)) = same.split_first() else {
            let mut point = Point { name, at: place, on: Vec::new() };
            add(&mut point.on, bodies);
            return self.found.push(point);
        };
        for &other in others.iter().rev() {
            let merged = self.found.remove(other);
            add(&mut self.found[first].on, &merged.on);
        }
        add(&mut self.found[first].on, bodies);
    }
}

fn add(to: &mut Vec<Option<usize>>, bodies: &[Option<usize>]) {
    for body in bodies {
        if !to.contains(body) {
            to.push(*body);
        }
    }
}
