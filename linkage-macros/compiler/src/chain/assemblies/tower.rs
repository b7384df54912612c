//! Numbers of a prime field, with square roots adjoined one after the other.

/// The prime 2³¹ − 1: a product of two residues fits into 64 bits.
pub const PRIME: u64 = (1 << 31) - 1;

pub fn product(a: u64, b: u64) -> u64 {
    a * b % PRIME
}

pub(super) fn power(mut base: u64, mut exponent: u64) -> u64 {
    let mut power = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            power = product(power, base);
        }
        base = product(base, base);
        exponent >>= 1;
    }
    power
}

/// By Fermat's theorem; zero for zero.
pub fn reciprocal(a: u64) -> u64 {
    power(a, PRIME - 2)
}

/// A number x + y s of a level: the first half of its residues is x, the second y, each of the level below. At the lowest level it is one
/// residue.
pub(super) type Residues = Vec<u64>;

/// The squares of the roots that were adjoined: each is a number of the level below its root.
#[derive(Default)]
pub struct Tower {
    squares: Vec<Residues>,
}

impl Tower {
    /// Adjoins the root of a number.
    pub fn adjoin(&mut self, square: Residues) -> Residues {
        let size = 1 << self.squares.len();
        self.squares.push(padded(square, size));
        let mut root = vec![0; 2 * size];
        root[size] = 1;
        root
    }

    fn square(&self, half: usize) -> &Residues {
        &self.squares[half.ilog2() as usize]
    }

    pub fn plus(&self, a: &[u64], b: &[u64]) -> Residues {
        self.by_parts(a, b, |a, b| (a + b) % PRIME)
    }

    pub fn minus(&self, a: &[u64], b: &[u64]) -> Residues {
        self.by_parts(a, b, |a, b| (a + PRIME - b) % PRIME)
    }

    fn by_parts(&self, a: &[u64], b: &[u64], of: impl Fn(u64, u64) -> u64) -> Residues {
        let part = |all: &[u64], index: usize| all.get(index).copied().unwrap_or(0);
        (0..a.len().max(b.len())).map(|index| of(part(a, index), part(b, index))).collect()
    }

    /// (x + y s) (u + v s) = x u + y v s² + (x v + y u) s.
    pub fn times(&self, a: &[u64], b: &[u64]) -> Residues {
        let (a, b) = if a.len() < b.len() { (b, a) } else { (a, b) };
        if let [a] = a {
            return vec![product(*a, b[0])];
        }
        let (x, y) = a.split_at(a.len() / 2);
        let [real, root] = if b.len() < a.len() {
            [self.times(x, b), self.times(y, b)]
        } else {
            let (u, v) = b.split_at(x.len());
            let squares = self.times(&self.times(y, v), self.square(x.len()));
            let mixed = self.plus(&self.times(x, v), &self.times(y, u));
            [self.plus(&self.times(x, u), &squares), mixed]
        };
        [padded(real, x.len()), padded(root, x.len())].concat()
    }

    /// 1/(x + y s) = (x − y s)/(x² − y² s²).
    pub fn inverse(&self, a: &[u64]) -> Residues {
        if let [a] = a {
            return vec![reciprocal(*a)];
        }
        let (x, y) = a.split_at(a.len() / 2);
        let below = self.inverse(&self.norm_below(a));
        let [real, root] = [self.times(x, &below), self.times(&self.minus(&[], y), &below)];
        [padded(real, x.len()), padded(root, x.len())].concat()
    }

    /// The product of x + y s and x − y s, at the level below.
    fn norm_below(&self, a: &[u64]) -> Residues {
        let (x, y) = a.split_at(a.len() / 2);
        let squares = self.times(&self.times(y, y), self.square(x.len()));
        padded(self.minus(&self.times(x, x), &squares), x.len())
    }

    /// The product over both signs of each of the first so many roots.
    pub fn norm(&self, a: &[u64], roots: usize) -> u64 {
        let mut norm = padded(a.to_vec(), 1 << roots);
        while norm.len() > 1 {
            norm = self.norm_below(&norm);
        }
        norm[0]
    }
}

fn padded(mut a: Residues, size: usize) -> Residues {
    a.resize(size.max(a.len()), 0);
    a
}
