//! A program means the same before and after every pass, in 55 digits.

use crate::equations;
use crate::equations::declarations::{UNKNOWNS, VARIANTS};
use crate::equations::parallelograms::PARALLELOGRAMS;
use crate::exact::Exact;
use crate::ir::construct::{Rule, rebuild};
use crate::ir::interpret::{Number, ProgramValues, Searched};
use crate::ir::program::Program;
use crate::oracle::{Digits, defaults, mechanism, values};
use crate::passes::{RULES, affine, contract, fold, optimise, simplify};

/// Every second variant; `.ci/nightly` takes the others.
#[test]
fn no_pass_changes_a_value() {
    passes_change_no_value(0);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn no_pass_changes_a_value_of_other_variants() {
    passes_change_no_value(1);
}

/// In every second variant from the first on.
fn passes_change_no_value(first: usize) {
    type Pass = fn(&Program) -> Program;
    let passes: [(&str, Pass); 6] = [
        ("fold", |program| rebuild(program, &[fold::fold_constants as Rule])),
        ("simplify", |program| rebuild(program, &[simplify::simplify as Rule])),
        ("both", |program| rebuild(program, RULES)),
        ("affine", affine::square_distances),
        ("fuse", contract::fuse_products),
        ("all", optimise),
    ];
    for variant in VARIANTS.iter().chain(UNKNOWNS).chain(PARALLELOGRAMS).skip(first).step_by(2) {
        let mechanism = mechanism(variant.source);
        let given = ProgramValues {
            inputs: variant.inputs.iter().map(|q| q.map(Digits::float)).collect(),
            params: defaults(&mechanism),
            loads: Vec::new(),
            drives: Vec::new(),
            unit: None,
        };
        let raw = equations::derive(&mechanism, &[]);
        let expected = values(&raw, "motion", &given);
        for (name, pass) in passes {
            let passed = pass(&raw);
            assert!(passed.graph.len() <= raw.graph.len(), "{name} made {} larger", variant.name);
            let found = values(&passed, "motion", &given);
            for (found, expected) in found.iter().zip(&expected) {
                // Both are good to about 120 digits less the conditioning of the pose.
                assert!(found.apart(expected) < 1e-55, "{name} changed {}", variant.name);
            }
        }
    }
}

/// Cosine and sine are leaves of their own: what a resolver gives is all that the entry points for
/// it read of the angle, and on the circle every pass keeps what they make of it.
#[test]
fn a_given_cosine_and_sine_are_all_that_is_read_of_an_angle() {
    let exact = |digits: &str| Digits::exact(&Exact::decimal(digits).expect("a decimal number"));
    let [cos, sin] = ["0.28", "0.96"].map(exact);
    for groups in [
        "rrr BC(B), DC(D) -> C { lengths: (0.254, 0.1778), mode: left }",
        "guide rail through (0, 0.02) along 10deg;
         rrp BC(B), ram(rail) -> C { length: 0.3, mode: ahead }",
        "rpr block(B), bar(D) { offset: 0.03 }",
        "guide rail through (0.1, 0.2) along 80deg; rpp block(B), yoke(rail) { slot: 70deg }",
        "crank BE(B) -> E { length: 0.1, relative_to: AB, angle: q }",
    ] {
        let mechanism = mechanism(&format!(
            "struct M {{ input q: angle; ground A(0, 0), D(0.3048, 0);
             crank AB(A) -> B {{ length: 0.1016, angle: q }} {groups} }}"
        ));
        let raw = equations::derive(&mechanism, &[]);
        let given = |value: Digits, unit| ProgramValues {
            inputs: vec![[value, Digits::float(1.3), Digits::float(-0.6)]],
            params: defaults(&mechanism),
            loads: Vec::new(),
            drives: Vec::new(),
            unit,
        };
        let angle = given(sin.atan2(&cos), None);
        let elsewhere = given(Digits::float(2.0), Some([cos.clone(), sin.clone()]));
        let expected = values(&raw, "motion", &angle);
        for program in [&raw, &affine::square_distances(&raw), &optimise(&raw)] {
            let found = values(program, "motion_at", &elsewhere);
            for (found, expected) in found.iter().zip(&expected) {
                assert!(found.apart(expected) < 1e-55, "{groups}");
            }
        }
    }
}

/// Off the circle the affine square of a distance is none, which is why an amplitude is divided out
/// before the formulas: here it shows what they would make of it.
#[test]
fn off_the_circle_a_coupler_would_not_keep_its_length() {
    let four_bar = "struct M { input q: angle; ground A(0, 0), D(0.6, 0);
        crank AB(A) -> B { length: 0.1, angle: q }
        rrr BC(B), DC(D) -> C { lengths: (0.5, 0.4), mode: left } output B, C; }";
    let mechanism = mechanism(four_bar);
    let program = optimise(&equations::derive(&mechanism, RULES));
    let length = |amplitude: f64| {
        let unit = [0.6, 0.8].map(|x| Digits::float(amplitude * x));
        let inputs = vec![[0.0; 3].map(Digits::float)];
        let given = ProgramValues {
            inputs,
            params: Vec::new(),
            loads: Vec::new(),
            drives: Vec::new(),
            unit: Some(unit),
        };
        let pins = values(&program, "position_at", &given);
        let [bx, by, cx, cy] = [0, 1, 2, 3].map(|i| pins[i].to_f64());
        (cx - bx).hypot(cy - by)
    };
    assert!((length(1.0) - 0.5).abs() < 1e-15, "{}", length(1.0));
    assert!((length(1.01) - 0.5).abs() > 1e-5, "{}", length(1.01));
}
