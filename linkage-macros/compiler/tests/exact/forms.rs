//! Structural equality, and the identities of roots and angles.

use core::cmp::Ordering;

use super::{Exact, defined, number, value};

#[track_caller]
fn assert_same(a: &str, b: &str) {
    assert_eq!(defined(a), defined(b), "`{a}` and `{b}`");
}

#[test]
fn sines_of_multiples_of_30_and_45_degrees() {
    let sines = [
        (0, "0"),
        (30, "0.5"),
        (45, "2 sqrt 2 div"),
        (60, "3 sqrt 2 div"),
        (90, "1"),
        (120, "3 sqrt 2 div"),
        (135, "2 sqrt 2 div"),
        (150, "0.5"),
        (180, "0"),
        (210, "0.5 neg"),
        (225, "2 sqrt 2 div neg"),
        (240, "3 sqrt 2 div neg"),
        (270, "1 neg"),
        (300, "3 sqrt 2 div neg"),
        (315, "2 sqrt 2 div neg"),
        (330, "0.5 neg"),
        (360, "0"),
    ];
    for (degrees, sine) in sines {
        for turns in [0, 1, 1000] {
            let angle = degrees + 360 * turns;
            assert_same(&format!("{angle} deg sin"), sine);
            assert_same(&format!("{angle} deg neg sin neg"), sine);
            assert_same(&format!("90 deg {angle} deg sub cos"), sine);
            assert_same(&format!("{angle} deg 90 deg sub cos"), sine);
        }
    }
}

#[test]
fn powers_and_logarithms_undo_each_other() {
    for (a, b) in [
        ("0 exp", "1"),
        ("1 ln", "0"),
        ("0 neg tanh", "0"),
        ("3 ln exp", "3"),
        ("2.5 exp ln", "2.5"),
        ("2.5 neg tanh", "2.5 tanh neg"),
        ("1.5 3 pow", "3.375"),
        ("2 neg 3 pow", "8 neg"),
        ("2 3 neg pow", "0.125"),
        ("pi 0 pow", "1"),
        ("2.25 1.5 pow", "3.375"),
        ("4 0.5 neg pow", "0.5"),
        ("2 0.5 pow", "2 sqrt"),
    ] {
        assert_same(a, b);
    }
    // An eighth root has no form of its own; its number is known all the same.
    assert_eq!(defined("256 0.125 pow").cmp_value(&Exact::integer(2)), Ordering::Equal);
    assert_eq!(defined("256 0.125 pow").to_f64(), 2.0);
    // The least normal number is above e^−709.
    assert_eq!(defined("700 neg exp").to_f64(), 9.859_676_543_759_77e-305);
    // Coarse enclosures of a small number hold zero, where there is no logarithm.
    assert_eq!(defined("1e-300 ln").to_f64(), -690.7755278982137);
    for undefined in ["701 exp", "701 neg exp", "0 ln", "2 neg ln", "2 neg 0.5 pow", "0 1 neg pow"]
    {
        assert_eq!(value(undefined), None, "{undefined}");
    }
    assert_eq!([value("0 0.3 pow"), value("2 65 pow"), value("3 400.5 pow")], [None, None, None]);
}

#[test]
fn tangents_of_multiples_of_30_and_45_degrees() {
    for (angle, tangent) in [("0", "0"), ("30", "1 3 sqrt div"), ("45", "1"), ("60", "3 sqrt")] {
        assert_same(&format!("{angle} deg tan"), tangent);
        assert_same(&format!("180 {angle} sub deg tan neg"), tangent);
        assert_same(&format!("{tangent} atan"), &format!("{angle} deg"));
        assert_same(&format!("{tangent} neg atan neg"), &format!("{angle} deg"));
    }
    assert_eq!(value("90 deg tan"), None);
    assert_eq!(value("270 deg neg tan"), None);
}

#[test]
fn sines_are_one_number_by_symmetry() {
    for same in ["20 deg neg cos", "70 deg sin", "110 deg sin", "160 deg cos neg", "430 deg sin"] {
        assert_same("20 deg cos", same);
    }
    for same in [
        "1 neg sin neg",
        "pi 1 sub sin",
        "90 deg 1 sub cos",
        "1 90 deg sub cos",
        "1 720 deg add sin",
    ] {
        assert_same("1 sin", same);
    }
    for same in
        ["20 deg 1 sub neg cos", "110 deg 1 sub sin", "380 deg 1 sub cos", "1 70 deg add sin"]
    {
        assert_same("20 deg 1 sub cos", same);
    }
    assert_ne!(defined("20 deg sin"), defined("20 deg cos"));
    assert_ne!(defined("20 deg sin"), defined("20 deg sin neg"));
    assert_ne!(defined("1 sin"), defined("1 cos"));
}

