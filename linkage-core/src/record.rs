//! Inputs and results as arrays of numbers.

use core::mem::{self, ManuallyDrop};

use crate::{Direction, Point, Scalar};

/// A record of numbers that can be taken as an array: a position, a velocity, an acceleration, a
/// motion, margins, or several inputs.
///
/// The records of a solver are structs with a field for each output. Code that serves every
/// mechanism, such as a table, a plot or an interpolation, takes their numbers one after the
/// other instead.
///
/// ```
/// use linkage_core::{Record, mechanism};
///
/// mechanism! {
///     struct Crank { input q: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: q } }
/// }
///
/// fn table<R: Record>(record: R) -> Vec<(&'static str, R::Number)> {
///     R::LABELS.iter().copied().zip(record.into_array()).collect()
/// }
///
/// let velocity = Crank::new().velocity(0.0, 2.0)?;
/// let expected = [("AB.omega", 2.0), ("velocity of B.x", 0.0), ("velocity of B.y", 2.0)];
/// assert_eq!(table(velocity), expected);
/// # Ok::<(), linkage_core::SolveError>(())
/// ```
pub trait Record: Sized {
    /// The type of the record's numbers.
    type Number;

    /// `[Number; N]`, in the order of the record's fields and their components.
    type Array: AsRef<[Self::Number]> + AsMut<[Self::Number]> + IntoIterator<Item = Self::Number>;

    /// The name of each number in errors: `C.x`, `velocity of C.x`, `DC.omega`. A direction holds two
    /// numbers, cosine and sine, under the label of its angle.
    const LABELS: &'static [&'static str];

    /// The numbers of the record.
    #[must_use]
    fn into_array(self) -> Self::Array;

    /// The record of the numbers.
    #[must_use]
    fn from_array(array: Self::Array) -> Self;

    /// The points of the record and their names; for velocities and accelerations, those of the points. For
    /// forces, the reactions in ground axes, by their paths.
    ///
    /// ```
    /// # use linkage_core::{Record, mechanism};
    /// # mechanism! {
    /// #     struct Crank { input q: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: q } }
    /// # }
    /// let p = Crank::new().position(0.0)?;
    /// assert!(p.points().eq([("B", p.B)]));
    /// assert!(p.links().eq([("AB", p.AB)]));
    /// # Ok::<(), linkage_core::SolveError>(())
    /// ```
    fn points(self) -> impl Iterator<Item = (&'static str, Point<Self::Number>)>
    where
        Self::Number: Copy,
    {
        pairs(self).filter_map(|([x_label, y_label], [x, y])| {
            let name = x_label.strip_suffix(".x")?;
            (y_label.strip_suffix(".y") == Some(name)).then_some((plain(name), Point { x, y }))
        })
    }

    /// The directions of the links of a position, and their names. A link that slides is among
    /// them, without its slide.
    fn links(self) -> impl Iterator<Item = (&'static str, Direction<Self::Number>)>
    where
        Self::Number: Copy,
    {
        pairs(self).filter_map(|(labels, [cos, sin])| {
            let name = labels[0].strip_suffix(".angle")?;
            (labels[0] == labels[1]).then_some((plain(name), Direction { cos, sin }))
        })
    }
}

/// Every two numbers that follow each other, and their labels.
fn pairs<R: Record>(record: R) -> impl Iterator<Item = ([&'static str; 2], [R::Number; 2])>
where
    R::Number: Copy,
{
    let numbers = record.into_array();
    (1..R::LABELS.len()).filter_map(move |second| {
        let labels = [*R::LABELS.get(second - 1)?, *R::LABELS.get(second)?];
        let numbers = numbers.as_ref();
        Some((labels, [*numbers.get(second - 1)?, *numbers.get(second)?]))
    })
}

/// The rows of a matrix of one column.
#[inline(always)]
pub fn column<T, const N: usize>(rows: [T; N]) -> [[T; 1]; N] {
    rows.map(|row| [row])
}

/// Three lists as one.
#[inline(always)]
pub fn joined<T, const A: usize, const B: usize, const C: usize, const N: usize>(
    a: [T; A],
    b: [T; B],
    c: [T; C],
) -> [T; N] {
    /// One behind the other, without a gap: all are aligned alike.
    #[repr(C)]
    struct Three<T, const A: usize, const B: usize, const C: usize>([T; A], [T; B], [T; C]);
    const { assert!(A + B + C == N) };
    let three = ManuallyDrop::new(Three(a, b, c));
    #[allow(unsafe_code, reason = "no safe function joins arrays, and loops stay in memory")]
    // SAFETY: what is read are the N numbers that `three` holds, which nobody else drops.
    unsafe {
        mem::transmute_copy(&three)
    }
}

/// A name without what it is a rate of: `blade` of `velocity of blade`.
fn plain(name: &'static str) -> &'static str {
    name.rsplit(' ').next().unwrap_or(name)
}

/// A single input is a record of one number.
impl<T: Scalar> Record for T {
    type Number = T;
    type Array = [T; 1];

    const LABELS: &'static [&'static str] = &[""];

    #[inline(always)]
    fn into_array(self) -> [T; 1] {
        [self]
    }

    #[inline]
    fn from_array([number]: [T; 1]) -> T {
        number
    }
}

/// Several numbers that have no names.
impl<T: Scalar, const N: usize> Record for [T; N] {
    type Number = T;
    type Array = [T; N];

    const LABELS: &'static [&'static str] = &[""; N];

    #[inline(always)]
    fn into_array(self) -> [T; N] {
        self
    }

    #[inline]
    fn from_array(array: [T; N]) -> Self {
        array
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::rc::Rc;

    #[test]
    fn lists_are_joined_in_order_and_every_part_lives_once() {
        let parts: [Rc<u8>; 6] = core::array::from_fn(|part| Rc::new(part as u8));
        let [a, b, c, d, e, f] = parts.clone();
        let all: [Rc<u8>; 6] = joined([a], [b, c], [d, e, f]);
        assert_eq!(all, parts);
        assert!(all.iter().all(|part| Rc::strong_count(part) == 2));
        drop(all);
        assert!(parts.iter().all(|part| Rc::strong_count(part) == 1));
        // Lists of none, and elements with a gap in them.
        assert_eq!(joined::<u8, 0, 2, 1, 3>([], [1, 2], [3]), [1, 2, 3]);
        assert_eq!(joined::<(u8, u32), 1, 1, 0, 2>([(1, 2)], [(3, 4)], []), [(1, 2), (3, 4)]);
    }
}
