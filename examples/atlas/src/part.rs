//! A part of a search, and the file that holds its short list.
//!
//! Part K of N takes the K-th of N equal runs of linkages. Its result depends on the question and on the
//! arithmetic of the machine alone, not on threads, on other parts or on when it runs. Its file is written
//! beside its place and then renamed, and ends with a fingerprint of all lines before, so that a file that was
//! cut off is told from a whole one.
//!
//! ```text
//! atlas part 3/16
//! question 0123456789abcdef
//! arithmetic 0123456789abcdef
//! entries 1000
//! 3f9d70a3d70a3d71 12345
//! …
//! fingerprint 0123456789abcdef
//! ```
//!
//! A distance is written as its bits. The question is the fingerprint of the path, the grid and the numbers of
//! poses; the arithmetic is that of some curves as this machine traces them. Machines that fuse
//! products into sums differ from those that do not by roundings, and their parts are not mixed.

use std::fmt;
use std::fs::{self, File};
use std::io::{ErrorKind, Write as _};
use std::ops::Range;
use std::path::{Path, PathBuf};

use linkage_core::LengthMismatch;

use crate::drawn_path::DrawnPath;
use crate::fingerprint::Fingerprint;
use crate::four_bar::Tracer;
use crate::grid::{self, Grid};
use crate::search::{self, Entry, FINE_POSES, POSES, SHORT_LIST};
use crate::shape::Describer;

/// Which part of how many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    number: usize,
    count: usize,
}

impl Part {
    /// Part `number` of `count`, counted from 1; none where there is no such part.
    #[must_use]
    pub fn new(number: usize, count: usize) -> Option<Self> {
        (1..=count).contains(&number).then_some(Self { number, count })
    }

    /// All parts of so many.
    pub fn all(count: usize) -> impl Iterator<Item = Self> {
        (1..=count).map(move |number| Self { number, count })
    }

    /// A part as `3/16`.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (number, count) = text.split_once('/')?;
        Self::new(number.parse().ok()?, count.parse().ok()?)
    }

    /// Counted from 1.
    #[must_use]
    pub fn number(self) -> usize {
        self.number
    }

    /// The linkages of this part, of so many in all: parts differ by one linkage at most.
    #[must_use]
    pub fn linkages(self, all: usize) -> Range<usize> {
        // In 128 bits, which no product of two numbers of 64 leaves.
        let end = |nth: usize| (all as u128 * nth as u128 / self.count as u128) as usize;
        end(self.number - 1)..end(self.number)
    }

    /// The name of this part's file in a directory of all parts.
    #[must_use]
    pub fn file_in(self, directory: &Path) -> PathBuf {
        directory.join(format!("part-{}-of-{}.txt", self.number, self.count))
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.count)
    }
}

/// The search that a part belongs to, and the arithmetic that it uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Question {
    asked: Fingerprint,
    arithmetic: Fingerprint,
}

impl Question {
    /// A path that is searched in a grid on this machine.
    ///
    /// # Errors
    /// Never: all slices of a sweep are of one length.
    pub fn new(path: &DrawnPath, grid: Grid) -> Result<Self, LengthMismatch> {
        let mut asked = Fingerprint::new();
        asked.add(format!("{grid} {POSES} {FINE_POSES} {SHORT_LIST}").as_bytes());
        path.x.iter().chain(&path.y).for_each(|number| asked.add(&number.to_le_bytes()));
        Ok(Self { asked, arithmetic: arithmetic()? })
    }

    /// The same question on a machine whose numbers round differently.
    #[cfg(test)]
    pub(crate) fn elsewhere(self) -> Self {
        Self { arithmetic: self.asked, ..self }
    }
}

/// The fingerprint of the descriptors of a few curves.
fn arithmetic() -> Result<Fingerprint, LengthMismatch> {
    let (mut tracer, mut describer) = (Tracer::new(POSES), Describer::default());
    let (atlas, mut arithmetic) = (grid::atlas(), Fingerprint::new());
    for (&lengths, &point) in atlas.linkages.iter().step_by(20).zip(atlas.points.iter().step_by(5))
    {
        tracer.trace(&grid::curve(lengths, point))?;
        let Some(curve) = describer.describe(&tracer.x, &tracer.y) else { continue };
        for c in (1..=3).flat_map(|k| [curve.coefficient(k), curve.coefficient(-k)]).flatten() {
            arithmetic.add(&c.re.to_le_bytes());
            arithmetic.add(&c.im.to_le_bytes());
        }
    }
    Ok(arithmetic)
}

