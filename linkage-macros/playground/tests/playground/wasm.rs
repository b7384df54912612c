//! The same compiler for a browser: what it answers is what it answers here.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use linkage_playground::{ALL, C, CHECK, FMU, RUST, answered};

use super::{MACHINES, skipped};

/// Answers of the compiler in a browser, written into a folder.
const ASK: &str = include_str!("ask.cjs");

/// The playground, if this machine can build it: once for all tests.
pub(crate) fn built() -> Option<PathBuf> {
    static BUILT: OnceLock<Option<PathBuf>> = OnceLock::new();
    let build = || {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("play.html");
        let _ = fs::remove_file(&path);
        let status = Command::new(env!("CARGO_BIN_EXE_playground")).arg(&path).status();
        assert!(status.expect("the program starts").success());
        path.exists().then_some(path)
    };
    let path = BUILT.get_or_init(build).clone();
    if path.is_none() {
        skipped::skipped("the playground: no wasm32-unknown-unknown");
    }
    path
}

/// Every machine in every language, byte for byte; their drawn lengths are numbers on which all systems' `hypot` agree.
/// Memory that does not grow; the size of the file, and of what is fetched.
#[test]
#[ignore = "builds the compiler for a browser"]
fn a_browser_is_answered_alike() {
    let Some(page) = built() else { return };
    let size = fs::metadata(&page).expect("it was written").len();
    assert!((800_000..1_200_000).contains(&size), "{size} bytes");
    if Command::new("node").arg("--version").output().is_err() {
        return skipped::skipped("what the playground computes: no node");
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("playground");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    let mut texts: Vec<(String, String)> =
        MACHINES.iter().map(|(name, text)| (format!("{name}.rs"), text.to_string())).collect();
    let broken = MACHINES[0].1.replace("link BC(B", "link BC(Q");
    texts.push(("broken.rs".into(), broken));
    for (name, text) in &texts {
        fs::write(folder.join(name), text).expect("a file can be written");
    }
    let script = folder.join("ask.cjs");
    fs::write(&script, ASK).expect("a file can be written");
    let output =
        Command::new("node").arg(&script).arg(&page).arg(&folder).output().expect("node runs");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    for (name, text) in &texts {
        for task in [CHECK, C, FMU, RUST, ALL] {
            let found = fs::read(folder.join(format!("{name}.{task}"))).expect("it was answered");
            assert!(found == answered(text, task), "{name} is answered otherwise, task {task}");
        }
    }
    let numbers: Vec<u64> = said.split_whitespace().filter_map(|part| part.parse().ok()).collect();
    let [begun, memory, zipped] = numbers[..] else { panic!("{said}") };
    assert!(begun == memory && memory < 16 << 20, "{said}");
    // As a server sends it.
    assert!(zipped < 1_000_000, "{zipped} bytes zipped");
}
