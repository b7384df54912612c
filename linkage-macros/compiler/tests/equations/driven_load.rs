//! Mechanisms of which a load drives an input, against the same under the load that was found: nothing is left for a drive.

use crate::equations::{derive, load_does_work};
use crate::ir::interpret::{Number, ProgramValues};
use crate::ir::program::Program;
use crate::oracle::{Digits, mechanism, values};
use crate::passes;

/// A declaration with a load `pull`, its outputs but for the first, and its inputs.
struct Machine {
    statements: &'static str,
    outputs: &'static str,
    inputs: &'static [&'static str],
}

const LAWS: &str =
    "let damped = pull - 20(N*s/m) * rate(ram.slide); let both = -(damped / 2 - pull * 2) + 3N;
     let scaled = cut + both * (1 + q / 5) / 2;";

/// A slider-crank on which the load stands in every way.
const ENGINE: Machine = Machine {
    statements: "ground A(0, 0); guide bed through (0, 10mm) along 5deg;
         crank AB(A) -> B { length: 80mm, angle: q }
         rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
         gravity (0, -9.81); mass 2kg on BC uniform; mass 3kg on ram at (10mm, 0); inertia 0.1(kg*m^2) on AB;
         force (scaled, 2 * damped) in ram on C; force 4N - pull / 3 between A and C;
         torque 0.03m * pull between BC and AB; torque -0.01m * both on BC;",
    outputs: "AB.A, BC.B, BC.C, ram.bed, shaking, law = scaled * rate(ram.slide)",
    inputs: &["q"],
};

const ARM: Machine = Machine {
    statements: "ground A(0, 0); crank AB(A) -> B { length: 1m, angle: q }
         guide rail on AB through (0.2m, 0) along 80deg; slider ram(rail) -> C { slide: 300mm * r }
         gravity (0, -9.81); mass 2kg on C; mass 1kg on AB uniform; inertia 0.4(kg*m^2) on ram;
         force pull * (1 + rate(r) / 9(rad/s)) - cut between A and C; torque 0.1m * pull on AB;",
    outputs: "AB.A, ram.rail, q.drive",
    inputs: &["q", "r"],
};

const FRICTION: &str = "friction 0.02 at A radius 20mm; friction 0.021 at B radius 21mm;
     friction 0.022 on BC at C radius 22mm; friction 0.023 on ram length 90mm;";

const STATE: [[f64; 3]; 2] = [[0.7, 3.0, -2.0], [0.4, -1.5, 4.0]];

impl Machine {
    /// The mechanism with the load given or found; `driven` is the input that it drives.
    fn solver(&self, more: &str, driven: &str, is_given: bool) -> Program {
        let Self { statements, outputs, inputs } = self;
        let laws = if self.inputs.len() == 1 { LAWS } else { "" };
        let (placed, acting) = statements.split_once("gravity").expect("there is gravity");
        let (drive, first) = match is_given {
            false => (format!("drive {driven} by pull;"), "pull".to_string()),
            true => (String::new(), format!("{driven}.drive")),
        };
        let source = format!(
            "struct M {{ input {}: angle; load cut: force; load pull: force; {placed} {laws} gravity {acting} \
             {more} {drive} output {first}, {outputs}; }}",
            inputs.join(", ")
        );
        passes::optimise(&derive(&mechanism(&source), passes::RULES))
    }

    /// The numbers of an entry point, with the load given or found.
    fn found(
        &self,
        program: &Program,
        entry: &str,
        driven: &str,
        given: Option<&Digits>,
    ) -> Vec<Digits> {
        // Forwards the load stands in the place of the drive, and nothing in that of a given one.
        let drive = |name: &&str| match (*name == driven, given) {
            (true, None) => Digits::float(45.0),
            (true, Some(_)) => Digits::float(0.0),
            (false, _) => Digits::float(-6.0),
        };
        let state = &STATE[..self.inputs.len()];
        let given = ProgramValues {
            inputs: state.iter().map(|one| one.map(Digits::float)).collect(),
            params: Vec::new(),
            loads: [Digits::float(11.0)].into_iter().chain(given.cloned()).collect(),
            drives: self.inputs.iter().map(drive).collect(),
            unit: None,
        };
        values(program, entry, &given)
    }

