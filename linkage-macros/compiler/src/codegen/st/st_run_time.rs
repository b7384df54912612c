//! The parts that the blocks of all mechanisms share: the types of results, and the functions of their formulas.
//!
//! A text is written once and printed for both types of numbers. Its constants are those of C.

use std::collections::BTreeMap;

use super::st_names::BlockNames;
use super::types::comment;
use crate::codegen::c::c_identifiers::Width;
use crate::codegen::c::provenance::{Prefix, VERSION};
use crate::codegen::c::run_time::spelling;
use crate::interface::quantity::{Order, Quantity};
use crate::syntax::words::in_capitals;

/// The text of `linkage_run.st`.
pub(super) fn source() -> String {
    let mut source = format!(
        "(* linkage_run.st: types and functions of the blocks that linkage {VERSION} has printed; once in a project.\n\n   \
         LREAL and REAL have to be rounded to 64 and 32 bits by each operation. Nothing is kept between calls.\n\n   \
         This text is yours: use, change and pass it on under any terms, with or without this notice. It comes\n   \
         without any warranty. *)\n"
    );
    for (width, near) in [
        (Width::Double, include_str!("run/sin_cos_f64.st")),
        (Width::Single, include_str!("run/sin_cos_f32.st")),
    ] {
        source += &types(width);
        let near = near.replace("    TURN\n", include_str!("run/turn.st"));
        let functions = one_by_one(&(of_width(include_str!("run/numbers.st"), width) + &near));
        for function in functions.split_inclusive("END_FUNCTION\n") {
            source += &typed(function, real(width));
        }
    }
    source
}

fn real(width: Width) -> &'static str {
    if width == Width::Single { "REAL" } else { "LREAL" }
}

/// The records of results, each once.
fn types(width: Width) -> String {
    let mut records = BTreeMap::new();
    for layout in Quantity::EVERY.iter().flat_map(|of| Order::ALL.map(|order| of.layout(order))) {
        if let Some(record) = layout.record {
            records.entry(record).or_insert(layout);
        }
    }
    let mut text = String::new();
    for (record, layout) in records {
        let name = width.shared_type_name(record);
        text += &format!("\n{}\nTYPE {name} :\nSTRUCT\n", comment(layout.words));
        let fields = BlockNames::default().names(layout.parts.iter().map(|part| part.field));
        for field in fields {
            text += &format!("    {field} : {};\n", real(width));
        }
        text += "END_STRUCT;\nEND_TYPE\n";
    }
    text
}

/// A text with the words of a width in the place of the general ones.
fn of_width(text: &str, width: Width) -> String {
    let is_narrow = width == Width::Single;
    let number = |word: &str| spelling(width, word).trim_end_matches('f').to_string();
    let [high_splitter, last_bit, smallest] = match is_narrow {
        false => ["4294967297.0", "4.76837158203125E-7", "2.2250738585072014E-308"],
        true => ["4097.0", "0.000244140625", "1.1754944E-38"],
    };
    let words = [
        ("ARC_SINE OF z", horner(spelling(width, "ARC_SINE"))),
        ("ARC_TANGENT OF z", horner(spelling(width, "ARC_TANGENT"))),
        ("HIGH_SPLITTER", high_splitter.to_string()),
        ("SPLITTER", number("SPLITTER")),
        ("LAST_BIT", last_bit.to_string()),
        ("SMALLEST", smallest.to_string()),
        ("EIGHTH_TURN", number("EIGHTH_TURN")),
        ("QUARTER_TURN", number("QUARTER_TURN")),
        ("QUARTER_LOW", with_point(&number("QUARTER_LOW"))),
        ("NUMBER", real(width).to_string()),
        ("@", if is_narrow { "_f32" } else { "" }.to_string()),
    ];
    words.iter().fold(text.to_string(), |text, (general, own)| text.replace(general, own))
}

