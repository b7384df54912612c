//! Names of points: none is left out, none is seen twice or not at all while its joint is there, and one that stands far
//! from its joint has a line to it.

use gallery::declarations::excavator;

use super::cases::cases;
use super::sample;
use super::xml::{Element, numbers, parse};

/// The group that moves a name, and the text's middle in the first pose.
fn named<'e>(root: &'e Element, name: &str) -> Option<(&'e Element, [f64; 2])> {
    let elements = root.all();
    let own = |e: &Element| e.name == "text" && e.text == name;
    let holds = |e: &&&Element| {
        e.attribute("transform").is_some()
            && e.children.iter().any(|child| own(child) || child.children.iter().any(own))
    };
    let Some(group) = elements.iter().find(holds) else {
        let text = elements.iter().find(|e| own(e))?;
        let at = ["x", "y"].map(|side| text.attribute(side).unwrap().parse().unwrap());
        return Some((text, at));
    };
    let at = numbers(&group.attribute("transform")?.replace("translate", " "));
    Some((group, [at[0], at[1]]))
}

/// True where an element is seen in a pose: its own opacity, or the step of it that the pose is in.
fn is_seen(element: &Element, share: f64) -> bool {
    let moves = element.children.iter().find(|e| e.attribute("attributeName") == Some("opacity"));
    let Some(moves) = moves else { return element.attribute("opacity") != Some("0") };
    let of = |name: &str| numbers(&moves.attribute(name).unwrap().replace(';', " "));
    let (times, values) = (of("keyTimes"), of("values"));
    values[times.iter().rposition(|&time| time <= share + 1e-9).unwrap()] > 0.5
}

/// Where texts with this name are seen below an element in one of so many poses.
pub(super) fn seen(element: &Element, name: &str, (pose, poses): (usize, usize)) -> Vec<[f64; 2]> {
    if !is_seen(element, pose as f64 / (poses - 1).max(1) as f64) {
        return Vec::new();
    }
    let side = |name: &str| element.attribute(name).map_or(0.0, |at| at.parse().unwrap());
    if element.name == "text" {
        return if element.text == name { vec![[side("x"), side("y")]] } else { Vec::new() };
    }
    let below = element.children.iter().flat_map(|child| seen(child, name, (pose, poses)));
    let below: Vec<[f64; 2]> = below.collect();
    if below.is_empty() {
        return below;
    }
    let moves = element.children.iter().find(|e| e.attribute("type") == Some("translate"));
    let shift = element.attribute("transform").map_or(vec![0.0; 2], |shift| {
        numbers(shift.split(')').next().unwrap().trim_start_matches("translate("))
    });
    let by = moves.map_or(shift, |e| numbers(e.attribute("values").unwrap())[2 * pose..].to_vec());
    below.into_iter().map(|[x, y]| [x + by[0], y + by[1]]).collect()
}

#[test]
fn every_name_is_seen_once_while_its_joint_is_there() {
    let (mut hops, mut named, mut frames) = (0, 0, 0);
    for piece in sample() {
        // Those that name some points alone.
        if ["crane::Crane", "parallelograms::TwoParallelograms"].contains(&piece.name) {
            continue;
        }
        for width in [296.0, 360.0, 720.0] {
            let still = parse(&piece.film.still().width(width).to_svg().unwrap());
            for name in piece.film.points() {
                assert_eq!(seen(&still, name, (0, 1)).len(), 1, "{} {name}", piece.name);
            }
        }
        let (root, view) = (parse(&piece.film.to_svg().unwrap()), piece.film.view().unwrap());
        let poses = piece.film.len();
        for name in piece.film.points() {
            let mut last: Option<[f64; 2]> = None;
            for pose in 0..poses {
                let at = piece.film.point(pose, name).ok().map(|at| view.pixels([at.x, at.y]));
                let found = seen(&root, name, (pose, poses));
                assert_eq!(found.len(), usize::from(at.is_some()), "{} {name} {pose}", piece.name);
                let beside = at.map(|[x, y]| [found[0][0] - x, found[0][1] - y]);
                let has_hopped =
                    |([x, y], [u, v]): ([f64; 2], [f64; 2])| (x - u).hypot(y - v) > 0.3;
                hops += usize::from(last.zip(beside).is_some_and(has_hopped));
                last = beside;
                frames += 1;
            }
            named += 1;
        }
    }
    println!("{named} names, {frames} frames, {hops} hops");
    // A name that never gave way would stand on a bar in most films.
    assert!(hops > cases(6, 20) && hops < 2 * named, "{hops}");
}

/// From beside its joint to beside its text.
#[test]
fn a_name_far_from_its_joint_has_a_line_to_it() {
    let path = (0..=40).map(|k| [2.15 + 0.015 * f64::from(k), 2.65 + 0.02 * f64::from(k), 1.8]);
    let film = excavator::Excavator::new().film(path).width(328.0);
    let (view, root) = (film.view().unwrap(), parse(&film.to_svg().unwrap()));
    let mut lines = 0;
    for name in ["O", "F", "G", "H", "J", "S", "T", "N", "K", "V", "W", "tooth"] {
        let at = film.point(0, name).unwrap();
        let joint = view.pixels([at.x, at.y]);
        let (group, [x, y]) = named(&root, name).expect(name);
        // In the first pose; a name that goes elsewhere has the line of each place beside it.
        let first = group.children.iter().find(|child| child.name == "g").unwrap_or(group);
        let line = first.children.iter().find_map(|child| child.attribute("d"));
        let from = |[u, v]: [f64; 2]| (u - joint[0]).hypot(v - joint[1]);
        let Some(line) = line else {
            // The letters begin within 24.6 px; their middle is farther by half their width and height.
            let half = 0.5 * 13.0 * 0.86 * name.len() as f64;
            assert!(from([x, y]) < 25.0 + half + 9.5, "{name}: {}", from([x, y]));
            continue;
        };
        let ends = numbers(&line.replace(['M', 'L'], " "));
        let [start, end] =
            [[ends[0], ends[1]], [ends[2], ends[3]]].map(|[u, v]| from([x + u, y + v]));
        // Coordinates are rounded to 0.05 px.
        assert!((start - 6.6).abs() < 0.2, "{name}: {start}");
        assert!(end > 26.0, "{name}: {end}");
        lines += 1;
    }
    assert!(lines > 0, "a picture so small has names that fit nowhere near");
}
