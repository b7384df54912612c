//! Springs, dampers and applied forces, read back from the text.

use gallery::declarations::{andrews_squeezer, shear_bearings, vibration};
use gallery::motions::turn;
use linkage_core::sketch::Film;
use linkage_core::{SolveError, mechanism};

use super::gaps::is_shown;
use super::xml::{Element, numbers, parse};

mechanism! {
    /// A swinging arm on a spring and a damper side by side, a damper and a spring alone, and loads.
    struct Sprung {
        input q: angle;
        param k = 2000(N/m);
        load push: force;
        load thrust: number;
        ground A(0, 0), S(100mm, -200mm), T(400mm, -150mm), U(0, 300mm), D(700mm, 100mm);
        crank AB(A) -> B        { length: 300mm, angle: q }
        rrr   BC(B), DC(D) -> C { lengths: (400mm, 300mm), mode: right }
        point P on AB at (150mm, 0);
        spring between P and S { stiffness: k, free_length: 200mm, damping: 50(N*s/m) }
        spring between T and P { damping: 10(N*s/m) }
        spring between U and C { stiffness: k, free_length: 100mm }
        mass 1kg on AB uniform;
        force (push, 2 * push) on C;
        force (0, thrust * 1(N) + 3(N*s/m) * rate(B.x)) in AB on B;
        force push between P and C;
    }
}

mechanism! {
    /// A block on a spring of no free length, which it passes.
    struct Through {
        input x: length;
        ground O(0, 0);
        guide rail through O along 0deg;
        slider body(rail) -> P { slide: x }
        mass 1kg on P;
        spring between O and P { stiffness: 15(N/m), free_length: 0 }
    }
}

/// A spring in the text: where its group is, and its line, both in every frame.
struct Drawn {
    seats: Vec<[f64; 3]>,
    paths: Vec<String>,
}

fn spring(root: &Element, name: &str, frames: usize) -> Drawn {
    let elements = root.all();
    let mut named = elements.iter().filter(|e| e.attribute("data-spring") == Some(name));
    let (Some(group), None) = (named.next(), named.next()) else { panic!("one spring {name}") };
    let values = |kind: &str| {
        let mut animations = group.children.iter();
        let own = animations.find(|child| child.attribute("type") == Some(kind))?;
        Some(numbers(own.attribute("values")?))
    };
    let base = group.attribute("transform").unwrap();
    let base = numbers(&base.replace("translate", " ").replace("rotate", " "));
    let (places, turns) = (values("translate"), values("rotate"));
    let seat = |frame: usize| {
        let at = |list: &Option<Vec<f64>>, width: usize, nth: usize| match list {
            Some(list) if list.len() > 2 * width => list[width * frame + nth],
            Some(list) => list[nth],
            None => base.get(nth + if width == 1 { 2 } else { 0 }).copied().unwrap_or(0.0),
        };
        [at(&places, 2, 0), at(&places, 2, 1), at(&turns, 1, 0)]
    };
    let path = group.children.iter().find(|child| child.name == "path").expect("it has a line");
    let moving = path.children.iter().find(|c| c.attribute("attributeName") == Some("d"));
    let paths: Vec<String> = match moving {
        Some(moving) => {
            moving.attribute("values").unwrap().split(';').map(str::to_string).collect()
        }
        None => vec![path.attribute("d").unwrap().to_string(); frames],
    };
    assert_eq!(paths[0], path.attribute("d").unwrap(), "{name} begins as it stands");
    Drawn { seats: (0..frames).map(seat).collect(), paths }
}

fn length(path: &str) -> f64 {
    let (_, end) = path.rsplit_once('H').expect("it ends on its line");
    end.parse().unwrap()
}

fn letters(path: &str) -> String {
    path.chars().filter(|c| c.is_ascii_alphabetic()).collect()
}

/// Both ends are where their points are, and every frame has the same lines, in every film.
fn check(film: &Film, [from, to]: [&str; 2]) -> Drawn {
    let (view, root) = (film.view().unwrap(), parse(&film.to_svg().unwrap()));
    let drawn = spring(&root, &format!("{from} {to}"), film.len());
    for frame in 0..film.len() {
        let pixels = |name| film.point(frame, name).map(|p| view.pixels([p.x, p.y]));
        let (Ok(first), Ok(second)) = (pixels(from), pixels(to)) else { continue };
        let ([x, y, degrees], path) = (drawn.seats[frame], &drawn.paths[frame]);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let end = [x + cos * length(path), y + sin * length(path)];
        for (drawn, wanted) in [([x, y], first), (end, second)] {
            let off = (drawn[0] - wanted[0]).hypot(drawn[1] - wanted[1]);
            assert!(off < 0.03, "{from} {to} {frame}: {off}");
        }
        assert_eq!(letters(path), letters(&drawn.paths[0]), "{from} {to} {frame}");
    }
    drawn
}

