//! The inputs at which a machine is as it is drawn.

use super::machine::{Machine, machine};

fn of(statements: &str) -> Machine {
    machine(&format!("pub struct M {{ {statements} }}"))
        .unwrap_or_else(|told| panic!("{statements}: {told:?}"))
}

/// A wheel that is geared up turns by more than a half turn while it is drawn at less: at 170° twice the input is 340°,
/// and the second crank is drawn at −20°, a full turn off that.
#[test]
fn an_angle_a_turn_off_what_is_drawn_is_as_drawn() {
    let [b, e] = [170_f64, -20.0].map(|at| at.to_radians());
    for (second, at) in [("2 * t", e), ("2 * t + 0.001 * sin(t)", e)] {
        let ends = [[b.cos(), b.sin()], [4.0 + at.cos(), at.sin()]];
        let [[bx, by], [ex, ey]] = ends;
        let geared = of(&format!(
            "input t: angle; ground A(0, 0), D(4, 0); pin B({bx:?}, {by:?}), E({ex:?}, {ey:?}), C(2.1, 3); \
             link AB(A, B), DE(D, E), BC(B, C), EC(E, C); drive AB.angle = t; drive DE.angle = {second};"
        ));
        let drawn = geared.drawn_inputs();
        // The first drive says where its input is drawn, to the roundings of an arc tangent.
        assert!((drawn[0] - b).abs() < 1e-14, "{second}: {drawn:?}");
    }
}

/// A drive that no input brings to where it is drawn is told beside one that no input moves, and that is drawn to two
/// digits.
#[test]
fn a_drive_that_no_input_moves_is_not_told_for_another() {
    let told = machine(
        "pub struct M { input t: angle; ground A(0, 0), D(4, 0), G(6, 1); pin B(0.5, 0.9), C(3.2, 2.6), H(6.7, 1.71); \
         link AB(A, B), BC(B, C), DC(D, C), GH(G, H); drive AB.angle = 10deg + 0.2 * sin(t); drive GH.angle = 45deg; }",
    );
    // 60.945° is at most 10° + 11.5° for no input.
    assert_eq!(
        told.err().expect("`AB` is drawn elsewhere"),
        ["`drive AB.angle` cannot be as drawn: no input was found at which it is 60.9°\n\
          draw `AB` where its value takes it, or change the value"]
    );
}

/// A jib on a boom, driven along the guide that it carries: with the boom's pin at rest, the jib's pins go back along the
/// guide by what the boom goes on, and turn about that pin with the boom. The guide is 10° from the jib's first two pins,
/// which are at 45°.
#[test]
fn a_link_that_carries_the_guide_of_a_driven_one_goes_the_other_way() {
    for through in ["(0.2, -0.3)", "(0, 0)"] {
        let crane = machine(&format!(
            "pub struct M {{ input t: angle; input s: length; ground A(0, 0); pin B(1.5, 0.9), P(2.4, 1.2), Q(3.1, 1.9); \
             link boom(A, B) on rail; link jib(P, Q); guide rail on jib through {through} along 10deg; \
             drive boom.angle = t; drive boom.slide = s; }}"
        ))
        .unwrap_or_else(|told| panic!("{told:?}"));
        let (p, q, half) = ([2.4, 1.2], [3.1, 1.9], 0.5_f64.sqrt());
        let start = match through {
            "(0, 0)" => p,
            // By 45°.
            _ => [p[0] + half * (0.2 + 0.3), p[1] + half * (0.2 - 0.3)],
        };
        let along = [55_f64.to_radians().cos(), 55_f64.to_radians().sin()];
        let drawn = [0.9_f64.atan2(1.5), -start[0] * along[0] - start[1] * along[1]];
        for [turn, way] in [[0.0, 0.0], [0.4, 0.0], [0.0, -0.3], [-0.2, 0.5]] {
            let found = crane.pins::<f64>(&[drawn[0] + turn, drawn[1] + way]);
            for (name, at) in [("P", p), ("Q", q)] {
                let [x, y] = [0, 1].map(|axis| at[axis] - way * along[axis]);
                let (sin, cos) = turn.sin_cos();
                let wanted = [cos * x - sin * y, sin * x + cos * y];
                let now = found.iter().find(|(pin, _)| pin == name).expect("a pin").1;
                let off = (now[0] - wanted[0]).hypot(now[1] - wanted[1]);
                // A few products of lengths of three.
                assert!(off < 1e-14, "{name} is off by {off:e}");
            }
        }
    }
}
