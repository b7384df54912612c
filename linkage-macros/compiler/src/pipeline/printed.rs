//! Solvers as texts of other languages: C99, structured text, and FMUs.

use proc_macro2::TokenStream;

use super::{assembly_export, program, understood};
use crate::codegen::c::provenance::{Prefix, Provenance, hash};
use crate::codegen::c::selection::Selection;
use crate::diagnostics::{Diagnostic, Diagnostics, Failure};
use crate::exact::AtomScope;
use crate::model::mechanism::Mechanism;
use crate::{codegen, lower};

/// A file of printed code.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct File {
    /// The name, without a folder.
    pub name: String,
    /// The whole text.
    pub text: String,
}

/// Prints the solver of a declaration as C99: its header, its source, and the run-time that all mechanisms
/// share. `only` names the entry points and widths to be printed, `motion_at` or `f32`; all of them where it names
/// none. A `prefix`, `acme`, stands in front of all names that a linker sees, the run-time's too: the solvers of two
/// suppliers, printed by two versions, stand in one program.
///
/// # Errors
/// The mistakes in the declaration, in the order of the source, names that are none, and a prefix that is none.
///
/// ```
/// let source = "pub struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2, angle: t } }";
/// let tokens = source.parse().expect("these are tokens");
/// let files = linkage_compiler::c(tokens, &["position"], None).expect("there is no mistake");
/// assert_eq!(files[1].name, "crank.c");
/// assert!(files[1].text.contains("LinkageStatus crank_position("));
/// ```
pub fn c(
    source: TokenStream,
    only: &[&str],
    prefix: Option<&str>,
) -> Result<Vec<File>, Vec<Diagnostic>> {
    let _atoms = AtomScope::begin();
    with_lowered(source, only, prefix, |lowered, selection, provenance| {
        let solver = codegen::c::generate(provenance.mechanism, lowered, selection, provenance);
        let lists = assembly_export::in_c(selection, provenance);
        Ok(files(solver.into_iter().chain(lists).collect()))
    })
}

/// Prints the fast path of a declaration as structured text of IEC 61131-3: its types and function blocks, and the
/// functions that all mechanisms share. `only` and `prefix` are those of [`c`]; sines and cosines are printed, or
/// `by_controller` the controller's.
///
/// # Errors
/// The mistakes in the declaration, in the order of the source, names that are none, a prefix that is none, and what
/// structured text has not: searches and friction.
///
/// ```
/// let source = "pub struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2, angle: t } }";
/// let tokens = source.parse().expect("these are tokens");
/// let files = linkage_compiler::st(tokens, &["position"], None, false).expect("there is no mistake");
/// assert_eq!(files[0].name, "crank.st");
/// assert!(files[0].text.contains("FUNCTION_BLOCK crank_position\n"));
/// ```
pub fn st(
    source: TokenStream,
    only: &[&str],
    prefix: Option<&str>,
    by_controller: bool,
) -> Result<Vec<File>, Vec<Diagnostic>> {
    let _atoms = AtomScope::begin();
    with_lowered(source, only, prefix, |lowered, selection, provenance| {
        let mechanism = provenance.mechanism;
        let printed =
            codegen::st::generate(mechanism, lowered, selection, provenance, by_controller);
        printed.map(files).map_err(|refusal| {
            let mut diagnostics = Diagnostics::new();
            diagnostics.error_because(mechanism.name.span(), refusal.why, refusal.because);
            let Failure(mistakes) = diagnostics.finish().expect_err("a mistake was told");
            mistakes
        })
    })
}

/// Prints the solver of a declaration as an FMU of FMI 3.0, for model exchange and for co-simulation: the description
/// of the model, and its sources. Where there is forward dynamics and not just kinematics is asked for, the inputs
/// and their rates are states.
///
/// # Errors
/// The mistakes in the declaration, in the order of the source.
pub fn fmu(source: TokenStream, is_kinematic: bool) -> Result<Vec<File>, Vec<Diagnostic>> {
    let _atoms = AtomScope::begin();
    with_lowered(source, &["f64"], None, |lowered, selection, provenance| {
        let mechanism = provenance.mechanism;
        let model = codegen::c::fmu::generate(mechanism, lowered, is_kinematic);
        let solver = codegen::c::generate(mechanism, lowered, selection, provenance);
        let in_sources = |(name, text)| (format!("sources/{name}"), text);
        Ok(files(model.into_iter().chain(solver.into_iter().map(in_sources)).collect()))
    })
}

fn files(texts: Vec<(String, String)>) -> Vec<File> {
    texts.into_iter().map(|(name, text)| File { name, text }).collect()
}

/// Texts made of the routines of a declaration, as far as they are selected.
fn with_lowered<T>(
    source: TokenStream,
    only: &[&str],
    prefix: Option<&str>,
    make: impl FnOnce(
        &lower::routine::Lowered<'_>,
        &Selection,
        &Provenance<'_>,
    ) -> Result<T, Vec<Diagnostic>>,
) -> Result<T, Vec<Diagnostic>> {
    let declaration = hash(&source);
    let (mut mechanism, _) = understood(source)?;
    let mut diagnostics = Diagnostics::new();
    let prefix = prefix_of(&mechanism, prefix, &mut diagnostics);
    let program = program(&mechanism);
    let selection = Selection::of(&mechanism, &program, only, &mut diagnostics);
    diagnostics.finish().map_err(|Failure(mistakes)| mistakes)?;
    mechanism.name = prefix.named(&mechanism.name);
    // The numbers of an entry point are the same whichever others are printed.
    let program = selection.apply(program);
    let lowered = lower::lower(&mechanism, &program);
    let provenance = Provenance { mechanism: &mechanism, declaration, prefix };
    make(&lowered, &selection, &provenance)
}

/// The prefix of this text, where there is one.
pub(super) fn prefix_of(
    mechanism: &Mechanism,
    text: Option<&str>,
    diagnostics: &mut Diagnostics,
) -> Prefix {
    let Some(text) = text else { return Prefix::default() };
    Prefix::new(text).unwrap_or_else(|| {
        diagnostics.error_because(
            mechanism.name.span(),
            format!("`{text}` is no prefix"),
            "it is letters and digits behind a letter, such as `acme` or `acme_left`".to_string(),
        );
        Prefix::default()
    })
}
