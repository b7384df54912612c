//! Functions of a target in printed C: the bounds of `linkage report` hold with the error that they promise, and a sine by
//! a table, one by an integer CORDIC and one that errs as it may are compiled and run.

#[path = "../../../tests/skipped.rs"]
mod skipped;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Machines without parameters that turn fully on the fast path: the name of the type, that of its files, and the text.
const MACHINES: [(&str, &str, &str); 3] = [
    (
        "FlyingShear",
        "flying_shear",
        "struct FlyingShear { input theta: angle; ground A(0, 0), D(665.7mm, 0);
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
         point blade on BC at (500mm, -60mm); output blade; }",
    ),
    (
        "Engine",
        "engine",
        "struct Engine { input theta: angle; ground A(0, 0); guide bore through A along 90deg;
         crank AB(A) -> B { length: 43mm, angle: theta }
         rrp rod(B), piston(bore) -> P { length: 136mm, offset: 12mm, mode: ahead } output P, rod; }",
    ),
    (
        "RockerSlider",
        "rocker_slider",
        "struct RockerSlider { input theta: angle; ground A(0, 0), D(200mm, -40mm);
         guide way through (0, 260mm) along 0deg;
         crank AB(A) -> B { length: 60mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (190mm, 120mm), mode: left }
         point E on DC at (210mm, 0);
         rrp EF(E), block(way) -> F { length: 220mm, offset: 0, mode: ahead } output C, F; }",
    ),
];

/// A target's functions: the header, what it is compiled with, and the errors as the report takes them.
struct Target {
    name: &'static str,
    header: &'static str,
    more: &'static [&'static str],
    errors: &'static [&'static str],
}

const WRONG: Target =
    Target { name: "wrong", header: "wrong.h", more: &[], errors: &["--sine-error", "2^-20"] };

const TARGETS: [Target; 4] = [
    WRONG,
    Target {
        name: "all",
        header: "wrong.h",
        more: &["-DALL_WRONG"],
        errors: &["--sine-error", "2^-20", "--sqrt-error", "2"],
    },
    Target { name: "cordic", header: "cordic.h", more: &[], errors: &["--sine-error", "2^-21"] },
    Target { name: "table", header: "cmsis_dsp.h", more: &[], errors: &["--sine-error", "2^-15"] },
];

const STRICT: [&str; 8] =
    ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror", "-O2"];

/// The step through the numbers of a turn; a sample takes a larger one.
const EVERY: u32 = 53;
const SAMPLED: u32 = EVERY * 2003;

fn source(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)
}

fn linkage(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.args(arguments).current_dir(folder).output().expect("the program starts")
}

fn text(output: &Output) -> String {
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// A folder with the printed solver of a machine.
fn printed(test: &str, (_, file, machine): (&str, &str, &str)) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("hooks").join(test).join(file);
    fs::create_dir_all(&folder).expect("a folder can be made");
    fs::write(folder.join("machine.rs"), machine).expect("a file can be written");
    text(&linkage(&folder, &["export", "c", "machine.rs", "-o", ".", "--only", "motion"]));
    folder
}

/// The header of the driver: the machine's words, and the bounds in single precision that a report proves at these errors.
fn with_bounds(folder: &Path, (name, file, _): (&str, &str, &str), errors: &[&str]) {
    let report = ["report", "machine.rs", "--only", "motion", "--width", "f32", "--json"];
    let report = text(&linkage(folder, &[&report, errors].concat()));
    let report: serde_json::Value = serde_json::from_str(&report).expect("it is JSON");
    let motion = &report[0]["entries"][0];
    assert_eq!(motion["straight"], true, "{name}");
    let results = motion["results"].as_array().expect("it is a list");
    let bounds = results.iter().map(|of| of["f32"]["within"].as_f64().expect("it is proved"));
    let bounds: Vec<String> = bounds.map(|bound| format!("{bound:e}")).collect();
    let header = format!(
        "#include \"{file}.h\"\ntypedef {name}Motion Wide;\ntypedef {name}MotionF32 Narrow;\n\
         #define WIDE(x, to, error) {file}_motion((x), 1.0, 0.0, (to), (error))\n\
         #define NARROW(x, to, error) {file}_motion_f32((x), 1.0f, 0.0f, (to), (error))\n\
         static const double bounds[] = {{ {} }};\n",
        bounds.join(", ")
    );
    fs::write(folder.join("machine.h"), header).expect("a file can be written");
}

