//! Facts that the rules remember about things already made, beside the mechanism itself.

use proc_macro2::Span;

use crate::diagnostics::Extent;
use crate::exact::Exact;
use crate::reach::line::BodyLine;

use crate::model::dimension::{Dimension, Measure};
use crate::model::mechanism::{Carrier, GuideId, PointId, Scalar};
use crate::model::names::Entity;
use crate::model::reads::Reads;
use crate::model::searched::Searched;

#[derive(Default)]
pub struct Facts {
    /// By parameter.
    pub params: Vec<ParamFacts>,
    /// By named expression.
    pub lets: Vec<LetFacts>,
    /// By law.
    pub laws: Vec<LetFacts>,
    /// By point: whether it moves.
    pub points: Vec<bool>,
    /// By link.
    pub links: Vec<LinkFacts>,
    /// By guide.
    pub guides: Vec<GuideFacts>,
    /// By unknown.
    pub searches: Vec<Searched>,
    /// By unknown: where its ends stand.
    pub ends_of_unknowns: Vec<[Extent; 2]>,
    /// Points, links and unknowns that somebody has named, in order of declaration.
    pub order: Vec<Entity>,
    /// Where gravity is given.
    pub gravity_at: Option<Span>,
    /// The load that drives an input.
    pub driving: Option<String>,
    /// The longest length that has a unit.
    pub longest_with_unit: Option<Exact>,
    /// The longest length without a unit, and where it stands.
    pub longest_bare_length: Option<(Exact, Extent)>,
    /// True if a length anywhere has a unit.
    pub a_length_has_a_unit: bool,
    /// Which points belong to which bodies, and where other points stand still on one.
    places: Vec<Location>,
}

pub struct ParamFacts {
    pub measure: Measure,
    /// The default, where a mistake about its value is reported.
    pub span: Extent,
    /// True if it was reported already.
    pub blamed: bool,
}

pub struct LetFacts {
    pub measure: Measure,
    pub moves: bool,
    pub reads: Reads,
    /// Power of the load that drives an input.
    pub pull: Degree,
}

impl LetFacts {
    /// Those of a number of this dimension that reads neither rates nor loads.
    pub(super) fn of_a_pose(of: Dimension, moves: bool) -> Self {
        let (measure, reads, pull) = (Measure::Known(of), Reads::default(), Degree::Free);
        Self { measure, moves, reads, pull }
    }
}

/// Power to which a number contains the load that drives an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Degree {
    /// It does not.
    Free,
    /// A multiple, and what is free.
    Linear,
    Other,
}

pub struct LinkFacts {
    pub moves: bool,
    /// True for a bar with an outer joint and a pin.
    pub is_bar: bool,
    /// The distance from one to the other; `None` also where it was in error.
    pub length: Option<Scalar>,
    /// True if its joint and its pin are known. Any other point is then certainly neither.
    pub has_its_joints: bool,
    /// True if its group is placed. Where the group's fields or joints are in error, the forces of
    /// its links are unknown, and that was reported.
    pub is_placed: bool,
}

pub struct GuideFacts {
    pub moves: bool,
    pub carrier: Carrier,
    /// Where the line lies on its carrier, if that is constant.
    pub line: Option<BodyLine>,
    /// Its angle on its carrier, if that is constant.
    pub angle: Option<Exact>,
}

struct Location {
    carrier: Carrier,
    point: PointId,
    /// True if it was declared as a point of the body or is a joint of it.
    belongs: bool,
    /// The place in the carrier's frame, if it is constant.
    at: Option<[Exact; 2]>,
}

impl Facts {
    /// The facts that hold before the first statement is resolved.
    pub(super) fn of(longest_with_unit: Option<Exact>, driving: Option<String>) -> Self {
        Self { longest_with_unit, driving, ..Self::default() }
    }

    /// The unknown that is searched: one that is not solved yet.
    pub(super) fn searched(&self) -> Option<&Searched> {
        self.searches.last().filter(|searched| !searched.ended)
    }

    /// True if the entity depends on an input.
    pub(super) fn moves(&self, entity: Entity) -> bool {
        match entity {
            Entity::Input(_) | Entity::Unknown(_) => true,
            // A load moves nothing, and a spring or a stop is no part of the motion.
            Entity::Param(_)
            | Entity::Load(_)
            | Entity::Pull
            | Entity::Spring(_)
            | Entity::Stop(_) => false,
            Entity::Let(id) => self.lets[id.index()].moves,
            Entity::Law(id) => self.laws[id.index()].moves,
            Entity::Point(id) => self.points[id.index()],
            Entity::Link(id) => self.links[id.index()].moves,
            Entity::Guide(id) => self.guides[id.index()].moves,
        }
    }

    /// The point belongs to the carrier: it was declared there, or is a joint of it.
    pub(super) fn fix(&mut self, point: PointId, carrier: Carrier, at: Option<[Exact; 2]>) {
        self.places.push(Location { carrier, point, belongs: true, at });
    }

    /// The point of another body stands still at a place of the carrier.
    pub(super) fn stands_still(&mut self, point: PointId, carrier: Carrier, at: [Exact; 2]) {
        self.places.push(Location { carrier, point, belongs: false, at: Some(at) });
    }

    pub(super) fn belongs_to(&self, point: PointId, carrier: Carrier) -> bool {
        self.points_of(carrier).any(|known| known == point)
    }

    /// The points of a body, joints included.
    pub(super) fn points_of(&self, carrier: Carrier) -> impl Iterator<Item = PointId> {
        let places = self.places.iter().filter(move |p| p.belongs && p.carrier == carrier);
        places.map(|place| place.point)
    }

    /// The bodies that a point belongs to.
    pub(super) fn carriers(&self, point: PointId) -> impl Iterator<Item = Carrier> {
        let places = self.places.iter().filter(move |p| p.belongs && p.point == point);
        places.map(|place| place.carrier)
    }

    /// The constant place of the point on the carrier.
    pub(super) fn place(&self, point: PointId, carrier: Carrier) -> Option<&[Exact; 2]> {
        self.places
            .iter()
            .find(|place| place.point == point && place.carrier == carrier)
            .and_then(|place| place.at.as_ref())
    }

    /// The constant vector from one point to the other, if both are fixed to one body.
    pub(super) fn between(&self, from: PointId, to: PointId) -> Option<[Exact; 2]> {
        self.places.iter().filter(|place| place.point == from).find_map(|place| {
            let [x0, y0] = place.at.as_ref()?;
            let [x1, y1] = self.place(to, place.carrier)?;
            Some([x1.sub(x0), y1.sub(y0)])
        })
    }

    /// The constant line of the guide and the constant place of the point, if both are fixed to
    /// one body.
    pub(super) fn line_and_place(
        &self,
        guide: GuideId,
        point: PointId,
    ) -> Option<(&BodyLine, &[Exact; 2])> {
        let guide = &self.guides[guide.index()];
        Some((guide.line.as_ref()?, self.place(point, guide.carrier)?))
    }
}
