//! Writes the square of a distance from a point of the ground to a pin that turns about another as
//! what it is: affine in the cosine and sine of the angle.
//!
//! With x = a₀ + a₁ cos θ + a₂ sin θ and y = b₀ + b₁ cos θ + b₂ sin θ on a circle of radius l
//! (a₁² + b₁² = a₂² + b₂² = l², a₁ a₂ + b₁ b₂ = 0), cos² θ + sin² θ = 1 leaves
//!
//! ```text
//! x² + y² = k₀ + k₁ cos θ + k₂ sin θ       k₀ = a₀² + b₀² + l²
//!                                          k₁ = 2 (a₀ a₁ + b₀ b₁),  k₂ = 2 (a₀ a₂ + b₀ b₂)
//! ```
//!
//! which is known two or three operations earlier. Bounds over a stretch of the angle are tighter by it.
//! A constant that is added or taken away next stays what it is: in k₀ it would be rounded by itself, and a
//! group's height and shares, which are made of both, would agree less.
//!
//! # Error
//! In units of ε/2, with D the distance of the pivots: the affine form loses at most
//! k₀ + 2 |k| + d² (two constants, a product, a sum), where k₀ = D² + l² and |k| = 2 D l. The sum
//! of squares loses at least 4 |x| l |cos θ| + 2 x² + 2 d² where y vanishes (a constant, a
//! product, a difference, squares and their sum), which is where d² is smallest. The affine form
//! is chosen where the pin's longest distance is at most one and a half of its shortest, which is
//! D ≥ 5 l or l ≥ 5 D: at D = 5 l the two lose 62 l² and 80 l² at the shortest distance. Of nearer
//! circles a group's bars and rates, which are made of x and y as well, are less exact than by the sum of
//! squares, long before k₀ + k₁ cancels.

use std::cmp::Ordering;

use super::RULES;
use crate::exact::Exact;
use crate::function::Function;
use crate::ir::construct::{Maker, Moved, rebuild_with};
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::hash::Map;
use crate::ir::program::Program;

/// The program with squares of distances in their affine form, where that loses nothing.
pub fn square_distances(program: &Program) -> Program {
    let graph = &program.graph;
    let squares = squares(graph);
    rebuild_with(program, RULES, |maker, id, moved| squares.get(&id)?.make(maker, moved))
}

/// The squares of distances that are to be affine.
fn squares(graph: &Graph) -> Map<Id, AffineForm> {
    let forms = forms(graph);
    let square = |id| {
        let (x, y) = sum_of_squares(graph, id)?;
        let (x, y) = (forms[x.index()].as_ref()?, forms[y.index()].as_ref()?);
        Some((id, x.square_with(y)?))
    };
    graph.iter().filter_map(|(id, _)| square(id)).collect()
}

/// Operands of a sum of two squares, if no rounding error of the squares or of the sum is requested.
fn sum_of_squares(graph: &Graph, id: Id) -> Option<(Id, Id)> {
    let Node::Add(xx, yy) = graph.node(id) else { return None };
    let squared = |id| match graph.node(id) {
        Node::Mul(a, b) if a == b => Some(a),
        _ => None,
    };
    let (x, y) = (squared(xx)?, squared(yy)?);
    let asked =
        [Node::AddErr(xx, yy), Node::AddErr(yy, xx), Node::MulErr(x, x), Node::MulErr(y, y)];
    asked.into_iter().all(|error| graph.find(error).is_none()).then_some((x, y))
}

/// The angle whose cosine and sine a value is affine in, by the nodes that hold these.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Rotation {
    By(Id),
    Given(u32),
}

/// k₀ + k₁ cos θ + k₂ sin θ; no angle where it is constant.
#[derive(Clone)]
struct AffineForm {
    turn: Option<Rotation>,
    terms: [Exact; 3],
}

