//! Inputs that are quantities: the trees they make, and their mistakes.

use super::{body, check_statements};

#[test]
fn quantities_stand_behind_their_names() {
    let tree = |statements: &str| {
        let (tree, mistakes) = body(statements);
        assert_eq!(mistakes, "", "{statements}");
        tree
    };
    assert_eq!(tree("input a = AB.angle;"), "input a = AB.angle");
    assert_eq!(
        tree("input x = 2 * tool.x, fold = BC.angle - AB.angle + 90deg,;"),
        "input x = (2 * tool.x), fold = ((BC.angle - AB.angle) + 90deg)"
    );
    assert_eq!(tree("input s = distance(F, G);"), "input s = distance(F, G)");
}

#[test]
fn mistakes_of_quantities() {
    check_statements(&[
        (
            "input x = tool.x, y;",
            ";: say what `y` is: `y = tool.x` / inputs of a kind, without a quantity, have a statement of their own",
        ),
        ("input x = ;", ";: expected a number or a name, found `;`"),
        (
            "input x = tool.x y = tool.y;",
            "y#1: expected `;`, found `y` / a product is written with `*`",
        ),
        (
            "input x = tool.x, y = tool.y, z: length;",
            ":: say what `z` is: `z = tool.x` / inputs of a kind, without a quantity, have a statement of their own",
        ),
        ("drive tip.x = x;", "tip: write `input x = tip.x;` / a `drive` gives an angle or a slide"),
        (
            "drive tip.y = 2 * s;",
            "tip: write `input q = tip.y;` / a `drive` gives an angle or a slide",
        ),
        (
            "drive distance(F, G) = s;",
            "distance: write `input s = distance(F, G);` / a `drive` gives an angle or a slide",
        ),
    ]);
}
