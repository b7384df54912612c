//! Drawn parallelograms in printed C, in both widths: one behind a rocker, and two in a row.

use std::process::Command;

use super::c_program::level;
use super::skipped::skipped;
use crate::pipeline;

const WIPER: &str = "pub struct Chain { input theta: angle;
    ground A(0, 0), D(-250mm, 60mm), H(350mm, 60mm);
    pin B(45mm, 0), C(-245mm, -20mm), E(-320mm, 50mm), F(280mm, 50mm);
    link AB(A, B), rod(B, C), first(D, C, E), tie(E, F), second(H, F); drive AB.angle = theta; }";

/// Two parallelograms in a row: three wheels of a locomotive.
const RODS: &str = "pub struct Chain { input theta: angle;
    ground D(0, 0), H(1.4m, 0), L(2.9m, 10mm); pin E(0.2m, 0.2m), F(1.6m, 0.2m), G(3.1m, 0.21m);
    link first(D, E), second(H, F), third(L, G), rod(E, F), rear(F, G); drive first.angle = theta; }";

const CALLER: &str = r#"
#include <stdio.h>
#include "chain.h"
#define CALL(real, record, function) \
    for (k = -40; k <= 40; k++) { \
        record at; \
        LinkageError error; \
        if (function((real)0.157 * (real)k, &at, &error) != LINKAGE_OK) return 1; \
        printf("%.17g %.17g %.17g %.17g\n", (double)at.E.x, (double)at.E.y, (double)at.F.x, (double)at.F.y); \
    }
int main(void)
{
    int k;
    CALL(double, ChainPosition, chain_position)
    CALL(float, ChainPositionF32, chain_position_f32)
    return 0;
}
"#;

/// The lines that a caller in C prints of a printed solver; none without a compiler.
pub(super) fn printed(name: &str, source: &str, caller: &str) -> Option<String> {
    let folder = std::env::temp_dir().join(format!("linkage_{}_{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder can be made");
    let files =
        pipeline::c(source.parse().expect("tokens"), &[], None).expect("there is no mistake");
    for file in &files {
        std::fs::write(folder.join(&file.name), &file.text).expect("it can be written");
    }
    std::fs::write(folder.join("caller.c"), caller).expect("it can be written");
    let sources = files.iter().map(|file| &file.name[..]).filter(|name| name.ends_with(".c"));
    let compiled = Command::new("cc")
        .args(["-std=c99", level(), "-Wall", "-Werror", "-o", "caller", "caller.c"])
        .args(sources)
        .arg("-lm")
        .current_dir(&folder)
        .output();
    let Ok(compiled) = compiled else {
        skipped("a drawn machine in C: no cc");
        return None;
    };
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let output = Command::new(folder.join("caller")).output().expect("the program starts");
    assert!(output.status.success());
    let _ = std::fs::remove_dir_all(&folder);
    Some(String::from_utf8(output.stdout).expect("text"))
}

/// E and F at 81 angles, in f64 and then in f32; none without a compiler.
fn answers(source: &str) -> Option<Vec<[f64; 4]>> {
    let text = printed("chain", source, CALLER)?;
    let numbers = |line: &str| {
        let mut numbers = line.split(' ').map(|number| number.parse().expect("a number"));
        [(); 4].map(|()| numbers.next().expect("four numbers"))
    };
    Some(text.lines().map(numbers).collect())
}

/// F − H = E − D, through all change points of an `rrr` with these lengths. Sums of lengths of 3 m round by 4 ε of them.
#[test]
fn drawn_parallelograms_stay_such_in_c() {
    for (source, base) in [(WIPER, [0.6, 0.0]), (RODS, [1.4, 0.0])] {
        let Some(answers) = answers(source) else { return };
        assert_eq!(answers.len(), 162);
        for (nth, [ex, ey, fx, fy]) in answers.into_iter().enumerate() {
            let off = if nth < 81 { 12.0 * f64::EPSILON } else { 12.0 * f64::from(f32::EPSILON) };
            assert!((fx - ex - base[0]).abs() < off, "{nth}: {fx} {ex}");
            assert!((fy - ey - base[1]).abs() < off, "{nth}: {fy} {ey}");
        }
    }
}
