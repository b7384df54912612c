//! Printed structured text for readers of others: blark, a package of Python, and the crate iec61131. `.ci/nightly` brings
//! both.

use std::env;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use super::skipped::skipped;
use super::{all, folder, texts};

/// The texts of every so many declarations, as files.
fn written(name: &str, every: usize) -> Vec<PathBuf> {
    let place = folder(name);
    let _ = fs::remove_dir_all(&place);
    fs::create_dir_all(&place).expect("a folder can be made");
    let mut paths = Vec::new();
    for (nth, (_, tokens)) in all().iter().enumerate().step_by(every) {
        let Some((files, _)) = texts(tokens) else { continue };
        // The run-time is the same text for all of them.
        for file in &files[..if paths.is_empty() { 2 } else { 1 }] {
            paths.push(place.join(format!("{nth}_{}", file.name)));
            fs::write(paths.last().expect("one was put"), &file.text).expect("it can be written");
        }
    }
    paths
}

fn accepted(command: &mut Command, files: &[PathBuf]) {
    let output = command.args(files).output().expect("it starts");
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{told}{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(told.lines().count(), files.len(), "a line a file: {told}");
}

/// Python prints the kinds of what it reads, a line a file.
const BLARK: &str = "\
import sys
from blark.parse import parse_source_code
for path in sys.argv[1:]:
    parsed = parse_source_code(open(path).read())
    if parsed.exception: sys.exit(f'{path}: {parsed.exception}')
    print(len(parsed.transform().items))
";

#[test]
fn blark_accepts_what_is_printed() {
    let python = env::var("LINKAGE_PYTHON").unwrap_or_else(|_| "python3".to_string());
    let has_it = Command::new(&python).args(["-c", "import blark"]).output();
    if !has_it.is_ok_and(|output| output.status.success()) {
        return skipped("structured text read by others: no blark");
    }
    // It takes a minute for one of 100 kB.
    let every = if env::var_os("LINKAGE_WHOLE").is_some() { 61 } else { 197 };
    accepted(Command::new(python).args(["-c", BLARK]), &written("blark", every));
}

#[test]
fn the_crate_iec61131_accepts_what_is_printed() {
    let Some(program) = env::var_os("LINKAGE_IEC61131") else {
        return skipped("structured text read by others: no iec61131");
    };
    accepted(&mut Command::new(program), &written("iec61131", 1));
}
