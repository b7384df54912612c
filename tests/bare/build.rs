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
    package
});

/// The static library with these features at this optimisation level, or what Cargo said.
pub(crate) fn library(features: &str, level: &str) -> Result<PathBuf, String> {
    let _one_at_a_time = BUILDING.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let target = directory().join("target");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--release", "--offline", "--features", features, "--target-dir"])
        .arg(&target)
        .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", level)
        .current_dir(&*PACKAGE)
        .output()
        .expect("Cargo starts");
    if !output.status.success() {
        return Err(text(&output.stderr));
    }
    let kept = directory().join(format!("solvers-{level}-{features}.a"));
    // Another test may be reading what an earlier build left there.
    let fresh = kept.with_extension("fresh");
    fs::copy(target.join("release/libbare.a"), &fresh).expect("the library was built");
    fs::rename(&fresh, &kept).expect("it is put in its place");
    Ok(kept)
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
