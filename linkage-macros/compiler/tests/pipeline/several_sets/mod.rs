//! Every mistake in sets of inputs, at the tokens that were written and without a name that nobody wrote.

pub(crate) mod cuts;

use crate::diagnostics::told;
use crate::mistakes::proposals_are_read;
use crate::pipeline::{self, Options};

const FIVE_BAR: &str = "ground A(-50mm, 0), E(50mm, 0); pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm); \
                        link AB(A, B), BC(B, tool), CD(D, tool), ED(E, D);";
const MOTORS: &str = "input motors { a = AB.angle, b = ED.angle }";

fn mistakes(base: &str, statements: &str) -> String {
    let source = format!("pub struct FiveBar {{ {base} {statements} }}");
    let tokens = source.parse().expect("these are tokens");
    let output = pipeline::compile(tokens, &Options::ALL);
    let end = source.len() - " }".len();
    syn::parse2::<syn::File>(output.tokens).expect("a stub is Rust");
    told(&output.diagnostics, &source, end - statements.len()..end)
}

#[test]
fn mistakes_of_sets() {
    let rows = [
        ("input hand { x = tool.x, y = tool.y }", ""),
        (
            "input hand { x = tool.x }",
            "hand: `hand` drives 1 of 2 freedoms; name one more / `AB`, `BC`, `CD` and `ED` still move when every input is held",
        ),
        (
            "input hand { x = tool.x, y = tool.y, a }",
            "hand: `hand` drives more than the machine's freedoms / `AB`, `BC`, `tool` and the ground hold each other; leave out `x = tool.x` or `a = AB.angle`",
        ),
        (
            "input hand { x = tool.x, s = distance(A, B) }",
            "s = distance(A, B): `distance(A, B)` does not change / `AB` joins the two: leave it out, or write `AB.length`",
        ),
        (
            "input hand { x = tool.x, q = AB.angle * CD.angle }",
            "AB.angle * CD.angle: an input is one quantity of the machine, a factor before and a constant behind it / a factor stands in front of the quantity and a constant behind it: `2 * tip.y`, `shank.angle + 90deg`",
        ),
        (
            "input hand { x, y = tool.y }",
            "x: say what `x` is: `x = tool.x` / one of the sets that a coordinate is in says what it is",
        ),
        (
            "input hand { a = CD.angle, y = tool.y }",
            "a: `a` is `AB.angle` in `motors`; choose another name / a coordinate of several sets is one quantity",
        ),
        (
            "input hand { x = tool.x, x = tool.y }",
            "x#3: `x` is named twice; remove one / `hand` drives it once",
        ),
        (
            "input hand { x = tool.x y = tool.y }",
            "y#1: expected `,` or `}`, found `y` / a set is `{ x = tool.x, y = tool.y }`",
        ),
        ("input hand { x = , y = tool.y }", ",: expected a number or a name, found `,`"),
        ("input hand { }", "hand: say what `hand` drives: `input hand { x = tool.x }`"),
        (
            "input new { x = tool.x, y = tool.y }",
            "new: the name `new` is taken; choose another / each machine has a function `new`",
        ),
        (
            "input page { x = tool.x, y = tool.y }",
            "page: the name `page` is taken; choose another / each machine has a function `page`",
        ),
        (
            "input motors { x = tool.x, y = tool.y }",
            "motors: the name `motors` is taken; choose another / another set is called so",
        ),
        (
            "input hand { x = tol.x, y = tool.y }",
            "tol: no pin named `tol`; one with a similar name exists: `tool` / say where it is drawn: `pin tol(…, …);`",
        ),
        // Found with either set, in other words.
        (
            "input hand { x = BC.slide, y = tool.y }",
            "slide: `BC` does not slide / what slides is declared on a guide: `link BC(…) on GUIDE;`",
        ),
        (
            "input hand { x = tool.x, y = tool.y } input end { u = BC.angle, v = distance(B, D) }",
            "",
        ),
        (
            "input hand { x = tool.x, y = tool.y } link EF(E, B);",
            "before motors: `motors` drives more than the machine's freedoms / `AB`, `EF` and the ground hold each other; leave out `a = AB.angle`\nhand: `hand` drives more than the machine's freedoms / `AB`, `BC`, `EF`, `tool` and the ground hold each other; leave out `x = tool.x`",
        ),
        (
            "input hand { x = tool.x, y = tool.y } mass 1kg on tol;",
            "tol: no point named `tol`; a point with a similar name exists: `tool`",
        ),
        ("input hand { x = tool.x, y = tool.y } output twice = 2 * a, tool;", ""),
        (
            "input hand { x = tool.x, y = tool.y } guide g through (0, 0) along a; link r() on g; drive r.slide = 0;",
            "a: `g` has no place in the drawing / a guide goes through a point and along an angle or towards a point, on a link whose own guide does not stand on it",
        ),
        (
            "input hand { x = tool.x, B = tool.y }",
            "B: the name `B` is taken; choose another / `B` is a point",
        ),
        (
            "input hand { x = B.x, y = B.y }",
            "hand: `hand` drives more than the machine's freedoms / `AB`, `B` and the ground hold each other; leave out `x = B.x`\nhand: `hand` drives 2 of 3 freedoms; name one more / `BC`, `CD` and `ED` still move when every input is held",
        ),
        (
            "input hand { x = tool.x, y = tool.y } input k: length; link r(B, F) { length: k } link q(E, F); pin F(1, 1);",
            "",
        ),
        (
            "input hand { x = tool.x, y = tool.y } output tool, a.drive, x.drive; mass 1kg on tool;",
            "",
        ),
        (
            "input hand { x = tool.x, y = tool.y } point P on BC at (10mm * a, 0);",
            "a: `P` has no place in the drawing / its place on the link depends on an input, or on the point itself",
        ),
        ("input hand { x = tool.x, y = tool.y } crank AG(A) -> G { length: 10mm, angle: a }", ""),
        (
            "input hand { x = tool.x, y = tool.y } input theta: angle; crank AG(A) -> G { length: 10mm, angle: theta }",
            "",
        ),
    ];
    let mut other = String::new();
    for (statements, expected) in rows {
        let found = mistakes(&format!("{FIVE_BAR} {MOTORS}"), statements);
        proposals_are_read(&found);
        if found != expected {
            other += &format!("{statements}\nexpected:\n{expected}\nfound:\n{found}\n\n");
        }
    }
    assert!(other.is_empty(), "{other}");
}

