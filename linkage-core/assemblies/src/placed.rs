//! A pinned group with the numbers of its places: its closures enclosed, those of one mode in plain numbers, and its assemblies.

use libm::{ilogb, scalbn, sqrt};

use crate::circle::{Budget, CircleOrigin, OnCircle, zeros};
use crate::closure::{Algebra, Twin, closure, product};
use crate::complex::Complex;
use crate::disc::Disc;
use crate::listed::{Assembly, List, Outcome, wrapped};
use crate::pinned::{BODIES, BodyPin, ClosureDegree, PinnedDyad, PinnedGroup, STANDING, TURNED};

/// The part of a bar's length, squared, within which a dyad is not said to fail.
const ROUNDING: f64 = 1e-9;
/// Tangents of half the angles from which the circle is divided. The second is for an assembly that lies where the first divides.
const ORIGINS: [f64; 2] = [0.187_5, 0.343_75];
/// The widths of angles within which the mode of a zero is looked for.
const WIDTHS: [f64; 4] = [1e-12, 1e-11, 1e-10, 1e-9];

/// A group in a pose of the inputs. The numbers of its places are taken as exact.
pub struct Placed<'g> {
    group: &'g PinnedGroup,
    degree: &'g ClosureDegree,
    places: &'g [[f64; 2]],
    left_out: [f64; 2],
    /// By body, the number of the place from which its coordinates are counted.
    origins: [usize; BODIES],
    /// A power of two, by which places are multiplied without rounding.
    scale: f64,
}

impl<'g> Placed<'g> {
    /// A group with its places, by their numbers in the coordinates of their bodies, and the vector along the link that was left out.
    ///
    /// None where a number is not finite, a place is missing, or a bar has no length.
    #[must_use]
    pub fn new(
        group: &'g PinnedGroup,
        degree: &'g ClosureDegree,
        (places, left_out): (&'g [[f64; 2]], [f64; 2]),
    ) -> Option<Self> {
        let mut origins = [0; BODIES];
        [origins[STANDING], origins[TURNED]] = group.pivot;
        for (_, dyad) in group.dyads() {
            for bar in dyad.bars {
                *origins.get_mut(bar.body)? = bar.ends[0];
            }
        }
        let mut placed = Self { group, degree, places, left_out, origins, scale: 1.0 };
        let mut size = left_out[0].abs().max(left_out[1].abs());
        let mut is_finite = left_out.iter().all(|number| number.is_finite());
        let on_bars = group.dyads().flat_map(|(_, dyad)| dyad.bars).flat_map(|bar| {
            let [_, place] = bar.ends;
            [bar.outer, BodyPin { body: bar.body, place }]
        });
        for at in group.pivots().into_iter().chain(group.equation).chain(on_bars) {
            // All places that are read, once.
            (at.body < BODIES && at.place < places.len()).then_some(())?;
            let Complex { x, y } = placed.at(at);
            size = size.max(x.abs()).max(y.abs());
            is_finite &= x.is_finite() && y.is_finite();
        }
        let has_bars = group.dyads().flat_map(|(_, dyad)| dyad.bars).all(|bar| {
            let [_, place] = bar.ends;
            placed.at(BodyPin { body: bar.body, place }).length() > 0.0
        });
        (is_finite && has_bars && size > 0.0).then_some(())?;
        placed.scale = scalbn(1.0, -ilogb(size));
        placed.scale.is_finite().then_some(placed)
    }

    /// A place in the coordinates of its body, counted from its origin.
    fn at(&self, at: BodyPin) -> Complex {
        let [place, origin] = [at.place, self.origins[at.body]].map(|index| self.places[index]);
        Complex { x: (place[0] - origin[0]) * self.scale, y: (place[1] - origin[1]) * self.scale }
    }

    /// The vector of a bar from its outer pin to the inner one.
    fn bar(&self, dyad: &PinnedDyad, index: usize) -> Complex {
        let bar = dyad.bars[index];
        self.at(BodyPin { body: bar.body, place: bar.ends[1] })
    }

    fn length_left_out(&self) -> Complex {
        let [x, y] = self.left_out.map(|part| part * self.scale);
        Complex { x, y }
    }

    /// The equation of one mode at an angle of the unknown; `None` where a dyad does not assemble.
    #[must_use]
    pub fn missed(&self, angle: f64, sides: usize) -> Option<f64> {
        let mut plain = Plain { of: self, turn: Complex::turned(angle), assembles: true };
        let missed = closure(self.group, &mut plain, sides, |_, _| {}).x;
        (plain.assembles && missed.is_finite()).then_some(missed)
    }

    /// All ways to assemble the group, by at most as many samples and pieces.
    ///
    /// `N` is the count of assemblies with complex coordinates, twice the degree.
    #[must_use]
    pub fn assemblies<const N: usize>(&self, budget: Budget) -> List<N> {
        let [first, second] = ORIGINS.map(|tangent| CircleOrigin { tangent });
        let first = self.assemblies_from(first, budget);
        if !matches!(first.outcome, Outcome::Open { .. }) {
            return first;
        }
        let left = Budget {
            samples: budget.samples - first.samples,
            pieces: budget.pieces - first.pieces,
        };
        let second: List<N> = self.assemblies_from(second, left);
        let (samples, pieces) = (first.samples + second.samples, first.pieces + second.pieces);
        let mut taken = if second.is_proved() { second } else { first };
        (taken.samples, taken.pieces) = (samples, pieces);
        taken
    }

    fn assemblies_from<const N: usize>(&self, origin: CircleOrigin, budget: Budget) -> List<N> {
        let mut list = List::new(Outcome::Proved);
        let mut unplaced = None;
        let found = |ends: [f64; 2]| match self.assembly(ends) {
            Some(assembly) if list.push(assembly) => {}
            _ => unplaced = unplaced.or(Some(ends)),
        };
        let searched = zeros(self, (self.degree.half, origin), budget, found);
        list.outcome = match (searched.outcome, unplaced) {
            (Outcome::Proved, Some([from, to])) => Outcome::Open { from, to },
            (outcome, _) => outcome,
        };
        (list.samples, list.pieces) = (searched.samples, searched.pieces);
        list.sort();
        list.search_within(|assembly, off| {
            self.missed(assembly.unknown + off, assembly.sides).is_some()
        });
        list
    }

    /// The assembly at a zero of the product: the only mode whose equation changes its sign there.
    fn assembly(&self, [from, to]: [f64; 2]) -> Option<Assembly> {
        WIDTHS.iter().find_map(|width| {
            let ends = [from - width, to + width];
            let mut changing = (0..1 << self.group.count()).filter_map(|sides| {
                let [low, high] = ends.map(|end| self.missed(end, sides));
                let (low, high) = low.zip(high)?;
                ((low > 0.0) != (high > 0.0)).then_some((sides, high > 0.0))
            });
            let (sides, rises) = changing.next()?;
            changing.next().is_none().then(|| {
                let root = self.root(ends, sides, rises);
                let unknown = wrapped(root);
                let between = ends.map(|end| end + (unknown - root));
                Assembly { unknown, between, sides, rises, room: 0.0, within: 0.0 }
            })
        })
    }

    /// The place at which the equation of a mode changes its sign, by halving.
    fn root(&self, [mut low, mut high]: [f64; 2], sides: usize, rises: bool) -> f64 {
        loop {
            let middle = (low + high) / 2.0;
            if !(low < middle && middle < high) {
                return middle;
            }
            let is_above = self.missed(middle, sides).is_some_and(|missed| missed > 0.0) == rises;
            match is_above {
                true => high = middle,
                false => low = middle,
            }
        }
    }
}

impl OnCircle for Placed<'_> {
    /// The product over all modes, with the powers of the bases.
    fn value(&self, turn: Disc) -> Disc {
        let mut enclosed = Enclosed { of: self, turn };
        product(self.group, self.degree, &mut enclosed, Disc::exact(1.0, 0.0))
    }

