//! The time of a call, for people: `cargo bench -p laboratory --bench solvers`.
//!
//! The mechanisms are those of the example `work_precision`, which says how these times compare
//! with other ways to the same numbers; here they stand by entry point and width.

use std::f64::consts::TAU;

use divan::{Bencher, black_box};
use laboratory::generated::{Chain, CouplerPoint, FourBar, FourBarCompensated, SixBar, Stephenson};

fn main() {
    divan::main();
}

/// Angles all over a turn, in no order: multiples of the golden angle.
fn angles() -> impl FnMut() -> f64 {
    let mut k = 0.0;
    move || {
        k += 1.0;
        k * 2.399_963_229_728_653 % TAU
    }
}

const RATE: f64 = 10.0;
const SECOND: f64 = 1.0;

/// A module of every entry point of a mechanism.
macro_rules! entry_points {
    ($module:ident: $solver:ident $(, $width:ident)+) => {
        mod $module {
            use super::*;

            $(mod $width {
                use super::*;

                fn solver() -> $solver<$width> {
                    $solver::default()
                }

                #[divan::bench]
                fn position(bencher: Bencher<'_, '_>) {
                    let solver = solver();
                    bencher
                        .with_inputs(angles())
                        .bench_local_values(|theta| solver.position(theta as $width));
                }

                #[divan::bench]
                fn motion(bencher: Bencher<'_, '_>) {
                    let solver = solver();
                    let rates = black_box([RATE as $width, SECOND as $width]);
                    bencher
                        .with_inputs(angles())
                        .bench_local_values(|theta| {
                            solver.motion(theta as $width, rates[0], rates[1])
                        });
                }

                #[divan::bench]
                fn motion_at(bencher: Bencher<'_, '_>) {
                    let solver = solver();
                    let rates = black_box([RATE as $width, SECOND as $width]);
                    let mut angles = angles();
                    bencher.with_inputs(move || angles().sin_cos()).bench_local_values(
                        |(sin, cos)| {
                            solver.motion_at(cos as $width, sin as $width, rates[0], rates[1])
                        },
                    );
                }
            })+
        }
    };
}

entry_points!(four_bar: FourBar, f32, f64);
entry_points!(four_bar_compensated: FourBarCompensated, f32, f64);
entry_points!(coupler_point: CouplerPoint, f32, f64);
entry_points!(six_bar: SixBar, f32, f64);
entry_points!(stephenson: Stephenson, f32, f64);
entry_points!(ten_links: Chain, f32, f64);
