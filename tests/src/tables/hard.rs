//! Hard poses of single groups; `hard.txt` says what they are.

use std::sync::LazyLock;

use super::text::{after, all_of, lines_of, numbers, parts};

/// One pose with what a solver should answer.
#[derive(Debug)]
pub struct Case {
    pub name: &'static str,
    pub inputs: Vec<f64>,
    /// High part, low part, achievable absolute error.
    pub truth: Vec<(f64, f64, f64)>,
}

macro_rules! cases {
    ($($name:ident)+) => {$(
        pub static $name: LazyLock<Vec<Case>> = LazyLock::new(|| read(stringify!($name)));
    )+};
}

cases! { RRR RRR_F32 FOUR_BAR_LEFT FOUR_BAR_RIGHT KITE PRP RPP RPR SLIDER_CRANK }

/// A case is a line `case NAME | inputs`, and a line for every number of the truth.
fn read(table: &str) -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    for line in lines_of(include_str!("hard.txt"), table) {
        if line.starts_with("case ") {
            let [name, inputs] = all_of(parts(after("case", Some(line))));
            cases.push(Case { name, inputs: numbers(inputs), truth: Vec::new() });
        } else {
            let [high, low, achievable] = all_of(numbers(line));
            let case = cases.last_mut().expect("a line `case …`");
            case.truth.push((high, low, achievable));
        }
    }
    cases
}
