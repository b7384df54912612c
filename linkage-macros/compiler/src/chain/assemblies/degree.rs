//! The powers of the dyads' bases that make the closure's product over all modes a polynomial, and its degree.
//!
//! A closure is rational in z = e^{iφ}, and its product over all modes has poles only where a dyad's base has no length.
//! Times powers of the bases it is zⁿ-fold a polynomial of degree 2n in z, whose zeros are the complex assemblies: a trigonometric
//! polynomial of degree n in φ. The powers are those of a kind of group, whatever its lengths are, and are found for lengths
//! that are residues of a prime: no rounding decides.

use linkage_assemblies::{
    Algebra, BodyPin, ClosureDegree, DYADS, MOST_DEGREE, PinnedGroup, Twin, closure,
};

use super::tower::{PRIME, Residues, Tower, power, product, reciprocal};

/// The greatest power that is tried.
const MOST_POWER: u32 = 10;
/// A polynomial of degree d has no divided difference over d + 2 points; two of these are looked at.
const POINTS: usize = 2 * MOST_DEGREE + 3;

/// The powers and the degree of a kind of group; `None` where no powers up to ten make one up to thirty.
pub fn degree(group: &PinnedGroup) -> Option<ClosureDegree> {
    let samples: Vec<_> = (0..POINTS).map(|index| Sampled::of(group, point(index))).collect();
    let weights = [0, 1].map(|first| weights(first, POINTS - 1));
    let powers = all_powers(group.count()).into_iter().find(|powers| {
        let values: Vec<_> =
            samples.iter().map(|sample| sample.value(powers, MOST_DEGREE)).collect();
        (0..2).all(|first| divided_difference(&values[first..], &weights[first]) == 0)
    })?;
    // With the true degree the values are those of a polynomial, with a lower one they are not.
    let half = (0..=MOST_DEGREE).find(|&half| {
        let count = 2 * half + 2;
        (0..2).all(|first| {
            let values = samples[first..first + count].iter();
            let values: Vec<_> = values.map(|sample| sample.value(&powers, half)).collect();
            divided_difference(&values, &self::weights(first, count)) == 0
        })
    })?;
    (half > 0).then_some(ClosureDegree { powers, half })
}

/// All powers of so many bases, those with the least sums first.
fn all_powers(bases: usize) -> Vec<[u32; DYADS]> {
    let mut all = vec![[0; DYADS]];
    for base in 0..bases {
        let with = |powers: [u32; DYADS], power: u32| {
            let mut powers = powers;
            powers[base] = power;
            powers
        };
        let longer =
            |&powers: &[u32; DYADS]| (0..=MOST_POWER).map(move |power| with(powers, power));
        all = all.iter().flat_map(longer).collect();
    }
    all.sort_by_key(|powers| powers.iter().sum::<u32>());
    all
}

/// A residue at which a polynomial is looked at.
fn point(index: usize) -> u64 {
    product(7919, index as u64 + 2)
}

/// The weights of the values in a divided difference over a row of points.
fn weights(first: usize, count: usize) -> Vec<u64> {
    let points = || (first..first + count).map(point);
    let weight = |at: u64| {
        let others = points().filter(|&other| other != at);
        reciprocal(others.fold(1, |all, other| product(all, (at + PRIME - other) % PRIME)))
    };
    points().map(weight).collect()
}

fn divided_difference(values: &[u64], weights: &[u64]) -> u64 {
    values
        .iter()
        .zip(weights)
        .fold(0, |sum, (&value, &weight)| (sum + product(value, weight)) % PRIME)
}

/// The sides of the dyads: each root stands for both.
const SIDES: usize = 0;

/// The products over all modes at a point.
struct Sampled {
    at: u64,
    closure: u64,
    bases: Vec<u64>,
}

impl Sampled {
    fn of(group: &PinnedGroup, at: u64) -> Self {
        let mut field = AtPoint { at, tower: Tower::default() };
        let mut bases = Vec::new();
        let closure = closure(group, &mut field, SIDES, |_, base| bases.push(base.clone()));
        let norm = |(roots, base): (usize, &Residues)| field.tower.norm(base, roots);
        let bases = bases.iter().enumerate().map(norm).collect();
        Self { at, closure: field.tower.norm(&closure, group.count()), bases }
    }

    /// The product with these powers of the bases, times zⁿ.
    fn value(&self, powers: &[u32; DYADS], half: usize) -> u64 {
        let bases = self.bases.iter().zip(powers);
        let value =
            bases.fold(self.closure, |all, (&base, &by)| product(all, power(base, by.into())));
        product(value, power(self.at, half as u64))
    }
}

/// Lengths that are residues: points and their conjugates are independent, as those of complex lengths are.
struct AtPoint {
    at: u64,
    tower: Tower,
}

/// A residue for each coordinate of a pin on a body, by the finalizer of SplitMix64.
fn residue(body: usize, pin: usize, part: u64) -> u64 {
    let mut bits =
        (((body as u64) << 32 | pin as u64) << 1 | part).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    (bits ^ (bits >> 31)) % (PRIME - 1) + 1
}

/// The number of the link that was left out: that of no body.
const LEFT_OUT: usize = 1 << 20;

impl Algebra for AtPoint {
    type Number = Residues;

    fn plus(&self, a: &Residues, b: &Residues) -> Residues {
        self.tower.plus(a, b)
    }

    fn minus(&self, a: &Residues, b: &Residues) -> Residues {
        self.tower.minus(a, b)
    }

    fn times(&self, a: &Residues, b: &Residues) -> Residues {
        self.tower.times(a, b)
    }

    fn inverse(&self, a: &Residues) -> Residues {
        self.tower.inverse(a)
    }

    fn root(&mut self, square: Residues) -> Residues {
        self.tower.adjoin(square)
    }

    fn place(&self, at: BodyPin) -> Twin<Residues> {
        [0, 1].map(|part| vec![residue(at.body, at.place, part)])
    }

    fn turn(&self) -> Twin<Residues> {
        [vec![self.at], vec![reciprocal(self.at)]]
    }

    fn left_out(&self) -> Twin<Residues> {
        [0, 1].map(|part| vec![residue(LEFT_OUT, 0, part)])
    }
}
