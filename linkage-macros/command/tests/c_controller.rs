//! The controller in C under `examples`: its printed files are what the program prints today, and it holds the strip.

#[path = "../../../tests/skipped.rs"]
mod skipped;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const PRINT: &str = "cargo run -p linkage-command -- export c examples/c_controller/shear.rs \
                     -o examples/c_controller/solver --only motion,f32";

fn example() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/c_controller")
}

#[test]
fn printed_files_are_up_to_date() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("c_controller");
    let output = Command::new(env!("CARGO_BIN_EXE_linkage"))
        .args(["export", "c"])
        .arg(example().join("shear.rs"))
        .arg("-o")
        .arg(&folder)
        .args(["--only", "motion,f32"])
        .output()
        .expect("the program starts");
    assert!(output.status.success());
    for name in ["flying_shear.h", "flying_shear.c", "linkage_run.h", "linkage_run.c"] {
        let read = |folder: &Path| fs::read_to_string(folder.join(name)).expect("it can be read");
        assert!(read(&folder) == read(&example().join("solver")), "`{name}` is old: `{PRINT}`");
    }
}

#[test]
fn the_blade_goes_with_the_strip() {
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join("shear");
    let command = Command::new("cc")
        .args([
            "-std=c99",
            "-pedantic",
            "-Wall",
            "-Wextra",
            "-Wshadow",
            "-Wconversion",
            "-Werror",
            "-O2",
        ])
        .args(["-Isolver", "main.c", "solver/flying_shear.c", "solver/linkage_run.c", "-lm", "-o"])
        .arg(&program)
        .current_dir(example())
        .output();
    let Ok(output) = command else { return skipped::skipped("the controller in C: no cc") };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(&program).output().expect("it starts");
    let report = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success() && report.starts_with("6 cuts in 2 s"), "{report}");
}
