//! FMUs: FMPy validates them and simulates them, and its numbers are those of the solver in Rust.

use std::path::{Path, PathBuf};
use std::process::Command;

include!("data/press.rs");

/// An FMU of the press.
fn fmu(name: &str, flags: &[&str]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let output = Command::new(env!("CARGO_BIN_EXE_linkage"))
        .args(["fmu", "tests/data/press.rs", "-o"])
        .arg(&path)
        .args(flags)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    path
}

/// The lines that FMPy's script prints; none where there is no FMPy.
fn simulated(fmu: &Path, mode: &str) -> Option<Vec<Vec<String>>> {
    let python = std::env::var("LINKAGE_PYTHON").unwrap_or_else(|_| "python3".to_string());
    let has_fmpy = Command::new(&python).args(["-c", "import fmpy"]).output();
    if !has_fmpy.is_ok_and(|output| output.status.success()) {
        println!("skipped: {python} has no fmpy");
        return None;
    }
    let output = Command::new(python)
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/simulate.py"))
        .arg(fmu)
        .arg(mode)
        .output()
        .expect("Python starts");
    let report = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{report}{}", String::from_utf8_lossy(&output.stderr));
    let lines = report.lines().map(|line| line.split(' ').map(str::to_string).collect());
    Some(lines.collect())
}

fn numbers(line: &[String]) -> Vec<f64> {
    line[1..].iter().map(|word| word.parse().expect("a number")).collect()
}

/// The states after half a second, by Runge and Kutta's method with steps of 50 µs: its error is below 1e-12.
fn integrated(press: &Press) -> [f64; 2] {
    let (mut state, h) = ([0.4, 5.0], 5e-5);
    let rates = |state: [f64; 2]| press.state_rates(state, 1.5, 30.0).expect("it turns");
    let moved = |state: [f64; 2], by: f64, rate: [f64; 2]| [0, 1].map(|i| state[i] + by * rate[i]);
    for _ in 0..10_000 {
        let k1 = rates(state);
        let k2 = rates(moved(state, h / 2.0, k1));
        let k3 = rates(moved(state, h / 2.0, k2));
        let k4 = rates(moved(state, h, k3));
        let sum = [0, 1].map(|i| k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
        state = moved(state, h / 6.0, sum);
    }
    state
}

#[test]
fn a_dynamic_fmu_is_simulated_as_by_state_rates() {
    let Some(lines) = simulated(&fmu("press.fmu", &[]), "dynamic") else { return };
    assert_eq!(lines[0], ["findings", "0"]);
    let press = Press { counterweight: 2.5, ..Press::new() };
    let [theta, rate] = integrated(&press);
    let height = press.position(theta).expect("a pose").C.y;
    assert_eq!(lines.len(), 3);
    for line in &lines[1..] {
        for (found, expected) in numbers(line).iter().zip([theta, rate, height]) {
            let error = (found - expected).abs();
            assert!(
                error <= 1e-9 * expected.abs().max(1.0),
                "{line:?}: {expected}, off by {error:e}"
            );
        }
    }
}

#[test]
fn a_kinematic_fmu_computes_the_motion_and_says_who_refuses() {
    let Some(lines) = simulated(&fmu("press_kinematic.fmu", &["--kinematic"]), "kinematic") else {
        return;
    };
    assert_eq!(lines[0], ["findings", "0"]);
    let motion = Press::new().motion(0.4, 5.0, 2.0).expect("a pose");
    let expected = [motion.position.C.y, motion.velocity.C.y, motion.acceleration.C.y];
    let of_kind = |kind: &'static str| lines.iter().filter(move |line| line[0] == kind);
    for line in of_kind("ModelExchange").chain(of_kind("CoSimulation")) {
        assert_eq!(numbers(line), expected, "{line:?}");
    }
    let refusals: Vec<_> = of_kind("refused").collect();
    assert_eq!(refusals.len(), 2);
    for line in refusals {
        assert!(line.join(" ").ends_with("BC, ram cannot be assembled"), "{line:?}");
    }
}
