//! Invalid requests: each gives a typed error or a picture that says so, never a panic.

use gallery::declarations::{five_bar_robot, flying_shear, range};
use linkage_core::SolveError;
use linkage_core::sketch::{SketchError, Theme, Unit};

use super::xml::parse;

#[test]
fn an_unknown_name_is_told_with_the_nearest() {
    let shear = flying_shear::FlyingShear::new();
    let message = |error: Result<String, SketchError>| error.unwrap_err().to_string();
    let sketch = || shear.sketch(2.0).unwrap();
    assert_eq!(
        message(sketch().trace("Blade").to_svg()),
        "no point named `Blade`; the nearest name is `blade`"
    );
    assert_eq!(
        message(shear.film([0.0]).label(["b"]).to_svg()),
        "no point named `b`; the nearest name is `B`"
    );
    assert!(shear.film([0.0]).force("E", [[1.0, 0.0]]).to_svg().is_err());
    assert!(matches!(
        sketch().link("bc"),
        Err(SketchError::UnknownName { kind: "link", nearest: Some(name), .. }) if name == "BC"
    ));
}

#[test]
fn an_empty_path_is_an_error_and_an_unassembled_pose_the_solvers() {
    let shear = flying_shear::FlyingShear::new();
    let nothing = shear.film(std::iter::empty::<f64>());
    assert!(matches!(nothing.to_svg(), Err(SketchError::EmptyPath)));
    assert!(matches!(nothing.still().to_svg(), Err(SketchError::EmptyPath)));
    assert!(nothing.is_empty() && nothing.gaps().is_empty());
    assert!(nothing.there_and_back().following().to_html().is_err());
    let far = range::FourBar { base: 1.0 };
    assert_eq!(far.sketch(0.0).unwrap_err(), far.position(0.0).unwrap_err());
    assert!(matches!(shear.sketch(f64::NAN), Err(SolveError::NotFinite { name: "theta" })));
    assert!(shear.film([0.0]).point(1, "B").is_err());
    let file = shear.sketch(0.0).unwrap().write_svg("no/such/folder/pose.svg");
    assert!(matches!(file, Err(SketchError::Write(_))));
}

#[test]
fn one_pose_is_a_film_that_stands_still() {
    let shear = flying_shear::FlyingShear::new();
    let film = shear.film([2.0]).trace("blade").poses(6);
    let text = film.to_svg().unwrap();
    assert!(!text.contains("<animate") && text.contains("data-point=\"blade\""));
    parse(&text);
    parse(&film.still().to_svg().unwrap());
    assert!(film.there_and_back().to_html().is_ok());
    // One pose out of reach says how far, and has no "at worst".
    let far = range::FourBar { base: 1.0 }.film([0.0]).to_svg().unwrap();
    assert!(far.contains("BC, DC: 450 mm out of reach<"), "{far}");
}

#[test]
fn a_pose_that_is_no_number_is_a_gap_and_is_said() {
    let shear = flying_shear::FlyingShear::new();
    let film = shear.film([0.0, f64::NAN, 1.0]);
    let [gap] = &film.gaps()[..] else { panic!("{:?}", film.gaps()) };
    assert_eq!((gap.poses.clone(), gap.error), (1..2, SolveError::NotFinite { name: "theta" }));
    let text = film.to_svg().unwrap();
    assert!(text.contains("`theta` leads to a result that is not finite"), "{text}");
    // Nothing of the machine is shown then but the ground.
    assert!(film.point(1, "B").is_err() && film.point(1, "D").is_ok());
}

#[test]
fn reactions_are_read_from_the_results() {
    use gallery::declarations::shear_bearings;
    let shear = shear_bearings::FlyingShear::new();
    let path = [0.0, 1.0, 2.0];
    let arrows = |text: &str| {
        let root = parse(text);
        let elements = root.all();
        let arrows = elements.iter().filter(|e| e.attribute("stroke-width") == Some("2"));
        arrows.map(|arrow| arrow.attribute("d").unwrap().to_string()).collect::<Vec<_>>()
    };
    let read = shear.film(path).reactions(path.map(|q| shear.statics(q, 1e4)));
    let forces = path.map(|q| shear.statics(q, 1e4).unwrap());
    let given = shear
        .film(path)
        .force("A", forces.map(|f| [f.AB.A.x, f.AB.A.y]))
        .force("B", forces.map(|f| [f.AB.B.x, f.AB.B.y]))
        .force("C", forces.map(|f| [f.BC.C.x, f.BC.C.y]))
        .force("D", forces.map(|f| [f.DC.D.x, f.DC.D.y]));
    let text = read.to_svg().unwrap();
    // Reactions have a colour of their own.
    let (own, other) = (Theme::Light.palette().push, Theme::Light.palette().accent);
    let given = given.to_svg_in(Theme::Light).unwrap();
    assert!(
        read.to_svg_in(Theme::Light).unwrap() == given.replace(other, own) && given.contains(other)
    );
    assert_eq!(arrows(&text).len(), 4);
    // A pose without a result has no arrows; there is none for what has no joint.
    let failed = path.map(|q| {
        if q == 0.0 { Err(SolveError::Singular { group: "" }) } else { shear.statics(q, 1e4) }
    });
    let text = shear.film(path).reactions(failed).to_svg().unwrap();
    assert_eq!(
        parse(&text).all().iter().filter(|e| e.attribute("opacity") == Some("0")).count(),
        4
    );
    // There and back the forces go back as well.
    let back = shear.film(path).there_and_back().reactions(path.map(|q| shear.statics(q, 1e4)));
    let shapes = back.to_svg().unwrap();
    let root = parse(&shapes);
    let elements = root.all();
    let moving = elements.iter().find(|e| e.attribute("attributeName") == Some("d")).unwrap();
    let values: Vec<&str> = moving.attribute("values").unwrap().split(';').collect();
    assert_eq!((values.len(), values[0], values[1]), (5, values[4], values[3]));
}

#[test]
fn any_number_is_drawn_or_said_to_be_none() {
    let strange = [f64::NAN, f64::INFINITY, 1e300, -1e300, 1e17, 5e-324, 0.0];
    let shear = flying_shear::FlyingShear::new();
    for q in strange {
        for path in [vec![q], vec![0.0, q, 1.0], vec![q, q]] {
            let film = shear.film(path).trace("blade").poses(usize::MAX).seconds(q).width(q);
            parse(&film.to_svg().unwrap());
            parse(&film.still().to_svg().unwrap());
            let _ = film.following().there_and_back().to_svg().unwrap();
        }
        for base in [0.39, -0.39, 0.0] {
            let bar = range::FourBar { base: base * q };
            parse(&bar.film([0.0, q]).unit(Unit::Cm).title("<&>").to_svg().unwrap());
        }
        let film = five_bar_robot::Inverse::new().film([[q, 0.3], [0.0, q]]);
        parse(&film.force("P", [[q, 1.0], [0.0, 0.0]]).to_svg().unwrap());
    }
}
