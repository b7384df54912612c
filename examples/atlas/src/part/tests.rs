//! Parts together are the whole, and a file that is not whole is not taken.

use std::fs;
use std::path::PathBuf;

use super::{Part, PartError, Question, merged, read, write};
use crate::drawn_path::DrawnPath;
use crate::grid::Grid;
use crate::progress::Progress;
use crate::search::{self, Entry};
use crate::shape::Describer;

/// Some linkages with some points each.
const GRID: Grid = Grid { lengths: 7, columns: 4, rows: 3 };

fn path() -> DrawnPath {
    DrawnPath::parse(include_str!("../../paths/d.txt")).expect("it is drawn")
}

fn list(part: Part, length: usize) -> Vec<Entry> {
    let path = path();
    let described = Describer::default().describe(&path.x, &path.y).expect("it has a size");
    let candidates = GRID.candidates();
    let linkages = part.linkages(candidates.linkages.len());
    search::short_list(&described, &candidates, linkages, length, &Progress::silent())
        .expect("slices of one length")
}

fn whole() -> Part {
    Part::new(1, 1).expect("there is one")
}

/// A directory of this test's own.
fn directory(name: &str) -> PathBuf {
    let directory = std::env::temp_dir().join(format!("atlas-{name}-{}", std::process::id()));
    fs::create_dir_all(&directory).expect("it can be written");
    directory
}

#[test]
fn every_linkage_is_in_one_part() {
    for (all, count) in [(0, 3), (1, 3), (7, 3), (32_020, 64), (5, 9), (usize::MAX, 2)] {
        let mut next = 0;
        for part in Part::all(count) {
            let linkages = part.linkages(all);
            assert_eq!(linkages.start, next, "{part} of {all}");
            assert!(linkages.len() <= all / count + 1 && linkages.len() >= all / count);
            next = linkages.end;
        }
        assert_eq!(next, all);
    }
    for text in ["0/3", "4/3", "3", "3/", "/3", "-1/3", "1/0", "1/3/5"] {
        assert_eq!(Part::parse(text), None, "{text}");
    }
}

#[test]
fn the_lists_of_parts_merge_into_that_of_the_whole() {
    let length = 50;
    let one = list(whole(), length);
    assert_eq!(one.len(), length);
    for count in [2, 3, 16] {
        let parts = Part::all(count).flat_map(|part| list(part, length)).collect();
        assert_eq!(search::shortest(parts, length), one, "{count} parts");
    }
}

#[test]
fn a_list_does_not_depend_on_threads() {
    let one = list(whole(), 50);
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let found = pool.expect("threads can be started").install(|| list(whole(), 50));
        assert_eq!(found, one, "{threads} threads");
    }
}

#[test]
fn files_give_back_every_bit_and_merge_into_the_whole() {
    let directory = directory("merge");
    let question = Question::new(&path(), GRID).expect("slices of one length");
    let parts: Vec<Part> = Part::all(3).collect();
    for &part in &parts {
        let entries = list(part, search::SHORT_LIST);
        let file = part.file_in(&directory);
        write(&file, part, &question, &entries).expect("it can be written");
        assert_eq!(read(&file, part, &question), Ok(entries));
    }
    assert_eq!(merged(&directory, 3, &question), Ok(list(whole(), search::SHORT_LIST)));
    // A part that is missing is named, and so is one that was cut off.
    fs::remove_file(parts[0].file_in(&directory)).expect("it was there");
    let second = parts[1].file_in(&directory);
    let bytes = fs::read(&second).expect("it is there");
    fs::write(&second, &bytes[..bytes.len() / 2]).expect("it can be written");
    let errors = vec![(parts[0], PartError::Missing), (parts[1], PartError::NotWhole)];
    assert_eq!(merged(&directory, 3, &question), Err(errors));
    fs::remove_dir_all(directory).expect("it was there");
}

#[test]
fn a_file_cut_anywhere_or_changed_in_any_byte_is_not_taken() {
    let directory = directory("cut");
    let (part, file) = (whole(), directory.join("part.txt"));
    let question = Question::new(&path(), GRID).expect("slices of one length");
    write(&file, part, &question, &list(part, 3)).expect("it can be written");
    let bytes = fs::read(&file).expect("it was written");
    let mut refused = 0;
    for at in 0..bytes.len() {
        let mut changed = bytes.clone();
        changed[at] ^= 1;
        for broken in [&bytes[..at], &changed] {
            fs::write(&file, broken).expect("it can be written");
            assert_eq!(read(&file, part, &question), Err(PartError::NotWhole), "at {at}");
            refused += 1;
        }
    }
    assert_eq!(refused, 2 * bytes.len());
    fs::remove_dir_all(directory).expect("it was there");
}

#[test]
fn a_file_of_another_question_or_arithmetic_is_refused_by_name() {
    let directory = directory("other");
    let (part, file) = (whole(), directory.join("part.txt"));
    let question = Question::new(&path(), GRID).expect("slices of one length");
    write(&file, part, &question, &list(part, 3)).expect("it can be written");
    let finer = Question::new(&path(), Grid { rows: 4, ..GRID }).expect("slices of one length");
    assert_eq!(read(&file, part, &finer), Err(PartError::OtherQuestion));
    let mut other = path();
    other.x[0] += f64::EPSILON;
    let other = Question::new(&other, GRID).expect("slices of one length");
    assert_eq!(read(&file, part, &other), Err(PartError::OtherQuestion));
    let half = Part::new(1, 2).expect("there is one");
    assert_eq!(read(&file, half, &question), Err(PartError::OtherQuestion));
    assert_eq!(read(&file, part, &question.elsewhere()), Err(PartError::OtherArithmetic));
    fs::remove_dir_all(directory).expect("it was there");
}
