//! Derivatives of `tests/src/mechanisms/differentiated.rs` by their inputs and dimensions.

use std::sync::LazyLock;

use super::text::{after, all_of, lines_of, numbers, parts};

/// A number to about 22 digits, high part and low part, and its condition.
pub type Slope = (f64, f64, f64);

/// A state, and a column for every input and then for every dimension: all rows' slopes.
#[derive(Debug)]
pub struct Case {
    pub is_flipped: bool,
    pub numbers: Vec<f64>,
    pub columns: Vec<Vec<Slope>>,
}

macro_rules! cases {
    ($($name:ident)+) => {$(
        pub static $name: LazyLock<Vec<Case>> = LazyLock::new(|| read(stringify!($name)));
    )+};
}

cases! { BARS PRESS QUICK_RETURN CROSSED_GUIDES YOKE MANIPULATOR }

/// A case is a line `case declared | numbers` or `case flipped | numbers`, and a line for every
/// column.
fn read(table: &str) -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    let mut lines = lines_of(include_str!("slopes.txt"), table);
    let outputs = after("outputs", lines.next()).split(' ').count();
    for line in lines {
        if line.starts_with("case ") {
            let [mode, given] = all_of(parts(after("case", Some(line))));
            let is_flipped = mode == "flipped";
            assert!(is_flipped || mode == "declared", "no mode: {line}");
            cases.push(Case { is_flipped, numbers: numbers(given), columns: Vec::new() });
        } else {
            let slope = |part| all_of(numbers(part)).into();
            let column: Vec<Slope> = parts(line).map(slope).collect();
            assert_eq!(column.len(), outputs, "{line}");
            cases.last_mut().expect("a line `case …`").columns.push(column);
        }
    }
    cases
}
