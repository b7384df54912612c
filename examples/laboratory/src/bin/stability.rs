//! Errors of every group as its limit comes near: tables, and charts with the textbook's forms
//! beside.
//!
//! `cargo run --release -p laboratory --bin stability` prints the hard cases, then for each group the
//! errors at 1e-1 to 1e-15 from its limit, in double and in single precision, and draws them to
//! `target/charts/stability_position.svg`, `stability_velocity.svg` and `stability_single.svg`.

use laboratory::near_limits::{self, EXPONENTS, Sweep};
use linkage_tests::hard_table;

fn main() {
    hard_cases();
    let [stretched, stretched_single] = near_limits::stretched();
    let mut sweeps = near_limits::all();
    let mut single = near_limits::single();
    sweeps.insert(0, stretched);
    single.insert(0, stretched_single);
    println!("\ndouble precision");
    sweeps.iter().for_each(print_sweep);
    println!("\nsingle precision");
    single.iter().for_each(print_sweep);
    let title = "error against distance from the limit";
    let draw = |name: &str, what: &str, sweeps: &[Sweep], order: usize| {
        let panels = sweeps.iter().map(|sweep| sweep.panel(sweep.title, order)).collect();
        charts::write(name, &format!("{what}: {title}"), 2, panels);
    };
    draw("stability_position", "Position", &sweeps, 0);
    draw("stability_velocity", "Velocity", &sweeps, 1);
    draw("stability_single", "Position in single precision", &single, 0);
}

fn hard_cases() {
    let (lines, refusals) = hard_table::table();
    println!("hard cases: error, error that rounding the data would cause, ratio\n");
    for line in &lines {
        println!(
            "{:14} {:24} {:7} {:9.2e} {:9.2e} {:6.2}",
            line.mechanism,
            line.case,
            line.quantity,
            line.error,
            line.achievable,
            line.ratio()
        );
    }
    for (mechanism, case, error) in &refusals {
        println!("{mechanism:14} {case:24} refused: {error}");
    }
    let worst = lines.iter().map(hard_table::Line::ratio).fold(0.0, f64::max);
    println!("\nworst ratio {worst:.2} of {} numbers", lines.len());
}

fn print_sweep(sweep: &Sweep) {
    for (order, what) in ["position", "velocity"].into_iter().enumerate() {
        println!("\n{}: worst error of {what}\n", sweep.title);
        print!("distance");
        sweep.series.iter().for_each(|series| print!("  {:>18}", series.name));
        println!();
        let count = sweep.series[0].errors[order].len();
        for (index, exponent) in EXPONENTS.take(count).enumerate() {
            print!("  1e-{exponent:02} ");
            for series in &sweep.series {
                print!("  {:18.1e}", series.errors[order][index]);
            }
            println!();
        }
    }
}
