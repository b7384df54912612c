//! The records that entry points take and return.

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use super::context::Context;
use super::module;
use super::paths::Paths;
use super::results::{self, read, ty};
use crate::codegen::docs;
use crate::codegen::identifiers::generated;
use crate::codegen::text::Text;
use crate::interface::quantity::Order;
use crate::interface::records::{Field, Record, RecordId, RecordKind, Shape};
use crate::interface::{Interface, labels};
use crate::model::mechanism::Mechanism;

/// All records of a mechanism, each for serde as well where they are to be serialised.
pub(super) fn definitions(cx: &Context<'_>, is_serialised: bool) -> TokenStream {
    let records = cx.interface.records.iter().filter(|record| cx.interface.is_used(record));
    let defined = |record: &Record| match is_serialised && serde_knows(record) {
        true => serialised(&cx.paths, &definition(cx, record)),
        false => definition(cx, record),
    };
    records.map(defined).collect()
}

/// True if serde implements its traits for every field: its arrays end at 32 elements.
fn serde_knows(record: &Record) -> bool {
    record.fields.iter().all(|field| match field.shape {
        Shape::List(count) => count <= 32,
        Shape::Matrix { rows, columns } => rows.max(columns) <= 32,
        Shape::Quantity(..) | Shape::Record(_) | Shape::Number => true,
    })
}

/// The record with serde's derives where the run-time crate has its feature `serde`.
fn serialised(paths: &Paths, definition: &TokenStream) -> TokenStream {
    let ([with_serde, serde], derive) =
        (["with_serde", "serde"].map(|item| paths.outside(item)), paths.outside("derive"));
    let path = serde.to_token_stream().to_string().replace(' ', "");
    quote! {
        #with_serde! {
            { #[#derive(#serde::Serialize, #serde::Deserialize)] #[serde(crate = #path)] }
            #definition
        }
    }
}

/// The implementations of the records: arrays, rows, and conversions from lists.
pub(super) fn implementations(cx: &Context<'_>) -> TokenStream {
    let implementation = |record: &Record| match record.kind {
        RecordKind::Inputs | RecordKind::Loads => from_list(cx, record),
        RecordKind::Outputs(order) => rows(cx, record, order),
        _ => TokenStream::new(),
    };
    let returned = cx.interface.record_ids().filter(|&id| cx.interface.is_used(cx.record(id)));
    let mut arrays = Text::long();
    returned.for_each(|id| as_array(cx, id, &mut arrays));
    let own = cx.interface.records.iter().map(implementation);
    [arrays.into_token_stream()].into_iter().chain(own).collect()
}

