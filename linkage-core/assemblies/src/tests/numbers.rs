//! Discs, polynomials, and zeros around the circle.

use std::vec::Vec;

use super::{Complex, Numbers};
use crate::{Budget, CircleOrigin, Disc, Nodes, OnCircle, Outcome, Searched, ZerosFound, zeros};

/// Points of discs, and results of operations on them, which the resulting discs hold.
#[test]
fn discs_hold_what_they_enclose() {
    let mut numbers = Numbers(31);
    for _ in 0..4000 {
        let mut number = || 4.0 * numbers.next() - 2.0;
        let mut disc =
            || Disc { radius: 0.3 * number().abs().powi(4), ..Disc::exact(number(), number()) };
        let (a, b) = (disc(), disc());
        // A point at the rim.
        let mut rim = |of: Disc| {
            let at = Complex::turned(2.0 * number());
            Complex::new(of.x, of.y) + at.times(of.radius * (1.0 - 1e-9))
        };
        let (p, q) = (rim(a), rim(b));
        let holds = |disc: Disc, point: Complex| {
            let off = (point - Complex::new(disc.x, disc.y)).length();
            // The roundings of the point itself.
            let own = 1e-15 * (1.0 + point.length());
            assert!(off <= disc.radius + own, "{off} in {disc:?}");
        };
        holds(a.plus(b), p + q);
        holds(a.minus(b), p - q);
        holds(a.times(b), p * q);
        holds(a.conjugate(), p.conjugate());
        let inverse = a.inverse();
        if inverse.radius.is_finite() {
            holds(inverse, Complex::new(1.0, 0.0).over(p));
            // No wider than the image, which reaches as far on its near side.
            let least = Complex::new(a.x, a.y).length() - a.radius;
            assert!(inverse.radius < 1.001 * a.radius / (least * (least + a.radius)) + 1e-12);
        } else {
            assert!(Complex::new(a.x, a.y).length() <= a.radius * (1.0 + 1e-9));
        }
        let root = a.root();
        let half = Complex::turned(p.angle() / 2.0).times(p.length().sqrt());
        let off = [half, -half].map(|half| (half - Complex::new(root.x, root.y)).length());
        assert!(off[0].min(off[1]) <= root.radius * (1.0 + 1e-12), "{off:?} in {root:?}");
        assert!(root.radius <= a.radius.sqrt() * 1.001 + 1e-14);
    }
}

/// Exact operations have discs of a few roundings, and no less than theirs.
#[test]
fn discs_of_exact_numbers_are_small() {
    let third = Disc::exact(3.0, 0.0).inverse();
    // 1/3 is off by a third of the last place.
    assert!(third.radius > 1e-17 && third.radius < 2e-15, "{third:?}");
    let product = Disc::exact(0.1, 0.3).times(Disc::exact(0.7, 0.9));
    assert!(product.radius > 1e-17 && product.radius < 2e-15, "{product:?}");
    assert!(Disc::exact(1e-200, 0.0).times(Disc::exact(1e-200, 0.0)).radius > 0.0);
    assert!(!Disc::exact(0.0, 0.0).inverse().radius.is_finite());
}

