//! How right every group is as its limit comes near: tables, and charts with the textbook's forms
//! beside.
//!
//! `cargo run --release -p laboratory --bin stability` prints the hard cases, then for each group the
//! errors at 1e-1 to 1e-15 from its limit, in double and in single precision, and draws them to
//! `target/charts/stability_position.svg`, `stability_velocity.svg` and `stability_single.svg`. Both
//! axes are decimal logarithms.

mod sweep;
mod textbook;

use charts::{Curve, Panel};
use linkage_tests::hard_table;
use sweep::{Series, Sweep};

fn main() {
    hard_cases();
    let (sweeps, single) = (sweep::all(), sweep::single());
    println!("\ndouble precision");
    sweeps.iter().for_each(print_sweep);
    println!("\nsingle precision");
    single.iter().for_each(print_sweep);
    let title = "error against distance from the limit";
    let draw = |name: &str, what: &str, sweeps: &[Sweep], order: usize| {
        let panels = sweeps.iter().map(|sweep| panel(sweep, order)).collect();
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
        for (index, exponent) in sweep::EXPONENTS.take(count).enumerate() {
            print!("  1e-{exponent:02} ");
            for series in &sweep.series {
                print!("  {:18.1e}", series.errors[order][index]);
            }
            println!();
        }
    }
}

fn panel(sweep: &Sweep, order: usize) -> Panel {
    let curve = |series: &Series| {
        let points = sweep::EXPONENTS.zip(&series.errors[order]);
        // An error of nothing, and one that is no number, have no place on a logarithmic axis.
        let points = points.filter(|(_, error)| error.is_finite());
        let points =
            points.map(|(exponent, error)| (-f64::from(exponent), error.max(1e-24).log10()));
        Curve::named(series.name, charts::colour_of(series.name), points.collect())
    };
    let axes = ["log10 of the distance", "log10 of the error"];
    let title = format!("{}, {}", sweep.title, sweep.measures[order]);
    Panel::over(&title, axes, sweep.series.iter().map(curve).collect())
}
