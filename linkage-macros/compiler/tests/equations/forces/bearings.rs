//! The forces that all links on a point put on it: the opposite of what its pin puts on each of them.

use super::{Digits, Id, Number, Walk, whole};
use crate::model::acting::Effort;
use crate::model::mechanism::{Equation, Mechanism, PointId, Scalar, UnknownId};

/// By point, the nodes of the sum.
pub(super) fn found(mechanism: &Mechanism, walk: &Walk<'_, '_>) -> Vec<(PointId, [Id; 2])> {
    let of_point = |(point, link)| {
        let parts = walk.components(Effort::Bearing(link, point));
        (point, [parts[0].id, parts[1].id])
    };
    mechanism.standing().into_iter().map(of_point).collect()
}

/// By point, the sum from the forces on the links, but for points that a bar pushes which nobody draws: the matrix
/// knows no such link.
pub(super) fn truths(
    mechanism: &Mechanism,
    expected: &[(Effort, Vec<Digits>)],
) -> Vec<(PointId, [Digits; 2])> {
    let standing = mechanism.standing();
    let of_point = |point: PointId| {
        let own = standing.iter().filter(|(at, _)| *at == point);
        let forces = own.filter_map(|(at, link)| {
            expected.iter().find(|(effort, _)| *effort == Effort::Pin(*link, *at))
        });
        forces.fold([whole(0), whole(0)], |[x, y], (_, force)| [x.sub(&force[0]), y.sub(&force[1])])
    };
    let points = standing.iter().map(|(point, _)| *point);
    let points = points.filter(|point| !is_pushed_by_nothing_drawn(mechanism, *point));
    points.map(|point| (point, of_point(point))).collect()
}

fn is_pushed_by_nothing_drawn(mechanism: &Mechanism, point: PointId) -> bool {
    (0..mechanism.unknowns.len() as u32).map(UnknownId).any(|id| {
        let reads = match &mechanism.unknowns[id.index()].equation {
            Equation::Distance { points, .. } => points.contains(&point),
            Equation::Difference(sides) => {
                sides.iter().any(|side| matches!(side, Scalar::Offset(read, _) if *read == point))
            }
            Equation::Turn(_) => false,
        };
        reads && mechanism.left_out(id).is_none()
    })
}
