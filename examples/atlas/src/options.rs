//! The command line.

use std::ffi::OsString;
use std::fmt;
use std::path::PathBuf;

use crate::grid::Grid;
use crate::part::Part;
use crate::search::SHORT_LIST;

/// The arguments in words.
pub const USAGE: &str = "\
atlas [PATH] [--grid LENGTHS,COLUMNS,ROWS] [--refine COUNT] [--best FILE]
atlas [PATH] [--grid LENGTHS,COLUMNS,ROWS] --part K/N --out FILE
atlas [PATH] [--grid LENGTHS,COLUMNS,ROWS] --missing N DIRECTORY
atlas [PATH] [--grid LENGTHS,COLUMNS,ROWS] [--refine COUNT] [--best FILE] --merge N DIRECTORY";

/// Which work is done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Work {
    /// The whole search.
    Whole,
    /// One part of it, into a file.
    Part(Part, PathBuf),
    /// The numbers of parts whose files are missing or not whole, of so many in a directory.
    Missing(usize, PathBuf),
    /// The end of the search, from the files of so many parts in a directory.
    Merge(usize, PathBuf),
}

/// The options of the command line: the path, the grid, and the share of the work.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// The file of the drawn path; none is the walking machine's.
    pub path: Option<PathBuf>,
    /// The candidates.
    pub grid: Grid,
    /// As many of the nearest are refined.
    pub refine: usize,
    /// Where the refined list is written, every number to its last bit.
    pub best: Option<PathBuf>,
    /// See [`Work`].
    pub work: Work,
}

/// A mistake on the command line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misused(String);

impl fmt::Display for Misused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{USAGE}", self.0)
    }
}

impl std::error::Error for Misused {}

impl Options {
    /// Reads the arguments, without the program's name.
    ///
    /// # Errors
    /// See [`Misused`].
    pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Self, Misused> {
        let (grid, refine, work) = (Grid::TEN_MILLION, SHORT_LIST, Work::Whole);
        let mut options = Self { path: None, grid, refine, best: None, work };
        let (mut part, mut out, mut arguments) = (None, None, arguments.into_iter());
        while let Some(argument) = arguments.next() {
            let name = argument.to_string_lossy().into_owned();
            let mut next = || {
                arguments
                    .next()
                    .ok_or_else(|| Misused(format!("`{name}` stands without its value")))
            };
            match name.as_str() {
                "--grid" => options.grid = parsed(&name, &next()?, Grid::parse)?,
                "--refine" => options.refine = parsed(&name, &next()?, |text| text.parse().ok())?,
                "--best" => options.best = Some(next()?.into()),
                "--part" => part = Some(parsed(&name, &next()?, Part::parse)?),
                "--out" => out = Some(PathBuf::from(next()?)),
                "--missing" => {
                    options.work = Work::Missing(count(&name, &next()?)?, next()?.into())
                }
                "--merge" => options.work = Work::Merge(count(&name, &next()?)?, next()?.into()),
                _ if name.starts_with("--") => {
                    return Err(Misused(format!("there is no option `{name}`")));
                }
                _ if options.path.is_some() => {
                    return Err(Misused(
                        "one path is searched at a time; give one file".to_owned(),
                    ));
                }
                _ => options.path = Some(argument.into()),
            }
        }
        match (part, out) {
            (Some(part), Some(out)) => options.work = Work::Part(part, out),
            (None, None) => {}
            _ => return Err(Misused("`--part` and `--out` go together".to_owned())),
        }
        Ok(options)
    }
}

fn parsed<T>(
    name: &str,
    value: &OsString,
    parse: impl FnOnce(&str) -> Option<T>,
) -> Result<T, Misused> {
    let text = value.to_string_lossy();
    parse(&text).ok_or_else(|| Misused(format!("`{text}` is no value of `{name}`")))
}

/// The number of parts, at least one.
fn count(name: &str, value: &OsString) -> Result<usize, Misused> {
    parsed(name, value, |text| text.parse().ok().filter(|&count| count > 0))
}
