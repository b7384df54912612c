//! Named laws against the same forces with the laws written out.

use crate::equations::derive;
use crate::ir::interpret::Given;
use crate::oracle::{Digits, mechanism, values};
use crate::passes;

/// Every answer about forces of a slider-crank with these statements, in one state.
fn answers(statements: &str) -> Vec<(&'static str, Vec<f64>)> {
    let source = format!(
        "struct M {{ input q: angle; load cut: force;
         ground A(0, 0); guide bed through A along 0deg;
         crank AB(A) -> B {{ length: 80mm, angle: q }}
         rrp BC(B), ram(bed) -> C {{ length: 250mm, mode: ahead }}
         mass 2kg on C; inertia 0.1(kg*m^2) on AB; {statements}
         output q.drive, BC.C, ram.bed, energy; }}"
    );
    let program = passes::optimise(&derive(&mechanism(&source), passes::RULES));
    let number = Digits::float;
    let given = Given {
        inputs: vec![[0.7, 3.0, -2.0].map(number)],
        params: Vec::new(),
        loads: vec![number(11.0)],
        drives: vec![number(5.0)],
        unit: None,
    };
    ["forces", "statics", "forward_dynamics", "equations_of_motion"]
        .map(|entry| {
            let found = values(&program, entry, &given);
            (entry, found.iter().map(Digits::to_f64).collect())
        })
        .into()
}

#[test]
fn a_law_is_what_it_is_written_as() {
    let named = answers(
        "let v = rate(ram.slide); let brake = -5(N*s/m) * v + cut; let both = brake + v * 1(N*s/m);
         force (both, brake) on C; torque 0.1(m) * brake on AB;",
    );
    let written = answers(
        "force (-5(N*s/m) * rate(ram.slide) + cut + rate(ram.slide) * 1(N*s/m),
                -5(N*s/m) * rate(ram.slide) + cut) on C;
         torque 0.1(m) * (-5(N*s/m) * rate(ram.slide) + cut) on AB;",
    );
    assert_eq!(named, written);
    // The rates are those of the motion, also where the efforts are taken from a unit rate.
    let without = answers("force (cut, cut) on C;");
    assert_ne!(named[0], without[0]);
}

/// Each law is computed once, however many stand on it, and none inside another.
#[test]
fn laws_stand_on_laws_without_end() {
    let mut source = "let v0 = 1(N*s/m) * rate(ram.slide);".to_string();
    for law in 1..1000 {
        source += &format!("let v{law} = (v{0} + v{0}) / 2;", law - 1);
    }
    let named = answers(&format!("{source} force (v999, cut) on C;"));
    assert_eq!(named, answers("force (1(N*s/m) * rate(ram.slide), cut) on C;"));
}
