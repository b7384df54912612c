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

use super::build::{PACKAGE, library, sources, text};

/// The optimisation levels at which a bare library is compiled.
const LEVELS: [&str; 5] = ["1", "2", ALL, "s", "z"];

/// The level at which every mechanism is built.
const ALL: &str = "3";

/// Every entry point in both widths, as the end of a function's name; and the count of mechanisms that have it, at a
/// level where few of them rub and where all are built.
const ENTRIES: [(&str, [usize; 2]); 17] = [
    ("position", [17, 31]),
    ("velocity", [17, 31]),
    ("motion", [17, 31]),
    ("coefficients", [17, 31]),
    ("position_at", [10, 18]),
    ("velocity_at", [10, 18]),
    ("motion_at", [10, 18]),
    ("margins", [8, 8]),
    ("forces", [8, 22]),
    ("statics", [8, 22]),
    ("forces_at", [4, 12]),
    ("statics_at", [4, 12]),
    ("energy", [4, 12]),
    ("energy_at", [2, 7]),
    ("forward_dynamics", [7, 17]),
    ("equations_of_motion", [5, 7]),
    ("holding", [2, 13]),
];

/// The library at a level: where printed C is compared with it, all of it.
fn library_at(level: &str) -> PathBuf {
    let features = if level == ALL { "all" } else { "" };
    library(features, level).unwrap_or_else(|error| panic!("-O{level}: {error}"))
}

/// The C functions that the library defines, but for the controls.
fn functions(library: &Path) -> Vec<String> {
    let output = Command::new("nm").args(["-g", "--defined-only"]).arg(library).output();
    let symbols = text(&output.expect("nm comes with gcc").stdout);
    let code = symbols.lines().filter_map(|line| line.split_once(" T ")).map(|(_, name)| name);
    // Rust's own functions, and those of its compiler, have names that no C header declares.
    let declared = code.filter(|name| {
        name.contains('_') && !name.starts_with('_') && !name.starts_with("control_")
    });
    let mut functions: Vec<String> = declared.map(str::to_owned).collect();
    functions.sort();
    functions.dedup();
    functions
}

/// Links these functions of the library into a program without anything else, or says what is
/// missing.
fn link_alone(library: &Path, name: &str, functions: &[&str]) -> Result<PathBuf, String> {
    let mut table = String::from("#include <stddef.h>\n");
    for name in functions {
        let _ = writeln!(table, "void {name}(void);");
    }
    let _ =
        writeln!(table, "void (*const volatile solvers[])(void) = {{{}}};", functions.join(", "));
    let _ = writeln!(table, "const size_t solver_count = {};", functions.len());
    // Tests that link against one library run side by side.
    let beside = |ending| library.with_extension(format!("{name}{ending}"));
    let (source, program) = (beside(".c"), beside(""));
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
    let library = library_at(level);
    let functions = functions(&library);
    for (entry, counts) in ENTRIES {
        for ending in [format!("_{entry}"), format!("_{entry}_f32")] {
            // `…_equations_of_motion` is another entry point than `…_motion`.
            let others = ENTRIES.iter().filter(|(other, _)| other.ends_with(&format!("_{entry}")));
            let others: Vec<String> =
                others.map(|(other, _)| ending.replacen(&format!("_{entry}"), other, 1)).collect();
            let is_this = |name: &&String| {
                name.ends_with(&ending) && !others.iter().any(|other| name.ends_with(other))
            };
            let count = functions.iter().filter(is_this).count();
            assert_eq!(
                count,
                counts[usize::from(level == ALL)],
                "-O{level}: functions on …{ending}"
            );
        }
    }
    let methods = functions.iter().filter(|name| name.starts_with("methods_")).count();
    assert_eq!(methods, 32, "-O{level}: both widths of what `methods.rs` calls");
    let functions: Vec<&str> = functions.iter().map(String::as_str).collect();
    if let Err(missing) = link_alone(&library, "alone", &functions) {
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
#[ignore = "a release build of all solvers: `.ci/run` makes it"]
fn solvers_stand_alone_at_level_3() {
    prove("3");
}

#[test]
#[ignore = "release builds of all solvers: `.ci/nightly` makes them"]
fn solvers_stand_alone_at_every_optimisation_level() {
    for level in LEVELS {
        prove(level);
    }
}

/// The result of linking a control of the library; the error is the linker's message.
fn linked(control: &str, level: &str) -> Result<(), String> {
    let library = library_at(level);
    link_alone(&library, control, &[control]).map(drop)
}

fn a_reachable_panic_is_caught(level: &str) {
    assert_eq!(linked("control_sound", level), Ok(()));
    let error = linked("control_indexing", level).expect_err("an index may be out of range");
    assert!(error.contains("a_panic_is_reachable"), "-O{level}: {error}");
}

#[test]
#[ignore = "a release build of all solvers: `.ci/run` makes it"]
fn a_reachable_panic_is_caught_at_level_3() {
    a_reachable_panic_is_caught("3");
}

#[test]
#[ignore = "release builds of all solvers: `.ci/nightly` makes them"]
fn a_reachable_panic_is_caught_at_every_optimisation_level() {
    for level in LEVELS {
        a_reachable_panic_is_caught(level);
    }
}

#[test]
#[ignore = "release builds of all solvers: `.ci/nightly` makes them"]
fn the_heap_is_caught() {
    let error = library("boxing", "3").expect_err("there is no allocator");
    assert!(error.contains("no global memory allocator found"), "{error}");
    let error = linked("control_malloc", "3").expect_err("there is no C library");
    assert!(error.contains("undefined reference to `malloc'"), "{error}");
}

#[test]
#[ignore = "release builds of all solvers: `.ci/nightly` makes them"]
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