#[test]
fn angles_of_known_sines() {
    assert_same("0.5 asin", "30 deg");
    assert_same("0.5 neg acos", "120 deg");
    assert_same("2 sqrt 2 div asin", "45 deg");
    assert_same("3 sqrt 2 div neg acos", "150 deg");
    assert_same("1 acos", "0");
    assert_same("1 neg acos", "pi");
    assert_same("20 deg cos acos", "20 deg");
    assert_same("100 deg sin asin", "80 deg");
    assert_same("40 deg tan atan", "40 deg");
    assert_same("80 deg tan atan", "80 deg");
    assert_eq!(value("1.0000000000000000001 asin"), None);
    assert_eq!(value("2 sqrt neg acos"), None);
}

#[test]
fn atan2_in_every_direction() {
    let directions = [
        ("0", "1", "0"),
        ("1", "1", "45 deg"),
        ("2", "0", "90 deg"),
        ("3 sqrt", "1 neg", "120 deg"),
        ("0", "3 neg", "pi"),
        ("3 sqrt neg", "3 neg", "150 deg neg"),
        ("2 sqrt neg", "0", "90 deg neg"),
        ("1 neg", "3 sqrt", "30 deg neg"),
    ];
    for (y, x, angle) in directions {
        assert_same(&format!("{y} {x} atan2"), angle);
    }
    assert_eq!(value("0 0 atan2"), None);
    for angle in [20, 115, 180, 200, 300] {
        let principal = if angle > 180 { angle - 360 } else { angle };
        let expected = number("0").add(&Exact::integer(principal)).mul(&defined("1 deg"));
        let found = defined(&format!("{angle} deg sin 0.3 mul {angle} deg cos 0.3 mul atan2"));
        assert_eq!(found, expected, "{angle}°");
    }
}

#[test]
fn the_sine_of_an_angle_of_lengths_is_algebraic() {
    assert_same("5 12 atan2 sin", "5 13 div");
    assert_same("5 12 neg atan2 cos", "12 13 div neg");
    assert_same("5 neg 12 neg atan2 sin", "5 13 div neg");
    assert_same("0.28 acos sin", "0.96");
    assert_same("1 3 div asin cos", "8 sqrt 3 div");
    assert_same("1 3 div acos tan", "8 sqrt");
    assert_same("0.2 atan tan", "0.2");
}

#[test]
fn roots_are_reduced() {
    assert_same("4 9 div sqrt", "2 3 div");
    assert_same("8 sqrt", "2 2 sqrt mul");
    assert_same("0.5 sqrt", "2 sqrt 2 div");
    assert_same("2 sqrt 3 sqrt mul", "6 sqrt");
    assert_same("6 sqrt 10 sqrt mul", "2 15 sqrt mul");
    assert_same("1 3 sqrt div", "3 sqrt 3 div");
    assert_same("2 sqrt 2 sqrt mul", "2");
    assert_same("pi sqrt pi sqrt mul", "pi");
    assert_same("pi pi mul 4 mul sqrt", "2 pi mul");
    assert_same(
        "1 pi sub 1 pi sub mul 1 mul sqrt pi 1 sub mul",
        "1 pi sub 1 pi sub mul sqrt pi 1 sub mul",
    );
    assert_same("1 2 sqrt add sqrt 1 2 sqrt add sqrt mul", "1 2 sqrt add");
    assert_same("2 2 8 sqrt add mul sqrt", "4 2 sqrt 1 add mul sqrt");
    assert_same("1000000007 sqrt 5000000035 sqrt mul", "1000000007 5 sqrt mul");
    assert_same("1 sin 1 sin mul sqrt", "1 sin");
    assert_same("20 deg sin 0.3 mul 0 hypot", "20 deg sin 0.3 mul");
    assert_same("4 sin 4 sin mul sqrt", "4 sin neg");
    assert_same("20 deg sin 0.08 mul 20 deg cos 0.08 mul hypot", "0.08");
    assert_same("3 4 neg hypot", "5");
    assert_same("2 sqrt 0 hypot", "2 sqrt");
    assert_same("0 0 hypot", "0");
    assert_eq!(value("1 neg sqrt"), None);
    assert_eq!(value("1 2 sqrt sub sqrt"), None);
}

