//! START HERE: the phases in order, each with what is true after it.

pub mod assembly_export;
mod change_points;
mod common_range;
mod parsed;
mod planar_bodies;
mod printed;
pub mod several_sets;
mod transfers_in_c;
mod written_values;

pub use planar_bodies::{
    PlanarBodies, PlanarBody, PlanarGuide, PlanarInput, PlanarSpring, PlanarStop, planar_bodies,
};
pub use printed::{File, c, fmu, st};
pub use transfers_in_c::c_transfers;
pub use written_values::{WrittenValue, quantity};

use proc_macro2::{Span, TokenStream, TokenTree};

use crate::codegen::Drawing;
use crate::codegen::drawn_plan::PlanParts;
use crate::codegen::script::page::PageParts;
use crate::diagnostics::{Diagnostic, Diagnostics, Failure};
use crate::exact::AtomScope;
use crate::interface::Interface;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::ir::interpret::ProgramValues;
use crate::ir::posing::{Conditions, Placing, UnknownWords};
use crate::ir::program::Program;
use crate::model::Stub;
use crate::model::mechanism::{Mechanism, Param};
use crate::report::{self, Report, ReportOptions};
use crate::syntax::tree::Declaration;
use crate::{codegen, equations, lower, model, passes};

use parsed::{Parsed, parsed};

/// The parts that are generated beside the solver. The default is none.
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct Options {
    /// The program by which the mechanism is drawn, for the feature `sketch` of `linkage-core`.
    pub sketch: bool,
    /// The script of its page, for the feature `page` of `linkage-core`; needs `sketch`.
    pub page: bool,
    /// Records that serde writes and reads, for the feature `serde` of `linkage-core`.
    pub serde: bool,
}

impl Options {
    /// Nothing beside the solver.
    pub const NONE: Self = Self { sketch: false, page: false, serde: false };
    /// The solver, what it is drawn by, and its page.
    pub const PAGE: Self = Self { sketch: true, page: true, serde: false };
    /// All that can be generated.
    pub const ALL: Self = Self { sketch: true, page: true, serde: true };
}

/// Generated code and mistakes.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Output {
    /// The solver. After a mistake, a compile error for each beside a stub of the solver, so that
    /// one mistake gives one message.
    pub tokens: TokenStream,
    /// The mistakes in the order of the source; none where the solver is complete.
    pub diagnostics: Vec<Diagnostic>,
    /// The remarks on a complete solver, in the order of the source. They are no part of the tokens.
    pub notes: Vec<Diagnostic>,
}

/// Compiles the declaration of a mechanism, the tokens between the braces of `mechanism! { … }`.
///
/// ```
/// let source = "pub struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2, angle: t } }";
/// let tokens = source.parse().expect("these are tokens");
/// let output = linkage_compiler::compile(tokens, &linkage_compiler::Options::default());
/// assert!(output.diagnostics.is_empty());
/// assert!(output.tokens.to_string().contains("struct Crank"));
/// ```
pub fn compile(source: TokenStream, options: &Options) -> Output {
    // The numbers of one declaration are not those of the next.
    let _atoms = AtomScope::begin();
    let mut diagnostics = Diagnostics::new();
    let parsed = parsed(source.clone(), &mut diagnostics);
    if let Some(sets) = parsed.as_ref().filter(|parsed| parsed.means_all_sets()) {
        return several_sets::compile(sets, (&source, options), diagnostics);
    }
    let declaration = parsed.map(Parsed::driven);
    let resolved = declaration.as_ref().map(|tree| resolved(tree, &mut diagnostics));
    let notes = diagnostics.take_notes();
    match (resolved, diagnostics.finish()) {
        (Some(Ok(mechanism)), Ok(())) => {
            let text = options.page.then(|| text(&source));
            let tokens = solver(&mechanism, text.as_deref(), options);
            Output { tokens, diagnostics: Vec::new(), notes }
        }
        (resolved, Err(Failure(diagnostics))) => {
            let errors = diagnostics.iter().map(Diagnostic::compile_error);
            let understood = declaration.as_ref().zip(resolved.and_then(Result::err));
            let stub = understood
                .map(|(declaration, Stub(mechanism))| stub(declaration, &mechanism, options));
            Output { tokens: errors.chain(stub).collect(), diagnostics, notes: Vec::new() }
        }
        (_, Ok(())) => unreachable!("a phase that gives nothing has reported why"),
    }
}

