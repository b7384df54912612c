//! Parts without mass that another body carries: guides, slots, and places that move in their link.
//!
//! Each has equations of its own, and is held by as many unknowns. A dimension that moves the part in its
//! carrier has the effort of the unknown along it. So nothing here moves a force to another place by hand.

use super::matrix::Matrix;
use super::readings::evaluate;
use super::{
    Pair, Part, held_point, is_moving, normal, part, part_of_carrier, part_of_point, whole,
};
use crate::ir::interpret::{Number, Searched};
use crate::model::acting::MassPlace;
use crate::model::mechanism::{
    AngleSum, Carrier, GuideDirection, GuideId, LinkId, Placement, PointId, Scalar, Step, Through,
};
use crate::oracle::Digits;

impl<'k> Matrix<'k, '_> {
    /// Unknowns that hold a step's guide or point on its carrier.
    pub(super) fn carry(&mut self, step: &'k Step) {
        match step {
            Step::Guide { guide, carrier, through, course } => {
                self.carry_guide(*guide, *carrier, through, course);
            }
            Step::Point { point, carrier: Carrier::Link(link), place, .. } => {
                if held_point(self.kinematics.mechanism, *point) {
                    self.carry_point(*point, *link, place);
                }
            }
            Step::Ground { .. } | Step::Point { .. } | Step::Group(_) => {}
        }
    }

    /// Masses at places that move.
    pub(super) fn carry_masses(&mut self) {
        let mechanism = self.kinematics.mechanism;
        for (index, mass) in mechanism.dynamics.masses.iter().enumerate() {
            let MassPlace::At(link, place) = &mass.place else { continue };
            if !is_moving(mechanism, place) {
                continue;
            }
            let mut applied = self.motion.applied.iter();
            let own = applied.find(|applied| applied.part == Part::Mass(index));
            let at = own.expect("a mass acts").at.clone();
            let by = part(mechanism, *link, mechanism.moves(&place[0]));
            let u = self.motion.directions[link.index()].clone();
            self.hold([Part::Mass(index), by], &at, &u, [Some(&place[0]), Some(&place[1])]);
        }
    }

    /// Two forces at a place, along u and its normal, which move the place by these dimensions.
    fn hold(
        &mut self,
        parts: [Part; 2],
        at: &Pair<Digits>,
        u: &Pair<Digits>,
        dimensions: [Option<&Scalar>; 2],
    ) {
        for (direction, dimension) in [u.clone(), normal(u)].iter().zip(dimensions) {
            let unknown = self.unknown(parts, at, direction, 0);
            if let Some(dimension) = dimension {
                self.transmit(dimension, &[(unknown, whole(1))]);
            }
        }
    }

    fn unknown(
        &mut self,
        parts: [Part; 2],
        at: &Pair<Digits>,
        force: &Pair<Digits>,
        couple: i64,
    ) -> usize {
        let column = self.pair(parts, at, force, couple);
        self.columns.push(column);
        self.columns.len() - 1
    }

    fn carry_guide(
        &mut self,
        guide: GuideId,
        carrier: Carrier,
        through: &'k Through,
        course: &'k GuideDirection,
    ) {
        let (at, along) = self.motion.guides[guide.index()].clone();
        let (own, body) = (Part::Guide(guide), part_of_carrier(carrier));
        let x = self.x_of(carrier);
        match through {
            Through::Point(point) => {
                let by = part_of_point(self.kinematics, carrier, *point);
                self.hold([own, by], &at, &x, [None; 2]);
            }
            Through::At([first, second]) => {
                self.hold([own, body], &at, &x, [Some(first), Some(second)]);
            }
        }
        match course {
            GuideDirection::Along(turn) => self.hold_turned([own, body], turn),
            GuideDirection::Towards(to) => {
                let by = part_of_point(self.kinematics, carrier, *to);
                let at = self.motion.points[to.index()].clone();
                self.unknown([own, by], &at, &normal(&along), 0);
            }
        }
    }

    /// A couple that turns a part in its carrier.
    fn hold_turned(&mut self, parts: [Part; 2], turn: &AngleSum) {
        let zero = [whole(0), whole(0)];
        let couple = self.unknown(parts, &zero, &zero, 1);
        self.transmit_turn(turn, &[(couple, whole(1))]);
    }

    /// The slot of a block in a yoke. It is pushed across the yoke by one dimension, and turned by another.
    pub(super) fn carry_slot(
        &mut self,
        [block, yoke]: [LinkId; 2],
        at: &Pair<Digits>,
        across: &Scalar,
        turn: &AngleSum,
    ) {
        let parts = [Part::Slot(block), Part::Link(yoke)];
        let u = self.motion.directions[yoke.index()].clone();
        self.hold(parts, at, &u, [None, Some(across)]);
        self.hold_turned(parts, turn);
    }

    fn carry_point(&mut self, point: PointId, link: LinkId, place: &'k Placement) {
        let mechanism = self.kinematics.mechanism;
        let moves = mechanism.coordinates_move(Carrier::Link(link), point)[0];
        let parts = [Part::Held(point), part(mechanism, link, moves)];
        let at = self.motion.points[point.index()].clone();
        let origin = self.motion.origins[link.index()].clone();
        let u = self.motion.directions[link.index()].clone();
        let from_origin = [at[0].sub(&origin[0]), at[1].sub(&origin[1])];
        match place {
            Placement::Cartesian([x, y]) => self.hold(parts, &at, &u, [Some(x), Some(y)]),
            Placement::Polar(radius, angle) => {
                let r = from_origin[0].hypot(&from_origin[1]);
                let outwards = from_origin.map(|part| part.div(&r));
                let pull = self.unknown(parts, &at, &outwards, 0);
                self.transmit(radius, &[(pull, whole(1))]);
                let turn = self.unknown(parts, &at, &normal(&outwards), 0);
                self.transmit(angle, &[(turn, r)]);
            }
            Placement::Distances { distances, length, .. } => {
                // Two struts. The second stands on the rod, where the length is driven.
                let l = evaluate(mechanism, length, self.given);
                let second = [0, 1].map(|axis| from_origin[axis].sub(&u[axis].mul(&l)));
                let rod = match mechanism.moves(length) {
                    true => Part::Rod(link),
                    false => Part::Link(link),
                };
                let struts = [(from_origin, Part::Link(link)), (second, rod)];
                for ((strut, by), distance) in struts.into_iter().zip(distances) {
                    let r = strut[0].hypot(&strut[1]);
                    let outwards = strut.map(|part| part.div(&r));
                    let push = self.unknown([Part::Held(point), by], &at, &outwards, 0);
                    self.transmit(&distance.value, &[(push, whole(1))]);
                }
            }
        }
    }

    fn x_of(&self, carrier: Carrier) -> Pair<Digits> {
        match carrier {
            Carrier::Ground => [whole(1), whole(0)],
            Carrier::Link(link) => self.motion.directions[link.index()].clone(),
        }
    }
}
