//! Mistakes and notes as they are told, and their counts at the end.

use linkage_compiler::{Diagnostic, Level};

use crate::messages;
use crate::output::{self, Failure};
use crate::program::{Declaration, Program};
use crate::style::Style;

/// The most mechanisms that the line at the end names.
const NAMED: usize = 4;

/// The counts of all that was told.
#[derive(Default)]
pub(crate) struct Report {
    mistakes: usize,
    notes: usize,
    /// The mechanisms that were looked at.
    names: Vec<String>,
}

impl Report {
    /// Tells mistakes and notes of a declaration on the standard error output.
    pub(crate) fn tell(
        &mut self,
        program: &Program,
        declaration: &Declaration,
        found: &[Diagnostic],
    ) {
        let style = Style::of_errors();
        for one in found {
            eprintln!("{}", messages::text(one, &program.place(declaration, one), style));
        }
        self.count(declaration, found);
    }

    /// Counts mistakes and notes that are told elsewhere.
    pub(crate) fn count(&mut self, declaration: &Declaration, found: &[Diagnostic]) {
        let count = |level| found.iter().filter(|one| one.level == level).count();
        self.mistakes += count(Level::Mistake);
        self.notes += count(Level::Note);
        self.names.push(declaration.name());
    }

    /// The result of all that was told.
    pub(crate) fn result(&self) -> Result<(), Failure> {
        if self.mistakes == 0 { Ok(()) } else { Err(Failure::Told) }
    }

    /// Tells how many mistakes there are, if any.
    pub(crate) fn close(&self) -> Result<(), Failure> {
        self.result().inspect_err(|_| eprintln!("{}", self.counts()))
    }

    /// The same, and a line where all is well.
    pub(crate) fn close_with_counts(&self) -> Result<(), Failure> {
        self.close()?;
        output::print(&format!("{}\n", self.counts()))
    }

    /// One line: mechanisms, mistakes, notes.
    fn counts(&self) -> String {
        let several = |count: usize, word: &str| match count {
            0 => format!("no {word}"),
            1 => format!("1 {word}"),
            _ => format!("{count} {word}s"),
        };
        let machines = match self.names.len() {
            count if count > NAMED => several(count, "mechanism"),
            _ => self.names.join(", "),
        };
        let notes = match self.notes {
            0 => String::new(),
            count => format!(", {}", several(count, "note")),
        };
        format!("{machines}: {}{notes}", several(self.mistakes, "mistake"))
    }
}
