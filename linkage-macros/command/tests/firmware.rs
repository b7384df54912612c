//! Templates of `examples/firmware` against the names that LinuxCNC and ros2_control have: they compile, and poses, rates
//! and efforts come back.

#[path = "../../../tests/skipped.rs"]
mod skipped;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use skipped::skipped;

fn printed() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("firmware");
    let _ = fs::remove_dir_all(&folder);
    let output = Command::new(env!("CARGO_BIN_EXE_linkage"))
        .args(["export", "c", "robots.rs", "--only", "f64", "-o"])
        .arg(&folder)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/firmware"))
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder
}

/// The numbers that a program of these sources prints; none without a compiler.
fn ran(
    compiler: &str,
    folder: &Path,
    flags: &[&str],
    sources: &[&str],
    name: &str,
) -> Option<Vec<f64>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (stubs, templates) =
        (root.join("tests/data/firmware"), root.join("../../examples/firmware"));
    let mut command = Command::new(compiler);
    command.args(flags).args(["-Wall", "-Wextra", "-Werror", "-O1", "-o", name]);
    command.arg("-I").arg(&stubs).arg("-I").arg(&templates).arg("-I.").args(sources).arg("-lm");
    let Ok(output) = command.current_dir(folder).output() else {
        skipped(&format!("templates for firmware: no {compiler}"));
        return None;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(folder.join(name)).output().expect("the program starts");
    assert!(output.status.success(), "{output:?}");
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    println!("{name}: {told}");
    Some(told.split_whitespace().map(|word| word.parse().expect("a number")).collect())
}

#[test]
fn templates_compile_and_come_back() {
    let folder = printed();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = |path: PathBuf| path.to_string_lossy().into_owned();
    let (kins, caller, transmission) = (
        text(root.join("../../examples/firmware/five_bar_kins.c")),
        text(root.join("tests/data/firmware/five_bar_caller.c")),
        text(root.join("tests/data/firmware/ankle_caller.cpp")),
    );
    let solver = ["five_bar.c", "five_bar_motors.c", "five_bar_hand.c", "linkage_run.c"];
    let sources = [&[&kins[..], &caller][..], &solver].concat();
    if let Some(told) = ran("cc", &folder, &["-std=c99", "-pedantic"], &sources, "kins") {
        let [found, refused, back, ratio, jump] = told[..] else { panic!("{told:?}") };
        assert!(found > 5_000.0 && refused > 1_000.0, "{found} {refused}");
        // A tenth of a nanometre, of lengths of 200 mm next to limits; the error of a difference is its step's square.
        assert!(back < 1e-7 && ratio < 1e-4, "{back} {ratio}");
        // Steps of 0.12 mm turn no arm by more than a degree.
        assert!(jump < 1.0, "{jump}");
    }
    let solver = ["ankle.c", "ankle_motors.c", "ankle_joints.c", "linkage_run.c"];
    let sources = [&["-x", "c++", &transmission[..]][..], &solver].concat();
    if let Some(told) = ran("c++", &folder, &["-std=c++17"], &sources, "transmission") {
        let [joints, motors, back, power] = told[..] else { panic!("{told:?}") };
        assert_eq!([joints, motors], [2.0; 2]);
        // Units of 1, over a condition of some tens where the rod is nearly in line with its arm.
        assert!(back < 1e-11 && power < 1e-13, "{back} {power}");
    }
}
