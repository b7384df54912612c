//! What generated records share with any plain struct: `Clone`, `Copy`, `Debug` and `PartialEq`, against
//! copies of them that have all four derived.

use core::array::from_fn;
use core::fmt::Debug;
use linkage_core::{
    AngularAcceleration, AngularVelocity, Direction, Force, GuideForce, Point, Record, Shaking,
    Slide, SlidingAcceleration, SlidingDirection, SlidingVelocity, mechanism,
};

mechanism! {
    /// Something of everything that a result can be.
    pub struct Shovel {
        input swing: angle;
        input tilt: angle;
        load pull: force;
        load brake: torque;
        ground A(0, 0), D(0.4m, 0);
        crank AB(A) -> B { length: 0.3m, angle: swing }
        crank DE(D) -> E { length: 0.3m, angle: tilt }
        rrr BC(B), EC(E) -> C { lengths: (0.5m, 0.5m), mode: left }
        guide rail through (0, 1.2m) along 0deg;
        rrp CR(C), block(rail) -> R { length: 1.5m, mode: ahead }
        rpr cyl(E), rod(R) { offset: 0 }
        gravity (0, -9.81);
        mass 0.8kg on AB uniform;
        mass 0.5kg on CR uniform;
        force (pull, 0) in BC on C;
        torque brake on DE;
        output swing.drive, AB.A, block.rail, shaking, C, BC, cyl, block.slide, span = distance(A, C),
            EC.margin, energy;
    }
}

/// The structs with everything derived, and how each is made of the record of its name.
macro_rules! derived {
    ($($name:ident { $($field:ident: $ty:ty),* })*) => {
        #[allow(non_camel_case_types, non_snake_case, reason = "names are those of the records")]
        mod by_hand {
            use super::*;

            $(
                #[derive(Clone, Copy, Debug, PartialEq)]
                pub(super) struct $name { $($field: $ty),* }

                impl From<super::$name<f64>> for $name {
                    fn from(record: super::$name<f64>) -> Self {
                        Self { $($field: record.$field.into()),* }
                    }
                }
            )*
        }

        #[test]
        fn records_are_copied_compared_and_shown_as_if_derived() {
            $(agree::<$name<f64>, by_hand::$name>(Record::from_array(from_fn(number)));)*
        }
    };
}

derived! {
    ShovelInput { swing: f64, tilt: f64 }
    ShovelLoads { pull: f64, brake: f64 }
    ShovelPosition {
        C: Point<f64>, BC: Direction<f64>, cyl: SlidingDirection<f64>, block: Slide<f64>,
        span: f64, EC_margin: f64
    }
    ShovelVelocity {
        C: Point<f64>, BC: AngularVelocity<f64>, cyl: SlidingVelocity<f64>, block: Slide<f64>,
        span: f64, EC_margin: f64
    }
    ShovelAcceleration {
        C: Point<f64>, BC: AngularAcceleration<f64>, cyl: SlidingAcceleration<f64>, block: Slide<f64>,
        span: f64, EC_margin: f64
    }
    ShovelMotion {
        position: ShovelPosition, velocity: ShovelVelocity, acceleration: ShovelAcceleration
    }
    ShovelMargins { EC_margin: f64 }
    ShovelForcesOfswing { drive: f64 }
    ShovelForcesOfAB { A: Force<f64> }
    ShovelForcesOfblock { rail: GuideForce<f64> }
    ShovelForces {
        swing: ShovelForcesOfswing, AB: ShovelForcesOfAB, block: ShovelForcesOfblock,
        shaking: Shaking<f64>
    }
    ShovelEnergy { kinetic: f64, potential: f64 }
    ShovelEquations { mass: [[f64; 2]; 2], force: [f64; 2] }
}

/// A number of its own for each place, of many sizes and both signs.
fn number(index: usize) -> f64 {
    let index = index as f64;
    (index - 3.25) * 10_f64.powf(index - 6.0)
}

fn agree<R, D>(record: R)
where
    R: Record<Number = f64> + Copy + PartialEq + Debug,
    D: From<R> + PartialEq + Debug,
{
    let derived = D::from(record);
    assert_eq!(format!("{record:?}"), format!("{derived:?}"));
    assert_eq!(format!("{record:#?}"), format!("{derived:#?}"));
    assert_eq!(format!("{record:+8.3?}"), format!("{derived:+8.3?}"));
    #[expect(clippy::clone_on_copy, reason = "it is what is asked")]
    let cloned = record.clone();
    assert_eq!(D::from(cloned), derived);
    assert_eq!(record, cloned);
    // One number at a time: what differs, what differs in its sign alone, and what equals nothing.
    for index in 0..R::LABELS.len() {
        for [before, after] in [[0.0, -0.0], [1.0, 2.0], [f64::NAN, f64::NAN], [5.0, 5.0]] {
            let with = |number| {
                let mut numbers = record.into_array();
                numbers.as_mut()[index] = number;
                R::from_array(numbers)
            };
            let (before, after) = (with(before), with(after));
            assert_eq!(before == after, D::from(before) == D::from(after), "{before:?} {after:?}");
            assert_eq!(format!("{after:?}"), format!("{:?}", D::from(after)));
        }
    }
}

/// Of numbers that are nothing but `Copy`, a record is `Copy` as well, and no more is asked of it.
#[test]
fn a_record_of_anything_that_is_copy_is_copy() {
    #[derive(Clone, Copy)]
    struct Plain;
    let record: ShovelEnergy<Plain> = Record::from_array([Plain; 2]);
    let copies = [record; 2];
    assert_eq!(copies.len(), 2);
    // Neither compared nor shown, slices go in and out.
    let (mut one, mut two) = ([0.0; 3], [0.0; 3]);
    let slices: ShovelEnergy<&mut [f64]> = Record::from_array([&mut one[..], &mut two[..]]);
    assert_eq!(slices.into_array().map(|slice| slice.len()), [3, 3]);
}

/// A struct of the user's holds it and derives the same, whatever the number.
#[test]
fn a_solver_is_copied_compared_and_shown() {
    #[derive(Clone, Debug, PartialEq)]
    struct Holder<T> {
        shovel: Shovel<T>,
    }
    let shovel = Shovel::new();
    let copy = shovel;
    #[expect(clippy::clone_on_copy, reason = "it is what is asked")]
    let cloned = copy.clone();
    assert_eq!(Holder { shovel }.clone(), Holder { shovel: cloned });
    assert_eq!(format!("{cloned:?}"), "Shovel { use_new_: PhantomData<f64> }");
}
