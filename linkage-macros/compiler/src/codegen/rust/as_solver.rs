//! `Solver`: what the run-time crate asks of a solver, once for all that it does with every mechanism.

use quote::quote;

use super::context::Context;
use super::input_records::{input_of, of_numbers};
use super::{fast_path, results, tracking};
use crate::codegen::identifiers::text;
use crate::codegen::text::Text;
use crate::interface::EntryId;
use crate::interface::entries::Analysis;

/// Nothing where not everything is offered that the trait asks for, as in some tests.
pub(super) fn items(cx: &Context<'_>) -> Text {
    let mut to = Text::long();
    let stages = Analysis::STAGES.map(|analysis| cx.interface.find(analysis.by_value()));
    let [Some(position), Some(velocity), Some(motion)] = stages else { return to };
    if !cx.interface.has(Analysis::Coefficients) {
        return to;
    }
    let by_order = [position, velocity, motion];
    let (solver, scalar) = (&cx.names.solver, &cx.names.scalar);
    let [trait_, real] = ["Solver", "Real"].map(|item| cx.paths.written(item));
    to.put(&format!("impl<{scalar}: {real}> {trait_} for {solver}<{scalar}> {{\n"));
    types(cx, by_order, &mut to);
    titles(cx, &mut to);
    if cx.searches() {
        to.put(&format!("const SEARCHES: {} = true;\n", cx.paths.written("bool")));
    }
    tracking::flips(cx.mechanism, &cx.paths, &mut to);
    input(cx, &mut to);
    entries(cx, by_order, &mut to);
    rows(&mut to);
    solve(cx, by_order, &mut to);
    follow(cx, by_order, &mut to);
    tracking::clearances(cx, &mut to);
    to.put("}\n");
    to
}

