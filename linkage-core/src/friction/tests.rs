//! The amounts against their own equations, on random systems and on constructed ones.

use super::guarded::{GUARDED, NEWTON, jammed};
use super::*;
use crate::cases::cases;

/// Uniform in [0, 1).
struct Draw(u64);

impl Draw {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Symmetric about zero.
    fn signed(&mut self) -> f64 {
        2.0 * self.next() - 1.0
    }
}

/// The spectral radius of L by its powers: the growth of a positive vector.
fn radius<const W: usize, const M: usize>(system: &System<f64, W, M>) -> f64 {
    let (mut vector, bounds) = ([1.0; M], system.bounds());
    let mut grown = 0.0;
    for _ in 0..600 {
        // With the unit matrix added, no power is periodic.
        let next: [f64; M] = core::array::from_fn(|j| {
            vector[j] + (0..M).map(|k| bounds[j][k] * vector[k]).sum::<f64>()
        });
        let size = next.iter().copied().fold(0.0, f64::max);
        (vector, grown) = (next.map(|x| x / size), size);
    }
    grown - 1.0
}

fn is_settled<const W: usize, const M: usize>(
    system: &System<f64, W, M>,
    amounts: [f64; M],
) -> bool {
    let [(start, _), (values, _)] =
        [[0.0; M], amounts].map(|at| system.linear(at, &mut libm::hypot));
    System::<f64, W, M>::settled(amounts, values, start, &system.bounds())
}

/// A system of this spectral radius, its amounts in units of very different size.
fn random<const W: usize, const M: usize>(draw: &mut Draw, rho: f64) -> System<f64, W, M> {
    let guides = (draw.next() * f64::from(1 << M)) as u32;
    let mut rows = [[0.0; W]; M];
    for row in &mut rows {
        row.iter_mut().for_each(|number| *number = draw.signed());
        row[SHARE] = 10.0_f64.powf(draw.signed());
    }
    let mut system = System { rows, guides };
    let scale = rho / radius(&system);
    let units: [f64; M] = core::array::from_fn(|_| 10.0_f64.powf(6.0 * draw.signed()));
    for j in 0..M {
        system.rows[j][SHARE] *= scale * units[j];
        for (k, unit) in units.iter().enumerate() {
            system.rows[j][CHANGES + 2 * k] /= unit;
            system.rows[j][CHANGES + 2 * k + 1] /= unit;
        }
    }
    system
}

/// Solves random systems: the steps are few, and the bound (I − L)⁻¹|Φ − x| shows each amount.
fn random_systems_are_solved<const W: usize, const M: usize>(count: usize) {
    let mut draw = Draw(M as u64);
    for (rho, most) in [(0.1, 4), (0.5, 6), (0.9, 8), (0.99, 8)] {
        for _ in 0..count {
            let system: System<f64, W, M> = random(&mut draw, rho);
            let (found, steps) = system.solved_in().expect("the spectral radius is below one");
            assert!(steps <= most, "{steps} steps at {rho}");
            let bounds = system.bounds();
            let (start, _) = system.linear([0.0; M], &mut libm::hypot);
            let (values, _) = system.linear(found, &mut libm::hypot);
            let off = core::array::from_fn(|j| magnitude(values[j] - found[j]));
            let bound = solve(without(bounds), off);
            // 4ε of each amount's size, amplified by (I − L)⁻¹. In the norm weighed by its eigenvector
            // that is at most 1/(1 − ρ), and by components the ratio of the amounts beside it.
            let sizes = core::array::from_fn(|j| {
                let changes: f64 = (0..M).map(|k| bounds[j][k] * found[k]).sum();
                4.0 * f64::EPSILON * (start[j] + changes)
            });
            let shown = solve(without(bounds), sizes);
            for j in 0..M {
                assert!(found[j] >= 0.0 && bound[j] <= shown[j], "{found:?} {bound:?} {shown:?}");
            }
        }
    }
}

/// A sample of the systems of `.ci/nightly`.
#[test]
fn systems_of_one_to_four_amounts_are_solved() {
    let count = cases(80, 300);
    random_systems_are_solved::<5, 1>(count);
    random_systems_are_solved::<7, 2>(count);
    random_systems_are_solved::<9, 3>(count);
    random_systems_are_solved::<11, 4>(count);
}

