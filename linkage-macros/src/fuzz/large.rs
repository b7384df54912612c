//! Declarations of a size that nobody writes by hand, but a script or a slip of one may: what can
//! be compiled is, on the smallest stack a compiler has, and what cannot is refused.

use std::fmt::Write;

use super::messages;
use crate::pipeline;

/// The messages of a declaration that is compiled on a stack of so many KiB.
fn messages_on_stack(kib: usize, source: String) -> Vec<String> {
    let compile = move || {
        let tokens = source.parse().expect("these are tokens");
        messages(pipeline::compile(tokens))
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
    for (first, operation) in [
        ("q", " + q"),
        ("q", " + 1e-3"),
        ("q", " - k"),
        ("q", " * k"),
        ("q", " / 2"),
        ("1", " * q"),
    ] {
        let angle = format!("{first}{}", operation.repeat(2000));
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
