//! Routines into structured text of IEC 61131-3: the fast path of a mechanism as function blocks, for controllers that no
//! C reaches.
//!
//! A block holds the formulas of one entry point. Conditions stand in front of what needs them, and so do questions about
//! sizes where intervals do not show that no value overflows: a block meets no infinity and no number that is none. It
//! has no slow path: what that would decide is refused.

mod block;
mod in_st;
pub mod st_names;
mod st_run_time;
mod types;

use std::collections::HashMap;

use self::in_st::InSt;
use self::st_names::BlockNames;
use super::arguments::Signatures;
use super::c::c_identifiers::{Width, file_stem, function};
use super::c::provenance::{Provenance, VERSION};
use super::c::selection::Selection;
use super::identifiers::text;
use crate::interface::Interface;
use crate::interface::entries::ArgumentKind;
use crate::ir::graph::Node;
use crate::lower::always_finite::Unbounded;
use crate::lower::places::{ArgumentPart, Place, place};
use crate::lower::routine::Lowered;
use crate::model::mechanism::Mechanism;

/// The reason why a mechanism has no function blocks, and what mends it.
pub(crate) struct Refusal {
    pub why: String,
    pub because: String,
}

/// Prints the files of a mechanism: name and text of its types and blocks, and of the functions that they call.
pub(crate) fn generate(
    mechanism: &Mechanism,
    lowered: &Lowered<'_>,
    selection: &Selection,
    provenance: &Provenance<'_>,
    by_controller: bool,
) -> Result<Vec<(String, String)>, Refusal> {
    let signatures = Signatures::new(mechanism, &lowered.interface);
    let stem = file_stem(&text(&mechanism.name));
    let globals = Globals::of(mechanism, &lowered.interface, selection);
    let mut source = String::new();
    for &width in &selection.widths {
        let to = Plc {
            mechanism,
            lowered,
            signatures: &signatures,
            globals: &globals,
            width,
            by_controller,
        };
        to.types(&mut source);
        for id in to.interface().ids() {
            source += &to.block(id)?;
        }
    }
    let source = head(lowered, provenance, by_controller, &source) + &source;
    let prefix = &provenance.prefix;
    let run_time = ("linkage_run.st", st_run_time::source());
    let own = (format!("{stem}.st"), st_run_time::renamed(&source, prefix));
    Ok(vec![own, (prefix.in_front_of(run_time.0), st_run_time::renamed(&run_time.1, prefix))])
}

/// The names of a mechanism's types and blocks, of which no two are one.
struct Globals(HashMap<String, String>);

impl Globals {
    fn of(mechanism: &Mechanism, interface: &Interface, selection: &Selection) -> Self {
        let mut scope = BlockNames::default();
        let mut names = HashMap::new();
        for &width in &selection.widths {
            let types = interface.records.iter().map(|record| text(&record.name));
            let types = types.chain([text(&mechanism.name)]).map(|name| width.type_name(&name));
            let blocks = interface.entries.iter();
            let blocks = blocks.map(|entry| function(&mechanism.name, entry, width));
            for name in types.chain(blocks) {
                let own = scope.name(&name);
                names.insert(name, own);
            }
        }
        Self(names)
    }

    fn name(&self, in_c: &str) -> String {
        self.0.get(in_c).cloned().unwrap_or_else(|| in_c.to_string())
    }
}

/// The printer of numbers of one width.
#[derive(Clone, Copy)]
struct Plc<'a> {
    mechanism: &'a Mechanism,
    lowered: &'a Lowered<'a>,
    signatures: &'a Signatures<'a>,
    globals: &'a Globals,
    width: Width,
    /// True if sines and cosines are the controller's.
    by_controller: bool,
}

