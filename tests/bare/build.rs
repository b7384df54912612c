//! Builds the solvers as a static library without the standard library.
//!
//! The package is written to Cargo's directory for tests' files; its sources stay where they are.
//! All builds share one target directory, so that the macro is compiled once.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

/// The directory that holds everything that is built.
pub(crate) fn directory() -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bare");
    fs::create_dir_all(&directory).expect("the tests' directory can be written");
    directory
}

/// This directory, where the sources are.
pub(crate) fn sources() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bare")
}

fn manifest() -> String {
    let (root, library) = (env!("CARGO_MANIFEST_DIR"), sources().join("library.rs"));
    format!(
        "[package]\nname = \"bare\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
         [lib]\npath = {library:?}\ncrate-type = [\"staticlib\"]\n\n\
         [features]\ncontrol = []\nindexing = [\"control\"]\nboxing = [\"control\"]\n\
         malloc = [\"control\"]\nprinting = [\"control\"]\n\n\
         [profile.release]\npanic = \"abort\"\n\n\
         [dependencies]\nlinkage-core = {{ path = {:?}, default-features = false, \
         features = [\"macros\"] }}\n\n[workspace]\n",
        Path::new(root).join("linkage-core"),
    )
}

/// One build at a time: they leave their results under the same name.
static BUILDING: Mutex<()> = Mutex::new(());

/// The static library with these features at this optimisation level, or what Cargo said.
pub(crate) fn library(features: &str, level: &str) -> Result<PathBuf, String> {
    let _one_at_a_time = BUILDING.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let package = directory().join("package");
    fs::create_dir_all(&package).expect("a directory for the package");
    fs::write(package.join("Cargo.toml"), manifest()).expect("the package's manifest");
    // The versions that this workspace is tested with, all of them on this machine already.
    let lock = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.lock");
    fs::copy(lock, package.join("Cargo.lock")).expect("the workspace's lock file");
    let target = directory().join("target");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--release", "--offline", "--features", features, "--target-dir"])
        .arg(&target)
        .env("CARGO_PROFILE_RELEASE_OPT_LEVEL", level)
        .current_dir(&package)
        .output()
        .expect("Cargo starts");
    if !output.status.success() {
        return Err(text(&output.stderr));
    }
    let kept = directory().join(format!("solvers-{level}-{features}.a"));
    fs::copy(target.join("release/libbare.a"), &kept).expect("the library was built");
    Ok(kept)
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
