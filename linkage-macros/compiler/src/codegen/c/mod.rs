//! Routines into C99: the functions of `export c;` as source, for compilers that Rust has no target for.
//!
//! The header is the one of `export c;`, so either library answers behind it. A routine is written twice a width:
//! once as the fast path compares, once as the slow path diagnoses. Names of our own inside a function have a
//! capital letter or no underscore at their end, which no local of a routine has.

pub mod c_identifiers;
mod c_names;
mod entry;
pub(crate) mod fmu;
pub mod header;
mod in_c;
pub(crate) mod printed_list;
pub mod provenance;
mod public_function;
mod reserved;
mod roots;
pub mod run_time;
pub mod selection;
pub(crate) mod transfers;
mod two_paths;

use self::c_identifiers::{Width, file_stem, snake_case};
use self::in_c::rubs;
use self::provenance::Provenance;
use self::selection::Selection;
use super::arguments::Signatures;
use super::identifiers::text;
use crate::interface::Interface;
use crate::lower::routine::Lowered;
use crate::model::mechanism::Mechanism;

/// Prints the files of a mechanism: name and text of its header and its source, then those of the run-time, which
/// holds the search for roots where something is searched, and that for friction where amounts of it depend on each
/// other.
pub fn generate(
    mechanism: &Mechanism,
    lowered: &Lowered<'_>,
    selection: &Selection,
    provenance: &Provenance<'_>,
) -> Vec<(String, String)> {
    let signatures = Signatures::new(mechanism, &lowered.interface);
    let solver = text(&mechanism.name);
    let [stem, file] = [snake_case(&solver), file_stem(&solver)];
    let mut source = provenance.in_source();
    for &width in &selection.widths {
        let without = width.excluded();
        source += &format!("\n#ifndef {without}\n");
        In { mechanism, lowered, signatures: &signatures, width, stem: &stem }.all(&mut source);
        source += &format!("\n#endif /* {without} */\n");
    }
    let header = header::text(&signatures, &selection.widths, &provenance.in_header());
    let mut run_time =
        vec![("linkage_run.h", run_time::header()), ("linkage_run.c", run_time::source())];
    if !mechanism.unknowns.is_empty() {
        run_time.push((ROOT, run_time::root_source()));
    }
    if rubs(lowered) {
        run_time.push((FRICTION, run_time::friction_source()));
    }
    let prefix = &provenance.prefix;
    let own = [(format!("{file}.h"), header), (format!("{file}.c"), prefix.put_into(&source))];
    let run_time = run_time.into_iter();
    own.into_iter()
        .chain(run_time.map(|(name, text)| (prefix.in_front_of(name), prefix.put_into(&text))))
        .collect()
}

/// The part of the run-time that finds roots.
const ROOT: &str = "linkage_root.c";

/// The part of the run-time that finds amounts of friction.
const FRICTION: &str = "linkage_friction.c";

/// The printer of numbers of one width.
#[derive(Clone, Copy)]
struct In<'a> {
    mechanism: &'a Mechanism,
    lowered: &'a Lowered<'a>,
    signatures: &'a Signatures<'a>,
    width: Width,
    stem: &'a str,
}

impl<'a> In<'a> {
    fn all(self, to: &mut String) {
        self.roots(to);
        for routine in &self.lowered.routines {
            self.routine(routine, to);
        }
        for id in self.interface().ids() {
            self.core(id, to);
            self.diagnosis(id, to);
        }
        self.defaults(to);
        for id in self.interface().ids() {
            self.entry(id, to);
        }
    }

    fn interface(self) -> &'a Interface {
        &self.lowered.interface
    }

    /// The number's type.
    fn real(self) -> &'static str {
        self.width.in_c()
    }

    /// The ending of functions and literals of this width.
    fn ending(self) -> &'static str {
        if self.width == Width::Single { "f" } else { "" }
    }

    /// A literal, in parentheses where it begins with a sign.
    fn number(self, wide: f64, narrow: f32) -> String {
        let digits = match self.width {
            Width::Double if wide.is_infinite() => "HUGE_VAL".to_string(),
            Width::Single if narrow.is_infinite() => "HUGE_VALF".to_string(),
            Width::Double => format!("{:?}", wide.abs()),
            Width::Single => format!("{:?}f", narrow.abs()),
        };
        let is_negative = match self.width {
            Width::Double => wide.is_sign_negative(),
            Width::Single => narrow.is_sign_negative(),
        };
        if is_negative { format!("(-{digits})") } else { digits }
    }

    /// A limit of both widths.
    fn limit(self, [wide, narrow]: [f64; 2]) -> String {
        self.number(wide, narrow as f32)
    }
}
