//! Bodies on joints: slides first, then pins from the ground outwards, so that every loop closes at a pin.

use std::collections::VecDeque;
use std::f64::consts::TAU;

use linkage_compiler::{PlanarBodies, PlanarBody};

/// A body's joint to the body that it hangs on.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Joint {
    /// About a pin.
    Hinge(String),
    /// Along a guide.
    Slide(usize),
}

/// A body in the tree; the ground is no body.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub body: usize,
    pub parent: Option<usize>,
    pub joint: Joint,
}

/// A pin at which a loop closes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Closure {
    pub pin: String,
    pub body: usize,
    /// The other body; the ground where there is none.
    pub other: Option<usize>,
}

/// A drawing as a tree.
pub(super) struct Machine {
    pub parts: PlanarBodies,
    /// In an order in which what a body hangs on comes before it.
    pub nodes: Vec<Node>,
    pub closures: Vec<Closure>,
}

impl Machine {
    /// # Errors
    /// Bodies that nothing holds, and loops that close at a guide.
    pub(super) fn of(parts: PlanarBodies) -> Result<Self, String> {
        let mut machine = Self { parts, nodes: Vec::new(), closures: Vec::new() };
        machine.hang()?;
        machine.close();
        Ok(machine)
    }

    pub(super) fn body(&self, body: usize) -> &PlanarBody {
        &self.parts.bodies[body]
    }

    pub(super) fn named(&self, name: &str) -> Option<usize> {
        self.parts.bodies.iter().position(|body| body.name == name)
    }

    pub(super) fn node(&self, body: usize) -> Option<&Node> {
        self.nodes.iter().find(|node| node.body == body)
    }

    fn is_placed(&self, body: usize) -> bool {
        self.body(body).is_cylinder || self.node(body).is_some()
    }

    fn hang(&mut self) -> Result<(), String> {
        let mut front = VecDeque::new();
        self.slide_on(None, &mut front)?;
        front.push_front(None);
        while let Some(parent) = front.pop_front() {
            let pins: Vec<String> = match parent {
                Some(body) => self.body(body).pins.iter().map(|(pin, _)| pin.clone()).collect(),
                None => self.parts.ground.iter().map(|(pin, _)| pin.clone()).collect(),
            };
            for pin in pins {
                for body in 0..self.parts.bodies.len() {
                    let own = self.body(body);
                    let is_here = own.pins.iter().any(|(other, _)| *other == pin);
                    if is_here && own.on.is_empty() && !self.is_placed(body) {
                        self.nodes.push(Node { body, parent, joint: Joint::Hinge(pin.clone()) });
                        self.slide_on(Some(body), &mut front)?;
                        front.push_back(Some(body));
                    }
                }
            }
        }
        match (0..self.parts.bodies.len()).find(|&body| !self.is_placed(body)) {
            None => Ok(()),
            Some(body) => Err(format!("nothing holds `{}`", self.body(body).name)),
        }
    }

    /// Hangs what slides on the guides of a body, or of the ground.
    fn slide_on(
        &mut self,
        carrier: Option<usize>,
        front: &mut VecDeque<Option<usize>>,
    ) -> Result<(), String> {
        for body in 0..self.parts.bodies.len() {
            let own = self.body(body);
            let [guide] = own.on[..] else {
                if own.on.len() > 1 {
                    return Err(format!("`{}` slides on two guides", own.name));
                }
                continue;
            };
            if self.parts.guides[guide].on == carrier && !self.is_placed(body) {
                self.nodes.push(Node { body, parent: carrier, joint: Joint::Slide(guide) });
                front.push_back(Some(body));
            }
        }
        Ok(())
    }

