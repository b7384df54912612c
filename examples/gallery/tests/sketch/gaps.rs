//! Poses that cannot be assembled.

use gallery::declarations::{excavator, range};
use gallery::motions::turn;
use linkage_core::SolveError;
use linkage_core::sketch::Film;

use super::xml::{Element, numbers, parse};

fn four_bar() -> Film {
    range::FourBar { base: 0.39 }.film(turn())
}

/// Whether an element is shown at a share of the film's time.
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

/// Both ends of the arrow, and how long it is on the page, against `by`.
#[test]
fn the_arrow_is_as_long_as_what_is_missing() {
    let solver = range::FourBar { base: 0.39 };
    let far = solver.film([std::f64::consts::PI]);
    let near = range::FourBar { base: 0.02 };
    // The distance of the pivots is below the difference of the bars.
    let short = near.film([std::f64::consts::PI * 0.999]);
    for (film, outcome) in [(far, solver.position(std::f64::consts::PI).err()), (short, None)] {
        let gaps = film.gaps();
        let Some(SolveError::OutOfReach { by, .. }) = gaps.first().map(|gap| gap.error) else {
            assert!(outcome.is_none());
            continue;
        };
        assert!(outcome.is_none_or(|error| error == gaps[0].error));
        let (view, root) = (film.view().unwrap(), parse(&film.to_svg().unwrap()));
        let elements = root.all();
        let arrow = elements.iter().find(|element| {
            element.name == "path" && element.attribute("stroke-width") == Some("2")
        });
        let path = arrow.and_then(|arrow| arrow.attribute("d")).expect("there is an arrow");
        let ends = numbers(&path.replace(['M', 'L'], " "));
        let length = (ends[2] - ends[0]).hypot(ends[3] - ends[1]);
        assert!((length - by * view.scale).abs() < 0.02, "{length} for {}", by * view.scale);
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