/// A program with a target's functions in printed C; none without a compiler.
fn compiled(folder: &Path, target: &Target, sources: &[String]) -> Option<PathBuf> {
    let program = folder.join(target.name);
    let hooks = source("../../examples/c_controller/hooks");
    let command = Command::new("cc")
        .args(STRICT)
        .arg("-I.")
        .arg(format!("-I{}", hooks.display()))
        .arg(format!("-I{}", source("tests/hooks").display()))
        .arg(format!("-DLINKAGE_HOOKS=\"{}\"", target.header))
        .args(target.more)
        .args(sources)
        .args(["-lm", "-o"])
        .arg(&program)
        .current_dir(folder)
        .output();
    let Ok(output) = command else {
        skipped::skipped("functions of a target in C: no cc");
        return None;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(program)
}

/// The answer of the driver over every so many numbers of a turn; none without a compiler.
fn driven(
    folder: &Path,
    file: &str,
    target: &Target,
    every: u32,
) -> Option<Result<[f64; 3], String>> {
    let driver = source("tests/hooks/driver.c").display().to_string();
    let sources = [driver, format!("{file}.c"), "linkage_run.c".to_string()];
    let program = compiled(folder, target, &sources)?;
    let output = Command::new(program).arg(every.to_string()).output().expect("it starts");
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    if !output.status.success() {
        return Some(Err(told));
    }
    let numbers = told.split_whitespace().map(|word| word.parse().expect("it is a number"));
    Some(Ok(numbers.collect::<Vec<f64>>().try_into().expect("three of them")))
}

fn hold(test: &str, target: &Target, machines: &[(&str, &str, &str)], every: u32) {
    for &machine in machines {
        let folder = printed(test, machine);
        with_bounds(&folder, machine, target.errors);
        let Some(answer) = driven(&folder, machine.1, target, every) else { return };
        let what = format!("{} of {}", target.name, machine.0);
        let [poses, refused, share] = answer.unwrap_or_else(|told| panic!("{what}: {told}"));
        println!("{what}: {poses} poses, {share} of a bound at most");
        assert!(poses > 2.0 * 1.0e9 / f64::from(every) && refused == 0.0, "{what}: {refused}");
        // A bound adds all errors up as if each were at its worst, and some pose comes near.
        assert!(share > 0.1, "{what}: {share}");
    }
}

#[test]
fn bounds_hold_with_the_errors_that_functions_promise() {
    hold("sample", &WRONG, &MACHINES, SAMPLED);
    for target in &TARGETS[1..] {
        hold("sample", target, &MACHINES[..1], SAMPLED);
    }
}

/// 40 million poses of each of three machines.
#[test]
#[ignore = "a minute: nightly"]
fn bounds_hold_at_every_53rd_angle_with_a_sine_of_20_bits() {
    hold("whole", &WRONG, &MACHINES, EVERY);
}

/// The bounds of our own sine are exceeded by another one: the driver looks, and the functions are called.
#[test]
fn bounds_of_the_own_sine_do_not_hold_with_a_worse_one() {
    let machine = MACHINES[0];
    let folder = printed("own", machine);
    with_bounds(&folder, machine, &[]);
    let Some(answer) = driven(&folder, machine.1, &WRONG, SAMPLED) else { return };
    let told = answer.expect_err("a bound is exceeded");
    assert!(told.contains("is wrong by"), "{told}");
}

#[test]
fn the_controller_runs_with_a_table_and_with_a_cordic() {
    let example = source("../../examples/c_controller");
    for target in &TARGETS[2..] {
        let folder = printed("controller", MACHINES[0]);
        let at = |name: &str| example.join(name).display().to_string();
        let sources = [at("main.c"), "flying_shear.c".to_string(), "linkage_run.c".to_string()];
        let Some(program) = compiled(&folder, target, &sources) else { return };
        let output = Command::new(program).output().expect("it starts");
        let told = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success() && told.starts_with("6 cuts in 2 s"), "{told}");
    }
}

/// A function without its error, or with one that the fast path's comparisons do not allow for, is not compiled.
#[test]
fn a_function_states_its_error() {
    let folder = printed("stated", MACHINES[0]);
    for (given, told) in [
        (&["-DLINKAGE_SIN_COS_F32=f"][..], "LINKAGE_SIN_COS_WITHIN_F32"),
        (
            &["-DLINKAGE_SIN_COS_F64=f", "-DLINKAGE_SIN_COS_WITHIN_F64=9"],
            "LINKAGE_SIN_COS_WITHIN_F64",
        ),
        (&["-DLINKAGE_SQRT_F32=f"], "LINKAGE_SQRT_PLACES_F32"),
        (&["-DLINKAGE_SQRT_F64=f", "-DLINKAGE_SQRT_PLACES_F64=5"], "LINKAGE_SQRT_PLACES_F64"),
    ] {
        let command = Command::new("cc")
            .args(STRICT)
            .args(given)
            .args(["-c", "linkage_run.c", "-o", "stated.o"])
            .current_dir(&folder)
            .output();
        let Ok(output) = command else {
            return skipped::skipped("functions of a target in C: no cc");
        };
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && errors.contains(told), "{given:?}: {errors}");
    }
}

/// An error that is no number, or beyond what the fast path's comparisons allow for.
#[test]
fn an_error_that_cannot_be_is_refused() {
    let folder = printed("refused", MACHINES[0]);
    for (given, told) in [
        (["--sine-error", "2^-9"], "write the error of a sine as `2^-20` in place of `2^-9`"),
        (["--sine-error", "much"], "write the error of a sine as `2^-20` in place of `much`"),
        (["--sine-error", "-1e-6"], "write the error of a sine as `2^-20` in place of `-1e-6`"),
        (["--sqrt-error", "5"], "write the error of a square root as `1` in place of `5`"),
    ] {
        let [option, value] = given;
        let output = linkage(&folder, &["report", "machine.rs", &format!("{option}={value}")]);
        let errors = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(!output.status.success() && errors.contains(told), "{given:?}: {errors}");
    }
}
