//! Colours and width of messages.

use std::env;
use std::io::{self, IsTerminal};

use linkage_compiler::Level;

/// The characters to which a line of a source is cut, as rustc does where it knows no terminal.
const WIDTH: usize = 140;

/// The looks of messages.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    is_coloured: bool,
    /// The characters of a line.
    pub width: usize,
}

/// The parts of a message that have a colour.
#[derive(Clone, Copy)]
pub(crate) enum Part {
    Level(Level),
    Message,
    Frame,
}

impl Style {
    /// The looks on the standard error output: colours on a terminal, unless `NO_COLOR` is set.
    pub(crate) fn of_errors() -> Self {
        let is_refused = env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        let is_plain = env::var_os("TERM").is_none_or(|value| value == "dumb");
        let columns = env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok());
        Self {
            is_coloured: io::stderr().is_terminal() && !is_refused && !is_plain,
            width: columns.unwrap_or(WIDTH),
        }
    }

    /// A text in the colour of its part.
    pub(crate) fn paint(self, part: Part, text: &str) -> String {
        let code = match part {
            _ if !self.is_coloured || text.is_empty() => return text.to_string(),
            Part::Level(Level::Mistake) => "1;31",
            Part::Level(Level::Note) => "1;32",
            Part::Message => "1",
            Part::Frame => "1;34",
        };
        format!("\x1b[{code}m{text}\x1b[0m")
    }
}

/// Tells what is wrong without a place in a source.
pub(crate) fn tell(message: &str) {
    eprintln!("{} {message}", Style::of_errors().paint(Part::Level(Level::Mistake), "error:"));
}
