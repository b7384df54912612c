//! Stops: two ends of a motion x, which push back beyond them.
//!
//! With the middle m and half the way h between the ends
//!
//! ```text
//! y = x − m      gap = h − |y|      s = sign y
//! beyond an end, where gap < 0:      f = max(0, −k gap + c s ẏ)
//! ```
//!
//! and −s f acts on what x moves: a couple on links by their angles, a force along a guide, or between two
//! points. It never pulls: a damper of a motion that leaves the end faster than the stop follows exerts nothing.
//! Energy: ½ k gap² beyond an end.
//!
//! An angle is that from the middle, in (−π, π], unless drivers say it.
//!
//! # Source
//! K. H. Hunt, F. R. E. Crossley, Coefficient of restitution interpreted as damping in vibroimpact, J. Appl.
//! Mech. 42 (1975), on linear dampers that would pull at the end of a contact.

use crate::equations::forces::elastic::springs::turned_from;
use crate::equations::forces::provided::{Line, not_negative};
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;
use crate::model::acting::{Elastic, Stop, Stopped};
use crate::model::mechanism::{Carrier, LinkId, PointId};

/// The name in errors of what lies between the ends, which is not negative.
const WAY: &str = "way between the ends of a stop";

/// A stop in a pose.
struct StopContact<'s> {
    /// y
    off: Jet<'s>,
    gap: Sym<'s>,
    stiffness: Sym<'s>,
    damping: Sym<'s>,
}

impl<'s> StopContact<'s> {
    fn of(kinematics: &Kinematics<'s>, index: usize) -> Self {
        let mechanism = kinematics.mechanism;
        let (stop, title) =
            (&mechanism.dynamics.stops[index], mechanism.title_of(Elastic::Stop(index)));
        let [from, to] = kinematics.jets(&stop.ends).map(|end| end.value);
        let way = to - from;
        let way = match way.is_constant() {
            true => way,
            false => way.guarded_by(Check::NotNegative(WAY.to_string()), title, &[]),
        };
        let middle = from + way.half();
        let off = match &stop.of {
            Stopped::Angle(sum) => turned_from(kinematics, sum, middle),
            Stopped::Slide(by) => kinematics.slide(*by) + Jet::constant(-middle),
            Stopped::Distance(points) => {
                let line = line(kinematics, index, *points);
                let [p, q] = points.map(|point| kinematics.point(point).velocity);
                let rate = line.vector.dot(q - p) * line.inverse;
                Jet { value: line.length - middle, rate, ..Jet::constant(middle) }
            }
        };
        Self {
            off,
            gap: way.half() - off.value.magnitude(),
            stiffness: not_negative(kinematics, &stop.stiffness, title),
            damping: not_negative(kinematics, &stop.damping, title),
        }
    }

    /// The effort on x.
    fn effort(&self, kinematics: &Kinematics<'s>) -> Sym<'s> {
        let zero = kinematics.builder.zero();
        let rate = kinematics.at_rate_scale(self.off.rate);
        let pushing = |sign: Sym<'s>| {
            let push = self.damping * (sign * rate) - self.stiffness * self.gap;
            -sign * zero.at_least(push, zero, push)
        };
        let [below, above] = [-1, 1].map(|sign| pushing(kinematics.builder.integer(sign)));
        let beyond = self.off.value.at_least(zero, above, below);
        self.gap.at_least(zero, zero, beyond)
    }
}

fn line<'s>(kinematics: &Kinematics<'s>, index: usize, points: [PointId; 2]) -> Line<'s> {
    Line::between(kinematics, points, kinematics.mechanism.title_of(Elastic::Stop(index)))
}

/// The effort of the stop, positive where it makes the motion larger.
pub(in crate::equations::forces) fn effort<'s>(
    kinematics: &Kinematics<'s>,
    index: usize,
) -> Sym<'s> {
    StopContact::of(kinematics, index).effort(kinematics)
}

/// The way to the nearer end, negative beyond it.
pub(in crate::equations::forces) fn gap<'s>(kinematics: &Kinematics<'s>, index: usize) -> Sym<'s> {
    StopContact::of(kinematics, index).gap
}

/// Energy stored in all stops.
pub(super) fn energy<'s>(kinematics: &Kinematics<'s>) -> Sym<'s> {
    let zero = kinematics.builder.zero();
    let stops = 0..kinematics.mechanism.dynamics.stops.len();
    let energy = stops.map(|index| {
        let StopContact { gap, stiffness, .. } = StopContact::of(kinematics, index);
        gap.at_least(zero, zero, stiffness.half() * gap.squared())
    });
    energy.fold(zero, |sum, energy| sum + energy)
}

/// The stops, with their numbers in the declaration.
pub fn stops<'k>(kinematics: &'k Kinematics<'_>) -> impl Iterator<Item = (usize, &'k Stop)> {
    kinematics.mechanism.dynamics.stops.iter().enumerate()
}

/// Forces on points.
pub(super) fn forces<'s>(kinematics: &Kinematics<'s>) -> Vec<(PointId, Vector<'s>)> {
    let forces = stops(kinematics).flat_map(|(index, stop)| match stop.of {
        Stopped::Distance(points) => {
            let line = line(kinematics, index, points);
            let push = (effort(kinematics, index) * line.inverse) * line.vector;
            vec![(points[0], -push), (points[1], push)]
        }
        _ => Vec::new(),
    });
    forces.collect()
}

/// Couples on bodies: of an angle against the ground, the ground has the opposite.
pub(super) fn couples<'s>(kinematics: &Kinematics<'s>) -> Vec<(Carrier, Sym<'s>)> {
    let couples = stops(kinematics).flat_map(|(index, stop)| {
        let Stopped::Angle(sum) = &stop.of else { return Vec::new() };
        let effort = effort(kinematics, index);
        let times = |times: i64| kinematics.builder.integer(times) * effort;
        let of_link =
            |&(link, count): &(LinkId, i32)| (Carrier::Link(link), times(i64::from(count)));
        let total: i64 = sum.links.iter().map(|&(_, count)| i64::from(count)).sum();
        let ground = (total != 0).then(|| (Carrier::Ground, times(-total)));
        sum.links.iter().map(of_link).chain(ground).collect()
    });
    couples.collect()
}

/// Forces on links along their slides.
pub(in crate::equations::forces) fn slides<'s>(
    kinematics: &Kinematics<'s>,
) -> Vec<(LinkId, Sym<'s>)> {
    let slides = stops(kinematics).filter_map(|(index, stop)| match stop.of {
        Stopped::Slide(link) => Some((link, effort(kinematics, index))),
        _ => None,
    });
    slides.collect()
}
