//! The triangle of the joints B, D and C: what the position of the group is made of.

use std::ops::{Add, Mul, Sub};

use crate::equations::crank_pin::CrankPin;
use crate::equations::double_word::DoubleWord;
use crate::equations::motion::PointMotion;
use crate::equations::parts::GroupScope;
use crate::equations::symbol::{Sym, Vector};
use crate::ir::graph::Check;
use crate::model::mechanism::Numerics;

/// The bars as multiples of d and d⊥.
pub(super) struct Triangle<'s> {
    pub(super) lengths: [Sym<'s>; 2],
    /// d
    pub(super) line: Vector<'s>,
    /// The crank that B is the pin of, where it is one.
    pub(super) crank: Option<CrankPin<'s>>,
    /// i/2
    pub(super) half: Sym<'s>,
    /// 2 d·r₂ = 2a d² and −2 d·r₃ = 2b d²
    pub(super) shares: [Sym<'s>; 2],
    /// The place of the bar that is known not to be the longer one.
    shorter: Option<usize>,
    /// a and b
    along: [Sym<'s>; 2],
    /// h
    height: Sym<'s>,
    /// J
    pub(super) cross: Sym<'s>,
    /// 1/J
    pub(super) inverse: Sym<'s>,
    /// 1/l₂l₃
    over_product: Sym<'s>,
}

impl<'s> Triangle<'s> {
    /// 1/l of a bar.
    pub(super) fn over_length(&self, bar: usize) -> Sym<'s> {
        let (own, other) = (self.lengths[bar], self.lengths[1 - bar]);
        if own.is_constant() { own.recip() } else { other * self.over_product }
    }

    /// r₂ and r₃.
    pub(super) fn bars(&self, scope: &GroupScope<'s>) -> [Vector<'s>; 2] {
        let across = self.height * self.line.normal();
        scope.note("h n x", across.x);
        scope.note("h n y", across.y);
        self.both(self.line, across)
    }

    /// Images of both bars under a linear map, given those of d and h d⊥.
    fn both<V>(&self, line: V, across: V) -> [V; 2]
    where
        V: Copy + Add<Output = V> + Sub<Output = V>,
        Sym<'s>: Mul<V, Output = V>,
    {
        let [a, b] = self.along;
        let (second, third) = (|| a * line + across, || across - b * line);
        match self.shorter {
            // Halves of d cost nothing.
            _ if a.is_constant() => [second(), third()],
            Some(0) => [second(), second() - line],
            Some(_) => [third() + line, third()],
            None => [second(), third()],
        }
    }

    /// r × f of both bars, from d·f and d × f: they wait for h alone, and not for the bars.
    pub(super) fn crosses(&self, dot: Sym<'s>, cross: Sym<'s>) -> [Sym<'s>; 2] {
        self.both(cross, -(self.height * dot))
    }
}

/// i and 4 l₂ l₃ − i, which vanish at the inner and at the outer toggle.
struct Factors<'s> {
    near: Sym<'s>,
    far: Sym<'s>,
}

pub(super) fn triangle<'s>(
    scope: &GroupScope<'s>,
    joints: [PointMotion<'s>; 2],
    [l2, l3]: [Sym<'s>; 2],
    mode: Sym<'s>,
) -> Triangle<'s> {
    let line = scope.call_vector("d", joints[0].to(joints[1]));
    let is_compensated = scope.numerics == Numerics::Compensated;
    let crank = if is_compensated { None } else { CrankPin::of(joints) };
    let plain = scope.note("d d", line.dot(line));
    let square = plain.guarded_by(Check::SquareOfCentres, scope.group, &[line.x, line.y, l2, l3]);
    let one = line.x.builder().integer(1);
    let over_twice = scope.label("half over d2", one.half() / scope.label("d2", square));
    let difference = l2 - l3;
    let factors = if is_compensated {
        carried(line, [l2, l3])
    } else {
        let near = plain - difference.squared();
        Factors { near, far: (l2 * l3).twice().twice() - near }
    };
    let whole = scope.label("i", factors.near);
    let height = Height::of(scope, line, [l2, l3], factors, [plain, over_twice], mode);

    let shares = [l2 * difference, -(l3 * difference)].map(|shift| whole + shift.twice());
    let along = if difference.is_zero() {
        // d²/2d², an identity wherever 1/d² exists.
        [one.half(); 2]
    } else {
        // From i like J²: its rounding acts like one of d, and the bars keep their lengths.
        let decided = |name, share: Sym<'s>, [near, far]: [Sym<'s>; 2]| {
            let operands = [height.rounded, line.x, line.y, near, far, height.spread];
            scope.label(&format!("2 {name} d2"), share);
            let share = scope.note(&format!("{name} share"), share * over_twice);
            scope.label(name, share.guarded_by(Check::ShareOfCentres, scope.group, &operands))
        };
        [decided("a", shares[0], [l2, l3]), decided("b", shares[1], [l3, l2])]
    };
    let shorter = difference.constant_value().map(|difference| usize::from(difference > 0.0));
    Triangle {
        lengths: [l2, l3],
        line,
        crank,
        half: whole.half(),
        shares,
        shorter,
        along,
        height: height.height,
        cross: height.cross,
        inverse: height.inverse,
        over_product: height.over_product,
    }
}