/// The mistakes in a declaration in the order of the source; the remarks on one without. They are those of [`compile`],
/// and no code is made.
///
/// ```
/// let source = "pub struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2, angle: u } }";
/// let told = linkage_compiler::check(source.parse().expect("these are tokens"));
/// assert_eq!(told[0].message, "nothing is named `u`");
/// ```
pub fn check(source: TokenStream) -> Vec<Diagnostic> {
    let _atoms = AtomScope::begin();
    let mut diagnostics = Diagnostics::new();
    match parsed(source, &mut diagnostics) {
        Some(sets) if sets.means_all_sets() => {
            several_sets::resolved_all(&sets, &mut diagnostics);
        }
        Some(one) => {
            let _ = resolved(&one.driven(), &mut diagnostics);
        }
        None => {}
    }
    let notes = diagnostics.take_notes();
    diagnostics.finish().map_or_else(|Failure(mistakes)| mistakes, |()| notes)
}

/// The texts that the page of a declaration is made of: `linkage_core::sketch` puts them together.
///
/// # Errors
/// The mistakes in the declaration, in the order of the source.
pub fn page(source: TokenStream) -> Result<PageParts, Vec<Diagnostic>> {
    let _atoms = AtomScope::begin();
    let (mechanism, notes) = understood(source)?;
    let (program, placing) = (program(&mechanism), placing(&mechanism));
    let lowered = lower::lower(&mechanism, &program);
    let placing = lower::lower_placing(&mechanism, &placing);
    let marks = marks(&mechanism);
    let marks = marks.as_ref().map(|program| lower::lower_marks(&mechanism, program));
    let parts = PageParts::of(&mechanism, &lowered, (&placing, marks.as_ref()));
    Ok(PageParts { notes, ..parts })
}

/// A mechanism in one pose, as it is drawn.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct DrawnPose {
    /// The names of all parts, and the statements that place them.
    pub plan: PlanParts,
    /// Where they are: two numbers a point, five a link (origin, cosine and sine, slide), four a guide, then the
    /// lengths and offsets of groups.
    pub numbers: Vec<f64>,
}

/// Computes where the parts of a mechanism stand at these inputs, with parameters at their defaults: the pose that
/// `sketch` of the generated solver draws. `conditions` are the run-time's.
///
/// # Errors
/// The mistakes in the declaration, in the order of the source.
///
/// # Panics
/// If there are fewer inputs than the declaration has.
pub fn drawing(
    source: TokenStream,
    inputs: &[f64],
    conditions: &mut dyn Conditions,
) -> Result<DrawnPose, Vec<Diagnostic>> {
    let _atoms = AtomScope::begin();
    let (mechanism, _) = understood(source)?;
    let program = placing(&mechanism);
    let unknowns = unknown_words(&mechanism);
    let given = at_defaults(&mechanism, inputs);
    let numbers = Placing::new(&program).numbers(&given, &unknowns, conditions);
    Ok(DrawnPose { plan: PlanParts::of(&mechanism), numbers })
}

