//! Quantities that are inputs: every mistake at the tokens that were written, without a name that nobody wrote.

use super::{check, resolved};

const FIVE_BAR: &str = "ground A(-50mm, 0), E(50mm, 0); pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm); \
                        link AB(A, B), BC(B, tool), CD(D, tool), ED(E, D);";
const LIFT: &str =
    "ground O(0, 0), F(0.5m, -0.4m); pin G(2.4m, 1.6m), tip(3m, 1m); link boom(O, G, tip);";

#[test]
fn mistakes_in_quantities() {
    check(&[
        (
            FIVE_BAR,
            "input x = tool.x;",
            "before AB: `AB`, `BC`, `CD` and `ED` still move when every input is held: one drive too few / drive one of them, `drive AB.angle = …;`, or pin one of them to another link",
        ),
        (
            FIVE_BAR,
            "input x = tool.x, y = tool.y, a = AB.angle;",
            "tool#1: `AB`, `BC`, `tool` and the ground hold each other without `input a = AB.angle`: one constraint too many / leave out `input x = tool.x` or `input a = AB.angle`",
        ),
        (
            FIVE_BAR,
            "input x = tol.x, y = tool.y;",
            "tol: no pin named `tol`; one with a similar name exists: `tool` / say where it is drawn: `pin tol(…, …);`",
        ),
        (
            FIVE_BAR,
            "input x = tol.x, y = tol.y;",
            "tol#1: no pin named `tol`; one with a similar name exists: `tool` / say where it is drawn: `pin tol(…, …);`\ntol#2: no pin named `tol`; one with a similar name exists: `tool` / say where it is drawn: `pin tol(…, …);`",
        ),
        (
            FIVE_BAR,
            "input x = A.x, y = tool.y;",
            "A: `A` stands still / an input moves a `pin` of the drawing, or a point on a link",
        ),
        (
            FIVE_BAR,
            "input x = AB.x, y = tool.y;",
            "AB: `AB` is a link, not a point / a coordinate is that of a point: `tool.x`",
        ),
        (
            FIVE_BAR,
            "input x = 3mm, y = tool.y;",
            "3mm: `x` moves nothing; write `param` for a number with a default / an input is a quantity of the machine: an angle, a slide, a length, a coordinate of a point or a distance",
        ),
        (
            FIVE_BAR,
            "input x = tool.x, z = tool.x;",
            "z = tool.x: `x` and `z` are one quantity / leave out `z = tool.x`",
        ),
        (
            FIVE_BAR,
            "input x = tool.x * B.y, y = tool.y;",
            "tool.x * B.y: an input is one quantity of the machine, a factor before and a constant behind it / a factor stands in front of the quantity and a constant behind it: `2 * tip.y`, `shank.angle + 90deg`",
        ),
        (
            FIVE_BAR,
            "input x = tool.z, y = tool.y;",
            "tool.z: an input is one quantity of the machine, a factor before and a constant behind it / a factor stands in front of the quantity and a constant behind it: `2 * tip.y`, `shank.angle + 90deg`",
        ),
        (
            FIVE_BAR,
            "input a = AB.angle, c = AB.angle;",
            "c = AB.angle: `a` and `c` are one quantity / leave out `c = AB.angle`",
        ),
        (
            FIVE_BAR,
            "input a = AB.angle, c = AB.slide;",
            "slide: `AB` slides on no guide / a cylinder has a length: `link AB(A, B) { length: … }`; what slides is declared as `link AB(…) on GUIDE;`",
        ),
        (
            FIVE_BAR,
            "input a = AB.angle, c = AD.angle;",
            "AD: no link named `AD`; one with a similar name exists: `AB` / links are declared with the pins through them: `link BC(B, C);`",
        ),
        (
            FIVE_BAR,
            "input a = AB.angle, c = A.angle;",
            "A: `A` is a point, not a link / name a link: through `A` goes `AB`",
        ),
        (
            FIVE_BAR,
            "input a = AB.angle, c = AB.length;",
            "before ED: `BC`, `CD` and `ED` still move when every input is held: one drive too few / drive one of them, `drive ED.angle = …;`, or pin one of them to another link",
        ),
        (
            FIVE_BAR,
            "input a = AB.angle, c = AC.length;",
            "AC: no link named `AC`; one with a similar name exists: `AB` / links are declared with the pins through them: `link BC(B, C);`",
        ),
        (
            FIVE_BAR,
            "input a = AB.angle, c = distance(A, B);",
            "c = distance(A, B): `distance(A, B)` does not change / `AB` joins the two: leave it out, or write `AB.length`",
        ),
        (
            FIVE_BAR,
            "input a = AB.angle, c = distance(A, E);",
            "c = distance(A, E): `distance(A, E)` does not change / both points stand still",
        ),
        (
            FIVE_BAR,
            "input a = AB.angle, c = distance(A, Q);",
            "Q: no pin named `Q` / say where it is drawn: `pin Q(…, …);`",
        ),
        (
            FIVE_BAR,
            "input x = tool.x, b = B.x, d = D.x;",
            "d = D.x: `x`, `b` and `d` fight: `AB`, `BC`, `CD`, `ED` and the ground have 2 freedoms and 3 inputs / leave out `input x = tool.x`, `input b = B.x` or `input d = D.x`",
        ),
        (
            LIFT,
            "input s = distance(F, G), a = boom.angle;",
            "s: `boom` and the ground hold each other without `input a = boom.angle`: one constraint too many / leave out `input s = distance(F, G)` or `input a = boom.angle`",
        ),
        (
            LIFT,
            "input s = distance(F, G), t = distance(F, tip);",
            "t: `boom` and the ground hold each other: one constraint too many / leave out `input t = distance(F, tip)`",
        ),
        (
            LIFT,
            "input x = tip.x, y = tip.y;",
            "tip#1: `boom`, `tip` and the ground hold each other: one constraint too many / leave out `input x = tip.x`",
        ),
        (
            LIFT,
            "input x = tip.x; input y = tip.y;",
            "tip#1: `boom`, `tip` and the ground hold each other: one constraint too many / leave out `input x = tip.x`",
        ),
        (
            LIFT,
            "input x = tip.x; drive boom.angle = x;",
            "x = tip.x: `drive boom.angle` and `input x = tip.x` fight: `boom` and the ground have one freedom and 2 drives / leave out `drive boom.angle` or `input x = tip.x`",
        ),
        (LIFT, "link FG(F, G); input s = FG.length;", ""),
        (
            LIFT,
            "link FG(F, G); input s = boom.length;",
            "length: a length is that of one link with two pins / leave it out: the distances between the pins of this link are as drawn",
        ),
        (
            LIFT,
            "link FG(F, G) { length: 3m } input s = FG.length;",
            "length#2: `FG` has a length already; leave out its braces / `FG.length` is an input",
        ),
        (
            LIFT,
            "input s: length; link FG(F, G); drive FG.length = s;",
            "length#2: a drive gives an angle or a slide / the length of a cylinder stands in its braces: `link FG(F, G) { length: … }`",
        ),
    ]);
}

/// Inputs keep the order and the kinds of their quantities, and the drawing gives the values of all of them.
#[test]
fn quantities_are_inputs_of_their_kind() {
    for (base, statements, wanted) in [
        (FIVE_BAR, "input a = 90deg - AB.angle, x = tool.x;", "refused"),
        (FIVE_BAR, "input a = AB.angle + 90deg, y = 2 * tool.y - 10mm;", "a 3.8026 y 0.3900"),
        (FIVE_BAR, "input x = tool.x, y = tool.y;", "x 0.0000 y 0.2000"),
        (LIFT, "input s = distance(F, G) - 1m;", "s 1.7586"),
        (LIFT, "input y = tip.y;", "y 1.0000"),
    ] {
        let (mechanism, _) = resolved(&format!("{base} {statements}"));
        let told = mechanism.map(|mechanism| {
            let drawn = mechanism.drawn.expect("it is drawn");
            let inputs = mechanism.inputs.iter().zip(drawn);
            inputs
                .map(|(input, at)| format!("{} {at:.4}", input.name))
                .collect::<Vec<_>>()
                .join(" ")
        });
        assert_eq!(told.unwrap_or("refused".to_string()), wanted, "{statements}");
    }
}