/// The factors with the rounding errors of every sum and square put back.
fn carried<'s>(d: Vector<'s>, lengths: [Sym<'s>; 2]) -> Factors<'s> {
    let square = DoubleWord::square_of(d, DoubleWord::of_coordinate);
    let [l2, l3] = lengths.map(DoubleWord::of_sum);
    let near = square.difference((l2 - l3).squared());
    Factors { near, far: (l2 + l3).squared().difference(square) }
}

/// The height of C over d, and what follows from it.
struct Height<'s> {
    /// h
    height: Sym<'s>,
    /// J
    cross: Sym<'s>,
    /// 1/J
    inverse: Sym<'s>,
    /// 1/l₂l₃
    over_product: Sym<'s>,
    /// 4 J² or (J/l₂l₃)², as rounding leaves it.
    rounded: Sym<'s>,
    /// Its size, of which rounding takes last places.
    spread: Sym<'s>,
}

impl<'s> Height<'s> {
    fn of(
        scope: &GroupScope<'s>,
        d: Vector<'s>,
        [l2, l3]: [Sym<'s>; 2],
        Factors { near, far }: Factors<'s>,
        [of_line, over_twice]: [Sym<'s>; 2],
        mode: Sym<'s>,
    ) -> Self {
        let (product, one) = (l2 * l3, d.x.builder().integer(1));
        let over_product = product.recip();
        // 2 J in m², or J as a multiple of l₂l₃: the root. What its factors are scaled by, 1/J as a multiple of the
        // root's inverse, and 2 J and J as multiples of the root.
        let (scale, inverse, [twice, area], unit, of_constants) = if has_room([l2, l3], of_line) {
            let unit = product.twice().twice();
            (one, one.twice(), [one, one.half()], unit, unit)
        } else {
            (
                over_product.half(),
                over_product,
                [product.twice(), product],
                one.twice(),
                over_product,
            )
        };
        let rounded = scope.note("root squared", (near * scale) * (far * scale));
        let spread = match scope.numerics {
            // Factors that are wrong by last places of themselves.
            Numerics::Compensated => d.x.builder().zero(),
            Numerics::Plain if product.is_constant() => (l2 + l3).squared() * of_constants,
            Numerics::Plain => of_line * of_constants,
        };
        let circles = [d.x, d.y, l2, l3, unit, spread];
        let square = rounded.guarded_by(Check::ReachCircles, scope.group, &circles);
        let magnitude = square.sqrt();
        let root = mode * magnitude;
        // The other assembly of the same bars has it as well.
        let inverse = scope.label("inverse j", mode * scope.over_root(inverse, magnitude));
        scope.label("root", root);
        let height = scope.label("h", root * (twice * over_twice));
        Self { height, cross: area * root, inverse, over_product, rounded, spread }
    }
}

/// True if J² is known to lie well within the range of f32. It is compared down to 16 ε of its largest
/// value, (l₂ l₃)². With a cylinder and a bar between joints that stand still, J is at most d times the
/// bar; J² is compared where the cylinder is longer than 16 ε of the bar, above 256 ε² of (d l)².
fn has_room(lengths: [Sym<'_>; 2], of_line: Sym<'_>) -> bool {
    let largest = match lengths.map(Sym::constant_value) {
        [Some(l2), Some(l3)] => Some(l2 * l3),
        [Some(bar), None] | [None, Some(bar)] => {
            of_line.constant_value().map(|square| bar * square.sqrt())
        }
        [None, None] => None,
    };
    largest.is_some_and(|largest| (1e-12..1e12).contains(&largest.abs()))
}