/// The form of every node that has one.
fn forms(graph: &Graph) -> Vec<Option<AffineForm>> {
    let mut forms: Vec<Option<AffineForm>> = Vec::with_capacity(graph.len());
    for (_, node) in graph.iter() {
        let of = |id: Id| forms[id.index()].as_ref();
        let form = match node {
            Node::Constant(constant) => Some(AffineForm::constant(graph.value(constant).clone())),
            Node::Apply(Function::Cos, angle) => Some(AffineForm::of(Rotation::By(angle), 1)),
            Node::Apply(Function::Sin, angle) => Some(AffineForm::of(Rotation::By(angle), 2)),
            Node::InputCos(input) => Some(AffineForm::of(Rotation::Given(input), 1)),
            Node::InputSin(input) => Some(AffineForm::of(Rotation::Given(input), 2)),
            Node::Neg(a) => of(a).map(|a| a.scaled(&Exact::integer(-1))),
            Node::Add(a, b) => of(a).zip(of(b)).and_then(|(a, b)| a.plus(b)),
            Node::Sub(a, b) => {
                of(a).zip(of(b)).and_then(|(a, b)| a.plus(&b.scaled(&Exact::integer(-1))))
            }
            Node::Mul(a, b) => of(a).zip(of(b)).and_then(|(a, b)| a.times(b)),
            _ => None,
        };
        forms.push(form);
    }
    forms
}

impl AffineForm {
    fn constant(value: Exact) -> Self {
        Self { turn: None, terms: [value, Exact::integer(0), Exact::integer(0)] }
    }

    fn of(turn: Rotation, term: usize) -> Self {
        let terms = [0, 1, 2].map(|i| Exact::integer(i64::from(i == term)));
        Self { turn: Some(turn), terms }
    }

    fn scaled(&self, factor: &Exact) -> Self {
        Self { turn: self.turn, terms: self.terms.each_ref().map(|term| term.mul(factor)) }
    }

    /// The angle of both, if they do not turn by different ones.
    fn common(&self, other: &Self) -> Option<Option<Rotation>> {
        match (self.turn, other.turn) {
            (Some(one), Some(another)) => (one == another).then_some(Some(one)),
            (one, another) => Some(one.or(another)),
        }
    }

    fn plus(&self, other: &Self) -> Option<Self> {
        let turn = self.common(other)?;
        let terms = [0, 1, 2].map(|i| self.terms[i].add(&other.terms[i]));
        Some(Self { turn, terms })
    }

    fn times(&self, other: &Self) -> Option<Self> {
        match (self.turn, other.turn) {
            (None, _) => Some(other.scaled(&self.terms[0])),
            (_, None) => Some(self.scaled(&other.terms[0])),
            _ => None,
        }
    }

    /// self² + other², where both move on a circle about a point far enough away or near enough.
    fn square_with(&self, other: &Self) -> Option<Self> {
        let turn = self.common(other)?;
        let dot = |i: usize, k: usize| {
            self.terms[i].mul(&self.terms[k]).add(&other.terms[i].mul(&other.terms[k]))
        };
        let radius = dot(1, 1);
        let on_circle = radius.cmp_value(&dot(2, 2)).is_eq() && dot(1, 2).is_zero();
        if !on_circle {
            return None;
        }
        let mean = dot(0, 0).add(&radius);
        let [cos, sin] = [dot(0, 1), dot(0, 2)].map(|term| term.add(&term));
        // 4 (D + l)² ≤ 9 (D − l)²  ⇔  13 |k| ≤ 5 k₀
        let of_squares = |factor: i64, square: Exact| square.mul(&Exact::integer(factor));
        let amplitude = of_squares(169, cos.mul(&cos).add(&sin.mul(&sin)));
        let bound = of_squares(25, mean.mul(&mean));
        let keeps_its_digits = amplitude.cmp_value(&bound) != Ordering::Greater;
        keeps_its_digits.then_some(Self { turn, terms: [mean, cos, sin] })
    }

    fn make(&self, maker: &mut Maker<'_>, moved: &Moved) -> Option<Id> {
        let [cos, sin] = match self.turn? {
            Rotation::By(angle) => [
                Node::Apply(Function::Cos, moved.of(angle)),
                Node::Apply(Function::Sin, moved.of(angle)),
            ],
            Rotation::Given(input) => [Node::InputCos(input), Node::InputSin(input)],
        };
        let mut sum = maker.constant(self.terms[0].clone());
        for (node, coefficient) in [cos, sin].into_iter().zip(&self.terms[1..]) {
            let (node, coefficient) = (maker.make(node), maker.constant(coefficient.clone()));
            let term = maker.make(Node::Mul(coefficient, node));
            sum = maker.make(Node::Add(sum, term));
        }
        Some(sum)
    }
}