impl<'a> Plc<'a> {
    fn interface(self) -> &'a Interface {
        &self.lowered.interface
    }

    /// The number's type.
    fn real(self) -> &'static str {
        match self.width {
            Width::Double => "LREAL",
            Width::Single => "REAL",
        }
    }

    /// The ending of functions of this width.
    fn ending(self) -> &'static str {
        if self.width == Width::Single { "_f32" } else { "" }
    }

    /// The name of a type of this width.
    fn type_name(self, name: &str) -> String {
        self.globals.name(&self.width.type_name(name))
    }

    fn has_params(self) -> bool {
        !self.mechanism.params.is_empty()
    }

    /// The expression that reads an input, a load, a drive or a parameter from a block's pins.
    fn leaf(self, given: &[ArgumentKind], pins: &[String], node: Node) -> Option<String> {
        let interface = self.interface();
        Some(match place(self.mechanism, interface, given, node)? {
            Place::Param(field) => format!("{}.{}", pins[0], self.param(&text(field))),
            Place::Argument(at, ArgumentPart::All) => pins[at + 1].clone(),
            Place::Argument(at, ArgumentPart::Index(index)) => format!("{}[{index}]", pins[at + 1]),
            Place::Argument(at, ArgumentPart::Field(field)) => {
                let record = match given[at] {
                    ArgumentKind::Loads => interface.loads,
                    ArgumentKind::Value
                    | ArgumentKind::Rate
                    | ArgumentKind::Acceleration
                    | ArgumentKind::Cosine
                    | ArgumentKind::Sine
                    | ArgumentKind::Drives => interface.inputs,
                };
                let record = interface.record(record.expect("several have a record"));
                let field = types::field(record.fields.iter().map(|field| &field.name), field);
                format!("{}.{field}", pins[at + 1])
            }
        })
    }

    fn param(self, name: &str) -> String {
        let params: Vec<String> =
            self.mechanism.params.iter().map(|param| text(&param.name)).collect();
        let at = params.iter().position(|param| param == name).expect("it is a parameter");
        BlockNames::default().names(params).swap_remove(at)
    }

    fn refusal(self, of: Unbounded) -> Refusal {
        let solver = text(&self.mechanism.name);
        match of {
            Unbounded::Function(function) => Refusal {
                why: format!("`{}` is no function of structured text", function.name()),
                because: "`export c` prints it".to_string(),
            },
            Unbounded::Constant => Refusal {
                why: format!("a constant of `{solver}` is beyond {}", self.real()),
                because: "`--only f64` prints LREAL alone".to_string(),
            },
            Unbounded::Solved => Refusal {
                why: match self.mechanism.unknowns.first() {
                    Some(unknown) => format!(
                        "structured text has no search for `{}` of `{solver}`",
                        self.mechanism.title_of_unknown(unknown)
                    ),
                    None => format!("structured text solves no equations of `{solver}`"),
                },
                because: "`export c` prints it".to_string(),
            },
        }
    }
}

/// The first lines of a mechanism's text, with the groups that its blocks refuse.
fn head(
    lowered: &Lowered<'_>,
    provenance: &Provenance<'_>,
    by_controller: bool,
    blocks: &str,
) -> String {
    let solver = text(&provenance.mechanism.name);
    let (file, declaration) = (file_stem(&solver), provenance.declaration);
    let sines = match by_controller {
        true => "Sines and cosines are the controller's, and so are their errors.",
        false => "Sines and cosines are those of linkage_run.st, with the bits of printed C.",
    };
    let groups = lowered.program.groups.iter().enumerate();
    let refused = groups.filter(|(nth, _)| blocks.contains(&format!("status := {};", nth + 1)));
    let groups: String = refused
        .map(|(nth, group)| format!("   {:>4}  {}\n", nth + 1, types::in_comment(group)))
        .collect();
    format!(
        "(* {file}.st: the fast path of {solver} as function blocks of IEC 61131-3, printed by linkage {VERSION}\n   \
         from its declaration, whose words have the hash {declaration:016x}; do not edit. linkage_run.st belongs\n   \
         to it.\n\n   \
         Next to a limit a block answers or refuses as the fast path of the solver does: within some last places of\n   \
         its limit a group is refused that printed C decides without rounding. What a block answers has the bits of\n   \
         printed C without fused operations, where each operation is rounded to its LREAL or REAL. Nothing is\n   \
         divided by zero, and no value is infinite or none. {sines}\n\n   \
         status says whether there is an answer, and refused names what is to blame; without one all results are\n   \
         zero:\n\n   \
         \x20  0  there is an answer\n{groups}   \
         \x20 -1  the input, rate, parameter or load is no number, or too large\n   \
         \x20 -2  the parameter is none of its modes, 1 and -1\n   \
         \x20 -3  a value on the way is too large or too small\n   \
         \x20 -4  the cosine and the sine are those of no angle\n\n   \
         This text is yours: use, change and pass it on under any terms, with or without this notice. It comes\n   \
         without any warranty. *)\n",
    )
}

/// Lines of a block's body, four blanks for each statement that is open.
fn indented(lines: &str) -> String {
    let (mut depth, mut text) = (1_usize, String::with_capacity(lines.len() * 5 / 4));
    for line in lines.lines() {
        let ends = ["END_", "ELSE", "ELSIF", "UNTIL"].iter().any(|word| line.starts_with(word));
        depth -= usize::from(ends && !line.starts_with("END_REPEAT"));
        text.push_str(&"    ".repeat(depth));
        text.push_str(line);
        text.push('\n');
        let begins = ["THEN", "ELSE", "REPEAT"].iter().any(|word| line.ends_with(word));
        depth += usize::from(begins);
    }
    text
}

/// A printer of structured text.
type BlockPrinter<'p> = super::printer::Printer<'p, InSt<'p>>;
