//! Answers of printed C, compiled strictly, beside those of Rust: in both widths, to the bit. With `LINKAGE_WHOLE` it is
//! optimised as well.

use std::fmt::Write;
use std::process::Command;

use proc_macro2::{TokenStream, TokenTree};

use super::super::cases::cases;
use super::super::numbers::skipped::skipped;

/// A declaration that is printed in C.
pub(super) struct Printed {
    pub text: &'static str,
    pub name: &'static str,
    pub has_params: bool,
}

/// The answers of Rust in both widths; those in `f32` as they are in `f64`.
pub(super) type Answers = [Vec<Option<Vec<f64>>>; 2];

/// An input, its rate and its acceleration.
const RATES: &str = "(real)given[k][0], (real)given[k][1], (real)given[k][2], ";

/// A call in both widths at each row of what is given. `TAIL` stands for nothing or `F32`, `END` for nothing or `_f32`.
const CALLER: &str = r#"
#include <stdio.h>
#include <string.h>
#include "HEADER.h"
static const double given[COUNT][WIDTH] = {
ROWS};
#define CALL(real, TAIL, END) \
    for (k = 0; k < COUNT; k++) { \
        NAME##ENTRY##TAIL answer; \
        real numbers[sizeof answer / sizeof(real)]; \
        SETUP \
        memset(&answer, 0, sizeof answer); \
        printf("%d", (int)STEM_CALL##END(ARGUMENTS&answer, NULL)); \
        memcpy(numbers, &answer, sizeof answer); \
        for (n = 0; n < sizeof numbers / sizeof numbers[0]; n++) { \
            const double wide = (double)numbers[n]; \
            unsigned long long bits; \
            memcpy(&bits, &wide, sizeof bits); \
            printf(" %016llx", bits); \
        } \
        printf("\n"); \
    }
int main(void)
{
    size_t k, n;
    CALL(double, , )
    CALL(float, F32, _f32)
    return 0;
}
"#;

impl Printed {
    /// Asserts that poses are those of Rust.
    pub(super) fn places(&self, given: &[Vec<f64>], answers: &Answers) {
        let arguments = match given[0].len() {
            1 => "(real)given[k][0], ".to_string(),
            _ => "&q, ".to_string(),
        };
        let setup = match given[0].len() {
            1 => String::new(),
            count => {
                let all: Vec<_> = (0..count).map(|nth| format!("(real)given[k][{nth}]")).collect();
                format!("const NAMEInput##TAIL q = {{ {} }};", all.join(", "))
            }
        };
        self.compare(["Position", "position"], [&setup, &arguments], given, answers);
    }

    /// Asserts that motions at an input, its rate and its acceleration are those of Rust.
    pub(super) fn motions(&self, given: &[Vec<f64>], answers: &Answers) {
        self.compare(["Motion", "motion"], ["", RATES], given, answers);
    }

    /// Asserts that forces at an input, its rate and its acceleration are those of Rust, with loads in front of the result.
    pub(super) fn forces(&self, loads: &str, given: &[Vec<f64>], answers: &Answers) {
        let arguments = format!("{RATES}{loads}");
        self.compare(["Forces", "forces"], ["", &arguments], given, answers);
    }

    fn compare(
        &self,
        [record, entry]: [&str; 2],
        [setup, arguments]: [&str; 2],
        given: &[Vec<f64>],
        answers: &Answers,
    ) {
        let call: TokenStream = self.text.parse().expect("these are tokens");
        let Some(TokenTree::Group(group)) = call.into_iter().last() else {
            panic!("a call ends with its brackets")
        };
        let files =
            linkage_compiler::c(group.stream(), &[entry], None).expect("there is no mistake");
        let header = files[0].name.trim_end_matches(".h").to_string();
        let call = format!("_{entry}(");
        let mut words = files[0].text.split_whitespace();
        let stem = words.find_map(|word| word.split_once(&call)).expect("it is declared").0;
        let folder =
            std::env::temp_dir().join(format!("right_{}_{header}_{entry}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder can be made");
        for file in &files {
            std::fs::write(folder.join(&file.name), &file.text).expect("it can be written");
        }
        let rows = given.iter().fold(String::new(), |mut rows, row| {
            let row: Vec<String> = row.iter().map(|x| format!("{x:?}")).collect();
            writeln!(rows, "    {{ {} }},", row.join(", ")).expect("a string takes it");
            rows
        });
        let (mut setup, mut arguments) = (setup.to_string(), arguments.to_string());
        if self.has_params {
            setup = format!("const NAME##TAIL own = STEM_default##END();{setup}");
            arguments.insert_str(0, "&own, ");
        }
        let caller = CALLER
            .replace("SETUP", &setup)
            .replace("ARGUMENTS", &arguments)
            .replace("STEM_CALL", &format!("{stem}_{entry}"))
            .replace("STEM", stem)
            .replace("HEADER", &header)
            .replace("ENTRY", record)
            .replace("NAME", self.name)
            .replace("COUNT", &given.len().to_string())
            .replace("WIDTH", &given[0].len().to_string())
            .replace("ROWS", &rows);
        std::fs::write(folder.join("caller.c"), caller).expect("it can be written");
        let sources = files.iter().map(|file| &file.name[..]).filter(|name| name.ends_with(".c"));
        let compiled = Command::new("cc")
            .args([
                "-std=c99",
                ["-O0", "-O2"][cases(0, 1)],
                "-Wall",
                "-Wextra",
                "-Wshadow",
                "-Werror",
                "-o",
                "caller",
            ])
            .arg("caller.c")
            .args(sources)
            .arg("-lm")
            .current_dir(&folder)
            .output();
        let Ok(compiled) = compiled else { return skipped("right numbers in C: no cc") };
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
        let output = Command::new(folder.join("caller")).output().expect("the program starts");
        let said = String::from_utf8(output.stdout).expect("it writes text");
        let answers = answers.iter().flatten();
        assert_eq!(said.lines().count(), answers.clone().count(), "{}", self.name);
        for (nth, (line, answer)) in said.lines().zip(answers).enumerate() {
            let bits = |x: &f64| format!("{:016x}", x.to_bits());
            let wanted = answer.as_ref().map(|all| all.iter().map(bits).collect::<Vec<_>>());
            let mut words = line.split(' ');
            let is_refused = words.next() != Some("0");
            let found = (!is_refused).then(|| words.collect::<Vec<_>>());
            let is_same = match (&found, &wanted) {
                (Some(found), Some(wanted)) => found == wanted,
                (None, None) => true,
                _ => false,
            };
            assert!(is_same, "{} {nth}: {line} for {wanted:?}", self.name);
        }
        drop(std::fs::remove_dir_all(&folder));
    }
}
