//! Declarations that parse, and their trees.

use super::{body, parsed};
use crate::syntax::tree::LetStatement;

/// The tree of statements that hold no mistake.
fn tree(statements: &str) -> String {
    let (tree, mistakes) = body(statements);
    assert_eq!(mistakes, "", "{statements}");
    tree
}

fn expression(text: &str) -> String {
    tree(&format!("let x = {text};")).replacen("let x = ", "", 1)
}

#[test]
fn a_flying_shear_parses_as_written() {
    let source = "
        /// Strip-mill flying shear.
        pub(crate) struct FlyingShear {
            input theta: angle;

            ground A(0, 0);
            ground D(665.7mm, 0);

            crank AB(A) -> B        { length: 80mm, angle: theta }
            rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }

            /// The upper blade.
            point blade on BC at (500mm, -60mm);
        }";
    let (tree, mistakes) = parsed(source);
    assert_eq!(mistakes, "");
    assert_eq!(
        tree.as_deref(),
        Some(
            "restricted FlyingShear
input theta: angle
ground A(0, 0)
ground D(665.7mm, 0)
crank AB(A) -> B { length: 80mm, angle: theta }
rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }
/// point blade on BC at (500mm, (-60mm))"
        )
    );
}

#[test]
fn every_statement_has_its_tree() {
    for statement in [
        "input s, x: length",
        "param l = 632mm",
        "param elbow: mode = left",
        "param phase: angle = 90deg",
        "let half = (l / 2)",
        "ground A(0, 0), D((l * 2), 0)",
        "guide rail through (0, 1) along 0deg",
        "guide axis through A towards D",
        "guide slot on BC through (1, 2) along 30deg",
        "guide slot on BC through P towards C",
        "point P on BC at (1, 2)",
        "point P at (s, x)",
        "point P on BC at polar (r, 20deg)",
        "point P on BC at distances (r1, r2) left",
        "output blade, DC.angle, ram.slide, fold = (BC.angle - DC.angle)",
        "output margin(BC, DC)",
        "numerics compensated",
        "crate = ::a::b",
        "crate = linkage_core",
        "export c",
    ] {
        assert_eq!(tree(&format!("{statement};")), statement);
    }
}

#[test]
fn every_group_has_its_tree() {
    for group in [
        "crank AB(A) -> B { length: 80mm, angle: theta, relative_to: BC }",
        "crank AB(A) { angle: ((-2) * theta) }",
        "slider ram(rail) -> P { slide: s, offset: 1mm }",
        "slider ram(rail) { slide: s }",
        "rrr BC(B), DC(D) -> C { lengths: (l1, l2), mode: left }",
        "rrp BC(B), block(rail) -> C { length: l, offset: e, mode: ahead }",
        "rpr block(B), bar(D) { offset: 0, mode: behind }",
        "prp p(rail1), q(rail2) -> C { offsets: (0, 1) }",
        "prp p(rail1), q(rail2) -> C {  }",
        "rpp block(B), yoke(rail) { slot: 90deg, offsets: (0, 0) }",
        // The model decides if such a group exists.
        "prr piston(rail), BC(B) -> C { length: l }",
        "triode a(A), b(B), c(C) { x: 1 }",
    ] {
        assert_eq!(tree(group), group);
    }
}

#[test]
fn lists_may_end_in_a_comma_and_braces_in_a_semicolon() {
    assert_eq!(
        tree(
            "input s, x,: length; ground A(0, 0,),; crank AB(A,), -> B { length: 1, };
             rrr a(A), b(B), -> C { lengths: (1, 2,), }; output a, b,;"
        ),
        "input s, x: length
ground A(0, 0)
crank AB(A) -> B { length: 1 }
rrr a(A), b(B) -> C { lengths: (1, 2) }
output a, b"
    );
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, expected) in [
        ("1 + 2 * 3 - 4", "((1 + (2 * 3)) - 4)"),
        ("8 / 4 / 2", "((8 / 4) / 2)"),
        ("a - b - c", "((a - b) - c)"),
        ("-a * b", "((-a) * b)"),
        ("a * -b", "(a * (-b))"),
        ("- -a", "(-(-a))"),
        ("-(a + b)", "(-(a + b))"),
        ("(1 + 2) * 3", "((1 + 2) * 3)"),
        ("-2 * theta + 15deg", "(((-2) * theta) + 15deg)"),
        ("ram.slide / 20mm", "(ram.slide / 20mm)"),
        ("atan2(y, -x,)", "atan2(y, (-x))"),
        ("sqrt(hypot(a, b) * pi)", "sqrt((hypot(a, b) * pi))"),
        ("BC.angle-DC.angle", "(BC.angle - DC.angle)"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn units_stand_behind_their_numbers() {
    for (text, expected) in [
        ("632mm", "632mm"),
        ("0.5m", "0.5m"),
        ("90deg", "90deg"),
        ("1e-3m", "1e-3m"),
        ("2in", "2in"),
        ("1_000.5mm", "1000.5mm"),
        ("5. + 1", "(5 + 1)"),
        ("0.25turn", "0.25turn"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn a_parenthesised_number_is_one_value_and_a_comma_makes_two() {
    assert_eq!(
        tree("g a(A) { x: (1 + 2) * 3, y: ((1), (2)) }"),
        "g a(A) { x: ((1 + 2) * 3), y: (1, 2) }"
    );
}

#[test]
fn fragments_of_other_macros_keep_their_precedence() {
    use proc_macro2::{Delimiter, Group, TokenStream};
    use quote::quote;

    let invisible = |tokens: TokenStream| Group::new(Delimiter::None, tokens);
    let visibility = invisible(quote!(pub));
    let (name, sum, literal) =
        (invisible(quote!(M)), invisible(quote!(a + b)), invisible(quote!(-5)));
    let source = quote! { #visibility struct #name { let x = 2 * #sum; let y = 1 - #literal; } };
    let mut diagnostics = crate::diagnostics::Diagnostics::new();
    let tree = super::parse(source, &mut diagnostics).expect("the declaration has a name");
    assert!(diagnostics.into_mistakes().is_empty());
    assert_eq!(super::text(&tree), "pub M\nlet x = (2 * (a + b))\nlet y = (1 - (-5))");
}

#[test]
fn spans_reach_from_the_first_to_the_last_token() {
    use super::tree::StatementKind;

    let source = "struct M { let x = 2 * (a + sqrt(b)) - BC.angle; }";
    let mut diagnostics = crate::diagnostics::Diagnostics::new();
    let tree = super::parse(source.parse().expect("tokens"), &mut diagnostics).expect("a name");
    let StatementKind::Let(LetStatement { value, .. }) = &tree.statements[0].kind else {
        panic!("no `let`")
    };
    diagnostics.error(value.span, "here");
    let told = crate::diagnostics::told(&diagnostics.into_mistakes(), source, 0..source.len());
    assert_eq!(told, "2 * (a + sqrt(b)) - BC.angle: here");
}

#[test]
fn units_are_multiplied_in_parentheses() {
    for (text, tree) in [
        ("15(N/m)", "15(N^1 m^-1)"),
        ("0.1(kg*m^2)", "0.1(kg^1 m^2)"),
        ("9.81(m/s^2)", "9.81(m^1 s^-2)"),
        ("2(1/s)", "2(s^-1)"),
        ("40(N*m/deg/s)", "40(N^1 m^1 deg^-1 s^-1)"),
        ("3(s^-1)", "3(s^-1)"),
        ("5(m)", "5m"),
        ("-5 (kN) * x", "((-5kN) * x)"),
    ] {
        assert_eq!(expression(text), tree, "{text}");
    }
}