/// The zeros of polynomials that are given by their roots.
#[test]
fn polynomials_tell_their_zeros() {
    for count in [7, 19, 59] {
        let nodes = Nodes::of(count);
        let told = |radius: f64, of: &dyn Fn(f64) -> f64| {
            let mut values = Nodes::no_values();
            (0..count).for_each(|node| values[node] = of(nodes.node(node)));
            nodes.polynomial(&values, radius).zeros()
        };
        let ZerosFound::One([from, to]) = told(0.0, &|x| (x - 0.3) * (x * x + 4.0)) else {
            panic!("{count}")
        };
        assert!(from <= 0.3 && 0.3 <= to && to - from < 1e-10, "{count}: {from} to {to}");
        let ZerosFound::One([from, to]) = told(1e-6, &|x| 0.3 - x) else { panic!("{count}") };
        // Four times the radius about the zero, by a slope that is known to 59² of these.
        for around in [0.3 - from, to - 0.3] {
            assert!((4e-6..4.1e-6).contains(&around), "{count}: {around:e}");
        }
        assert_eq!(told(0.0, &|x| x * x * x + x + 3.0), ZerosFound::None);
        assert_eq!(told(0.0, &|x| x + 1.5), ZerosFound::None);
        // Its slope keeps its sign, and its constant term is no greater than the others.
        assert_eq!(told(0.0, &|x| 0.95 + x + 0.1 * (2.0 * x * x - 1.0)), ZerosFound::None);
        assert_eq!(told(0.0, &|x| x * x), ZerosFound::Unknown);
        assert_eq!(told(0.0, &|x| x * x - 0.25), ZerosFound::Unknown);
        // Not known well enough: at an end, or everywhere.
        assert_eq!(told(1e-3, &|x| 1.0 + x - 3e-3), ZerosFound::Unknown);
        assert_eq!(told(1.0, &|x| x), ZerosFound::Unknown);
        // A zero at an end is one of two pieces, or of none.
        assert_eq!(told(0.0, &|x| 1.0 + x), ZerosFound::Unknown);
        assert_eq!(told(0.0, &|x| x - 1.0), ZerosFound::Unknown);
        assert_eq!(told(f64::INFINITY, &|x| x), ZerosFound::Unknown);
        assert_eq!(told(0.0, &|_| f64::NAN), ZerosFound::Unknown);
    }
}

/// A trigonometric polynomial of degree two with known zeros: the product of the sines of half the angles from these.
struct Sines([f64; 4]);

impl OnCircle for Sines {
    fn value(&self, turn: Disc) -> Disc {
        // Each product of two sines of halves is of degree one.
        let factor = |[a, b]: [f64; 2]| {
            let middle = Complex::turned(-(a + b) / 2.0);
            let turned = turn.times(Disc::exact(middle.x, middle.y));
            let cosine = Disc { y: 0.0, ..turned };
            Disc::exact(((a - b) / 2.0).cos(), 0.0).minus(cosine)
        };
        let [a, b, c, d] = self.0;
        factor([a, b]).times(factor([c, d]))
    }

    fn has_none(&self, _: f64, _: f64) -> bool {
        false
    }
}

/// All zeros around the circle are found once, wherever it is divided, in ascending order but for the first turn; a small budget ends
/// the search, and a double zero is open where it is.
#[test]
fn zeros_around_the_circle_are_found_once() {
    let wanted = [-3.0, -0.4, 0.9, 2.7];
    for tangent in [0.0, 0.187_5, -0.6, 1.3] {
        let origin = CircleOrigin { tangent };
        let mut found = Vec::new();
        let budget = Budget { samples: 2000, pieces: 400 };
        let searched = zeros(&Sines(wanted), (2, origin), budget, |ends| found.push(ends));
        assert_eq!((searched.outcome, found.len()), (Outcome::Proved, 4), "{tangent}");
        // Every piece has five samples.
        assert_eq!(searched.samples, 5 * searched.pieces);
        found.sort_by(|a, b| a[0].total_cmp(&b[0]));
        for (ends, wanted) in found.iter().zip(wanted) {
            assert!(ends[0] - 1e-12 <= wanted && wanted <= ends[1] + 1e-12, "{ends:?} {wanted}");
            assert!(ends[1] - ends[0] < 1e-9);
        }
        for budget in [Budget { pieces: 6, ..budget }, Budget { samples: 34, ..budget }] {
            let ended = zeros(&Sines(wanted), (2, origin), budget, |_| {});
            assert_eq!(
                ended,
                Searched { outcome: Outcome::OutOfBudget, samples: 30, pieces: ended.pieces }
            );
            assert!(ended.pieces <= 7);
        }
        let budget = Budget { samples: 20_000, pieces: 4000 };
        let double = zeros(&Sines([-2.0, 0.5, 0.5, 2.0]), (2, origin), budget, |_| {}).outcome;
        let Outcome::Open { from, to } = double else { panic!("{double:?}") };
        assert!((from - 0.5).abs() < 1e-5 && (to - 0.5).abs() < 1e-5 && from < to, "{double:?}");
    }
}
