//! The residues by which degrees are computed.

use super::tower::{PRIME, Tower, product, reciprocal};
use super::*;

/// A root that is adjoined is one, its inverse too, and the norm of x + y s is the product of both signs.
#[test]
fn towers_are_fields() {
    let mut numbers = Numbers(29);
    let mut residue = move || (numbers.next() * PRIME as f64) as u64;
    let mut tower = Tower::default();
    let first = tower.adjoin(vec![residue()]);
    let square = tower.times(&first, &first);
    assert_eq!(square[1], 0);
    let second = tower.adjoin(vec![residue(), residue()]);
    for _ in 0..20 {
        let a: Vec<_> = (0..4).map(|_| residue()).collect();
        let b: Vec<_> = (0..2).map(|_| residue()).collect();
        let one = tower.times(&a, &tower.inverse(&a));
        assert_eq!(one, [1, 0, 0, 0]);
        let both = tower.times(&tower.times(&a, &b), &second);
        assert_eq!(both, tower.times(&a, &tower.times(&second, &b)));
        // The norm is multiplicative, and that of a residue is its fourth power.
        let norms = product(tower.norm(&a, 2), tower.norm(&b, 2));
        assert_eq!(tower.norm(&tower.times(&a, &b), 2), norms);
        let x = residue();
        let square = product(x, x);
        assert_eq!(tower.norm(&[x], 2), product(square, square));
        assert_eq!(product(x, reciprocal(x)), 1);
        assert_eq!(tower.minus(&tower.plus(&a, &b), &b), a);
    }
}
