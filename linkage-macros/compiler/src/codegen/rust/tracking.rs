//! The functions for following a motion through changes of mode: the clearance of every group, and the
//! parameter that holds its mode.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::context::{Context, numeric_params};
use super::in_rust::RustPrinter;
use super::input_records::{input_of, of_fields, of_numbers};
use super::paths::Paths;
use super::solver;
use crate::codegen::identifiers::generated;
use crate::codegen::text::Text;
use crate::interface::entries::ArgumentKind;
use crate::ir::program::Program;
use crate::lower::routine::Routine;
use crate::model::mechanism::{Mechanism, Param, ParamKind};

/// The count of groups with a clearance.
pub(super) fn count(program: &Program) -> usize {
    program.clearances.len()
}

/// The groups' titles, and the parameters that hold their modes.
pub(super) fn groups(program: &Program, paths: &Paths, to: &mut Text) {
    let [some, none] = ["Some", "None"].map(|name| paths.written(name));
    to.list(&program.clearances, |to, clearance| {
        let title = &program.groups[clearance.group as usize];
        to.put(&format!("({title:?}, "));
        match clearance.param {
            Some(param) => to.put(&format!("{some}({param}))")),
            None => to.put(&none).put(")"),
        };
    });
}

/// The mode that a parameter's number stands for becomes the other; nothing where none is a parameter.
pub(super) fn flips(mechanism: &Mechanism, paths: &Paths, to: &mut Text) {
    let modes = mechanism.params.iter().enumerate();
    let modes = modes.filter(|(_, param)| !matches!(param.kind, ParamKind::Number { .. }));
    let flips = modes.map(|(index, param)| {
        let field = &param.name;
        format!("{index} => self.{field} = self.{field}.flipped(), ")
    });
    let flips: String = flips.collect();
    if !flips.is_empty() {
        let size = paths.written("usize");
        to.put(&format!("#[inline] fn flip(&mut self, param_: {size}) "));
        to.put(&format!("{{ match param_ {{ {flips}_ => {{}} }} }}\n"));
    }
}

/// The groups' clearances, in the form that the trait requires. The routine of a pose computes them on its
/// way. A mechanism with an unknown has a routine of its own for them, which computes rates as well.
pub(super) fn clearances(cx: &Context<'_>, to: &mut Text) {
    told(cx, to);
    match cx.lowered.clearances {
        None => on_the_way(cx, to),
        Some(_) => {
            at_rest(cx, to);
            with_rates_asked(cx, to);
        }
    }
}

