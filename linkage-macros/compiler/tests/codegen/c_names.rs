//! Names that C, a compiler or a header has for itself, wherever a declaration may use them.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::c_printed::compiled;
use super::skipped::skipped;
use crate::codegen::c::c_identifiers::{Width, arguments, distinct};
use crate::codegen::c::run_time;
use crate::pipeline;
use proc_macro2::{Ident, Span, TokenStream};

/// Dialects, with what each is told beside.
const DIALECTS: [(&str, &[&str]); 5] = [
    ("cc", &["-std=c99", "-pedantic", "-Wshadow", "-Wconversion"]),
    ("cc", &["-std=gnu17"]),
    ("g++", &["-x", "c++", "-std=gnu++17"]),
    ("cc", &["-std=gnu2x", NUMBERED, DECIMAL]),
    ("g++", &["-x", "c++", "-std=gnu++20", NUMBERED]),
];
/// Types of numbers that C23 lets headers have.
const NUMBERED: &str = "-D__STDC_WANT_IEC_60559_TYPES_EXT__";
const DECIMAL: &str = "-D__STDC_WANT_DEC_FP__";
/// The dialects of a sample.
const FIRST: usize = 3;

/// Macros, keywords, types and functions: of C and C++, of the headers, of compilers and of what is printed.
const NAMES: &[&str] = &[
    "NAN",
    "NULL",
    "INFINITY",
    "HUGE_VAL",
    "isnan",
    "signbit",
    "M_PI",
    "FP_NAN",
    "DEC128_MIN",
    "FLT32X_MAX",
    "DBL_MAX",
    "INT8_MAX",
    "SIZE_MAX",
    "EOF",
    "errno",
    "I",
    "linux",
    "unix",
    "far",
    "min",
    "max",
    "small",
    "interface",
    "IN",
    "OUT",
    "register",
    "delete",
    "operator",
    "and",
    "wchar_t",
    "bool",
    "char8_t",
    "nullptr",
    "int",
    "double",
    "asm",
    "sin",
    "fabs",
    "size_t",
    "int32_t",
    "signgam",
    "index",
    "timespec",
    "memcpy",
    "LinkagePoint",
    "LinkagePointF32",
    "LinkageDirection",
    "LinkageStatus",
    "LinkageWhy",
    "LINKAGE_OK",
    "LINKAGE_JAMS",
    "LINKAGE_NOT_CERTIFIED",
    "LINKAGE_OTHER_ASSEMBLY",
    "LINKAGE_COLD",
    "Linkage",
    "LinkageRun",
    "LinkageRoot",
    "Math",
    "StdInt",
    "Fmi3",
    "Fmi3Model",
    "Instance",
    "STATES",
    "GROUPS",
    "TOKEN",
    "KIND",
    "VR",
    "step",
    "evaluate_0",
    "linkage_refused",
    "linkage_sin_cos",
    "mechanism",
    "error",
    "result",
    "ok",
    "cosine",
    "sine",
    "self_",
    "to",
    "why",
    "q",
    "loads",
    "drives",
    "status",
    "_Bool",
    "__linux__",
    "_B",
    "θ",
    "u03b8",
    "main",
];

/// A crank with one input and load: the names of its struct, point, link, parameter, input and load.
fn crank([solver, point, link, param, input, load]: [&str; 6]) -> String {
    format!(
        "pub struct {solver} {{ input {input}: angle; load {load}: force; param {param} = 2kg;
         ground A_(0, 0); crank {link}(A_) -> {point} {{ length: 1m, angle: {input} }}
         mass {param} on {point}; force ({load}, 0) on {point};
         output {point}, {link}, {input}.drive, {link}.A_; }}"
    )
}

