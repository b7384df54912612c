//! Tests of `codegen/c/provenance`.

pub(crate) use linkage_compiler::codegen::c::provenance::*;
use proc_macro2::Ident;

#[test]
fn a_prefix_is_words_of_letters_and_digits() {
    for text in ["acme", "Acme2", "acme_left_arm"] {
        assert!(Prefix::new(text).is_some(), "{text}");
    }
    for text in ["", "2x", "acme_", "_acme", "a__b", "a-b", "größe", "a b"] {
        assert!(Prefix::new(text).is_none(), "{text}");
    }
    let arm = Ident::new("Arm", proc_macro2::Span::call_site());
    let prefix = Prefix::new("acme_left").expect("it is one");
    assert_eq!(prefix.named(&arm), "AcmeLeftArm");
    assert_eq!(Prefix::default().named(&arm), "Arm");
}

#[test]
fn functions_and_files_of_the_run_time_are_renamed_alone() {
    let prefix = Prefix::new("acme").expect("it is one");
    for (before, after) in [
        ("x = linkage_sqrt(y);", "x = acme_linkage_sqrt(y);"),
        ("#include \"linkage_run.h\"\n", "#include \"acme_linkage_run.h\"\n"),
        ("to->linkage_x = a.linkage_x;", "to->linkage_x = a.linkage_x;"),
        ("name = \"linkage_x\\\"\"; linkage_why", "name = \"linkage_x\\\"\"; acme_linkage_why"),
        ("\"\\\\\"; linkage_why(\"linkage_\")", "\"\\\\\"; acme_linkage_why(\"linkage_\")"),
        ("#ifndef LINKAGE_WORDS", "#ifndef ACME_LINKAGE_WORDS"),
        ("my_linkage_x LINKAGE_OK LinkageWhy", "my_linkage_x LINKAGE_OK LinkageWhy"),
    ] {
        assert_eq!(prefix.put_into(before), after);
        assert_eq!(Prefix::default().put_into(before), before);
    }
}

#[test]
fn layout_and_comments_change_no_hash() {
    let of = |text: &str| hash(&text.parse().expect("these are tokens"));
    let plain = of("struct Crank { input t: angle; length: 2 }");
    assert_eq!(of("struct Crank {\n  // A crank.\n  input t : angle ; length:2 }"), plain);
    for other in [
        "struct Crank { input t: angle; length: 3 }",
        "struct Crank { input t: angle; length: 2.0 }",
        "struct Crank { input t: angle; } length: 2",
        "struct Crank ( input t: angle; length: 2 )",
        "struct Crank { input t: angle; -length: 2 }",
    ] {
        assert_ne!(of(other), plain, "{other}");
    }
}
