//! Takes the declarations out of the examples, so that the gallery shows what they declare.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

/// Examples that have folders of their own: their files with declarations, and what each is called.
const FOLDERS: [(&str, &str); 12] = [
    ("electronic_cam/cam.rs", "electronic_cam"),
    ("calibration/src/machine.rs", "calibration"),
    ("function_generator/src/generator.rs", "function_generator"),
    ("function_generator/src/bin/counterweight.rs", "counterweight"),
    ("dynamics/src/bin/andrews_squeezer/main.rs", "andrews_squeezer"),
    ("dynamics/src/bin/cart/main.rs", "cart"),
    ("dynamics/controller/lib.rs", "computed_torque"),
    ("dynamics/src/bin/crane.rs", "crane"),
    ("dynamics/src/bin/dead_point/main.rs", "dead_point"),
    ("dynamics/src/bin/parallelograms.rs", "parallelograms"),
    ("dynamics/src/bin/run_up.rs", "run_up"),
    ("dynamics/src/bin/vibration/main.rs", "vibration"),
];

fn main() {
    let examples = Path::new(&env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("..");
    println!("cargo::rerun-if-changed={}", examples.display());
    let entries = fs::read_dir(&examples).expect("the examples are there");
    let single = entries.map(|entry| entry.expect("the folder can be read").path());
    let single = single.filter(|path| path.extension().is_some_and(|end| end == "rs"));
    let single = single.map(|path| (stem(&path), path));
    let folders = FOLDERS.map(|(file, name)| (name.to_string(), examples.join(file)));
    let mut files: Vec<(String, PathBuf)> = single.chain(folders).collect();
    files.sort();
    let (mut modules, mut names, mut texts) = (String::new(), String::new(), String::new());
    for (module, file) in files {
        let text = fs::read_to_string(&file).expect("the example can be read");
        let declarations = declarations(&text);
        if !declarations.is_empty() {
            writeln!(modules, "/// The example's.\npub mod {module} {{ use linkage_core::mechanism; {declarations} }}")
                .expect("a string takes everything");
            for declaration in declarations.split_inclusive("\n}\n") {
                let Some(name) = structs(declaration).next() else { continue };
                write!(names, "\"{module}::{name}\", ").expect("a string takes everything");
                let (file, declaration) = (named(&examples, &file), declaration.trim());
                write!(texts, "({file:?}, {declaration:?}), ").expect("a string takes everything");
            }
        }
    }
    writeln!(modules, "/// All that can be drawn.\npub const NAMES: &[&str] = &[{names}];")
        .expect("a string takes everything");
    writeln!(modules, "/// Of each the example's file and its text.\npub const TEXTS: &[(&str, &str)] = &[{texts}];")
        .expect("a string takes everything");
    let out = env::var_os("OUT_DIR").expect("a build script has one");
    fs::write(Path::new(&out).join("declarations.rs"), modules).expect("it can be written");
}

/// The file as the root of the workspace sees it.
fn named(examples: &Path, file: &Path) -> String {
    let below = file.strip_prefix(examples).expect("it is one of them");
    format!("examples/{}", below.display())
}

/// The name of the example.
fn stem(file: &Path) -> String {
    file.file_stem().expect("it has a name").to_string_lossy().into_owned()
}

/// The names of the declared structs.
fn structs(declarations: &str) -> impl Iterator<Item = &str> {
    let behind = declarations.split("pub struct ").skip(1);
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
