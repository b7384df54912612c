//! The number of instructions of a call, which no other program on the machine can disturb:
//! `cargo bench -p laboratory --bench instructions`, where valgrind and `gungraun-runner` are installed.
//!
//! The mechanisms are those of the example `work_precision`.

#![allow(missing_docs, unused_qualifications, reason = "what the attributes of benchmarks make")]

use std::hint::black_box;

use gungraun::{library_benchmark, library_benchmark_group, main};
use laboratory::generated::{
    Chain, ChainMotion, CouplerPoint, CouplerPointMotion, FourBar, FourBarMotion, FourBarPosition,
    SixBar, SixBarMotion, Stephenson, StephensonMotion,
};
use linkage_core::{SolveError, mechanism};

mechanism! {
    /// The Stephenson III six-bar, of which only the first loop's point is asked for.
    struct FirstLoop {
        input theta: angle;

        ground A(0, 0), D(100mm, 0), F(180mm, 60mm);

        crank AB(A) -> B        { length: 40mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (110mm, 90mm), mode: left }
        point P on BC at (70mm, 50mm);
        rrr   PE(P), FE(F) -> E { lengths: (120mm, 100mm), mode: left }

        output P;
    }
}

mechanism! {
    /// The first loop alone, which takes as many operations; the counts differ by a few moves.
    struct OnlyLoop {
        input theta: angle;

        ground A(0, 0), D(100mm, 0);

        crank AB(A) -> B        { length: 40mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (110mm, 90mm), mode: left }
        point P on BC at (70mm, 50mm);

        output P;
    }
}

/// A crank angle and its rates, which the optimiser does not know.
fn pose() -> [f64; 3] {
    black_box([0.7, 10.0, 1.0])
}

#[library_benchmark]
fn four_bar_position() -> Result<FourBarPosition<f64>, SolveError> {
    let [theta, _, _] = pose();
    FourBar::new().position(theta)
}

#[library_benchmark]
fn four_bar_motion() -> Result<FourBarMotion<f64>, SolveError> {
    let [theta, omega, alpha] = pose();
    FourBar::new().motion(theta, omega, alpha)
}

#[library_benchmark]
fn four_bar_motion_at() -> Result<FourBarMotion<f64>, SolveError> {
    let [_, omega, alpha] = pose();
    FourBar::new().motion_at(black_box(0.8), black_box(0.6), omega, alpha)
}

#[library_benchmark]
fn coupler_point_motion() -> Result<CouplerPointMotion<f64>, SolveError> {
    let [theta, omega, alpha] = pose();
    CouplerPoint::new().motion(theta, omega, alpha)
}

#[library_benchmark]
fn six_bar_motion() -> Result<SixBarMotion<f64>, SolveError> {
    let [theta, omega, alpha] = pose();
    SixBar::new().motion(theta, omega, alpha)
}

#[library_benchmark]
fn stephenson_motion() -> Result<StephensonMotion<f64>, SolveError> {
    let [theta, omega, alpha] = pose();
    Stephenson::new().motion(theta, omega, alpha)
}

#[library_benchmark]
fn first_of_two_loops_motion() -> Result<FirstLoopMotion<f64>, SolveError> {
    let [theta, omega, alpha] = pose();
    FirstLoop::new().motion(theta, omega, alpha)
}

#[library_benchmark]
fn only_loop_motion() -> Result<OnlyLoopMotion<f64>, SolveError> {
    let [theta, omega, alpha] = pose();
    OnlyLoop::new().motion(theta, omega, alpha)
}

#[library_benchmark]
fn ten_links_motion() -> Result<ChainMotion<f64>, SolveError> {
    let [theta, omega, alpha] = pose();
    Chain::new().motion(theta, omega, alpha)
}

library_benchmark_group!(
    name = solvers;
    benchmarks =
        four_bar_position,
        four_bar_motion,
        four_bar_motion_at,
        coupler_point_motion,
        six_bar_motion,
        stephenson_motion,
        first_of_two_loops_motion,
        only_loop_motion,
        ten_links_motion
);

main!(library_benchmark_groups = solvers);
