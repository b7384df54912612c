//! Proof that an equation has at most one root of its trend, where only constants decide.
//!
//! The bracket is walked in pieces. On each the slope and the curvature by the unknown are enclosed by
//! intervals in `f64`, every bound rounded outward. The roots of a trend lie where the slope has its
//! sign, and on one stretch of that sign there is one at most. So it is proved that there is only one
//! such stretch: pieces with the sign, between pieces with the other, and in between such where the
//! curvature keeps its sign, so that the slope passes zero once. Near the dead points that most brackets
//! end at this is what decides.

use super::interval::Interval;
use crate::exact::Exact;
use crate::function::Function;
use crate::ir::graph::{Graph, Id, Node, RootSearch};
use crate::ir::liveness::{Path, live, live_nodes};

/// Pieces of the bracket: a slope of a dozen operations is known to a part in a hundred on each.
const PIECES: u32 = 128;

/// True if at most one root of a slope of this sign is proved, given the search for an end; none where the
/// slope depends on more than constants and the unknown.
pub(super) fn has_one_root(graph: &Graph, sought: &RootSearch, rises: bool) -> Option<bool> {
    let [_, slope, curvature] = sought.sides;
    let mut pieces = pieces(graph, sought.between, [slope, curvature])?;
    let course = pieces.try_fold(SlopeCourse::Before, |course, of_piece| {
        let with_the_trend = |sign: bool| sign == rises;
        let [slope, grows] = of_piece.map(|interval| interval?.sign().map(with_the_trend));
        course.after(slope, grows)
    });
    Some(course.is_some())
}

/// True if the slope is proved to have one sign on all pieces but the first and the last, and the side of
/// the equation that it belongs to is proved to be a finite number everywhere.
pub(super) fn is_steady(graph: &Graph, between: [Id; 2], side: Id, slope: Id) -> bool {
    let Some(pieces) = pieces(graph, between, [side, slope]) else { return false };
    let mut signs = Vec::new();
    for [side, slope] in pieces {
        if !side.is_some_and(|side| (side.high - side.low).is_finite()) {
            return false;
        }
        signs.push(slope.and_then(Interval::sign));
    }
    let inner = &signs[1..signs.len() - 1];
    inner[0].is_some() && inner.iter().all(|sign| *sign == inner[0])
}

/// The enclosures of these nodes on one piece of the bracket after the other; none where they depend on more
/// than constants and the unknown.
fn pieces<const N: usize>(
    graph: &Graph,
    between: [Id; 2],
    wanted: [Id; N],
) -> Option<impl Iterator<Item = [Option<Interval>; N]>> {
    let live = live(graph, &wanted, Path::Unchecked);
    let nodes: Vec<_> = live_nodes(graph, &live).collect();
    let is_known = |node: Node| match node {
        Node::Constant(_) | Node::Low(_) | Node::Trial(_) => true,
        Node::Solved(..) => false,
        node => {
            let mut operands = 0;
            node.for_operands(&mut |_| operands += 1);
            operands > 0
        }
    };
    let ends = between.map(|end| graph.as_constant(end).map(Exact::to_f64));
    let ([Some(from), Some(to)], true) = (ends, nodes.iter().all(|&(_, node)| is_known(node)))
    else {
        return None;
    };
    let at = move |piece: u32| from + (to - from) * (f64::from(piece) / f64::from(PIECES));
    // The value of a constant takes as long as a hundred operations.
    let mut values = vec![None; graph.len()];
    let is_constant = |node: Node| matches!(node, Node::Constant(_));
    for &(id, _) in nodes.iter().filter(|&&(_, node)| is_constant(node)) {
        values[id.index()] = graph.as_constant(id).map(|value| Interval::around(value.to_f64()));
    }
    let nodes: Vec<_> = nodes.into_iter().filter(|&(_, node)| !is_constant(node)).collect();
    Some((0..PIECES).map(move |piece| {
        let trial = Interval::of(at(piece), at(piece + 1)).widened();
        for &(id, node) in &nodes {
            values[id.index()] = value(&values, node, trial);
        }
        wanted.map(|id| values[id.index()])
    }))
}

/// Progress of the walk, by the slope's sign against that of the trend.
#[derive(Clone, Copy)]
pub enum SlopeCourse {
    /// The slope has not had the sign yet.
    Before,
    /// The slope has the sign, or may gain it in this piece and then keeps it.
    Within,
    /// The slope changes sign in this piece or a later one.
    Leaving,
    /// The slope no longer has the sign.
    Behind,
}

impl SlopeCourse {
    /// After a piece on which the slope has the trend's sign or the other, or where that is not known,
    /// its curvature has. None where the sign might come back.
    pub fn after(self, slope: Option<bool>, grows: Option<bool>) -> Option<Self> {
        Some(match (slope, grows, self) {
            (Some(true), _, Self::Before | Self::Within) => Self::Within,
            (Some(false), _, Self::Before) => Self::Before,
            (Some(false), ..) => Self::Behind,
            (None, Some(true), Self::Before | Self::Within) => Self::Within,
            // It has not the sign where this begins, and does not get it.
            (None, Some(false), Self::Behind) => Self::Behind,
            (None, Some(false), _) => Self::Leaving,
            _ => return None,
        })
    }
}

pub fn value(values: &[Option<Interval>], node: Node, trial: Interval) -> Option<Interval> {
    let v = |id: Id| values[id.index()];
    let product = |a: Id, b: Id| Some(v(a)?.times(v(b)?).widened());
    Some(match node {
        Node::Trial(_) => trial,
        // Parts of a rounding: in real numbers they are zero.
        Node::Low(_) | Node::MulErr(..) | Node::AddErr(..) => Interval::point(0.0),
        Node::Neg(a) => v(a)?.negated(),
        Node::Add(a, b) => v(a)?.plus(v(b)?).widened(),
        Node::Sub(a, b) => v(a)?.plus(v(b)?.negated()).widened(),
        Node::Mul(a, b) if a == b => v(a)?.squared().widened(),
        Node::Mul(a, b) => product(a, b)?,
        Node::Fused(a, b, c) => product(a, b)?.plus(v(c)?).widened(),
        Node::Det([a, b, c, d]) => product(a, b)?.plus(product(c, d)?.negated()).widened(),
        Node::Div(a, b) => v(a)?.times(v(b)?.reciprocal()?.widened()).widened(),
        Node::Apply(Function::Sqrt, a) => v(a)?.root()?.widened(),
        Node::Apply(Function::Sin, a) => v(a)?.wave(f64::sin, f64::cos),
        Node::Apply(Function::Cos, a) => v(a)?.wave(f64::cos, f64::sin),
        Node::Guard(a, _) => v(a)?,
        // Any other node has no enclosure.
        _ => return None,
    })
}

impl Interval {
    /// The numbers that are rounded to this.
    pub fn around(value: f64) -> Self {
        Self::point(value).widened()
    }

    /// With the rounding of the operation that made it.
    pub fn widened(self) -> Self {
        Self::of(self.low.next_down(), self.high.next_up())
    }

    /// Range of a sine or a cosine f: within |f′(m)| r + r²/2 of f(m). No library is wrong by more than
    /// 1e-14 at the angles of a turn.
    pub fn wave(self, f: fn(f64) -> f64, slope: fn(f64) -> f64) -> Self {
        let middle = 0.5 * (self.low + self.high);
        let radius = (self.high - middle).max(middle - self.low).next_up();
        let off = (slope(middle).abs() + 1e-14) * radius + 0.5 * radius * radius + 1e-14;
        let value = f(middle);
        Self::of((value - off).max(-1.0), (value + off).min(1.0)).widened()
    }
}
