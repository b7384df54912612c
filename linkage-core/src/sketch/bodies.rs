//! Rigid bodies: the shape of every link in its own frame, and its pose in each frame of the film.

use std::vec;
use std::vec::Vec;

use super::member::{LinkShape, Member};
use super::plan::Element;
use super::scene::{Pose, Scene};
use super::shapes::{Shape, skeleton, turned};
use super::style::{BLOCK, OVERRUN};
use super::svg::{Transform, View};

/// A rigid body.
#[derive(Clone, Debug)]
pub(super) struct Body {
    /// The link that it is a part of.
    pub link: Option<usize>,
    pub shapes: Vec<Shape>,
    pub seats: Vec<Option<Transform>>,
    /// The points that stand still on it, in its own pixels.
    pub carries: Vec<(usize, [f64; 2])>,
}

impl Body {
    /// Lines that stand for it, on the page.
    pub(super) fn lines(&self, frame: usize) -> Vec<Vec<[f64; 2]>> {
        let Some(seat) = self.seats[frame] else { return Vec::new() };
        let lines = self.shapes.iter().map(Shape::line);
        lines.map(|line| line.into_iter().map(|spot| seat.place(spot)).collect()).collect()
    }
}

/// The data that every body is made from.
struct Maker<'s> {
    scene: &'s Scene,
    view: View,
    bodies: Vec<Body>,
}

/// Every body in the order of declaration.
pub(super) fn bodies(scene: &Scene, view: View) -> Vec<Body> {
    let mut maker = Maker { scene, view, bodies: Vec::new() };
    for (statement, &made) in scene.plan.statements.iter().enumerate() {
        maker.take(statement, made);
    }
    maker.take_the_rest();
    maker.bodies
}

