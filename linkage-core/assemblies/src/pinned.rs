//! The pins and bodies of a group that one unknown and dyads of bars place.

/// The number of all that stands still.
pub const STANDING: usize = 0;
/// The number of the body that the unknown turns.
pub const TURNED: usize = 1;
/// The most dyads of a group.
pub const DYADS: usize = 4;
/// The most bodies.
pub const BODIES: usize = 2 * DYADS + 2;

/// The most places of a group: two pivots, two outer pins and four ends of each dyad, and two pins of the equation.
pub const MOST_PLACES: usize = 4 + 6 * DYADS;

/// A pin as a point of a body: by the number of its place in the body's coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyPin {
    /// The body's number.
    pub body: usize,
    /// The place's number.
    pub place: usize,
}

/// A bar of a dyad: it hangs on a pin of another body and ends at the dyad's inner pin.
#[derive(Clone, Copy, Debug)]
pub struct HungBar {
    /// The bar's own number.
    pub body: usize,
    /// The pin of the other body.
    pub outer: BodyPin,
    /// The numbers of that pin's place and of the inner pin's, on the bar.
    pub ends: [usize; 2],
}

/// Two bars with a pin between them.
#[derive(Clone, Copy, Debug)]
pub struct PinnedDyad {
    /// The bars. The side of the inner pin is seen from the first bar's outer pin looking to the second's.
    pub bars: [HungBar; 2],
}

/// A group with one link left out: the distance of two pins is the equation.
#[derive(Clone, Copy, Debug)]
pub struct PinnedGroup {
    /// The pin about which the unknown turns its body: its place on what stands still, and on the body.
    pub pivot: [usize; 2],
    /// In the order in which they are placed, the last ones none.
    pub dyads: [Option<PinnedDyad>; DYADS],
    /// The pins of the link that was left out.
    pub equation: [BodyPin; 2],
}

impl PinnedGroup {
    /// The dyads with their indices.
    pub fn dyads(&self) -> impl Iterator<Item = (usize, &PinnedDyad)> {
        self.dyads.iter().flatten().enumerate()
    }

    /// The count of its dyads.
    #[must_use]
    pub fn count(&self) -> usize {
        self.dyads().count()
    }

    /// The pivot on what stands still, and on the body that the unknown turns.
    #[must_use]
    pub fn pivots(&self) -> [BodyPin; 2] {
        let [standing, turned] = self.pivot;
        [BodyPin { body: STANDING, place: standing }, BodyPin { body: TURNED, place: turned }]
    }
}

/// The powers of the dyads' bases by which a group's closure, multiplied over all modes, is a trigonometric polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ClosureDegree {
    /// By dyad.
    pub powers: [u32; DYADS],
    /// Its degree: half the count of assemblies with complex coordinates.
    pub half: usize,
}
