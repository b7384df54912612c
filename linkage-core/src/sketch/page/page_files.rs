//! The files of the page's run-time, its styles and its document.

use std::vec::Vec;

/// The files that compute and decide.
pub(super) const ARITHMETIC: [&str; 3] =
    [include_str!("kernels.js"), include_str!("limit.js"), include_str!("checks.js")];

/// The files of the search for an unknown.
pub(super) const SEARCH: [&str; 2] = [include_str!("roots.js"), include_str!("survey.js")];

/// The file that solves for friction.
pub(super) const FRICTION: [&str; 1] = [include_str!("friction.js")];

/// The files that read the results, without a document.
pub(super) const READS: [&str; 3] =
    [include_str!("words.js"), include_str!("pose.js"), include_str!("drag.js")];

/// The file that finds ends of sliders, where the page is told none.
pub(super) const RANGES: [&str; 1] = [include_str!("ranges.js")];

/// The files of all that a reader sees and sets.
pub(super) const SHOWS: [&str; 5] = [
    include_str!("picture.js"),
    include_str!("symbols.js"),
    include_str!("curves.js"),
    include_str!("acts.js"),
    include_str!("controls.js"),
];

/// The files that only pages of some machines have, each with what stands in these machines' constants, and with its style.
pub(super) const PARTS: [(&[&str], &str, &str); 11] = [
    (&["const SETS"], include_str!("sets.js"), ""),
    (&["\nmarks: "], include_str!("marks.js"), include_str!("marks.css")),
    (&["\nforces: ", "\nappliedAt: ", "\nmarks: "], include_str!("forces.js"), ""),
    (
        &["guides:[\"", "\"block\"", "\"sleeve\"", "\"cylinder\"", "\"slotted_bar\"", "\"yoke\""],
        include_str!("slides.js"),
        include_str!("slides.css"),
    ),
    (&["springs:[{"], include_str!("springs.js"), ""),
    (&["\nholding: "], include_str!("held.js"), ""),
    (&["params:[{"], include_str!("tolerance.js"), include_str!("tolerance.css")),
    (&["params:[{"], include_str!("defaults.js"), ""),
    (&["words:["], include_str!("modes.js"), include_str!("modes.css")),
    (&["wanted:[{"], include_str!("wanted.js"), ""),
    (&["_dynamics: "], include_str!("run.js"), ""),
];

/// The file that begins the page, behind all others.
pub(super) const BEGINS: [&str; 1] = [include_str!("page.js")];

/// The style of all pages, and what stands on them.
pub(super) const STYLE: &str = include_str!("page.css");
pub(super) const SKELETON: &str = include_str!("page.html");

/// Every file of the run-time.
pub(super) fn every_file() -> Vec<&'static str> {
    let parts: Vec<&str> = PARTS.iter().map(|(_, file, _)| *file).collect();
    [&ARITHMETIC[..], &SEARCH, &FRICTION, &READS, &RANGES, &SHOWS, &parts, &BEGINS].concat()
}
