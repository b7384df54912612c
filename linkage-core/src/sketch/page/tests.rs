//! The script's arithmetic and its decisions at limits, against those of the crate, to the bit.

mod amounts;
mod cases;
mod courses;
mod node;
mod refusals;
mod routines;
mod searches;
mod words;

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::page_files::{
    ARITHMETIC, BEGINS, FRICTION, PARTS, RANGES, READS, SEARCH, SHOWS, SKELETON, STYLE,
};
use super::{names, squeeze};
use crate::sketch::style::Theme;
use amounts::amounts;
use cases::{Case, conditions, kernels};
use courses::{COURSE, courses};
use refusals::{REFUSALS, refusals};
use routines::{ROUTINE, routines};
use searches::{pieces, searches, steady};

/// Compares each line's answer with the script's own. Zeros of both signs differ, NaN are alike.
const COMPARE: &str = r#"
const number = (hex) => fromBits(parseInt(hex.slice(0, 8), 16), parseInt(hex.slice(8), 16));
const bits = (x) => Number.isNaN(x) ? "NaN" : [highBits(x), bytes.getUint32(4)].map((w) => w.toString(16).padStart(8, "0")).join("");
const functions = { sinCos, tan, asin, acos, atan, atan2, hypot, exp, ln, tanh, pow, det, mulErr, addErr, exactSum: (...terms) => exactSum(terms) };
// These are the browser's own: within a unit in the last place, as the crate's are.
const foreign = ["exp", "ln", "tanh", "pow"];
const isClose = (found, expected) => {
  const [a, b] = [found, expected].map((hex) => (hex === "NaN" ? NaN : number(hex)));
  return Object.is(a, b) || Math.abs(a - b) <= Math.max(2 * EPSILON * Math.abs(b), 5e-324);
};
const sought = ([from, to, trend, near, target, hole, share, ...terms], isSteady) => {
  const found = rootOf([from, to], trend, Number.isNaN(near) ? null : near, (x) => {
    let [value, slope] = [0, 0];
    for (let k = 0; k < terms.length; k += 3) {
      const [a, b, c] = terms.slice(k, k + 3), [sin, cos] = sinCos(b * x + c);
      [value, slope] = [value + a * sin, slope + a * b * cos];
    }
    return [x > hole ? NaN : value, target, slope * share];
  }, isSteady);
  const { kind, isOrdered, by, at, other } = found, of = (x) => (x === undefined ? [] : [bits(x)]);
  if (!kind) return found.map(bits).join(" ");
  if (kind === "Interval") return `${kind} ${isOrdered}`;
  return [kind, ...of(by), ...of(at), ...(other ? [other.trend, bits(other.at)] : [])].join(" ");
};
const rubbing = ([count, guides, ...numbers]) => {
  const width = 3 + 2 * count, row = (j) => numbers.slice(count + j * width, count + (j + 1) * width);
  const places = Array.from({ length: count }, (_, j) => j), checks = new FirstError();
  const found = amountsOf(checks, numbers.slice(0, count), places.map(row), guides, places.map(String));
  return checks.error ? `${checks.error.kind} ${checks.error.group}` : found.map(bits).join(" ");
};
/// Steps are counted by the equations' evaluations: one at first, then one or two each.
const stepped = ([count, guides, ...numbers]) => {
  const width = 3 + 2 * count, rows = Array.from({ length: count }, (_, j) => numbers.slice(count + j * width, count + (j + 1) * width));
  const system = new System(rows, guides), { linear } = System.prototype, { values: start } = system.linear(system.none, hypot);
  let calls = 0;
  system.linear = (...given) => (calls++, linear.apply(system, given));
  const said = (found, steps) => (Array.isArray(found) ? [steps, ...found.map(bits)].join(" ") : "none");
  const solved = system.solved(), all = said(solved, calls <= UNGUARDED + 2 ? calls - 2 : UNGUARDED + (calls - UNGUARDED - 3) / 2);
  calls = 0;
  const guarded = system.guarded(start);
  return `${all} ${said(guarded, UNGUARDED + (calls - 1) / 2)}`;
};
const answer = (name, given) => {
  if (name === "steps") return stepped(given);
  if (name === "amounts") return rubbing(given);
  if (name === "routine") return routine(given);
  if (name === "course") return course(given);
  if (name === "blamed") return blamedOf(given);
  if (name === "closed") return closedOf(given);
  if (name === "piece") {
    const place = (k) => ({ x: given[k], value: given[k + 1], slope: given[k + 2] });
    const piece = new Open([place(1), place(4)], given[0]);
    return `${piece.isClear()} ${piece.onlyTurn()} ${bits(piece.remainderOfHalves(place(7)))}`;
  }
  if (name === "search") return sought(given, false);
  // The crate surveys what the script is told of the slope.
  if (name === "steady") return sought(given, true);
  if (functions[name]) return [functions[name](...given)].flat().map(bits).join(" ");
  const checks = new FirstError(), value = checks[name](...given, "group", "group");
  const { kind, group, by } = checks.error ?? {};
  return !kind ? bits(value) : by === undefined ? `${kind} ${group}` : `${kind} ${group} ${bits(by)}`;
};
const lines = require("fs").readFileSync(process.argv[2], "utf8").trim().split("\n");
let wrong = 0;
for (const line of lines) {
  const [asked, expected] = line.split(" : "), [name, ...given] = asked.split(" ");
  const found = answer(name, given.map(number));
  const isSame = found === expected || (foreign.includes(name) && isClose(found, expected));
  if (!isSame && ++wrong <= 5) console.log(`${name} ${given.map(number)}: ${found} for ${expected}`);
}
console.log(`${lines.length} compared, ${wrong} wrong`);
process.exitCode = wrong ? 1 : 0;
"#;

