//! What the pipeline makes of a declaration in several ways, read and derived once for all of them.

use super::parts;
use crate::diagnostics::{Diagnostic, Diagnostics};
use crate::exact::AtomScope;
use crate::model;
use crate::pipeline::{Options, code, placing, program, read, stub, text};
use proc_macro2::TokenStream;

/// The stub that the declaration would have if it had mistakes, its solver, and the solver of the same declaration
/// with `export c;` beside all that can be shown of it.
pub(super) fn all(source: &TokenStream) -> [TokenStream; 3] {
    let _atoms = AtomScope::begin();
    let mut diagnostics = Diagnostics::new();
    let (declaration, resolved) = read(source.clone(), &mut diagnostics);
    let mistakes: Vec<_> = diagnostics.into_mistakes().iter().map(Diagnostic::text).collect();
    let Some((declaration, Ok(mut mechanism))) = declaration.zip(resolved) else {
        panic!("{mistakes:?}\n{source}")
    };
    assert!(mistakes.is_empty(), "{mistakes:?}\n{source}");
    let (placing, program) = (placing(&mechanism), program(&mechanism));
    let solver = code(&mechanism, &program, None, &Options::NONE);
    mechanism.export_c = true;
    let text = text(&parts::exported(source));
    let exported = code(&mechanism, &program, Some((&placing, Some(&text))), &Options::PAGE);
    [stub(&declaration, &model::stub(&declaration), &Options::NONE), solver, exported]
}
