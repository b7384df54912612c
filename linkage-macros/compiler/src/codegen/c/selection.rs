//! The part of a mechanism that is printed: all of it, or some entry points, or one width.

use super::c_identifiers::Width;
use crate::codegen::identifiers::text;
use crate::diagnostics::Diagnostics;
use crate::interface::Interface;
use crate::interface::entries::EntryPoint;
use crate::ir::program::Program;
use crate::lower::stands_on;
use crate::model::mechanism::Mechanism;

/// Entry points and widths.
pub struct Selection {
    points: Vec<EntryPoint>,
    pub widths: Vec<Width>,
}

impl Selection {
    /// The selection among the entry points that a program answers, by their names, `f64` and `f32`; all of those
    /// that no name tells. Reports names that are none.
    pub fn of(
        mechanism: &Mechanism,
        program: &Program,
        only: &[&str],
        diagnostics: &mut Diagnostics,
    ) -> Self {
        let all: Vec<EntryPoint> =
            program.answers.iter().filter_map(|answer| answer.entry).collect();
        let interface = Interface::of(mechanism).limited_to(all.iter().copied());
        let widths = Width::ALL.into_iter().filter(|width| only.contains(&width.in_rust()));
        let widths: Vec<Width> = widths.collect();
        let points = all.iter().copied().filter(|point| only.contains(&point.name()));
        let points: Vec<EntryPoint> = points.collect();
        let is_known = |name: &&str| {
            points.iter().any(|point| point.name() == *name)
                || widths.iter().any(|width| width.in_rust() == *name)
        };
        for name in only.iter().filter(|name| !is_known(name)) {
            let names: Vec<&str> = all.iter().map(|point| point.name()).collect();
            diagnostics.error_because(
                mechanism.name.span(),
                format!("`{name}` is no entry point of `{}`", text(&mechanism.name)),
                format!("there are {}; and the widths f64 and f32", names.join(", ")),
            );
        }
        let points = if points.is_empty() { all } else { with_needed(&interface, points) };
        let widths = if widths.is_empty() { Width::ALL.to_vec() } else { widths };
        Self { points, widths }
    }

    /// The interface of what is printed.
    pub(crate) fn interface(&self, mechanism: &Mechanism) -> Interface {
        Interface::of(mechanism).limited_to(self.points.iter().copied())
    }

    /// The program without the answers of other entry points.
    pub fn apply(&self, program: Program) -> Program {
        let is_selected = |point: EntryPoint| self.points.contains(&point);
        let answers = program.answers.into_iter();
        let answers = answers.filter(|answer| answer.entry.is_none_or(is_selected)).collect();
        Program { answers, ..program }
    }
}

/// The entry points, and those whose formulas some of them use.
fn with_needed(interface: &Interface, mut points: Vec<EntryPoint>) -> Vec<EntryPoint> {
    let mut at = 0;
    while let Some(&point) = points.get(at) {
        at += 1;
        let needed = interface.find(point).and_then(|id| stands_on(interface, id));
        let needed = needed.map(|id| interface.entry(id).point);
        points.extend(needed.filter(|needed| !points.contains(needed)));
    }
    points
}