/// On a target with fused operations the crate rounds otherwise than a script can.
fn compare(cases: impl Iterator<Item = Case>) {
    if cfg!(any(target_feature = "fma", target_arch = "aarch64")) {
        return;
    }
    let lines: String = cases.map(|case| format!("{case}\n")).collect();
    let run_time = [&ARITHMETIC[..], &SEARCH, &FRICTION].concat().concat();
    let script = format!("{run_time}{COURSE}{ROUTINE}{REFUSALS}{COMPARE}");
    let Some(output) = node::run(&script, &lines) else { return };
    assert!(output.is_success, "{}", output.text);
}

#[test]
fn the_script_computes_the_same_bits() {
    compare(kernels());
}

#[test]
fn the_script_decides_alike_beside_limits() {
    compare(conditions());
}

#[test]
fn the_script_searches_alike() {
    compare(searches().chain(pieces()).chain(steady()));
}

/// Every kind of course is often met.
#[test]
fn the_script_surveys_alike() {
    let cases: Vec<Case> = courses().collect();
    for word in ["rises", "zero", "never", "unknown"] {
        let met = cases.iter().filter(|case| case.answer.starts_with(word)).count();
        assert!(met > 500, "{word}: {met} of {}", cases.len());
    }
    compare(cases.into_iter());
}

#[test]
fn the_script_leaves_the_fast_path_with_all_its_frictions() {
    compare(routines());
}

/// Every kind of answer is often met.
#[test]
fn the_script_blames_alike() {
    let cases: Vec<Case> = refusals().collect();
    let met = |answer: &str| cases.iter().filter(|case| case.answer.contains(answer)).count();
    for answer in ["result", "0", "3", "NotFinite x", "NoSolution x", "SeveralDeadPoints x", "fine"]
    {
        assert!(met(answer) > 100, "{answer}: {}", met(answer));
    }
    compare(cases.into_iter());
}

/// Every kind of answer is often met.
#[test]
fn the_script_solves_for_friction_alike() {
    let cases = amounts();
    for kind in ["Jams", "NotFinite", ""] {
        let is_it = |case: &&Case| case.answer.split(' ').next().is_some_and(|word| word == kind);
        let is_solved = |case: &&Case| case.answer.starts_with(|c: char| c.is_ascii_hexdigit());
        let met = match kind {
            "" => cases.iter().filter(is_solved).count(),
            _ => cases.iter().filter(is_it).count(),
        };
        assert!(met > 500, "{kind}: {met} of {}", cases.len());
    }
    compare(cases.into_iter());
}

