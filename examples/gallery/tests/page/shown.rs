//! The numbers that a reader sees on a page, read back: table, CSV, ticks, legends and status of twenty machines and
//! more, each within its printed digits of the solver's.

use core::f64::consts::TAU;

use gallery::declarations::*;
use linkage_core::sketch::shortened;
use linkage_core::{Mechanism, Record, Solver};

use super::browser::{Visit, scripted};
use super::numbers::Forces;

/// Tells what is seen at three places of the first input, a line a thing; the charts of all outputs at one of them.
const READ: &str = r##"
addEventListener("load", () => setTimeout(() => {
  const out = [], say = (...cells) => out.push(cells.map((cell) => String(cell).replaceAll("\u00a0", " ")).join("|"));
  const at = (node, name) => node.getAttribute(name), isShown = (node) => at(node, "visibility") !== "hidden";
  // Places are rounded to a tenth of a pixel.
  const readCharts = () => charts.filter(({ svg }) => svg.style.display !== "none").forEach(({ title, ticks, series, labels, dots, cursor, left, height }) => {
    const texts = [...ticks.children].map((text) => [text.textContent, +at(text, "x"), +at(text, "y")]);
    const beside = texts.filter(([, x]) => Math.abs(x - left + 7) < 0.06), across = texts.filter(([, , y]) => y === height - 6);
    say("chart", title.textContent, beside.find(([, , y]) => y === 15)?.[0] ?? "");
    for (const [words, , y] of beside) if (y !== 15) say("up", words, y);
    for (const [words, x] of across) say("across", words, x);
    say("cursor", /M([-\d.]+)/.exec(at(cursor, "d"))[1]);
    series.forEach(({ name }, k) => say("series", name, labels[k].textContent.trim(), isShown(dots[k]) ? /,([-\d.]+)\)/.exec(at(dots[k], "transform"))[1] : ""));
  });
  const show = () => {
    // The table is told at once.
    told = 0;
    due = CURVES;
    frame();
  };
  play(false);
  const places = [...samples.keys()].filter((k) => !samples[k].refused);
  for (const share of [0.07, 0.42, 0.8]) {
    const k = places[Math.floor(share * places.length)];
    state.q = withInput(0, samples[k].x);
    show();
    say("pose", state.q.join(), rates().join(), state.l.join());
    say("status", $("#state").textContent);
    const lines = csv().trim().split("\n").filter((line) => !line.startsWith("# "));
    say("head", ...lines[0].split(","));
    say("line", ...lines[k + 1].split(","));
    for (const { "cells": cells } of $("#values")["rows"]) if (cells[1].tagName === "TD") say("row", ...[...cells].map((cell) => cell.textContent));
    if (share === 0.42) for (const name of offered) {
      showCurvesOf(name);
      show();
      readCharts();
    }
  }
  parent.postMessage({ failures: [], "told": [...out, "read"] }, "*");
}, 300));
"##;

type Motion = Box<dyn Fn(&[f64], &[f64]) -> Vec<(&'static str, [f64; 3])>>;
type Efforts = Box<dyn Fn(&[f64], &[f64], &[f64]) -> Vec<f64>>;

/// A page and what computes its numbers: rows by their names with two derivatives, and the numbers of forces.
struct Machine {
    name: &'static str,
    motion: Motion,
    forces: Efforts,
}

fn machine<S: Solver<Scalar = f64> + 'static>(
    name: &'static str,
    solver: S,
    forces: Forces<S, S::Input>,
) -> Machine {
    let motion = move |q: &[f64], v: &[f64]| {
        let given = |list: &[f64]| <S as Mechanism>::inputs(|k| list[k]);
        let still = <S as Mechanism>::inputs(|_| 0.0);
        let rows = Mechanism::motion(&solver, given(q), given(v), still).expect("it stands");
        let of = |k: usize| rows.each_ref().map(|rows| rows.as_ref()[k]);
        S::TITLES.outputs.iter().enumerate().map(|(k, name)| (*name, of(k))).collect()
    };
    let asked = move |q: &[f64], v: &[f64], loads: &[f64]| {
        let given = |list: &[f64]| S::input(|k| list[k]);
        let answers = forces(&solver, [given(q), given(v), S::input(|_| 0.0)], loads);
        let own = answers.into_iter().find(|(name, _)| *name == "forces");
        own.map_or(Vec::new(), |(_, numbers)| numbers.expect("they follow"))
    };
    Machine { name, motion: Box::new(motion), forces: Box::new(asked) }
}

