//! Takes the declarations out of the examples, so that the gallery shows what they declare.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Examples that have folders of their own: their files with declarations.
const FOLDERS: [&str; 3] =
    ["electronic_cam/cam.rs", "calibration/src/machine.rs", "function_generator/src/generator.rs"];

fn main() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    println!("cargo::rerun-if-changed={}", examples.display());
    let entries = fs::read_dir(&examples).expect("the examples are there");
    let single = entries.map(|entry| entry.expect("the folder can be read").path());
    let single = single.filter(|path| path.extension().is_some_and(|end| end == "rs"));
    let files = single.chain(FOLDERS.map(|file| examples.join(file)));
    let mut files: Vec<PathBuf> = files.collect();
    files.sort();
    let (mut modules, mut names) = (String::new(), String::new());
    for file in files {
        let text = fs::read_to_string(&file).expect("the example can be read");
        let declarations = declarations(&text);
        if !declarations.is_empty() {
            let module = module(&examples, &file);
            writeln!(modules, "/// The example's.\npub mod {module} {{ use linkage_core::mechanism; {declarations} }}")
                .expect("a string takes everything");
            for name in structs(&declarations) {
                write!(names, "\"{module}::{name}\", ").expect("a string takes everything");
            }
        }
    }
    writeln!(modules, "/// All that can be drawn.\npub const NAMES: &[&str] = &[{names}];")
        .expect("a string takes everything");
    let out = env::var_os("OUT_DIR").expect("a build script has one");
    fs::write(Path::new(&out).join("declarations.rs"), modules).expect("it can be written");
}

/// The name of the example.
fn module(examples: &Path, file: &Path) -> String {
    let below = file.strip_prefix(examples).expect("the file is below");
    let first = below.components().next().expect("it has a name").as_os_str();
    first.to_string_lossy().trim_end_matches(".rs").to_string()
}

/// What is declared, but for mechanisms in which something is searched: those have no drawings.
fn structs(declarations: &str) -> impl Iterator<Item = &str> {
    let behind = declarations.split("pub struct ").skip(1);
    let behind =
        behind.filter(|behind| !behind.lines().any(|line| line.trim().starts_with("solve ")));
    behind.filter_map(|behind| behind.split(|c: char| !c.is_alphanumeric()).next())
}

/// Every block from a line `mechanism! {` to the next brace at the margin.
fn declarations(text: &str) -> String {
    let mut found = String::new();
    let mut is_inside = false;
    for line in text.lines() {
        is_inside |= line.starts_with("mechanism! {");
        if is_inside {
            let line = line.replace("pub(crate) struct", "pub struct");
            found.push_str(&line);
            found.push('\n');
        }
        is_inside &= line != "}";
    }
    found
}
