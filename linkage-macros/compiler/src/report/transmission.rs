//! Transmission angles, from the values whose sign says whether a group can be assembled, and from the sides that these
//! are made of.
//!
//! Sine and cosine are enclosed apart, and the angle is that of all pairs of both. Next to a limit the sine alone is
//! narrow, and next to a right angle the cosine alone is: so either holds where the other says little.

use super::sensitivity::ProvedBoxes;
use super::{TransmissionReport, comparisons};
use crate::interface::EntryId;
use crate::ir::check::TransmissionTriangle;
use crate::ir::graph::{Guard, Id, Node};
use crate::ir::liveness::{Path, live, live_nodes};
use crate::lower::routine::Lowered;
use crate::prove::function_ranges;
use crate::prove::goal::Goal;
use crate::prove::one_box::OneBox;
use crate::prove::outward::OutwardInterval;
use crate::prove::premises::Premises;
use crate::prove::sloped::{InputBox, SlopedValue};
use crate::prove::width::Precision;

/// A group, and the numbers that its angle follows from.
struct Transmitted {
    group: u32,
    /// The square of a multiple of the sine.
    value: Id,
    sides: TransmittedSides,
}

/// The sides of a group's triangle.
#[derive(Clone, Copy)]
enum TransmittedSides {
    /// Joints (dx, dy) apart and two bars. The value is a quarter of the sine's square, in squares of the unit.
    Bars { joints: [Id; 2], bars: [Id; 2], unit: Id },
    /// The way t from the joint to the guide along the guide's normal, and the bar l. The value is l² − t².
    Guide { across: Id, bar: Id },
    /// The joints (bx, by) apart, and the bar's offset e. The value is b² − e².
    Block { joints: [Id; 2], offset: Id },
}

/// The least and the largest angle so far, each with where it is.
struct AngleEnds([(OutwardEnd, Vec<f64>); 2]);

/// An end of an enclosure: the angle times −1 where it is the largest, so that less is further out.
type OutwardEnd = f64;

/// See the module's documentation.
pub(super) fn transmissions(
    lowered: &Lowered<'_>,
    id: EntryId,
    looked: &ProvedBoxes<'_>,
) -> Vec<TransmissionReport> {
    let graph = &lowered.program.graph;
    let needed = live(graph, comparisons::sinks(lowered, id), Path::Slow);
    let guards = live_nodes(graph, &needed).filter_map(|(_, node)| match node {
        Node::Guard(value, guard) => measured(value, graph.condition(guard)),
        _ => None,
    });
    let mut found: Vec<Transmitted> = Vec::new();
    for guard in guards {
        if found.iter().all(|known| known.value != guard.value) {
            found.push(guard);
        }
    }
    let sinks: Vec<Id> = found.iter().flat_map(|of| of.sides.all().chain([of.value])).collect();
    let given: &Premises = looked.given;
    let subject = Goal::new(graph, (&sinks, &[]), given, Precision::DOUBLE);
    let mut ends: Vec<AngleEnds> = found.iter().map(|_| AngleEnds::NONE).collect();
    for sides in &looked.boxes {
        let values = OneBox::new(&subject, InputBox::new(sides));
        for (of, ends) in found.iter().zip(&mut ends) {
            ends.widen(&values, &of.angles(&values));
        }
    }
    let told = found.iter().zip(ends).filter(|(_, ends)| ends.0[0].0.is_finite());
    told.map(|(of, AngleEnds([(least, least_at), (most, largest_at)]))| TransmissionReport {
        group: lowered.program.groups[of.group as usize].clone(),
        least,
        least_at,
        largest: -most,
        largest_at,
    })
    .collect()
}

fn measured(value: Id, guard: &Guard) -> Option<Transmitted> {
    let sides = match (guard.check.triangle()?, &guard.operands[..]) {
        (TransmissionTriangle::Bars, &[dx, dy, l1, l2, unit, _]) => {
            TransmittedSides::Bars { joints: [dx, dy], bars: [l1, l2], unit }
        }
        (TransmissionTriangle::Guide, &[across, bar]) => TransmittedSides::Guide { across, bar },
        (TransmissionTriangle::Block, &[bx, by, offset]) => {
            TransmittedSides::Block { joints: [bx, by], offset }
        }
        _ => return None,
    };
    Some(Transmitted { group: guard.group, value, sides })
}

impl TransmittedSides {
    fn all(self) -> impl Iterator<Item = Id> {
        let all = match self {
            Self::Bars { joints: [dx, dy], bars: [l1, l2], unit } => vec![dx, dy, l1, l2, unit],
            Self::Guide { across, bar } => vec![across, bar],
            Self::Block { joints: [bx, by], offset } => vec![bx, by, offset],
        };
        all.into_iter()
    }
}

impl Transmitted {
    /// The angle over the box, and at each of its corners.
    fn angles(&self, values: &OneBox<'_, '_>) -> Vec<OutwardInterval> {
        let frame = &values.frame;
        let of = |id: Id| values.sloped(id);
        let distance =
            |[x, y]: [Id; 2]| frame.met(&frame.add(&frame.square(of(x)), &frame.square(of(y))));
        // The side that the sine's root is measured by, the factor of the root, and the cosine.
        let (by, factor, cosine) = match self.sides {
            TransmittedSides::Bars { joints, bars: [l1, l2], unit } => {
                let squares = frame.add(&frame.square(of(l1)), &frame.square(of(l2)));
                let product = frame.mul(of(l1), of(l2));
                let over = frame.add(&product, &product);
                let cosine = frame.div(&frame.sub(&squares, &distance(joints)), &over);
                (*of(unit), 2.0, cosine)
            }
            TransmittedSides::Guide { across, bar } => {
                (*of(bar), 1.0, frame.div(of(across), of(bar)))
            }
            TransmittedSides::Block { joints, offset } => {
                let length = function_ranges::root(frame, &distance(joints));
                (length, 1.0, frame.div(of(offset), &length))
            }
        };
        let cosine = frame.met(&cosine);
        let columns = 0..frame.columns();
        columns.map(|at| self.angle(values, &by, factor, cosine.columns[at], at)).collect()
    }

    fn angle(
        &self,
        values: &OneBox<'_, '_>,
        by: &SlopedValue,
        factor: f64,
        cosine: OutwardInterval,
        at: usize,
    ) -> OutwardInterval {
        let root = values.column(self.value, at).root().scaled(factor);
        let sine = root.div(by.columns[at].abs()).meet(OutwardInterval::between(0.0, 1.0));
        function_ranges::angle(sine, cosine.meet(OutwardInterval::between(-1.0, 1.0)))
    }
}

impl AngleEnds {
    const NONE: Self = Self([(f64::INFINITY, Vec::new()), (f64::INFINITY, Vec::new())]);

    /// With the angles of a box: where one is further out, the box's corner that is nearest to it.
    fn widen(&mut self, values: &OneBox<'_, '_>, angles: &[OutwardInterval]) {
        let outward: [fn(OutwardInterval) -> OutwardEnd; 2] = [|of| of.low, |of| -of.high];
        for ((end, at), outward) in self.0.iter_mut().zip(outward) {
            let over_the_box = outward(angles[0]);
            if over_the_box < *end {
                let corners = 1..angles.len();
                let nearest =
                    corners.min_by(|&a, &b| outward(angles[a]).total_cmp(&outward(angles[b])));
                *end = over_the_box;
                *at = nearest.map_or_else(Vec::new, |at| values.frame.corner(at - 1));
            }
        }
    }
}