/// Two of them, with a mode.
fn cranks([solver, point, link, mode, input, load]: [&str; 6]) -> String {
    format!(
        "pub struct {solver} {{ input {input}: angle; input s_: angle; load {load}: force; load m_: torque;
         param {mode}: mode = left; ground A_(0, 0), D_(1m, 0);
         crank AB_(A_) -> B_ {{ length: 300mm, angle: {input} }}
         crank DE_(D_) -> E_ {{ length: 300mm, angle: s_ }}
         rrr {link}(B_), EC_(E_) -> {point} {{ lengths: (700mm, 600mm), mode: {mode} }}
         force ({load}, 0) on {point}; torque m_ on AB_;
         output {point}, {link}, {input}.drive, {link}.B_; }}"
    )
}

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("linkage_c_{}_{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

/// The sources of a model, which hold those of its solver, in a folder of this number.
fn print_model(source: &str, nth: usize, root: &Path) -> Vec<String> {
    let tokens: TokenStream = source.parse().expect("these are tokens");
    let files = pipeline::fmu(tokens, false);
    let files = files.unwrap_or_else(|mistakes| panic!("{source}: {}", mistakes[0].message));
    let own = files.iter().filter_map(|file| {
        let name = file.name.strip_prefix("sources/")?;
        std::fs::create_dir_all(root.join(nth.to_string())).expect("a folder can be made");
        let path = format!("{nth}/{name}");
        std::fs::write(root.join(&path), &file.text).expect("it can be written");
        (name.ends_with(".c") && name != "linkage_run.c").then_some(path)
    });
    own.collect()
}

/// A compiler's flags in a dialect.
fn flags(own: &[&'static str]) -> Vec<&'static str> {
    [&["-Wall", "-Wextra", "-Werror", "-fsyntax-only"], own].concat()
}

/// A sample of the places; `.ci/nightly` takes all.
#[test]
fn some_names_are_c() {
    names_are_c(30);
}

#[test]
#[ignore = "half a minute: `.ci/nightly` takes it"]
fn every_name_is_c() {
    names_are_c(1);
}

fn names_are_c(every: usize) {
    let (folder, count) = (folder(&format!("names_{every}")), NAMES.len());
    let mut sources = Vec::new();
    for nth in (0..count).step_by(every) {
        // All of them together bring every name to every place.
        let names = [0, 7, 14, 21, 28, 35].map(|by| NAMES[(nth + by) % count]);
        sources.extend(print_model(&crank(names), nth, &folder));
        if nth % 5 == 0 {
            sources.extend(print_model(&cranks(names), nth + count, &folder));
        }
    }
    let dialects = if every == 1 { &DIALECTS[..] } else { &DIALECTS[..FIRST] };
    for &(compiler, own) in dialects {
        // The functions of FMI are C alone.
        let sources = sources.iter().filter(|file| compiler == "cc" || !file.ends_with("/fmi3.c"));
        let sources: Vec<String> = sources.cloned().collect();
        let told = compiled(compiler, &flags(own), &sources, &folder);
        let told = told.into_iter().flatten().collect::<String>();
        let errors: Vec<&str> = told.lines().filter(|line| line.contains("error")).collect();
        assert!(errors.is_empty(), "{compiler} {own:?}: {errors:#?}");
    }
    std::fs::remove_dir_all(&folder).expect("the folder was made here");
}

/// Words of a preprocessed text and names of macros: whatever may be taken.
fn candidates(told: (&str, &[&str]), folder: &Path) -> Option<BTreeSet<String>> {
    let text = |more: &[&str]| {
        let output = Command::new(told.0)
            .args(told.1)
            .args(more)
            .arg("headers.c")
            .current_dir(folder)
            .output();
        output.ok().map(|output| String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let mut found = BTreeSet::new();
    for text in [text(&["-E", "-P"])?, text(&["-E", "-dM"])?] {
        let words = text.split(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_');
        let names = words.filter(|word| word.starts_with(|first: char| !first.is_ascii_digit()));
        found.extend(names.filter(|name| *name != "_").map(str::to_string));
    }
    Some(found)
}

/// All that the installed headers and the run-time take: a type, a field and an argument of each name.
#[test]
fn names_are_clear_of_the_installed_headers() {
    let folder = folder("headers");
    let solver = Ident::new("Press", Span::call_site());
    let headers =
        ["float.h", "math.h", "stddef.h", "stdint.h", "string.h", "stdbool.h", "stdlib.h"];
    let headers: String = headers.map(|name| format!("#include <{name}>\n")).concat();
    std::fs::write(folder.join("run.h"), run_time::header()).expect("it can be written");
    std::fs::write(folder.join("headers.c"), format!("{headers}#include \"run.h\"\n"))
        .expect("it can be written");
    for dialect in DIALECTS {
        let Some(names) = candidates(dialect, &folder) else {
            return skipped(&format!("names in C: no {}", dialect.0));
        };
        assert!(names.len() > 700, "{}", names.len());
        let mut text = format!("{headers}#include \"run.h\"\n");
        let mut types = BTreeSet::new();
        for (nth, name) in names.iter().enumerate() {
            let ty = Width::Double.type_name(name);
            let [field] = &distinct(&solver, [name.clone()])[..] else { panic!("one is one") };
            let all =
                arguments(&solver, ["mechanism", "motion", "error"], [name.clone()].into_iter());
            if types.insert(ty.clone()) {
                text += &format!("typedef struct {ty} {{ double x; }} {ty};\n");
            }
            text += &format!(
                "struct field_{nth} {{ LinkagePoint {field}; int32_t own_; LinkagePoint at_; }};\n"
            );
            text += &format!("void take_{nth}(double {});\n", all[3]);
        }
        std::fs::write(folder.join("names.c"), text).expect("it can be written");
        let told = compiled(dialect.0, &flags(dialect.1), &["names.c".to_string()], &folder);
        let errors = told.into_iter().flatten().collect::<String>();
        let errors: Vec<&str> = errors.lines().filter(|line| line.contains("error")).collect();
        assert!(errors.is_empty(), "{dialect:?}: {} errors, {errors:#?}", errors.len());
    }
    std::fs::remove_dir_all(&folder).expect("the folder was made here");
}