/// A number as it is written, in SI, and half of its last digit. A zero stands for what rounding leaves.
fn number(text: &str, unit: &str) -> (f64, f64) {
    let is_digit = |c: char| "−-.0123456789·⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c);
    let text = text.trim();
    let (written, own) = text.split_at(text.find(|c| !is_digit(c)).unwrap_or(text.len()));
    let (digits, power) = written.split_once("·10").unwrap_or((written, "⁰"));
    let raised = |c: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|own| own == c);
    let power = power.chars().map(|c| raised(c).map_or("-".to_string(), |k| k.to_string()));
    let tens: i32 = power.collect::<String>().parse().expect("a power of ten");
    let value: f64 = digits.replace('−', "-").parse().unwrap_or_else(|_| panic!("{text:?}"));
    let decimals = digits.split_once('.').map_or(0, |(_, behind)| behind.len()) as i32;
    let size = size_of(if own.trim().is_empty() { unit } else { own.trim() });
    let by = if digits == "0" { 0.0 } else { 0.5 * 10_f64.powi(tens - decimals) };
    (value * 10_f64.powi(tens) * size, by * size)
}

/// A unit in SI: all rates are by the second.
fn size_of(unit: &str) -> f64 {
    let base = unit.split('/').next().unwrap_or_default();
    let bases = ["m", "N", "N·m", "W"];
    let mut prefixes = "afpnµm kMG".chars().zip((-6..).map(|k| 10_f64.powi(3 * k)));
    let prefixed = prefixes
        .find(|(prefix, _)| base.strip_prefix(*prefix).is_some_and(|rest| bases.contains(&rest)));
    match base {
        "°" => 1_f64.to_radians(),
        "" | "1" => 1.0,
        _ if bases.contains(&base) => 1.0,
        _ => prefixed.unwrap_or_else(|| panic!("{unit:?}")).1,
    }
}

/// The counts of numbers read.
#[derive(Default, Debug)]
struct Count {
    status: usize,
    cells: usize,
    csv: usize,
    ticks: usize,
    legends: usize,
    dots: usize,
    /// The faults, by machine.
    faults: Vec<String>,
}

impl Count {
    fn is_near(&mut self, found: f64, expected: f64, by: f64, place: &str) {
        // A half may be rounded either way.
        let by = 1.001 * by + 1e-14 * expected.abs();
        if (found - expected).abs() <= by {
            return;
        }
        self.faults.push(format!("{place}: {found:e} for {expected:e} within {by:e}"));
    }
}

/// The solver's numbers in the pose that is read.
#[derive(Default)]
struct Pose<'t> {
    q: Vec<f64>,
    rows: Vec<(&'static str, [f64; 3])>,
    forces: Vec<f64>,
    /// The names of forces, in the order of their numbers.
    efforts: Vec<&'t str>,
}

impl<'t> Pose<'t> {
    fn of(machine: &Machine, [q, rates, loads]: [&str; 3]) -> Self {
        let list = |text: &str| text.split(',').filter_map(|x| x.parse().ok()).collect();
        let [q, rates, loads]: [Vec<f64>; 3] = [q, rates, loads].map(list);
        let (rows, forces) = ((machine.motion)(&q, &rates), (machine.forces)(&q, &rates, &loads));
        Self { q, rows, forces, efforts: Vec::new() }
    }

    /// A number and its derivatives. A page says of one that is an angle that it is.
    fn row(&self, name: &str) -> Option<[f64; 3]> {
        let is_it = |row: &str| row == name || name.strip_suffix(".angle") == Some(row);
        self.rows.iter().find(|(row, _)| is_it(row)).map(|(_, orders)| *orders)
    }

    /// The row of this name with this order, and the share of the largest that counts as rounding.
    fn value(&self, name: &str, order: usize) -> Option<(f64, f64)> {
        let largest = |list: &mut dyn Iterator<Item = f64>| list.map(f64::abs).fold(0.0, f64::max);
        if let Some(orders) = self.row(name) {
            let all = largest(&mut self.rows.iter().map(|(_, orders)| orders[order]));
            return Some((orders[order], 1e-8 * all));
        }
        let k = self.efforts.iter().position(|effort| *effort == name)?;
        Some((self.forces[k], 1e-8 * largest(&mut self.forces.iter().copied())))
    }

