//! Tests of `model/dimension`.

use crate::model::units::unit;
pub(crate) use linkage_compiler::model::dimension::*;

#[test]
fn lengths_carry_exponents() {
    let area = Measure::LENGTH.product(Measure::LENGTH);
    assert_eq!(area.dimension().words(), "an area");
    assert_eq!(area.root(), Some(Measure::LENGTH));
    assert_eq!(Measure::LENGTH.root(), None);
    assert_eq!(Measure::LENGTH.quotient(Measure::LENGTH), Measure::NUMBER);
    assert_eq!(Measure::Bare.quotient(area).dimension().words(), "a quantity in m^-2");
}

#[test]
fn forces_are_made_of_masses_lengths_and_times() {
    let [mass, time, force] = [Dimension::MASS, Dimension::TIME, Dimension::FORCE];
    let acceleration = Dimension::LENGTH.times(time, -2);
    assert_eq!(acceleration.words(), "an acceleration");
    assert_eq!(mass.times(acceleration, 1), force);
    let torque = force.times(Dimension::LENGTH, 1);
    assert_eq!(torque.words(), "a torque");
    assert_eq!(torque.times(Dimension::ANGLE, -1), torque);
    let inertia = mass.times(Dimension::LENGTH, 2);
    assert_eq!(
        Measure::Known(torque).quotient(Measure::Known(inertia)).root().unwrap(),
        Measure::NUMBER.quotient(Measure::Known(time))
    );
    assert_eq!(force.times(Dimension::LENGTH, -1).words(), "a force over a length (N/m)");
}

/// The unit that a message proposes is read as the dimension that is missing.
#[test]
fn proposed_units_have_the_dimension() {
    let read = |text: &str| {
        let mut sign = 1;
        let factors = text.trim_matches(['(', ')']).split_inclusive(['*', '/']);
        factors.fold(Dimension::NUMBER, |product, factor| {
            let (name, power) = match factor.trim_end_matches(['*', '/']).split_once('^') {
                Some((name, power)) => (name, power.parse().expect("a power is a number")),
                None => (factor.trim_end_matches(['*', '/']), 1),
            };
            let of_unit = unit(name).map_or(Dimension::NUMBER, |(dimension, _)| dimension);
            let product = product.times(of_unit, power * sign);
            if factor.ends_with('/') {
                sign = -1;
            }
            product
        })
    };
    let powers = || -3..=3;
    let all = powers().flat_map(|l| powers().flat_map(move |m| powers().map(move |t| [l, m, t])));
    let mut count = 0;
    for [length, mass, time] in all {
        let dimension = Dimension { length, mass, time, angle: false };
        if let Some(text) = dimension.unit() {
            assert_eq!(read(text), dimension, "{text}");
            count += 1;
        }
    }
    assert_eq!(count, 16);
}

#[test]
fn an_angle_counts_as_a_number_in_products() {
    assert_eq!(Measure::ANGLE.product(Measure::LENGTH), Measure::LENGTH);
    assert_eq!(Measure::ANGLE.product(Measure::Bare), Measure::ANGLE);
    assert_eq!(Measure::ANGLE.quotient(Measure::ANGLE), Measure::NUMBER);
    assert_eq!(Measure::ANGLE.sum(Measure::LENGTH), None);
    assert_eq!(Measure::NUMBER.sum(Measure::ANGLE), Some(Measure::ANGLE));
}

#[test]
fn a_bare_number_fits_anywhere() {
    assert!(Measure::Bare.fits(Dimension::LENGTH) && Measure::Bare.fits(Dimension::ANGLE));
    assert_eq!(Measure::Bare.product(Measure::NUMBER), Measure::Bare);
    assert!(!Measure::NUMBER.fits(Dimension::LENGTH));
}
