//! A machine in one pose, by the names that it has where it comes from.

use std::collections::HashSet;

use super::Mistake;

pub(crate) struct Drawing {
    /// The name of the solver.
    pub name: String,
    /// The unit of all coordinates.
    pub unit: String,
    pub pins: Vec<Pin>,
    pub links: Vec<Link>,
    pub guides: Vec<Guide>,
    pub drives: Vec<Drive>,
    pub masses: Vec<Mass>,
    /// Links with inertia alone, in kg·m².
    pub rotors: Vec<(String, f64)>,
    pub gravity: Option<[f64; 2]>,
    pub springs: Vec<Spring>,
    pub forces: Vec<Force>,
    /// The parts of the machine that have no counterpart here, for a comment.
    pub left_out: Vec<String>,
    /// The places where this drawing is another than the one that came, a sentence each, for a comment.
    pub remarks: Vec<String>,
}

pub(crate) struct Pin {
    pub id: String,
    pub at: [f64; 2],
    pub is_ground: bool,
}

#[derive(Default)]
pub(crate) struct Link {
    pub id: String,
    pub pins: Vec<String>,
    /// The guides on which it slides.
    pub on: Vec<String>,
}

pub(crate) struct Guide {
    pub id: String,
    /// The link that carries it; `None` is the ground.
    pub on: Option<String>,
    pub line: Line,
}

/// The mass of a link, at a place of the drawing, with the unit that the numbers have.
pub(crate) struct Mass {
    pub link: String,
    pub value: f64,
    pub unit: &'static str,
    pub at: [f64; 2],
    pub inertia: f64,
    pub unit_of_inertia: &'static str,
}

/// A force on a link at a place of the drawing, in newtons.
pub(crate) struct Force {
    pub id: String,
    pub link: String,
    pub at: [f64; 2],
    pub vector: [f64; 2],
    /// True if it turns with the link.
    pub turns: bool,
}

/// A line in the drawing.
pub(crate) enum Line {
    /// Through two pins of the link that carries it.
    Pins([String; 2]),
    /// Through a place, in a direction that is given as it came.
    Along { through: [f64; 2], angle: Angle },
}

/// A direction from the drawing's x axis.
#[derive(Clone, Copy)]
pub(crate) enum Angle {
    Degrees(f64),
    Radians(f64),
    Vector([f64; 2]),
}

impl Angle {
    pub(crate) fn radians(self) -> f64 {
        match self {
            Self::Degrees(angle) => angle.to_radians(),
            Self::Radians(angle) => angle,
            Self::Vector([x, y]) => y.atan2(x),
        }
    }
}

/// A link that is driven: turned against the ground or another link, or slid along its guide.
pub(crate) enum Drive {
    Angle {
        link: String,
        against: Option<String>,
    },
    Slide {
        link: String,
    },
    /// An input that is a factor times a quantity.
    Input {
        input: String,
        of: Quantity,
        factor: f64,
    },
    /// A quantity that is a factor times another, and a constant.
    Coupled {
        of: Quantity,
        by: Quantity,
        factor: f64,
        constant: f64,
    },
}

/// A quantity of the drawing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Quantity {
    /// The angle of a link, against another where there is one.
    Angle(String, Option<String>),
    Slide(String),
    /// A coordinate of a pin: 0 is x.
    Place(String, usize),
    Distance([String; 2]),
}

/// A spring and damper: of an angle between two links, or of a distance.
pub(crate) struct Spring {
    pub of: Quantity,
    pub stiffness: f64,
    pub damping: f64,
    /// The angle or the length at which it is slack.
    pub slack: f64,
}

impl Quantity {
    /// True if it is one of this link's own.
    pub(crate) fn is_of(&self, link: &str) -> bool {
        match self {
            Self::Angle(own, against) => own == link || against.as_deref() == Some(link),
            Self::Slide(own) => own == link,
            Self::Place(..) | Self::Distance(_) => false,
        }
    }
}

impl Drawing {
    pub(crate) fn new(name: &str, unit: &str) -> Self {
        Self {
            name: name.to_string(),
            unit: unit.to_string(),
            pins: Vec::new(),
            links: Vec::new(),
            guides: Vec::new(),
            drives: Vec::new(),
            masses: Vec::new(),
            rotors: Vec::new(),
            gravity: None,
            springs: Vec::new(),
            forces: Vec::new(),
            left_out: Vec::new(),
            remarks: Vec::new(),
        }
    }

