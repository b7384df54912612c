//! `{:?}` of generated records.
//!
//! A derived `Debug` is a function for every record that names each field again; here it is a call
//! with a text, which costs a compiler a fraction of that.

use core::fmt::{self, Debug, Formatter};

use crate::Record;

/// Shows a record as a derived `Debug` would. The `shape` is that text, on one line, with a `#` for
/// each number: `CrankPosition { AB: Direction { cos: #, sin: # }, B: Point { x: #, y: # } }`.
///
/// # Errors
/// Those of what is written to.
pub fn debug<R: Record + Copy>(record: &R, shape: &str, f: &mut Formatter<'_>) -> fmt::Result
where
    R::Number: Debug,
{
    Part { shape, numbers: record.into_array().as_ref() }.fmt(f)
}

/// A record, a list or a number, with the numbers from its first on.
struct Part<'a, T> {
    shape: &'a str,
    numbers: &'a [T],
}

impl<T: Debug> Debug for Part<'_, T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { shape, numbers } = *self;
        if let Some((name, fields)) = enclosed(shape, " { ", " }") {
            let mut record = f.debug_struct(name);
            for Part { shape, numbers } in (Parts { shapes: fields, numbers }) {
                let (field, shape) = shape.split_once(": ").unwrap_or_default();
                record.field(field, &Part { shape, numbers });
            }
            return record.finish();
        }
        if let Some((_, items)) = enclosed(shape, "[", "]") {
            return f.debug_list().entries(Parts { shapes: items, numbers }).finish();
        }
        numbers.first().map_or(Ok(()), |number| number.fmt(f))
    }
}

/// What stands before a bracket, and what in it.
fn enclosed<'a>(shape: &'a str, open: &str, close: &str) -> Option<(&'a str, &'a str)> {
    shape.strip_suffix(close)?.split_once(open)
}

/// The parts of a record or list, one after the other.
struct Parts<'a, T> {
    shapes: &'a str,
    numbers: &'a [T],
}

impl<'a, T> Iterator for Parts<'a, T> {
    type Item = Part<'a, T>;

    fn next(&mut self) -> Option<Part<'a, T>> {
        if self.shapes.is_empty() {
            return None;
        }
        let mut depth = 0_i32;
        let is_end = |sign| {
            match sign {
                '{' | '[' => depth = depth.saturating_add(1),
                '}' | ']' => depth = depth.saturating_sub(1),
                _ => {}
            }
            sign == ',' && depth == 0
        };
        let end = self.shapes.find(is_end).unwrap_or(self.shapes.len());
        let (shape, rest) = self.shapes.split_at_checked(end)?;
        let part = Part { shape, numbers: self.numbers };
        self.shapes = rest.strip_prefix(", ").unwrap_or_default();
        self.numbers = self.numbers.get(shape.matches('#').count()..).unwrap_or_default();
        Some(part)
    }
}

#[cfg(test)]
mod tests {
    use std::format;

    use super::*;
    use crate::{Direction, Point};

    #[derive(Clone, Copy, Debug)]
    struct Lift<T> {
        _é: Point<T>,
        list: [[T; 2]; 2],
        inner: Inner<T>,
        _empty: [T; 0],
        last: T,
    }

    #[derive(Clone, Copy, Debug)]
    struct Inner<T> {
        x: T,
        ab: Direction<T>,
    }

    const SHAPE: &str = "Lift { _é: Point { x: #, y: # }, list: [[#, #], [#, #]], inner: Inner { x: #, ab: \
         Direction { cos: #, sin: # } }, _empty: [], last: # }";

    #[test]
    fn a_record_is_shown_as_a_derived_debug_shows_it() {
        let record = Lift {
            _é: Point { x: 1.0, y: -0.0 },
            list: [[f64::NAN, 1e300], [f64::INFINITY, 0.1]],
            inner: Inner { x: 2.0, ab: Direction { cos: 1e-7, sin: 0.25 } },
            _empty: [],
            last: 1.0 / 3.0,
        };
        let [[a, b], [c, d]] = record.list;
        let Inner { x, ab } = record.inner;
        let numbers = [1.0, -0.0, a, b, c, d, x, ab.cos, ab.sin, record.last];
        let shown = Part { shape: SHAPE, numbers: &numbers };
        assert_eq!(format!("{shown:?}"), format!("{record:?}"));
        assert_eq!(format!("{shown:#?}"), format!("{record:#?}"));
        assert_eq!(format!("{shown:+9.3?}"), format!("{record:+9.3?}"));
        assert_eq!(format!("{:?}", Part { shape: "#", numbers: &[0.5] }), "0.5");
    }
}
