//! The inputs as text: a number, or the record of several.

use proc_macro2::Ident;

use crate::codegen::context::Context;
use crate::codegen::text::Text;

/// The type of the inputs, of numbers of this type.
pub(super) fn input_of(cx: &Context<'_>, number: &str) -> String {
    match cx.inputs() {
        Some(record) => format!("{record}<{number}>"),
        None => number.to_string(),
    }
}

/// Values, rates or second rates of the inputs, from a function of the place of each among all.
pub(super) fn of_numbers(cx: &Context<'_>, number: &str, order: usize, to: &mut Text) {
    let first = order * cx.mechanism.inputs.len();
    if cx.inputs().is_none() {
        to.put(&format!("{number}({first})"));
        return;
    }
    let mut places = first..;
    of_fields(cx, to, |to, _| {
        let place = places.next().expect("there are as many as are asked for");
        to.put(&format!("{number}({place})"));
    });
}

/// The record of several inputs, of what is written for each.
pub(super) fn of_fields(cx: &Context<'_>, to: &mut Text, mut write: impl FnMut(&mut Text, &Ident)) {
    let record = cx.inputs().expect("there are several").to_string();
    to.put(&record).put(" { ").list(&cx.mechanism.inputs, |to, input| {
        to.put(&input.name.to_string()).put(": ");
        write(to, &input.name);
    });
    to.put(" }");
}
