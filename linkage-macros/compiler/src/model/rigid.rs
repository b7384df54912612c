//! Bodies that never move against each other: a group of constant dimensions whose outer joints all stand on one body is
//! rigid with it, and so is a driver whose angle or slide no input changes.

use super::acting::Contact;
use super::mechanism::{
    Carrier, Drive, Group, GuideDirection, GuideId, Joint, JointKind, Mechanism, PointId, Slideway,
    Step, Through,
};

/// Bodies by classes that are rigid in themselves: the ground, then link after link.
pub struct RigidBodies {
    class: Vec<usize>,
    /// Points that have a constant place in a body: a pin between two bars has one in both.
    points: Vec<(usize, PointId)>,
    guides: Vec<(usize, GuideId)>,
}

fn index(carrier: Carrier) -> usize {
    match carrier {
        Carrier::Ground => 0,
        Carrier::Link(link) => link.index() + 1,
    }
}

impl RigidBodies {
    pub fn of(mechanism: &Mechanism) -> Self {
        let class = (0..=mechanism.links.len()).collect();
        let mut bodies = Self { class, points: Vec::new(), guides: Vec::new() };
        for step in &mechanism.steps {
            bodies.take(mechanism, step);
        }
        bodies
    }

    /// True if the bodies of a contact never move against each other.
    pub fn hold(&self, mechanism: &Mechanism, contact: Contact) -> bool {
        let (link, other) = match contact {
            Contact::Pin { link, against, .. } => (link, Some(index(against))),
            Contact::Guide(link) => {
                let mut joints = mechanism.joints().filter(|joint| joint.link() == link);
                (link, joints.find_map(|joint| self.slid_on(joint)))
            }
        };
        other.is_some_and(|other| self.class[other] == self.class[index(Carrier::Link(link))])
    }

    /// The body that a joint's link slides on, where the line has a constant place in it.
    fn slid_on(&self, joint: &Joint) -> Option<usize> {
        match joint.slideway()? {
            Slideway::Guide(guide) => self.body_of(*guide),
            Slideway::Bar(link) | Slideway::Slot { link, .. } => Some(index(Carrier::Link(*link))),
        }
    }

    fn body_of(&self, asked: GuideId) -> Option<usize> {
        self.guides.iter().find(|(_, guide)| *guide == asked).map(|(body, _)| *body)
    }

    fn take(&mut self, mechanism: &Mechanism, step: &Step) {
        match step {
            Step::Ground { point, .. } => self.points.push((0, *point)),
            Step::Point { point, carrier, .. } => {
                if mechanism.coordinates_move(*carrier, *point) == [false; 2] {
                    self.points.push((index(*carrier), *point));
                }
            }
            Step::Guide { guide, carrier, through, course } => {
                let body = index(*carrier);
                let has = |point: &PointId| self.points.contains(&(body, *point));
                let starts = match through {
                    Through::At(at) => !at.iter().any(|x| mechanism.moves(x)),
                    Through::Point(point) => has(point),
                };
                let goes = match course {
                    GuideDirection::Along(angle) => !mechanism.turns(angle),
                    GuideDirection::Towards(point) => has(point),
                };
                if starts && goes {
                    self.guides.push((body, *guide));
                }
            }
            Step::Group(group) => self.take_group(mechanism, group),
        }
    }

    fn take_group(&mut self, mechanism: &Mechanism, group: &Group) {
        if let Some(class) = self.carrier_of(mechanism, group) {
            group.links.iter().for_each(|link| self.class[index(Carrier::Link(*link))] = class);
        }
        for (k, link) in group.links.iter().enumerate() {
            let body = index(Carrier::Link(*link));
            self.points.extend(group.outer[k].point().map(|point| (body, point)));
            let is_constant = |length| !mechanism.moves(length);
            let reaches = group.lengths[k].as_ref().is_none_or(|length| is_constant(&length.value));
            self.points.extend(group.pin.filter(|_| reaches).map(|pin| (body, pin)));
        }
    }

    /// The class of the body that all outer joints of a group stand on, if nothing in the group moves.
    fn carrier_of(&self, mechanism: &Mechanism, group: &Group) -> Option<usize> {
        let mut lengths = group.lengths.iter().flatten().map(|length| &length.value);
        if lengths.any(|length| mechanism.moves(length))
            || group.offsets().into_iter().any(|offset| mechanism.moves(offset))
            || group.joints().any(|joint| is_moved(mechanism, joint))
        {
            return None;
        }
        let mut classes = self.class.iter().copied();
        classes.find(|&class| group.outer.iter().all(|joint| self.stands_on(joint, class)))
    }

    fn stands_on(&self, joint: &Joint, class: usize) -> bool {
        let is_turned_by = match &joint.drive {
            Some(Drive::Angle { relative_to, .. }) => self.class[index(*relative_to)] == class,
            _ => true,
        };
        let stands = match &joint.kind {
            JointKind::Revolute(asked) => {
                let mut points = self.points.iter().filter(|(_, point)| point == asked);
                points.any(|(body, _)| self.class[*body] == class)
            }
            JointKind::Prismatic { .. } => {
                self.slid_on(joint).is_some_and(|body| self.class[body] == class)
            }
        };
        is_turned_by && stands
    }
}

/// True if a drive or the angle of a slot changes with an input.
fn is_moved(mechanism: &Mechanism, joint: &Joint) -> bool {
    let is_driven = match &joint.drive {
        Some(Drive::Angle { angle, .. }) => mechanism.turns(angle),
        Some(Drive::Slide(slide)) => mechanism.moves(slide),
        None => false,
    };
    let is_turned = match joint.slideway() {
        Some(Slideway::Slot { angle, .. }) => mechanism.turns(angle),
        _ => false,
    };
    is_driven || is_turned
}
