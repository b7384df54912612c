//! `Clone`, `Copy`, `Debug` and `PartialEq` of what is generated.
//!
//! What a derive writes takes every field into its hands, and costs the compiler more than many a
//! formula: a copy is one of the whole, and two records are equal where their numbers are.

use proc_macro2::TokenStream;
use quote::quote;

use super::context::Context;
use super::identifiers::text;
use super::module;
use super::text::Text;
use crate::interface::records::{Kind, Record, RecordId, Shape};

/// What stands in front of the solver, of which there is one: its number need not be `Copy`, so that a
/// struct of the user's may hold it and derive the same.
pub(super) fn in_front_of_solver(cx: &Context<'_>) -> TokenStream {
    attributes(cx, &["Clone", "Copy", "Debug", "PartialEq"])
}

/// What stands in front of a record.
pub(super) fn in_front_of_record(cx: &Context<'_>, record: &Record) -> TokenStream {
    let derived: &[&str] = if is_shown_by_shape(record) { &[] } else { &["Debug"] };
    attributes(cx, derived)
}

fn attributes(cx: &Context<'_>, derived: &[&str]) -> TokenStream {
    let derives = (!derived.is_empty()).then(|| cx.paths.derives(derived));
    let layout = cx.mechanism.export_c.then(|| quote!(#[repr(C)]));
    let allowed = module::allowed_outside(cx);
    quote!(#derives #layout #allowed)
}

/// The numbers of a matrix come column by column, and are shown row by row.
fn is_shown_by_shape(record: &Record) -> bool {
    record.kind != Kind::Equations
}

/// All that is not derived for a record.
pub(super) fn of_record(cx: &Context<'_>, id: RecordId) -> Text {
    let record = cx.record(id);
    let name = record.name.to_string();
    let mut code = copied(cx, &name);
    equal(cx, &name, &mut code);
    if is_shown_by_shape(record) {
        shown(cx, id, &mut code);
    }
    code
}

/// `Clone` and `Copy`.
fn copied(cx: &Context<'_>, name: &str) -> Text {
    let [clone, copy] = ["Clone", "Copy"].map(|item| cx.paths.written(item));
    let mut code = Text::default();
    implementation(cx, &[&copy], &clone, name, &mut code);
    code.put(" { #[inline] fn clone(&self) -> Self { *self } } ");
    implementation(cx, &[&copy], &copy, name, &mut code);
    code.put(" {} ");
    code
}

/// `PartialEq`: of the numbers, as of a list of them.
fn equal(cx: &Context<'_>, name: &str, code: &mut Text) {
    let [copy, equal, record, bool_] =
        ["Copy", "PartialEq", "Record", "bool"].map(|item| cx.paths.written(item));
    implementation(cx, &[&copy, &equal], &equal, name, code);
    code.put(" { #[inline] fn eq(&self, other_: &Self) -> ").put(&bool_).put(" { ");
    code.put(&record).put("::into_array(*self) == ").put(&record).put("::into_array(*other_) } } ");
}

/// `Debug`: the text of one that is derived, with places for the numbers.
fn shown(cx: &Context<'_>, id: RecordId, code: &mut Text) {
    let [copy, debug, shown, formatter, fmt] =
        ["Copy", "Debug", "debug", "Formatter", "fmt"].map(|item| cx.paths.written(item));
    implementation(cx, &[&copy, &debug], &debug, &cx.record(id).name.to_string(), code);
    code.put(" { fn fmt(&self, f_: &mut ").put(&formatter).put("<'_>) -> ").put(&fmt);
    code.put("::Result { ").put(&shown).put("(self, \"").put(&shape(cx, Shape::Record(id)));
    code.put("\", f_) } } ");
}

/// `impl<T: …> Trait for Name<T>`
fn implementation(cx: &Context<'_>, bounds: &[&str], trait_: &str, name: &str, code: &mut Text) {
    let scalar = cx.names.scalar.to_string();
    code.put("#[automatically_derived] impl<").put(&scalar).put(": ").put(&bounds.join(" + "));
    code.put("> ").put(trait_).put(" for ").put(name).put("<").put(&scalar).put("> ");
}

/// What `{:?}` shows of a result, with a `#` for each number.
fn shape(cx: &Context<'_>, of: Shape) -> String {
    let braced = |name: &str, fields: Vec<String>| format!("{name} {{ {} }}", fields.join(", "));
    match of {
        Shape::Number => "#".to_string(),
        Shape::List(count) => list("#", count),
        Shape::Matrix { rows, columns } => list(&list("#", columns), rows),
        Shape::Quantity(quantity, order) => {
            let layout = quantity.layout(order);
            let parts = layout.parts.iter().map(|part| format!("{}: #", part.field));
            layout.record.map_or("#".to_string(), |record| braced(record, parts.collect()))
        }
        Shape::Record(id) => {
            let record = cx.record(id);
            let fields = record.fields.iter();
            let fields = fields
                .map(|field| format!("{}: {}", text(&field.name), shape(cx, field.shape)))
                .collect();
            braced(&text(&record.name), fields)
        }
    }
}

fn list(item: &str, count: usize) -> String {
    format!("[{}]", vec![item; count].join(", "))
}
