//! Names of points: none is left out, none fades below half while its joint is there, and one that stands
//! far from its joint has a line to it.

use gallery::declarations::excavator;
use gallery::pieces;

use super::xml::{Element, numbers, parse};

/// The element that says how a text is seen, and the text's middle in the first pose.
fn named<'e>(root: &'e Element, name: &str) -> Option<(&'e Element, [f64; 2])> {
    let elements = root.all();
    let own = |e: &Element| e.name == "text" && e.text == name;
    if let Some(text) = elements.iter().find(|e| own(e) && e.attribute("x").is_some()) {
        let at = ["x", "y"].map(|side| text.attribute(side).unwrap().parse().unwrap());
        return Some((text, at));
    }
    let group = elements.iter().find(|e| e.name == "g" && e.children.iter().any(own))?;
    let at = numbers(&group.attribute("transform")?.replace("translate", " "));
    Some((group, [at[0], at[1]]))
}

/// Every opacity that an element takes.
fn opacities(element: &Element) -> Vec<f64> {
    let own = element.attribute("opacity").map(str::to_string);
    let moves = element.children.iter().filter(|e| e.attribute("attributeName") == Some("opacity"));
    let moves = moves.map(|e| e.attribute("values").unwrap().to_string());
    own.into_iter().chain(moves).flat_map(|list| numbers(&list.replace(';', " "))).collect()
}

#[test]
fn no_name_is_left_out_or_fades_below_half() {
    for piece in pieces() {
        // Those that name some points alone.
        if ["crane::Crane", "parallelograms::TwoParallelograms"].contains(&piece.name) {
            continue;
        }
        for width in [296.0, 360.0, 720.0] {
            let still = parse(&piece.film.still().width(width).to_svg().unwrap());
            for name in piece.film.points() {
                let (text, _) =
                    named(&still, name).unwrap_or_else(|| panic!("{} {name}", piece.name));
                assert!(opacities(text).is_empty(), "{} {name}", piece.name);
            }
        }
        let root = parse(&piece.film.to_svg().unwrap());
        for name in piece.film.points() {
            let (text, _) = named(&root, name).unwrap_or_else(|| panic!("{} {name}", piece.name));
            let is_there = (0..piece.film.len()).all(|pose| piece.film.point(pose, name).is_ok());
            let least = opacities(text).into_iter().fold(1.0, f64::min);
            match is_there {
                true => assert!(least >= 0.5, "{} {name}: {least}", piece.name),
                false => assert_eq!(least, 0.0, "{} {name}", piece.name),
            }
        }
    }
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
        let line = group.children.iter().find_map(|child| child.attribute("d"));
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
