//! A page from texts: those of a declaration, which a macro or a program has printed, and those of the run-time.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::declared::Declared;
use super::json::{list, number, object, string};
use super::names::script;
use super::page_files::{
    ARITHMETIC, BEGINS, FRICTION, PARTS, RANGES, READS, SEARCH, SHOWS, SKELETON, STYLE,
};
use super::settings::Wishes;
use super::squeeze;
use crate::sketch::drawn::spaced;
use crate::sketch::sketch_error::SketchError;
use crate::sketch::svg::escaped;

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
    wishes.check(&machine.declared)?;
    let Parts { plan, options, script } = Parts::of(machine, wishes);
    let consts = format!(
        "const BY = null;\nconst PLAN = {plan};\nconst PAGE = {options};\nconst MACHINE = {script};\n"
    );
    Ok(written([machine.name, machine.docs], &consts, wishes))
}

/// The page of a machine that has several sets of inputs, each with its name and the mechanism that it drives. The first
/// drives the page, until a reader chooses another. One set alone is a page without a choice. A wish is one of the sets that
/// have what it names, and a path is the first set's.
///
/// # Errors
/// `UnknownName` for a curve, a range, a rate or a load of nothing that is declared.
pub fn html_of_sets(
    name: &str,
    sets: &[(&str, Machine<'_>)],
    wishes: &Wishes,
) -> Result<String, SketchError> {
    if let [(_, machine)] = sets {
        return html(machine, wishes);
    }
    let all: Vec<_> = sets.iter().map(|(_, machine)| machine.declared).collect();
    let wishes_of = wishes.of_each(&all)?;
    let objects = sets.iter().zip(&wishes_of).map(|((set, machine), wishes)| {
        let Parts { plan, options, script } = Parts::of(machine, wishes);
        object([
            ("set", string(set)),
            ("plan", plan.to_string()),
            ("page", options),
            ("machine", script.to_string()),
        ])
    });
    let consts = format!("const SETS = {};\n{CHOSEN}", list(objects));
    let docs = sets.first().map_or("", |(_, machine)| machine.docs);
    Ok(written([name, docs], &consts, wishes))
}

/// The choice among several sets of the one that drives: by the page around this one, or by the address.
const CHOSEN: &str = r#"const asksFor = ({ set }) => (globalThis.STATE || (globalThis.location?.hash ?? "").slice(1)).split("&").includes(`~by=${encodeURIComponent(set)}`);
const BY = SETS.find(asksFor) ?? SETS[0];
const { plan: PLAN, page: PAGE, machine: MACHINE } = BY;
"#;

/// Objects of JavaScript: what is drawn, what a reader may set, and what computes.
struct Parts<'a> {
    plan: &'a str,
    options: String,
    script: &'a str,
}

impl<'a> Parts<'a> {
    fn of(Machine { declared, values, .. }: &Machine<'a>, wishes: &Wishes) -> Self {
        let texts = |texts: &[String]| list(texts.iter().map(|text| string(text)));
        let options = object([
            ("inputs", wishes.inputs(declared)),
            ("params", wishes.params(declared, values)),
            ("loads", wishes.loads(declared)),
            ("traces", texts(&wishes.traces)),
            ("curves", texts(&wishes.curves)),
            ("path", list(wishes.path.iter().map(|q| list(q.iter().map(|&x| number(x)))))),
            ("before", list(wishes.before.iter().map(|&x| number(x)))),
            ("points", list(wishes.points.iter().map(pair))),
            ("wanted", list(wishes.wanted.iter().map(wanted))),
            ("text", string(declared.text)),
        ]);
        Self { plan: declared.plan, options, script: declared.script }
    }
}

fn pair([x, y]: &[f64; 2]) -> String {
    list([number(*x), number(*y)])
}

fn wanted((output, pairs): &(String, Vec<[f64; 2]>)) -> String {
    object([("output", string(output)), ("pairs", list(pairs.iter().map(pair)))])
}

/// A page around the constants of its machine.
fn written([name, docs]: [&str; 2], consts: &str, wishes: &Wishes) -> String {
    let spaced = spaced(name);
    let title = wishes.title.as_deref().unwrap_or(&spaced);
    let has = |found: &str| consts.contains(found);
    let where_has =
        |found: &str, files: &'static [&'static str]| if has(found) { files } else { &[] };
    let (search, friction, ranges) = (
        where_has("c.root(", &SEARCH),
        where_has("amountsOf(", &FRICTION),
        where_has("from:NaN", &RANGES),
    );
    let parts = [&ARITHMETIC[..], search, friction, &READS, ranges];
    let computes = [&[consts], &parts.concat()[..]].concat();
    let computes = format!("\"use strict\";\n{}", script(&computes));
    let own = PARTS.iter().filter(|(found, ..)| found.iter().any(|found| has(found)));
    let (own, styles): (Vec<_>, Vec<_>) = own.map(|(_, file, style)| (*file, *style)).unzip();
    let shown = [&SHOWS, &own[..], &BEGINS].concat();
    let shows = format!("\"use strict\";\n{}", script(&shown));
    filled(&[
        ("style", &squeeze::style(&[&[STYLE], &styles[..]].concat())),
        ("title", &escaped(title)),
        ("docs", &escaped(docs)),
        ("computes", &unclosed(&computes)),
        ("shows", &unclosed(&shows)),
    ])
}

/// The skeleton of a page with these texts in its gaps.
fn filled(texts: &[(&str, &str)]) -> String {
    let skeleton = squeeze::markup(SKELETON);
    let mut parts = skeleton.split("{{");
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
