//! The bodies of a model in space, in the pose that it is written in.

use super::super::Mistake;
use super::classes::Classes;
use super::space::{Frame, Turn, Vector, cross, dot, unit};
use super::xml::Element;

/// A joint between a body and its parent.
#[derive(Clone, Debug)]
pub(super) struct Joint {
    pub name: String,
    pub is_slide: bool,
    pub anchor: Vector,
    pub axis: Vector,
    /// Its number in the pose.
    pub reference: f64,
    pub stiffness: f64,
    pub damping: f64,
    pub slack: f64,
    pub armature: f64,
    pub has_range: bool,
}

/// A mass: its centre, and its inertia about an axis.
#[derive(Clone, Debug)]
pub(super) struct Inertial {
    pub mass: f64,
    pub at: Vector,
    /// The inertia about axes of the world.
    pub inertia: [Vector; 3],
}

/// A body that moves.
#[derive(Clone, Debug)]
pub(super) struct Body {
    pub name: String,
    pub parent: Option<usize>,
    pub joint: Joint,
    pub inertials: Vec<Inertial>,
    pub sites: Vec<(String, Vector)>,
}

/// All of a model that a drawing can have.
pub(super) struct Model {
    pub name: String,
    pub bodies: Vec<Body>,
    /// Sites of what does not move.
    pub sites: Vec<(String, Vector)>,
    pub gravity: Vector,
    pub equalities: Vec<Element>,
    pub tendons: Vec<Element>,
    pub actuators: Vec<Element>,
    pub left_out: Vec<String>,
    /// The frames of all named bodies, and the moving body that each is part of.
    pub frames: Vec<(String, Frame, Option<usize>)>,
    in_degrees: bool,
    classes: Classes,
}

/// Masses below are those that MuJoCo asks for of a body without mass.
const LEAST: f64 = 2e-12;

impl Model {
    pub(super) fn read(root: &Element) -> Result<Self, Mistake> {
        let compiler = root.all("compiler").last();
        let option = |name: &str| compiler.and_then(|compiler| compiler.attribute(name));
        let classes = Classes::of(root);
        let gravity = root.all("option").last();
        let gravity = gravity.map_or(Ok(GRAVITY), |option| option.list("gravity", GRAVITY))?;
        let listed = |list: &str| -> Vec<Element> {
            let all = root.all(list).flat_map(|list| &list.children);
            all.map(|element| classes.complete(element, None)).collect()
        };
        let mut model = Self {
            name: root.attribute("model").unwrap_or("Machine").to_string(),
            bodies: Vec::new(),
            sites: Vec::new(),
            gravity,
            equalities: listed("equality"),
            tendons: listed("tendon"),
            actuators: listed("actuator"),
            left_out: Vec::new(),
            frames: Vec::new(),
            in_degrees: option("angle") != Some("radian"),
            classes: Classes::of(root),
        };
        if option("eulerseq").is_some_and(|order| order != "xyz") {
            return Err("turns by `euler` are read in the order xyz alone".to_string());
        }
        if option("coordinate") == Some("global") {
            return Err("coordinates of the world are no longer MuJoCo's".to_string());
        }
        let world = root.all("worldbody").next().ok_or("there is no `worldbody`")?;
        model.parts(world, Frame::WORLD, None, None)?;
        Ok(model)
    }

    /// An angle in radians.
    fn angle(&self, angle: f64) -> f64 {
        if self.in_degrees { angle.to_radians() } else { angle }
    }

