//! Quantities that are inputs beside plain inputs and drives: the two expand to the same tokens.

use super::{pipeline, texts};
use crate::pipeline::Options;

/// The code of a declaration, its documentation included, and its messages.
fn expanded(statements: &str) -> Vec<String> {
    // A page holds the text of its declaration.
    let mut options = Options::ALL;
    options.page = false;
    let source = format!("pub struct Machine {{ {statements} }}");
    let output = pipeline::compile(source.parse().expect("these are tokens"), &options);
    let messages: Vec<_> = output.diagnostics.iter().map(|it| it.text()).collect();
    assert_eq!(messages, [""; 0], "{statements}");
    let code = texts(output.tokens);
    // Editors find other names in another text.
    let end = code.windows(2).position(|pair| pair[0] == "struct" && pair[1] == "Names_");
    code[..end.expect("it names its names")].iter().map(ToString::to_string).collect()
}

fn expand_alike(quantities: &str, drives: &str) {
    let [found, wanted] = [quantities, drives].map(expanded);
    let same = found.iter().zip(&wanted).take_while(|(a, b)| a == b).count();
    let around = |code: &[String]| {
        let from = same.saturating_sub(30);
        code[from..].iter().take(60).cloned().collect::<Vec<_>>().join(" ")
    };
    assert!(found == wanted, "{quantities}:\n{}\n\n{}", around(&found), around(&wanted));
}

const FIVE_BAR: &str = "ground A(-50mm, 0), E(50mm, 0); pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm); \
                        link AB(A, B), BC(B, tool), CD(D, tool), ED(E, D);";

#[test]
fn quantities_expand_as_inputs_and_drives() {
    let rows = [
        (
            "input a = AB.angle, b = ED.angle;",
            "input a, b: angle;",
            "drive AB.angle = a; drive ED.angle = b;",
        ),
        (
            "input a = AB.angle + 90deg; input b = -2 * ED.angle;",
            "input a: angle; input b: angle;",
            "drive AB.angle = a - 90deg; drive ED.angle = b / -2;",
        ),
        ("input x = tool.x, y = tool.y;", "input x, y: length;", "point tool at (x, y);"),
        (
            "input y = 2 * tool.y - 10mm, x = tool.x;",
            "input y, x: length;",
            "point tool at (x, (y + 10mm) / 2);",
        ),
        (
            "input turn = AB.angle, fold = BC.angle - AB.angle;",
            "input turn, fold: angle;",
            "drive AB.angle = turn; drive BC.angle - AB.angle = fold;",
        ),
    ];
    for (quantities, inputs, drives) in rows {
        expand_alike(&format!("{quantities} {FIVE_BAR}"), &format!("{inputs} {FIVE_BAR} {drives}"));
    }
}

const BOOM: &str = "ground O(0, 0), F(0.5m, -0.4m); pin G(2.4m, 1.6m), tip(3m, 1m); link boom(O, G, tip); output boom, tip;";

/// Where today's language says it by links and guides that have names.
#[test]
fn quantities_expand_as_links_and_guides() {
    let rail = "guide tip_x_rail through (0, 0) along 0deg; link tip_x_carriage() on tip_x_rail; \
                guide tip_x_way on tip_x_carriage through tip along 90deg; link tip_x_block(tip) on tip_x_way; \
                drive tip_x_carriage.slide = x;";
    let upright = "guide tip_y_rail through (0, 0) along 90deg; link tip_y_carriage() on tip_y_rail; \
                   guide tip_y_way on tip_y_carriage through tip along -90deg; link tip_y_block(tip) on tip_y_way; \
                   drive tip_y_carriage.slide = (y - 1m) / 2;";
    let slid = "guide bed through (0, 0) along 0deg; link rod(G, E), ram(E) on bed; pin E(4m, 0);";
    let rows = [
        ("input s = distance(F, G);", "input s: length;", "link F_G(F, G) { length: s }"),
        ("input x = tip.x;", "input x: length;", rail),
        ("input y = 2 * tip.y + 1m;", "input y: length;", upright),
        ("input s = FG.length; link FG(F, G);", "input s: length; link FG(F, G) { length: s }", ""),
        (
            &format!("input s = ram.slide - 1m; {slid}"),
            &format!("input s: length; {slid}"),
            "drive ram.slide = s + 1m;",
        ),
    ];
    for (quantities, inputs, drives) in rows {
        expand_alike(&format!("{quantities} {BOOM}"), &format!("{inputs} {BOOM} {drives}"));
    }
}