/// To and fro.
fn swing() -> impl Iterator<Item = f64> + Clone {
    turn().map(|t| 0.5 - 0.4 * t.cos())
}

#[test]
fn springs_stretch_between_their_points_and_keep_their_coils() {
    let film = Sprung::new().film(swing());
    let [both, damper, coil] = [["P", "S"], ["T", "P"], ["U", "C"]].map(|ends| check(&film, ends));
    // The corners of a zigzag are evenly spaced and fill what its ends leave, short or long.
    let corners = |path: &str| -> Vec<f64> {
        let parts = path.split('L').skip(1);
        parts.map(|part| numbers(&part.replace('H', " "))[0]).collect()
    };
    let counts: Vec<usize> = coil.paths.iter().map(|path| corners(path).len()).collect();
    assert!(counts[0] >= 9 && counts.iter().all(|count| *count == counts[0]), "{counts:?}");
    let pitches = coil.paths.iter().map(|path| {
        let corners = corners(path);
        let steps = corners[..corners.len() - 1].windows(2).map(|pair| pair[1] - pair[0]);
        let (least, most) = steps.fold((f64::MAX, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
        assert!(most - least < 0.21 && least > 2.0, "{least} {most}");
        least
    });
    let (least, most) = pitches.fold((f64::MAX, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
    assert!(most > 1.05 * least, "it stretches: {least} to {most}");
    // A spring with a damper has a zigzag, a damper alone none.
    assert!(both.paths[0].contains('L') && !damper.paths[0].contains('L'));
}

/// The cylinder is the only part of the line that goes along, across and along; the piston follows it.
#[test]
fn a_piston_never_leaves_its_cylinder() {
    let film = Sprung::new().film(swing());
    for ends in [["P", "S"], ["T", "P"]] {
        let drawn = check(&film, ends);
        let mut seen = Vec::new();
        for path in &drawn.paths {
            let parts: Vec<&str> = path.split('M').collect();
            let cylinder = parts.iter().position(|part| letters(part) == "HVH").unwrap();
            let [cylinder, piston] = [parts[cylinder], parts[cylinder + 1]];
            let cylinder = numbers(&cylinder.replace(['H', 'V'], " "));
            let (top, bottom) = (cylinder[0], cylinder[2]);
            let piston = numbers(&piston.replace('V', " "))[0];
            assert!(bottom + 2.0 < piston && piston + 2.0 < top, "{bottom} {piston} {top}");
            assert!(bottom > 0.0 && top < length(path), "{path}");
            seen.push((bottom, top, piston));
        }
        // The cylinder is rigid, and the piston moves in it.
        assert!(seen.iter().all(|part| (part.0, part.1) == (seen[0].0, seen[0].1)));
        let least = seen.iter().map(|part| part.2).fold(f64::MAX, f64::min);
        let most = seen.iter().map(|part| part.2).fold(0.0, f64::max);
        assert!(most - least > 5.0);
    }
}

#[test]
fn a_spring_that_its_end_passes_does_not_turn_about() {
    let film = Through::new().film(turn().map(f64::sin));
    let drawn = check(&film, ["O", "P"]);
    let lengths: Vec<f64> = drawn.paths.iter().map(|path| length(path)).collect();
    assert!(lengths.iter().any(|l| *l > 50.0) && lengths.iter().any(|l| *l < -50.0));
    assert!(drawn.seats.iter().all(|seat| seat[2] == drawn.seats[0][2]));
}

#[test]
fn what_springs_hold_on_to_is_drawn_and_what_stands_still_does_not_move() {
    let supports = |text: &str| text.matches("M0 0L-10 17H10Z").count();
    let wall = r#"<path d="M-17 0H17" stroke-width="1.6"/>"#;
    // The squeezer's spring swings about C, which is a joint for that; a mass's spring is on a wall.
    let squeezer = andrews_squeezer::Squeezer::new();
    let text = squeezer.film(turn().step_by(20)).to_svg().unwrap();
    assert_eq!((supports(&text), text.contains(wall)), (4, false));
    let mass = vibration::Oscillator::new();
    let text = mass.film([-2.0, 3.0]).to_svg().unwrap();
    assert_eq!((supports(&text), text.matches(wall).count()), (0, 1));
    let still = mass.sketch(1.0).unwrap().to_svg().unwrap();
    assert!(still.contains("data-spring=\"O P\"") && !still.contains("<animate"));
    parse(&still);
}

/// Every corner of a path, along the spring.
fn along(path: &str) -> Vec<f64> {
    let starts: Vec<usize> = path.match_indices(['M', 'H', 'L', 'V']).map(|(at, _)| at).collect();
    let mut along = Vec::new();
    for (nth, &start) in starts.iter().enumerate() {
        let end = starts.get(nth + 1).copied().unwrap_or(path.len());
        // A vertical line does not change the place along the spring.
        if &path[start..=start] != "V" {
            along.push(numbers(&path[start + 1..end])[0]);
        }
    }
    along
}

#[test]
fn the_lines_of_a_spring_that_its_end_passes_stay_between_its_ends() {
    let film = Through::new().film(turn().map(f64::sin));
    for path in &check(&film, ["O", "P"]).paths {
        let length = length(path);
        for x in along(path) {
            // Corners are rounded to 0.1 px, the end to 0.01 px.
            let is_between = length.min(0.0) - 0.06 <= x && x <= length.max(0.0) + 0.06;
            assert!(is_between, "{x} is not between 0 and {length}: {path}");
        }
    }
}

/// Three twentieths of its shortest length, 14 px at most, and a coil for every 13 px at its middle length.
#[test]
fn a_spring_has_a_straight_part_at_either_end_and_as_many_coils_as_fit() {
    // As drawn, and on pages on which the spring is too short for a straight part of 14 px.
    for width in [720.0, 200.0, 120.0] {
        let film = Sprung::new().film(swing()).width(width);
        let drawn = check(&film, ["U", "C"]);
        let lengths: Vec<f64> = drawn.paths.iter().map(|path| length(path)).collect();
        let least = lengths.iter().copied().fold(f64::MAX, f64::min);
        let most = lengths.iter().copied().fold(0.0, f64::max);
        let lead = (0.15 * least).min(14.0);
        let coils = ((least + most) / 26.0).round().clamp(4.0, 10.0);
        assert!(lead > 2.0, "{width}: {lead}");
        for (path, length) in drawn.paths.iter().zip(lengths) {
            let corners = along(path);
            // The beginning, the straight part, two corners a coil, the other straight part, the end.
            assert_eq!(corners.len() as f64, 4.0 + 2.0 * coils, "{width}: {path}");
            let [first, last] = [corners[1], corners[corners.len() - 2]];
            assert!((first - lead).abs() < 0.06, "{width}: {first} for {lead}");
            assert!((last - (length - lead)).abs() < 0.06, "{width}: {last}");
        }
    }
}

mechanism! {
    /// A mass on a spring along a line at any angle.
    struct Slanted {
        input x: length;
        param way: angle = 0deg;
        ground O(0, 0);
        guide rail through O along way;
        slider body(rail) -> P { slide: x }
        mass 1kg on P;
        spring between O and P { stiffness: 15(N/m), free_length: 0 }
    }
}

/// The plate of a wall, of which up is y of its group.
const PLATE: &str = "M-17 0H17";
const SUPPORT: &str = "M0 0L-10 17H10Z";

#[test]
fn a_wall_looks_along_its_spring_at_every_angle() {
    for degrees in (0..24).map(|nth| 15.0 * f64::from(nth)) {
        for lengths in [[0.2, 0.3, 0.5], [-0.2, -0.3, -0.5]] {
            let film = Slanted { way: f64::to_radians(degrees) }.film(lengths);
            let text = film.to_svg().unwrap();
            assert_eq!(text.matches(PLATE).count(), 1, "{degrees}");
            let root = parse(&text);
            let elements = root.all();
            let holds = |e: &&&Element| e.children.iter().any(|c| c.attribute("d") == Some(PLATE));
            let wall = elements.iter().find(holds).expect("there is a wall");
            let seat = wall.attribute("transform").unwrap().replace("translate", " ");
            let turned = numbers(&seat.replace("rotate", " ")).get(2).copied().unwrap_or(0.0);
            // Up on the page is −y; turned clockwise by `turned`.
            let (sin, cos) = turned.to_radians().sin_cos();
            let looks = [sin, -cos];
            let view = film.view().unwrap();
            let [o, p] = ["O", "P"].map(|name| film.point(0, name).unwrap());
            let [o, p] = [o, p].map(|at| view.pixels([at.x, at.y]));
            let length = (p[0] - o[0]).hypot(p[1] - o[1]);
            let dot = (looks[0] * (p[0] - o[0]) + looks[1] * (p[1] - o[1])) / length;
            // The angle is rounded to 0.001°.
            assert!(dot > 1.0 - 1e-8, "{degrees} {lengths:?}: {dot}");
        }
    }
}

mechanism! {
    /// A pivot that holds a spring along a line as well.
    struct Shared {
        input x: length;
        input q: angle;
        ground O(0, 0);
        guide rail through O along 0deg;
        slider body(rail) -> P { slide: x }
        crank arm(O) -> Q      { length: 0.2m, angle: q }
        mass 1kg on P;
        mass 1kg on Q;
        spring between O and P { stiffness: 15(N/m), free_length: 0 }
    }
}

#[test]
fn a_spring_on_a_pivot_gets_no_wall_beside_the_support() {
    let film = Shared::new().film([[0.3, 1.0], [0.4, 1.5], [0.5, 2.0]]);
    let text = film.to_svg().unwrap();
    assert_eq!((text.matches(SUPPORT).count(), text.matches(PLATE).count()), (1, 0));
}

#[test]
fn a_spring_on_what_is_missing_is_hidden_with_it() {
    let path = (0..=60).map(|k| 0.1 + 0.1 * f64::from(k));
    let film = Sprung::new().film(path);
    let root = parse(&film.to_svg().unwrap());
    let elements = root.all();
    let coil = elements.iter().find(|e| e.attribute("data-spring") == Some("U C")).unwrap();
    let mut missing = 0;
    for pose in 0..film.len() {
        let is_there = film.point(pose, "C").is_ok();
        let share = pose as f64 / (film.len() - 1) as f64;
        assert_eq!(is_shown(coil, share), is_there, "{pose}");
        missing += usize::from(!is_there);
    }
    assert!((1..60).contains(&missing), "{missing}");
}

#[test]
fn applied_forces_are_those_of_the_declaration() {
    let sprung = Sprung::new();
    let (q, rate, loads) = (0.5, 2.0, SprungLoads { push: 40.0, thrust: 7.0 });
    let found = sprung.applied(q, rate, loads).unwrap();
    let p = sprung.position(q).unwrap();
    let v = sprung.velocity(q, rate).unwrap();
    let own = 7.0 + 3.0 * v.B.x;
    let (dx, dy) = (p.C.x - p.P.x, p.C.y - p.P.y);
    let push = [dx, dy].map(|d| 40.0 * d / dx.hypot(dy));
    let wanted = [
        ("C", [40.0, 80.0]),
        ("B", [-own * p.AB.sin, own * p.AB.cos]),
        ("P", push.map(|x| -x)),
        ("C", push),
    ];
    assert_eq!(found.forces().len(), wanted.len());
    for ((name, force), (point, by_hand)) in found.forces().iter().zip(wanted) {
        assert_eq!(*name, point);
        for (a, b) in force.iter().zip(by_hand) {
            assert!((a - b).abs() < 1e-12, "{name}: {force:?} {by_hand:?}");
        }
    }
    let nothing = sprung.applied(q, rate, SprungLoads { push: f64::NAN, thrust: 0.0 });
    assert_eq!(nothing.unwrap_err(), SolveError::NotFinite { name: "push" });
    assert!(matches!(sprung.applied(3.0, 0.0, loads), Err(SolveError::OutOfReach { .. })));
}

#[test]
fn a_film_of_applied_forces_is_one_of_the_same_forces_by_hand() {
    let shear = shear_bearings::FlyingShear::new();
    let film = || shear.film([0.0, 1.0, 2.0]);
    let cuts = [2e3, 1e4, 5e3];
    let read = film()
        .applied([0.0, 1.0, 2.0].iter().zip(cuts).map(|(q, cut)| shear.applied(*q, 0.0, cut)));
    let by_hand = film().force("blade", cuts.map(|cut| [0.0, cut]));
    assert_eq!(read.to_svg().unwrap(), by_hand.to_svg().unwrap());
    // Where there is no result there is no arrow.
    let failed = [Err(SolveError::Singular { group: "" }), shear.applied(1.0, 0.0, 1e4)];
    let text = film().applied(failed).to_svg().unwrap();
    assert!(text.contains(r#"opacity="0""#));
    let none = film().applied(std::iter::empty()).to_svg().unwrap();
    assert_eq!(none, film().to_svg().unwrap());
}