    /// Compares everything but the load, and the drive that is left, in so many digits of the largest number.
    fn check(&self, more: &str, driven: &str, share: f64) {
        let [searched, told] = [false, true].map(|is_given| self.solver(more, driven, is_given));
        for entry in ["forces", "statics"] {
            let found = self.found(&searched, entry, driven, None);
            let known = self.found(&told, entry, driven, Some(&found[0]));
            let largest = known.iter().chain(&found).map(|x| x.to_f64().abs()).fold(1.0, f64::max);
            assert!(known[0].to_f64().abs() <= share * largest, "{entry}: {}", known[0].to_f64());
            assert!(found[0].to_f64().abs() > 1.0, "{entry}: a load of {}", found[0].to_f64());
            for (found, known) in found[1..].iter().zip(&known[1..]) {
                let apart = found.sub(known).to_f64().abs();
                assert!(apart <= share * largest, "{entry}: {} {}", found.to_f64(), known.to_f64());
            }
        }
        let forward = |program, given| -> Vec<f64> {
            let found = self.found(program, "forward_dynamics", driven, given);
            found.iter().map(Digits::to_f64).collect()
        };
        let (found, known) = (forward(&searched, None), forward(&told, Some(&Digits::float(45.0))));
        assert_eq!(found, known);
    }
}

#[test]
fn nothing_is_left_for_a_drive() {
    ENGINE.check("", "q", 1e-40);
    ARM.check("", "r", 1e-40);
}

/// Amounts are solved to some ε.
#[test]
fn nothing_is_left_for_a_drive_beside_friction() {
    ENGINE.check(FRICTION, "q", 1e-13);
    let smooth =
        "friction 0.2 at A radius 30mm smooth 0.1(rad/s); friction 0.1 on ram smooth 0.05(m/s);";
    ARM.check(smooth, "r", 1e-13);
    // The band is that of the two creeps.
    let searched = ENGINE.solver(FRICTION, "q", false);
    let source = |entry| ENGINE.found(&searched, entry, "q", None);
    let [backwards, forwards] = &source("holding")[..] else { panic!("there are two") };
    // The creep of the state is forwards.
    let creep = &source("statics")[0];
    assert!(forwards.sub(creep).to_f64().abs() <= 1e-12 * creep.to_f64().abs());
    assert!(backwards.sub(forwards).to_f64().abs() > 1.0);
}

/// A load that stands still, or across what moves, is told from one that is at a dead point now and then.
#[test]
fn a_load_is_known_to_do_no_work_where_nothing_moves_along_it() {
    let works = |statements: &str| {
        let source = format!(
            "struct M {{ input q: angle; input r: length; ground A(0, 0), E(3m, 0); load pull: force;
             crank AB(A) -> B {{ length: 1m, angle: q }}
             guide rail through (0.2m, 0) along 90deg; rrp BC(B), ram(rail) -> C {{ length: 3m, mode: ahead }}
             guide level through E along 0deg; slider cart(level) -> D {{ slide: r }}
             mass 1kg on C; mass 1kg on D; {statements} }}"
        );
        load_does_work(&mechanism(&source), passes::RULES)
    };
    for (statements, is_some) in [
        ("force (pull, 0) on C; drive q by pull;", false),
        ("force (2N, pull) on C; drive q by pull;", true),
        ("force (pull, 0) in ram on C; drive q by pull;", true),
        ("force (0, pull) in ram on C; drive q by pull;", false),
        ("force (0, pull) on D; force (pull, 0) on C; drive r by pull;", false),
        ("force (pull, 0) on D; drive r by pull;", true),
        ("force (pull, pull) on D; drive q by pull;", false),
        ("force (pull, pull) on D; torque pull * 1m on BC; drive q by pull;", true),
        ("torque pull * 1m on cart; drive r by pull;", false),
        ("force pull between C and D; drive r by pull;", true),
        ("torque pull * 1m on ram; force pull - pull between C and D; drive q by pull;", false),
        ("force (pull, 0) on C;", true),
    ] {
        assert_eq!(works(statements), is_some, "{statements}");
    }
}
