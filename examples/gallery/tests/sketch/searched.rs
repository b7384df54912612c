//! Mechanisms of which an equation fixes a part.

use gallery::declarations::{set_point, suspension};
use linkage_core::sketch::Film;
use linkage_core::{SolveError, mechanism};

use super::gaps::is_shown;
use super::placed::compare;
use super::xml::parse;

mechanism! {
    /// Two unknowns, the second behind the first, and what hangs on both.
    struct Twice {
        input x, h: length;
        param lag: angle = 2deg;
        ground A(0, 0), D(0.9m, 0);
        guide rail through (0, 0.1m) along 0deg;
        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B             { length: 0.1m, angle: theta }
        rrp   BC(B), ram(rail) -> C  { length: 0.3m, mode: ahead }
        solve theta { ram.slide = x, mode: falling, near: 60deg }
        unknown phi: angle between (-80deg, 80deg);
        crank DE(D) -> E             { length: 0.5m, angle: 180deg - phi - lag }
        rpr   block(E), bar(C)       { offset: 20mm, mode: ahead }
        solve phi { E.y = h, mode: rising }
        point P on bar at (0.2m, theta * 0.05m);
    }
}

mechanism! {
    /// An equation whose difference jumps where an angle passes half a turn: it has no root there.
    struct Jump {
        input psi: angle;
        unknown theta: angle between (90deg, 270deg);
        ground A(0, 0);
        crank AB(A) -> B { length: 1m, angle: theta }
        solve theta { AB.angle = psi, mode: falling }
    }
}

#[test]
fn what_is_searched_is_drawn_where_the_solver_finds_it() {
    let car = suspension::ByTheWheel::new();
    compare(&car, &[[0.15, 0.5]], |path| car.film(path.iter().map(|z| z[0])));
    let twice = Twice::new();
    compare(&twice, &[[0.19, 0.4], [-0.4, 0.45]], |path| twice.film(path.iter().copied()));
    let jump = Jump::new();
    let film = jump.film([0.0, 3.0]);
    assert!(jump.position(0.0).is_err() && film.point(0, "B").is_err());
    let text = jump.film([0.0]).to_svg().unwrap();
    assert!(text.contains("its ends, 180° missing<"), "{text}");
    // A picture of one point has no size of its own.
    assert!(text.contains(">50 mm<"), "{text}");
}

/// From where the wheel can be to far above and back.
fn beyond() -> Vec<f64> {
    (0..=80).map(|k| 0.33 + 0.4 * (f64::from(k) * std::f64::consts::PI / 80.0).sin()).collect()
}

fn missing(car: &suspension::ByTheWheel, z: f64) -> Option<f64> {
    match car.position(z) {
        Err(SolveError::NoSolution { unknown: "theta", by, unit: "m", .. }) => Some(by),
        Err(error) => panic!("{error}"),
        Ok(_) => None,
    }
}

#[test]
fn a_place_without_a_root_is_a_gap_that_says_what_is_missing() {
    let (car, path) = (suspension::ByTheWheel::new(), beyond());
    let film: Film = car.film(path.iter().copied()).trace("W");
    let found: Vec<Option<f64>> = path.iter().map(|&z| missing(&car, z)).collect();
    let [gap] = &film.gaps()[..] else { panic!("{:?}", film.gaps()) };
    for (pose, found) in found.iter().enumerate() {
        assert_eq!(gap.poses.contains(&pose), found.is_some(), "{pose}");
        assert_eq!(film.link(pose, "kingpin").is_err(), found.is_some(), "{pose}");
        assert!(film.point(pose, "A").is_ok());
    }
    assert_eq!(gap.error, car.position(path[gap.poses.start]).unwrap_err());
    // The footer has the largest of them, in the unit that was asked for.
    let worst = found.iter().flatten().fold(0.0, |worst: f64, by| worst.max(*by));
    let cm = film.unit(linkage_core::sketch::Unit::Cm);
    let text = cm.to_svg().unwrap();
    let footer =
        format!("theta: no solution between its ends, {:.1} cm missing at worst", 1e2 * worst);
    assert!(text.contains(&footer), "{footer}: {text}");
    let root = parse(&text);
    let links = root.all().into_iter().filter(|e| e.attribute("data-link").is_some());
    let mut hidden = 0;
    for link in links {
        for (pose, found) in found.iter().enumerate() {
            let share = pose as f64 / (path.len() - 1) as f64;
            assert_eq!(is_shown(link, share), found.is_none(), "{pose}");
            hidden += usize::from(found.is_some());
        }
    }
    assert!(hidden > 50, "{hidden}");
    // One pose is an error, and a film of it alone a picture that says so.
    assert_eq!(car.sketch(0.9).unwrap_err(), car.position(0.9).unwrap_err());
    let alone = car.film([0.9]).to_svg().unwrap();
    assert!(alone.contains("mm missing<"), "{alone}");
    let strange = car.film([0.9, f64::NAN, 1e300]).following().there_and_back();
    assert!(strange.to_html().is_ok() && strange.gaps().len() > 1);
}

#[test]
fn a_film_of_what_is_searched_keeps_its_modes() {
    let press = set_point::Press::new();
    let film = || press.film((0..=40).map(|k| 0.2 + 0.003 * f64::from(k)));
    let kept = film().to_svg().unwrap();
    assert_eq!(film().following().to_svg().unwrap(), kept);
    assert!(film().gaps().is_empty());
}
