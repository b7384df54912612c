//! A still, a film and the figures as they were. `LINKAGE_RENEW=1` writes the first two anew, `cargo run
//! --release -p gallery -- --committed` what documentation and README show: look at them.

use std::fs;
use std::path::Path;

use gallery::declarations::{flying_shear, slider_crank};
use gallery::motions::turn;
use linkage_core::sketch::Theme;

fn check(name: &str, made: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/sketch/snapshots").join(name);
    if std::env::var_os("LINKAGE_RENEW").is_some() {
        return fs::write(path, made).unwrap();
    }
    let kept = fs::read_to_string(path).unwrap();
    assert!(made == kept, "{name} is another: LINKAGE_RENEW=1 writes it anew; look at it then");
}

#[test]
fn pictures_are_as_they_were() {
    let still = flying_shear::FlyingShear::new().sketch(2.0).unwrap();
    check("still.svg", &still.to_svg().unwrap());
    let coarse = turn().step_by(20);
    let film = slider_crank::OffsetSliderCrank::new().film(coarse).trace("P").title("Slider-crank");
    check("film.svg", &film.to_svg().unwrap());
}

#[test]
fn documentation_and_readme_show_what_is_drawn_now() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let differs = |kept: &str, made: &str| {
        let kept = root.join(kept);
        let text = fs::read_to_string(&kept).unwrap();
        assert!(text == made, "{} is another: see the head of this file", kept.display());
    };
    for (name, figure) in gallery::figures::figures(Theme::Auto).unwrap() {
        differs(&format!("linkage-core/src/figures/{name}.svg"), &figure);
        assert!(!figure.contains("\n\n"), "documentation would end at an empty line");
        crate::xml::parse(&figure);
    }
    let film = gallery::motions::of_unknowns();
    differs("linkage-core/src/figures/suspension.svg", &film.to_svg().unwrap());
    differs("linkage-core/src/figures/drawn.md", &gallery::figures::addresses().unwrap());
    let of_limits = gallery::figures::addresses_of_limits().unwrap();
    differs("linkage-core/src/figures/drawn_limits.md", &of_limits);
    let of_searches = gallery::figures::addresses_of_searches().unwrap();
    differs("linkage-core/src/figures/drawn_searches.md", &of_searches);
    for (name, film) in gallery::readme() {
        differs(&format!("examples/gallery/films/{name}.svg"), &film.to_svg().unwrap());
    }
}