    pub(crate) fn pin(&self, id: &str) -> Option<&Pin> {
        self.pins.iter().find(|pin| pin.id == id)
    }

    pub(crate) fn link(&self, id: &str) -> Option<&Link> {
        self.links.iter().find(|link| link.id == id)
    }

    /// The link with this name, which begins without pins where it was not named before.
    pub(crate) fn link_named(&mut self, id: &str) -> &mut Link {
        let index = self.links.iter().position(|link| link.id == id);
        let index = index.unwrap_or_else(|| {
            self.links.push(Link { id: id.to_string(), ..Link::default() });
            self.links.len() - 1
        });
        &mut self.links[index]
    }

    /// Makes one link of two, by the name of the first.
    pub(crate) fn merge(&mut self, first: &str, other: &str) {
        let Some(at) = self.links.iter().position(|link| link.id == other) else { return };
        let Link { pins, on, .. } = self.links.remove(at);
        let link = self.link_named(first);
        link.pins.extend(pins);
        link.on.extend(on);
        let mut seen = HashSet::new();
        link.pins.retain(|pin| seen.insert(pin.clone()));
        let links = self.drives.iter_mut().flat_map(|drive| match drive {
            Drive::Angle { link, against } => [Some(link), against.as_mut()],
            Drive::Slide { link } => [Some(link), None],
            Drive::Input { of, .. } | Drive::Coupled { of, .. } => match of {
                Quantity::Angle(link, against) => [Some(link), against.as_mut()],
                Quantity::Slide(link) => [Some(link), None],
                Quantity::Place(..) | Quantity::Distance(_) => [None, None],
            },
        });
        let links =
            links.flatten().chain(self.guides.iter_mut().filter_map(|guide| guide.on.as_mut()));
        let links = links.chain(self.masses.iter_mut().map(|mass| &mut mass.link));
        let links = links.chain(self.forces.iter_mut().map(|force| &mut force.link));
        links.filter(|link| link.as_str() == other).for_each(|link| *link = first.to_string());
    }

    /// The links through a pin.
    pub(crate) fn at(&self, pin: &str) -> impl Iterator<Item = &Link> {
        self.links.iter().filter(move |link| link.pins.iter().any(|own| own == pin))
    }

    /// The frame of a link in the drawing, its origin and its angle: from its first pin to its second. With
    /// one pin the angle is that of the link's guide, else the ground's; without a pin it begins at the point of
    /// the guide.
    pub(crate) fn frame(&self, id: &str) -> Result<([f64; 2], f64), Mistake> {
        let link = self.link(id).ok_or_else(|| format!("no link is named `{id}`"))?;
        let at = |pin: &String| self.pin(pin).map(|pin| pin.at);
        let guide = link.on.first().and_then(|on| self.guides.iter().find(|guide| guide.id == *on));
        match (link.pins.first().and_then(at), link.pins.get(1).and_then(at), guide) {
            (Some([u, v]), Some([x, y]), _) => Ok(([u, v], (y - v).atan2(x - u))),
            (Some(origin), None, Some(guide)) => Ok((origin, self.line(guide)?.1)),
            (Some(origin), None, None) => Ok((origin, 0.0)),
            (None, _, Some(guide)) => self.line(guide),
            (None, _, None) => Err(format!("`{id}` has no joint but the one of its guide")),
        }
    }

    /// A point of a guide in the drawing, and its angle.
    fn line(&self, guide: &Guide) -> Result<([f64; 2], f64), Mistake> {
        match &guide.line {
            Line::Along { through, angle } => Ok((*through, angle.radians())),
            Line::Pins(pins) => {
                let [from, to] = pins.each_ref().map(|pin| self.pin(pin).map(|pin| pin.at));
                let (Some(from), Some(to)) = (from, to) else {
                    return Err(format!(
                        "a slot goes through `{}` and `{}`, which are no pins",
                        pins[0], pins[1]
                    ));
                };
                Ok((from, (to[1] - from[1]).atan2(to[0] - from[0])))
            }
        }
    }
}
