//! Sweeps: an entry point on slices. The loop is the run-time crate's; what is generated says how
//! records of slices become lists of components, and lists of components records.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::arguments::{Arguments, Form};
use super::context::Context;
use super::identifiers::{function_name, generated};
use super::token_list::Tokens;
use super::{docs, fast_path, results};
use crate::interface::EntryId;
use crate::interface::entries::{EQUATIONS, Entry, FORWARD};
use crate::interface::records::Shape;

/// `sweep_position` and its kin.
pub(super) fn items(cx: &Context<'_>) -> TokenStream {
    let sweeps: Vec<Sweep<'_>> = cx.entries().filter_map(|id| Sweep::of(cx, id)).collect();
    let (name, scalar, float) = (&cx.names.solver, &cx.names.scalar, cx.paths.item("Float"));
    let (functions, implementations) =
        (sweeps.iter().map(Sweep::function), sweeps.iter().map(Sweep::implementation));
    let functions: TokenStream = functions.collect();
    let functions = (!functions.is_empty())
        .then(|| quote!(impl<#scalar: #float> #name<#scalar> { #functions }));
    quote!(#functions #(#implementations)*)
}

struct Sweep<'a> {
    cx: &'a Context<'a>,
    id: EntryId,
    entry: &'a Entry,
    arguments: Arguments<'a>,
    /// How many numbers a pose takes.
    numbers: usize,
    /// The run-time type that stands for the entry point.
    kind: Tokens,
    /// How many numbers a pose takes and gives.
    ins: Literal,
    outs: Literal,
}

impl<'a> Sweep<'a> {
    /// The sweep of an entry point, if it has one.
    fn of(cx: &'a Context<'a>, id: EntryId) -> Option<Self> {
        let entry = cx.entry(id);
        if !entry.sweeps {
            return None;
        }
        let kind = match entry.name {
            "position" => "OfPosition",
            "velocity" => "OfVelocity",
            "forces" => "OfForces",
            "statics" => "OfStatics",
            "energy" => "OfEnergy",
            FORWARD => "OfForwardDynamics",
            EQUATIONS => "OfEquationsOfMotion",
            _ => "OfMotion",
        };
        let arguments = Arguments::new(cx, entry.given);
        let numbers = arguments.parts().map(|(_, form)| form.numbers()).sum();
        Some(Self {
            cx,
            id,
            entry,
            kind: cx.paths.item(kind),
            arguments,
            numbers,
            ins: Literal::usize_unsuffixed(numbers),
            outs: Literal::usize_unsuffixed(cx.interface.numbers(entry.result)),
        })
    }

    /// What the user calls.
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
                // What stands in a list of series says what it is by `into()`.
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
        let slices = results::ty(cx, entry.result, &quote!(&mut [#scalar]));
        let outputs = self.numbers_of(&quote!(out));
        let function = function_name(&format!("sweep_{}", entry.name));
        let docs = docs::sweep(cx, self.id);
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
        let (name, scalar) = (&cx.names.solver, &cx.names.scalar);
        let [float, any, trait_, result, error] =
            ["Float", "Scalar", "Entry", "Result", "SolveError"].map(|item| cx.paths.item(item));
        let lane = &cx.names.lifted;
        let (core, method) = (fast_path::core_name(cx, entry), function_name(entry.name));
        let locals: Vec<_> = self.numbered_locals();
        let arguments = self.call(&locals);
        let single = self.numbers_in("numbers_or_error", quote!(self.#method(#(#arguments),*)));
        let (given, solved) = match cx.searches() {
            // Poses are searched one by one: the mask says no, and a single call follows.
            true => {
                let value = generated("result_");
                let nothing = quote!(let #value = #lane::num(0.0););
                (quote!(_), quote!(#nothing ([#value; #outs], #lane::gt(#value, #value))))
            }
            false => {
                let answer = quote!(self.lift::<#lane>().#core(#(#arguments),*));
                (quote!([#(#locals),*]), self.numbers_in("numbers_and_mask", answer))
            }
        };
        quote! {
            impl<#scalar: #float> #trait_<#kind, #scalar, #ins, #outs> for #name<#scalar> {
                #[inline(always)]
                fn solve<#lane: #any>(
                    &self,
                    #given: [#lane; #ins],
                ) -> ([#lane; #outs], #lane::Mask) {
                    #solved
                }

                fn solve_one(
                    &self,
                    [#(#locals),*]: [#scalar; #ins],
                ) -> #result<[#scalar; #outs], #error> {
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

    /// An answer that holds a result, holding the list of its numbers instead; a list is one.
    fn numbers_in(&self, convert: &str, answer: TokenStream) -> TokenStream {
        let convert = self.cx.paths.item(convert);
        match self.entry.result {
            Shape::List(_) => answer,
            _ => quote!(#convert(#answer)),
        }
    }

    /// The numbers of a pose, argument by argument.
    fn inputs(&self) -> Vec<TokenStream> {
        let into = self.cx.paths.item("Into");
        let of = |(name, form): (&Ident, Form<'_>)| match form {
            Form::Record(_, fields) => fields.iter().map(|field| quote!(#name.#field)).collect(),
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
                Form::Record(record, fields) => quote!(#record { #(#fields: #own),* }),
                Form::List(_) => quote!([#(#own),*]),
                Form::Number => quote!(#(#own)*),
            }
        };
        self.arguments.parts().map(argument).collect()
    }
}