    /// At each pin all bodies hang on one another; those that do not by the tree are tied.
    fn close(&mut self) {
        let grounded: Vec<String> = self.parts.ground.iter().map(|(pin, _)| pin.clone()).collect();
        let mut pins = grounded.clone();
        for (pin, _) in self.parts.bodies.iter().flat_map(|body| &body.pins) {
            if !pins.contains(pin) {
                pins.push(pin.clone());
            }
        }
        for pin in pins {
            let through = (0..self.parts.bodies.len()).filter(|&body| {
                let own = self.body(body);
                !own.is_cylinder && own.pins.iter().any(|(other, _)| *other == pin)
            });
            let through: Vec<usize> = through.collect();
            let mut groups: Vec<Vec<Option<usize>>> =
                through.iter().map(|&body| vec![Some(body)]).collect();
            groups.extend(grounded.contains(&pin).then(|| vec![None]));
            for &body in &through {
                let Some(Node { parent, joint: Joint::Hinge(at), .. }) = self.node(body) else {
                    continue;
                };
                let of =
                    |wanted: Option<usize>| groups.iter().position(|group| group.contains(&wanted));
                if let (true, Some(own), Some(other)) = (*at == pin, of(Some(body)), of(*parent))
                    && own != other
                {
                    let mut merged = groups.remove(own.max(other));
                    groups[own.min(other)].append(&mut merged);
                }
            }
            let mut groups = groups.into_iter();
            let Some(first) = groups.next() else { continue };
            for extra in groups {
                let closure = match (first[0], extra[0]) {
                    (Some(body), other) | (other, Some(body)) => {
                        Closure { pin: pin.clone(), body, other }
                    }
                    (None, None) => continue,
                };
                self.closures.push(closure);
            }
        }
    }

    /// A place of the drawing in the frame of a body; the ground's is the drawing's.
    pub(super) fn local(&self, body: Option<usize>, [x, y]: [f64; 2]) -> [f64; 2] {
        let Some(body) = body else { return [x, y] };
        let ([left, low], angle) = self.body(body).frame;
        let (sin, cos) = angle.sin_cos();
        [cos * (x - left) + sin * (y - low), cos * (y - low) - sin * (x - left)]
    }

    /// The angle of a body's frame against that of the body that it hangs on.
    pub(super) fn turn(&self, node: &Node) -> f64 {
        let turn = self.angle(Some(node.body)) - self.angle(node.parent);
        match node.parent {
            None => turn,
            Some(_) => turn - TAU * (turn / TAU).round(),
        }
    }

    fn angle(&self, body: Option<usize>) -> f64 {
        body.map_or(0.0, |body| self.body(body).frame.1)
    }

    /// The number of a joint in the drawing, which is the solver's.
    pub(super) fn drawn(&self, node: &Node) -> f64 {
        match node.joint {
            Joint::Hinge(_) => self.turn(node),
            Joint::Slide(guide) => {
                let guide = &self.parts.guides[guide];
                let ([x, y], _) = self.body(node.body).frame;
                let (sin, cos) = guide.along.sin_cos();
                (x - guide.through[0]) * cos + (y - guide.through[1]) * sin
            }
        }
    }

    pub(super) fn joint_name(&self, node: &Node) -> String {
        let kind = match node.joint {
            Joint::Hinge(_) => "angle",
            Joint::Slide(_) => "slide",
        };
        format!("{}.{kind}", self.body(node.body).name)
    }

    /// The largest distance of two points.
    pub(super) fn size(&self) -> f64 {
        let points: Vec<[f64; 2]> = self.points().map(|(_, at)| *at).collect();
        let pairs = points.iter().flat_map(|p| points.iter().map(move |q| (p, q)));
        pairs.map(|(p, q)| (p[0] - q[0]).hypot(p[1] - q[1])).fold(0.0, f64::max)
    }

    pub(super) fn points(&self) -> impl Iterator<Item = &(String, [f64; 2])> {
        self.parts.ground.iter().chain(self.parts.bodies.iter().flat_map(|body| &body.pins))
    }

    /// The site of a point: on the first body that holds it, or on the ground.
    pub(super) fn site(&self, pin: &str) -> Option<String> {
        let holds = |body: &&PlanarBody| {
            !body.is_cylinder && body.pins.iter().any(|(other, _)| other == pin)
        };
        let body = self.parts.bodies.iter().find(holds).map(|body| format!("{}.{pin}", body.name));
        let ground = self.parts.ground.iter().find(|(other, _)| other == pin);
        ground.map(|_| format!("ground.{pin}")).or(body)
    }
}
