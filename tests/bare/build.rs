//! Builds the solvers as a static library without the standard library.
//!
//! The package is written to Cargo's directory for tests' files; its sources stay where they are.
//! All builds share one target directory, so that the macro is compiled once.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{LazyLock, Mutex};

/// The directory that holds everything that is built.
pub(crate) fn directory() -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bare");
    fs::create_dir_all(&directory).expect("the tests' directory can be written");
    directory
}

/// This directory, where the sources are.
pub(crate) fn sources() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("bare")
}

/// The root of the repository.
const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// One build at a time: they leave their results under the same name.
static BUILDING: Mutex<()> = Mutex::new(());

/// The package, written once.
pub(crate) static PACKAGE: LazyLock<PathBuf> = LazyLock::new(|| {
    let package = directory().join("package");
    fs::create_dir_all(&package).expect("a directory for the package");
    let manifest = include_str!("package.toml").replace("@ROOT@", ROOT);
    fs::write(package.join("Cargo.toml"), manifest).expect("the package's manifest");
    // The versions that this workspace is tested with, all of them on this machine already.
    fs::copy(Path::new(ROOT).join("Cargo.lock"), package.join("Cargo.lock")).expect("a lock file");
    let [at_every_level, others] = rubbing_sources();
    write_anew(&package.join("rubbing.rs"), &at_every_level);
    write_anew(&package.join("other_rubbing.rs"), &others);
    write_anew(&package.join("all_rubbing.rs"), &(at_every_level + &others));
    package
});

/// Writes a file unless it is as it is to be: what is written anew is built anew.
fn write_anew(path: &Path, text: &str) {
    if fs::read_to_string(path).ok().as_deref() != Some(text) {
        fs::write(path, text).expect("the tests' directory can be written");
    }
}

/// The mechanisms of the tests whose joints rub, with C functions.
pub(crate) fn rubbing() -> PathBuf {
    PACKAGE.join("all_rubbing.rs")
}

/// Those of them that are built at every level: between them they hold every group, a motion that is told, one
/// that follows from loads with several inputs, and a load that drives.
const AT_EVERY_LEVEL: [&str; 3] = ["RubbingGroups", "RubbingArm", "RubbingEngine"];

/// The other one that a load drives.
const PUSHED: &str = "PushedCrank";

/// The declarations that are built at every level, and the others.
fn rubbing_sources() -> [String; 2] {
    let mechanisms = Path::new(ROOT).join("tests/src/mechanisms");
    let read = |name| fs::read_to_string(mechanisms.join(name)).expect("it can be read");
    let (rubbing, pulled) = (read("friction.rs"), read("rubbing_pulled.rs"));
    let is_one_of = |block: &str, names: &[&str]| {
        names.iter().any(|name| block.contains(&format!("pub struct {name} ")))
    };
    let of = |source: &str| source.split("\nmechanism! {").skip(1).map(str::to_owned).collect();
    let [mut blocks, pulled]: [Vec<String>; 2] = [of(&rubbing), of(&pulled)];
    let wanted = [&AT_EVERY_LEVEL[..], &[PUSHED]].concat();
    blocks.extend(pulled.into_iter().filter(|block| is_one_of(block, &wanted)));
    let (at_every_level, others): (Vec<_>, Vec<_>) =
        blocks.into_iter().partition(|block| is_one_of(block, &AT_EVERY_LEVEL));
    assert_eq!(at_every_level.len(), AT_EVERY_LEVEL.len(), "each name is declared");
    [at_every_level, others].map(|blocks| {
        let exported = |block: String| block.replace("\n    }\n}", "\n        export c;\n    }\n}");
        let declared = |block| format!("\nmechanism! {{{}", exported(block));
        blocks.into_iter().map(declared).collect()
    })
}

/// The static library with these features at this optimisation level, or what Cargo said.
pub(crate) fn library(features: &str, level: &str) -> Result<PathBuf, String> {
    built(features, level, "release", &[])
}

/// All solvers for a machine with fused operations, which are none without the standard library.
pub(crate) fn fused_library() -> Result<PathBuf, String> {
    // With a target of its own the macro is compiled once, without the flags.
    let target = "x86_64-unknown-linux-gnu";
    let flags = format!("target.{target}.rustflags=[\"-Ctarget-cpu=x86-64-v3\"]");
    let place = format!("{target}/release");
    built("fused,all", "3", &place, &["--target", target, "--config", &flags])
}

/// Also where the result is found, below the target directory, and other arguments.
fn built(features: &str, level: &str, place: &str, others: &[&str]) -> Result<PathBuf, String> {
    let _one_at_a_time = BUILDING.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let target = directory().join("target");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--release", "--offline", "--features", features, "--target-dir"])
        .arg(&target)
        .args(others)
        .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", level)
        // A linter in the compiler's place, as `.ci/run` has it, optimises less.
        .env_remove("RUSTC_WORKSPACE_WRAPPER")
        .current_dir(&*PACKAGE)
        .output()
        .expect("Cargo starts");
    if !output.status.success() {
        return Err(text(&output.stderr));
    }
    let kept = directory().join(format!("solvers-{level}-{features}.a"));
    // Another test may be reading what an earlier build left there.
    let fresh = kept.with_extension("fresh");
    fs::copy(target.join(place).join("libbare.a"), &fresh).expect("the library was built");
    fs::rename(&fresh, &kept).expect("it is put in its place");
    Ok(kept)
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