/// A text with a line for each variable.
fn one_by_one(text: &str) -> String {
    let lines = text.lines().map(|line| match line.split_once(" : ") {
        Some((names, ty)) if line.starts_with("    ") => {
            let names = names.trim().split(", ");
            names.map(|name| format!("    {name} : {ty}\n")).collect()
        }
        _ => format!("{line}\n"),
    });
    lines.collect()
}

/// A polynomial by Horner's scheme, for coefficients from the lowest on.
fn horner(coefficients: &str) -> String {
    let numbers = coefficients.split(',').map(str::trim).filter(|number| !number.is_empty());
    let numbers: Vec<String> =
        numbers.map(|number| with_point(number.trim_end_matches('f'))).collect();
    let mut lines = String::new();
    for (nth, number) in numbers.iter().rev().enumerate() {
        lines += &match nth {
            0 => format!("total := {number};\n"),
            _ => format!("    total := total * z + {number};\n"),
        };
    }
    lines.trim_end().to_string()
}

/// A number of C as one of structured text: `1e-05` as `1.0E-05`, in parentheses where it begins with a sign.
fn with_point(number: &str) -> String {
    let number = match number.split_once('e') {
        Some((mantissa, exponent)) if mantissa.contains('.') => format!("{mantissa}E{exponent}"),
        Some((mantissa, exponent)) => format!("{mantissa}.0E{exponent}"),
        None => number.to_string(),
    };
    if number.starts_with('-') { format!("({number})") } else { number }
}

/// A function whose numbers are constants with a type. Zero is a literal.
fn typed(function: &str, real: &str) -> String {
    let Some(end) = function.rfind("END_VAR\n") else { return function.to_string() };
    let (declared, body) = function.split_at(end + "END_VAR\n".len());
    let (mut constants, mut text, mut rest) = (Vec::<String>::new(), String::new(), body);
    while let Some(first) = rest.chars().next() {
        let is_word = first.is_ascii_alphabetic();
        let is_number = first.is_ascii_digit();
        let length = match () {
            () if is_word => rest.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')),
            () if is_number => end_of_number(rest),
            () => Some(first.len_utf8()),
        };
        let (word, behind) = rest.split_at(length.unwrap_or(rest.len()));
        match is_number && word != "0.0" {
            false => text += word,
            true => {
                let known = constants.iter().position(|constant| constant == word);
                let nth = known.unwrap_or_else(|| {
                    constants.push(word.to_string());
                    constants.len() - 1
                });
                text += &format!("k{}", nth + 1);
            }
        }
        rest = behind;
    }
    if constants.is_empty() {
        return function.to_string();
    }
    let lines = constants.iter().enumerate();
    let lines = lines.map(|(nth, digits)| format!("    k{} : {real} := {digits};\n", nth + 1));
    format!("{declared}VAR CONSTANT\n{}END_VAR\n{text}", lines.collect::<String>())
}

fn end_of_number(text: &str) -> Option<usize> {
    let mut before = ' ';
    text.find(|letter: char| {
        let is_part = letter.is_ascii_digit()
            || matches!(letter, '.' | 'E')
            || before == 'E' && matches!(letter, '-' | '+');
        before = letter;
        !is_part
    })
}

/// A text with the prefix in front of the run-time's types and functions, and of its file.
pub(super) fn renamed(text: &str, prefix: &Prefix) -> String {
    let capitals = in_capitals(&prefix.in_front_of(""));
    if capitals.is_empty() {
        return text.to_string();
    }
    let is_of_a_name = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    let (mut made, mut rest, mut before) = (String::with_capacity(text.len()), text, ' ');
    while let Some(first) = rest.chars().next() {
        let starts = !is_of_a_name(before);
        match () {
            () if starts && rest.starts_with("linkage_") => made += &prefix.in_front_of(""),
            () if starts && rest.starts_with("Linkage") => made += &capitals,
            () => {}
        }
        made.push(first);
        before = first;
        rest = &rest[first.len_utf8()..];
    }
    made
}
