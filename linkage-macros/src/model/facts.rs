//! What the rules remember of things already made, beside the mechanism itself.

use proc_macro2::Span;

use crate::exact::Exact;

use super::dimension::Measure;
use super::mechanism::{Carrier, Expr, GuideId, LinkId, PointId};
use super::names::Entity;

#[derive(Default)]
pub(super) struct Facts {
    /// By parameter.
    pub params: Vec<ParamFacts>,
    /// By named expression.
    pub lets: Vec<LetFacts>,
    /// By point: whether it moves.
    pub points: Vec<bool>,
    /// By link.
    pub links: Vec<LinkFacts>,
    /// By guide.
    pub guides: Vec<GuideFacts>,
    /// Points and links in order of declaration.
    pub order: Vec<Entity>,
    /// Which points are fixed to which bodies.
    places: Vec<Location>,
}

pub(super) struct ParamFacts {
    pub measure: Measure,
    /// The default, where a mistake about its value is reported.
    pub span: Span,
    /// Whether it was reported already.
    pub blamed: bool,
}

pub(super) struct LetFacts {
    pub measure: Measure,
    pub moves: bool,
}

pub(super) struct LinkFacts {
    pub moves: bool,
    /// Whether it is a bar with an outer joint and a pin.
    pub is_bar: bool,
    /// The distance from one to the other; `None` also where it was in error.
    pub length: Option<Expr>,
}

pub(super) struct GuideFacts {
    pub moves: bool,
    pub carrier: Carrier,
    /// Where the line lies on its carrier, if that is constant.
    pub line: Option<Line>,
    /// Its angle on its carrier, if that is constant.
    pub angle: Option<Exact>,
}

#[derive(Clone)]
pub(super) struct Line {
    pub through: [Exact; 2],
    pub angle: Exact,
}

struct Location {
    carrier: Carrier,
    point: PointId,
    /// The place in the carrier's frame, if it is constant.
    at: Option<[Exact; 2]>,
}

impl Facts {
    /// Whether the thing depends on an input.
    pub(super) fn moves(&self, entity: Entity) -> bool {
        match entity {
            Entity::Input(_) => true,
            Entity::Param(_) => false,
            Entity::Let(id) => self.lets[id.index()].moves,
            Entity::Point(id) => self.points[id.index()],
            Entity::Link(id) => self.links[id.index()].moves,
            Entity::Guide(id) => self.guides[id.index()].moves,
        }
    }

    /// The point is fixed to the carrier.
    pub(super) fn fix(&mut self, point: PointId, carrier: Carrier, at: Option<[Exact; 2]>) {
        self.places.push(Location { carrier, point, at });
    }

    pub(super) fn lies_on(&self, point: PointId, carrier: Carrier) -> bool {
        self.places.iter().any(|place| place.point == point && place.carrier == carrier)
    }

    /// The points of the link, joints included.
    pub(super) fn points_on(&self, link: LinkId) -> impl Iterator<Item = PointId> {
        self.places.iter().filter(move |p| p.carrier == Carrier::Link(link)).map(|p| p.point)
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
    ) -> Option<(&Line, &[Exact; 2])> {
        let guide = &self.guides[guide.index()];
        Some((guide.line.as_ref()?, self.place(point, guide.carrier)?))
    }
}
