//! Several sets of inputs of one machine: the struct of their parameters, and the ways from each set to the others.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use syn::ext::IdentExt;

use super::context::literal;
use super::module;
use super::paths::Paths;
use super::{solver, structs};
use crate::codegen::identifiers::{generated, text, used};
use crate::interface::Interface;
use crate::interface::carried_over::{Assembled, CarriedOver, PlaceInPose, SideLine};
use crate::model::mechanism::Mechanism;

/// A set of inputs, and the mechanism that it drives.
pub(crate) struct DrivenSet<'a> {
    pub set: &'a Ident,
    pub mechanism: &'a Mechanism,
}

impl DrivenSet<'_> {
    /// The type of its inputs.
    fn input(&self, scalar: &Ident) -> TokenStream {
        match Interface::of(self.mechanism).input_record() {
            Some(record) => quote!(#record<#scalar>),
            None => quote!(#scalar),
        }
    }

    fn solver(&self) -> Ident {
        used(&self.mechanism.name)
    }

    fn inputs_in_words(&self) -> String {
        let inputs = self.mechanism.inputs.iter().map(|input| format!("`{}`", text(&input.name)));
        inputs.collect::<Vec<_>>().join(", ")
    }
}

/// The struct of parameters under the declared name, and what leads from set to set. `shared` says which stretch two sets
/// have in common, a line each.
pub(crate) fn generate(
    name: &Ident,
    sets: &[DrivenSet<'_>],
    (shared, has_page): (&[String], bool),
) -> TokenStream {
    let Some(first) = sets.first() else { return TokenStream::new() };
    let records = sets
        .iter()
        .filter_map(|set| Interface::of(set.mechanism).input_record().map(ToString::to_string));
    let solvers = sets.iter().map(|set| set.mechanism.name.to_string());
    let own: Vec<_> = records.chain(solvers).chain([text(name)]).collect();
    let paths = Paths::beside(first.mechanism, own);
    let scalar = generated("T");
    let structure = structure(name, first.mechanism, (sets, shared), (&paths, &scalar));
    let parameters = parameters(name, first.mechanism, sets, (&paths, &scalar));
    let pairs = sets.iter().flat_map(|from| {
        let others = sets.iter().filter(|to| to.set != from.set);
        others.map(|to| pair(from, to, (&paths, &scalar))).collect::<Vec<_>>()
    });
    let page = has_page.then(|| page(name, sets, &paths));
    let import = paths.import_in_constant();
    // Records in the body of a function are seen from no module in it, so that none is made here.
    quote! {
        #structure
        #[allow(clippy::approx_constant, reason = "a drawn angle may be near a constant by chance")]
        const _: () = { #import #parameters #(#pairs)* #page };
    }
}

fn structure(
    name: &Ident,
    mechanism: &Mechanism,
    (sets, shared): (&[DrivenSet<'_>], &[String]),
    (paths, scalar): (&Paths, &Ident),
) -> TokenStream {
    let (visibility, allowed) = (&mechanism.visibility, module::allowed());
    let (own, attributes) = (&mechanism.docs, structs::attributes(mechanism, paths));
    let list = sets.iter().map(|set| {
        let (name, inputs) = (text(set.set), set.inputs_in_words());
        format!(" - [`{name}()`](Self::{name}): [`{}`], driven by {inputs}.", set.mechanism.name)
    });
    let lines = [" The parameters of one machine. Each set of inputs has a solver of them:", ""];
    // A line without a mark would go on in the list.
    let shared = shared.iter().flat_map(|line| [String::new(), line.clone()]);
    let lines = lines.map(str::to_string).into_iter().chain(list).chain(shared);
    let fields = solver::fields(mechanism, paths, scalar);
    let float = paths.outside("f64");
    quote! {
        #(#own)*
        #[doc = ""]
        #(#[doc = #lines])*
        #attributes
        #allowed
        #visibility struct #name<#scalar = #float> { #fields }
    }
}

/// `new`, `Default`, and the solvers.
fn parameters(
    name: &Ident,
    mechanism: &Mechanism,
    sets: &[DrivenSet<'_>],
    (paths, scalar): (&Paths, &Ident),
) -> TokenStream {
    let name = used(name);
    let new = solver::defaults(mechanism, paths, &quote!(#name), |wide, _| literal(wide));
    let default = solver::defaults(mechanism, paths, &quote!(Self), |wide, narrow| {
        quote!(#scalar::lit(#wide, #narrow)).into()
    });
    let [float, same_as, any, default_trait] =
        ["f64", "SameAs", "Scalar", "Default"].map(|item| paths.item(item));
    let solvers = sets.iter().map(|set| {
        let (set_name, solver) = (set.set, set.solver());
        let value =
            solver::construct(mechanism, paths, &quote!(#solver), solver::held, solver::held);
        let doc = format!(" The solver that is driven by {}.", set.inputs_in_words());
        quote! {
            #[doc = #doc]
            #[inline]
            #[must_use]
            pub fn #set_name(&self) -> #solver<#scalar> { #value }
        }
    });
    quote! {
        impl<#scalar> #name<#scalar> {
            /// The parameters at their declared values, in `f64`.
            #[inline]
            #[must_use]
            pub const fn new() -> #name<#float> where #float: #same_as<#scalar> { #new }
        }
        impl<#scalar: #any> #default_trait for #name<#scalar> {
            /// The parameters at their declared values, rounded once.
            #[inline]
            fn default() -> Self { #default }
        }
        impl<#scalar: #any> #name<#scalar> { #(#solvers)* }
    }
}

/// The page that is driven by one set or another.
fn page(name: &Ident, sets: &[DrivenSet<'_>], paths: &Paths) -> TokenStream {
    let Some((first, others)) = sets.split_first() else { return TokenStream::new() };
    let [with_page, page, float] = ["with_page", "Page", "f64"].map(|item| paths.item(item));
    let (machine, solver, set, called) = (text(name), first.solver(), first.set, text(first.set));
    let name = used(name);
    let others = others.iter().map(|other| {
        let (set, called) = (other.set, text(other.set));
        quote!(.or_set(#called, &self.#set()))
    });
    quote! {
        #with_page! {
            impl #name<#float> {
                /// A page on which the machine is dragged, with these parameters at first. One set of inputs drives it;
                /// a reader chooses which.
                #[must_use]
                pub fn page(&self) -> #page<#solver<#float>> {
                    #page::of_set(#machine, #called, &self.#set()) #(#others)*
                }
            }
        }
    }
}

/// The way from one set to another.
fn pair(
    from: &DrivenSet<'_>,
    to: &DrivenSet<'_>,
    (paths, scalar): (&Paths, &Ident),
) -> TokenStream {
    let carried = CarriedOver::between(from.mechanism, to.mechanism);
    let [here, there] = [from, to].map(DrivenSet::solver);
    let (input, count) =
        (from.input(scalar), Literal::usize_unsuffixed(from.mechanism.inputs.len()));
    let coordinates = carried.coordinates.iter().map(|place| place_of(paths, place));
    let sides = carried.sides.iter().map(|side| side_of(paths, side));
    let compared = carried.compared.iter().map(|(here, there, group)| {
        let [here, there] = [*here, *there].map(Literal::usize_unsuffixed);
        quote!((#here, #there, #group))
    });
    let other = solver::construct(to.mechanism, paths, &quote!(#there), solver::held, solver::held);
    let method = format_ident!("to_{}", to.set.unraw());
    let doc = format!(
        " The pose as one of [`{}`], on the assembly of the drawing: its inputs, and rates, efforts and inertias with them.",
        to.mechanism.name
    );
    let names = ["Real", "CarriesOver", "Place", "AssembledSide", "Transfer", "TransferError"];
    let [real, carries, place, side, transfer, error] = names.map(|item| paths.item(item));
    let [result, str_, usize_, into] =
        ["Result", "str", "usize", "Into"].map(|item| paths.item(item));
    let (given, q) = match from.mechanism.inputs.len() {
        1 => (quote!(#scalar), quote!(q)),
        _ => (quote!(impl #into<#input>), quote!(#into::into(q))),
    };
    quote! {
        impl<#scalar: #real> #carries<#there<#scalar>, #count> for #here<#scalar> {
            const COORDINATES: [#place; #count] = [#(#coordinates),*];
            const SIDES: &'static [#side] = &[#(#sides),*];
            const COMPARED: &'static [(#usize_, #usize_, &'static #str_)] = &[#(#compared),*];
            #[inline]
            fn other(&self) -> #there<#scalar> { #other }
        }
        impl<#scalar: #real> #here<#scalar> {
            #[doc = #doc]
            ///
            /// # Errors
            /// Those of `position`, and `OtherAssembly` where the other solver would find another pose.
            #[inline]
            pub fn #method(
                &self,
                q: #given,
            ) -> #result<#transfer<Self, #there<#scalar>, #count>, #error> {
                #transfer::new(*self, #q)
            }
        }
    }
}

fn place_of(paths: &Paths, found: &PlaceInPose) -> TokenStream {
    let place = paths.item("Place");
    match found {
        PlaceInPose::Input(input) => {
            let input = Literal::usize_unsuffixed(*input);
            quote!(#place::Input(#input))
        }
        PlaceInPose::Row(row, drawn) => {
            let row = Literal::usize_unsuffixed(*row);
            let drawn = match drawn {
                Some(drawn) => {
                    let (some, drawn) = (paths.item("Some"), literal(*drawn));
                    quote!(#some(#drawn))
                }
                None => {
                    let none = paths.item("None");
                    quote!(#none)
                }
            };
            quote!(#place::Row(#row, #drawn))
        }
        PlaceInPose::Fixed(value) => {
            let value = literal(*value);
            quote!(#place::Fixed(#value))
        }
    }
}

fn side_of(paths: &Paths, side: &Assembled) -> TokenStream {
    let [assembled, way] = ["AssembledSide", "Way"].map(|item| paths.item(item));
    let point = |point: &[PlaceInPose; 2]| {
        let [x, y] = point.each_ref().map(|place| place_of(paths, place));
        quote!([#x, #y])
    };
    let (group, from, pin, is_positive) =
        (&side.group, point(&side.from), point(&side.pin), side.is_positive);
    let line = match &side.line {
        SideLine::Towards(to) => {
            let to = point(to);
            quote!(#way::Towards(#to))
        }
        SideLine::Along([x, y]) => {
            let [x, y] = [literal(*x), literal(*y)];
            quote!(#way::Along([#x, #y]))
        }
    };
    quote! {
        #assembled {
            group: #group, from: #from, way: #line, pin: #pin, is_positive: #is_positive,
        }
    }
}
