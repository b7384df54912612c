//! Errors of a group's forms over distances from its limit, the worst of many poses at each.

use charts::{Curve, Panel};
use linkage_tests::measured::families::{self, Family};
use linkage_tests::measured::poses::Source;
use linkage_tests::measured::{self, Measured, Pose, Width};

mod textbook;

use textbook::Answer;

/// The distances are 1e-1 to 1e-15.
pub const EXPONENTS: core::ops::RangeInclusive<u8> = 1..=15;

const POSES: usize = 2000;

/// One group next to one of its limits.
pub struct Sweep {
    /// The group and the limit.
    pub title: &'static str,
    /// The kind of the position error and that of the velocity error.
    pub measures: [&'static str; 2],
    /// First what the data allow, then the solver, then other forms.
    pub series: Vec<Series>,
}

/// Position and velocity errors of one form.
pub struct Series {
    /// The name of the solver.
    pub name: &'static str,
    /// Errors of position and velocity, at every distance.
    pub errors: [Vec<f64>; 2],
}

/// Which rows of a group's results are compared: one or two for the position, one for the
/// velocity; and whether the position's error is relative.
#[derive(Clone, Copy)]
struct Rows {
    position: [usize; 2],
    velocity: usize,
    is_relative: bool,
}

const PIN: Rows = Rows { position: [0, 1], velocity: 2, is_relative: false };

/// Distances from a form's answer to the truth.
fn errors<const ROWS: usize>(answer: Answer, truth: &[[f64; ROWS]; 3], rows: Rows) -> [f64; 2] {
    let ([x, y], velocity) = answer;
    let [a, b] = rows.position.map(|row| truth[0][row]);
    let away = if rows.position[0] == rows.position[1] { x - a } else { (x - a).hypot(y - b) };
    let scale = if rows.is_relative { a.abs() } else { 1.0 };
    let rate = truth[1][rows.velocity];
    [away.abs() / scale, ((velocity - rate) / rate).abs()]
}

/// The measured and the allowed errors at a pose, in the same terms.
fn measured_errors<const ROWS: usize>(
    orders: &[[Measured; ROWS]; 3],
    truth: &[[f64; ROWS]; 3],
    rows: Rows,
) -> [[f64; 2]; 2] {
    // Points are measured as one quantity in both rows.
    let (position, velocity) = (orders[0][rows.position[0]], orders[1][rows.velocity]);
    let scale = if rows.is_relative { truth[0][rows.position[0]].abs() } else { 1.0 };
    let rate = truth[1][rows.velocity].abs();
    [
        [position.achievable / scale, velocity.achievable / rate],
        [position.error / scale, velocity.error / rate],
    ]
}

/// The worst of every form over a family. A form that answers with no number where there is a
/// pose has the largest error there is.
macro_rules! sweep {
    ($title:literal, $measures:expr, $family:ident of $group:ident in $width:expr, $rows:expr,
     $($name:literal: $textbook:expr),* $(; $compensated:literal: $other:ident)?) => {{
        let width: Width = $width;
        let family: Family<_, _> = families::$family;
        let names = ["what the data allow", "this solver", $($name,)* $($compensated,)?];
        let mut series: Vec<Series> = names
            .into_iter()
            .map(|name| Series { name, errors: [Vec::new(), Vec::new()] })
            .collect();
        for exponent in EXPONENTS.take_while(|&exponent| is_resolved(exponent, width)) {
            let gap = 10.0_f64.powi(-i32::from(exponent));
            let mut source = Source::new(5);
            let mut worst = vec![[0.0_f64; 2]; series.len()];
            for _ in 0..POSES {
                let pose: Pose<_, _> = family(&mut source, gap).rounded(width);
                let Some(truth) = measured::$group::truth(&pose) else { continue };
                let Some(orders) = measured::$group::measure(&pose, width) else { continue };
                let mut found: Vec<[f64; 2]> = measured_errors(&orders, &truth, $rows).to_vec();
                let others: &[[f64; 2]] = &[$(errors($textbook(&pose), &truth, $rows)),*];
                found.extend(others);
                $(if let Some(orders) = measured::$other::measure(&pose, width) {
                    found.push(measured_errors(&orders, &truth, $rows)[1]);
                })?
                for (worst, found) in worst.iter_mut().zip(found) {
                    for order in 0..2 {
                        let error = if found[order].is_nan() { 1.0 } else { found[order] };
                        worst[order] = worst[order].max(error);
                    }
                }
            }
            for (series, worst) in series.iter_mut().zip(worst) {
                for order in 0..2 {
                    series.errors[order].push(worst[order]);
                }
            }
        }
        Sweep { title: $title, measures: $measures, series }
    }};
}

const OF_PIN: [&str; 2] = ["pin in bar lengths", "relative, ω of the bar"];
const OF_SLIDE: [&str; 2] = ["relative, slide", "relative, rate of the slide"];

/// True if the width can tell a distance of so many digits from zero.
fn is_resolved(exponent: u8, width: Width) -> bool {
    10.0_f64.powi(-i32::from(exponent)) >= width.half_unit()
}

const fn slide(row: usize) -> Rows {
    Rows { position: [row, row], velocity: row, is_relative: true }
}

const INVERSION: Rows = Rows { position: [1, 1], velocity: 0, is_relative: false };

/// Two bars that are nearly stretched, in double and in single precision.
#[must_use]
pub fn stretched() -> [Sweep; 2] {
    [
        sweep!("rrr, stretched", OF_PIN, stretched_from_origin of rrr in Width::Double, PIN,
            "law of cosines": textbook::law_of_cosines, "half angles": textbook::half_angles;
            "compensated": compensated_rrr),
        sweep!("rrr, stretched", OF_PIN, stretched_from_origin of rrr in Width::Single, PIN,
            ; "compensated": compensated_rrr),
    ]
}

/// Every group next to each of its limits, in double precision but for the first, which `stretched`
/// has.
#[must_use]
pub fn all() -> Vec<Sweep> {
    let width = Width::Double;
    vec![
        sweep!("rrr, folded", OF_PIN, folded_from_origin of rrr in width, PIN,
            "law of cosines": textbook::law_of_cosines, "half angles": textbook::half_angles;
            "compensated": compensated_rrr),
        sweep!("rrp, square to its guide", OF_PIN, square_to_guide of rrp in width, PIN,
            "arc sine": textbook::arc_sine_slider),
        sweep!("rpr, at its offset", ["slide in offsets", "relative, ω of the bar"],
            at_offset of rpr in width, INVERSION, "arc sine": textbook::arc_sine_inversion),
        sweep!("prp, nearly parallel", OF_SLIDE, parallel_guides of prp in width, slide(2),
            "crossed directions": textbook::crossed_directions),
        sweep!("rpp, slot along rail", OF_SLIDE, slot_along_rail of rpp in width, slide(0),
            "two equations": textbook::two_equations),
    ]
}

/// The same in single precision, against what its own data allow.
#[must_use]
pub fn single() -> Vec<Sweep> {
    let width = Width::Single;
    vec![
        sweep!("rrr, folded", OF_PIN, folded_from_origin of rrr in width, PIN,
            ; "compensated": compensated_rrr),
        sweep!("rrp, square to its guide", OF_PIN, square_to_guide of rrp in width, PIN,),
        sweep!("rpr, at its offset", ["slide in offsets", "relative, ω of the bar"],
            at_offset of rpr in width, INVERSION,),
        sweep!("prp, nearly parallel", OF_SLIDE, parallel_guides of prp in width, slide(2),),
        sweep!("rpp, slot along rail", OF_SLIDE, slot_along_rail of rpp in width, slide(0),),
    ]
}

impl Sweep {
    /// Its errors over the distance, each form in its colour; the axes are decimal logarithms.
    #[must_use]
    pub fn panel(&self, title: &str, order: usize) -> Panel {
        let curve = |series: &Series| {
            let points = EXPONENTS.zip(&series.errors[order]);
            // An error of nothing, and one that is no number, have no logarithm.
            let points = points.filter(|(_, error)| error.is_finite() && **error > 0.0);
            let points = points.map(|(exponent, error)| (-f64::from(exponent), error.log10()));
            Curve::named(series.name, charts::colour_of(series.name), points.collect())
        };
        let axes = ["log₁₀ of the distance from the limit, in lengths", "log₁₀ of the error"];
        let title = format!("{title}, {}", self.measures[order]);
        Panel::over(&title, axes, self.series.iter().map(curve).collect())
    }
}
