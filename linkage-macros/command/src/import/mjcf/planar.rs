//! A model whose bodies move in one plane, as a drawing.

use super::super::Mistake;
use super::super::drawing::{
    Angle, Drawing, Drive, Guide, Line, Link, Mass, Pin, Quantity, Spring,
};
use super::model::Model;
use super::pins::{Point, points};
use super::space::{Vector, cross, dot, unit};
use super::xml::Element;

/// The plane in which bodies move, by its axes, and the largest distance in it.
pub(super) struct Plane {
    x: Vector,
    y: Vector,
    /// About which angles are counter-clockwise.
    normal: Vector,
    pub size: f64,
}

/// The sine of the angle that axes of one direction may differ by.
const APART: f64 = 1e-6;

impl Plane {
    /// # Errors
    /// Hinges about axes that differ, slides that leave the plane, and a model without hinges.
    fn of(model: &Model) -> Result<Self, Mistake> {
        let mut hinges = model.bodies.iter().filter(|body| !body.joint.is_slide);
        let first = hinges.next().ok_or("there is no hinge, by which a plane would be known")?;
        for other in hinges {
            let sine = cross(first.joint.axis, other.joint.axis);
            if dot(sine, sine).sqrt() > APART {
                return Err(format!(
                    "the axes of `{}` and `{}` differ",
                    first.joint.name, other.joint.name
                ));
            }
        }
        if let Some(slide) = model.bodies.iter().find(|body| {
            body.joint.is_slide && dot(body.joint.axis, first.joint.axis).abs() > APART
        }) {
            return Err(format!("`{}` slides out of the plane of the hinges", slide.joint.name));
        }
        let (x, y, normal) = axes(first.joint.axis);
        let mut plane = Self { x, y, normal, size: 0.0 };
        let anchors: Vec<_> =
            model.bodies.iter().map(|body| plane.place(body.joint.anchor)).collect();
        let pairs = anchors.iter().flat_map(|p| anchors.iter().map(move |q| (p, q)));
        plane.size = pairs.map(|(p, q)| (p[0] - q[0]).hypot(p[1] - q[1])).fold(1e-3, f64::max);
        Ok(plane)
    }

    pub(super) fn place(&self, at: Vector) -> [f64; 2] {
        self.seen(at).map(rounded)
    }

    /// The place without rounding, of what is written in another frame.
    fn seen(&self, at: Vector) -> [f64; 2] {
        [self.x, self.y].map(|axis| dot(axis, at))
    }

    /// 1 of an axis about which angles are counter-clockwise, or −1.
    fn sign(&self, axis: Vector) -> f64 {
        if dot(axis, self.normal) > 0.0 { 1.0 } else { -1.0 }
    }
}

/// The plane across an axis as it is drawn: x to the right and z up, or x and y, or y and z.
fn axes(axis: Vector) -> (Vector, Vector, Vector) {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let is_along = |other: Vector| dot(axis, other).abs() > 1.0 - APART * APART;
    match () {
        () if is_along(y) => (x, z, [0.0, -1.0, 0.0]),
        () if is_along(z) => (x, y, z),
        () if is_along(x) => (y, z, x),
        () => {
            let up = [0, 1, 2].map(|part| z[part] - axis[2] * axis[part]);
            let up = unit(up).unwrap_or(y);
            (cross(up, axis), up, axis)
        }
    }
}

/// A number to twelve decimals.
fn rounded(number: f64) -> f64 {
    format!("{number:.12}").parse::<f64>().unwrap_or(number) + 0.0
}

pub(super) fn drawing(model: &Model) -> Result<Drawing, Mistake> {
    let plane = Plane::of(model)?;
    let points = points(model, &plane)?;
    let mut reader = Reader { model, plane, points, drawing: Drawing::new(&model.name, "m") };
    reader.drawing.left_out.clone_from(&model.left_out);
    reader.pins();
    reader.links();
    reader.actuated()?;
    reader.coupled()?;
    reader.held_by_springs();
    reader.masses();
    reader.springs()?;
    Ok(reader.drawing)
}

