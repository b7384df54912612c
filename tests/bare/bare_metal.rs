//! The proof that a solver needs neither the standard library nor a heap and cannot panic.
//!
//! The mechanisms of `tests/bare` are built without the standard library, with a panic handler
//! that calls a function nobody defines, and every function of every solver is linked into a
//! program that holds nothing else. A panic that can be reached is then an undefined symbol, and
//! so is an allocation; the standard library is a second panic handler. Each of these is also
//! tried, so that a proof that proves nothing fails.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::build::{PACKAGE, library, sources, text};

/// The optimisation levels at which a bare library is compiled.
const LEVELS: [&str; 5] = ["1", "2", "3", "s", "z"];

/// Every entry point in both widths, as the start of a function's name and its end.
const ENTRIES: [&str; 16] = [
    "position",
    "velocity",
    "motion",
    "coefficients",
    "position_at",
    "velocity_at",
    "motion_at",
    "margins",
    "forces",
    "statics",
    "forces_at",
    "statics_at",
    "energy",
    "energy_at",
    "forward_dynamics",
    "equations_of_motion",
];

/// The count of mechanisms that have the entry point.
fn mechanisms_with(entry: &str) -> usize {
    match entry {
        "position_at" | "velocity_at" | "motion_at" => 8,
        "margins" => 7,
        "forces" | "statics" | "forward_dynamics" | "equations_of_motion" => 4,
        "forces_at" | "statics_at" | "energy" => 2,
        "energy_at" => 1,
        _ => 13,
    }
}

/// The C functions that the library defines.
fn functions(library: &Path) -> Vec<String> {
    let output = Command::new("nm").args(["-g", "--defined-only"]).arg(library).output();
    let symbols = text(&output.expect("nm comes with gcc").stdout);
    let code = symbols.lines().filter_map(|line| line.split_once(" T ")).map(|(_, name)| name);
    // Rust's own functions, and those of its compiler, have names that no C header declares.
    let declared = code.filter(|name| name.contains('_') && !name.starts_with('_'));
    let mut functions: Vec<String> = declared.map(str::to_owned).collect();
    functions.sort();
    functions.dedup();
    functions
}

/// Links these functions of the library into a program without anything else, or says what is
/// missing.
fn link_alone(library: &Path, functions: &[&str]) -> Result<PathBuf, String> {
    let mut table = String::from("#include <stddef.h>\n");
    for name in functions {
        let _ = writeln!(table, "void {name}(void);");
    }
    let _ =
        writeln!(table, "void (*const volatile solvers[])(void) = {{{}}};", functions.join(", "));
    let _ = writeln!(table, "const size_t solver_count = {};", functions.len());
    let stem = library.with_extension("");
    let (source, program) = (stem.with_extension("table.c"), stem.with_extension("alone"));
    fs::write(&source, table).expect("the tests' directory can be written");
    let output = Command::new("gcc")
        .args(["-O1", "-ffreestanding", "-fno-tree-loop-distribute-patterns"])
        .args(["-nostdlib", "-static", "-Wl,--gc-sections", "-o"])
        .arg(&program)
        .arg(sources().join("alone.c"))
        .arg(&source)
        .arg(library)
        .output()
        .expect("gcc starts");
    if output.status.success() { Ok(program) } else { Err(text(&output.stderr)) }
}

fn prove(level: &str) {
    let library = library("", level).unwrap_or_else(|error| panic!("-O{level}: {error}"));
    let functions = functions(&library);
    for entry in ENTRIES {
        for ending in [format!("_{entry}"), format!("_{entry}_f32")] {
            // `…_equations_of_motion` is another entry point than `…_motion`.
            let others = ENTRIES.iter().filter(|other| other.ends_with(&format!("_{entry}")));
            let others: Vec<String> =
                others.map(|other| ending.replacen(&format!("_{entry}"), other, 1)).collect();
            let is_this = |name: &&String| {
                name.ends_with(&ending) && !others.iter().any(|other| name.ends_with(other))
            };
            let count = functions.iter().filter(is_this).count();
            assert_eq!(count, mechanisms_with(entry), "-O{level}: functions on …{ending}");
        }
    }
    let methods = functions.iter().filter(|name| name.starts_with("methods_")).count();
    assert_eq!(methods, 32, "-O{level}: both widths of what `methods.rs` calls");
    let functions: Vec<&str> = functions.iter().map(String::as_str).collect();
    if let Err(missing) = link_alone(&library, &functions) {
        let suspects = places_that_panic(&library).join("\n");
        panic!("-O{level}: the solvers do not stand alone:\n{missing}\nPanics:\n{suspects}");
    }
}