/// The attributes in front of every struct.
pub(super) fn attributes(mechanism: &Mechanism, paths: &Paths) -> TokenStream {
    let derives = paths.derives(&["Clone", "Copy", "Debug", "PartialEq"]);
    let layout = mechanism.export_c.then(|| quote!(#[repr(C)]));
    let allowed = module::allowed_outside(mechanism);
    quote!(#derives #layout #allowed)
}

fn definition(cx: &Context<'_>, record: &Record) -> TokenStream {
    let (name, scalar, visibility) =
        (&record.name, &cx.names.scalar, module::visibility_inside(cx.mechanism));
    let (docs, attributes) =
        (docs::record(cx.mechanism, record), attributes(cx.mechanism, &cx.paths));
    let fields = record.fields.iter().map(|field| {
        let (docs, name) = (docs::field(cx.mechanism, field), &field.name);
        let ty = ty(cx.interface, &cx.paths, field.shape, &quote!(#scalar));
        quote!(#docs pub #name: #ty)
    });
    let fields: Vec<_> = fields.collect();
    let float = cx.paths.outside("f64");
    // The fields of a motion are named by the compiler and stand on lines of their own: a comma ends each.
    let last = (record.kind == RecordKind::Motion).then(|| quote!(,));
    let named = matches!(record.kind, RecordKind::ForcesOf(_))
        .then(|| quote!(#[allow(non_camel_case_types, reason = "names are as declared")]));
    quote! {
        #docs
        #attributes
        #named
        #visibility struct #name<#scalar = #float> { #(#fields),* #last }
    }
}

/// `rows()`: the record as a list, in the order of `OUTPUTS`.
fn rows(cx: &Context<'_>, record: &Record, order: Order) -> TokenStream {
    let (name, scalar, count) = (&record.name, &cx.names.scalar, cx.rows());
    let (bound, as_array) = (cx.paths.item("Scalar"), cx.paths.item("Record"));
    let rows = match order {
        Order::Position => {
            let rows: Vec<String> = record.fields.iter().flat_map(rows_of).collect();
            let rows = Text::from(format!("[{}]", rows.join(", ")));
            quote!(#rows)
        }
        // A row a number: a direction turns at one rate.
        Order::Velocity | Order::Acceleration => quote!(#as_array::into_array(*self)),
    };
    let docs = docs::rows(order);
    quote! {
        impl<#scalar: #bound> #name<#scalar> {
            #docs
            #[inline]
            #[must_use]
            pub fn rows(&self) -> [#scalar; #count] { #rows }
        }
    }
}

/// The rows of an output: of a direction the angle, of anything else its components.
fn rows_of(field: &Field) -> Vec<String> {
    let Shape::Quantity(quantity, order) = field.shape else { return Vec::new() };
    let (name, layout) = (&field.name, quantity.layout(order));
    let angle = layout.parts.len() - layout.rows.len();
    let angle = (angle > 0).then(|| format!("self.{name}.angle()"));
    let rest = if angle.is_some() { &layout.parts[2..] } else { layout.parts };
    let rest = rest.iter().map(|part| read(&format!("self.{name}"), part));
    angle.into_iter().chain(rest).collect()
}

/// The conversion of a plain array into the record of several inputs or loads.
fn from_list(cx: &Context<'_>, record: &Record) -> TokenStream {
    let (name, scalar) = (&record.name, &cx.names.scalar);
    let count = Literal::usize_unsuffixed(record.fields.len());
    let [from, trait_] = ["From", "Record"].map(|item| cx.paths.item(item));
    let list = generated("list_");
    quote! {
        impl<#scalar> #from<[#scalar; #count]> for #name<#scalar> {
            #[inline]
            fn from(#list: [#scalar; #count]) -> Self { #trait_::from_array(#list) }
        }
    }
}

/// Each of them as an array of numbers.
fn as_array(cx: &Context<'_>, id: RecordId, to: &mut Text) {
    let (record, shape) = (cx.record(id), Shape::Record(id));
    let count = cx.interface.numbers(shape);
    let numbers: Vec<String> = (0..count).map(|i| format!("n{i}_")).collect();
    let mut pattern = Text::default();
    pattern.put("[").put(&numbers.join(", ")).put("]");
    let (mut taken, mut made) = (Text::default(), Text::default());
    let mut left = numbers.iter();
    let mut next = |to: &mut Text| {
        to.put(left.next().expect("a name each"));
    };
    match record.kind {
        RecordKind::Motion => {
            by_records(cx.interface, &cx.paths, record, [&mut taken, &mut made]);
            pattern = Text::from("list_".to_string());
        }
        // Lists are taken apart: what is indexed would have to be copied.
        RecordKind::Equations => {
            results::assemble(cx.interface, &cx.paths, shape, &mut made, &mut next);
            taken.put("let ").append(&made);
            taken.put(" = self; ").append(&pattern);
        }
        _ => {
            let components = results::components(cx.interface, shape, "self");
            taken.put("[").put(&components.join(", ")).put("]");
            results::assemble(cx.interface, &cx.paths, shape, &mut made, &mut next);
        }
    }
    let [trait_, str_] = ["Record", "str"].map(|item| cx.paths.written(item));
    let (name, scalar) = (&record.name, &cx.names.scalar);
    let array = format!("[{scalar}; {count}]");
    to.put(&format!("impl<{scalar}> {trait_} for {name}<{scalar}> {{ type Number = {scalar}; "));
    to.put(&format!("type Array = {array}; const LABELS: & 'static [& 'static {str_}] = &"));
    let labels = labels::of_record(cx.interface, cx.mechanism, id);
    to.put("[").list(labels, |to, label| {
        to.put(&format!("{label:?}"));
    });
    to.put("]");
    // Always inlined on the way out: lanes must stay in registers of their own instruction set.
    to.put(&format!("; #[inline(always)] fn into_array(self) -> {array} {{ ")).append(&taken);
    to.put(" } #[inline] fn from_array(").append(&pattern);
    to.put(&format!(": {array}) -> Self {{ ")).append(&made);
    to.put(" } }\n");
}

/// A record of records, to and from the numbers of all of them: taken apart and joined as lists, since
/// every number by a name of its own would cost rustc as much as a line of formulas.
fn by_records(
    interface: &Interface,
    paths: &Paths,
    record: &Record,
    [taken, made]: [&mut Text; 2],
) {
    let (trait_, joined) = (paths.written("Record"), paths.written("joined"));
    let names: Vec<String> = record.fields.iter().map(|field| field.name.to_string()).collect();
    let counts: Vec<usize> =
        record.fields.iter().map(|field| interface.numbers(field.shape)).collect();
    taken.put(&joined).put("(").list(&names, |to, name| {
        to.put(&trait_).put("::into_array(self.").put(name).put(")");
    });
    taken.put(")");
    for (nth, name) in names.iter().enumerate() {
        let passed = |counts: &[usize]| vec!["_".to_string(); counts.iter().sum()];
        let mut list = passed(&counts[..nth]);
        list.push(format!("{name}_ @ .."));
        list.extend(passed(&counts[nth + 1..]));
        made.put("let [").put(&list.join(", ")).put("] = list_;\n");
    }
    made.put("Self { ").list(&names, |to, name| {
        to.put(name).put(": ").put(&trait_).put("::from_array(").put(name).put("_)");
    });
    made.put(" }");
}
