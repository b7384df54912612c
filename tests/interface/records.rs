//! The uses of generated items in a user's own struct.

use linkage_core::find::Root;
use linkage_core::range::{Extrema, Stretches};
use linkage_core::{Direction, Force, Point, Slide, mechanism};

mechanism! {
    struct Press {
        input theta: angle;
        param rod = 3m;
        ground A(0, 0);
        guide rail through A along 0deg;
        crank AB(A) -> B          { length: 1m, angle: theta }
        rrp BC(B), ram(rail) -> C { length: rod, mode: ahead }
        output ram.slide, C;
    }
}

/// Solvers and records have what is derived, on the same terms: a generic struct that holds them needs no
/// bound of its own.
#[test]
fn generic_structs_hold_solvers_and_records_and_derive_the_same() {
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct State<T> {
        press: Press<T>,
        last: PressMotion<T>,
    }
    let press = Press::new();
    let state = State { press, last: press.motion(0.0, 1.0, 0.0).unwrap() };
    let copies = [state; 2];
    assert_eq!(copies.to_vec()[1], state);
    assert_eq!(
        format!("{:?}", state.last.position),
        "PressPosition { ram: Slide { slide: 4.0 }, C: Point { x: 4.0, y: 0.0 } }"
    );
}

/// A user's function names a record or a result without its number, which is `f64` then, as the
/// solver's is.
#[test]
fn records_and_results_are_of_f64_unless_another_number_is_named() {
    fn show(motion: &PressMotion) -> String {
        let (position, velocity): (&PressPosition, &PressVelocity) =
            (&motion.position, &motion.velocity);
        let (pin, ram, acceleration): (Point, Slide, &PressAcceleration) =
            (position.C, velocity.ram, &motion.acceleration);
        format!("{:.1} {:.1} {:.1}", pin.x, ram.slide, acceleration.ram.slide)
    }
    // At a quarter of a turn s = cos θ + √(9 − sin² θ) is √8, s′ = −1 and s″ = 1/√8.
    let motion = Press::new().motion(core::f64::consts::FRAC_PI_2, 1.0, 0.0).unwrap();
    assert_eq!(show(&motion), "2.8 -1.0 0.4");
    let narrow: PressMotion<f32> = Press::default().motion(0.0_f32, 1.0, 0.0).unwrap();
    assert_eq!(narrow.position.C.x, 4.0);
    let sizes = [size_of::<Direction>(), size_of::<Force>(), size_of::<Root>()];
    assert_eq!(
        sizes,
        [size_of::<Direction<f64>>(), size_of::<Force<f64>>(), size_of::<Root<f64>>()]
    );
    let of_ranges = [size_of::<Extrema>(), size_of::<Stretches>()];
    assert_eq!(of_ranges, [size_of::<Extrema<f64>>(), size_of::<Stretches<f64>>()]);
}