/// A page weighs 53 kB at most beside the formulas, the names and the arithmetic that decides limits, and with all that a
/// machine can have 71 kB.
#[test]
fn a_page_is_light() {
    let weight = |scripts: &[&str], styles: &[&str]| {
        names::script(scripts).len() + squeeze::style(styles).len()
    };
    let script = [&READS[..], &SHOWS, &BEGINS].concat();
    let least = squeeze::markup(SKELETON).len() + weight(&script, &[STYLE]);
    assert!((50_000..53_000).contains(&least), "{least} bytes");
    let parts: Vec<&str> = PARTS.iter().map(|(_, file, _)| *file).chain(RANGES).collect();
    let styles: Vec<&str> = PARTS.iter().map(|(.., style)| *style).collect();
    let most = least + weight(&parts, &styles);
    assert!((60_000..71_000).contains(&most), "{most} bytes");
}

/// Links, reactions and loads have one colour on pages and in films.
#[test]
fn pages_and_films_have_the_same_colours() {
    let style = include_str!("page.css");
    let schemes: Vec<&str> = style.split(":root").skip(1).collect();
    for (scheme, theme) in schemes.iter().zip([Theme::Light, Theme::Dark]) {
        let palette = theme.palette();
        let links = palette.links.iter().enumerate().map(|(k, link)| (format!("l{k}"), *link));
        let others = [("push", palette.push), ("warn", palette.accent)];
        for (name, colour) in links.chain(others.map(|(name, colour)| (name.into(), colour))) {
            assert!(scheme.contains(&format!("--{name}: {colour};")), "{name} in {theme:?}");
        }
    }
}

/// Pointers of links with one joint, and what guides exceed their blocks by, have one length on pages and in films.
#[test]
fn pages_and_films_have_the_same_lengths() {
    let [picture, slides] = [include_str!("picture.js"), include_str!("slides.js")];
    assert!(picture.contains(&format!("const POINTER = {};", crate::sketch::bodies::POINTER)));
    assert!(slides.contains(&format!("const OVERRUN = {};", crate::sketch::style::OVERRUN)));
}

/// The relative luminance of a colour `#rrggbb` or `#rgb` (Web Content Accessibility Guidelines 2.2).
fn luminance(colour: &str) -> f64 {
    let digits: Vec<u32> = colour.chars().filter_map(|digit| digit.to_digit(16)).collect();
    let parts: Vec<u32> = match digits[..] {
        [r, g, b] => [r, g, b].map(|part| 17 * part).into(),
        _ => digits.chunks(2).map(|pair| 16 * pair[0] + pair[1]).collect(),
    };
    let linear = |part: u32| match f64::from(part) / 255.0 {
        part if part <= 0.04045 => part / 12.92,
        part => ((part + 0.055) / 1.055).powf(2.4),
    };
    0.2126 * linear(parts[0]) + 0.7152 * linear(parts[1]) + 0.0722 * linear(parts[2])
}

#[test]
fn every_text_has_contrast_in_both_schemes() {
    let style = include_str!("page.css");
    let schemes: Vec<&str> = style.split(":root").skip(1).collect();
    assert_eq!(schemes.len(), 2);
    for scheme in &schemes {
        // The dark scheme leaves some colours to the light one, and some are another one's.
        let set = |name: &str| {
            let of = |scheme: &&str| {
                scheme.split_once(&format!("--{name}: ")).map(|(_, set)| set.to_string())
            };
            let set = of(scheme).or_else(|| of(&schemes[0])).expect("it is there");
            set.split(';').next().unwrap_or_default().to_string()
        };
        let colour = |name: &str| {
            let own = set(name);
            let other = own.strip_prefix("var(--").and_then(|other| other.strip_suffix(')'));
            luminance(&other.map_or(own.clone(), set))
        };
        for (text, ground) in [
            ("ink", "paper"),
            ("ink", "faint"),
            ("quiet", "paper"),
            ("quiet", "faint"),
            ("warn", "paper"),
            ("accent", "faint"),
            ("on-accent", "accent"),
            ("push", "paper"),
            ("s0", "paper"),
            ("s1", "paper"),
            ("s2", "paper"),
        ] {
            let [a, b] = [colour(text), colour(ground)];
            let contrast = (a.max(b) + 0.05) / (a.min(b) + 0.05);
            assert!(contrast >= 4.5, "{text} on {ground}: {contrast:.2}");
        }
    }
}
