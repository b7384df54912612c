//! Cases whose friction or force is the user's own law, and a crane with a told trolley.
//!
//! Numbers have thirty digits and come from their closed forms.

use linkage_core::mechanism;
use linkage_tests::mechanisms::told::Trolley;

mechanism! {
    /// A band about 270° of a drum, its slack side drawn by 100 N.
    pub struct BandBrake {
        input theta: angle;
        let grip = exp(0.3 * (270deg / 1rad));
        ground A(0, 0);
        crank drum(A) { angle: theta }
        torque -(grip - 1) * 100N * 0.2m * sign(rate(theta)) on drum;
    }
}

mechanism! {
    /// A gas spring of 400 N at 0.5 m and a stroke of 0.2 m.
    pub struct GasSpring {
        input x: length;
        ground P(0, 0);
        guide line through P along 0deg;
        slider rod(line) -> Q { slide: x }
        force 400N * pow(0.2m / (0.2m - (0.5m - x)), 1.3) between P and Q;
    }
}

/// Each number is made of some twenty operations.
fn close(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-13 * expected.abs(), "{found} is not {expected}");
}

#[test]
fn band() {
    for rate in [3.0, -3.0] {
        let f = BandBrake::new().forces(0.4, rate, 0.0).unwrap();
        close(f.theta.drive * f64::signum(rate), 62.224_142_857_707_056_8);
    }
}

/// The acceleration that leaves the sway without a couple, and the trolley's drive.
#[test]
fn told() {
    let sway = -1.189_262_923_245_221_815;
    let f = Trolley::new().forces([2.0, 0.3], [0.5, -0.4], [0.7, sway]).unwrap();
    close(f.x.drive, -88.023_079_713_478_306_172);
    // The couple is a difference of some 80 kg · 9.81 m/s² · 3 m.
    assert!(f.sway.drive.abs() < 1e-13 * 2400.0, "{}", f.sway.drive);
    let second =
        Trolley::new().forward_dynamics([2.0, 0.3], [0.5, -0.4], [f.x.drive, 0.0]).unwrap();
    close(second[1], sway);
    close(second[0], 0.7);
}

#[test]
fn gas_spring() {
    let f = GasSpring::new().forces(0.38, 0.0, 0.0).unwrap();
    close(-f.x.drive, 1_316.382_204_334_237_413);
}
