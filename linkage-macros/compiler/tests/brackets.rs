//! Tests of `brackets`.

pub(crate) use linkage_compiler::brackets::*;

#[test]
fn the_bracket_at_fault_is_named_at_its_place() {
    for (text, wanted) in [
        ("pin B(80mm, 0), C(1m, 2m;\n}", Some((17, "`(` is not closed"))),
        ("mechanism! { pub struct S { pin A(0, 0); }", Some((11, "`{` is not closed"))),
        ("ground A(0, 0)); }", Some((14, "`)` closes nothing"))),
        ("{ a [ ( ) }", Some((4, "`[` is not closed"))),
        ("]", Some((0, "`]` closes nothing"))),
        ("ä(", Some((2, "`(` is not closed"))),
        ("f(a(b[c]{d}))", None),
        // Brackets that are none.
        ("/// a (\n// )\n", None),
        ("/* ( /* [ */ { */ )", Some((18, "`)` closes nothing"))),
        (r#"f("(\"(", '(', '\'', b'[', "\\")"#, None),
        (r###"r"(\" r#"("[""# br##"{"# "## cr"(""###, None),
        (r##"(r#"(")"#"##, Some((0, "`(` is not closed"))),
        ("fn f<'a>(x: &'a str) { r#fn(", Some((27, "`(` is not closed"))),
        ("er\"(\" (", Some((6, "`(` is not closed"))),
        // Not closed, and no brackets.
        ("\"(", None),
        ("/* (", None),
        ("'", None),
        ("", None),
    ] {
        let found = unbalanced(text);
        let found = found.as_ref().map(|(at, why)| (at.start, &why[..]));
        assert_eq!(found, wanted, "{text}");
    }
}
