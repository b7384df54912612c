//! The formulas of an entry point: a `let` for every node, and a call at every condition and
//! angle. Whether a condition is marked or explained is up to the guard that is handed in.
//!
//! Position, velocity and motion share their formulas, which are most of what a mechanism expands
//! to: the order is a constant, and what a lower one does not need is never compiled for it.

use std::collections::HashSet;
use std::iter;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::blocks::{Statement, lay_out};
use super::body::{Body, Statements};
use super::names::{function_name, generated};
use super::pieces::Pieces;
use super::results::Order;
use super::{Context, entry, results};
use crate::ir::graph::{Check, GuardId, Id};
use crate::ir::liveness::{Course, unguarded};
use crate::ir::program::{Entry, EntryKind};

/// Position, velocity and motion of one kind of input: one function, which stops where nothing
/// more is asked for.
struct Family<'a>([&'a Entry; 3]);

impl<'a> Family<'a> {
    fn of(cx: &'a Context<'_>, kind: EntryKind) -> Option<Self> {
        let kinds = match kind {
            EntryKind::Position | EntryKind::Velocity | EntryKind::Motion => {
                [EntryKind::Position, EntryKind::Velocity, EntryKind::Motion]
            }
            EntryKind::PositionAt | EntryKind::VelocityAt | EntryKind::MotionAt => {
                [EntryKind::PositionAt, EntryKind::VelocityAt, EntryKind::MotionAt]
            }
            EntryKind::Coefficients | EntryKind::Margins => return None,
        };
        let [position, velocity, motion] = kinds.map(|kind| cx.entry(kind));
        Some(Self([position?, velocity?, motion?]))
    }

    fn motion(&self) -> &'a Entry {
        self.0[2]
    }

    fn name(&self) -> Ident {
        let at = entry::takes_cosine(self.motion().kind);
        function_name(if at { "formulas_at_" } else { "formulas_" })
    }
}

/// The entry point that leads the function in which the formulas of this one stand.
pub(super) fn leading<'a>(cx: &'a Context<'_>, entry: &'a Entry) -> &'a Entry {
    Family::of(cx, entry.kind).map_or(entry, |family| family.motion())
}

/// The functions that hold the formulas of all entry points.
pub(super) fn functions(cx: &Context<'_>) -> TokenStream {
    let own = cx.program.entries.iter().filter(|entry| cx.has_formulas(entry));
    own.filter_map(|entry| match Family::of(cx, entry.kind) {
        Some(family) if entry.kind == family.motion().kind => Some(of_family(cx, &family)),
        Some(_) => None,
        None => Some(of_one(cx, entry)),
    })
    .collect()
}

