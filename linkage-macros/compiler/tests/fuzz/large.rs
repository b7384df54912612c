//! Declarations of a size that nobody writes by hand, but a script or a slip of one may: what can
//! be compiled is, on the smallest stack a compiler has, and what cannot is refused.

use std::fmt::Write;

use super::messages;
use crate::oracle::mechanism;
use crate::pipeline::Options;
use crate::{exact, pipeline};

/// The messages of a declaration that is compiled on a stack of so many KiB.
fn messages_on_stack(kib: usize, source: String) -> Vec<String> {
    let compile = move || {
        let tokens = source.parse().expect("these are tokens");
        messages(pipeline::compile(tokens, &Options::ALL).tokens)
    };
    let thread = std::thread::Builder::new().stack_size(kib << 10).spawn(compile);
    thread.expect("a thread can be started").join().expect("the compiler does not panic")
}

/// A crank turned by an expression of `q`, behind other statements.
fn crank(before: &str, angle: &str) -> String {
    format!(
        "struct S {{ input q: angle; param k: number = 2; {before}
         ground A(0, 0); crank AB(A) -> B {{ length: 1, angle: {angle} }} }}"
    )
}

/// Half of what a thread of Rust's has, in KiB: a server that expands macros for an editor starts
/// one for every declaration, and a compiler gives its own at least as much.
const STACK: usize = 1024;

#[test]
fn a_chain_is_as_long_as_its_source() {
    for (first, operation, count) in [
        ("q", " + q", 2000),
        ("q", " - 1e-3", 2000),
        ("q", " + k", 2000),
        ("q", " * k", 1000),
        ("1", " * q", 200),
        ("q", " / 2", 1000),
    ] {
        let angle = format!("{first}{}", operation.repeat(count));
        assert_eq!(messages_on_stack(STACK, crank("", &angle)), [""; 0], "{operation}");
    }
    let tip =
        "point P at (q * 1m, 0); output P, turned = ".to_string() + &"AB.angle + ".repeat(2000);
    let source = crank("", "q").replace('}', "") + "} " + &tip + "q; }";
    assert_eq!(messages_on_stack(STACK, source), [""; 0]);
}

#[test]
fn nesting_ends_before_the_stack_does() {
    let refused = "name a part of this expression with `let`\nit is nested more than 100 deep";
    for (before, after) in [
        ("(", ")"),
        ("q + 2 * (", ")"),
        ("-", ""),
        ("sin(", ")"),
        ("sqrt(1 + ", ")"),
        ("hypot(3, ", ")"),
    ] {
        let nested = |levels| format!("{}q{}", before.repeat(levels), after.repeat(levels));
        let compiled = |levels| messages_on_stack(STACK, crank("", &nested(levels)));
        // The braces of the mechanism and those of the group are levels as well.
        assert_eq!(compiled(97), [""; 0], "{before}");
        // Both arguments of a function may be too deep, once each.
        for messages in [compiled(101), compiled(5000)] {
            assert!(!messages.is_empty() && messages.iter().all(|m| m == refused), "{messages:?}");
        }
    }
}

#[test]
fn names_are_not_nested() {
    let mut lets = "let a0 = q; ".to_string();
    for i in 1..=1000 {
        write!(lets, "let a{i} = sqrt(a{} + 1); ", i - 1).expect("a string takes everything");
    }
    assert_eq!(messages_on_stack(STACK, crank(&lets, "a1000")), [""; 0]);
}

#[test]
fn a_chain_of_constants_is_as_long_as_its_source() {
    let mut lets = "let a0 = 1; ".to_string();
    for i in 1..=1000 {
        write!(lets, "let a{i} = sqrt(a{} + 1); ", i - 1).expect("a string takes everything");
    }
    assert_eq!(messages_on_stack(STACK, crank(&lets, "q + a1000")), [""; 0]);

    // Dyads on dyads, all of which stand still.
    let mut groups =
        "ground Z(0, 0); crank a0(Z) -> P0 { length: 100mm, angle: 1rad } ".to_string();
    for i in 1..=200 {
        let (x, before) = (i * 600, i - 1);
        write!(
            groups,
            "ground D{i}({x}mm, 0); rrr a{i}(P{before}), b{i}(D{i}) -> P{i}
             {{ lengths: (605mm, 300mm), mode: left }} "
        )
        .expect("a string takes everything");
    }
    assert_eq!(messages_on_stack(STACK, crank(&groups, "q")), [""; 0]);
}

#[test]
fn numbers_end_before_patience_does() {
    let refused = "a number of more than 1200 digits; write it rounded\n\
                   constants are exact: a product has the digits of both its factors";
    // Every line has twice the digits of the line before: the 64th power is the last that is kept.
    let squares = |first: &str, lines| {
        let mut lets = format!("let a0 = {first}; ");
        for i in 1..=lines {
            write!(lets, "let a{i} = a{0} * a{0}; ", i - 1).expect("a string takes everything");
        }
        messages_on_stack(STACK, crank(&lets, &format!("q + a{lines}")))
    };
    assert_eq!(squares("1.0000001", 6), [""; 0]);
    // The root keeps squares from being rational: 1 + 1e-9 sqrt(2), and a cosine that is nearly one.
    for first in ["1.0000001", "1 + 1e-9 * sqrt(2)", "cos(1e-5)", "pi / 3.14159"] {
        assert_eq!(squares(first, 30), [refused], "{first}");
    }
    let product = format!("q + 1{}", " * 1.1".repeat(2000));
    assert_eq!(messages_on_stack(STACK, crank("", &product)), [refused]);
    let digits = |count| format!("q + 0.{}", "7".repeat(count));
    assert_eq!(messages_on_stack(STACK, crank("", &digits(600))), [""; 0]);
    assert_eq!(messages_on_stack(STACK, crank("", &digits(1200))), [refused]);
}

#[test]
fn the_end_of_a_compilation_is_the_end_of_its_numbers() {
    for i in 1..=50 {
        let angle = format!("q + sqrt({i}.5) * 1rad + atan(sin({i}deg) / (sqrt(2) + {i}))");
        let tokens = crank("", &angle).parse().expect("these are tokens");
        assert_eq!(messages(pipeline::compile(tokens, &Options::ALL).tokens), [""; 0]);
        assert_eq!(exact::known_atoms(), 0);
        proc_macro2::extra::invalidate_current_thread_spans();
    }
    // Something was forgotten there.
    let _mechanism = mechanism(&crank("", "q + sqrt(1.5) * 1rad"));
    assert!(exact::known_atoms() > 0);
}
