//! The statements of a routine, printed one by one.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use super::arguments::Arguments;
use super::context::Context;
use super::identifiers::{function_name, generated, text};
use super::token_list::Tokens;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::ir::graph::{Id, Node, Wanted};
use crate::ir::liveness::Path;
use crate::lower::routine::{Comparison, Condition, Reading, Routine, Statement, Threshold};
use crate::model::mechanism::{Numerics, ParamKind};

/// What the statements of one routine are printed with.
pub(super) struct Printer<'a> {
    pub cx: &'a Context<'a>,
    pub arguments: Arguments<'a>,
    pub routine: &'a Routine,
}

impl<'a> Printer<'a> {
    pub(super) fn new(cx: &'a Context<'a>, routine: &'a Routine) -> Self {
        Self { cx, arguments: Arguments::new(cx, routine.given), routine }
    }

    pub(super) fn statements(&self, statements: &[Statement]) -> TokenStream {
        Tokens::joined(statements.iter().map(|statement| self.statement(statement)))
            .into_token_stream()
    }

    fn statement(&self, statement: &Statement) -> Tokens {
        let stream = match statement {
            Statement::Let(id) => {
                return Tokens::bound(self.name(*id), self.expression(self.node(*id)));
            }
            Statement::SinCos { angle, sin, cos, is_checked } => {
                self.sin_cos(*angle, [*sin, *cos], *is_checked)
            }
            Statement::Check(condition) => self.condition(condition),
            Statement::Find { search, root, size } => self.find(*search, *root, *size),
            Statement::Scope { statements, hands_on } => {
                let names: Vec<Ident> = hands_on.iter().map(|&id| self.name(id)).collect();
                // A tuple, or the bare name of a single local.
                let pattern = match &names[..] {
                    [only] => quote!(#only),
                    _ => quote!((#(#names),*)),
                };
                let lines = self.statements(statements);
                quote!(let #pattern = { #lines #pattern };)
            }
        };
        stream.into()
    }

    /// The root of an equation, found by a function of its own.
    fn find(&self, search: usize, root: Id, size: Option<Id>) -> TokenStream {
        let search = &self.cx.lowered.searches[search];
        let (guard, function) = (generated("checks_"), function_name(&search.routine.name));
        let given = search.given.iter().map(|&id| self.value(id));
        let size = size.map_or(quote!(_), |size| {
            let size = self.name(size);
            quote!(#size)
        });
        let unknown = &self.cx.mechanism.unknowns[search.sought.unknown as usize];
        let unit = unit(unknown.measure, Order::Position);
        let (root, unknown) = (self.name(root), text(&unknown.name));
        if let Wanted::End(_) = search.sought.wanted {
            return quote!(let (#root, #size) = self.#function([#(#given),*]););
        }
        if self.routine.path == Path::Unchecked {
            let open = self.cx.paths.item("open");
            return quote!(let (#root, #size) = #open(self.#function([#(#given),*])););
        }
        quote!(let (#root, #size) = #guard.root(self.#function([#(#given),*]), #unknown, #unit);)
    }

    pub(super) fn name(&self, id: Id) -> Ident {
        generated(&self.routine.locals.name(id))
    }

    fn node(&self, id: Id) -> Node {
        self.cx.graph().node(id)
    }

    /// The expression that reads a node's value.
    pub(super) fn value(&self, id: Id) -> Tokens {
        self.read(&self.routine.reading(self.cx.graph(), id))
    }

    fn read(&self, reading: &Reading) -> Tokens {
        match reading {
            Reading::Leaf(node) => {
                self.arguments.read(*node).expect("a routine reads what it is given")
            }
            Reading::Constant(node) => self.constant(*node),
            Reading::Negated(inner) => self.read(inner).negated(),
            Reading::Local(id) => self.name(*id).into(),
        }
    }

    /// A constant as a number.
    fn constant(&self, node: Node) -> Tokens {
        let graph = self.cx.graph();
        match node {
            Node::Low(constant) => {
                let value = graph.value(constant);
                self.cx.literal(value.low_f64(), value.low_f32())
            }
            Node::Constant(constant) => {
                let value = graph.value(constant);
                self.cx.literal(value.to_f64(), value.to_f32())
            }
            _ => unreachable!("only constants are read as such"),
        }
    }

    /// `let (sine, cosine) = …;` of an angle.
    fn sin_cos(&self, angle: Id, pair: [Option<Id>; 2], is_checked: bool) -> TokenStream {
        let [sin, cos] = pair.map(|id| match id.map(|id| self.name(id)) {
            Some(name) => quote!(#name),
            None => quote!(_),
        });
        let value = self.value(angle);
        if is_checked {
            let guard = generated("checks_");
            let function = function_name(match self.cx.mechanism.numerics {
                Numerics::Fast => "sin_cos_fast",
                Numerics::Plain | Numerics::Compensated => "sin_cos",
            });
            quote!(let (#sin, #cos) = #guard.#function(#value);)
        } else {
            let function = self.cx.scalar("sin_cos");
            quote!(let (#sin, #cos) = #function(#value);)
        }
    }

    /// A condition as two calls: one that compares, unless it is known to hold, and one that
    /// diagnoses. What is compared with a spread is compared once more where limits ask for more. The value goes on as that one returns it.
    fn condition(&self, condition: &Condition) -> TokenStream {
        let (guard, name) = (generated("checks_"), self.name(condition.id));
        let value = self.value(condition.value);
        let comparison = condition.comparison.map(|(comparison, threshold)| {
            let method = function_name(match comparison {
                Comparison::Above => "above",
                Comparison::AtLeast => "at_least",
                Comparison::Away => "away",
            });
            let threshold = match threshold {
                Threshold::SmallestSquare => {
                    let smallest = self.cx.scalar("smallest_square");
                    quote!(#smallest()).into()
                }
                Threshold::Number(wide, narrow) => self.cx.literal(wide, narrow as f32),
            };
            quote!(#guard.#method(#value, #threshold);)
        });
        let diagnosis = function_name(condition.diagnosis);
        let above_rounding = condition.above_rounding.map(|spread| {
            let spread = self.value(spread);
            quote!(#guard.above_rounding(#value, #spread);)
        });
        let operands = condition.operands.iter().map(|&operand| self.value(operand));
        let operands = match condition.in_a_list {
            true => quote!([#(#operands),*],),
            false => quote!(#(#operands,)*),
        };
        let group = &self.cx.program().groups[condition.group as usize];
        if condition.diagnosis == "closed" {
            let size = condition.operands.iter().map(|&operand| self.value(operand));
            let unit = condition.word.iter();
            return quote!(#guard.closed(#value, #(#size,)* #group #(, #unit)*););
        }
        let length = condition.word.iter();
        quote! {
            #comparison
            #above_rounding
            let #name = #guard.#diagnosis(#value, #operands #group #(, #length)*);
        }
    }

    fn expression(&self, node: Node) -> Tokens {
        let call = |function: &str, operands: &[Id]| {
            Tokens::call(self.cx.scalar(function), operands.iter().map(|&id| self.value(id)))
        };
        let infix = |a, sign, b| Tokens::joined([self.value(a), Tokens::sign(sign), self.value(b)]);
        match node {
            Node::Neg(a) => self.value(a).negated(),
            Node::Add(a, b) => infix(a, '+', b),
            Node::Sub(a, b) => infix(a, '-', b),
            Node::Mul(a, b) => infix(a, '*', b),
            Node::Div(a, b) => infix(a, '/', b),
            Node::Sqrt(a) => call("sqrt", &[a]),
            Node::Tan(a) => call("tan", &[a]),
            Node::Asin(a) => call("asin", &[a]),
            Node::Acos(a) => call("acos", &[a]),
            Node::Atan(a) => call("atan", &[a]),
            Node::Atan2(y, x) => call("atan2", &[y, x]),
            Node::Hypot(a, b) => call("hypot", &[a, b]),
            Node::Det(operands) => call("det", &operands),
            Node::MulErr(a, b) => call("mul_err", &[a, b]),
            Node::AddErr(a, b) => call("add_err", &[a, b]),
            Node::Fused(a, b, c) => call("fused", &[a, b, c]),
            Node::Mode(param) => self.mode(param).into(),
            Node::Constant(_)
            | Node::Low(_)
            | Node::Input { .. }
            | Node::InputCos(_)
            | Node::InputSin(_)
            | Node::Param(_)
            | Node::Load(_)
            | Node::Drive(_)
            | Node::Sin(_)
            | Node::Cos(_)
            | Node::Trial(_)
            | Node::Root(_)
            | Node::Size(_)
            | Node::Guard(..) => unreachable!("read in place, or a statement of its own kind"),
        }
    }

    fn mode(&self, param: u32) -> TokenStream {
        let param = &self.cx.mechanism.params[param as usize];
        let ty = match param.kind {
            ParamKind::Sense { .. } => self.cx.paths.item("Sense"),
            ParamKind::Trend { .. } => self.cx.paths.item("Trend"),
            ParamKind::Side { .. } | ParamKind::Number { .. } => self.cx.paths.item("Side"),
        };
        let (field, scalar) = (&param.name, &self.cx.names.scalar);
        quote!(#ty::sign::<#scalar>(self.#field))
    }
}