    /// True where a dyad on the turned body and on what stands still does not assemble: its base is longer than both bars, or shorter
    /// than their difference, by more than the base can change.
    fn has_none(&self, angle: f64, within: f64) -> bool {
        self.group.dyads().any(|(_, dyad)| {
            let hosts = dyad.bars.map(|bar| bar.outer);
            let [turned, standing] = match hosts.map(|host| host.body) {
                [TURNED, STANDING] => hosts,
                [STANDING, TURNED] => [hosts[1], hosts[0]],
                _ => return false,
            };
            // Both are counted from the pivot.
            let [arm, far] = [turned, standing].map(|host| self.at(host));
            let square = (Complex::turned(angle) * arm - far).square();
            let change = 2.0 * arm.length() * far.length() * within;
            let bars = [0, 1].map(|index| self.bar(dyad, index).length());
            let [sum, difference] =
                [bars[0] + bars[1], bars[0] - bars[1]].map(|length| length * length);
            let room = ROUNDING * (square + sum + change);
            square - change > sum + room || square + change < difference - room
        })
    }
}

/// A closure whose numbers hold its roundings.
struct Enclosed<'g> {
    of: &'g Placed<'g>,
    turn: Disc,
}

fn exact(Complex { x, y }: Complex) -> Twin<Disc> {
    let place = Disc::exact(x, y);
    [place, place.conjugate()]
}

impl Algebra for Enclosed<'_> {
    type Number = Disc;

    fn plus(&self, a: &Disc, b: &Disc) -> Disc {
        a.plus(*b)
    }

    fn minus(&self, a: &Disc, b: &Disc) -> Disc {
        a.minus(*b)
    }

    fn times(&self, a: &Disc, b: &Disc) -> Disc {
        a.times(*b)
    }

    fn inverse(&self, a: &Disc) -> Disc {
        a.inverse()
    }

    fn root(&mut self, square: Disc) -> Disc {
        square.root()
    }

    fn place(&self, at: BodyPin) -> Twin<Disc> {
        exact(self.of.at(at))
    }

    fn turn(&self) -> Twin<Disc> {
        [self.turn, self.turn.conjugate()]
    }

    fn left_out(&self) -> Twin<Disc> {
        exact(self.of.length_left_out())
    }
}

/// A closure of one mode where all dyads assemble.
struct Plain<'g> {
    of: &'g Placed<'g>,
    turn: Complex,
    assembles: bool,
}

impl Algebra for Plain<'_> {
    type Number = Complex;

    fn plus(&self, a: &Complex, b: &Complex) -> Complex {
        *a + *b
    }

    fn minus(&self, a: &Complex, b: &Complex) -> Complex {
        *a - *b
    }

    fn times(&self, a: &Complex, b: &Complex) -> Complex {
        *a * *b
    }

    fn inverse(&self, a: &Complex) -> Complex {
        let by = 1.0 / a.square();
        Complex { x: a.x * by, y: -a.y * by }
    }

    fn root(&mut self, square: Complex) -> Complex {
        self.assembles &= square.x <= 0.0;
        Complex { x: 0.0, y: sqrt((-square.x).max(0.0)) }
    }

    fn place(&self, at: BodyPin) -> Twin<Complex> {
        let place = self.of.at(at);
        [place, place.conjugate()]
    }

    fn turn(&self) -> Twin<Complex> {
        [self.turn, self.turn.conjugate()]
    }

    fn left_out(&self) -> Twin<Complex> {
        let way = self.of.length_left_out();
        [way, way.conjugate()]
    }
}
