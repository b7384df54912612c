//! Counterweights that keep a four-bar from shaking its frame, found by sequential quadratic
//! programming with exact gradients.
//!
//! The unknowns are first moments of mass on crank and rocker, two components each. The objective is the
//! mean square of the shaking force over a turn. Its gradient comes from dual numbers through the
//! solver's `shaking`. That the force can be balanced altogether, and by which moments, is Berkof and
//! Lowen's (A New Method for Completely Force Balancing Simple Linkages, 1969): what carries the coupler's
//! share of mass at its pin, and the link's own, on the other side of the pivot.

use std::f64::consts::TAU;

use linkage_core::num_dual::DualSVec;
use linkage_core::{Real, SolveError, differentiate, mechanism};

mechanism! {
    /// Four-bar of three uniform bars with counterweights of 1 kg.
    pub struct FourBar {
        input theta: angle;
        param crank_x = 0m;
        param crank_y = 0m;
        param rocker_x = 0m;
        param rocker_y = 0m;

        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B        { length: 250mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }

        mass 52.21g on AB uniform;
        mass 104.21g on BC uniform;
        mass 102.21g on DC uniform;
        mass 1kg on AB at (crank_x, crank_y);
        mass 1kg on DC at (rocker_x, rocker_y);

        output shaking;
    }
}

/// Where the two counterweights are.
type Places = [f64; 4];

const POSES: u32 = 72;
const SPEED: f64 = 4.0 * std::f64::consts::PI;

/// The mean square of the shaking force, in N².
fn objective<T: Real>(places: [T; 4]) -> Result<T, SolveError> {
    let [crank_x, crank_y, rocker_x, rocker_y] = places;
    let machine = FourBar { crank_x, crank_y, rocker_x, rocker_y };
    let number = |value: f64| T::lit(value, value as f32);
    let mut sum = number(0.0);
    for pose in 0..POSES {
        let theta = number(TAU * f64::from(pose) / f64::from(POSES));
        let force = machine.forces(theta, number(SPEED), number(0.0))?.shaking;
        sum = sum + force.x * force.x + force.y * force.y;
    }
    Ok(sum / number(f64::from(POSES)))
}

fn gradient(places: Places) -> Result<Places, SolveError> {
    let slope = differentiate(places, |places: [DualSVec<f64, 4>; 4]| Ok([objective(places)?]))?;
    Ok([0, 1, 2, 3].map(|k| slope[(0, k)]))
}

/// The result of the search, and the number of its evaluations.
fn balanced() -> (Places, f64, usize) {
    let count = std::cell::Cell::new(0);
    let cost = |places: &[f64], into: Option<&mut [f64]>, (): &mut ()| {
        count.set(count.get() + 1);
        let places = [places[0], places[1], places[2], places[3]];
        if let (Some(into), Ok(slope)) = (into, gradient(places)) {
            into.copy_from_slice(&slope);
        }
        objective(places).unwrap_or(f64::INFINITY)
    };
    let until = slsqp::StopTols { xtol_rel: 1e-14, ftol_rel: 1e-30, ..slsqp::StopTols::default() };
    let limits: [&dyn slsqp::Func<()>; 0] = [];
    let ended = slsqp::minimize(cost, &[0.0; 4], &[(-1.0, 1.0); 4], &limits, (), 200, Some(until));
    let (Ok((_, places, value)) | Err((_, places, value))) = ended;
    ([places[0], places[1], places[2], places[3]], value, count.get())
}

/// Berkof and Lowen's first moments, in kg·m, of counterweights of 1 kg.
const EXPECTED: Places =
    [-0.5 * (0.05221 + 0.10421) * 0.25, 0.0, -0.5 * (0.10221 + 0.10421) * 0.5, 0.0];

fn main() -> Result<(), SolveError> {
    let before = objective([0.0_f64; 4])?;
    let (places, after, count) = balanced();
    println!("shaking force, root of the mean square over a turn at 120 rpm:");
    println!("  without counterweights {:.4} N", before.sqrt());
    println!("  with them              {:.1e} N, after {count} evaluations\n", after.sqrt());
    println!("{:>28} {:>12} {:>12}", "first moments in kg·m", "found", "exact");
    let names = ["crank, along", "crank, across", "rocker, along", "rocker, across"];
    for ((name, found), exact) in names.iter().zip(places).zip(EXPECTED) {
        println!("{name:>28} {found:>12.9} {exact:>12.9}");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_search_finds_the_moments_that_balance_all_of_it() {
        let (places, after, count) = balanced();
        // A square of forces: at 1e-8 of the moments it is at 1e-16 of itself.
        for (found, exact) in places.into_iter().zip(EXPECTED) {
            assert!((found - exact).abs() < 1e-8, "{places:?}");
        }
        let before = objective([0.0_f64; 4]).unwrap();
        assert!(after < 1e-12 * before && count < 100, "{after} {count}");
    }

    #[test]
    fn the_gradient_is_that_of_differences() {
        let places = [0.03, -0.02, 0.05, 0.04];
        let exact = gradient(places).unwrap();
        for k in 0..4 {
            let h = 1e-5_f64;
            let at = |step: f64| {
                let mut places = places;
                places[k] += step;
                objective(places).unwrap()
            };
            // The objective is a square of the places: central differences have no error but rounding.
            let difference = (at(h) - at(-h)) / (2.0 * h);
            assert!((exact[k] - difference).abs() < 1e-8 * exact[k].abs().max(1.0), "{k}");
        }
    }
}
