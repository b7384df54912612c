//! The four-bar in `examples/four_bar.rs`, as `linkage export rust` prints it, is a program, computes what the macro's
//! solver does, and stands in part in the documentation.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

const EXAMPLE: &str = "examples/four_bar.rs";

fn read(name: &str) -> String {
    fs::read_to_string(Path::new(ROOT).join(name)).expect("it can be read")
}

/// The expansion of the declaration, as the program prints it.
fn expansion() -> String {
    let mut linkage = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let output = linkage.args(["export", "rust", EXAMPLE]).current_dir(ROOT).output();
    let output = output.expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("it is text")
}

/// The declaration with the macro around it.
fn declaration() -> String {
    let source = read(EXAMPLE);
    let start = source.find("mechanism! {").expect("a declaration");
    let length = source[start..].find("\n}\n").expect("its end");
    source[start..start + length + 3].to_owned()
}

/// Both solvers compute the same in either width; the text of a number is that of no other.
const PROGRAM: &str = r#"
fn main() {
    let (declared, printed) = (declared::FourBar::new(), printed::FourBar::new());
    let (declared_f32, printed_f32) = (declared.lift::<f32>(), printed.lift::<f32>());
    for step in 0..1000 {
        let theta = f64::from(step) * 0.0123;
        let (a, b) = (declared.motion(theta, 7.0, -3.0), printed.motion(theta, 7.0, -3.0));
        assert!(a.is_ok(), "{a:?}");
        assert_eq!(format!("{a:?}"), format!("{b:?}"));
        let theta = theta as f32;
        let (a, b) = (declared_f32.motion(theta, 7.0, -3.0), printed_f32.motion(theta, 7.0, -3.0));
        assert!(a.is_ok(), "{a:?}");
        assert_eq!(format!("{a:?}"), format!("{b:?}"));
    }
    println!("equal to the last bit");
}
"#;

/// The libraries `linkage-core` beside this program, the newest first: they differ by their features.
fn libraries() -> Vec<PathBuf> {
    let program = std::env::current_exe().expect("this program is a file");
    let entries = fs::read_dir(program.parent().expect("a folder")).expect("it can be read");
    let libraries = entries.map(|entry| entry.expect("it can be read").path()).filter(|path| {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        name.starts_with("liblinkage_core-") && name.ends_with(".rlib")
    });
    let mut libraries: Vec<_> = libraries.collect();
    libraries.sort_by_key(|path| fs::metadata(path).and_then(|file| file.modified()).ok());
    libraries.reverse();
    libraries
}

#[test]
fn the_printed_solver_computes_what_the_macro_makes() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let (source, program) = (folder.join("four_bar_expanded.rs"), folder.join("four_bar_expanded"));
    let (declared, printed) = (declaration(), expansion());
    let text = format!(
        "mod declared {{ use linkage_core::mechanism; {declared} }}\nmod printed {{\n{printed}}}\n{PROGRAM}"
    );
    fs::write(&source, text).expect("it can be written");
    let mut said = String::from("Cargo has built no library");
    for library in libraries() {
        let output = Command::new(Path::new(env!("CARGO")).with_file_name("rustc"))
            .args(["--edition=2024", "-Adead_code", "-Aunused_imports", "-Dwarnings", "-o"])
            .args([&program, &source])
            .arg("-L")
            .arg(library.parent().expect("the library is in a folder"))
            .arg("--extern")
            .arg(format!("linkage_core={}", library.display()))
            .output()
            .expect("the compiler starts");
        if output.status.success() {
            let output = Command::new(&program).output().expect("the program starts");
            assert_eq!(String::from_utf8_lossy(&output.stderr), "");
            assert_eq!(String::from_utf8_lossy(&output.stdout), "equal to the last bit\n");
            return;
        }
        said = String::from_utf8_lossy(&output.stderr).into_owned();
    }
    panic!("{said}");
}

/// The formulas of a position, without the indentation of the whole.
fn formulas(expansion: &str) -> String {
    let (_, rest) = expansion.split_once("fn formulas_at_<").expect("the formulas");
    let (constants, rest) = rest.split_once("if ORDER == 3 {").expect("clearances come first");
    let (_, shared) = constants.split_once("let acceleration_").expect("the constants' end");
    let (_, shared) = shared.split_once(";\n").expect("its own");
    let (_, rest) = rest.split_once("}\n").expect("their end");
    let (formulas, _) = rest.split_once("if ORDER == 0 {").expect("the position alone");
    let indent = formulas.find("let").expect("a statement");
    let lines = shared.trim_end().lines().chain(formulas.trim_end().lines());
    let lines = lines.map(|line| &line[indent..]);
    lines.map(|line| format!("{line}\n")).collect()
}

#[test]
fn the_documentation_shows_the_formulas() {
    const PAGE: &str = "linkage-core/docs/method_and_measurements.md";
    let page = read(PAGE);
    let heading = page.find("\n## The code\n").expect("the page shows code");
    let start = heading + page[heading..].find("```text\n").expect("behind its heading");
    let (before, rest) = (&page[..start], &page[start + "```text\n".len()..]);
    let (shown, after) = rest.split_once("```\n").expect("its end");
    let made = formulas(&expansion());
    if std::env::var_os("LINKAGE_RENEW").is_some() {
        let page = format!("{before}```text\n{made}```\n{after}");
        return fs::write(Path::new(ROOT).join(PAGE), page).expect("it can be written");
    }
    assert_eq!(made, shown, "LINKAGE_RENEW=1 cargo test -p linkage-command --test expanded");
}
