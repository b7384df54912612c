//! The run-time without hardware for `double` beside the one with it: the same refusals of the same groups, and answers
//! that differ by the last place at most.
//!
//! Every loop of either says how often it runs at most, and no call of the test makes it run longer.
//!
//! A program in C holds both, under two prefixes, and calls them with numbers some last places beside each limit, at
//! sizes from 1e-18 to 1e18. The build in double precision is the oracle; `c_run_time.rs` holds it to the run-time crate.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::c_printed::{CORTEX_M4, print_every};
use super::c_program::level;
use super::skipped::skipped;
use crate::cases::cases;
use crate::codegen::c::provenance::Prefix;
use crate::codegen::c::run_time;

/// Calls of all kinds, and of each the least count of answers and of refusals among the first 15 million.
const KINDS: [(&str, usize, usize); 15] = [
    ("circles", 400_000, 400_000),
    ("share", 900_000, 0),
    ("distances", 500_000, 300_000),
    ("centres", 200_000, 500_000),
    ("line", 500_000, 300_000),
    ("offset", 500_000, 300_000),
    ("moving", 500_000, 200_000),
    ("square", 400_000, 400_000),
    ("blamed", 200_000, 600_000),
    ("closed", 400_000, 400_000),
    ("angle", 900_000, 0),
    ("length", 900_000, 0),
    ("near", 900_000, 0),
    ("root", 100_000, 600_000),
    ("friction", 600_000, 100_000),
];

