//! A gripper: a screw moves a nut, two fingers close. Which nut opens it by a given width has no closed form, and
//! is solved in the declaration.

use linkage_core::mechanism;
use linkage_tests::random::Random;

mechanism! {
    /// From the screw to the opening.
    pub struct FromScrew {
        /// The nut's place on the screw.
        input screw: length;
        /// The force that each finger presses with.
        load grip: force;

        ground F(50mm, 30mm);
        guide axis through (0, 0) along 0deg;
        slider nut(axis) -> N      { slide: screw }
        rrr    link(N), horn(F) -> H { lengths: (40mm, 25mm), mode: left }
        point tip on horn at (-60mm, 5mm);
        let width = 2 * tip.y;

        force (0, grip) on tip;
        output opening = width, tip, N, H, screw.drive;
    }
}

mechanism! {
    /// From the opening to the screw, which an equation fixes.
    pub struct FromOpening {
        input opening: length;
        load thrust: force;

        ground F(50mm, 30mm);
        guide axis through (0, 0) along 0deg;
        unknown screw: length between (-2mm, 18mm);
        slider nut(axis) -> N      { slide: screw }
        rrr    link(N), horn(F) -> H { lengths: (40mm, 25mm), mode: left }
        point tip on horn at (-60mm, 5mm);
        let width = 2 * tip.y;
        solve screw { width = opening, mode: falling }

        force (thrust, 0) on N;
        output screw, tip, opening.drive, screw.drive;
    }
}

#[test]
fn power_is_the_same_on_both_sides_of_a_gripper() {
    let (screw, opening) = (FromScrew::new(), FromOpening::new());
    let mut random = Random::new(42);
    let mut worst = [0.0_f64; 3];
    for _ in 0..20_000 {
        let [at, rate, grip] =
            [(0.5e-3, 14.5e-3), (-0.1, 0.1), (-50.0, 50.0)].map(|(a, b)| random.anywhere(a, b));
        let apart = |one: f64, two: f64| (one - two).abs() / (one.abs() + two.abs());
        let width = screw.position(at).expect("it reaches").opening;
        let closing = screw.velocity(at, rate).expect("it moves").opening;
        let thrust = screw.statics(at, grip).expect("it stands").screw.drive;
        // The grip pushes the tip outwards, half of the opening's rate.
        worst[0] = worst[0].max(apart(thrust * rate, -grip * closing / 2.0));

        let back = opening.position(width).expect("it opens that far");
        worst[1] = worst[1].max((back.screw - at).abs() / 0.04);
        let held = opening.statics(width, -thrust).expect("it stands").opening.drive;
        worst[2] = worst[2].max(apart(held, -grip / 2.0));
    }
    let [power, places, forces] = worst.map(|error| error / f64::EPSILON);
    println!("power {power:.2} ε, places {places:.1} ε, forces {forces:.1} ε");
    assert!(power <= 8.0, "{power}");
    // The places are compared with the link's length. The test goes through the equation there and back.
    assert!(places <= 16.0 && forces <= 64.0, "{worst:?}");
}