    /// Reads the content of a body that is part of this moving one, or of the world.
    fn parts(
        &mut self,
        of: &Element,
        frame: Frame,
        moving: Option<usize>,
        class: Option<&str>,
    ) -> Result<(), Mistake> {
        for child in &of.children {
            match &child.name[..] {
                "body" => self.body(child, frame, moving, class)?,
                "site" => {
                    let site = self.classes.complete(child, class);
                    if let Some(name) = site.attribute("name") {
                        let at = frame.place(site.list("pos", [0.0; 3])?);
                        let site = (name.to_string(), at);
                        match moving {
                            Some(body) => self.bodies[body].sites.push(site),
                            None => self.sites.push(site),
                        }
                    }
                }
                "inertial" => {
                    let inertial = self.inertial(child, frame)?;
                    if let (Some(body), true) = (moving, inertial.mass > LEAST) {
                        self.bodies[body].inertials.push(inertial);
                    }
                }
                "frame" | "replicate" | "include" | "attach" | "composite" | "flexcomp" => {
                    return Err(format!(
                        "`{}` in a body is not read: write out its bodies",
                        child.name
                    ));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn body(
        &mut self,
        of: &Element,
        around: Frame,
        parent: Option<usize>,
        class: Option<&str>,
    ) -> Result<(), Mistake> {
        let name = of.attribute("name").unwrap_or("body").to_string();
        let frame = around.then(Frame { at: of.list("pos", [0.0; 3])?, turn: self.turn(of)? });
        let class = of.attribute("childclass").or(class);
        if of.all("freejoint").next().is_some() {
            return Err(format!("`{name}` moves freely, and not in a plane"));
        }
        let joints: Vec<_> = of.all("joint").collect();
        let moving = match joints[..] {
            [] => parent,
            [joint] => {
                let joint = self.joint(&self.classes.complete(joint, class), frame, &name)?;
                let (inertials, sites) = (Vec::new(), Vec::new());
                self.bodies.push(Body { name: name.clone(), parent, joint, inertials, sites });
                Some(self.bodies.len() - 1)
            }
            _ => return Err(format!("`{name}` has several joints, and is one link")),
        };
        if of.all("inertial").next().is_none() && of.all("geom").next().is_some() {
            self.left_out.push(format!("the mass of {name}, which follows from its shapes"));
        }
        self.frames.push((name, frame, moving));
        self.parts(of, frame, moving, class)
    }

    fn turn(&self, of: &Element) -> Result<Turn, Mistake> {
        let axis =
            |axis: Vector| unit(axis).ok_or_else(|| format!("an axis of `{}` is zero", of.name));
        if of.attribute("quat").is_some() {
            return Ok(Turn::of_quaternion(of.list("quat", [1.0, 0.0, 0.0, 0.0])?));
        }
        if of.attribute("euler").is_some() {
            let [x, y, z] = of.list("euler", [0.0; 3])?.map(|angle| self.angle(angle));
            let [a, b, c] = Turn::NONE.0;
            return Ok(Turn::about(a, x).then(Turn::about(b, y)).then(Turn::about(c, z)));
        }
        if of.attribute("axisangle").is_some() {
            let [x, y, z, angle] = of.list("axisangle", [0.0; 4])?;
            return Ok(Turn::about(axis([x, y, z])?, self.angle(angle)));
        }
        if of.attribute("xyaxes").is_some() {
            let [a, b, c, x, y, z] = of.list("xyaxes", [0.0; 6])?;
            let first = axis([a, b, c])?;
            let along = dot(first, [x, y, z]);
            let second = axis([x - along * first[0], y - along * first[1], z - along * first[2]])?;
            return Ok(Turn::of_axes(first, second, cross(first, second)));
        }
        if of.attribute("zaxis").is_some() {
            return Err(format!("`zaxis` of `{}` is not read: write `quat`", of.name));
        }
        Ok(Turn::NONE)
    }

    fn joint(&self, of: &Element, frame: Frame, body: &str) -> Result<Joint, Mistake> {
        let kind = of.attribute("type").unwrap_or("hinge");
        if !["hinge", "slide"].contains(&kind) {
            return Err(format!("the joint of `{body}` is a `{kind}`, which moves in no plane"));
        }
        let is_slide = kind == "slide";
        let axis = unit(frame.turn.of(of.list("axis", [0.0, 0.0, 1.0])?));
        let number = |name: &str| -> Result<f64, Mistake> {
            Ok(of.numbers(name)?.and_then(|list| list.first().copied()).unwrap_or(0.0))
        };
        let place = |name: &str| -> Result<f64, Mistake> {
            let number = number(name)?;
            Ok(if is_slide { number } else { self.angle(number) })
        };
        Ok(Joint {
            name: of.attribute("name").map_or_else(|| format!("{body}.joint"), str::to_string),
            is_slide,
            anchor: frame.place(of.list("pos", [0.0; 3])?),
            axis: axis.ok_or_else(|| format!("the axis of the joint of `{body}` is zero"))?,
            reference: place("ref")?,
            stiffness: number("stiffness")?,
            damping: number("damping")?,
            slack: place("springref")?,
            armature: number("armature")?,
            has_range: of.attribute("range").is_some(),
        })
    }

    fn inertial(&self, of: &Element, frame: Frame) -> Result<Inertial, Mistake> {
        let own = frame.then(Frame { at: of.list("pos", [0.0; 3])?, turn: self.turn(of)? });
        let mass = of.list("mass", [0.0])?[0];
        let [xx, yy, zz, xy, xz, yz] = match of.attribute("fullinertia") {
            Some(_) => of.list("fullinertia", [0.0; 6])?,
            None => {
                let [x, y, z] = of.list("diaginertia", [0.0; 3])?;
                [x, y, z, 0.0, 0.0, 0.0]
            }
        };
        let inertia = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        Ok(Inertial { mass, at: own.at, inertia: turned(inertia, own.turn) })
    }

    pub(super) fn body_of_joint(&self, name: &str) -> Option<usize> {
        self.bodies.iter().position(|body| body.joint.name == name)
    }

    /// A site, and the moving body that it is on.
    pub(super) fn site(&self, name: &str) -> Option<(Vector, Option<usize>)> {
        let on_bodies =
            self.bodies.iter().enumerate().flat_map(|(nth, body)| {
                body.sites.iter().map(move |(own, at)| (own, *at, Some(nth)))
            });
        let all = self.sites.iter().map(|(own, at)| (own, *at, None)).chain(on_bodies);
        all.into_iter().find(|(own, ..)| *own == name).map(|(_, at, body)| (at, body))
    }
}

/// MuJoCo's.
const GRAVITY: Vector = [0.0, 0.0, -9.81];

/// R I Rᵀ
fn turned(inertia: [Vector; 3], turn: Turn) -> [Vector; 3] {
    let columns = [0, 1, 2].map(|column| turn.of(inertia.map(|row| row[column])));
    let half: [Vector; 3] = [0, 1, 2].map(|row| [0, 1, 2].map(|column| columns[column][row]));
    half.map(|row| turn.of(row))
}
