//! What nobody should ask for: a typed error or a picture that says so, never a panic.

use gallery::declarations::{five_bar_robot, flying_shear, range};
use linkage_core::SolveError;
use linkage_core::sketch::{SketchError, Unit};

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
        Err(SketchError::UnknownName { kind: "link", nearest: Some("BC"), .. })
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
