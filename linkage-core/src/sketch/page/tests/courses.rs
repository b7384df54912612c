//! Courses of functions whose zeros and dead points samples meet exactly, with the crate's own answers.

use std::string::String;
use std::vec::Vec;
use std::{format, vec};

use super::cases::{Case, Random, bits};
use crate::roots::{At, surveyed};

/// Products of factors x − r, most of them at places that halving comes to: a root is then a sample of value zero,
/// and a double root a dead point of it. Slopes that are not the product's, and a pit that no sample need meet, lead
/// cubics astray; so few evaluations that they run out come in as well. Two equal cells have two equal dips, and an
/// interval of some units in the last place is soon divided down to neighbouring numbers.
pub(super) fn courses() -> impl Iterator<Item = Case> {
    let mut random = Random::new(31);
    (0..30_000).map(move |_| {
        let mut below = |count: u64| random.bits() % count;
        let mut roots: Vec<f64> = Vec::new();
        for _ in 0..=below(6) {
            // Sixteenths are met by halving; tenths are not.
            let parts = if below(4) == 0 { 10.0 } else { 16.0 };
            let root = (below(49) as f64 - 24.0) / parts;
            roots.extend(vec![root; 1 + usize::from(below(3) == 0)]);
        }
        let mut inner = [below(17), below(17)].map(|eighth| eighth as f64 / 8.0 - 1.0);
        inner.sort_by(f64::total_cmp);
        let factor = if below(2) == 0 { 1.0 } else { -1.0 };
        let share = [1.0, 1.0, 1.0, 1.0, 0.0, -1.0, 3.0][below(7) as usize];
        let most = if below(3) == 0 { below(30) } else { 70 };
        let depth = if below(3) == 0 { 0.1 } else { 0.0 };
        let [pit, width] = [below(2001) as f64 / 1000.0 - 1.0, below(100) as f64 / 1000.0];
        let unit = if below(8) == 0 { f64::EPSILON * (1 + below(16)) as f64 } else { 1.0 };
        let is_in_cells = below(8) == 0;
        // What is raised everywhere keeps its dips above zero.
        let [depth, pit, width] = if is_in_cells { [-0.02, 0.0, 9.0] } else { [depth, pit, width] };
        let cells = f64::from(u8::from(is_in_cells));
        let head = [most as f64, inner[0], inner[1], factor, share, depth, pit, width, cells, unit];
        let given = [&head[..], &roots].concat();
        let answer = answer(&given);
        Case { name: "course", given, answer }
    })
}

/// The function and its slope, rounded as the script rounds them, about one in some unit.
fn function(
    [factor, share, depth, pit, width, cells, unit]: [f64; 7],
    roots: &[f64],
    x: f64,
) -> [f64; 2] {
    let x = if unit == 1.0 { x } else { (x - 1.0) / unit };
    let x = if cells == 1.0 { x - x.floor() } else { x };
    let (mut value, mut slope) = (factor, 0.0);
    for root in roots {
        slope = slope * (x - root) + value;
        value *= x - root;
    }
    let lower = if (x - pit).abs() < width { depth } else { 0.0 };
    [value - lower, slope * share / unit]
}

fn answer(given: &[f64]) -> String {
    let [most, a, b, factor, share, depth, pit, width, cells, unit, roots @ ..] = given else {
        unreachable!()
    };
    let f = |x: f64| function([*factor, *share, *depth, *pit, *width, *cells, *unit], roots, x);
    let place = |at: f64| if *unit == 1.0 { at } else { 1.0 + at * unit };
    let places = [-1.0, *a, *b, 1.0].map(place);
    let (word, places, evaluations) = surveyed(f, places, *most as u32);
    let numbers = places.iter().flat_map(|&At { x, value, slope }| [x, value, slope]);
    let numbers: Vec<String> = numbers.map(bits).collect();
    format!("{word} {evaluations} {}", numbers.join(" "))
}

/// The course as the script has it.
pub(super) const COURSE: &str = r#"
const course = ([most, a, b, factor, share, depth, pit, width, cells, unit, ...roots]) => {
  const f = new Equation(1, (x) => {
    if (unit !== 1) x = (x - 1) / unit;
    if (cells === 1) x -= Math.floor(x);
    let [value, slope] = [factor, 0];
    for (const root of roots) {
      slope = slope * (x - root) + value;
      value *= x - root;
    }
    return [value - (Math.abs(x - pit) < width ? depth : 0), (slope * share) / unit];
  });
  const places = [-1, a, b, 1].map((x) => f.at(unit === 1 ? x : 1 + x * unit)), found = courseOf(f, places, most);
  const word = found.rises ? "rises" : found.zero ? "zero" : found.isKnown ? "never" : "unknown";
  const met = [...(found.rises ?? []), found.zero, found.nearest, ...(found.falling ?? [])].filter((at) => at);
  return `${word} ${f.evaluations} ${met.flatMap(({ x, value, slope }) => [x, value, slope]).map(bits).join(" ")}`;
};
"#;
