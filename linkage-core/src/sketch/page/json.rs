//! Values as JavaScript writes them.

use core::fmt::Display;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

pub(super) fn string(text: &str) -> String {
    let mut quoted = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => quoted.extend(['\\', letter]),
            letter if letter < ' ' => quoted += &format!("\\u{:04x}", u32::from(letter)),
            letter => quoted.push(letter),
        }
    }
    quoted + "\""
}

pub(super) fn strings(texts: &[&str]) -> String {
    list(texts.iter().map(|text| string(text)))
}

/// Not a number and infinity have no literal.
pub(super) fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { "NaN".to_string() }
}

pub(super) fn list(values: impl IntoIterator<Item = impl Display>) -> String {
    let values: Vec<String> = values.into_iter().map(|value| value.to_string()).collect();
    format!("[{}]", values.join(","))
}

pub(super) fn object<const N: usize>(fields: [(&str, String); N]) -> String {
    let fields = fields.map(|(name, value)| format!("{name}:{value}"));
    format!("{{{}}}", fields.join(","))
}
