//! Pictures that the program draws: those of Rust, byte for byte.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use linkage_core::SolveError;

include!("data/shear.rs");
include!("data/gripper.rs");

fn draw(flags: &[&str]) -> Output {
    draw_of("shear.rs", flags)
}

fn draw_of(file: &str, flags: &[&str]) -> Output {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let command = command.args(["draw", file]).args(flags).current_dir(data);
    command.output().expect("the program starts")
}

fn told(flags: &[&str]) -> (Option<i32>, String) {
    let output = draw(flags);
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn a_picture_is_the_one_that_rust_draws() {
    let flags = ["--machine", "Shear", "--set", "crank=9cm", "--set", "side=left"];
    let more = ["--at", "theta=120deg", "--title", "A <shear>"];
    let shear = Shear { crank: 0.09, side: linkage_core::Side::Left };
    let at = 120.0 * (std::f64::consts::PI / 180.0);
    let sketch = shear.sketch(at).expect("it is in reach").title("A <shear>");
    let drawn = draw(&[&flags[..], &more].concat());
    assert_eq!(String::from_utf8_lossy(&drawn.stdout), sketch.to_svg().expect("it can be drawn"));
    // A drawn machine stands as it is drawn.
    let sketch = Lift::new().sketch(0.4_f64.hypot(0.6)).expect("it is drawn");
    let drawn = draw(&["--machine", "Lift"]);
    assert_eq!(String::from_utf8_lossy(&drawn.stdout), sketch.to_svg().expect("it can be drawn"));
    // An angle of which nothing is said is one radian.
    let sketch = Shear::new().sketch(1.0).expect("it is in reach");
    let drawn = draw(&flags[..2]);
    assert_eq!(String::from_utf8_lossy(&drawn.stdout), sketch.to_svg().expect("it can be drawn"));
}

#[test]
fn a_pose_that_is_none_is_told() {
    let error = Shear { crank: 2.5, ..Shear::new() }.sketch(0.0).expect_err("it is out of reach");
    assert!(matches!(error, SolveError::OutOfReach { .. }), "{error:?}");
    let (status, why) = told(&["--machine", "Shear", "--at", "theta=0", "--set", "crank=2.5m"]);
    assert_eq!(status, Some(2), "{why}");
    assert!(why.contains(&format!("`Shear` cannot be drawn: {error}")), "{why}");
    let (status, why) = told(&["--at", "theta=1m"]);
    assert_eq!(status, Some(2), "{why}");
    assert!(why.contains("this is in m, and `theta` is in rad"), "{why}");
}

/// A group of several unknowns is drawn where it is certified, and refused by that elsewhere.
#[test]
fn a_group_of_several_unknowns_is_drawn() {
    let gripper = Gripper::new();
    let [drawn] = Gripper::DRAWN;
    let sketch = gripper.sketch(drawn + 1e-3).expect("the cylinder comes out");
    let at = format!("s={:?}", drawn + 1e-3);
    let output = draw_of("gripper.rs", &["--at", &at]);
    assert_eq!(String::from_utf8_lossy(&output.stdout), sketch.to_svg().expect("it can be drawn"));
    let error = gripper.sketch(drawn + 0.3).expect_err("the links are not so long");
    assert!(matches!(error, SolveError::NotCertified { .. }), "{error:?}");
    let output = draw_of("gripper.rs", &["--at", &format!("s={:?}", drawn + 0.3)]);
    let why = String::from_utf8_lossy(&output.stderr);
    assert!(why.contains(&format!("`Gripper` cannot be drawn: {error}")), "{why}");
}

#[test]
fn several_machines_are_files_of_a_folder() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawn/");
    let _ = fs::remove_dir_all(&folder);
    let path = folder.to_str().expect("it is a text");
    let flags = ["-o", path, "--machine", "Shear"];
    assert!(draw(&flags).status.success());
    let file = folder.join("Shear.svg");
    let drawn = fs::read_to_string(&file).expect("it was written");
    assert_eq!(drawn, Shear::new().sketch(1.0).unwrap().to_svg().unwrap());
    assert!(draw(&[&flags[..], &["--stale"]].concat()).status.success());
    fs::write(&file, "old").expect("it can be written");
    let (status, why) = told(&[&flags[..], &["--stale"]].concat());
    assert_eq!(status, Some(1));
    assert!(why.contains("is stale"), "{why}");
}
