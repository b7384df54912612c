//! Numbers in words, and words that readers write as numbers.

use std::format;
use std::string::ToString;

use super::node;
use crate::SolveError;
use crate::sketch::page::page_files::{ARITHMETIC, FRICTION, READS, SEARCH};

/// A computation, and its result.
const CASES: &[(&str, &str)] = &[
    ("digits(0)", "0"),
    ("digits(4.8e-15)", "4.800·10⁻¹⁵"),
    ("digits(1.49e-6)", "1.490·10⁻⁶"),
    ("digits(-2.3456e-4)", "−0.0002346"),
    ("digits(0.99996)", "1.000"),
    ("digits(-123456)", "−123456"),
    ("digits(1234567)", "1.235·10⁶"),
    ("digits(NaN)", "–"),
    // A force beside others of its size is one, however small; beside large ones it is rounding.
    ("inScale(4.8e-15, shownIn(\"N\", 0, 4.8e-15), 4.8e-15)", "4.800 fN"),
    ("inScale(4.8e-15, shownIn(\"N\", 0, 3e3), 3e3)", "0 kN"),
    ("inScale(-6577714, shownIn(\"N\", 0, 4e7), 4e7)", "−6.578 MN"),
    ("inScale(0.0587, shownIn(\"m\", 0, 0.5), 0.5)", "58.70 mm"),
    ("inScale(9.3e-5, shownIn(\"m\", 1, 2e-4), 2e-4)", "93.00 µm/s"),
    ("inScale(0.02, shownIn(\"kg\", 0, 0.02))", "20.00 g"),
    ("inScale(2e4, shownIn(\"kg/s\", 0, 2e4))", "20.00 kN·s/m"),
    ("inScale(3, shownIn(\"kg·m²\", 0, 3))", "3.000 kg·m²"),
    ("inScale(2e-4, shownIn(\"m²\", 0, 2e-4))", "0.0002000 m²"),
    ("inScale(0.5, shownIn(\"1\", 0, 1))", "0.5000"),
    ("inScale(-0.2, shownIn(\"rad\", 0, 1))", "−11.46°"),
    ("inScale(999.96, shownIn(\"N\", 0, 999.96))", "1.000 kN"),
    ("tickWords(-2e7 / 1e6, 20)", "−20"),
    ("tickWords(-0.000025, 0.000025)", "−0.000025"),
    ("tickWords(2e-7, 2e-7)", "2.00·10⁻⁷"),
    ("tickWords(-1e-17, 0.5)", "0.0"),
    ("[chosen.length = \"in\", words(0.0254, \"m\"), chosen.length = \"auto\"][1]", "1.000 in"),
    ("[chosen.angle = \"rad\", words(1, \"rad\", 1), chosen.angle = \"°\"][1]", "1.000 rad/s"),
    ("asTyped(0.08, [\"mm\", 1e3])", "80 mm"),
    ("asTyped(1.5e-7, [\"m\", 1])", "1.5·10⁻⁷ m"),
    ("asTyped(100, [\"\", 1])", "100"),
    ("asTyped(-2.5, [\"°\", 1])", "−2.5°"),
    // Texts of readers.
    ("numberIn(\"63.5mm\", \"m\", [\"m\", 1])", "0.0635"),
    ("numberIn(\"63,5\", \"m\", [\"mm\", 1e3])", "0.0635"),
    ("numberIn(\" −1.5·10⁻³ kN \", \"N\", [\"N\", 1])", "-1.5"),
    ("numberIn(\"2e3\", \"N\", [\"kN\", 1e-3])", "2000000"),
    ("numberIn(\"90\", \"rad\", [\"°\", 180 / Math.PI]) - Math.PI / 2", "0"),
    ("numberIn(\"0.5 turn\", \"rad\", [\"°\", 180 / Math.PI]) - Math.PI", "0"),
    ("numberIn(\"60 rpm\", \"rad/s\", [\"rpm\", 30 / Math.PI]) - TURN", "0"),
    ("numberIn(\"2.5 in\", \"mm\", [\"mm\", 1e3])", "0.0635"),
    ("numberIn(\"3 kg\", \"m\", [\"m\", 1])", "null"),
    ("numberIn(\"\", \"m\", [\"m\", 1])", "null"),
    ("numberIn(\"1.2.3\", \"m\", [\"m\", 1])", "null"),
    ("numberIn(\"1e999\", \"m\", [\"m\", 1])", "null"),
    ("numberIn(\"3 (N/m)\", \"N/m\", [\"N/m\", 1])", "3"),
    // Both ends of a turn stay what they are.
    ("turnedInto(TURN, 0, TURN) === TURN", "true"),
    ("turnedInto(TURN + 1, 0, TURN).toFixed(9)", "1.000000000"),
];