    /// Names of columns without a row are those of forces.
    fn head(&mut self, names: &[&'t str]) {
        let labels = names.iter().filter_map(|name| Some(name.split_once(" [")?.0)).skip(1);
        let is_row = |label: &str| {
            let own = label.split_once(" of ").map_or(label, |(_, own)| own);
            self.row(own).is_some()
        };
        let is_effort = |label: &&str| !is_row(label) && !label.contains(" at rest ");
        self.efforts = labels.filter(is_effort).collect();
        assert_eq!(self.efforts.len(), self.forces.len(), "{:?} {names:?}", self.efforts);
        // Every row has all three orders.
        let with = |word: &str| names.iter().filter(|name| name.contains(word)).count();
        let [velocities, accelerations] = ["velocity of ", "acceleration of "].map(with);
        let others = 2 + velocities + accelerations + self.forces.len() + with(" at rest ");
        assert_eq!([velocities, accelerations], [names.len() - others; 2], "{names:?}");
    }

    /// A line of the CSV: numbers in SI, all digits of them.
    fn line(&self, names: &[&str], cells: &[&str], count: &mut Count) {
        for (name, cell) in names.iter().zip(cells).skip(1) {
            let Some((label, _)) = name.split_once(" [") else { continue };
            let orders = [("acceleration of ", 2), ("velocity of ", 1), ("", 0)];
            let own = orders
                .iter()
                .find_map(|(word, order)| self.value(label.strip_prefix(word)?, *order));
            let Some((expected, _)) = own else { continue };
            let found: f64 = cell.parse().expect("a number");
            // The arc tangent of angles alone may round otherwise.
            count.is_near(found, expected, 1e-15 * (1.0 + expected.abs()), name);
            count.csv += 1;
        }
        assert_eq!(cells[0].parse(), Ok(self.q[0]));
    }
}

#[derive(Default)]
struct Chart<'t> {
    title: &'t str,
    unit: &'t str,
    /// Values in SI and their heights.
    up: Vec<(f64, f64)>,
    across: Vec<(&'t str, f64)>,
}

impl<'t> Chart<'t> {
    /// The value at a place between ticks, and what a third of a pixel is: all are rounded to a tenth.
    fn read(ticks: &[(f64, f64)], at: f64) -> Option<(f64, f64)> {
        let [(a, from), .., (b, to)] = ticks[..] else { return None };
        let slope = (b - a) / (to - from);
        Some((a + slope * (at - from), 0.3 * slope.abs()))
    }