#[test]
fn sums_and_products_forget_how_they_were_made() {
    assert_same("1 sin 2 sqrt add pi add", "pi 1 sin add 2 sqrt add");
    assert_same("1 sin 2 sqrt mul pi mul", "pi 1 sin mul 2 sqrt mul");
    assert_same("1 sin 1 sin sub", "0");
    assert_same("1 sin 0.5 mul 1 sin 0.5 mul add", "1 sin");
    assert_same("1 sin 1 sin div", "1");
    assert_same("0 1 sin mul", "0");
    assert_same("1 1 sin mul", "1 sin");
    assert_same("1 sin neg neg", "1 sin");
    assert_same("1 pi add 2 2 pi mul add div", "0.5");
    assert_same("0.3 pi add 1 sin mul 1 sin div", "0.3 pi add");
    assert_same("1 sin 0.3 pi add div 0.3 pi add mul", "1 sin");
    assert_same("2 sqrt 1 add 2 sqrt 1 sub mul", "1");
    assert_same("1 sin 1 sin mul 1 cos 1 cos mul add", "1");
    assert_same("1 1 1 sin div div", "1 sin");
    assert_same("1 pi add 1 1 pi add div 1 add mul", "2 pi add");
}

#[test]
fn signs_and_order() {
    let less = [
        ("3 neg", "2.9 neg"),
        ("22 7 div neg", "pi neg"),
        ("2 sqrt 3 sqrt add", "pi 1e-2 add"),
        ("355 113 div 1e-6 sub", "pi"),
        ("3 sin", "0.1411200080598672221007448028081103"),
        ("1e-30 sin", "1e-30"),
        ("0", "1e-1000 sin"),
    ];
    for (a, b) in less {
        assert_eq!(defined(a).cmp_value(&defined(b)), Ordering::Less, "`{a}` and `{b}`");
        assert_eq!(defined(b).cmp_value(&defined(a)), Ordering::Greater, "`{a}` and `{b}`");
    }
    assert_eq!(defined("3 8 sqrt add sqrt 2 sqrt sub 1 sub").signum(), Ordering::Equal);
}

#[test]
fn what_the_form_hides_is_found_in_the_digits() {
    // √(3 + 2√2) = 1 + √2, and an addition theorem.
    let one = defined("3 8 sqrt add sqrt 2 sqrt sub");
    assert!(one.is_one() && !one.is_zero());
    assert_eq!(one.to_integer(), Some(1));
    let zero = defined("1 sin 2 cos mul 1 cos 2 sin mul add 3 sin sub");
    assert!(zero.is_zero() && !zero.is_one());
    assert_eq!(number("1").div(&zero), None);
    assert!(!zero.add(&number("1e-600")).is_zero());
}

#[test]
fn integers_that_fit() {
    assert_eq!(Exact::integer(i64::MIN).to_integer(), Some(i64::MIN));
    assert_eq!(Exact::integer(i64::MAX).add(&Exact::integer(1)).to_integer(), None);
    assert_eq!(number("2.5").to_integer(), None);
    assert_eq!(number("250e-1").to_integer(), Some(25));
    assert_eq!(Exact::pi().to_integer(), None);
    assert_eq!(number("1e30").mul(&Exact::pi()).to_integer(), None);
}

#[test]
fn a_number_is_told_from_the_integers_that_it_may_be() {
    let first = |text: &str| defined(text).first_of(&[0, 1, -1]);
    for (text, expected) in [
        ("0", Some(0)),
        ("1", Some(1)),
        ("1 neg", Some(2)),
        ("2", None),
        ("2 sqrt", None),
        ("90 deg sin", Some(1)),
        // Sums that no rule makes an integer.
        ("1 sin 1 sin mul 1 cos 1 cos mul add", Some(1)),
        ("1 sin 1 sin mul 1 cos 1 cos mul add 1 sub", Some(0)),
        // Nearer to one than the first enclosure can tell.
        ("2 sqrt 1e-30 mul 1 add", None),
    ] {
        assert_eq!(first(text), expected, "{text}");
    }
}
