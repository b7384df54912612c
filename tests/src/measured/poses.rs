//! Random poses of every group: of any proportion, at any place and of any size, half of them
//! next to a limit, at a distance from it that is as likely to be 1e-15 as 1e-1.

use core::f64::consts::TAU;

use super::Pose;
use crate::random::Random;

/// Random numbers as poses need them.
pub struct Source(Random);

impl Source {
    pub fn new(seed: u64) -> Self {
        Self(Random::new(seed))
    }

    /// Uniform in [0, 1), to 53 bits.
    pub fn unit(&mut self) -> f64 {
        self.0.unit()
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + self.unit() * (high - low)
    }

    /// A power of ten with an exponent between the two.
    pub fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        10.0_f64.powf(self.between(low, high))
    }

    pub fn coin(&mut self) -> bool {
        self.unit() < 0.5
    }

    fn sign(&mut self) -> f64 {
        if self.coin() { 1.0 } else { -1.0 }
    }

    fn signed(&mut self, size: f64) -> f64 {
        size * self.sign() * self.magnitude(-1.0, 1.0)
    }

    /// A point up to ten times `size` away, often the origin.
    fn place(&mut self, size: f64) -> [f64; 2] {
        if self.unit() < 0.3 {
            return [0.0; 2];
        }
        let (far, turn) = (size * self.magnitude(-1.0, 1.0), self.angle());
        [far * turn.cos(), far * turn.sin()]
    }

    pub fn angle(&mut self) -> f64 {
        self.between(-TAU / 2.0, TAU / 2.0)
    }

    /// A share of 1: anything, or almost all or nothing of it.
    fn share(&mut self) -> f64 {
        match (self.unit() * 4.0) as u8 {
            0 | 1 => self.unit(),
            2 => self.magnitude(-15.0, -1.0),
            _ => 1.0 - self.magnitude(-15.0, -1.0),
        }
    }

    fn rates<const I: usize>(&mut self, sizes: [f64; I]) -> [f64; I] {
        sizes.map(|size| self.signed(size))
    }
}

/// The pose as a whole: rates for its inputs, lengths of the order of `size`.
fn moving<const I: usize, const P: usize>(
    source: &mut Source,
    q: [f64; I],
    sizes: [f64; I],
    params: [f64; P],
) -> Pose<I, P> {
    let (rate, second) = (source.rates(sizes), source.rates(sizes));
    Pose { q, rate, second, params, plus: source.coin() }
}

pub fn rrr(source: &mut Source) -> Pose<4, 2> {
    let size = source.magnitude(-3.0, 3.0);
    let l = [0, 1].map(|_| size * source.magnitude(-1.0, 1.0));
    let (least, most) = ((l[0] - l[1]).abs(), l[0] + l[1]);
    let (d, turn) = (least + source.share() * (most - least), source.angle());
    let b = source.place(size);
    let q = [b[0], b[1], b[0] + d * turn.cos(), b[1] + d * turn.sin()];
    moving(source, q, [size; 4], l)
}

pub fn rrp(source: &mut Source) -> Pose<5, 2> {
    let size = source.magnitude(-3.0, 3.0);
    let (l, e) = (size * source.magnitude(-1.0, 1.0), size * source.between(-1.0, 1.0));
    let (k, phi) = (source.place(size), source.angle());
    let (x, y) = (size * source.between(-3.0, 3.0), e - source.sign() * l * source.share());
    let q = [
        k[0] + x * phi.cos() - y * phi.sin(),
        k[1] + x * phi.sin() + y * phi.cos(),
        k[0],
        k[1],
        phi,
    ];
    moving(source, q, [size, size, size, size, 1.0], [l, e])
}

pub fn rpr(source: &mut Source) -> Pose<4, 1> {
    let size = source.magnitude(-3.0, 3.0);
    let b = size * source.magnitude(-1.0, 1.0);
    let (e, turn) = (source.sign() * b * source.share(), source.angle());
    let d = source.place(size);
    let q = [d[0] + b * turn.cos(), d[1] + b * turn.sin(), d[0], d[1]];
    moving(source, q, [size; 4], [e])
}

pub fn prp(source: &mut Source) -> Pose<6, 2> {
    let size = source.magnitude(-3.0, 3.0);
    let (k, j, phi) = (source.place(size), source.place(size), source.angle());
    let psi = phi + source.sign() * source.share() * TAU / 4.0;
    let e = [0, 1].map(|_| size * source.between(-1.0, 1.0));
    moving(source, [k[0], k[1], phi, j[0], j[1], psi], [size, size, 1.0, size, size, 1.0], e)
}

pub fn rpp(source: &mut Source) -> Pose<5, 3> {
    let size = source.magnitude(-3.0, 3.0);
    let (b, k, phi) = (source.place(size), source.place(size), source.angle());
    let slot = source.sign() * source.share() * TAU / 4.0;
    let e = [0, 1].map(|_| size * source.between(-1.0, 1.0));
    let q = [b[0], b[1], k[0], k[1], phi];
    moving(source, q, [size, size, size, size, 1.0], [slot, e[0], e[1]])
}
