//! Scripts run by node, where it is installed.

use std::format;
use std::path::PathBuf;
use std::process::Command;
use std::string::String;
use std::sync::atomic::{AtomicU32, Ordering};

#[path = "../../../../../tests/skipped.rs"]
mod skipped;

/// The answer of a script.
pub(super) struct Output {
    pub is_success: bool,
    pub text: String,
}

/// Runs a script that is given the name of a file with this content; none where there is no node, unless
/// `LINKAGE_NODE` says that there must be.
pub(super) fn run(script: &str, content: &str) -> Option<Output> {
    static NEXT: AtomicU32 = AtomicU32::new(0);
    let is_there = Command::new("node").arg("--version").output().is_ok();
    if !is_there {
        assert!(std::env::var_os("LINKAGE_NODE").is_none(), "node is required");
        skipped::skipped("what the script of a page computes: no node");
        return None;
    }
    let unique = format!("linkage_{}_{}", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
    let file = |ending: &str, text: &str| -> PathBuf {
        let path = std::env::temp_dir().join(format!("{unique}.{ending}"));
        std::fs::write(&path, text).expect("the folder of temporary files is there");
        path
    };
    let (script, content) = (file("cjs", script), file("txt", content));
    let found = Command::new("node").arg(&script).arg(&content).output().expect("node runs");
    [script, content].iter().for_each(|path| drop(std::fs::remove_file(path)));
    let text = [found.stdout, found.stderr].concat();
    let text = String::from_utf8_lossy(&text).into_owned();
    Some(Output { is_success: found.status.success(), text })
}
