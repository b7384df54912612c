//! The tables.

use crate::bench::Finding;

/// The title of the report: the measurement and the machine.
pub(crate) fn heading(rounds: usize) -> String {
    let fused = if cfg!(target_feature = "fma") { "with" } else { "without" };
    format!(
        "Position, velocity and acceleration of every output, all checks included; compiled \
         {fused} fused operations;\nmedians of {rounds} rounds. Ratios are to the straightforward \
         closed form; a latency is a pose that waits for the one before.\nErrors against 30 digits \
         are the largest over a turn, in ε of the largest value of the same quantity."
    )
}

/// One mechanism in one width.
pub(crate) fn print(title: &str, findings: &[Finding]) {
    println!("{title:34} throughput          latency             error in ε");
    println!("{:34}  ratio       ns     ratio       ns       pos.     vel.     acc.", "");
    for finding in findings {
        println!("{}", row(finding));
    }
    println!();
}

fn row(Finding { name, throughput, latency, errors }: &Finding) -> String {
    let mut row = format!("{name:34} {:6.3} {:8.1}", throughput.ratio, throughput.nanoseconds);
    match latency {
        Some(latency) => row += &format!("    {:6.3} {:8.1}  ", latency.ratio, latency.nanoseconds),
        None => row += &format!("{:21}", ""),
    }
    for error in errors.iter().flatten() {
        row += &format!(" {error:8.1}");
    }
    row.trim_end().to_owned()
}