impl Maker<'_> {
    fn seats(&self, pose: impl Fn(usize) -> Option<Pose>) -> Vec<Option<Transform>> {
        self.scene.frames().map(|frame| Some(self.view.seat(pose(frame)?))).collect()
    }

    fn push(&mut self, link: usize, shapes: Vec<Shape>, carries: Vec<(usize, [f64; 2])>) {
        let seats = self.seats(|frame| self.scene.link(frame, link));
        self.bodies.push(Body { link: Some(link), shapes, seats, carries });
    }

    /// A part of a link that moves against the rest of it.
    fn push_part(&mut self, link: usize, shapes: Vec<Shape>, pose: impl Fn(usize) -> Option<Pose>) {
        let seats = self.seats(pose);
        self.bodies.push(Body { link: Some(link), shapes, seats, carries: Vec::new() });
    }

    /// The points that stand still on a link.
    fn points(&self, link: usize) -> Vec<(usize, [f64; 2])> {
        let joints = self.scene.plan.statements.iter().flat_map(|made| made.joints());
        let own = joints.filter(|&(on, _)| on == link);
        own.filter_map(|(_, point)| {
            Some((point, self.view.local(self.scene.on_link(link, point)?)))
        })
        .collect()
    }

    /// Every link of a group, what slides in another one last.
    fn take(&mut self, statement: usize, made: Element) {
        let is_sleeve = |member: &Member| member.shape == LinkShape::Sleeve;
        let sleeve = made.members().map(|(_, member)| member).find(is_sleeve);
        let sleeve = sleeve.map(|member| member.link);
        for (nth, member) in made.members() {
            let link = member.link;
            match (member.shape, sleeve, made.point(), member.guide()) {
                (LinkShape::Bar, ..) => self.bar(link),
                (LinkShape::Cylinder, _, Some(pin), _) => self.cylinder(link, pin),
                (LinkShape::Body, ..) => self.body(link),
                (LinkShape::Block, .., Some(guide)) => self.block(link, guide, statement, nth),
                (LinkShape::SlottedBar, Some(block), ..) => {
                    self.slotted_bar(link, block, statement)
                }
                (LinkShape::Yoke, Some(block), ..) => self.yoke(link, block, statement),
                _ => {}
            }
        }
        if let Some(block) = sleeve {
            self.sleeve(block);
        }
    }

    fn bar(&mut self, link: usize) {
        let points = self.points(link);
        let mut shapes = skeleton(&points);
        self.add_guides(link, &mut shapes, &points);
        self.push(link, shapes, points);
    }

    /// A crank without a pin: what is on it, or a pointer.
    fn body(&mut self, link: usize) {
        let points = self.points(link);
        let mut shapes = skeleton(&points);
        self.add_guides(link, &mut shapes, &points);
        if shapes.is_empty() {
            shapes.push(Shape::Bar([[0.0, 0.0], [POINTER, 0.0]]));
        }
        self.push(link, shapes, points);
    }

    /// A bar of driven length: a tube about its outer joint and a rod at its pin.
    fn cylinder(&mut self, link: usize, pin: usize) {
        let scene = self.scene;
        let length = |frame| {
            let [x, y] = scene.link(frame, link)?.local(scene.point(frame, pin)?);
            Some(self.view.scale * x.hypot(y))
        };
        let reach = super::scene::range(scene.frames().map(length));
        let Some([shortest, longest]) = reach else { return };
        let stroke = longest - shortest;
        // A single pose does not tell the stroke.
        let tube = match scene.len() {
            1 => 0.64 * shortest,
            _ => shortest - 0.12 * stroke - GRIP,
        };
        let tube = tube.max(0.3 * shortest);
        let rod = (longest - tube + GRIP).min(0.95 * shortest);
        let mut points = self.points(link);
        points.retain(|&(point, _)| point != pin);
        let mut shapes = vec![Shape::Tube(tube)];
        if points.len() > 1 {
            shapes.extend(skeleton(&points));
        }
        self.push_part(link, vec![Shape::Rod(rod)], |frame| {
            Some(scene.link(frame, link)?.moved_to(scene.point(frame, pin)?))
        });
        if let Some(rod) = self.bodies.last_mut() {
            rod.carries = vec![(pin, [0.0, 0.0])];
        }
        self.push(link, shapes, points);
    }

    /// A block on a guide, whose pin may be beside it.
    fn block(&mut self, link: usize, guide: usize, statement: usize, nth: usize) {
        let scene = self.scene;
        let points = self.points(link);
        let mut shapes = if points.len() > 1 { skeleton(&points) } else { Vec::new() };
        self.add_guides(link, &mut shapes, &points);
        let on_guide = |frame| {
            let (pose, slide) = (scene.guide(frame, guide)?, scene.slide(frame, link)?);
            Some(pose.moved_to(pose.place([slide, 0.0])))
        };
        let offset = super::scene::range(
            scene.frames().map(|f| scene.link(f, link).map(|_| scene.dimension(f, statement, nth))),
        );
        let Some([least, most]) = offset else { return };
        if (most - least) * self.view.scale > 0.01 {
            self.push_part(link, vec![Shape::Block([0.0; 2])], on_guide);
        } else {
            let foot = self.view.local([0.0, -least]);
            if foot[1].abs() > BLOCK[1] / 2.0 {
                shapes.push(Shape::Stub([foot, [0.0; 2]]));
            }
            shapes.push(Shape::Block(foot));
        }
        self.push(link, shapes, points);
    }

    /// A block that slides on a bar or in a slot, at its pin.
    fn sleeve(&mut self, link: usize) {
        let points = self.points(link);
        let mut shapes = if points.len() > 1 { skeleton(&points) } else { Vec::new() };
        self.add_guides(link, &mut shapes, &points);
        shapes.push(Shape::Block([0.0; 2]));
        self.push(link, shapes, points);
    }

    /// The bar that a block slides on: as long as it goes.
    fn slotted_bar(&mut self, link: usize, block: usize, statement: usize) {
        let scene = self.scene;
        let (mut points, k) = (self.points(link), self.view.scale);
        let Some([least, most]) = scene.travel_of(block) else { return };
        let offset = scene.frames().find_map(|f| {
            scene.link(f, link)?;
            Some(scene.dimension(f, statement, 0))
        });
        let beside = -k * offset.unwrap_or(0.0);
        let ends = [[(k * least - OVERRUN).min(0.0), beside], [k * most + OVERRUN, beside]];
        let joints = points.clone();
        let is_aside = |spot: [f64; 2]| (spot[1] - beside).abs() > 1.0;
        let mut shapes = Vec::new();
        if is_aside([0.0; 2]) {
            shapes.push(Shape::Stub([[0.0; 2], [0.0, beside]]));
        }
        match joints.iter().any(|&(_, spot)| is_aside(spot) && spot != [0.0; 2]) {
            true => {
                shapes.extend(skeleton(&joints));
                shapes.push(Shape::Bar(ends));
            }
            false => {
                let on_bar = joints.iter().map(|&(_, [x, _])| x).filter(|&x| x != 0.0);
                let mut ends = ends;
                for x in on_bar {
                    ends[0][0] = ends[0][0].min(x);
                    ends[1][0] = ends[1][0].max(x);
                }
                if !is_aside([0.0; 2]) && k * least > OVERRUN {
                    ends[0][0] = ends[0][0].min(0.0);
                }
                shapes.push(Shape::Bar(ends));
            }
        }
        points.dedup_by_key(|point| point.0);
        self.add_guides(link, &mut shapes, &points);
        self.push(link, shapes, points);
    }

    /// A yoke: its block on the rail, the slot at an angle to it.
    fn yoke(&mut self, link: usize, block: usize, statement: usize) {
        let (scene, view) = (self.scene, self.view);
        let points = self.points(link);
        let mut shapes = Vec::new();
        if !points.is_empty() {
            let mut joints = points.clone();
            joints.push((usize::MAX, [0.0; 2]));
            shapes = skeleton(&joints);
        }
        let Some([least, most]) = scene.travel_of(block) else { return };
        let ends = [view.scale * least - OVERRUN, view.scale * most + OVERRUN];
        // The slot's origin: across the rail by one offset, across the slot by the other.
        let slot = |frame: usize| {
            let (yoke, along) = (scene.link(frame, link)?, scene.link(frame, block)?);
            let [first, second] = [0, 1].map(|nth| scene.dimension(frame, statement, nth));
            let along = along.moved_to(yoke.place([0.0, first]));
            Some(along.moved_to(along.place([0.0, second])))
        };
        let relative = |frame| Some(scene.link(frame, link)?.local_pose(slot(frame)?));
        let first = scene.frames().find_map(relative);
        let is_still = scene.frames().filter_map(relative).all(|pose| {
            first.is_some_and(|first| {
                let (dx, dy) = (pose.origin[0] - first.origin[0], pose.origin[1] - first.origin[1]);
                dx.hypot(dy) * view.scale < 0.01 && (pose.sin - first.sin).abs() < 1e-6
            })
        });
        match first.filter(|_| is_still) {
            Some(first) => {
                let seat = turned(view, first);
                let [start, end] = ends.map(|x| seat.place([x, 0.0]));
                let foot = view.local([0.0, scene.dimension(0, statement, 0)]);
                for stub in [[[0.0; 2], foot], [foot, seat.at]] {
                    if (stub[0][0] - stub[1][0]).hypot(stub[0][1] - stub[1][1]) > 3.0 {
                        shapes.push(Shape::Stub(stub));
                    }
                }
                // A slot that ends before it meets the yoke hangs on a stub of its own.
                let near = if ends[0] > 0.0 { start } else { end };
                if ends[0] > 0.0 || ends[1] < 0.0 {
                    shapes.push(Shape::Stub([seat.at, near]));
                }
                shapes.push(Shape::Bar([start, end]));
            }
            None => {
                let bar = Shape::Bar([[ends[0].min(0.0), 0.0], [ends[1].max(0.0), 0.0]]);
                self.push_part(link, vec![bar], slot);
            }
        }
        self.add_guides(link, &mut shapes, &points);
        shapes.push(Shape::Block([0.0; 2]));
        self.push(link, shapes, points);
    }

    /// The guides that lie still on a link, each tied to what is next to it.
    fn add_guides(&self, link: usize, shapes: &mut Vec<Shape>, points: &[(usize, [f64; 2])]) {
        for &made in self.scene.plan.statements {
            let Element::Guide(guide, Some(on)) = made else { continue };
            let lies = self.scene.guide_on_link(link, guide).filter(|_| on == link);
            let Some(lies) = lies else { continue };
            let seat = turned(self.view, lies);
            let ends = self.guide_ends(guide).map(|x| seat.place([x, 0.0]));
            let tie = nearest(ends, points);
            if let Some(tie) = tie {
                shapes.push(Shape::Stub(tie));
            }
            shapes.push(Shape::Bar(ends));
        }
    }

    fn guide_ends(&self, guide: usize) -> [f64; 2] {
        guide_ends(self.scene, self.view, guide)
    }

    /// Guides that move on their own, and points that stand still on nothing.
    fn take_the_rest(&mut self) {
        let scene = self.scene;
        for &made in scene.plan.statements {
            if let Element::Guide(guide, carrier) = made {
                let lies_still = match carrier {
                    Some(link) => scene.guide_on_link(link, guide).is_some(),
                    None => scene.still(guide).is_some(),
                };
                if !lies_still {
                    let [start, end] = self.guide_ends(guide);
                    let seats = self.seats(|frame| scene.guide(frame, guide));
                    let shapes = vec![Shape::Bar([[start, 0.0], [end, 0.0]])];
                    let body = Body { link: carrier, shapes, seats, carries: Vec::new() };
                    self.bodies.insert(0, body);
                }
            }
            let Some(point) = made.point().filter(|_| !matches!(made, Element::Ground(_))) else {
                continue;
            };
            let is_carried = |body: &Body| body.carries.iter().any(|&(own, _)| own == point);
            if !self.bodies.iter().any(is_carried) {
                let upright =
                    |frame| Some(Pose { origin: scene.point(frame, point)?, cos: 1.0, sin: 0.0 });
                let (seats, carries) = (self.seats(upright), vec![(point, [0.0; 2])]);
                self.bodies.push(Body { link: made.carrier(), shapes: Vec::new(), seats, carries });
            }
        }
    }
}