/// Across ρ = 1 every answer is a solution or a refusal, and the refusal is right: a sample of the systems of
/// `.ci/nightly`.
#[test]
fn friction_is_refused_just_where_it_may_hold_itself() {
    let mut draw = Draw(5);
    for nth in 0..cases(600, 2000) {
        // ρ within 2⁻⁴⁰ of one is left out: pivots are known within some rounding of their rows.
        let rho = 0.9 + 0.2 * draw.next();
        let system: System<f64, 9, 3> = random(&mut draw, rho);
        match system.solved() {
            Ok(found) => assert!(rho < 1.0 + 1e-9 && is_settled(&system, found), "{nth}: {rho}"),
            Err(_) => assert!(rho > 1.0 - 1e-9, "{nth}: {rho}"),
        }
    }
}

/// One guide: x = c |N + a x| has the solution c|N|/(1 − c a sign N).
#[test]
fn the_amount_of_one_guide_has_a_closed_form() {
    for (share, normal, change) in [(0.15, -120.0, 0.7), (0.3, 80.0, -2.1), (0.5, 1e-9, 1.9)] {
        let system = System { rows: [[share, normal, 0.0, change, 0.0]], guides: 1 };
        let [found] = system.solved().unwrap();
        let expected = share * f64::abs(normal) / (1.0 - share * change * f64::signum(normal));
        assert!((found - expected).abs() <= 4.0 * f64::EPSILON * expected, "{found} {expected}");
    }
    let jams = System { rows: [[0.5, 1.0, 0.0, 2.0, 0.0]], guides: 1 };
    assert_eq!(jams.solved(), Err(0));
}

/// One pin: the positive root of (1 − c²|a|²) x² − 2c² G·a x − c²|G|² = 0.
#[test]
fn the_amount_of_one_pin_has_a_closed_form() {
    for (share, [x, y], [by_x, by_y]) in
        [(0.1, [3.0, -4.0], [2.0, 1.0]), (0.02, [1e6, 2e5], [-30.0, 20.0])]
    {
        let system = System { rows: [[share, x, y, by_x, by_y]], guides: 0 };
        let [found] = system.solved().unwrap();
        let square = share * share;
        let a = 1.0 - square * (by_x * by_x + by_y * by_y);
        let b = square * (x * by_x + y * by_y);
        let c = square * (x * x + y * y);
        let expected = (b + f64::sqrt(b * b + a * c)) / a;
        // Four products and sums of either sign, and a root.
        assert!((found - expected).abs() <= 16.0 * f64::EPSILON * expected, "{found} {expected}");
    }
}

/// Absolute values alone can send Newton's steps round in a circle for ever; guarded ones end. Of the 30,000 draws
/// of `.ci/nightly`, one of which is such a circle, an ordinary run solves the thousand about that one.
#[test]
fn a_cycle_ends() {
    let mut draw = Draw(11);
    let mut cycles = 0;
    // A system is drawn by 25 numbers.
    for _ in 0..25 * cases(27_000, 0) {
        draw.next();
    }
    for _ in 0..cases(1000, 30_000) {
        let mut rows = [[0.0; 11]; 4];
        for row in &mut rows {
            [SHARE, FREE, CHANGES, CHANGES + 2, CHANGES + 4, CHANGES + 6]
                .into_iter()
                .for_each(|place| row[place] = draw.signed());
            row[SHARE] = magnitude(row[SHARE]);
        }
        let mut system = System { rows, guides: 0b1111 };
        let scale = (0.95 + 0.049 * draw.next()) / radius_at_most(&system);
        system.rows.iter_mut().for_each(|row| row[SHARE] *= scale);
        let (found, steps) = system.solved_in().expect("the spectral radius is below one");
        assert!(is_settled(&system, found) && steps <= NEWTON + GUARDED, "{steps}");
        cycles += usize::from(steps > NEWTON);
    }
    assert!(cycles > 0, "a draw without a cycle says nothing");
}

/// An upper bound of ρ in few steps, Collatz's: the largest growth of a component.
fn radius_at_most(system: &System<f64, 11, 4>) -> f64 {
    let (mut vector, bounds) = ([1.0; 4], system.bounds());
    let mut largest = 0.0;
    for _ in 0..40 {
        let next: [f64; 4] =
            core::array::from_fn(|j| (0..4).map(|k| bounds[j][k] * vector[k]).sum());
        largest = (0..4).map(|j| next[j] / vector[j]).fold(0.0, f64::max);
        let size = next.iter().copied().fold(0.0, f64::max);
        vector = next.map(|x| x / size);
    }
    largest
}

