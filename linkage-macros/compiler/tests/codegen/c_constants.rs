//! The constants and the flags of the run-time in C.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::path::Path;
use std::process::Command;

use super::skipped::skipped;
use crate::codegen::c::run_time;

/// The header refuses flags that break rounding.
#[test]
fn flags_that_break_rounding_are_refused() {
    let folder = std::env::temp_dir().join(format!("linkage_c_{}_flags", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder can be made");
    std::fs::write(folder.join("linkage_run.h"), run_time::header()).expect("it can be written");
    for (flags, is_refused) in [
        (&["-O2"][..], false),
        (&["-ffast-math"], true),
        (&["-O2", "-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"], true),
        (&["-ffinite-math-only"], true),
        (&["-mfpmath=387"], cfg!(target_arch = "x86_64")),
    ] {
        if flags[0] == "-mfpmath=387" && !cfg!(target_arch = "x86_64") {
            continue;
        }
        let command = Command::new("cc")
            .args(["-std=c99", "-fsyntax-only", "linkage_run.h"])
            .args(flags)
            .current_dir(&folder)
            .output();
        let Ok(output) = command else { return skipped("flags of the header in C: no cc") };
        assert_eq!(!output.status.success(), is_refused, "{flags:?}");
    }
}

/// The numbers of six digits or more in a text, in double precision or in single.
fn numbers(text: &str, is_single: bool) -> BTreeSet<u64> {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    let code: Vec<&str> = code.collect();
    let code = code.join("\n").replace('_', "");
    let mut found = BTreeSet::new();
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '.';
    let mut rest = &code[..];
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let before = rest[..start].chars().next_back();
        rest = &rest[start..];
        let mut end = rest.find(|c: char| !is_part(c)).unwrap_or(rest.len());
        if rest[..end].ends_with('e') && rest[end..].starts_with(['-', '+']) {
            end += 1 + rest[end + 1..].find(|c: char| !is_part(c)).unwrap_or(rest.len() - end - 1);
        }
        let (word, after) = rest.split_at(end);
        rest = after;
        let word = word.trim_end_matches('f');
        let digits = word.split('e').next().unwrap_or_default();
        let count = digits.chars().filter(char::is_ascii_digit).count();
        let is_name = before.is_some_and(char::is_alphabetic);
        if !is_name && digits.contains('.') && count >= 6 {
            found.extend(match is_single {
                false => word.parse::<f64>().map(f64::to_bits).ok(),
                true => word.parse::<f32>().map(|x| u64::from(x.to_bits())).ok(),
            });
        }
    }
    found
}

/// The kernels' constants are written in both languages.
#[test]
fn constants_are_those_of_the_run_time_crate() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../linkage-core/src/kernels");
    let read = |file: &str| std::fs::read_to_string(root.join(file)).expect("the file can be read");
    let arcs = read("arc.rs");
    let (wide, narrow) = arcs.split_once("narrow, f32").expect("both widths stand there");
    let (header, splitters) = (run_time::header(), read("arithmetic.rs"));
    let (split, splits) = splitters.split_once("impl Arithmetic for f32").expect("both widths");
    let singles: Vec<&str> = header.split("/* In single precision. */").collect();
    let [doubles, singles] = singles[..] else { panic!("there are two widths") };
    for (is_single, rust, c) in [
        (false, [wide, split, &read("sin_cos_f64.rs")].join("\n"), doubles),
        (true, [narrow, splits, &read("sin_cos_f32.rs")].join("\n"), singles),
    ] {
        // `FRAC_PI_2` and its kin have their digits in Rust's library.
        let [half, quarter, quadrants] =
            [FRAC_PI_2, FRAC_PI_4, 2.0 / PI].map(|x| match is_single {
                false => x.to_bits(),
                true => u64::from((x as f32).to_bits()),
            });
        let mut rust = numbers(&rust, is_single);
        rust.extend([half, quarter, quadrants]);
        assert_eq!(numbers(c, is_single), rust);
        assert!(rust.len() > 20);
    }
}
