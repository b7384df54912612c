//! Arrows of cranks and names beside joints: which way an arrow goes, and that a name stays at its joint.

use gallery::declarations::flying_shear;
use gallery::motions::turn;
use linkage_core::mechanism;
use linkage_core::sketch::Film;

use super::names::seen;
use super::xml::{Element, numbers, parse};

mechanism! {
    /// Two cranks, of which the second turns the other way, twice as fast.
    struct Against {
        input q: angle;
        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B { length: 0.3m, angle: q }
        crank DE(D) -> E { length: 0.3m, angle: 30deg - 2 * q }
    }
}

/// Every arrow about a pivot: from the pivot to its tail, and to the tip of its head.
fn arrows(film: &Film) -> Vec<(String, [[f64; 2]; 2])> {
    let (view, root) = (film.view().unwrap(), parse(&film.to_svg().unwrap()));
    let siblings: Vec<(String, String)> = root
        .all()
        .iter()
        .flat_map(|parent| parent.children.windows(2))
        .filter_map(|pair| {
            let path = |nth: usize| Some(pair[nth].attribute("d")?.to_string());
            Some((path(0)?, path(1)?))
        })
        .filter(|(arc, head)| arc.contains("A20 20 ") && head.ends_with('Z'))
        .collect();
    let pivot = |tail: [f64; 2]| {
        let names = film.points().iter().map(|name| (*name, film.point(0, name).unwrap()));
        let mut pixels = names.map(|(name, at)| (name, view.pixels([at.x, at.y])));
        // The arc's radius, and the rounding of both ends.
        let is_middle =
            |at: [f64; 2]| ((tail[0] - at[0]).hypot(tail[1] - at[1]) - 20.0).abs() < 0.02;
        pixels.find(|&(_, at)| is_middle(at)).expect("an arc is about a point")
    };
    let arrow = |(arc, head): &(String, String)| {
        let tail = numbers(&arc[1..arc.find('A').unwrap()]);
        let tip = numbers(&head[1..head.find('L').unwrap()]);
        let (name, at) = pivot([tail[0], tail[1]]);
        let from = |spot: &[f64]| [spot[0] - at[0], spot[1] - at[1]];
        (name.to_string(), [from(&tail), from(&tip)])
    };
    siblings.iter().map(arrow).collect()
}

/// Positive where the arrow goes counter-clockwise; the page's y points down.
fn sense([tail, tip]: [[f64; 2]; 2]) -> f64 {
    tail[1] * tip[0] - tail[0] * tip[1]
}

#[test]
fn the_arrow_of_a_crank_goes_the_way_the_crank_turns() {
    let path = (0..30).map(|k| 0.1 * f64::from(k));
    for (film, way) in
        [(Against::new().film(path.clone()), 1.0), (Against::new().film(path.rev()), -1.0)]
    {
        let found = arrows(&film);
        assert_eq!(found.len(), 2, "{found:?}");
        for (pivot, arrow) in found {
            let wanted = if pivot == "A" { way } else { -way };
            // As wide as 20 px at 100° or more.
            assert!(wanted * sense(arrow) > 100.0, "{pivot} {way}: {arrow:?}");
        }
    }
}

/// Where the middle of a name's line is in every pose.
fn name(root: &Element, name: &str, poses: usize) -> Vec<[f64; 2]> {
    (0..poses).map(|pose| seen(root, name, (pose, poses))[0]).collect()
}

#[test]
fn a_name_stays_on_one_side_of_its_joint_as_long_as_it_can() {
    let films = [
        flying_shear::FlyingShear::new().film(turn()).label(["A", "B", "C", "blade"]),
        Against::new().film(turn()).label(["A", "B"]),
    ];
    for film in films {
        let (view, root) = (film.view().unwrap(), parse(&film.to_svg().unwrap()));
        let wanted = ["A", "B", "C", "blade"].into_iter().filter(|p| film.points().contains(p));
        let mut moving = 0;
        for point in wanted {
            let places = name(&root, point, film.len());
            let joints = (0..film.len()).map(|pose| film.point(pose, point).unwrap());
            let joints: Vec<[f64; 2]> = joints.map(|at| view.pixels([at.x, at.y])).collect();
            moving += usize::from(joints.iter().any(|at| *at != joints[0]));
            let beside = |pose: usize| [0, 1].map(|side| places[pose][side] - joints[pose][side]);
            let mut hops = 0;
            for pose in 1..film.len() {
                let [[x, y], [u, v]] = [beside(pose), beside(pose - 1)];
                // Far is beyond two widths of the longest name.
                assert!(x.hypot(y) < 120.0, "{point} {pose}: {x} {y}");
                // Places of joints and of names beside them are rounded to 0.01 px each.
                hops += usize::from((x - u).hypot(y - v) > 0.05);
            }
            assert!(hops <= 4, "{point}: {hops}");
        }
        assert!(moving > 0);
    }
}

mechanism! {
    /// Two points at one place, whose names would stand at one place too.
    struct Twins {
        input q: angle;
        ground A(0, 0);
        crank AB(A) -> B { length: 0.3m, angle: q }
        point P1 on AB at (0.2m, 0.1m);
        point P2 on AB at (0.2m, 0.1m);
    }
}

/// Whose path is drawn, is named first, where there is most room; the other name makes way.
#[test]
fn the_name_of_a_traced_point_is_placed_before_others() {
    let film = || Twins::new().film((0..30).map(|k| 0.05 * f64::from(k)));
    let of = |traced: &str| {
        let film = film().trace(traced);
        let root = parse(&film.to_svg().unwrap());
        ["P1", "P2"].map(|point| name(&root, point, film.len())[0])
    };
    let ([first, other], [made_way, second]) = (of("P1"), of("P2"));
    // Where it stands if nothing else is named.
    let alone = film().trace("P1").label(["P1"]);
    let alone = name(&parse(&alone.to_svg().unwrap()), "P1", alone.len())[0];
    assert_eq!([first, second], [alone; 2], "the traced one has the place");
    assert_eq!(other, made_way, "the other one has the next");
    assert!((first[0] - other[0]).hypot(first[1] - other[1]) > 5.0, "{first:?} {other:?}");
}
