//! FMUs: FMPy validates them and simulates them, and its numbers are those of the solver in Rust.

#[path = "../../../tests/skipped.rs"]
mod skipped;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

include!("data/press.rs");

/// An FMU of a declaration.
fn fmu(source: &str, name: &str, flags: &[&str]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let output = Command::new(env!("CARGO_BIN_EXE_linkage"))
        .args(["export", "fmu", &format!("tests/data/{source}.rs"), "-o"])
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
        skipped::skipped("models validated and simulated: no fmpy");
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

/// Forces and energy of a motion, in the order of the script.
fn forces(press: &Press, [theta, rate, second]: [f64; 3]) -> [f64; 6] {
    let forces = press.forces(theta, rate, second, 30.0).expect("a pose");
    let energy = press.energy(theta, rate).expect("a pose");
    let (pin, guide) = (forces.BC.C, forces.ram.way);
    [forces.theta.drive, pin.x, pin.y, guide.normal, energy.kinetic, energy.potential]
}

#[test]
fn a_dynamic_fmu_is_simulated_as_by_state_rates() {
    let Some(lines) = simulated(&fmu("press", "press.fmu", &[]), "dynamic") else { return };
    assert_eq!(lines[0], ["findings", "0"]);
    let press = Press { counterweight: 2.5, ..Press::new() };
    let [theta, rate] = integrated(&press);
    let [_, second] = press.state_rates([theta, rate], 1.5, 30.0).expect("it turns");
    let position = press.position(theta).expect("a pose");
    let mut expected = vec![theta, rate, position.C.y, position.BC.cos, position.BC.sin];
    expected.extend(forces(&press, [theta, rate, second]));
    // The drive that the motion needs is the one that has moved it.
    assert!((expected[5] - 1.5).abs() < 1e-12);
    assert_eq!(lines.len(), 5);
    let (at_first, at_last): (Vec<_>, Vec<_>) =
        lines[1..].iter().partition(|line| line[0] == "first");
    assert!(at_first.iter().all(|line| (numbers(line)[0] - 1.5).abs() < 1e-12), "{at_first:?}");
    for line in at_last {
        let found = numbers(line);
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(&expected) {
            let error = (found - expected).abs();
            // Forces have hundreds of newtons, the counterweight's inertia as much: 1e-9 of them.
            assert!(
                error <= 1e-9 * expected.abs().max(1.0),
                "{line:?}: {expected}, off by {error:e}"
            );
        }
    }
}

#[test]
fn a_kinematic_fmu_computes_the_motion_and_says_who_refuses() {
    let Some(lines) = simulated(&fmu("press", "kinematic.fmu", &["--kinematic"]), "kinematic")
    else {
        return;
    };
    assert_eq!(lines[0], ["findings", "0"]);
    let press = Press::new();
    let motion = press.motion(0.4, 5.0, 2.0).expect("a pose");
    let expected = [motion.position.C.y, motion.velocity.C.y, motion.acceleration.C.y];
    let expected = [&expected[..], &forces(&press, [0.4, 5.0, 2.0])].concat();
    let of_kind = |kind: &'static str| lines.iter().filter(move |line| line[0] == kind);
    assert_eq!(of_kind("ModelExchange").chain(of_kind("CoSimulation")).count(), 2);
    for line in of_kind("ModelExchange").chain(of_kind("CoSimulation")) {
        assert_eq!(numbers(line), expected, "{line:?}");
    }
    let refusals: Vec<_> = of_kind("refused").collect();
    assert_eq!(refusals.len(), 2);
    for line in refusals {
        assert!(line.join(" ").ends_with("BC, ram cannot be assembled"), "{line:?}");
    }
}

/// The files of an archive that holds them as they are.
fn unpacked(archive: &[u8]) -> Vec<(String, &[u8])> {
    let number = |at: usize, count: usize| {
        archive[at..at + count].iter().rev().fold(0, |sum, &byte| (sum << 8) | usize::from(byte))
    };
    let (mut files, mut at) = (Vec::new(), 0);
    while archive[at..].starts_with(b"PK\x03\x04") {
        let (size, name) = (number(at + 18, 4), number(at + 26, 2));
        let content = at + 30 + name + number(at + 28, 2);
        let name = String::from_utf8_lossy(&archive[at + 30..at + 30 + name]).into_owned();
        files.push((name, &archive[content..content + size]));
        at = content + size;
    }
    files
}

/// A program in C calls the model as the standard allows and as it forbids, without Python.
#[test]
fn models_keep_to_their_standard() {
    is_called("called", &[]);
    is_called("called_kinematic", &["--kinematic"]);
}

fn is_called(name: &str, flags: &[&str]) {
    let archive = fs::read(fmu("press", &format!("{name}.fmu"), flags)).expect("it was written");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).expect("a folder can be made");
    let mut description = String::new();
    for (name, content) in unpacked(&archive) {
        match name.strip_prefix("sources/") {
            Some(source) => fs::write(folder.join(source), content).expect("it can be written"),
            None if name == "modelDescription.xml" => {
                description = String::from_utf8_lossy(content).into_owned();
            }
            None => {}
        }
    }
    let reference = |name: &str| {
        let start = format!("<Float64 name=\"{name}\" valueReference=\"");
        let (_, rest) = description.split_once(&start).expect("it is a variable");
        format!(
            "-D{}={}",
            name.replace('.', "_").to_uppercase(),
            rest.split('"').next().expect("a number")
        )
    };
    let names = ["theta", "theta_rate", "theta_acceleration", "rod", "C.y"];
    let caller = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/fmu_caller.c");
    let compiled = Command::new("cc")
        .args(["-std=c99", "-D_DEFAULT_SOURCE", "-Wall", "-Wextra", "-Werror", "-I."])
        .args(names.map(reference))
        .args([caller, "linkage_run.c", "press.c", "-lm", "-o", "caller"])
        .current_dir(&folder)
        .output();
    let Ok(compiled) = compiled else {
        return skipped::skipped("models called by a program in C: no cc");
    };
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let output = Command::new(folder.join("caller")).output().expect("it starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}

/// Every variable has the unit of what it is, and every unit its powers of kilogram, metre, second and radian.
#[test]
fn variables_have_units_by_their_dimensions() {
    let archive = fs::read(fmu("press", "units.fmu", &[])).expect("it was written");
    // The archive holds its files as they are.
    let text = String::from_utf8_lossy(&archive);
    let variables: Vec<_> = text.lines().filter(|line| line.contains("<Float64 ")).collect();
    assert!(variables.len() == 25 && variables.iter().all(|line| line.contains(" unit=\"")));
    for (name, unit, powers) in [
        ("time", "s", " s=\"1\""),
        ("theta", "rad", " rad=\"1\""),
        ("theta_rate", "rad/s", " s=\"-1\" rad=\"1\""),
        ("theta_acceleration", "rad/s²", " s=\"-2\" rad=\"1\""),
        ("drive of theta", "N·m", " kg=\"1\" m=\"2\" s=\"-2\""),
        ("work", "N", " kg=\"1\" m=\"1\" s=\"-2\""),
        ("counterweight", "kg", " kg=\"1\""),
        ("rod", "m", " m=\"1\""),
        ("C.x", "m", " m=\"1\""),
        ("velocity of C.y", "m/s", " m=\"1\" s=\"-1\""),
        ("acceleration of C.y", "m/s²", " m=\"1\" s=\"-2\""),
        ("BC.sin", "1", ""),
        ("BC.omega", "rad/s", " s=\"-1\" rad=\"1\""),
        ("BC.C.x", "N", " kg=\"1\" m=\"1\" s=\"-2\""),
        ("ram.way.couple", "N·m", " kg=\"1\" m=\"2\" s=\"-2\""),
        ("kinetic energy", "N·m", " kg=\"1\" m=\"2\" s=\"-2\""),
    ] {
        let of_name = format!(" name=\"{name}\"");
        let line = variables.iter().find(|line| line.contains(&of_name)).expect(name);
        assert!(line.contains(&format!(" unit=\"{unit}\"")), "{line}");
        let base = format!("<Unit name=\"{unit}\">\n      <BaseUnit{powers}/>\n");
        assert_eq!(text.matches(&base).count(), 1, "{base}");
    }
}

/// Forces that are refused, as where friction may hold itself, leave the motion alone.
#[test]
fn a_group_of_outputs_is_refused_alone() {
    let Some(lines) = simulated(&fmu("drawer", "drawer.fmu", &[]), "jams") else { return };
    assert_eq!(lines[0], ["findings", "0"]);
    let [_, motion, jams] = &lines[..] else { panic!("{lines:?}") };
    assert_eq!(motion[0], "CoSimulation");
    assert!((numbers(motion)[0] - 0.04).abs() < 1e-12, "{motion:?}");
    assert!(jams.join(" ").ends_with("drawer may be held by friction"), "{jams:?}");
}