/// The type of an entry point's record.
fn record(cx: &Context<'_>, id: EntryId) -> String {
    let scalar = &cx.names.scalar;
    results::ty(cx.interface, &cx.paths, cx.entry(id).result, &quote!(#scalar)).to_string()
}

fn types(cx: &Context<'_>, entries: [EntryId; 3], to: &mut Text) {
    let (scalar, rows, columns) = (&cx.names.scalar, cx.interface.rows, cx.interface.columns);
    let [position, velocity, motion] = entries.map(|id| record(cx, id));
    let (input, groups) =
        (input_of(cx.interface, &scalar.to_string()), tracking::count(cx.program()));
    let copy = cx.paths.written("Copy");
    to.put(&format!("type Scalar = {scalar}; type Input = {input} ;\n"));
    to.put(&format!("type Position = {position} ; type Velocity = {velocity} ;\n"));
    to.put(&format!("type Motion = {motion} ; type Rows = [{scalar}; {rows}];\n"));
    to.put(&format!("type Coefficients = [[{scalar}; {columns}]; {rows}];\n"));
    to.put(&format!("type Groups<X_: {copy}> = [X_; {groups}];\n"));
}

fn titles(cx: &Context<'_>, to: &mut Text) {
    let solver = &cx.names.solver;
    let [titles, float] = ["Titles", "f64"].map(|item| cx.paths.written(item));
    to.put(&format!("const TITLES: {titles} = {titles} {{ name: {:?}, ", text(solver)));
    to.put(&format!("inputs: & {solver}:: <{float}> ::INPUTS, "));
    to.put(&format!("outputs: & {solver}:: <{float}> ::OUTPUTS, groups: &["));
    tracking::groups(cx.program(), &cx.paths, to);
    to.put("], };\n");
}

/// The input of its numbers.
fn input(cx: &Context<'_>, to: &mut Text) {
    let scalar = &cx.names.scalar;
    let [fn_mut, usize_] = ["FnMut", "usize"].map(|item| cx.paths.written(item));
    let ty = input_of(cx.interface, &scalar.to_string());
    to.put("#[inline] fn input(mut number_: impl ");
    to.put(&format!("{fn_mut}({usize_}) -> {scalar}) -> {ty} {{ "));
    of_numbers(&cx.signatures, "number_", 0, to);
    to.put(" }\n");
}

/// The entry points themselves.
fn entries(cx: &Context<'_>, entries: [EntryId; 3], to: &mut Text) {
    let (scalar, rows, columns) = (&cx.names.scalar, cx.interface.rows, cx.interface.columns);
    let input = input_of(cx.interface, &scalar.to_string());
    let [result, error] = ["Result", "SolveError"].map(|item| cx.paths.written(item));
    let [position, velocity, motion] = entries.map(|id| record(cx, id));
    let coefficients = format!("[[{scalar}; {columns}]; {rows}]");
    let given = ["q_", "rate_", "acceleration_"];
    for (name, orders, ty) in [
        ("position", 1, position),
        ("velocity", 2, velocity),
        ("motion", 3, motion),
        ("coefficients", 1, coefficients),
    ] {
        let given = &given[..orders];
        to.put(&format!("#[inline] fn {name}(&self, ")).list(given, |to, name| {
            to.put(name).put(": ").put(&input).put(" ");
        });
        to.put(&format!(") -> {result}<{ty} , {error}> {{ Self::{name}(self, "));
        to.put(&given.join(", ")).put(") }\n");
    }
}

/// Records as rows.
fn rows(to: &mut Text) {
    to.put("#[inline] fn position_rows(record_: Self::Position) -> Self::Rows ");
    to.put("{ record_.rows() }\n");
    to.put("#[inline] fn motion_rows(record_: Self::Motion) -> [Self::Rows; 3] ");
    let fields = ["position", "velocity", "acceleration"];
    to.put("{ [").list(fields, |to, field| {
        to.put(&format!("record_.{field}.rows()"));
    });
    to.put("] }\n");
}

/// The fast paths, as sweeps call them. Poses with an unknown are searched one by one: the mask says no,
/// and a single call follows.
fn solve(cx: &Context<'_>, entries: [EntryId; 3], to: &mut Text) {
    let lane = &cx.names.lifted;
    let [usize_, any, function, once] =
        ["usize", "Scalar", "Fn", "FnOnce"].map(|item| cx.paths.written(item));
    let [given, put] = if cx.searches() { ["_"; 2] } else { ["given_", "put_"] };
    to.put(&format!("#[inline(always)] fn solve<const ORDER: {usize_}, {lane}: {any}>(&self, "));
    to.put(&format!("{given}: impl {function}({usize_}) -> {lane}, "));
    to.put(&format!("{put}: impl {once}(&[{lane}]),) -> {lane}::Mask {{ "));
    if cx.searches() {
        to.put(&format!("let result_ = {lane}::num(0.0); {lane}::gt(result_, result_) }}\n"));
        return;
    }
    let put_solved = cx.paths.written("put_solved");
    to.put(&format!("let lifted_ = self.lift:: <{lane}>(); match ORDER {{ "));
    for (id, pattern) in entries.into_iter().zip(["0", "1", "_"]) {
        let entry = cx.entry(id);
        let core = fast_path::core_name(&cx.signatures, entry);
        to.put(&format!("{pattern} => {put_solved}(lifted_.{core}("));
        to.list(0..entry.given.len(), |to, order| of_numbers(&cx.signatures, "given_", order, to));
        to.put("), put_)");
        to.put(if pattern == "_" { " } }\n" } else { ", " });
    }
}

/// The fast paths of a sweep's poses, where something is searched by a seed.
fn follow(cx: &Context<'_>, entries: [EntryId; 3], to: &mut Text) {
    if entries.iter().any(|&id| fast_path::following(cx, id).is_none()) {
        return;
    }
    let scalar = &cx.names.scalar;
    let [usize_, function, once, seed, boolean, put_usable] =
        ["usize", "Fn", "FnOnce", "Seed", "bool", "put_usable"].map(|item| cx.paths.written(item));
    to.put(&format!("#[inline] fn follow<const ORDER: {usize_}>(&self, "));
    to.put(&format!(
        "seeds_: &mut [{seed}<{scalar}>], given_: impl {function}({usize_}) -> {scalar}, "
    ));
    to.put(&format!("put_: impl {once}(&[{scalar}]),) -> {boolean} {{ match ORDER {{ "));
    for (id, pattern) in entries.into_iter().zip(["0", "1", "_"]) {
        let entry = cx.entry(id);
        to.put(&format!("{pattern} => {put_usable}(self.{}(", fast_path::following_name(entry)));
        to.list(0..entry.given.len(), |to, order| of_numbers(&cx.signatures, "given_", order, to));
        to.put(", seeds_), put_)").put(if pattern == "_" { " } }\n" } else { ", " });
    }
}