/// The line about the stretch that two sets share, or nothing.
fn both_ways(source: &str) -> Vec<String> {
    let output = pipeline::compile(source.parse().expect("these are tokens"), &Options::ALL);
    assert!(output.diagnostics.is_empty(), "{source}: {:?}", output.diagnostics);
    let file = syn::parse2::<syn::File>(output.tokens).expect("it is Rust");
    let docs = file.items.iter().filter_map(|item| match item {
        syn::Item::Struct(item) => Some(&item.attrs),
        _ => None,
    });
    let lines = docs.flatten().filter_map(|attribute| match &attribute.meta {
        syn::Meta::NameValue(pair) => {
            Some(quote::ToTokens::to_token_stream(&pair.value).to_string())
        }
        _ => None,
    });
    let lines = lines.filter(|line| line.contains("Both ways"));
    lines.map(|line| line.trim_matches(['"', ' ']).to_string()).collect()
}

/// The stretches by their triangles: a crank and its slider between the dead points, a crank and its rocker between the
/// rocker's, where crank and coupler are in one line.
#[test]
fn two_sets_share_a_stretch() {
    // Dead points where sin θ = (−)e/(l ± r), x = √((l ± r)² − e²).
    let slider = "struct Press { ground A(0, 0); guide rail through (0, 10mm) along 0deg;
        pin B(30mm, 40mm), C(200mm, 10mm); link AB(A, B), BC(B, C), ram(C) on rail;
        input side { theta = AB.angle } input press { x = C.x } }";
    let (r, l, e) = (50.0, 170.0_f64.hypot(30.0), 10.0);
    let [far, near] = [l + r, l - r];
    let ends =
        [(e / far).asin(), std::f64::consts::PI - (-e / near).asin() - std::f64::consts::TAU];
    // The drawing has 53.13°: the next dead points are the far one below it, and the near one above, at 180° + asin e/(l − r).
    let above = (ends[1] + std::f64::consts::TAU).to_degrees();
    let [x_far, x_near] = [far, near].map(|of| (of * of - e * e).sqrt() / 1000.0);
    let expected = format!(
        "Both ways: `theta` from {}° to {}°, where `x` is from {} m to {} m.",
        (ends[0].to_degrees() * 100.0).round() / 100.0,
        (above * 100.0).round() / 100.0,
        (x_far * 1e4).round() / 1e4,
        (x_near * 1e4).round() / 1e4,
    );
    assert_eq!(both_ways(slider), [expected]);
    // A parameter is at its default; two freedoms, and a search, have no such line.
    let with_param =
        slider.replace("link AB(A, B),", "param arm = 50mm; link AB(A, B) { length: arm } link");
    let [line] = &both_ways(&with_param)[..] else { panic!("a line") };
    assert!(line.ends_with(" m, with the parameters as declared."), "{line}");
    assert!(
        both_ways(&format!(
            "struct M {{ {FIVE_BAR} {MOTORS} input hand {{ x = tool.x, y = tool.y }} }}"
        ))
        .is_empty()
    );
}
