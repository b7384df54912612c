//! A still, a film and a figure as they were. `LINKAGE_RENEW=1` writes them anew: look at them.

use std::fs;
use std::path::Path;

use gallery::declarations::{flying_shear, slider_crank};
use gallery::motions::turn;

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
