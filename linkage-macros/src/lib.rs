//! The compiler behind `linkage-core`'s `mechanism!`.

mod codegen;
mod diagnostics;
mod equations;
mod exact;
mod ir;
mod model;
#[cfg(test)]
mod oracle;
mod passes;
mod pipeline;
mod syntax;

/// Declares a mechanism and generates its solver.
#[proc_macro]
pub fn mechanism(source: proc_macro::TokenStream) -> proc_macro::TokenStream {
    pipeline::compile(source.into()).into()
}