/// The parts of the run-time, and whether each is a source.
fn parts() -> [(&'static str, String, bool); 4] {
    [
        ("linkage_run.h", run_time::header(), false),
        ("linkage_run.c", run_time::source(), true),
        ("linkage_root.c", run_time::root_source(), true),
        ("linkage_friction.c", run_time::friction_source(), true),
    ]
}

/// The bound that a loop's line states; none where the line begins no loop.
fn bound(line: &str) -> Option<&str> {
    let code = line.trim_start();
    if !["for (", "while (", "do "].iter().any(|word| code.starts_with(word)) {
        return None;
    }
    let stated =
        line.split_once("{ /* at most ").and_then(|(_, rest)| rest.strip_suffix(" times */"));
    Some(stated.unwrap_or_else(|| panic!("a loop without its bound: {line}")))
}

/// A source whose loops end the program where they run longer than they say.
fn counted(source: &str) -> String {
    let mut text = String::with_capacity(source.len() * 2);
    for (nth, line) in source.lines().enumerate() {
        match bound(line) {
            Some(bound) => {
                let (head, _) = line.split_once("/*").expect("its bound stands there");
                text += &format!(
                    "loops_[{nth}] = 0;\n{head}\nran_(++loops_[{nth}], (long)({bound}), {nth});\n"
                );
            }
            None => text += &format!("{line}\n"),
        }
        if line == "#include \"linkage_run.h\"" {
            text += COUNTER;
        }
    }
    text
}

/// Counts of each loop's line, of the last run.
const COUNTER: &str = "#include <stdio.h>\n#include <stdlib.h>\nstatic long loops_[4000];\n\
    static void ran_(long count, long most, int line)\n{\n    if (count > most) {\n        \
    printf(\"the loop of line %d runs more than %ld times\\n\", line, most);\n        exit(2);\n    }\n}\n";

#[test]
fn every_loop_says_how_often_it_runs() {
    let loops: usize =
        parts().iter().map(|(_, text, _)| text.lines().filter_map(bound).count()).sum();
    assert!(loops > 120, "{loops}");
    for source in ["    for (;;) {", "    while (x) { /* a few times */"] {
        assert!(std::panic::catch_unwind(|| bound(source)).is_err(), "{source}");
    }
    // Printed functions of a mechanism have none.
    let text = "pub struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 1, angle: t } output B; }";
    let files = crate::pipeline::c(text.parse().expect("these are tokens"), &[], None);
    let source = &files.expect("there is no mistake")[1].text;
    assert_eq!(source.lines().filter_map(bound).count(), 0);
}

fn compiled(folder: &Path, flags: &[&str], arguments: &[&str]) -> bool {
    let warnings = ["-std=c99", level(), "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror"];
    let command = Command::new("cc")
        .args(warnings)
        .args(["-D_GNU_SOURCE"])
        .args(flags)
        .args(arguments)
        .current_dir(folder)
        .output();
    let Ok(output) = command else { return false };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    true
}

/// Both builds in one program, compiled with these flags; none without a compiler.
fn program(name: &str, flags: &[&str]) -> Option<PathBuf> {
    let folder = std::env::temp_dir().join(format!("linkage_builds_{}_{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder can be made");
    let callers = Path::new(env!("CARGO_MANIFEST_DIR")).join("codegen/c/builds");
    for file in ["one.h", "one.c", "wide.c", "single.c", "driver.c"] {
        std::fs::copy(callers.join(file), folder.join(file)).expect("a file can be written");
    }
    let single = Prefix::new("single").expect("it is one");
    let mut objects = Vec::new();
    for (prefix, own, caller) in [
        (Prefix::default(), &[][..], "wide.c"),
        (single, &["-DLINKAGE_NO_DOUBLE", "-Wdouble-promotion"][..], "single.c"),
    ] {
        let mut sources = vec![caller.to_string()];
        for (part, text, is_source) in parts() {
            let file = prefix.in_front_of(part);
            let text = if is_source { counted(&text) } else { text };
            std::fs::write(folder.join(&file), prefix.put_into(&text)).expect("it can be written");
            if is_source {
                sources.push(file);
            }
        }
        for source in sources {
            let object = source.replace(".c", ".o");
            let flags = [flags, if source == caller { &own[..own.len().min(1)] } else { own }];
            if !compiled(&folder, &flags.concat(), &["-c", &source, "-o", &object]) {
                skipped("both builds of the run-time in C: no cc");
                return None;
            }
            objects.push(object);
        }
    }
    let objects: Vec<&str> = objects.iter().map(String::as_str).collect();
    let linked = [&["driver.c"], &objects[..], &["-lm", "-o", "driver"]].concat();
    compiled(&folder, flags, &linked).then_some(folder)
}

/// Calls both so often.
fn builds_agree(name: &str, flags: &[&str], calls: usize) {
    let Some(folder) = program(name, flags) else { return };
    let output = Command::new(folder.join("driver")).arg(calls.to_string()).output();
    let output = output.expect("the program starts");
    let told = String::from_utf8_lossy(&output.stdout);
    println!("{told}");
    assert!(output.status.success(), "{told}");
    let lines: Vec<Vec<&str>> = told.lines().map(|line| line.split(' ').collect()).collect();
    assert_eq!(lines.len(), KINDS.len());
    for (line, (kind, answered, refused)) in lines.iter().zip(KINDS) {
        let count = |at: usize| line[at].parse::<usize>().expect("a count") * 15_000_000;
        assert_eq!(line[0], kind);
        assert!(count(1) >= answered * calls && count(3) >= refused * calls, "{line:?}");
        // Results of other bits are few: pairs round as double precision does but next to a tie.
        assert!(line[5].parse::<usize>().expect("a count") * 500 <= calls, "{line:?}");
    }
    std::fs::remove_dir_all(&folder).expect("the folder was made here");
}

/// A part of the calls that `.ci/nightly` makes.
#[test]
fn a_build_without_double_refuses_alike() {
    builds_agree("sample", &[], 150_000);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn a_build_without_double_refuses_alike_in_millions_of_calls() {
    builds_agree("all", &[], 15_000_000);
    if cfg!(target_arch = "x86_64") && std::is_x86_feature_detected!("fma") {
        builds_agree("fused", &["-march=x86-64-v3"], 3_000_000);
    }
}

/// Functions that a compiler calls where it has no instruction for numbers of 64 bits: of the ARM's interface, and of its own.
fn is_of_double(symbol: &str) -> bool {
    const ENDS: [&str; 7] = ["df2", "df3", "sidf", "didf", "sfdf2", "dfsi", "dfdi"];
    let own = symbol.strip_prefix("__aeabi_");
    own.is_some_and(|own| own.starts_with('d') || own.ends_with("2d") || own.starts_with("cd"))
        || (symbol.starts_with("__") && ENDS.iter().any(|end| symbol.ends_with(end)))
}

#[test]
fn names_of_software_double_are_known() {
    for name in ["__aeabi_dadd", "__aeabi_f2d", "__aeabi_cdcmple", "__adddf3", "__extendsfdf2"] {
        assert!(is_of_double(name), "{name}");
    }
    for name in ["__aeabi_fadd", "__aeabi_ul2f", "__aeabi_memcpy", "sqrtf", "__addsf3"] {
        assert!(!is_of_double(name), "{name}");
    }
}

/// The functions that objects of a Cortex-M4F ask for, of every so many declarations; none without its compiler.
fn asked_for(nth: usize) -> Option<Vec<String>> {
    let root = std::env::temp_dir().join(format!("linkage_c_{}_m4_{nth}", std::process::id()));
    let mut sources = print_every(nth, &root);
    let run = root.join("linkage_run.c");
    std::fs::write(run, run_time::source()).expect("it can be written");
    std::fs::write(root.join("linkage_run.h"), run_time::header()).expect("it can be written");
    sources.push("linkage_run.c".to_string());
    let mut symbols = Vec::new();
    for level in ["-O2", "-O0"].into_iter().take(cases(1, 2)) {
        for source in &sources {
            let arguments = [CORTEX_M4, &["-std=c99", level, "-c", source, "-o", "object.o"]];
            let compiler = Command::new("arm-none-eabi-gcc")
                .args(arguments.concat())
                .current_dir(&root)
                .output();
            let Ok(output) = compiler else {
                skipped("objects without software double: no arm-none-eabi-gcc");
                return None;
            };
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            let nm = Command::new("arm-none-eabi-nm")
                .args(["-u", "object.o"])
                .current_dir(&root)
                .output();
            let listed = nm.expect("it comes with the compiler");
            let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
            symbols.extend(listed.split_whitespace().map(str::to_string));
        }
    }
    std::fs::remove_dir_all(&root).expect("the folder was made here");
    symbols.sort();
    symbols.dedup();
    Some(symbols)
}

fn no_object_asks_for_software_double(nth: usize) {
    let Some(symbols) = asked_for(nth) else { return };
    let of_double: Vec<&String> = symbols.iter().filter(|symbol| is_of_double(symbol)).collect();
    assert!(of_double.is_empty(), "{of_double:?}");
    assert!(symbols.iter().any(|symbol| symbol == "sqrtf"), "{symbols:?}");
}

#[test]
fn some_objects_ask_for_no_software_double() {
    no_object_asks_for_software_double(240);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn no_object_of_any_declaration_asks_for_software_double() {
    no_object_asks_for_software_double(1);
}
