//! The inputs as text: a number, or the record of several.

use proc_macro2::Ident;

use crate::codegen::arguments::Signatures;
use crate::codegen::text::Text;
use crate::interface::Interface;

/// The type of the inputs, of numbers of this type.
pub(super) fn input_of(interface: &Interface, number: &str) -> String {
    match interface.input_record() {
        Some(record) => format!("{record}<{number}>"),
        None => number.to_string(),
    }
}

/// Values, rates or accelerations of the inputs, from a function of the place of each among all.
pub(super) fn of_numbers(signatures: &Signatures<'_>, number: &str, order: usize, to: &mut Text) {
    let first = order * signatures.mechanism.inputs.len();
    if signatures.interface.input_record().is_none() {
        to.put(&format!("{number}({first})"));
        return;
    }
    let mut places = first..;
    of_fields(signatures, to, |to, _| {
        let place = places.next().expect("there are as many as are asked for");
        to.put(&format!("{number}({place})"));
    });
}

/// The record of several inputs, of what is written for each.
pub(super) fn of_fields(
    signatures: &Signatures<'_>,
    to: &mut Text,
    mut write: impl FnMut(&mut Text, &Ident),
) {
    let record = signatures.interface.input_record().expect("there are several").to_string();
    to.put(&record).put(" { ").list(&signatures.mechanism.inputs, |to, input| {
        to.put(&input.name.to_string()).put(": ");
        write(to, &input.name);
    });
    to.put(" }");
}
