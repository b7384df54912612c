//! A stranger with a real mouse and real keys, and one with keys alone: what is exported computes what the page shows.
//!
//! Needs `chromium`, `node`, and of npm `playwright-core` and `axe-core`: `npm install --prefix target/node playwright-core
//! axe-core`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use linkage_core::sketch::shortened;
use serde_json::json;

use super::{skipped, wasm};

/// The way, step by step; a failure is told.
const WAY: &str = include_str!("way.cjs");

/// Calls the printed solver at the angles that the page was asked for.
const CALLER: &str = r#"
#include "four_bar.h"
#include <stdio.h>
#include <stdlib.h>
int main(int count, char **angles) {
    FourBar machine = four_bar_default();
    for (int k = 1; k < count; k++) {
        FourBarPosition found;
        LinkageError error;
        if (four_bar_position(&machine, atof(angles[k]), &found, &error) != LINKAGE_OK) return 1;
        printf("%.17g %.17g\n", found.P.x, found.P.y);
    }
    return 0;
}
"#;

/// The folder of what npm has installed.
fn modules() -> Option<PathBuf> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/node/node_modules");
    // The variable names a folder, or says that node is required.
    let named = std::env::var_os("LINKAGE_NODE").map(PathBuf::from);
    let folder = named.filter(|folder| folder.is_dir()).unwrap_or(own);
    folder.join("axe-core").is_dir().then_some(folder)
}

#[test]
#[ignore = "needs chromium, node and playwright-core, and builds the compiler for a browser"]
fn a_stranger_with_mouse_or_keys_exports_what_the_page_shows() {
    let has = |program: &str| Command::new(program).arg("--version").output().is_ok();
    let Some(modules) = modules().filter(|_| has("node") && has("chromium")) else {
        return skipped::skipped(
            "the playground by mouse and keys: no chromium, node or playwright-core",
        );
    };
    let Some(page) = wasm::built() else { return };
    for kind in ["mouse", "keys"] {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("way_{kind}"));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder can be made");
        let machines = Path::new(env!("CARGO_MANIFEST_DIR")).join("../command/tests/machines");
        let foreign =
            ["pmks/four_bar.txt", "pmks/slider_crank.txt", "pylinkage/coupler_curve.json"];
        let foreign =
            foreign.map(|name| fs::read_to_string(machines.join(name)).expect("it is there"));
        fs::write(folder.join("foreign.json"), json!(foreign).to_string())
            .expect("it can be written");
        fs::write(folder.join("frame.js"), shortened(include_str!("frame.js")))
            .expect("it can be written");
        let way = folder.join("way.cjs");
        fs::write(&way, WAY).expect("it can be written");
        let mut node = Command::new("node");
        let node = node.env("NODE_PATH", &modules).arg(&way).arg(&page).arg(&folder).arg(kind);
        let output = node.output().expect("node runs");
        let said = String::from_utf8_lossy(&output.stdout);
        let beside = String::from_utf8_lossy(&output.stderr);
        assert_eq!(said.trim(), "all is well", "{kind}: {beside}");
        computes_what_is_shown(&folder);
    }
}

/// The exported sources compile without a warning, and compute the numbers of the page.
fn computes_what_is_shown(folder: &Path) {
    let all: Vec<String> =
        unzipped(&folder.join("all.zip"), folder).into_iter().map(|(name, _)| name).collect();
    for name in ["c/four_bar.c", "FourBar.rs", "FourBar.html", "FourBar.fmu"] {
        assert!(all.iter().any(|own| own == name), "{name} is not among {all:?}");
    }
    unzipped(&folder.join("c.zip"), folder);
    if Command::new("gcc").arg("--version").output().is_err() {
        return skipped::skipped("what the playground exports: no gcc");
    }
    fs::write(folder.join("caller.c"), CALLER).expect("it can be written");
    let numbers = fs::read_to_string(folder.join("numbers.json")).expect("it was written");
    let numbers: Vec<[f64; 3]> = serde_json::from_str(&numbers).expect("these are numbers");
    let sources = ["caller.c", "four_bar.c", "linkage_run.c"];
    let mut gcc = Command::new("gcc");
    let gcc = gcc.args(["-std=c99", "-O2", "-Wall", "-Wextra", "-Werror"]).args(sources);
    let built = gcc.args(["-lm", "-o", "caller"]).current_dir(folder).status();
    assert!(built.expect("gcc runs").success());
    let angles = numbers.iter().map(|[theta, ..]| theta.to_string());
    let output = Command::new(folder.join("caller")).args(angles).output().expect("it runs");
    let told = String::from_utf8_lossy(&output.stdout);
    let found = told.split_whitespace().map(|number| number.parse().expect("a number"));
    let found: Vec<f64> = found.collect();
    assert_eq!(found.len(), 2 * numbers.len(), "{told}");
    // Both print the same formulas; a script has no fused operations, so that the last places may differ.
    for (found, [theta, x, y]) in found.chunks(2).zip(&numbers) {
        let off = (found[0] - x).abs().max((found[1] - y).abs());
        assert!(off < 1e-14, "{found:?} for {x} {y} at {theta}");
    }
}

/// The files of an archive whose entries are stored as they are, written into a folder.
fn unzipped(archive: &Path, folder: &Path) -> Vec<(String, Vec<u8>)> {
    let bytes = fs::read(archive).expect("it was saved");
    let number = |at: usize, count: usize| {
        bytes[at..at + count].iter().rev().fold(0, |all, &byte| all << 8 | usize::from(byte))
    };
    let (mut at, mut files) = (0, Vec::new());
    while number(at, 4) == 0x0403_4b50 {
        assert_eq!(number(at + 8, 2), 0, "the entry is stored");
        let (size, name, extra) = (number(at + 18, 4), number(at + 26, 2), number(at + 28, 2));
        let begins = at + 30 + name + extra;
        let name = String::from_utf8_lossy(&bytes[at + 30..at + 30 + name]).into_owned();
        let content = bytes[begins..begins + size].to_vec();
        if !name.contains('/') {
            fs::write(folder.join(&name), &content).expect("it can be written");
        }
        files.push((name, content));
        at = begins + size;
    }
    assert!(!files.is_empty(), "{archive:?} holds nothing");
    files
}
