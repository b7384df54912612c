//! The closure of a pinned group over any numbers: what its equation is off by.
//!
//! Points stand for themselves and for their conjugates, which are numbers of their own where a dyad does not assemble.
//! With a dyad's base B from U to V, its bars a and b, and h = B B̄ + a ā − b b̄, its inner pin is U + B (h + s)/(2 B B̄),
//! where s² = h² − 4 a ā B B̄: two circles, intersected. A dyad assembles where s² is negative, and the two roots are
//! its sides.

use core::array::from_fn;

use crate::pinned::{BODIES, BodyPin, ClosureDegree, DYADS, HungBar, PinnedDyad, PinnedGroup};

/// A number and its conjugate.
pub type Twin<N> = [N; 2];

/// The numbers by which a closure is computed.
pub trait Algebra {
    /// A number.
    type Number: Clone;
    /// a + b.
    fn plus(&self, a: &Self::Number, b: &Self::Number) -> Self::Number;
    /// a − b.
    fn minus(&self, a: &Self::Number, b: &Self::Number) -> Self::Number;
    /// a b.
    fn times(&self, a: &Self::Number, b: &Self::Number) -> Self::Number;
    /// 1/a.
    fn inverse(&self, a: &Self::Number) -> Self::Number;
    /// The root of a dyad's s², with a positive imaginary part where s² is negative: where the inner pin is on the left.
    fn root(&mut self, square: Self::Number) -> Self::Number;
    /// A pin in the coordinates of a body.
    fn place(&self, at: BodyPin) -> Twin<Self::Number>;
    /// The turning of the body that the unknown turns.
    fn turn(&self) -> Twin<Self::Number>;
    /// The vector between the pins of the link that was left out, in the link's coordinates.
    fn left_out(&self) -> Twin<Self::Number>;
}

/// A body's motion: z ↦ shift + turn z.
struct BodyMotion<N> {
    shift: Twin<N>,
    turn: Twin<N>,
}

/// A dyad on its outer pins, on neither side yet.
struct Triangle<N> {
    outer: [Twin<N>; 2],
    span: Twin<N>,
    /// B B̄.
    base: N,
    /// h.
    along: N,
    /// A root s.
    root: N,
    /// 1/(2 B B̄).
    part: N,
}

/// A computation in one algebra: the bodies that are placed so far.
struct Closing<'a, A: Algebra> {
    group: &'a PinnedGroup,
    algebra: &'a mut A,
    of: [Option<BodyMotion<A::Number>>; BODIES],
}

impl<'a, A: Algebra> Closing<'a, A> {
    /// The driven body at its angle.
    fn begin(group: &'a PinnedGroup, algebra: &'a mut A) -> Self {
        let mut closing = Self { group, algebra, of: from_fn(|_| None) };
        let [standing, turned] = group.pivots();
        let (to, turn) = (closing.algebra.place(standing), closing.algebra.turn());
        closing.take(turned, &to, turn);
        closing
    }

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

    /// The vectors of a dyad's bars, from their outer pins.
    fn bars(&self, dyad: &PinnedDyad) -> [Twin<A::Number>; 2] {
        dyad.bars.map(|bar| {
            let [outer, inner] =
                bar.ends.map(|place| self.algebra.place(BodyPin { body: bar.body, place }));
            self.minus(&inner, &outer)
        })
    }

    fn triangle(&mut self, dyad: &PinnedDyad) -> Triangle<A::Number> {
        let outer = dyad.bars.map(|bar| self.point(bar.outer));
        let bars = self.bars(dyad);
        let span = self.minus(&outer[1], &outer[0]);
        let [base, first, second] = [&span, &bars[0], &bars[1]].map(|way| self.square(way));
        let along = self.algebra.minus(&self.algebra.plus(&base, &first), &second);
        let twice = self.algebra.plus(&base, &base);
        let both = self.algebra.times(&self.algebra.plus(&first, &first), &twice);
        let square = self.algebra.minus(&self.algebra.times(&along, &along), &both);
        let (root, part) = (self.algebra.root(square), self.algebra.inverse(&twice));
        Triangle { outer, span, base, along, root, part }
    }

    /// Places the bars of a dyad on a side.
    fn assemble(&mut self, dyad: &PinnedDyad, of: &Triangle<A::Number>, is_left: bool) {
        let sum = self.algebra.plus(&of.along, &of.root);
        let difference = self.algebra.minus(&of.along, &of.root);
        let sides = if is_left { [sum, difference] } else { [difference, sum] };
        let sides = sides.map(|side| self.algebra.times(&side, &of.part));
        let way = self.times(&of.span, &sides);
        let ways = [way.clone(), self.minus(&way, &of.span)];
        let bars = self.bars(dyad);
        for i in 0..2 {
            let inverse = bars[i].each_ref().map(|part| self.algebra.inverse(part));
            let turn = self.times(&ways[i], &inverse);
            let HungBar { body, ends: [place, _], .. } = dyad.bars[i];
            self.take(BodyPin { body, place }, &of.outer[i], turn);
        }
    }

    /// The square of the distance of the equation's pins less that of the link's length.
    fn missed(&self) -> A::Number {
        let [first, second] = self.group.equation.map(|at| self.point(at));
        let missed = self.square(&self.minus(&first, &second));
        let length = self.square(&self.algebra.left_out());
        self.algebra.minus(&missed, &length)
    }
}

/// The square of the distance of the equation's pins less that of the link's length, in one mode: the dyads whose bits of `sides` are
/// set are on the left. Each dyad's B B̄ is handed over by its index.
pub fn closure<A: Algebra>(
    group: &PinnedGroup,
    algebra: &mut A,
    sides: usize,
    mut base: impl FnMut(usize, &A::Number),
) -> A::Number {
    let mut closing = Closing::begin(group, algebra);
    for (index, dyad) in group.dyads() {
        let triangle = closing.triangle(dyad);
        base(index, &triangle.base);
        closing.assemble(dyad, &triangle, sides >> index & 1 == 1);
    }
    closing.missed()
}

/// The product of the closures of all modes, with the powers of the dyads' bases, times a number.
///
/// A dyad is placed once for all sides of those behind it: the last one changes its side first.
pub fn product<A: Algebra>(
    group: &PinnedGroup,
    degree: &ClosureDegree,
    algebra: &mut A,
    times: A::Number,
) -> A::Number {
    let mut closing = Closing::begin(group, algebra);
    let mut triangles: [Option<Triangle<A::Number>>; DYADS] = from_fn(|_| None);
    let (count, mut all) = (group.count(), times);
    for mode in 0..1_usize << count {
        for (index, dyad) in group.dyads() {
            // The bit of this dyad changes, or one before it, where the bits behind it are zero.
            let behind = mode & ((1 << (count - 1 - index)) - 1);
            if behind != 0 {
                continue;
            }
            let is_left = mode >> (count - 1 - index) & 1 == 1;
            if !is_left {
                let triangle = closing.triangle(dyad);
                for _ in 0..degree.powers[index] {
                    all = closing.algebra.times(&all, &triangle.base);
                }
                triangles[index] = Some(triangle);
            }
            if let Some(triangle) = &triangles[index] {
                closing.assemble(dyad, triangle, is_left);
            }
        }
        all = closing.algebra.times(&all, &closing.missed());
    }
    all
}
