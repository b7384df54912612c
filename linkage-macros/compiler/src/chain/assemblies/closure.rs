//! The closure of a pinned group over any numbers: what its equation is off by.
//!
//! Points stand for themselves and for their conjugates, which are numbers of their own where a dyad does not assemble.
//! With a dyad's base B from U to V, its bars a and b, and h = B B̄ + a ā − b b̄, its inner pin is U + B (h + s)/(2 B B̄),
//! where s² = h² − 4 a ā B B̄: two circles, intersected. A dyad assembles where s² is negative, and the two roots are
//! its sides.

use std::array::from_fn;

use super::pinned::{BODIES, BodyPin, PinnedGroup, STANDING, TURNED};

/// A number and its conjugate.
pub(super) type Twin<N> = [N; 2];

/// The numbers by which a closure is computed.
pub(super) trait Algebra {
    type Number: Clone;
    fn plus(&self, a: &Self::Number, b: &Self::Number) -> Self::Number;
    fn minus(&self, a: &Self::Number, b: &Self::Number) -> Self::Number;
    fn times(&self, a: &Self::Number, b: &Self::Number) -> Self::Number;
    fn inverse(&self, a: &Self::Number) -> Self::Number;
    /// The root of the next dyad's s², on the side in which it is looked at.
    fn root(&mut self, square: Self::Number) -> Self::Number;
    /// A pin in the coordinates of a body.
    fn place(&self, at: BodyPin) -> Twin<Self::Number>;
    /// The turning of the body that the unknown turns.
    fn turn(&self) -> Twin<Self::Number>;
    /// The vector between the pins of the link that was left out.
    fn left_out(&self) -> Twin<Self::Number>;
}

/// A body's motion: z ↦ shift + turn z.
#[derive(Clone)]
struct BodyMotion<N> {
    shift: Twin<N>,
    turn: Twin<N>,
}

/// A computation in one algebra: the bodies that are placed so far.
struct Closing<'a, A: Algebra> {
    algebra: &'a mut A,
    of: [Option<BodyMotion<A::Number>>; BODIES],
}

impl<A: Algebra> Closing<'_, A> {
    fn plus(&self, a: &Twin<A::Number>, b: &Twin<A::Number>) -> Twin<A::Number> {
        from_fn(|i| self.algebra.plus(&a[i], &b[i]))
    }

    fn minus(&self, a: &Twin<A::Number>, b: &Twin<A::Number>) -> Twin<A::Number> {
        from_fn(|i| self.algebra.minus(&a[i], &b[i]))
    }

    fn times(&self, a: &Twin<A::Number>, b: &Twin<A::Number>) -> Twin<A::Number> {
        from_fn(|i| self.algebra.times(&a[i], &b[i]))
    }

    /// The square of a vector's length.
    fn square(&self, vector: &Twin<A::Number>) -> A::Number {
        self.algebra.times(&vector[0], &vector[1])
    }

    fn point(&self, at: BodyPin) -> Twin<A::Number> {
        let local = self.algebra.place(at);
        match &self.of[at.body] {
            Some(BodyMotion { shift, turn }) => self.plus(shift, &self.times(turn, &local)),
            None => local,
        }
    }

    /// Places a body by its turning and a pin.
    fn take(&mut self, at: BodyPin, to: &Twin<A::Number>, turn: Twin<A::Number>) {
        let shift = self.minus(to, &self.times(&turn, &self.algebra.place(at)));
        self.of[at.body] = Some(BodyMotion { shift, turn });
    }
}

/// The square of the distance of the equation's pins less that of the link's length. Each dyad's B B̄ is handed over by
/// its index.
pub(super) fn closure<A: Algebra>(
    group: &PinnedGroup,
    algebra: &mut A,
    mut base: impl FnMut(usize, &A::Number),
) -> A::Number {
    let mut closing = Closing { algebra, of: from_fn(|_| None) };
    let [pivot, turned] = [STANDING, TURNED].map(|body| BodyPin { body, pin: group.pivot });
    let (to, turn) = (closing.algebra.place(pivot), closing.algebra.turn());
    closing.take(turned, &to, turn);
    for (index, dyad) in group.dyads.iter().enumerate() {
        let from = dyad.bars.map(|bar| closing.point(bar.outer));
        let pins = dyad
            .bars
            .map(|bar| [bar.outer.pin, dyad.inner].map(|pin| BodyPin { body: bar.body, pin }));
        let bars = pins.map(|[outer, inner]| {
            closing.minus(&closing.algebra.place(inner), &closing.algebra.place(outer))
        });
        let span = closing.minus(&from[1], &from[0]);
        let [far, first, second] = [&span, &bars[0], &bars[1]].map(|way| closing.square(way));
        base(index, &far);
        let along = closing.algebra.minus(&closing.algebra.plus(&far, &first), &second);
        let twice = closing.algebra.plus(&far, &far);
        let both = closing.algebra.times(&closing.algebra.plus(&first, &first), &twice);
        let square = closing.algebra.minus(&closing.algebra.times(&along, &along), &both);
        let root = closing.algebra.root(square);
        let part = closing.algebra.inverse(&twice);
        let sides = [closing.algebra.plus(&along, &root), closing.algebra.minus(&along, &root)];
        let sides = sides.map(|side| closing.algebra.times(&side, &part));
        let way = closing.times(&span, &sides);
        let ways = [way.clone(), closing.minus(&way, &span)];
        for i in 0..2 {
            let bar = bars[i].each_ref().map(|part| closing.algebra.inverse(part));
            let turn = closing.times(&ways[i], &bar);
            closing.take(pins[i][0], &from[i], turn);
        }
    }
    let [first, second] = group.equation.map(|at| closing.point(at));
    let missed = closing.square(&closing.minus(&first, &second));
    let length = closing.algebra.left_out();
    let length = closing.square(&length);
    closing.algebra.minus(&missed, &length)
}
