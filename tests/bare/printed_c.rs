//! The C that `linkage export c` prints beside the library of `export c;`: each function of both is called with the same
//! random numbers, and with numbers some last places from a limit, and answers with the same bytes, status and error.
//!
//! A program in C calls them: `c_harness.rs` writes it, from the prototypes in the headers. `LINKAGE_CALLS` says how
//! often each function is called; without it, 20 000 times.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

use super::build::{self, directory, library, sources, text};
use super::c_harness;

/// A folder with the printed C of all mechanisms of a file.
fn printed(name: &str, source: &Path) -> PathBuf {
    let folder = directory().join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the tests' directory can be written");
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--offline", "-p", "linkage-command", "--"])
        .args(["export", "c"])
        .arg(source)
        .arg("-o")
        .arg(&folder)
        .current_dir(sources())
        .output()
        .expect("Cargo starts");
    assert!(output.status.success(), "{}", text(&output.stderr));
    c_harness::write(&folder);
    folder
}

/// Compiles and runs the program, the printed C with these flags and the program with those.
fn compared(folder: &Path, library: &Path, flags: &[&str], of_program: &[&str]) -> Vec<Line> {
    let printed = c_harness::headers(folder).into_iter().map(|(stem, _)| format!("{stem}.c"));
    let parts = ["linkage_run.c", "linkage_root.c", "linkage_friction.c"].map(str::to_string);
    let parts = parts.into_iter().filter(|part| folder.join(part).exists());
    let mut names = Vec::new();
    for source in parts.chain(printed) {
        let object = source.replace(".c", ".o");
        let output = Command::new("gcc")
            .args(flags)
            .args(["-O2", "-Wall", "-Wextra", "-Werror", "-include", "renamed.txt", "-c"])
            .args([&source, "-o", &object])
            .current_dir(folder)
            .output()
            .expect("gcc starts");
        assert!(output.status.success(), "{}", text(&output.stderr));
        names.push(object);
    }
    let output = Command::new("gcc")
        .args(["-std=c99", "-O1", "-Wall", "-Wextra", "-Wno-unused-function", "-Werror"])
        .args(["-D_GNU_SOURCE", "harness.c"])
        .args(of_program)
        .args(&names)
        .arg(library)
        .args(["-Wl,--gc-sections", "-lm", "-o", "harness"])
        .current_dir(folder)
        .output()
        .expect("gcc starts");
    assert!(output.status.success(), "{}", text(&output.stderr));
    let calls = std::env::var("LINKAGE_CALLS").unwrap_or_else(|_| "20000".to_string());
    let start = Instant::now();
    let report = called(&folder.join("harness"), &calls);
    println!("{}: {flags:?}, {calls} calls a function in {:?}", folder.display(), start.elapsed());
    report.lines().map(Line::parsed).collect()
}

/// The report of the program, which runs once a processor, each time with a part of the functions.
fn called(harness: &Path, calls: &str) -> String {
    let parts = std::thread::available_parallelism().map_or(1, usize::from);
    let started = (0..parts).map(|part| {
        let mut command = Command::new(harness);
        command.args([calls, &part.to_string(), &parts.to_string()]);
        command.stdout(Stdio::piped()).spawn().expect("it starts")
    });
    // All of them run before the first one is waited for.
    let running: Vec<_> = started.collect();
    let mut report = String::new();
    for child in running {
        let output = child.wait_with_output().expect("it ends");
        let lines = text(&output.stdout);
        println!("{lines}");
        assert!(output.status.success(), "{lines}");
        report += &lines;
    }
    report
}

/// A line of the report: a function, called with numbers at random or beside a limit.
struct Line {
    is_beside_limit: bool,
    function: String,
    answered: u64,
    refused: u64,
    /// Groups and joints that refused.
    blamed: Vec<String>,
}

impl Line {
    fn parsed(line: &str) -> Self {
        let mut parts = line.split(" [");
        let words: Vec<&str> = parts.next().expect("counts").split(' ').collect();
        let [kind, function, answered, _, refused, _] = words[..] else { panic!("{line}") };
        let count = |word: &str| word.parse().expect("a count");
        Self {
            is_beside_limit: kind == "limit",
            function: function.to_string(),
            answered: count(answered),
            refused: count(refused),
            blamed: parts.map(|name| name.trim_end_matches(']').to_string()).collect(),
        }
    }
}

/// Also that every function answers and refuses, each often enough to mean something; these few refuse nothing.
fn each_is_met(lines: &[Line], functions: usize, constant: &[&str]) {
    let random = lines.iter().filter(|line| !line.is_beside_limit);
    for line in random.clone() {
        let name = line.function.trim_end_matches("_f32");
        let is_constant = constant.contains(&name) && line.refused == 0;
        assert!(line.answered > 100 && (line.refused > 50 || is_constant), "{}", line.function);
    }
    assert_eq!(random.count(), functions);
}