/// The proofs about the solver of a declaration: errors of every result in both widths, what a dimension changes, where
/// the fast path answers, and what a call costs. It takes from milliseconds to seconds, and nothing else asks for it.
///
/// # Errors
/// The mistakes in the declaration, in the order of the source, and what is asked of names that are none.
///
/// ```
/// let source = "pub struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2, angle: t } }";
/// let tokens = source.parse().expect("these are tokens");
/// let report = linkage_compiler::report(tokens, &Default::default()).expect("there is no mistake");
/// let x = &report.entries[0].results[0];
/// let [double, single] = x.bounds.as_ref().expect("a crank is proved");
/// assert!(single.within < 2.5e-7 && double.within < 1e-15);
/// ```
pub fn report(source: TokenStream, options: &ReportOptions) -> Result<Report, Vec<Diagnostic>> {
    let _atoms = AtomScope::begin();
    let (mechanism, _) = understood(source.clone())?;
    let (program, mut diagnostics) = (program(&mechanism), Diagnostics::new());
    let lowered = lower::lower(&mechanism, &program);
    let made = report::of(&mechanism, (&program, &lowered), &source, options, &mut diagnostics);
    diagnostics.finish().map_err(|Failure(mistakes)| mistakes)?;
    Ok(made.expect("a report that is not made says why"))
}

/// The inputs at rest, with parameters at their defaults and nothing applied.
fn at_defaults(mechanism: &Mechanism, inputs: &[f64]) -> ProgramValues<f64> {
    ProgramValues {
        inputs: inputs.iter().map(|&q| [q, 0.0, 0.0]).collect(),
        params: mechanism.params.iter().map(Param::default_value).collect(),
        loads: vec![0.0; mechanism.dynamics.loads.len()],
        drives: vec![0.0; mechanism.inputs.len()],
        unit: None,
    }
}

/// The words for each unknown.
fn unknown_words(mechanism: &Mechanism) -> Vec<UnknownWords> {
    let unknowns = mechanism.unknowns.iter().map(|unknown| UnknownWords {
        title: mechanism.title_of_unknown(unknown).to_string(),
        unit: unit(unknown.measure, Order::Position),
        checks_span_at_run_time: unknown.dimension.angle
            && unknown.between.iter().any(|end| end.constant().is_none()),
    });
    unknowns.collect()
}

/// The mechanism of a declaration without mistakes, and the remarks on it.
fn understood(source: TokenStream) -> Result<(Mechanism, Vec<Diagnostic>), Vec<Diagnostic>> {
    let mut diagnostics = Diagnostics::new();
    let (_, resolved) = read(source, &mut diagnostics);
    let notes = diagnostics.take_notes();
    match (resolved, diagnostics.finish()) {
        (Some(Ok(mechanism)), Ok(())) => Ok((mechanism, notes)),
        (_, Err(Failure(diagnostics))) => Err(diagnostics),
        (_, Ok(())) => unreachable!("a phase that gives nothing has reported why"),
    }
}

/// The declaration, and what it means.
pub fn read(
    source: TokenStream,
    diagnostics: &mut Diagnostics,
) -> (Option<Declaration>, Option<Result<Mechanism, Stub>>) {
    let declaration = parsed(source, diagnostics).map(Parsed::driven);
    let resolved = declaration.as_ref().map(|tree| resolved(tree, diagnostics));
    (declaration, resolved)
}

/// The meaning of a declaration.
pub fn resolved(
    declaration: &Declaration,
    diagnostics: &mut Diagnostics,
) -> Result<Mechanism, Stub> {
    // No barrier in front: the tree marks what could not be read, and the model says nothing of what may only be
    // missing because of that. Afterwards every name is a typed id and every dimension is checked.
    let mut mechanism = model::resolve(declaration, diagnostics)?;
    // The three rules that ask for equations; nothing that follows can fail.
    let never_turns = equations::pole_of_what_never_turns(&mechanism, passes::RULES);
    let does_work = equations::load_does_work(&mechanism, passes::RULES);
    if does_work && never_turns.is_none() && assembly_export::can_be_listed(&mechanism, diagnostics)
    {
        change_points::found(&mut mechanism, diagnostics);
        return Ok(mechanism);
    }
    if let Some(links) = never_turns {
        model::link_never_turns(&mechanism, links, diagnostics);
    }
    if !does_work {
        model::load_does_no_work(declaration, &mechanism, diagnostics);
    }
    Err(Stub(Box::new(mechanism)))
}