/// The functions of the library, but for Rust's own, that call what panics in `core`.
fn places_that_panic(library: &Path) -> Vec<String> {
    let output = Command::new("objdump").arg("-r").arg(library).output();
    let relocations = text(&output.expect("objdump comes with gcc").stdout);
    let (mut places, mut object, mut section) = (Vec::new(), "", "");
    for line in relocations.lines() {
        if let Some((name, _)) = line.split_once(":     file format") {
            object = name;
        } else if let Some(name) = line.strip_prefix("RELOCATION RECORDS FOR ") {
            section = name;
        } else if (line.contains("panicking") || line.contains("_fail"))
            && !object.starts_with("core-")
        {
            places.push(format!("{object} {section}"));
        }
    }
    places.retain(|place| place.contains("[.text"));
    places.dedup();
    places
}

#[test]
#[ignore = "release builds of all solvers: `.ci/run` makes them"]
fn solvers_stand_alone() {
    prove("3");
}

#[test]
#[ignore = "release builds of all solvers: `.ci/run` makes them"]
fn solvers_stand_alone_at_every_optimisation_level() {
    for level in LEVELS {
        prove(level);
    }
}

/// The result of linking a control that has to compile; the error is the linker's message.
fn linked(control: &str, level: &str) -> Result<(), String> {
    let library = library(control, level).unwrap_or_else(|error| panic!("{control}: {error}"));
    link_alone(&library, &["control"]).map(drop)
}

#[test]
#[ignore = "release builds of all solvers: `.ci/run` makes them"]
fn a_reachable_panic_is_caught_at_every_optimisation_level() {
    for level in LEVELS {
        assert_eq!(linked("control", level), Ok(()));
        let error = linked("indexing", level).expect_err("an index may be out of range");
        assert!(error.contains("a_panic_is_reachable"), "-O{level}: {error}");
    }
}

#[test]
#[ignore = "release builds of all solvers: `.ci/run` makes them"]
fn the_heap_is_caught() {
    let error = library("boxing", "3").expect_err("there is no allocator");
    assert!(error.contains("no global memory allocator found"), "{error}");
    let error = linked("malloc", "3").expect_err("there is no C library");
    assert!(error.contains("undefined reference to `malloc'"), "{error}");
}

#[test]
#[ignore = "release builds of all solvers: `.ci/run` makes them"]
fn the_standard_library_is_caught() {
    let error = library("printing", "3").expect_err("there are two panic handlers");
    assert!(error.contains("panic_impl") && error.contains("std"), "{error}");
}

/// The packages that a crate without default features of `linkage-core` is built from.
fn dependencies(features: &str) -> Vec<String> {
    let output = Command::new(env!("CARGO"))
        .args(["tree", "--offline", "--prefix", "none", "--format", "{lib}"])
        .args(["--edges", "normal,build", "--features", features])
        .current_dir(&*PACKAGE)
        .output()
        .expect("Cargo starts");
    assert!(output.status.success(), "{}", text(&output.stderr));
    text(&output.stdout).lines().map(str::to_owned).collect()
}

#[test]
fn without_default_features_there_is_neither_nalgebra_nor_num_dual() {
    let (bare, full) = (dependencies(""), dependencies("ad"));
    for name in ["linkage_core", "linkage_macros", "libm"] {
        assert!(bare.iter().any(|package| package == name), "no {name} in {bare:?}");
    }
    for name in ["nalgebra", "num_dual"] {
        assert!(full.iter().any(|package| package == name), "no {name} in {full:?}");
        assert!(!bare.iter().any(|package| package == name), "{name} in {bare:?}");
    }
}
