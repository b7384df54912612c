//! What the steps of a mechanism say of its parts: whose a point is, and what moves.

use super::dynamics::Owner;
use super::mechanism::{
    AngleSum, Body, Carrier, Expr, LinkId, Mechanism, Placement, PointId, Step,
};

impl Mechanism {
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
            Expr::Let(id) => self.turns(&self.lets[id.index()]),
            Expr::Negate(value) => self.moves(value),
            Expr::Chain(first, rest) => {
                self.moves(first) || rest.iter().any(|(_, operand)| self.moves(operand))
            }
            Expr::Call(_, arguments) => arguments.iter().any(|argument| self.moves(argument)),
        }
    }

    /// Whether the angle changes with an input.
    pub(crate) fn turns(&self, angle: &AngleSum) -> bool {
        !angle.links.is_empty() || self.moves(&angle.rest)
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
