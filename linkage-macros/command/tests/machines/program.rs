//! Runs the program on fixtures.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/machines");

/// The folders of fixtures.
pub(crate) const FORMATS: [&str; 3] = ["pmks", "pylinkage", "pyslvs"];

pub(crate) fn fixture(name: &str) -> PathBuf {
    Path::new(FOLDER).join(name)
}

/// The fixtures, by folder and name.
pub(crate) fn fixtures() -> Vec<String> {
    let mut names = Vec::new();
    for folder in FORMATS {
        let files = std::fs::read_dir(fixture(folder)).expect("the folder exists");
        names.extend(files.map(|file| {
            let name = file.expect("a file").file_name();
            format!("{folder}/{}", name.to_str().expect("a plain name"))
        }));
    }
    names.sort();
    names
}

/// The drives that the first line of a pyslvs fixture asks for: its format has none.
pub(crate) fn drives_of(text: &str) -> Vec<&str> {
    let first = text.lines().next().unwrap_or_default();
    first.strip_prefix("# ").map(|drives| drives.split(' ').collect()).unwrap_or_default()
}

/// The declaration that the program prints of a file, or the mistake that it reports.
pub(crate) fn run(file: &Path, more: &[&str]) -> Result<String, String> {
    let text = std::fs::read_to_string(file).expect("the fixture exists");
    given(&text, &[&drives_of(&text), more].concat())
}

/// The same of a text.
pub(crate) fn given(text: &str, arguments: &[&str]) -> Result<String, String> {
    match given_or_ended(text, arguments) {
        (Some(0), printed, _) => Ok(printed),
        (_, _, told) => Err(told),
    }
}

/// The code that the program ends with, what it prints and what it says of a text.
pub(crate) fn given_or_ended(text: &str, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut program = Command::new(env!("CARGO_BIN_EXE_linkage"));
    program.args(["import", "-"]).args(arguments);
    program.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut running = program.spawn().expect("the program starts");
    // A program that refuses its arguments ends without reading.
    let _ = running.stdin.take().expect("it reads").write_all(text.as_bytes());
    let output = running.wait_with_output().expect("the program ends");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("it is text");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// The declarations of a folder's fixtures, each named after its folder and its file.
pub(crate) fn declarations(folder: &str) -> String {
    let mut all = String::from(
        "//! Every fixture as the program prints it, word for word.\n\nuse linkage_core::mechanism;\n",
    );
    for name in fixtures().iter().filter(|name| name.starts_with(&format!("{folder}/"))) {
        let stem = name.rsplit_once('.').map_or(&name[..], |(stem, _)| stem);
        let printed = run(&fixture(name), &["--name", stem]);
        let printed = printed.unwrap_or_else(|told| panic!("{name}: {told}"));
        all.push_str(&format!("\n// {name}\n{printed}"));
    }
    all
}