/// The groups and joints beside whose limits functions were called in both widths, by the mechanism.
fn limits_met(folder: &Path, lines: &[Line]) -> BTreeMap<String, Vec<String>> {
    let mut found = BTreeMap::new();
    for (stem, _) in c_harness::headers(folder) {
        let is_of = |line: &&Line| line.function.starts_with(&format!("{stem}_"));
        let of_width = |is_single: bool| {
            let own = lines.iter().filter(is_of).filter(|line| line.is_beside_limit);
            let own = own.filter(|line| line.function.ends_with("_f32") == is_single);
            own.flat_map(|line| line.blamed.iter().cloned()).collect::<BTreeSet<_>>()
        };
        let both: Vec<String> = of_width(false).intersection(&of_width(true)).cloned().collect();
        if !both.is_empty() {
            found.insert(stem, both);
        }
    }
    found
}

/// Products that a compiler may contract into sums, where the instruction is there and the run-time is told that it
/// is not: whatever were contracted would show.
const HIDDEN: [&str; 5] =
    ["-std=gnu17", "-march=x86-64-v3", "-U__FMA__", "-U__FP_FAST_FMA", "-U__FP_FAST_FMAF"];

/// The printed C with every set of flags that it is compiled with here, beside the library; and beside the library for
/// a machine with fused operations.
fn printed_is_the_library(folder: &Path, of_program: &[&str]) -> Vec<Line> {
    let library = library("all", "3").unwrap_or_else(|error| panic!("{error}"));
    let lines = compared(folder, &library, &["-std=c99"], of_program);
    if cfg!(target_arch = "x86_64") && std::is_x86_feature_detected!("fma") {
        compared(folder, &library, &HIDDEN, of_program);
        let fused = build::fused_library().unwrap_or_else(|error| panic!("{error}"));
        let of_program = [of_program, &["-DZEROS_HAVE_NO_SIGN"]].concat();
        compared(folder, &fused, &HIDDEN[..2], &of_program);
    }
    lines
}

fn listed(limits: &[(&str, &[&str])]) -> BTreeMap<String, Vec<String>> {
    let names = |list: &[&str]| list.iter().map(|name| name.to_string()).collect();
    limits.iter().map(|(stem, list)| (stem.to_string(), names(list))).collect()
}

#[test]
#[ignore = "a release build of all solvers: `.ci/nightly` makes it"]
fn printed_c_is_the_library() {
    let folder = printed("printed", &sources().join("mechanisms.rs"));
    let lines = printed_is_the_library(&folder, &[]);
    each_is_met(&lines, 230, &[]);
    let limits = listed(&[
        ("chosen_press", &["theta"]),
        ("everything", &["PC, block"]),
        ("excavator", &["crowd_ram, stick", "curl_ram, lever", "lift_ram, boom", "pull, bucket"]),
        ("heavy_robot", &["BC, EC"]),
        ("searched_press", &["h", "phi", "theta"]),
        ("slider_crank", &["BC, block"]),
        ("turning_bars", &["shoe, rod", "sleeve, bar", "x"]),
        ("tuned_four_bar", &["BC, DC"]),
    ]);
    assert_eq!(limits_met(&folder, &lines), limits);
}

/// Also of the mechanisms whose joints rub, at rest and in motion, from no friction to joints that jam.
#[test]
#[ignore = "a release build of all solvers: `.ci/nightly` makes it"]
fn printed_friction_is_the_library() {
    let folder = printed("printed_friction", &build::rubbing());
    let lines = printed_is_the_library(&folder, &["-DRUBS"]);
    let constant = [
        "drawer_coefficients",
        "incline_coefficients",
        "journal_holding",
        "laws_coefficients",
        "oscillator_coefficients",
        "unloaded_four_bar_holding",
    ];
    each_is_met(&lines, 390, &constant);
    let limits = listed(&[
        ("drawer", &["drawer"]),
        ("painleve_klein", &["one"]),
        ("pushed_crank", &["AB.A", "BC.B", "BC.C", "drive theta by push"]),
        ("rubbing_engine", &["AB.A", "BC.B", "BC.C", "piston"]),
        ("rubbing_four_bar", &["AB.A", "BC.B", "BC.C", "DC.D"]),
        ("rubbing_groups", &["CK.C", "CK.K", "block", "follower", "ram", "shoe", "shoe.H", "yoke"]),
        ("rubbing_press", &["AB.A", "BC, ram", "BC.B", "BC.C", "ram"]),
        ("wedge", &["follower", "shoe"]),
    ]);
    assert_eq!(limits_met(&folder, &lines), limits);
}
