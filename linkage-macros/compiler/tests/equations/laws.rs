//! Named laws against the same forces with the laws written out, and outputs of efforts against the efforts.

use crate::equations::derive;
use crate::ir::interpret::ProgramValues;
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
    let given = ProgramValues {
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

/// The numbers of an entry point of this declaration, in one state.
fn found(source: &str, entry: &str) -> Vec<f64> {
    let mechanism = mechanism(source);
    let program = passes::optimise(&derive(&mechanism, passes::RULES));
    let state = [[0.7, 3.0, -2.0], [0.3, -1.5, 4.0]];
    let given = ProgramValues {
        inputs: state[..mechanism.inputs.len()].iter().map(|one| one.map(Digits::float)).collect(),
        params: Vec::new(),
        loads: vec![Digits::float(11.0)],
        drives: vec![Digits::float(0.0); mechanism.inputs.len()],
        unit: None,
    };
    values(&program, entry, &given).iter().map(Digits::to_f64).collect()
}

fn close(found: f64, expected: f64, what: &str) {
    assert!(
        (found - expected).abs() <= 1e-14 * expected.abs().max(1.0),
        "{what}: {found}, {expected}"
    );
}

/// A slider-crank whose joints all rub, with outputs of all its efforts by themselves and in formulas.
const RUBBING: &str = "struct M { input q: angle; load cut: force;
     ground A(0, 0); guide bed through A along 0deg;
     crank AB(A) -> B { length: 80mm, angle: q }
     rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
     mass 2kg on BC uniform; mass 3kg on ram at (0, 0); inertia 0.1(kg*m^2) on AB;
     let law = cut - 2(N*s/m) * rate(ram.slide);
     force (law, 0) on C;
     friction 0.1 at A radius 20mm; friction 0.11 at B radius 21mm;
     friction 0.12 on BC at C radius 22mm; friction 0.13 on ram length 60mm;
     output q.drive, AB.drive, AB.A, BC.C, ram.bed, losses,
         AB.A.friction, AB.B.friction, BC.B.friction, BC.C.friction, ram.C.friction,
         ram.bed.friction, law,
         size = hypot(BC.C.x, BC.C.y), pressed = abs(ram.bed.normal) + ram.bed.couple / 60mm,
         power = q.drive * rate(q), slip = rate(BC.angle), taken = 2 * losses + cut * 1(m/s),
         across = AB.A.x - AB.A.y; }";

#[test]
fn formulas_are_made_of_the_efforts_beside_them() {
    for entry in ["forces", "statics"] {
        let numbers = found(RUBBING, entry);
        // In the order of the record: what one link has stands together.
        let &[
            drive,
            own,
            ax,
            ay,
            at_a,
            on_ab,
            cx,
            cy,
            on_bc,
            by_bc,
            normal,
            couple,
            on_ram,
            along,
            losses,
            law,
            size,
            pressed,
            power,
            slip,
            taken,
            across,
        ] = &numbers[..]
        else {
            panic!("{} numbers", numbers.len())
        };
        close(own, drive, "the crank has the input's drive");
        close(size, cx.hypot(cy), "size");
        close(pressed, normal.abs() + couple / 0.06, "pressed");
        close(across, ax - ay, "across");
        close(taken, 2.0 * losses + 11.0, "taken");
        // At B and C the one link has the opposite of the other.
        close(on_ab, -on_bc, "at B");
        close(by_bc, -on_ram, "at C");
        close(at_a.abs(), 0.1 * 0.02 * ax.hypot(ay), "the friction of A");
        close(by_bc.abs(), 0.12 * 0.022 * size, "the friction of C");
        close(along.abs(), 0.13 * normal.abs().max(2.0 * couple.abs() / 0.06), "of the ram");
        let rate = if entry == "forces" { 3.0 } else { 0.0 };
        close(power, drive * rate, "power");
        // The slips of a slider-crank by hand, at the rate of three or of the creep.
        let (q, way) = (0.7_f64, 3.0);
        let turned = -(0.08 * q.sin() / 0.25).asin();
        let omega = -way * 0.08 * q.cos() / (0.25 * turned.cos());
        let slide = -way * 0.08 * q.sin() + 0.25 * omega * turned.sin().abs();
        close(slip, omega * rate / way, "slip");
        close(law, 11.0 - 2.0 * slide * rate / way, "law");
        // Friction brakes: each takes the power that `losses` counts.
        let taken = -(at_a * way + on_bc * (omega - way) + by_bc * omega + along * slide);
        close(losses, taken, "losses");
        assert!(taken > 0.0 && at_a < 0.0);
    }
}

#[test]
fn formulas_of_several_inputs() {
    const ARM: &str = "struct M { input p: angle; input r: angle; load cut: force;
         ground A(0, 0); crank AB(A) -> B { length: 1m, angle: p }
         crank BC(B) -> C { length: 2m, angle: r, relative_to: AB }
         mass 2kg on C; mass 1kg on B; gravity (0, -9.81); torque cut * 1m on AB;";
    // Alone by power, and beside a reaction by the walk.
    for (beside, skip) in [("", 0), ("AB.A,", 2)] {
        let source = format!(
            "{ARM} output {beside} p.drive, r.drive, shaking,
             power = p.drive * rate(p) + r.drive * rate(r), twice = 2 * cut, moved = shaking.couple; }}"
        );
        let numbers = found(&source, "forces");
        let &[one, other, _, _, couple, power, twice, moved] = &numbers[skip..] else {
            panic!("{} numbers", numbers.len())
        };
        close(power, 3.0 * one - 1.5 * other, "power");
        close(twice, 22.0, "twice");
        close(moved, couple, "moved");
    }
}