/// The result of an entry point under the guard.
pub(super) fn call(cx: &Context<'_>, entry: &Entry, guard: &Ident) -> TokenStream {
    let arguments = cx.arguments(entry.kind);
    let given = arguments.names();
    let Some(family) = Family::of(cx, entry.kind) else {
        let name = own_name(entry.kind);
        return quote!(self.#name(&mut #guard, #(#given),*));
    };
    let order = family.0.iter().position(|known| known.kind == entry.kind).unwrap_or_default();
    let (name, missing) = (family.name(), 2 - order);
    let order = Literal::usize_unsuffixed(order);
    let rest = standstill(cx, family.motion().kind);
    let rates = vec![generated("rest_"); missing];
    let call = quote!(self.#name::<#order>(&mut #guard, #(#given,)* #(#rates),*));
    match missing {
        0 => call,
        1 => quote!({ #rest #call.velocity }),
        _ => quote!({ #rest #call.position }),
    }
}

/// The rates of inputs that do not move.
fn standstill(cx: &Context<'_>, kind: EntryKind) -> TokenStream {
    let (rest, zero) = (generated("rest_"), cx.literal(0.0, 0.0));
    if !cx.arguments(kind).are_records() {
        return quote!(let #rest = #zero;);
    }
    let (record, fields) = (&cx.names.input, cx.mechanism.inputs.iter().map(|input| &input.name));
    quote!(let #rest = #zero; let #rest = #record { #(#fields: #rest),* };)
}

fn own_name(kind: EntryKind) -> Ident {
    function_name(&format!("formulas_{}_", entry::method(kind)))
}

fn of_one(cx: &Context<'_>, entry: &Entry) -> TokenStream {
    let arguments = cx.arguments(entry.kind);
    let bounds = cx.bounds.get(&entry.kind);
    let body = Body { cx, arguments: &arguments, course: Course::Careful, bounds };
    let statements = body.statements(&entry.sinks);
    let kept = body.locals(entry.sinks.iter().copied());
    let lines = lay_out(&statements.list, &kept, &cx.locals);
    let values = entry.sinks.iter().map(|&sink| body.value(sink)).collect();
    let value = results::assemble(cx, entry.kind, values);
    function(&body, entry, &own_name(entry.kind), &statements, &quote!(#lines #value))
}

/// Position, velocity and acceleration one after the other, each followed by its record. The
/// records of the orders that are not asked for hold zeros.
fn of_family(cx: &Context<'_>, family: &Family<'_>) -> TokenStream {
    let motion = family.motion();
    let arguments = cx.arguments(motion.kind);
    let bounds = cx.bounds.get(&motion.kind);
    let body = Body { cx, arguments: &arguments, course: Course::Careful, bounds };
    let (mut statements, mut done) = (Statements::default(), HashSet::new());
    let mut ends = Vec::new();
    for entry in family.0 {
        body.add_statements(&mut statements, &mut done, &entry.sinks);
        ends.push(statements.list.len());
    }
    let (mut lines, mut start, mut sinks) = (at_rest(cx), 0, &motion.sinks[..]);
    let result = motion_of_records(cx);
    for (nth, (order, end)) in Order::ALL.into_iter().zip(ends).enumerate() {
        let (now, later) = (&statements.list[start..end], &statements.list[end..]);
        let used_later = later.iter().flat_map(|statement| statement.uses.iter().copied());
        let kept: Vec<Id> = used_later.chain(body.locals(sinks.iter().copied())).collect();
        lines.extend(lay_out(now, &kept, &cx.locals));
        let (own, rest) = sinks.split_at(results::count(cx, order));
        let values = own.iter().map(|&sink| body.value(sink));
        let (name, record) = (record_name(order), results::record_of(cx, order, values));
        let nth = Literal::usize_unsuffixed(nth);
        let stop =
            (order != Order::Acceleration).then(|| quote!(if ORDER == #nth { return #result; }));
        lines.extend(quote!(let #name = #record; #stop));
        (start, sinks) = (end, rest);
    }
    let (name, ty) = (family.name(), cx.paths.item("usize"));
    let name = quote!(#name<const ORDER: #ty>);
    function(&body, motion, &name, &statements, &quote!(#lines #result))
}

fn record_name(order: Order) -> Ident {
    generated(&format!("{}_", order.field()))
}

/// The result, made of the locals that hold its records.
fn motion_of_records(cx: &Context<'_>) -> TokenStream {
    let fields = Order::ALL.map(|order| function_name(order.field()));
    let (name, records) = (&cx.names.motion, Order::ALL.map(record_name));
    quote!(#name { #(#fields: #records),* })
}

/// The records of the orders that may not be asked for.
fn at_rest(cx: &Context<'_>) -> TokenStream {
    let (zero, nought) = (generated("zero_"), cx.literal(0.0, 0.0));
    let records = [Order::Velocity, Order::Acceleration].map(|order| {
        let zeros = iter::repeat_n(Pieces::from(zero.clone()), results::count(cx, order));
        let (name, record) = (record_name(order), results::record_of(cx, order, zeros));
        quote!(let #name = #record;)
    });
    quote!(let #zero = #nought; #(#records)*)
}

/// The function that holds formulas.
///
/// Inlined always: as a call of its own it would hand its results over through memory, one more
/// time, which costs a four-bar's solve a tenth of its throughput and a fifth of its latency; and
/// a sweep would run it on the instruction set of the rest of the program.
fn function(
    body: &Body<'_>,
    entry: &Entry,
    name: &impl ToTokens,
    statements: &Statements,
    lines: &TokenStream,
) -> TokenStream {
    let (cx, scalar) = (body.cx, &body.cx.names.scalar);
    let unread = body.arguments.unread(&statements.leaves);
    let (result, received) =
        (entry::result(cx, entry.kind), body.arguments.received(&quote!(#scalar)));
    let (guard, guards) = (generated("guard_"), cx.paths.item("Guard"));
    let unguarded = (!statements.is_guarded).then(|| quote!(let _ = #guard;));
    quote! {
        #[inline(always)]
        fn #name(&self, #guard: &mut impl #guards<#scalar>, #(#received),*) -> #result {
            #unguarded
            #unread
            #lines
        }
    }
}

/// A condition as two calls: one that marks, unless bounds show that it is met, and one that
/// looks. The value goes on as that one returns it. What is compared with a spread that is not
/// known before run time is marked by that, and once more where bounds ask for more.
pub(super) fn condition(body: &Body<'_>, id: Id, value: Id, guard: GuardId) -> Statement {
    let (cx, condition) = (body.cx, body.graph().condition(guard));
    let looked_at = match condition.check {
        // These look at the value alone; the operands are there to be computed first.
        Check::Nonzero | Check::Positive(_) => &[],
        _ => &condition.operands[..],
    };
    let in_a_list =
        condition.check.has_spread() || matches!(condition.check, Check::ShareOfCentres);
    let look = function_name(match condition.check {
        Check::ReachCircles => "reach_circles",
        Check::ShareOfCentres => "share_of_centres",
        Check::ReachDistances => "reach_distances",
        Check::ReachLine => "reach_line",
        Check::ReachOffset => "reach_offset",
        Check::Nonzero => "nonzero",
        Check::Positive(_) => "positive",
        Check::Square if condition.operands.is_empty() => "square",
        Check::Square => "square_of_centres",
    });
    let group = &cx.program.groups[condition.group as usize];
    let length = match &condition.check {
        Check::Positive(name) => Some(name),
        _ => None,
    };
    let length = length.into_iter();
    let operands = [value].into_iter().chain(looked_at.iter().copied());
    let name = cx.locals.name(id);
    let (first, others) = (body.value(value), looked_at.iter().map(|&operand| body.value(operand)));
    let values =
        if in_a_list { quote!(#first, [#(#others),*],) } else { quote!(#first, #(#others,)*) };
    let spread = body.graph().spread(body.graph().node(id));
    let (guard, mark) = (generated("guard_"), mark(body, value, &condition.check, spread));
    let is_known = |spread| body.bounds.is_some() && body.graph().as_constant(spread).is_some();
    let above_rounding = spread.filter(|&spread| !is_known(spread)).map(|spread| {
        let (value, spread) = (body.value(value), body.value(spread));
        quote!(#guard.above_rounding(#value, #spread);)
    });
    Statement {
        defines: vec![id],
        uses: body.locals(operands),
        code: quote! {
            #mark
            #above_rounding
            let #name = #guard.#look(#values #group #(, #length)*);
        },
    }
}

/// The call that marks a condition; nothing where it is known to hold.
fn mark(body: &Body<'_>, value: Id, check: &Check, spread: Option<Id>) -> Option<TokenStream> {
    let cx = body.cx;
    let method = function_name(match check {
        Check::ShareOfCentres => return None,
        Check::Nonzero if body.is_above_zero(value) => return None,
        Check::ReachCircles | Check::ReachDistances | Check::Positive(_) => "above",
        Check::ReachLine | Check::ReachOffset | Check::Square => "at_least",
        Check::Nonzero => "away",
    });
    let least = match body.bounds {
        Some(bounds) => bounds.least(cx, unguarded(body.graph(), value), check, spread)?,
        None if *check == Check::Square => {
            let smallest = cx.scalar("smallest_square");
            quote!(#smallest()).into()
        }
        None if *check == Check::ReachLine => cx.literal(f64::MIN_POSITIVE, f32::MIN_POSITIVE),
        None if spread.is_some() => return None,
        None => cx.literal(0.0, 0.0),
    };
    let (guard, value) = (generated("guard_"), body.value(value));
    Some(quote!(#guard.#method(#value, #least);))
}
