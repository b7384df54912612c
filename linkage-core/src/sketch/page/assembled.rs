//! A page from texts: those of a declaration, which a macro or a program has printed, and those of the run-time.

use std::format;
use std::string::{String, ToString};

use super::declared::Declared;
use super::json::{list, number, object, string};
use super::settings::Wishes;
use super::squeeze;
use crate::sketch::drawn::spaced;
use crate::sketch::sketch_error::SketchError;
use crate::sketch::svg::escaped;

/// The files that compute and decide.
pub(super) const ARITHMETIC: [&str; 3] =
    [include_str!("kernels.js"), include_str!("limit.js"), include_str!("checks.js")];

/// The files of the search for an unknown, which a page without one does without.
pub(super) const SEARCH: [&str; 2] = [include_str!("roots.js"), include_str!("survey.js")];

/// The file that solves for friction, which a page of a machine without any does without.
pub(super) const FRICTION: [&str; 1] = [include_str!("friction.js")];

/// The files that read the results, without a document.
pub(super) const READS: [&str; 4] = [
    include_str!("words.js"),
    include_str!("pose.js"),
    include_str!("drag.js"),
    include_str!("ranges.js"),
];

/// The files of all that a reader sees and sets.
pub(super) const SHOWS: [&str; 6] = [
    include_str!("picture.js"),
    include_str!("symbols.js"),
    include_str!("curves.js"),
    include_str!("acts.js"),
    include_str!("controls.js"),
    include_str!("page.js"),
];

/// A mechanism as its page has it.
#[derive(Clone, Copy, Debug)]
pub struct Machine<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its doc comment, in one line.
    pub docs: &'a str,
    /// Its declaration.
    pub declared: Declared<'a>,
    /// Its parameters' values; of a mode +1 or −1.
    pub values: &'a [f64],
}

/// The page of a mechanism.
///
/// # Errors
/// `UnknownName` for a curve, a range, a rate or a load of nothing that is declared.
pub fn html(machine: &Machine<'_>, wishes: &Wishes) -> Result<String, SketchError> {
    let Machine { name, docs, declared, values } = machine;
    wishes.check(declared)?;
    let spaced = spaced(name);
    let title = wishes.title.as_deref().unwrap_or(&spaced);
    let texts = |texts: &[String]| list(texts.iter().map(|text| string(text)));
    let options = object([
        ("inputs", wishes.inputs(declared)),
        ("params", wishes.params(declared, values)),
        ("loads", wishes.loads(declared)),
        ("traces", texts(&wishes.traces)),
        ("curves", texts(&wishes.curves)),
        ("path", list(wishes.path.iter().map(|q| list(q.iter().map(|&x| number(x)))))),
        ("text", string(declared.text)),
    ]);
    let machine = format!(
        "const PLAN = {};\nconst PAGE = {options};\nconst MACHINE = {};\n",
        declared.plan, declared.script
    );
    let where_called = |call: &str, files: &'static [&'static str]| {
        if declared.script.contains(call) { files } else { &[] }
    };
    let (search, friction) =
        (where_called("c.root(", &SEARCH), where_called("amountsOf(", &FRICTION));
    let parts = [&ARITHMETIC[..], search, friction, &READS];
    let computes = format!("\"use strict\";\n{machine}{}", squeeze::script(&parts.concat()));
    let shows = format!("\"use strict\";\n{}", squeeze::script(&SHOWS));
    Ok(filled(&[
        ("style", &squeeze::style(include_str!("page.css"))),
        ("title", &escaped(title)),
        ("docs", &escaped(docs)),
        ("computes", &unclosed(&computes)),
        ("shows", &unclosed(&shows)),
    ]))
}

/// The skeleton of a page with these texts in its gaps.
fn filled(texts: &[(&str, &str)]) -> String {
    let mut parts = include_str!("page.html").split("{{");
    let mut page = parts.next().unwrap_or_default().to_string();
    for part in parts {
        let (gap, rest) = part.split_once("}}").unwrap_or((part, ""));
        let text = texts.iter().find(|(name, _)| *name == gap).map_or("", |(_, text)| text);
        page += text;
        page += rest;
    }
    page
}

/// The script with nothing that would end its element: texts alone hold such, where a backslash changes
/// nothing.
fn unclosed(script: &str) -> String {
    script.replace("</", "<\\/").replace("<!--", "<\\!--")
}
