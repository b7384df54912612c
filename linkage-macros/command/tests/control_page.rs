//! The first page that a user of C reads, followed step by step: what it says is typed, and what it shows comes out.

#[path = "../../../tests/skipped.rs"]
mod skipped;

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
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

/// A folder of a test's own.
fn empty_folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

/// The output of a command that says nothing else.
fn typed(line: &str, folder: &Path) -> String {
    let own = Path::new(env!("CARGO_BIN_EXE_linkage")).parent().expect("it lies in a folder");
    let others = env::var_os("PATH").unwrap_or_default();
    let all = std::iter::once(own.to_path_buf()).chain(env::split_paths(&others));
    let path = env::join_paths(all).expect("a folder's name has no colon");
    let output =
        Command::new("sh").args(["-c", line]).env("PATH", &path).current_dir(folder).output();
    let output = output.expect("there is a shell");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && errors.is_empty(), "{line}: {errors}");
    String::from_utf8(output.stdout).expect("it is text")
}

/// Types the lines of a session and compares what each prints, unless it shows `…`; gives their number. The program that
/// a page installs is the one that is tested.
fn followed(session: &str, folder: &Path) -> usize {
    let steps = session.split("$ ").skip(1).filter(|step| !step.starts_with("cargo install "));
    let mut count = 0;
    for step in steps {
        let (line, shown) = step.split_once('\n').expect("a line is typed");
        let printed = typed(line, folder);
        assert!(shown == "…\n" || printed == shown, "{line}\n{printed}");
        count += 1;
    }
    count
}

/// The line that README's C prints is the one that its comment shows, and the comment of its Rust; its proved error is
/// the one that is reported.
#[test]
fn the_readme_shows_what_comes_out() {
    if Command::new("cc").arg("--version").output().is_err() {
        return skipped::skipped("the README's C: no cc");
    }
    let readme = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../README.md"))
        .expect("it is there");
    let blocks = blocks(&readme);
    let of = |language: &str| {
        &blocks.iter().find(|(found, _)| *found == language).expect("there is one").1
    };
    let (in_c, in_rust) = (of("c"), of("rust,ignore"));
    let (_, shown) = in_c.split_once("/* ").expect("a comment shows what comes out");
    let shown = shown.split(" */").next().expect("a comment ends");
    assert!(in_rust.trim_end().ends_with(&format!("// {shown}")), "{in_rust}");
    let folder = empty_folder("readme");
    fs::write(folder.join("shear.rs"), of("text")).expect("a file can be written");
    let program = format!(
        "#include <stdio.h>\n#include \"shear.h\"\nint main(void)\n{{\n{in_c}return 0;\n}}\n"
    );
    fs::write(folder.join("main.c"), program).expect("a file can be written");
    typed("linkage export c shear.rs -o control", &folder);
    typed("cc -std=c99 -O2 -Icontrol main.c control/*.c -lm -o shear", &folder);
    assert_eq!(typed("./shear", &folder).trim_end(), shown);
    let proved =
        readme.lines().find(|line| line.contains("proved, `f32` |")).expect("a row of the table");
    let bound = proved.split(" | ").nth(1).expect("a number").trim();
    let report = typed("linkage report shear.rs", &folder);
    assert!(
        report.lines().any(|line| line.contains("position.blade.x") && line.contains(bound)),
        "{bound}\n{report}"
    );
    typed("linkage report shear.rs --within 1um --width f32", &folder);
}

/// The first hour in C: the printed controller, a machine of the reader's own, and its proof.
#[cfg(unix)]
#[test]
fn the_start_in_c_can_be_followed() {
    if Command::new("cc").arg("--version").output().is_err() {
        return skipped::skipped("the start in C: no cc");
    }
    let root =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("it is there");
    let page = fs::read_to_string(root.join("linkage-core/docs/start_in_c.md"))
        .expect("the page is there");
    let folder = empty_folder("start_in_c");
    std::os::unix::fs::symlink(&root, folder.join("linkage")).expect("a link can be made");
    let mut steps = 0;
    for (language, block) in blocks(&page) {
        match language {
            "text" if block.starts_with("mechanism!") => {
                fs::write(folder.join("press.rs"), block).unwrap()
            }
            "c" => fs::write(folder.join("main.c"), block).unwrap(),
            "console" => steps += followed(&block, &folder),
            _ => {}
        }
    }
    assert_eq!(steps, 8, "{page}");
}

#[test]
fn the_page_for_c_can_be_followed() {
    if Command::new("cc").arg("--version").output().is_err() {
        return skipped::skipped("the page for C: no cc");
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../linkage-core/docs/controllers.md");
    let page = fs::read_to_string(root).expect("the page is there");
    let [("text", declaration), ("console", session), ..] = &blocks(&page)[..] else {
        panic!("a declaration, and a session that is typed")
    };
    let folder = empty_folder("control_page");
    fs::write(folder.join("shear.rs"), declaration).expect("a file can be written");
    assert_eq!(followed(session, &folder), 3, "{session}");
    typed("cc -std=c99 -Wall -Werror -c control/*.c", &folder);
}
