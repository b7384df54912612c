//! Masses and what acts: the resolved statements about forces, and which of the forces in the
//! mechanism are asked for.

use proc_macro2::Ident;
use syn::Attribute;

use super::mechanism::{
    Body, Carrier, Dimension, Expr, GuideId, InputId, LinkId, Mechanism, Placement, PointId,
    SpringId, Step, UnknownId,
};

/// Everything that a declaration says about forces; empty where it says nothing.
#[derive(Default)]
pub(crate) struct Dynamics {
    /// In ground axes; none unless written.
    pub gravity: Option<[Expr; 2]>,
    pub loads: Vec<Load>,
    pub masses: Vec<Mass>,
    pub forces: Vec<Force>,
    pub torques: Vec<Torque>,
    pub springs: Vec<Spring>,
    /// What `forces` and `statics` give.
    pub asked: Vec<Asked>,
    /// Whether `energy` is given.
    pub energy: bool,
}

/// A number given at each call.
pub(crate) struct Load {
    pub name: Ident,
    pub docs: Vec<Attribute>,
    pub dimension: Dimension,
}

/// What a force can act on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Owner {
    Ground,
    Link(LinkId),
    /// The pin between the links of a dyad, a body without mass of its own; or a driven point.
    Point(PointId),
}

pub(crate) struct Mass {
    pub place: MassPlace,
    pub mass: Quantity,
    /// About the centre of mass; of a uniform bar it follows from mass and length.
    pub inertia: Quantity,
}

/// A mass, an inertia or a number of a spring: no input changes it, and of all but the free angle
/// no parameter may make it negative.
pub(crate) struct Quantity {
    pub value: Expr,
    /// What an error calls it.
    pub name: String,
}

pub(crate) enum MassPlace {
    /// A point mass on a pin or a driven point.
    Pin(PointId),
    /// At a point of the link.
    Point(LinkId, PointId),
    /// At coordinates of the link's frame.
    At(LinkId, [Expr; 2]),
    /// A bar of this length.
    Uniform(LinkId, Expr),
}

pub(crate) enum Force {
    At {
        point: PointId,
        value: [Expr; 2],
        axes: Axes,
    },
    /// Positive pushes the points apart.
    Between {
        points: [PointId; 2],
        value: Expr,
    },
}

/// Whose axes a force is given in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axes {
    Body(Carrier),
    Guide(GuideId),
}

/// A couple: positive on the one, its opposite on the other if there is one.
pub(crate) struct Torque {
    pub on: Carrier,
    pub against: Option<Carrier>,
    pub value: Expr,
}

/// A spring and damper, with the names that errors have for its numbers.
pub(crate) struct Spring {
    pub name: Option<Ident>,
    pub docs: Vec<Attribute>,
    pub ends: Ends,
    pub stiffness: Quantity,
    pub damping: Quantity,
    /// The length or the angle at which it is slack.
    pub free: Quantity,
}

/// What a spring stands between.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ends {
    Points([PointId; 2]),
    /// A torsion spring: its angle is that of the second against the first.
    Bodies([Carrier; 2]),
}

/// A force, couple or effort in the mechanism, as a field of a field of the result.
pub(crate) struct Asked {
    /// The input, link or spring whose it is.
    pub owner: Ident,
    /// The point, guide or word behind the dot; what is the whole mechanism's has its owner again.
    pub field: Ident,
    pub docs: Vec<Attribute>,
    pub effort: Effort,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Effort {
    /// The effort of an input: power put in over its rate.
    Input(InputId),
    /// The same over the rate of an unknown, where that is driven in place of the only input.
    Unknown(UnknownId),
    /// What drives a crank or a slider.
    Drive(LinkId),
    /// The force that pushes the ends of a driven length apart.
    Push(LinkId),
    /// The force on the link by the pin.
    Pin(LinkId, PointId),
    /// The sum of the forces on the link by the links that stand on a point of its own.
    Bearing(LinkId, PointId),
    /// Normal force and couple on the link by the guide it slides on.
    Guide(LinkId),
    /// What a spring exerts on its ends: positive pushes them apart, or turns the second body
    /// forwards.
    Spring(SpringId),
    /// What inertia puts on the ground, as if all of it were one body: force, and couple about the
    /// origin.
    Shaking,
}

impl Dynamics {
    /// Whether anything has mass or acts.
    pub(crate) fn is_empty(&self) -> bool {
        let Self { masses, forces, torques, springs, .. } = self;
        masses.is_empty() && forces.is_empty() && torques.is_empty() && springs.is_empty()
    }
}

impl Mechanism {
    /// What errors call the groups, and behind them what acts along a line between two points, which
    /// has no direction where they meet: springs, then forces; and inputs, which may move no mass.
    pub(crate) fn titles(&self) -> Vec<String> {
        let groups = self.groups.iter().map(|group| group.title.clone());
        let springs = self.dynamics.springs.iter().map(|spring| self.spring_title(spring));
        let forces = self.dynamics.forces.iter().map(|force| match force {
            Force::Between { points, .. } => format!("force {}", self.pair(*points)),
            Force::At { .. } => String::new(),
        });
        let inputs = self.inputs.iter().map(|input| input.name.to_string());
        groups.chain(springs).chain(forces).chain(inputs).collect()
    }

    /// The number of an input's title among [`Self::titles`].
    pub(crate) fn title_of_input(&self, input: usize) -> u32 {
        let forces = self.dynamics.forces.len() as u32;
        self.title_of_force(0) + forces + input as u32
    }

