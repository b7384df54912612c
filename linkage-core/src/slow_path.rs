//! The slow path of an entry point: what is given, the conditions of the formulas, and what comes
//! out, asked in this order.

use core::hint::black_box;

use crate::checks::{Behind, FirstError, has_no_pose};
use crate::diagnosis::{finite_input, finite_result};
use crate::{Real, Record, SolveError};

/// The slow path of an entry point that returns a record: what is `given` must be finite, then every
/// condition of the formulas be met, then each number of the result be finite.
///
/// # Errors
/// The first that is not so.
// On a desktop a refusal made in place takes half of the time. On a microcontroller the registers that it needs would
// cost every answer instructions: a motion of the shear 40 of 236.
#[cfg_attr(target_pointer_width = "64", inline(always))]
#[cfg_attr(not(target_pointer_width = "64"), cold)]
pub fn diagnose<T: Real, R: Record<Number = T> + Copy>(
    given: &[(T, &'static str)],
    formulas: impl FnOnce(&mut FirstError) -> R,
) -> Result<R, SolveError> {
    let result = conditions_met(given, formulas)?;
    record_is_finite(R::LABELS, result.into_array().as_ref(), given)?;
    Ok(result)
}

/// The same where some numbers are known though a group has no pose: all that do not stand behind it. The others
/// are NaN.
///
/// A NaN counts as one behind such a group only where it is a number with another one in the place of what the group
/// lacks. Where it is not, and where nothing is known, the group is the answer.
///
/// # Errors
/// See [`diagnose`].
#[inline(always)]
pub fn diagnose_in_part<T: Real, R: Record<Number = T> + Copy>(
    given: &[(T, &'static str)],
    formulas: impl FnOnce(&mut FirstError) -> R,
    behind: impl Fn(&mut Behind) -> R,
) -> Result<R, SolveError> {
    let refusal = match diagnose(given, formulas) {
        Err(refusal) if has_no_pose(refusal) => refusal,
        answer => return answer,
    };
    let (mut unknown, mut invented) = (Behind::unknown(), Behind::invented());
    let (mut told, possible) =
        (behind(&mut unknown).into_array(), behind(&mut invented).into_array());
    let mut is_any_known = false;
    for (number, possible) in told.as_mut().iter_mut().zip(possible.as_ref()) {
        if number.is_finite() {
            is_any_known = true;
        } else if number.value().is_nan() && possible.is_finite() {
            *number = T::lit(f64::NAN, f32::NAN);
        } else {
            return Err(refusal);
        }
    }
    if is_any_known && !unknown.is_open() { Ok(R::from_array(told)) } else { Err(refusal) }
}

/// The same of one that returns anything else: `results` says which of its numbers are asked.
///
/// # Errors
/// See [`diagnose`].
#[inline(always)]
pub fn diagnose_all<T: Real, R: Copy, const N: usize>(
    given: &[(T, &'static str)],
    formulas: impl FnOnce(&mut FirstError) -> R,
    results: impl FnOnce(R) -> [(T, &'static str); N],
) -> Result<R, SolveError> {
    let result = conditions_met(given, formulas)?;
    results_are_finite(&results(result), given)?;
    Ok(result)
}

/// Hides the slow path's numbers from the optimiser one by one, from the `first` on.
///
/// The result lies in memory, side by side, and where it and the fast path's meet, LLVM brings the
/// latter together likewise: the number that is known first waits for its neighbour, and both move
/// between the halves of registers. Hidden, each of them has a place of its own. It costs the slow path
/// a store and a load of each, and nothing where there are no registers for several numbers.
#[inline(always)]
pub fn apart<R: Record<Number: Copy>>(
    found: Result<R, SolveError>,
    first: usize,
) -> Result<R, SolveError> {
    const HAS_VECTORS: bool = cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));
    match found {
        // A closure is not inlined everywhere, and then hides nothing.
        Ok(record) if HAS_VECTORS => {
            let mut numbers = record.into_array();
            for number in numbers.as_mut().iter_mut().skip(first) {
                *number = black_box(*number);
            }
            Ok(R::from_array(numbers))
        }
        _ => found,
    }
}

#[inline(always)]
pub(crate) fn conditions_met<T: Real, R>(
    given: &[(T, &'static str)],
    formulas: impl FnOnce(&mut FirstError) -> R,
) -> Result<R, SolveError> {
    inputs_are_finite(given)?;
    let mut first = FirstError::new();
    let result = formulas(&mut first);
    first.first()?;
    Ok(result)
}

// Without optimisation one of each serves all entry points of a type of numbers.

#[cfg_attr(debug_assertions, inline(never))]
#[cfg_attr(not(debug_assertions), inline(always))]
fn inputs_are_finite<T: Real>(given: &[(T, &'static str)]) -> Result<(), SolveError> {
    given.iter().try_for_each(|&(value, name)| finite_input(value, name))
}

#[cfg_attr(debug_assertions, inline(never))]
#[cfg_attr(not(debug_assertions), inline(always))]
fn results_are_finite<T: Real>(
    results: &[(T, &'static str)],
    given: &[(T, &'static str)],
) -> Result<(), SolveError> {
    results.iter().try_for_each(|&(value, name)| finite_result(value, name, given))
}

#[cfg_attr(debug_assertions, inline(never))]
#[cfg_attr(not(debug_assertions), inline(always))]
fn record_is_finite<T: Real>(
    names: &[&'static str],
    numbers: &[T],
    given: &[(T, &'static str)],
) -> Result<(), SolveError> {
    let mut numbers = names.iter().zip(numbers);
    numbers.try_for_each(|(name, &value)| finite_result(value, name, given))
}