/// From where to where a guide is drawn, in pixels along it.
pub(super) fn guide_ends(scene: &Scene, view: View, guide: usize) -> [f64; 2] {
    match scene.travel(guide) {
        Some([least, most]) => [view.scale * least - OVERRUN, view.scale * most + OVERRUN],
        None => [-IDLE, IDLE],
    }
}

/// From the end of a line that is nearer to a point, to that point; nothing where one is on it.
fn nearest(ends: [[f64; 2]; 2], points: &[(usize, [f64; 2])]) -> Option<[[f64; 2]; 2]> {
    let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let foot = |spot: [f64; 2]| {
        let [a, b] = ends;
        let along = [b[0] - a[0], b[1] - a[1]];
        let square = along[0] * along[0] + along[1] * along[1];
        let share = ((spot[0] - a[0]) * along[0] + (spot[1] - a[1]) * along[1]) / square;
        let share = share.clamp(0.0, 1.0);
        [a[0] + share * along[0], a[1] + share * along[1]]
    };
    let origin = [(usize::MAX, [0.0; 2])];
    let points = if points.is_empty() { &origin[..] } else { points };
    let ties = points.iter().map(|&(_, spot)| [spot, foot(spot)]);
    let tie = ties.min_by(|a, b| distance(a[0], a[1]).total_cmp(&distance(b[0], b[1])))?;
    (distance(tie[0], tie[1]) > 2.0).then_some(tie)
}

/// The length of a rod that stays in its tube at full extension.
const GRIP: f64 = 10.0;
/// A body that nothing is on.
pub(super) const POINTER: f64 = 44.0;
/// Half of a guide that nothing slides on.
const IDLE: f64 = 50.0;