struct Reader<'m> {
    model: &'m Model,
    plane: Plane,
    points: Vec<Point>,
    drawing: Drawing,
}

impl Reader<'_> {
    fn pins(&mut self) {
        for point in &self.points {
            let is_ground = point.on.contains(&None);
            let pin = Pin { id: point.name.clone(), at: point.at, is_ground };
            self.drawing.pins.push(pin);
        }
    }

    fn name(&self, body: usize) -> String {
        self.model.bodies[body].name.clone()
    }

    fn links(&mut self) {
        let model = self.model;
        for (nth, body) in model.bodies.iter().enumerate() {
            let mut link = Link { id: body.name.clone(), pins: self.pins_of(nth), on: Vec::new() };
            if body.joint.is_slide {
                let guide = format!("{}_guide", body.name);
                let axis = [self.plane.x, self.plane.y].map(|axis| dot(axis, body.joint.axis));
                let first = self.points.iter().find(|point| point.on.contains(&Some(nth)));
                let [x, y] =
                    first.map_or_else(|| self.plane.place(body.joint.anchor), |point| point.at);
                let [right, up] = axis.map(|part| part * body.joint.reference);
                let angle = Angle::Radians(rounded(axis[1].atan2(axis[0])));
                let through = [rounded(x - right), rounded(y - up)];
                let on = body.parent.map(|parent| self.name(parent));
                let line = Line::Along { through, angle };
                self.drawing.guides.push(Guide { id: guide.clone(), on, line });
                link.on.push(guide);
            }
            if body.joint.has_range {
                self.drawing.left_out.push(format!("the range of {}", body.joint.name));
            }
            self.drawing.links.push(link);
        }
    }

    /// The points of a body, those of its sites in their order first.
    fn pins_of(&self, body: usize) -> Vec<String> {
        let own = || self.points.iter().filter(move |point| point.on.contains(&Some(body)));
        let sites = self.model.bodies[body].sites.iter();
        let of_sites = sites.filter_map(|(name, _)| {
            let short = name.rsplit_once('.')?.1;
            own().find(|point| point.name == short)
        });
        let mut pins: Vec<String> = Vec::new();
        for point in of_sites.chain(own()) {
            if !pins.contains(&point.name) {
                pins.push(point.name.clone());
            }
        }
        pins
    }

    /// The quantity that a joint's number is, and its factor.
    fn of_joint(&self, body: usize) -> (Quantity, f64) {
        let own = &self.model.bodies[body];
        if own.joint.is_slide {
            return (Quantity::Slide(own.name.clone()), 1.0);
        }
        // A link that slides does not turn against its guide.
        let mut parent = own.parent;
        while let Some(above) = parent.filter(|&above| self.model.bodies[above].joint.is_slide) {
            parent = self.model.bodies[above].parent;
        }
        let against = parent.map(|parent| self.name(parent));
        (Quantity::Angle(own.name.clone(), against), self.plane.sign(own.joint.axis))
    }

    /// The quantities that actuators move.
    fn actuated(&mut self) -> Result<(), Mistake> {
        let mut seen = Vec::new();
        for actuator in &self.model.actuators {
            let Some((of, factor)) = self.of_actuator(actuator)? else { continue };
            if seen.contains(&of) {
                continue;
            }
            let gear = actuator.numbers("gear")?.unwrap_or_default();
            // The gear of a site is a direction.
            let gear = match actuator.attribute("site") {
                None => gear.first().copied().filter(|gear| *gear != 0.0).unwrap_or(1.0),
                Some(_) => 1.0,
            };
            let input = actuator.attribute("name").unwrap_or("q").to_string();
            seen.push(of.clone());
            self.drawing.drives.push(Drive::Input { input, of, factor: factor * gear });
        }
        Ok(())
    }

    fn of_actuator(&self, actuator: &Element) -> Result<Option<(Quantity, f64)>, Mistake> {
        let name = actuator.attribute("name").unwrap_or(&actuator.name);
        if let Some(joint) = actuator.attribute("joint") {
            let body = self.model.body_of_joint(joint);
            return body
                .map(|body| Some(self.of_joint(body)))
                .ok_or_else(|| format!("`{name}` moves no joint `{joint}`"));
        }
        if let Some(tendon) = actuator.attribute("tendon") {
            let found = self.model.tendons.iter().find(|own| own.attribute("name") == Some(tendon));
            let found = found.ok_or_else(|| format!("`{name}` moves no tendon `{tendon}`"))?;
            return self.of_tendon(found).map(Some);
        }
        if let (Some(site), Some(_)) = (actuator.attribute("site"), actuator.attribute("refsite")) {
            let point = self.point_of_site(site)?;
            let gear = actuator.list("gear", [1.0, 0.0, 0.0, 0.0, 0.0, 0.0])?;
            return match gear {
                [factor, 0.0, 0.0, 0.0, 0.0, 0.0] => Ok(Some((Quantity::Place(point, 0), factor))),
                [0.0, factor, 0.0, 0.0, 0.0, 0.0] => Ok(Some((Quantity::Place(point, 1), factor))),
                _ => Err(format!("`{name}` moves a site along no axis")),
            };
        }
        Err(format!("`{name}` moves neither a joint nor a tendon"))
    }

    fn point_of_site(&self, site: &str) -> Result<String, Mistake> {
        let (at, body) =
            self.model.site(site).ok_or_else(|| format!("there is no site `{site}`"))?;
        let at = self.plane.place(at);
        let is_it = |point: &&Point| {
            point.on.contains(&body)
                && (point.at[0] - at[0]).hypot(point.at[1] - at[1]) <= 1e-9 * self.plane.size
        };
        let point = self.points.iter().find(is_it).map(|point| point.name.clone());
        point.ok_or_else(|| format!("`{site}` is no joint: name it after its body, `BODY.{site}`"))
    }

    fn of_tendon(&self, tendon: &Element) -> Result<(Quantity, f64), Mistake> {
        let name = tendon.attribute("name").unwrap_or("a tendon");
        if tendon.name == "spatial" {
            let sites: Vec<_> = tendon.children.iter().collect();
            let [first, second] = sites[..] else {
                return Err(format!("`{name}` goes through other than two sites"));
            };
            let ends = [first, second].map(|site| match site.attribute("site") {
                Some(site) if sites.iter().all(|part| part.name == "site") => {
                    self.point_of_site(site)
                }
                _ => Err(format!("`{name}` goes round something")),
            });
            let [from, to] = ends;
            return Ok((Quantity::Distance([from?, to?]), 1.0));
        }
        let mut bodies = Vec::new();
        for part in &tendon.children {
            let body = part.attribute("joint").and_then(|joint| self.model.body_of_joint(joint));
            let coefficient = part.list("coef", [1.0])?[0];
            match body {
                Some(body)
                    if coefficient == self.plane.sign(self.model.bodies[body].joint.axis) =>
                {
                    bodies.push(body)
                }
                _ => return Err(format!("`{name}` is no angle between two bodies")),
            }
        }
        // Joints of one chain: the outermost against what the innermost hangs on.
        let mut outer = bodies.iter().copied().filter(|&body| {
            !bodies.iter().any(|&other| self.model.bodies[other].parent == Some(body))
        });
        let inner = bodies.iter().copied().find(|&body| {
            self.model.bodies[body].parent.is_none_or(|parent| !bodies.contains(&parent))
        });
        match (outer.next(), outer.next(), inner) {
            (Some(outer), None, Some(inner)) => {
                let against = self.model.bodies[inner].parent.map(|parent| self.name(parent));
                Ok((Quantity::Angle(self.name(outer), against), 1.0))
            }
            _ => Err(format!("`{name}` is no angle between two bodies")),
        }
    }

    /// Joints of which one follows another.
    fn coupled(&mut self) -> Result<(), Mistake> {
        for tie in self.model.equalities.iter().filter(|tie| tie.name != "connect") {
            let name = tie.attribute("name").unwrap_or(&tie.name);
            let (Some(own), Some(other), "joint") =
                (tie.attribute("joint1"), tie.attribute("joint2"), &tie.name[..])
            else {
                return Err(format!("`{name}` ties other than a pin or two joints"));
            };
            let joint = |name: &str| {
                self.model.body_of_joint(name).ok_or_else(|| format!("there is no joint `{name}`"))
            };
            let (own, other) = (joint(own)?, joint(other)?);
            let terms = tie.numbers("polycoef")?.unwrap_or_else(|| vec![0.0, 1.0]);
            if terms.iter().skip(2).any(|term| *term != 0.0) {
                return Err(format!("`{name}` is a polynomial over degree one"));
            }
            let term = |nth: usize| terms.get(nth).copied().unwrap_or(0.0);
            let ((of, own_factor), (by, factor)) = (self.of_joint(own), self.of_joint(other));
            let references = [own, other].map(|body| self.model.bodies[body].joint.reference);
            // y = y₀ + a₀ + a₁ (x − x₀), of numbers that are factors times quantities.
            let constant = references[0] + term(0) - term(1) * references[1];
            self.drawing.drives.push(Drive::Coupled {
                of,
                by,
                factor: term(1) * factor * own_factor,
                constant: constant * own_factor,
            });
        }
        Ok(())
    }

    /// Joints that a spring holds are inputs where freedoms have none: each joint is one, and each loop takes two.
    fn held_by_springs(&mut self) {
        let ties = self.model.equalities.iter().filter(|tie| tie.name == "connect").count();
        let mut free = self.model.bodies.len().saturating_sub(2 * ties + self.drawing.drives.len());
        for (nth, body) in self.model.bodies.iter().enumerate() {
            if free == 0 || body.joint.stiffness <= 0.0 {
                continue;
            }
            let (of, factor) = self.of_joint(nth);
            let is_it =
                |drive: &Drive| matches!(drive, Drive::Input { of: other, .. } if *other == of);
            if !self.drawing.drives.iter().any(is_it) {
                let input = body.joint.name.clone();
                self.drawing.drives.push(Drive::Input { input, of, factor });
                free -= 1;
            }
        }
    }

    fn masses(&mut self) {
        let model = self.model;
        let normal = self.plane.normal;
        for body in &model.bodies {
            for inertial in &body.inertials {
                let inertia = dot(normal, inertial.inertia.map(|row| dot(row, normal)));
                self.drawing.masses.push(Mass {
                    link: body.name.clone(),
                    value: inertial.mass,
                    unit: "kg",
                    at: self.plane.seen(inertial.at),
                    inertia,
                    unit_of_inertia: "kg*m^2",
                });
            }
            if body.joint.armature > 0.0 && !body.joint.is_slide && body.parent.is_none() {
                self.drawing.rotors.push((body.name.clone(), body.joint.armature));
            }
        }
        let gravity = [self.plane.x, self.plane.y].map(|axis| rounded(dot(axis, model.gravity)));
        let has_mass = !self.drawing.masses.is_empty();
        self.drawing.gravity = (has_mass && gravity != [0.0; 2]).then_some(gravity);
    }

    fn springs(&mut self) -> Result<(), Mistake> {
        for (nth, body) in self.model.bodies.iter().enumerate() {
            let joint = &body.joint;
            if joint.stiffness <= 0.0 && joint.damping <= 0.0 {
                continue;
            }
            match self.of_joint(nth) {
                (Quantity::Angle(own, against), sign) => self.drawing.springs.push(Spring {
                    of: Quantity::Angle(own, against),
                    stiffness: joint.stiffness,
                    damping: joint.damping,
                    slack: sign * joint.slack + 0.0,
                }),
                _ => self.drawing.left_out.push(format!("the spring along {}", joint.name)),
            }
        }
        for tendon in &self.model.tendons {
            let number = |name: &str| -> Result<f64, Mistake> {
                Ok(tendon.numbers(name)?.and_then(|list| list.first().copied()).unwrap_or(0.0))
            };
            let (stiffness, damping, slack) =
                (number("stiffness")?, number("damping")?, number("springlength")?);
            if stiffness > 0.0 || damping > 0.0 {
                let (of, _) = self.of_tendon(tendon)?;
                self.drawing.springs.push(Spring { of, stiffness, damping, slack });
            }
        }
        Ok(())
    }
}
