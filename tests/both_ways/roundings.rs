//! The change of numbers that a rounding of what they are computed from brings: differences, beside any formula.

/// A function of several numbers; nothing where it has no value.
pub(crate) type Of<'a> = &'a dyn Fn(&[f64]) -> Option<Vec<f64>>;

/// Share of a weight by which a number is moved. The error of a difference is its square and ε over it, each far below
/// what a bound that is met within half of itself has to be known to.
const STEP: f64 = 1e-6;

/// The values of a function, and for each the sum of what its arguments change in it, ∑|∂f/∂x| weight: ε times that is
/// the error of an evaluation whose arguments are off by ε times their weights.
pub(crate) fn changes(of: Of<'_>, at: &[f64], weights: &[f64]) -> Option<[Vec<f64>; 2]> {
    let values = of(at)?;
    let mut changes = vec![0.0; values.len()];
    let mut moved = at.to_vec();
    for (index, weight) in weights.iter().enumerate() {
        let mut value_at = |step: f64| {
            moved[index] = at[index] + step;
            of(&moved)
        };
        let (after, before) = (value_at(STEP * weight)?, value_at(-STEP * weight)?);
        moved[index] = at[index];
        for (change, (after, before)) in changes.iter_mut().zip(after.iter().zip(before)) {
            *change += (after - before).abs() / (2.0 * STEP);
        }
    }
    Some([values, changes])
}

#[test]
fn changes_are_those_of_the_derivatives() {
    let of: Of<'_> = &|x| (x[0] > 0.0).then(|| vec![x[0] * x[1], x[1].sin()]);
    let [values, changes] = changes(of, &[2.0, 3.0], &[10.0, 0.5]).expect("it has values");
    assert_eq!(values, [6.0, 3.0_f64.sin()]);
    assert!((changes[0] - (3.0 * 10.0 + 2.0 * 0.5)).abs() < 1e-7);
    assert!((changes[1] - 0.5 * 3.0_f64.cos().abs()).abs() < 1e-7);
    assert!(super::roundings::changes(of, &[1e-6, 1.0], &[10.0, 0.5]).is_none());
}