#[test]
fn numbers_and_words_belong_together() {
    let [words, pose, ..] = READS;
    let turned =
        pose.lines().find(|line| line.starts_with("const turnedInto")).expect("it is there");
    let curves = include_str!("../curves.js");
    let (_, ticks) = curves.split_once("const tickWords").expect("it is there");
    let (ticks, _) = ticks.split_once("\n};").expect("it ends");
    let ask = |(asked, expected): &(&str, &str)| {
        format!("said(() => {asked}, {asked:?}, {expected:?});\n")
    };
    let asked: std::string::String = CASES.iter().map(ask).collect();
    let script = format!(
        "{}{words}{turned}\nconst tickWords{ticks}\n}};\nlet wrong = 0;\nconst said = (of, asked, expected) => \
         {{ const found = String(of()); if (found !== expected) {{ wrong++; console.log(asked, found, expected); }} }};\n\
         {asked}process.exitCode = wrong ? 1 : 0;",
        ARITHMETIC.concat()
    );
    let Some(output) = node::run(&script, "") else { return };
    assert!(output.is_success, "{}", output.text);
}

/// A refused pose has the crate's words on a page, without the marks around names; what is missing is told as the picture
/// tells it.
#[test]
fn refusals_have_the_words_of_the_crate() {
    let invalid = |group, name| SolveError::Invalid { group, name };
    let refusals = [
        SolveError::Singular { group: "BC, DC" },
        SolveError::Singular { group: "spring A, B" },
        SolveError::Singular { group: "force A, B" },
        SolveError::Jams { joint: "A" },
        SolveError::NotFinite { name: "theta" },
        SolveError::SeveralDeadPoints { unknown: "x" },
        invalid("BC, DC", "length of BC"),
        invalid("BC", "mass on BC"),
        invalid("BC", "inertia on BC"),
        invalid("A", "friction at A"),
        invalid("spring A, B", "stiffness"),
        invalid("x", "ends of between"),
    ];
    let told = refusals.map(|error| {
        let kind = format!("{error:?}");
        let kind = kind.split(' ').next().unwrap_or_default().to_string();
        let name = if let SolveError::Invalid { name, .. } = error { name } else { "" };
        let said = error.to_string().replace('`', "");
        let group = error.culprit();
        format!("said({{ kind: {kind:?}, group: {group:?}, name: {name:?} }}, {said:?});\n")
    });
    let [words, pose, ..] = READS;
    let (_, why) = pose.split_once("const why = ").expect("it is there");
    let script = format!(
        "{}{words}\nconst why = {why}\nlet wrong = 0;\nconst said = (error, expected) => \
         {{ const found = why(error); if (found !== expected) {{ wrong++; console.log(found, expected); }} }};\n\
         {}said({{ kind: \"OutOfReach\", group: \"BC, DC\", by: 0.03 }}, \"BC, DC cannot be assembled: 30.00 mm are missing\");\n\
         process.exitCode = wrong ? 1 : 0;",
        [&ARITHMETIC[..], &SEARCH, &FRICTION].concat().concat(),
        told.concat()
    );
    let Some(output) = node::run(&script, "") else { return };
    assert!(output.is_success, "{}", output.text);
}
