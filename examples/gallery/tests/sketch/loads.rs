//! Forces and couples: length, way and value of what is drawn for them.

use gallery::declarations::{flying_shear, shear_bearings, vibration};
use gallery::motions::turn;
use linkage_core::sketch::{Sketch, Theme};

use super::xml::{Element, numbers, parse};

fn shear() -> Sketch {
    flying_shear::FlyingShear::new().sketch(2.0).unwrap()
}

fn loads<'e>(root: &'e Element, kind: &str) -> Vec<&'e Element> {
    let all = root.all().into_iter();
    all.filter(|e| e.attribute(&format!("data-{kind}")).is_some()).collect()
}

/// The corners of the line before the head.
fn line(element: &Element) -> Vec<[f64; 2]> {
    let path = element.attribute("d").unwrap();
    let line = path[1..].split('M').next().unwrap().replace('L', " ");
    numbers(&line).chunks_exact(2).map(|at| [at[0], at[1]]).collect()
}

#[test]
fn arrows_are_to_scale_but_none_is_too_short_to_be_seen() {
    let forces = [("B", [0.0, 3e3]), ("C", [-1.5e3, 0.0]), ("A", [3.0, -4.0]), ("D", [1.0, 0.0])];
    let picture = forces.into_iter().fold(shear(), |sketch, (name, f)| sketch.force(name, [f]));
    let text = picture.to_svg().unwrap();
    let root = parse(&text);
    let found = loads(&root, "force");
    // The force at D is below a thousandth of the largest.
    let names: Vec<_> = found.iter().map(|e| e.attribute("data-force").unwrap()).collect();
    assert_eq!(names, ["B", "C", "A"]);
    for (arrow, [x, y]) in found.iter().zip([[0.0, -90.0], [-45.0, 0.0], [9.0, 12.0]]) {
        let [from, to] = line(arrow)[..] else { panic!("two ends") };
        // Coordinates are rounded to 0.01 px.
        assert!((to[0] - from[0] - x).abs() < 0.011 && (to[1] - from[1] - y).abs() < 0.011);
        assert_eq!(arrow.attribute("stroke"), Some(Theme::Auto.palette().accent));
    }
    // A still says each value beside its arrow, in the colour of forces.
    let written = |value: &str| {
        let all = root.all();
        all.iter()
            .any(|e| e.name == "text" && e.text == value && e.attribute("fill") == Some("#b8123c"))
    };
    assert!(["3 kN", "1.5 kN", "5 N"].into_iter().all(written), "{text}");
    assert!(text.contains("arrows to scale from 500 N on"), "{text}");
}

#[test]
fn a_film_says_the_largest_of_each_force() {
    let solver = shear_bearings::FlyingShear::new();
    let results: Vec<_> = turn().map(|q| solver.statics(q, 1e4).unwrap()).collect();
    let largest = results.iter().map(|f| f.BC.C.x.hypot(f.BC.C.y)).fold(0.0, f64::max);
    let text = solver.film(turn()).reactions(results.into_iter().map(Ok)).to_svg().unwrap();
    let wanted = format!("C {:.2} kN", largest / 1e3);
    assert!(text.contains("largest forces: A ") && text.contains(&wanted), "{wanted}");
}

#[test]
fn a_couple_is_an_arc_that_goes_its_way() {
    let sketch = shear().couple("A", [6.0]).couple("D", [-3.0]).couple("C", [0.0]);
    let view = sketch.view().unwrap();
    let text = sketch.to_svg().unwrap();
    let root = parse(&text);
    let found = loads(&root, "couple");
    assert_eq!(found.len(), 2, "there is no arc for no couple");
    for (arc, (name, degrees)) in found.iter().zip([("A", 270.0), ("D", -135.0)]) {
        assert_eq!(arc.attribute("data-couple"), Some(name));
        let at = sketch.point(name).unwrap();
        let [x, y] = view.pixels([at.x, at.y]);
        let corners = line(arc);
        let mut turned = 0.0;
        for side in corners.windows(2) {
            let [a, b] = [side[0], side[1]].map(|[u, v]| [u - x, y - v]);
            // Coordinates are rounded to 0.05 px.
            assert!((a[0].hypot(a[1]) - 29.0).abs() < 0.1, "{a:?}");
            turned += (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]).to_degrees();
        }
        assert!((turned - degrees).abs() < 0.5, "{name}: {turned}");
    }
    assert!(text.contains(">6 N\u{b7}m<") && text.contains(">3 N\u{b7}m<"));
    assert!(text.contains("couples: A 6 N\u{b7}m, D 3 N\u{b7}m"), "{text}");
}

/// The rail passes below blocks and springs and reaches from the wall on.
#[test]
fn a_spring_along_a_guide_is_not_one_line_with_its_rail() {
    let film = vibration::TwoMasses::new().film([[0.0, 4.0], [1.0, 6.0]]);
    let (view, root) = (film.view().unwrap(), parse(&film.to_svg().unwrap()));
    let elements = root.all();
    let springs = elements.iter().filter(|e| e.attribute("data-spring").is_some());
    let height =
        |e: &Element| numbers(&e.attribute("transform").unwrap().replace("translate", " "))[1];
    let heights: Vec<f64> = springs.map(|spring| height(spring)).collect();
    assert_eq!(heights.len(), 2);
    let is_line = |d: &str| d.starts_with('M') && d.contains(" 0H") && !d.contains('L');
    let rails = elements.iter().filter(|e| {
        e.name == "g"
            && e.children.iter().any(|c| c.attribute("d").is_some_and(is_line))
            && e.attribute("data-link").is_none()
            && e.children.len() == 2
    });
    let wall = view.pixels([film.point(0, "O").unwrap().x, 0.0])[0];
    let mut found = 0;
    for rail in rails {
        let line = rail.children[0].attribute("d").unwrap();
        if line == "M-17 0H17" {
            continue;
        }
        found += 1;
        for spring in &heights {
            // The coils take 6 px, blocks 8.5 px.
            assert!(height(rail) - spring > 9.5, "{} {spring}", height(rail));
        }
        let at = numbers(&rail.attribute("transform").unwrap().replace("translate", " "))[0];
        let start = numbers(&line.replace(['M', 'H'], " "))[0];
        assert!(at + start < wall + 0.1, "{at} {start} {wall}");
    }
    assert_eq!(found, 1);
}