    fn spring_title(&self, spring: &Spring) -> String {
        match (&spring.name, spring.ends) {
            (Some(name), _) => format!("spring {name}"),
            (None, Ends::Points(points)) => format!("spring {}", self.pair(points)),
            (None, Ends::Bodies(bodies)) => {
                let [first, second] = bodies.map(|body| self.body_name(body));
                format!("spring {first}, {second}")
            }
        }
    }

    fn pair(&self, points: [PointId; 2]) -> String {
        let [p, q] = points.map(|point| &self.points[point.index()].name);
        format!("{p}, {q}")
    }

    /// `ground` or the link.
    pub(crate) fn body_name(&self, body: Carrier) -> String {
        match body {
            Carrier::Ground => "ground".to_string(),
            Carrier::Link(link) => self.links[link.index()].name.to_string(),
        }
    }

    /// The number of a spring's title among [`Self::titles`].
    pub(crate) fn title_of_spring(&self, spring: usize) -> u32 {
        (self.groups.len() + spring) as u32
    }

    /// The number of a force's title among [`Self::titles`].
    pub(crate) fn title_of_force(&self, force: usize) -> u32 {
        (self.groups.len() + self.dynamics.springs.len() + force) as u32
    }

    /// The group that makes the pin or the driven point.
    pub(crate) fn group_of(&self, point: PointId) -> u32 {
        match self.points[point.index()].part_of {
            Body::Pin(group) | Body::Driven(group) => group.0,
            Body::Link(link) => self.links[link.index()].made_by.0,
            Body::Ground => 0,
        }
    }

    /// What the point belongs to; none where the step that makes it is missing.
    pub(crate) fn owner(&self, point: PointId) -> Option<Owner> {
        self.steps.iter().find_map(|step| match step {
            Step::Ground { point: made, .. } if *made == point => Some(Owner::Ground),
            Step::Point { point: made, carrier, .. } if *made == point => Some(match carrier {
                Carrier::Ground => Owner::Point(point),
                Carrier::Link(link) => Owner::Link(*link),
            }),
            Step::Crank { link, pin: Some((made, _)), .. } if *made == point => {
                Some(Owner::Link(*link))
            }
            Step::Slider { link, pin: Some(made), .. } if *made == point => {
                Some(Owner::Link(*link))
            }
            Step::Rrr { pin, .. } | Step::Rrp { pin, .. } | Step::Prp { pin, .. }
                if *pin == point =>
            {
                Some(Owner::Point(point))
            }
            _ => None,
        })
    }

    /// Whether the coordinates of a point in the frame of its carrier change with an input.
    pub(crate) fn coordinates_move(&self, carrier: Carrier, point: PointId) -> [bool; 2] {
        let along = |length: &Expr| [self.moves(length), false];
        let found = self.steps.iter().find_map(|step| match step {
            Step::Point { point: made, carrier: own, place, .. }
                if *made == point && *own == carrier =>
            {
                let moves = |values: &[&Expr]| values.iter().any(|value| self.moves(value));
                Some(match place {
                    Placement::Cartesian([x, y]) => [self.moves(x), self.moves(y)],
                    Placement::Polar(radius, angle) => [moves(&[radius, angle]); 2],
                    Placement::Distances { distances: [first, second], length, .. } => {
                        [moves(&[&first.value, &second.value, length]); 2]
                    }
                })
            }
            Step::Crank { link, pin: Some((pin, length)), .. }
                if *pin == point && carrier == Carrier::Link(*link) =>
            {
                Some(along(&length.value))
            }
            Step::Rrr { links, pin, lengths, .. } if *pin == point => {
                let bar = links.iter().position(|link| carrier == Carrier::Link(*link))?;
                Some(along(&lengths[bar].value))
            }
            Step::Rrp { links, pin, length, .. }
                if *pin == point && carrier == Carrier::Link(links[0]) =>
            {
                Some(along(&length.value))
            }
            _ => None,
        });
        found.unwrap_or([false; 2])
    }

    /// Whether the expression changes with an input.
    pub(crate) fn moves(&self, expr: &Expr) -> bool {
        match expr {
            Expr::Constant(_) | Expr::Param(_) | Expr::Load(_) => false,
            Expr::Input(_)
            | Expr::Unknown(_)
            | Expr::Slide(_)
            | Expr::Coordinate(..)
            | Expr::Distance(_)
            | Expr::Offset(..)
            | Expr::Twist(_)
            | Expr::Rate(_) => true,
            Expr::Let(id) => {
                let turn = &self.lets[id.index()];
                !turn.links.is_empty() || self.moves(&turn.rest)
            }
            Expr::Negate(value) => self.moves(value),
            Expr::Chain(first, rest) => {
                self.moves(first) || rest.iter().any(|(_, operand)| self.moves(operand))
            }
            Expr::Call(_, arguments) => arguments.iter().any(|argument| self.moves(argument)),
        }
    }

    /// The points that links stand on, and the links: every revolute outer joint.
    pub(crate) fn standing(&self) -> Vec<(PointId, LinkId)> {
        let of = |step: &Step| match step {
            Step::Crank { pivot, link, .. } => vec![(*pivot, *link)],
            Step::Rrr { outer, links, .. } | Step::Rpr { outer, links, .. } => {
                vec![(outer[0], links[0]), (outer[1], links[1])]
            }
            Step::Rrp { outer, links, .. } | Step::Rpp { outer, links, .. } => {
                vec![(*outer, links[0])]
            }
            _ => Vec::new(),
        };
        self.steps.iter().flat_map(of).collect()
    }
}
