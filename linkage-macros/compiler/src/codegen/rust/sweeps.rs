//! Sweeps: an entry point on slices. The loop is the run-time crate's; what is generated says how
//! records of slices become lists of components, and lists of components records.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::context::Context;
use super::token_list::Tokens;
use super::{fast_path, results};
use crate::codegen::arguments::{Arguments, Form};
use crate::codegen::docs;
use crate::codegen::identifiers::{generated, used};
use crate::interface::EntryId;
use crate::interface::entries::Entry;
use crate::interface::records::Shape;
use crate::syntax::words::in_capitals;

/// `sweep_position` and its kin.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let sweeps: Vec<Sweep<'_>> = cx.entries().filter_map(|id| Sweep::of(cx, id)).collect();
    let (name, scalar, float) = (&cx.names.solver, &cx.names.scalar, cx.paths.item("Float"));
    let functions = sweeps.iter().map(Sweep::function);
    // The others are the solver's own.
    let implementations = sweeps.iter().filter(|sweep| !sweep.entry.is_a_stage());
    let implementations = implementations.map(Sweep::implementation);
    let functions: TokenStream = functions.collect();
    let functions = (!functions.is_empty())
        .then(|| quote!(impl<#scalar: #float> #name<#scalar> { #functions }));
    quote!(#functions #(#implementations)*)
}

/// `OfForwardDynamics` of `forward_dynamics`: the run-time type that stands for an entry point.
fn run_time_type(name: &str) -> String {
    format!("Of{}", in_capitals(name))
}

struct Sweep<'a> {
    cx: &'a Context<'a>,
    entry: &'a Entry,
    arguments: Arguments<'a>,
    /// The count of numbers that a pose takes.
    numbers: usize,
    /// The run-time type that stands for the entry point.
    kind: Tokens,
    /// The counts of numbers that a pose takes and gives.
    ins: Literal,
    outs: Literal,
}

impl<'a> Sweep<'a> {
    /// The sweep of an entry point, if it has one.
    fn of(cx: &'a Context<'a>, id: EntryId) -> Option<Self> {
        let entry = cx.entry(id);
        if !entry.point.row().sweeps || entry.takes_cosine() {
            return None;
        }
        let arguments = cx.signatures.arguments(&entry.given);
        let numbers = arguments.parts().map(|(_, form)| form.numbers()).sum();
        Some(Self {
            cx,
            entry,
            kind: cx.paths.item(&run_time_type(entry.name())),
            arguments,
            numbers,
            ins: Literal::usize_unsuffixed(numbers),
            outs: Literal::usize_unsuffixed(cx.interface.numbers(entry.result)),
        })
    }

    /// The public function.
    fn function(&self) -> TokenStream {
        let Self { cx, entry, kind, ins, outs, .. } = self;
        let scalar = &cx.names.scalar;
        let [series, status, progress, result, mismatch, sweep] =
            ["Series", "Status", "Progress", "Result", "LengthMismatch", "sweep"]
                .map(|item| cx.paths.item(item));
        let values = quote!(#series<'series, #scalar>);
        let [into, inputs] = ["Into", "Inputs"].map(|item| cx.paths.item(item));
        let (mut declared, mut converted) = (Vec::new(), TokenStream::new());
        for (name, form) in self.arguments.parts() {
            let ty = form.ty(&values);
            let given = match form {
                // The user converts each member of an array with `into()`.
                Form::List(_) => {
                    declared.push(quote!(#name: #ty));
                    continue;
                }
                Form::Record(..) => &inputs,
                Form::Number => &into,
            };
            declared.push(quote!(#name: impl #given<#ty>));
            // A list of series says what its members become.
            if let Form::Record(..) = form {
                converted.extend(quote!(let #name: #ty = #into::into(#name);));
            }
        }
        let inputs = self.inputs();
        let slices = results::ty(cx.interface, &cx.paths, entry.result, &quote!(&mut [#scalar]));
        let outputs = self.numbers_of(&quote!(out));
        let function = generated(&format!("sweep_{}", entry.name()));
        let docs = docs::sweep(cx.mechanism, cx.interface, entry);
        quote! {
            #docs
            pub fn #function<'series>(
                &self,
                #(#declared,)*
                out: #slices,
                status: &mut [#status],
                progress: impl #progress,
            ) -> #result<(), #mismatch> {
                #converted
                #sweep::<#kind, _, _, #ins, #outs>(
                    self, [#(#inputs),*], #outputs, status, progress,
                )
            }
        }
    }

    /// The entry point as the run-time crate's loop calls it.
    fn implementation(&self) -> TokenStream {
        let Self { cx, entry, kind, ins, outs, .. } = self;
        let (name, scalar, lane) = (&cx.names.solver, &cx.names.scalar, &cx.names.lifted);
        let [float, any, trait_, once, result, error] =
            ["Float", "Scalar", "Entry", "FnOnce", "Result", "SolveError"]
                .map(|item| cx.paths.item(item));
        let (core, method) = (fast_path::core_name(&cx.signatures, entry), generated(entry.name()));
        let locals: Vec<_> = self.numbered_locals();
        let arguments = self.call(&locals);
        let single = self.put_found(quote!(self.#method(#(#arguments),*)));
        let put = generated("put_");
        let (given, put_here, solved) = match cx.searches() {
            // Poses are searched one by one: the mask says no, and a single call follows.
            true => {
                let value = generated("result_");
                let nothing = quote!(let #value = #lane::num(0.0););
                (quote!(_), quote!(_), quote!(#nothing #lane::gt(#value, #value)))
            }
            false => {
                let answer = quote!(self.lift::<#lane>().#core(#(#arguments),*));
                (quote!([#(#locals),*]), quote!(#put), self.put_solved(answer))
            }
        };
        quote! {
            impl<#scalar: #float> #trait_<#kind, #scalar, #ins, #outs> for #name<#scalar> {
                #[inline(always)]
                fn solve<#lane: #any>(
                    &self,
                    #given: [#lane; #ins],
                    #put_here: impl #once(&[#lane]),
                ) -> #lane::Mask {
                    #solved
                }

                fn solve_one(
                    &self,
                    [#(#locals),*]: [#scalar; #ins],
                    #put: impl #once(&[#scalar]),
                ) -> #result<(), #error> {
                    #single
                }
            }
        }
    }

    /// A result as the list of its numbers.
    fn numbers_of(&self, result: &TokenStream) -> TokenStream {
        let as_array = self.cx.paths.item("Record");
        match self.entry.result {
            Shape::Number => quote!([#result]),
            Shape::List(_) => result.clone(),
            _ => quote!(#as_array::into_array(#result)),
        }
    }

    /// Puts the numbers of a fast path's answer; a list is one of numbers.
    fn put_solved(&self, answer: TokenStream) -> TokenStream {
        let [put, result, ok] = ["put_", "result_", "ok_"].map(generated);
        let helper = self.cx.paths.item("put_solved");
        match self.entry.result {
            Shape::List(_) => quote!(let (#result, #ok) = #answer; #put(&#result); #ok),
            _ => quote!(#helper(#answer, #put)),
        }
    }

    /// The same of an entry point's answer.
    fn put_found(&self, answer: TokenStream) -> TokenStream {
        let [put, result] = ["put_", "result_"].map(generated);
        let helper = self.cx.paths.item("put_found");
        match self.entry.result {
            Shape::List(_) => quote!(#answer.map(|#result| #put(&#result))),
            _ => quote!(#helper(#answer, #put)),
        }
    }

    /// The numbers of a pose, argument by argument.
    fn inputs(&self) -> Vec<TokenStream> {
        let into = self.cx.paths.item("Into");
        let of = |(name, form): (&Ident, Form<'_>)| match form {
            Form::Record(_, fields) => {
                fields.into_iter().map(used).map(|field| quote!(#name.#field)).collect()
            }
            Form::List(count) => {
                let index = (0..count).map(Literal::usize_unsuffixed);
                index.map(|index| quote!(#name[#index])).collect()
            }
            Form::Number => vec![quote!(#into::into(#name))],
        };
        self.arguments.parts().flat_map(of).collect()
    }

    fn numbered_locals(&self) -> Vec<Ident> {
        (0..self.numbers).map(|i| generated(&format!("x{i}_"))).collect()
    }

    /// The arguments of the single call, from as many locals as a pose has numbers.
    fn call(&self, locals: &[Ident]) -> Vec<TokenStream> {
        let mut rest = locals;
        let argument = |(_, form): (&Ident, Form<'_>)| {
            let (own, further) = rest.split_at(form.numbers());
            rest = further;
            match form {
                Form::Record(record, fields) => {
                    let fields = fields.into_iter().map(used);
                    quote!(#record { #(#fields: #own),* })
                }
                Form::List(_) => quote!([#(#own),*]),
                Form::Number => quote!(#(#own)*),
            }
        };
        self.arguments.parts().map(argument).collect()
    }
}