/// `told`, as far as the solver of other numbers that is asked.
fn told(cx: &Context<'_>, to: &mut Text) {
    let (scalar, lifted, count) = (&cx.names.scalar, &cx.names.lifted, count(cx.program()));
    let [real, copy, function, usize_] =
        ["Real", "Copy", "Fn", "usize"].map(|item| cx.paths.written(item));
    to.put(&format!("fn told<{lifted}: {real}, X_: {copy}>(&self, "));
    to.put(&format!("standing_: impl {function}({scalar}) -> {lifted}, "));
    to.put(&format!("input_: impl {function}({usize_}) -> {lifted}, "));
    to.put(&format!("of_: impl {function}([{lifted}; 2]) -> X_,) -> [X_; {count}] {{ "));
    if numeric_params(cx.mechanism).is_empty() {
        to.put("let _ = standing_; ");
    }
    let lift = |param: &Param| {
        let held = solver::held(param);
        quote!(standing_(#held))
    };
    let solver = &cx.names.solver;
    let lifted =
        solver::construct(cx.mechanism, &cx.paths, &quote!(#solver::<#lifted>), lift, solver::held);
    to.put(&format!("let lifted_ = {lifted};\n"));
}

/// A core without guards, as what is out of reach is a number below zero here, not a refusal.
pub(super) fn with_rates(cx: &Context<'_>) -> Option<TokenStream> {
    let routine = cx.lowered.clearances.as_ref()?;
    let arguments = cx.signatures.with_call_site_spans(&[ArgumentKind::Value, ArgumentKind::Rate]);
    let scalar = &cx.names.scalar;
    let (received, unread) =
        (arguments.received(&quote!(#scalar)), arguments.unread(&routine.reads));
    let (count, clearance) =
        (Literal::usize_unsuffixed(count(cx.program())), cx.paths.item("Clearance"));
    let body = listed(cx, routine);
    Some(quote! {
        fn clearances_(&self, #(#received),*) -> [#clearance<#scalar>; #count] { #unread #body }
    })
}

fn listed(cx: &Context<'_>, routine: &Routine) -> Text {
    let mut text = Text::long();
    let (printer, clearance) =
        (RustPrinter::beginning(cx, routine, &mut text), cx.paths.written("Clearance"));
    routine.stages.iter().for_each(|stage| printer.statements(&stage.statements, &mut text));
    let names = ["value", "scale", "rate", "second_rate"];
    text.put("[").list(&cx.program().clearances, |to, group| {
        to.put(&clearance).put(" { ");
        let fields = names.iter().zip(group.sinks());
        to.list(fields, |to, (name, sink)| printer.value(sink, to.put(name).put(": "))).put(" }");
    });
    text.put("]");
    text
}

/// Takes the clearances from the routine of a pose.
fn on_the_way(cx: &Context<'_>, to: &mut Text) {
    let Some(routine) = cx.lowered.routines.iter().find(|routine| routine.tells) else {
        to.put("let _ = (lifted_, input_, of_); [] }\n");
        return;
    };
    let (told, function) = (cx.paths.written("told"), generated(&routine.name));
    let turns = routine.given.first() == Some(&ArgumentKind::Cosine);
    if turns {
        to.put(&format!("let (sin_, cos_) = {}::sin_cos(", cx.names.lifted));
        of_numbers(&cx.signatures, "input_", 0, to);
        to.put("); ");
    }
    to.put("let rest_ = ");
    standstill(cx, to);
    let order = routine.stages.len();
    to.put(&format!("; {told}(|checks_| lifted_.{function}:: <{order}>(checks_, "));
    match turns {
        true => {
            to.put("cos_, sin_");
        }
        false => of_numbers(&cx.signatures, "input_", 0, to),
    }
    to.put(", rest_, rest_)).map(of_) }\n");
}

/// The rates of inputs that do not move.
fn standstill(cx: &Context<'_>, to: &mut Text) {
    let zero = format!("{}::num(0.0)", cx.names.lifted);
    match cx.interface.input_record() {
        None => {
            to.put(&zero);
        }
        Some(_) => of_fields(&cx.signatures, to, |to, _| {
            to.put(&zero);
        }),
    }
}

/// Takes the clearances from the routine with rates, with all rates zero.
fn at_rest(cx: &Context<'_>, to: &mut Text) {
    to.put("lifted_.clearances_(");
    of_numbers(&cx.signatures, "input_", 0, to);
    to.put(", ");
    standstill(cx, to);
    to.put(").map(|group_| of_([group_.value, group_.scale])) }\n");
}

/// The routine with rates, asked for them on numbers and on ranges.
fn with_rates_asked(cx: &Context<'_>, to: &mut Text) {
    let scalar = &cx.names.scalar;
    let clearance = cx.paths.written("Clearance");
    let (ty, none) = (input_of(cx.interface, &scalar.to_string()), cx.written(0.0, 0.0));
    to.put(&format!("fn clearances(&self, q_: {ty} , rate_: {ty}) "));
    to.put(&format!("-> Self::Groups<{clearance}<{scalar}>> {{ self.clearances_(q_, rate_) }}\n"));
    to.put(&format!("fn enclosures(&self, middle_: {ty} , radius_: {ty} , rate_: {ty} ,) "));
    to.put(&format!("-> Self::Groups<{clearance}<{scalar}::Enclosing>> "));
    to.put(&format!("{{ self.lift:: <{scalar}::Enclosing>().clearances_("));
    match cx.interface.input_record() {
        None => {
            to.put(&format!("middle_.enclosing(radius_), rate_.enclosing({none})"));
        }
        Some(_) => {
            of_fields(&cx.signatures, to, |to, field| {
                to.put(&format!("middle_.{field}.enclosing(radius_.{field})"));
            });
            to.put(", ");
            of_fields(&cx.signatures, to, |to, field| {
                to.put(&format!("rate_.{field}.enclosing({none})"));
            });
        }
    }
    to.put(") }\n");
}
