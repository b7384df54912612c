//! The list of what tests leave out for want of a tool. Tests of every crate include this file: none may depend on another's.

use std::io::Write;

/// Says that something is left out, and appends it to the list that `.ci/run` prints at its end and compares.
pub(crate) fn skipped(what: &str) {
    std::println!("skipped: {what}");
    let Some(list) = std::env::var_os("LINKAGE_SKIPS") else { return };
    let file = std::fs::OpenOptions::new().append(true).create(true).open(list);
    let mut file = file.expect("the list can be written");
    std::writeln!(file, "{what}").expect("the list can be written");
}
