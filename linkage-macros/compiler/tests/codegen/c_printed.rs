//! Every declaration of the workspace as C99: compilers accept it without a warning.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use super::skipped::skipped;
use crate::expansions::declarations;
use crate::pipeline;

pub(super) const STRICT: [&str; 8] = [
    "-std=c99",
    "-pedantic",
    "-Wall",
    "-Wextra",
    "-Wshadow",
    "-Wconversion",
    "-Werror",
    "-fsyntax-only",
];

/// A compiler and what it is told beside.
type Told = (&'static str, &'static [&'static str]);

/// Compilers that take every declaration, each with the one that stands in for it where it is not installed.
/// One width alone is what a target of that compiler has.
const COMPILERS: [[Told; 2]; 4] = [
    [("cc", &[]), ("clang", &[])],
    [("g++", &["-x", "c++", "-std=c++17"]), ("clang++", &["-x", "c++", "-std=c++17"])],
    [("clang", &["-DLINKAGE_NO_SINGLE"]), ("cc", &["-DLINKAGE_NO_SINGLE"])],
    [("arm-none-eabi-gcc", CORTEX_M4), ("cc", &["-DLINKAGE_NO_DOUBLE"])],
];

pub(super) const CORTEX_M4: &[&str] =
    &["-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard", "-DLINKAGE_NO_DOUBLE"];

/// What is said of a number that is too short.
const SHORT: &str = "double has fewer than 64 bits here";

/// The files of every so many declarations in a folder each, and the names of the sources.
pub(super) fn print_every(nth: usize, root: &Path) -> Vec<String> {
    let mut sources = Vec::new();
    let mut refused = BTreeMap::new();
    for (nth, declaration) in declarations::all().enumerate().step_by(nth) {
        let files = match pipeline::c(declaration.tokens.clone(), &[], None) {
            Ok(files) => files,
            Err(mistakes) => {
                refused.insert(declaration.name.clone(), mistakes[0].message.clone());
                continue;
            }
        };
        let folder = root.join(nth.to_string());
        std::fs::create_dir_all(&folder).expect("a folder can be made");
        for file in &files {
            std::fs::write(folder.join(&file.name), &file.text).expect("it can be written");
        }
        assert!(!files[1].text.contains("--"), "{}: a decrement", declaration.name);
        assert_eq!(set_aside_and_read(&files[1].text), [""; 0], "{}", declaration.name);
        sources.push(format!("{nth}/{}", files[1].name));
        // Parts of the run-time are the same text wherever they are printed.
        for part in &files[4..] {
            let is_run_time = part.name.starts_with("linkage_");
            let path = if is_run_time { part.name.clone() } else { format!("{nth}/{}", part.name) };
            if is_run_time && root.join(&path).exists() {
                continue;
            }
            std::fs::write(root.join(&path), &part.text).expect("it can be written");
            std::fs::write(root.join("linkage_run.h"), &files[2].text).expect("it can be written");
            sources.extend(path.ends_with(".c").then_some(path));
        }
    }
    assert!(refused.is_empty(), "{refused:?}");
    sources
}

/// Arguments of a machine that a function sets aside by `(void)`, though its body reads them. The residual of a
/// search sets its own two aside in any case.
fn set_aside_and_read(source: &str) -> Vec<&str> {
    source.split("\n}\n").flat_map(of_body).collect()
}

fn of_body(function: &str) -> impl Iterator<Item = &str> {
    let is_of_a_name = |letter: char| letter.is_alphanumeric() || letter == '_';
    let lines = function.lines();
    let names = lines.filter_map(|line| line.trim().strip_prefix("(void)")?.strip_suffix(';'));
    names.filter(|name| !["given", "trial_"].contains(name)).filter(move |name| {
        // Names of links stand in texts, too.
        let code = function.split('"').step_by(2);
        let words = code.flat_map(|code| code.split(|letter| !is_of_a_name(letter)));
        // Its declaration is one, and what sets it aside another.
        words.filter(|word| word == name).count() > 2
    })
}

/// As C and as C++; `.ci/nightly` asks the other compilers, about every declaration.
#[test]
fn some_declarations_are_c_and_cpp() {
    compilers_take(80, &COMPILERS[..2]);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn every_declaration_is_c_and_cpp() {
    assert!(compilers_take(1, &COMPILERS) > 250);
}

/// The count of declarations.
fn compilers_take(nth: usize, compilers: &[[Told; 2]]) -> usize {
    let root = std::env::temp_dir().join(format!("linkage_c_{}_{nth}", std::process::id()));
    let sources = print_every(nth, &root);
    for told in compilers {
        let answers = told.iter().find_map(|(compiler, flags)| {
            let mut all = [&STRICT[..], flags].concat();
            all.retain(|flag| !flags.contains(&"-std=c++17") || *flag != "-std=c99");
            compiled(compiler, &all, &sources, &root)
        });
        for errors in answers.into_iter().flatten() {
            assert!(errors.is_empty(), "{told:?}: {errors}");
        }
    }
    // Decisions at a limit need 53 bits: a compiler whose `double` has fewer is told so, once a source.
    let short = ["-std=c99", "-fsyntax-only", "-Wfatal-errors"];
    let told = compiled("avr-gcc", &short, &sources, &root).unwrap_or_default();
    let count: usize = told.iter().map(|errors| errors.matches(SHORT).count() / 2).sum();
    assert!(told.is_empty() || count == sources.len(), "{told:?}");
    // A folder that failed is kept, to be looked at.
    std::fs::remove_dir_all(&root).expect("the folder was made here");
    sources.len()
}

/// The messages of a compiler about the sources, some at a time; none where it is not installed.
pub(super) fn compiled(
    compiler: &str,
    flags: &[&str],
    sources: &[String],
    root: &Path,
) -> Option<Vec<String>> {
    let told = |sources: &[String]| {
        let output = Command::new(compiler).args(flags).args(sources).current_dir(root).output();
        output.ok().map(|output| String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let told: Option<Vec<_>> = std::thread::scope(|scope| {
        let parts: Vec<_> =
            sources.chunks(60).map(|part| scope.spawn(move || told(part))).collect();
        parts.into_iter().map(|part| part.join().expect("it only starts a program")).collect()
    });
    if told.is_none() {
        skipped(&format!("declarations in C: no {compiler}"));
    }
    told
}

/// Whatever the inputs and loads of a mechanism are, its model is C. `.ci/nightly` takes more of them.
#[test]
fn some_models_are_c() {
    models_are_c(45);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn many_models_are_c() {
    models_are_c(9);
}

fn models_are_c(every: usize) {
    let root = std::env::temp_dir().join(format!("linkage_c_{}_fmu_{every}", std::process::id()));
    for (nth, declaration) in declarations::all().step_by(every).enumerate() {
        let Ok(files) = pipeline::fmu(declaration.tokens, nth % 4 == 0) else { continue };
        let folder = root.join(nth.to_string());
        std::fs::create_dir_all(folder.join("sources")).expect("a folder can be made");
        for file in &files {
            std::fs::write(folder.join(&file.name), &file.text).expect("it can be written");
        }
        let command =
            Command::new("cc").args(STRICT).arg("sources/fmi3.c").current_dir(&folder).output();
        let Ok(output) = command else { return skipped("models in C: no cc") };
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {errors}", declaration.name);
    }
    std::fs::remove_dir_all(&root).expect("the folder was made here");
}
