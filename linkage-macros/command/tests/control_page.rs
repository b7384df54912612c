//! The first page that a user of C reads, followed step by step: what it says is typed, and what it shows comes out.

#[path = "../../../tests/skipped.rs"]
mod skipped;

use std::env;
use std::fs;
use std::path::Path;
use std::process::Command;

/// The language and the text of each block of code.
fn blocks(page: &str) -> Vec<(&str, String)> {
    let mut found = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        let Some(language) = line.strip_prefix("```") else { continue };
        let block: Vec<&str> = lines.by_ref().take_while(|line| *line != "```").collect();
        found.push((language, block.join("\n") + "\n"));
    }
    found
}

#[test]
fn the_page_for_c_can_be_followed() {
    if Command::new("cc").arg("--version").output().is_err() {
        return skipped::skipped("the page for C: no cc");
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../linkage-core/docs/control.md");
    let page = fs::read_to_string(root).expect("the page is there");
    let [("text", declaration), ("c", program), ("text", session), ..] = &blocks(&page)[..] else {
        panic!("a declaration, a program, and what is typed")
    };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("control_page");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    fs::write(folder.join("shear.rs"), declaration).expect("a file can be written");
    fs::write(folder.join("main.c"), program).expect("a file can be written");
    let own = Path::new(env!("CARGO_BIN_EXE_linkage")).parent().expect("it lies in a folder");
    let others = env::var_os("PATH").unwrap_or_default();
    let all = std::iter::once(own.to_path_buf()).chain(env::split_paths(&others));
    let path = env::join_paths(all).expect("a folder's name has no colon");
    let steps: Vec<&str> = session.split("$ ").skip(1).collect();
    assert!(steps.len() > 3, "{session}");
    for step in steps {
        let (typed, shown) = step.split_once('\n').expect("a line is typed");
        let mut shell = Command::new("sh");
        let output = shell.args(["-c", typed]).env("PATH", &path).current_dir(&folder).output();
        let output = output.expect("there is a shell");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && errors.is_empty(), "{typed}: {errors}");
        assert_eq!(String::from_utf8_lossy(&output.stdout), shown, "{typed}");
    }
}