    /// The last tick has the unit of all, and may stand elsewhere to be seen.
    fn cursor(&self, q: f64, x: f64, count: &mut Count) {
        let Some(((last, _), inner)) = self.across.split_last() else { return };
        let unit =
            last.trim_start_matches(|c: char| "−-.0123456789·⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(c)).trim();
        let ticks: Vec<_> = inner.iter().map(|(words, x)| (number(words, unit).0, *x)).collect();
        let Some((found, by)) = Self::read(&ticks, x) else { return };
        count.is_near(found, q, by, self.title);
        // Steps are equal.
        for pair in ticks.windows(3) {
            let [(a, u), (b, v), (c, w)] = [pair[0], pair[1], pair[2]];
            assert!(
                (2.0 * b - a - c).abs() < 1e-9 * (c - a).abs() && (2.0 * v - u - w).abs() < 0.31
            );
        }
        count.ticks += ticks.len() + self.up.len();
    }

    /// The number in the legend and the dot of a curve.
    fn series(&self, [name, label, y]: [&str; 3], pose: &Pose<'_>, count: &mut Count) {
        let orders = ["Position of ", "Velocity of ", "Acceleration of "];
        let order = orders.iter().position(|word| self.title.starts_with(word));
        let of = order.map_or(self.title, |order| &self.title[orders[order].len()..]);
        let row = if name.is_empty() { of.to_string() } else { format!("{of}.{name}") };
        let place = format!("{} {name}", self.title);
        let order = order.unwrap_or(0);
        let (expected, noise) = pose.value(&row, order).unwrap_or_else(|| panic!("no row {row}"));
        if label.is_empty() {
            return;
        }
        let (found, by) = number(label.strip_prefix(name).unwrap_or(label), "");
        count.is_near(found, expected, by + noise, &place);
        count.legends += 1;
        let Ok(y) = y.parse::<f64>() else { return };
        // Texts stand 4 px below their lines.
        let Some((found, by)) = Self::read(&self.up, y + 4.0) else { return };
        let turn = if name == "angle" && order == 0 { TAU } else { f64::INFINITY };
        let turns = if turn.is_finite() { ((found - expected) / turn).round() * turn } else { 0.0 };
        count.is_near(found - turns, expected, by + noise, &place);
        count.dots += 1;
    }
}

/// Everything of a page that was told.
fn check(machine: &Machine, lines: &[Vec<&str>], count: &mut Count) {
    let (mut pose, mut chart, mut names) = (Pose::default(), Chart::default(), Vec::new());
    for line in lines {
        match line[..] {
            ["pose", q, rates, loads] => pose = Pose::of(machine, [q, rates, loads]),
            ["status", text] => {
                for (words, q) in text.split("  ·  ").zip(&pose.q) {
                    let (found, by) = number(words.split_once(' ').expect("a name").1, "");
                    count.is_near((found - q + 1.0).rem_euclid(TAU), 1.0, by, text);
                    count.status += 1;
                }
            }
            ["head", ref all @ ..] => {
                names = all.to_vec();
                pose.head(all);
            }
            ["line", ref cells @ ..] => pose.line(&names, cells, count),
            ["row", label, ref cells @ ..] if !label.ends_with(" at rest") => {
                for (order, cell) in cells.iter().enumerate() {
                    let own = pose.value(label, order).unwrap_or_else(|| panic!("no row {label}"));
                    let (found, by) = number(cell, "");
                    count.is_near(found, own.0, by + own.1, &format!("{label} {order}"));
                    count.cells += 1;
                }
            }
            ["chart", title, unit] => chart = Chart { title, unit, ..Chart::default() },
            ["up", words, y] => chart.up.push((number(words, chart.unit).0, y.parse().unwrap())),
            ["across", words, x] => chart.across.push((words, x.parse().unwrap())),
            ["cursor", x] => chart.cursor(pose.q[0], x.parse().unwrap(), count),
            ["series", name, label, y] => chart.series([name, label, y], &pose, count),
            _ => {}
        }
    }
}

#[test]
#[ignore = "needs chromium"]
fn every_number_that_a_page_shows_is_the_solvers() {
    macro_rules! all {
        ($($module:ident::$name:ident $forces:expr),* $(,)?) => {
            [$(machine(concat!(stringify!($module), "::", stringify!($name)), $module::$name::new(), $forces)),*]
        };
    }
    let machines = all![
        flying_shear::FlyingShear no_forces!(),
        four_bar::FourBar no_forces!(),
        electronic_cam::FlyingShear no_forces!(),
        function_generator::FunctionGenerator no_forces!(),
        dead_point::ByLeft no_forces!(),
        run_up::FourBar forces!(),
        counterweight::FourBar forces!(),
        slider_crank::OffsetSliderCrank no_forces!(),
        crank_rocker_slider::CrankRockerSlider no_forces!(),
        crank_rpp::CrankYoke no_forces!(),
        whitworth::Shaper no_forces!(),
        whitworth::Whitworth no_forces!(),
        range::Shaper no_forces!(),
        six_bar::SixBar no_forces!(),
        jansen_leg::JansenLeg no_forces!(),
        calibration::SixBar no_forces!(),
        set_point::Press no_forces!(),
        excavator::Excavator no_forces!(),
        five_bar_robot::Forward no_forces!(),
        transplanter::Transplanter no_forces!(),
        driving_torque::FourBar forces!(),
        press_friction::CutPress forces!(load),
        shear_bearings::FlyingShear forces!(load),
        six_bar_reactions::SixBar forces!(),
    ];
    let pages = gallery::live::pages().unwrap();
    let mut count = Count::default();
    for machines in machines.chunks(5) {
        let visit = |machine: &Machine| {
            let page = pages.iter().find(|(name, _)| *name == machine.name);
            let html = page.expect("it has a page").1.clone();
            Visit { name: machine.name, html, width: 1280, steps: "" }
        };
        let visits: Vec<Visit> = machines.iter().map(visit).collect();
        let found = scripted(&visits, "shown", &["--force-prefers-reduced-motion"], |_| {
            shortened(&format!("{{ {READ} }}"))
        });
        assert_eq!(found.matches("\n  read").count(), machines.len(), "{found}");
        for machine in machines {
            let title = format!("{} 1280\n", machine.name);
            let (_, own) = found.split_once(&title).expect("it is told");
            let own = own.lines().take_while(|line| line.starts_with("  "));
            let lines: Vec<Vec<&str>> = own.map(|line| line[2..].split('|').collect()).collect();
            let before = count.faults.len();
            check(machine, &lines, &mut count);
            let own = count.faults[before..].iter_mut();
            own.for_each(|fault| *fault = format!("{}: {fault}", machine.name));
        }
    }
    println!("{count:?}");
    let Count { status, cells, csv, ticks, legends, dots, faults } = count;
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(status > 70 && cells > 500 && csv > 500 && ticks > 500 && legends > 200 && dots > 300);
}