#[test]
fn numbers_that_are_not_finite_are_refused() {
    let rows = [[0.1, f64::NAN, 0.0, 1.0, 0.0]];
    let amounts = Amounts { system: System { rows, guides: 0 }, joints: ["B"] };
    assert_eq!(amounts.diagnose([0.0]), Err(SolveError::NotFinite { name: "B" }));
    let rows = [[0.6, 1.0, 0.0, 2.0, 0.0]];
    let system: System<f64, 5, 1> = System { rows, guides: 1 };
    let amounts = Amounts { system, joints: ["ram"] };
    assert_eq!(amounts.diagnose([0.0]), Err(SolveError::Jams { joint: "ram" }));
    assert!(!amounts.system.stepped([0.6]).1);
}

/// The condition refuses amounts that are no solution, and takes those that are.
#[test]
fn comparisons_tell_a_solution_from_any_other_amount() {
    // x = 0.3 |100 + 0.5 x| has the solution 30/0.85.
    let system: System<f64, 5, 1> = System { rows: [[0.3, 100.0, 0.0, 0.5, 0.0]], guides: 1 };
    let solution = 30.0 / 0.85;
    assert!(is_settled(&system, [solution]));
    for off in [1e-13, -1e-13, 1e-3, -0.5, 1.0, f64::NAN, f64::INFINITY] {
        let amount = solution * (1.0 + off);
        assert!(!is_settled(&system, [amount]), "{off}");
        // The slow path finds it from there.
        let [found] = Amounts { system, joints: ["ram"] }.diagnose([amount]).unwrap();
        assert!((found - solution).abs() <= 4.0 * f64::EPSILON * solution, "{off}: {found}");
    }
}

/// Where straight-line steps have not ended, the slow path finds derivatives of every order as well.
#[cfg(feature = "ad")]
#[test]
fn the_slow_path_derives_the_solution() {
    use num_dual::Dual2_64;
    // x = c |G + a x| with G as the variable: c/(1 − c a) is its slope, and of a pin that is no line.
    let free = Dual2_64::from_re(3.0).derivative();
    let lit = |value: f64| Dual2_64::from_re(value);
    let row = [lit(0.4), free, lit(4.0), lit(0.5), lit(-0.3)];
    let amounts = Amounts { system: System { rows: [row], guides: 0 }, joints: ["B"] };
    let [found] = amounts.diagnose([lit(77.0)]).unwrap();
    let solved = |x: f64| {
        let system = System { rows: [[0.4, x, 4.0, 0.5, -0.3]], guides: 0 };
        system.solved().unwrap()[0]
    };
    // Central differences of second order: h²/6 of the third derivative and ε/h², 10⁻⁷ of each.
    let h = 1e-4;
    let (below, at, above) = (solved(3.0 - h), solved(3.0), solved(3.0 + h));
    assert!((found.re - at).abs() < 1e-15);
    assert!((found.v1 - (above - below) / (2.0 * h)).abs() < 1e-8);
    assert!((found.v2 - (above - 2.0 * at + below) / (h * h)).abs() < 1e-6);
}

/// A share of exactly one is held by some load, and overflow in the elimination shows no solution either.
#[test]
fn a_share_of_one_jams() {
    let one = System { rows: [[1.0, 3.0, 0.0, 1.0, 0.0]], guides: 1 };
    assert_eq!(jammed(one.bounds()), Some(0));
    let just_below = System { rows: [[1.0 - f64::EPSILON, 3.0, 0.0, 1.0, 0.0]], guides: 1 };
    assert_eq!(jammed(just_below.bounds()), None);
    // The second pivot is ∞ · 0.
    let row = |by: [f64; 2]| [1.0, 3.0, 0.0, by[0], 0.0, by[1], 0.0];
    let overflows = System { rows: [row([1.0 - f64::EPSILON, 0.0]), row([1e300, 0.5])], guides: 3 };
    assert_eq!(jammed(overflows.bounds()), Some(1));
    assert!(!pivots_are_positive(overflows.bounds()));
}
