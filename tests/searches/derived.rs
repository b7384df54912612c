//! Derivatives by dual numbers, and those in closed form, are of one and the same root.

use std::f64::consts::PI;

use linkage_core::SolveError;
use linkage_tests::mechanisms::unknowns::RamAndFollower;
use linkage_tests::random::{Random, cases};
use num_dual::Dual64;

fn kind<T>(answer: &Result<T, SolveError>) -> Option<std::mem::Discriminant<SolveError>> {
    answer.as_ref().err().map(std::mem::discriminant)
}

/// Both links in line, one way and the other, and up to six numbers from there; or anywhere.
fn drawn(random: &mut Random) -> (RamAndFollower, [f64; 2]) {
    let (r, rod) = (random.anywhere(0.75, 1.8), random.anywhere(1.9, 3.1));
    let seed = random.anywhere(0.0, PI);
    let dead_point = [r + rod, rod - r][usize::from(random.anywhere(0.0, 1.0) < 0.5)];
    let numbers = random.anywhere(-6.5, 6.5).round() as i64;
    let x = match random.anywhere(0.0, 1.0) < 0.7 {
        true => f64::from_bits(dead_point.to_bits().wrapping_add_signed(numbers)),
        false => random.anywhere(-0.5, 5.0),
    };
    (RamAndFollower { r, rod, seed }, [x, 3.0])
}

/// Closed forms and dual numbers decide on the same numbers whether a slope differs from rounding alone: next
/// to a dead point both refuse the derivatives, or neither. A sample of the draws of `.ci/nightly`.
#[test]
fn derivatives_are_refused_alike_next_to_dead_points() {
    let mut random = Random::new(31);
    let mut singular = 0;
    let draws = cases(5000, 20_000);
    for _ in 0..draws {
        let (solver, q) = drawn(&mut random);
        let (coefficients, jacobian) = (solver.coefficients(q), solver.jacobian(q));
        let both = (kind(&coefficients), kind(&jacobian));
        assert_eq!(both.0, both.1, "{solver:?} {q:?}: {coefficients:?} {jacobian:?}");
        singular += usize::from(matches!(jacobian, Err(SolveError::Singular { .. })));
    }
    assert!(singular > draws / 20, "{singular}");
}

/// The root that carries derivatives is the root, to the last bit.
#[test]
fn numbers_with_derivatives_take_the_root_of_those_without() {
    let mut random = Random::new(32);
    let mut solved = 0;
    for _ in 0..2000 {
        let (solver, [x, h]) = drawn(&mut random);
        let dual = [Dual64::new(x, 1.0), Dual64::from_re(h)];
        let Ok(with) = solver.lift::<Dual64>().position(dual) else { continue };
        let without = solver.position([x, h]).expect("with derivatives it is solved");
        assert_eq!((with.theta.re, with.phi.re), (without.theta, without.phi));
        solved += 1;
    }
    assert!(solved > 500, "{solved}");
}

/// A crank that is longer than its rod: in the middle of the bracket nothing can be assembled. A trial of
/// the search falls on the edge of that, where the last place of a division decides whether it is a
/// number.
#[test]
fn a_search_that_meets_what_cannot_be_assembled_meets_it_with_derivatives_too() {
    let solver = RamAndFollower { r: 2.567508364614382, rod: 2.5, seed: 1.0 };
    let q = [1.9405422703687263, 3.2271952683800293];
    let refused = SolveError::NotFinite { name: "theta" };
    assert_eq!(solver.position(q).map(|_| ()), Err(refused));
    assert_eq!(solver.jacobian(q).map(|_| ()), Err(refused));
    // The rates have none at the edge.
    assert_eq!(solver.coefficients(q).map(|_| ()), Err(SolveError::Singular { group: "BC, ram" }));
}
