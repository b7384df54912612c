//! `linkage report` as it is called.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

const SHEAR: &str = "\
struct FlyingShear {
    input theta: angle;
    param crank = 80mm;
    ground A(0, 0), D(665.7mm, 0);
    crank AB(A) -> B { length: crank, angle: theta }
    rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
    output C;
}
";

fn linkage(arguments: &[&str]) -> Output {
    let file = file();
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.arg("report").arg(file).args(arguments).output().expect("the program starts")
}

/// Written once, as tests run beside one another.
fn file() -> &'static Path {
    static FILE: OnceLock<PathBuf> = OnceLock::new();
    FILE.get_or_init(|| {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("reported.rs");
        fs::write(&path, SHEAR).expect("a file can be written");
        path
    })
}

fn texts(output: &Output) -> [String; 2] {
    [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned())
}

#[test]
fn a_report_is_a_table_and_json() {
    let output = linkage(&[]);
    let [text, _] = texts(&output);
    assert_eq!(output.status.code(), Some(0));
    let x = text.lines().find(|line| line.contains("position.C.x")).expect("a row");
    assert!(x.contains("0.14 µm") && x.contains("608.5 mm"), "{x}");
    assert!(text.contains("no call takes the slow path"), "{text}");
    let angles = "Transmission angle of BC, DC: from 65.4°, at 0.0°, to 92.1°, at -180.0°.";
    assert!(text.contains(angles), "{text}");

    let output = linkage(&["--json", "--width", "f32"]);
    let [text, _] = texts(&output);
    let json: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
    let motion = &json[0]["entries"][0];
    assert_eq!(motion["entry"], "motion");
    assert_eq!(motion["straight"], true);
    let x = &motion["results"][0];
    assert_eq!((&x["result"], &x["unit"]), (&"position.C.x".into(), &"m".into()));
    let within = x["f32"]["within"].as_f64().expect("a number");
    assert!((1.2e-7..1.6e-7).contains(&within), "{within:e}");
    assert!(x["f64"].is_null());
    assert!(x["sensitivities"]["crank"].as_f64().is_some_and(|slope| slope > 1.0), "{x}");
}

#[test]
fn the_exit_status_tells_what_is_not_shown() {
    let status = |arguments: &[&str]| {
        let output = linkage(arguments);
        let [_, why] = texts(&output);
        (output.status.code(), why)
    };
    assert_eq!(status(&["--within", "1um", "--width", "f32"]), (Some(0), String::new()));
    assert_eq!(status(&["--within", "1e-6mm", "--width", "f64"]), (Some(0), String::new()));
    let (code, why) = status(&["--within", "0.1um"]);
    assert_eq!(code, Some(1));
    assert!(
        why.contains("`FlyingShear.motion position.C.x` is proved within 0.14 µm in f32"),
        "{why}"
    );
    // So long a crank does not turn fully.
    let (code, why) = status(&["--within", "1um", "--width", "f32", "--set", "crank=420mm"]);
    assert_eq!(code, Some(1));
    // The proposed range is shown.
    let proposed = |why: &str| {
        let words = why.split("narrow it by `--between ").nth(1).expect("a range is proposed");
        words.split('`').next().expect("it ends").to_string()
    };
    let range = proposed(&why);
    let long = ["--within", "1um", "--width", "f32", "--set", "crank=420mm", "--between"];
    let (code, why) = status(&[&long[..], &[&range]].concat());
    assert_eq!((code, &why[..]), (Some(0), ""), "{range}");
    // A finer wish is shown farther from the limits, and a nanometre nowhere.
    let (_, finer) = status(&["--within", "0.3um", "--width", "f32", "--set", "crank=420mm"]);
    let ends = |range: &str| {
        let ends = range.trim_start_matches("theta=").split("..");
        ends.map(|end| end.trim_end_matches("deg").parse::<f64>().expect("degrees"))
            .collect::<Vec<_>>()
    };
    let (wide, narrow) = (ends(&range), ends(&proposed(&finer)));
    assert!(wide[0] < narrow[0] && narrow[1] < wide[1], "{wide:?} {narrow:?}");
    let (_, why) = status(&["--within", "1e-9m", "--width", "f32", "--set", "crank=420mm"]);
    assert!(why.contains("narrow it by `--between`"), "{why}");
    let (code, why) = status(&["--between", "theta"]);
    assert_eq!(code, Some(2));
    assert!(why.contains("write `NAME=VALUE` in place of `theta`"), "{why}");
    let (code, why) = status(&["--rate", "thetta=1"]);
    assert_eq!(code, Some(1));
    assert!(why.contains("`thetta` is not an input"), "{why}");
}
