//! Sensitivities to dimensions against what geometry says of them.

use linkage_tests::mechanisms::driven_groups::DrivenRrr;

/// Lengthening a bar moves the pin along it by that much and along the other bar not at all.
#[test]
fn sensitivities_satisfy_the_constraints() {
    let bars = DrivenRrr { l1: 1.25, l2: 1.5, ..DrivenRrr::new() };
    assert_eq!(DrivenRrr::PARAMS, ["l1", "l2"]);
    for q in [[0.0, 0.0, 1.0, 0.5], [0.25, -0.5, 1.5, 1.0], [-1.0, 0.5, 0.5, -0.75]] {
        let pose = bars.position(q).unwrap();
        let slopes = bars.sensitivity(q).unwrap();
        let row =
            |name: &str| DrivenRrr::OUTPUTS.iter().position(|output| *output == name).unwrap();
        let (x, y) = (row("C.x"), row("C.y"));
        let along = |cos: f64, sin: f64, length: usize| {
            slopes[(x, length)] * cos + slopes[(y, length)] * sin
        };
        // Twenty roundings of numbers below 2, at angles whose sine is above 0.5.
        let slack = 80.0 * f64::EPSILON;
        for (bar, own) in [(pose.BC, 0), (pose.DC, 1)] {
            for length in 0..2 {
                let stretch = if length == own { 1.0 } else { 0.0 };
                assert!((along(bar.cos, bar.sin, length) - stretch).abs() <= slack);
            }
        }
        for (bar, name, size) in [(pose.BC, "BC.angle", 1.25), (pose.DC, "DC.angle", 1.5)] {
            for length in 0..2 {
                let turned = along(-bar.sin, bar.cos, length) / size;
                assert!((slopes[(row(name), length)] - turned).abs() <= slack);
            }
        }
    }
}