/// Why a file does not give the entries of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PartError {
    /// There is no such file.
    Missing,
    /// It is cut off or changed.
    NotWhole,
    /// It is whole, and of another part, path or grid.
    OtherQuestion,
    /// It was computed where numbers round differently.
    OtherArithmetic,
    /// The system's reason.
    Unreadable(String),
}

impl fmt::Display for PartError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Missing => "there is no such file; run this part",
            Self::NotWhole => "it is cut off or changed; run this part again",
            Self::OtherQuestion => "it answers another question; name another file or directory",
            Self::OtherArithmetic => {
                "it was computed where numbers round differently; run all parts on machines of one kind"
            }
            Self::Unreadable(reason) => reason,
        })
    }
}

impl std::error::Error for PartError {}

/// Writes a part's file.
///
/// # Errors
/// Those of the system.
pub fn write(
    file: &Path,
    part: Part,
    question: &Question,
    entries: &[Entry],
) -> std::io::Result<()> {
    let mut text = head(part, question);
    text += &format!("entries {}\n", entries.len());
    for entry in entries {
        text += &format!("{:016x} {}\n", entry.distance.to_bits(), entry.candidate);
    }
    text += &format!("fingerprint {}\n", Fingerprint::of(text.as_bytes()));
    // Two processes with one part write two files of one content, and either may be the last.
    let beside = file.with_extension(format!("{}.unfinished", std::process::id()));
    let mut unfinished = File::create(&beside)?;
    unfinished.write_all(text.as_bytes())?;
    unfinished.sync_all()?;
    fs::rename(&beside, file)
}

/// The entries in a part's file.
///
/// # Errors
/// See [`PartError`].
pub fn read(file: &Path, part: Part, question: &Question) -> Result<Vec<Entry>, PartError> {
    let text = fs::read_to_string(file).map_err(|error| match error.kind() {
        ErrorKind::NotFound => PartError::Missing,
        ErrorKind::InvalidData => PartError::NotWhole,
        _ => PartError::Unreadable(error.to_string()),
    })?;
    let last = text.trim_end().rfind('\n').ok_or(PartError::NotWhole)?;
    let (lines, end) = text.split_at(last + 1);
    if end != format!("fingerprint {}\n", Fingerprint::of(lines.as_bytes())) {
        return Err(PartError::NotWhole);
    }
    let Some(listed) = lines.strip_prefix(&head(part, question)) else {
        let arithmetic = format!("arithmetic {}\n", question.arithmetic);
        let is_elsewhere = lines.contains(&format!("question {}\n", question.asked))
            && !lines.contains(&arithmetic);
        return Err(if is_elsewhere {
            PartError::OtherArithmetic
        } else {
            PartError::OtherQuestion
        });
    };
    let entries: Option<Vec<Entry>> = listed.lines().skip(1).map(entry).collect();
    entries.ok_or(PartError::NotWhole)
}

fn head(part: Part, question: &Question) -> String {
    let Question { asked, arithmetic } = question;
    format!("atlas part {part}\nquestion {asked}\narithmetic {arithmetic}\n")
}

fn entry(line: &str) -> Option<Entry> {
    let (bits, candidate) = line.split_once(' ')?;
    let distance = f64::from_bits(u64::from_str_radix(bits, 16).ok()?);
    Some(Entry { distance, candidate: candidate.parse().ok()? })
}

/// The short list of the whole search from the files of all parts, or the parts that have none and why.
///
/// # Errors
/// The parts that are not there.
pub fn merged(
    directory: &Path,
    count: usize,
    question: &Question,
) -> Result<Vec<Entry>, Vec<(Part, PartError)>> {
    let (mut entries, mut errors) = (Vec::new(), Vec::new());
    for part in Part::all(count) {
        match read(&part.file_in(directory), part, question) {
            Ok(listed) => entries.extend(listed),
            Err(error) => errors.push((part, error)),
        }
    }
    if errors.is_empty() { Ok(search::shortest(entries, SHORT_LIST)) } else { Err(errors) }
}

#[cfg(test)]
mod tests;
