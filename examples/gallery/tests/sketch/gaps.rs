//! Poses that cannot be assembled.

use gallery::declarations::{excavator, range};
use gallery::motions::turn;
use linkage_core::sketch::Film;
use linkage_core::{SolveError, mechanism};

use super::xml::{Element, numbers, parse};

fn four_bar() -> Film {
    range::FourBar { base: 0.39 }.film(turn())
}

/// True if an element is shown at a share of the film's time.
pub(super) fn is_shown(element: &Element, share: f64) -> bool {
    let mut animations = element.children.iter();
    let Some(opacity) =
        animations.find(|child| child.attribute("attributeName") == Some("opacity"))
    else {
        return element.attribute("opacity") != Some("0");
    };
    let times = numbers(opacity.attribute("keyTimes").unwrap());
    let values = numbers(opacity.attribute("values").unwrap());
    let at = times.iter().rposition(|&time| time <= share).unwrap();
    values[at] == 1.0
}

#[test]
fn what_cannot_be_placed_is_hidden_exactly_there() {
    let film = four_bar();
    let root = parse(&film.to_svg().unwrap());
    let mut seen = [0, 0];
    for element in root.all() {
        let Some(name) = element.attribute("data-link") else { continue };
        for pose in 0..film.len() {
            let share = pose as f64 / (film.len() - 1) as f64;
            let exists = film.link(pose, name).is_ok();
            seen[usize::from(exists)] += 1;
            assert_eq!(is_shown(element, share), exists, "{name} in pose {pose}");
            // Between a pose that exists and one that does not nothing is shown.
            let next = pose + 1;
            if next < film.len() && (exists != film.link(next, name).is_ok()) {
                let between = (pose as f64 + 0.5) / (film.len() - 1) as f64;
                assert!(!is_shown(element, between), "{name} behind pose {pose}");
            }
        }
    }
    assert!(seen[0] > 20 && seen[1] > 100, "{seen:?}");
    let gaps = film.gaps();
    let missing = (0..film.len()).filter(|&pose| film.link(pose, "BC").is_err());
    assert_eq!(gaps.iter().map(|gap| gap.poses.len()).sum::<usize>(), missing.count());
}

mechanism! {
    /// Two bars between pivots that are too far apart, or too close for the difference of the bars.
    struct Bars {
        input base: length;
        param first = 250mm;
        param second = 200mm;
        ground A(0, 0);
        guide bed through A along 25deg;
        slider cart(bed) -> D      { slide: base }
        rrr   AC(A), DC(D) -> C    { lengths: (first, second), mode: left }
    }
}

mechanism! {
    /// A bar that is too short for its block's line, which runs to the left of the guide.
    struct Line {
        input lift: length;
        param offset = 60mm;
        ground O(0, 0);
        guide post through O along 110deg;
        guide rail through (50mm, -20mm) along 20deg;
        slider cart(post) -> B      { slide: lift }
        rrp BC(B), block(rail) -> C { length: 100mm, offset: offset, mode: ahead }
    }
}

/// The double arrow of a single pose: from what the first link reaches to what the second one does.
fn arrow(film: &Film) -> [[f64; 2]; 2] {
    let root = parse(&film.to_svg().unwrap());
    let elements = root.all();
    let arrow = elements
        .iter()
        .find(|element| element.name == "path" && element.attribute("stroke-width") == Some("2"));
    let path = arrow.and_then(|arrow| arrow.attribute("d")).expect("there is an arrow");
    let ends = numbers(&path.replace(['M', 'L'], " "));
    [[ends[0], ends[1]], [ends[2], ends[3]]]
}

fn distance([a, b]: [[f64; 2]; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// The missing length in the only pose of a film.
fn missing(film: &Film) -> f64 {
    match film.gaps()[..] {
        [ref gap] => match gap.error {
            SolveError::OutOfReach { by, .. } => by,
            ref error => panic!("{error}"),
        },
        ref gaps => panic!("{} gaps", gaps.len()),
    }
}

/// Coordinates of an arrow are rounded to 0.01 px.
const ROUNDED: f64 = 0.02;

/// Each end is on its own bar's circle, and the arrow as long as what is missing.
#[test]
fn the_arrow_is_as_long_as_what_is_missing_between_circles() {
    let cases: [([f64; 2], f64); 4] = [
        // Too far apart; the second circle inside of the first; the first inside of the second.
        ([0.25, 0.2], 0.5),
        ([0.25, 0.2], 0.02),
        ([0.2, 0.25], 0.02),
        ([0.1, 0.25], -0.09),
    ];
    for ([first, second], base) in cases {
        let film = Bars { first, second }.film([base]);
        let (view, ends) = (film.view().unwrap(), arrow(&film));
        let by = missing(&film);
        let short = (base.abs() - first - second).max((first - second).abs() - base.abs());
        assert!((by - short).abs() < 1e-12, "{by} {short}");
        assert!((distance(ends) - by * view.scale).abs() < ROUNDED, "{first} {second} {base}");
        for (end, joint, length) in [(ends[0], "A", first), (ends[1], "D", second)] {
            let at = film.point(0, joint).unwrap();
            let radius = distance([view.pixels([at.x, at.y]), end]);
            assert!((radius - length * view.scale).abs() < ROUNDED, "{joint}: {radius}");
        }
    }
}

/// From the bar's circle straight to the line that is the offset to the left of the guide.
#[test]
fn the_arrow_ends_on_the_line_along_which_a_pin_slides() {
    for (offset, lift) in [(0.06, 0.4), (-0.06, 0.4), (0.06, -0.3)] {
        let film = Line { offset }.film([lift]);
        let (view, ends) = (film.view().unwrap(), arrow(&film));
        let by = missing(&film);
        let (sin, cos) = 20_f64.to_radians().sin_cos();
        // Metres from the guide, to the left of it: of the bar's own pin, and of both ends.
        let beside = |[x, y]: [f64; 2]| cos * (y + 0.02) - sin * (x - 0.05);
        let metres = |[x, y]: [f64; 2]| {
            [(x - view.origin[0]) / view.scale, (view.origin[1] - y) / view.scale]
        };
        let b = film.point(0, "B").unwrap();
        let short = (beside([b.x, b.y]) - offset).abs() - 0.1;
        assert!(short > 0.0 && (by - short).abs() < 1e-12, "{by} {short}");
        assert!((distance(ends) - by * view.scale).abs() < ROUNDED, "{offset} {lift}");
        let [from, to] = ends.map(|end| beside(metres(end)));
        let rounded = ROUNDED / view.scale;
        assert!((to - offset).abs() < rounded, "{to} for {offset}");
        // By so much the line is behind the circle, seen from the pin.
        assert!(((to - from).abs() - by).abs() < rounded, "{from} {to}");
        let reach = distance([view.pixels([b.x, b.y]), ends[0]]);
        assert!((reach - 0.1 * view.scale).abs() < ROUNDED, "{reach}");
    }
}

#[test]
fn a_film_wholly_out_of_reach_says_so() {
    let film = range::FourBar { base: 1.0 }.film(turn());
    let text = film.to_svg().unwrap();
    parse(&text);
    assert!(text.contains("BC, DC: 650 mm out of reach at worst"), "{text}");
    assert_eq!(film.gaps().len(), 1);
    let digger = excavator::Excavator::new().film([[0.5, 0.5, 0.5]; 3]);
    assert!(digger.to_svg().unwrap().contains("out of reach"));
    assert!(digger.point(0, "tooth").is_err() && digger.point(0, "O").is_ok());
}
