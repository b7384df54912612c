//! Tests of `codegen/st/st_names`.

pub(crate) use linkage_compiler::codegen::st::st_names::*;

#[test]
fn what_the_language_or_a_vendor_has_is_renamed() {
    for (name, other) in [
        ("blade", "blade"),
        ("if", "v_if"),
        ("End_If", "v_End_If"),
        ("region", "v_region"),
        ("sizeof", "v_sizeof"),
        ("Title", "v_Title"),
        ("R", "v_R"),
        ("int_to_lreal", "v_int_to_lreal"),
        ("to_real", "v_to_real"),
        ("point_to_b", "point_to_b"),
        ("cos", "cosine"),
        ("sin", "sine"),
        ("Sin", "v_Sin"),
        ("linkage_det", "v_linkage_det"),
        ("_B", "B"),
        ("a__b_", "a_b"),
        ("_2", "v_2"),
        ("θ", "u03b8"),
        ("v_if", "v_if"),
    ] {
        assert_eq!(BlockNames::default().name(name), other, "{name}");
    }
}

#[test]
fn names_that_differ_by_case_or_underscores_alone_are_made_different() {
    let names =
        BlockNames::default().names(["blade", "Blade", "BLADE", "blade_", "v_blade", "if", "v_if"]);
    let other = ["blade", "v_Blade", "v_v_BLADE", "v_v_v_blade", "v_v_v_v_blade", "v_if", "v_v_if"];
    assert_eq!(names, other);
}

#[test]
fn a_text_holds_letters_of_one_byte_and_no_sign_of_the_language() {
    assert_eq!(quoted("BC, DC"), "'BC, DC'");
    assert_eq!(quoted("it's 5$ θ"), "'it s 5  ?'");
    assert_eq!(quoted(&"x".repeat(100)).len(), 82);
}
