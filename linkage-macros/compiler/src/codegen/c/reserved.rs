//! Names that C, its compilers, its headers and the text that is printed take for themselves.
//!
//! A keyword is a name nowhere, and a macro is replaced wherever its name stands. What a header declares keeps its
//! name from other types alone: fields and arguments have scopes of their own.

use std::collections::HashSet;
use std::sync::LazyLock;

use crate::interface::quantity::Order;
use crate::interface::records::field_of_motion;

static WORDS: LazyLock<HashSet<&str>> = LazyLock::new(|| words(include_str!("reserved/words.txt")));

static DECLARED: LazyLock<HashSet<&str>> =
    LazyLock::new(|| words(include_str!("reserved/declared.txt")));

static FILES: LazyLock<HashSet<&str>> = LazyLock::new(|| words(include_str!("reserved/files.txt")));

/// The words of a text, in which a line may be a comment.
fn words(text: &'static str) -> HashSet<&'static str> {
    text.lines().filter(|line| !line.starts_with('#')).flat_map(str::split_whitespace).collect()
}

/// True if nothing can have the name: a keyword, a macro, or a type that stands among a record's fields, whose
/// meaning a field of its name would change in C++.
pub(super) fn is_word(name: &str) -> bool {
    WORDS.contains(name) || is_a_limit_of_a_numbered_type(name)
}

/// True for macros of <float.h> about types of C23: `DEC64_MAX`, `FLT32X_EPSILON`.
fn is_a_limit_of_a_numbered_type(name: &str) -> bool {
    let of_a_type = name.strip_prefix("FLT").or(name.strip_prefix("DEC"));
    let bits = of_a_type.and_then(|rest| rest.split_once('_')).map(|(bits, _)| bits);
    let is_numbered =
        bits.is_some_and(|bits| ["16", "32", "64", "128", "32X", "64X", "128X"].contains(&bits));
    // None of them has a tail.
    is_numbered && !name.ends_with('_')
}

/// True if no type can have the name.
pub(super) fn is_declared(name: &str) -> bool {
    is_word(name) || DECLARED.contains(name) || is_of_a_wide_type(name)
}

/// True for the functions of glibc by types of C23: `sinf128`, `strtof64x_l`, `lgammaf32_r`.
fn is_of_a_wide_type(name: &str) -> bool {
    let plain = ["_l", "_r"].iter().find_map(|end| name.strip_suffix(end)).unwrap_or(name);
    let ends = ["f16", "f32", "f64", "f128", "f32x", "f64x", "f128x"];
    ends.iter()
        .filter_map(|end| plain.strip_suffix(end))
        .any(|stem| DECLARED.contains(stem) || ["strto", "strfrom"].contains(&stem))
}

/// True if a name begins as functions of the run-time and of FMI do, and those that compute a model's variables.
pub(super) fn is_a_printed_function(name: &str) -> bool {
    ["linkage_", "fmi3", "evaluate_"].iter().any(|begin| name.starts_with(begin))
}

/// True if a name begins as those that C leaves to compilers and their headers: `__linux__`, `_Bool`.
pub(super) fn is_the_compilers(name: &str) -> bool {
    let second = name.strip_prefix('_').and_then(|rest| rest.chars().next());
    second.is_some_and(|letter| letter == '_' || letter.is_ascii_uppercase())
}

/// True if `#include` finds another file by the name, or a file cannot have it.
pub(super) fn is_file(stem: &str) -> bool {
    FILES.contains(stem)
}

/// True if an argument of the name would hide a function that is called beside it. The functions of a mechanism begin
/// with its stem.
pub(super) fn is_called(name: &str, stem: &str) -> bool {
    let action = name.strip_prefix(stem).and_then(|rest| rest.strip_prefix('_'));
    let is_function = |action: &str| {
        let begins = ["try_", "why_"].iter().any(|begin| action.starts_with(begin));
        let width = action.strip_prefix(field_of_motion(Order::Velocity));
        let is_told = ["origin", "input_labels", "output_labels", "drawn"].contains(&action);
        begins || is_told || width.is_some_and(|width| ["", "_f32"].contains(&width))
    };
    name.starts_with("linkage_") || action.is_some_and(is_function)
}