/// Equations and passes.
pub fn program(mechanism: &Mechanism) -> Program {
    // One graph holds the values of every entry point, written down under the rules: constants
    // are folded exactly, and nothing is added to zero or multiplied by one.
    let program = equations::derive(mechanism, passes::RULES);
    // Nothing is left that no entry needs, and products are contracted into their sums.
    passes::optimise(&program)
}

/// The solver, and with it what draws the mechanism where that is asked for.
fn solver(mechanism: &Mechanism, text: Option<&str>, options: &Options) -> TokenStream {
    let placing = options.sketch.then(|| placing(mechanism));
    let drawn = placing.as_ref().map(|program| (program, text));
    let own = code(mechanism, &program(mechanism), drawn, options);
    [own, assembly_export::solver_of_any(mechanism, options)].into_iter().collect()
}

/// The same for the program by which the mechanism is drawn, which shares nothing with the solver's.
pub fn placing(mechanism: &Mechanism) -> Program {
    passes::optimise(&equations::placing::derive(mechanism, passes::RULES))
}

/// The program of what a page draws beside bodies and forces; none where there is nothing.
fn marks(mechanism: &Mechanism) -> Option<Program> {
    equations::marks::derive(mechanism, passes::RULES).map(|program| passes::optimise(&program))
}

/// The text of a declaration as its author wrote it, with layout and comments; where another macro wrote
/// it, that of its tokens.
pub fn text(source: &TokenStream) -> String {
    let tokens = source.to_string();
    let is_it = |written: &String| {
        let Ok(call) = written.parse::<TokenStream>() else { return false };
        let Some(TokenTree::Group(group)) = call.into_iter().last() else { return false };
        group.stream().to_string() == tokens
    };
    let written = Span::call_site().source_text().filter(is_it);
    written.unwrap_or_else(|| format!("mechanism! {{ {tokens} }}"))
}

/// Lowering and code generation; the program that places what is drawn and the declaration's text, where it
/// is drawn.
pub fn code(
    mechanism: &Mechanism,
    program: &Program,
    drawn: Option<(&Program, Option<&str>)>,
    options: &Options,
) -> TokenStream {
    // Every statement of every function is decided; what is left is to print them.
    let lowered = lower::lower(mechanism, program);
    let has_page = drawn.is_some_and(|(_, source)| source.is_some()) && !mechanism.is_stub;
    let marks = has_page.then(|| marks(mechanism)).flatten();
    let drawing = drawn.map(|(program, source)| {
        let placing = lower::lower_placing(mechanism, program);
        let marks = marks.as_ref().map(|program| lower::lower_marks(mechanism, program));
        Drawing { placing, marks, source }
    });
    let kind = assembly_export::kind(mechanism);
    let listing = kind.as_ref().map(|kind| kind.listing(mechanism));
    codegen::generate(mechanism, &lowered, (drawing.as_ref(), listing.as_ref()), options.serde)
}

/// The struct and its methods for a declaration with mistakes. They never run: every result is zero.
pub fn stub(declaration: &Declaration, mechanism: &Mechanism, options: &Options) -> TokenStream {
    let interface = Interface::of(mechanism);
    // The stub does not know if its only input is the bare angle of a driver. It may therefore have a method
    // too many, which brings no message.
    let answers = interface.entries.iter();
    let answers = answers.map(|entry| (Some(entry.point), interface.numbers(entry.result)));
    let is_pushed = declaration.statements.iter().any(|statement| statement.kind.is_force());
    let drawn = std::iter::repeat_n((None, 0), if is_pushed { 2 } else { 1 });
    let nothing = options.sketch.then(|| Program::of_zeros(drawn));
    let drawn = nothing.as_ref().map(|nothing| (nothing, options.page.then_some("")));
    code(mechanism, &Program::of_zeros(answers), drawn, options)
}
