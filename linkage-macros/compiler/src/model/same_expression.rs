//! Expressions that are the same as they are written, and lengths made of coordinates.

use crate::function::Function;

use super::mechanism::{Mechanism, Operator, Scalar};

/// The expression without its name, where it has one of its own.
fn unnamed<'a>(mechanism: &'a Mechanism, mut expr: &'a Scalar) -> &'a Scalar {
    loop {
        expr = match expr {
            Scalar::Let(id) => match &mechanism.lets[id.index()] {
                named if named.links.is_empty() => &named.rest,
                _ => return expr,
            },
            _ => return expr,
        }
    }
}

/// True if both are one expression of one set of operands. A name stands for what it names.
pub(super) fn is_same(mechanism: &Mechanism, a: &Scalar, b: &Scalar) -> bool {
    let same = |a: &Scalar, b: &Scalar| is_same(mechanism, a, b);
    match (unnamed(mechanism, a), unnamed(mechanism, b)) {
        (Scalar::Constant(a), Scalar::Constant(b)) => a.cmp_value(b).is_eq(),
        (Scalar::Input(a), Scalar::Input(b)) => a == b,
        (Scalar::Param(a), Scalar::Param(b)) => a == b,
        (Scalar::Unknown(a), Scalar::Unknown(b)) => a == b,
        (Scalar::Tracked(a, i), Scalar::Tracked(b, j)) => (a, i) == (b, j),
        (Scalar::Let(a), Scalar::Let(b)) => a == b,
        (Scalar::Slide(a), Scalar::Slide(b)) => a == b,
        (Scalar::Coordinate(a, x), Scalar::Coordinate(b, y)) => (a, x) == (b, y),
        (Scalar::Distance([a, b]), Scalar::Distance([c, d])) => [(a, b), (b, a)].contains(&(c, d)),
        (Scalar::Offset(a, x), Scalar::Offset(b, y)) => (a, x) == (b, y),
        (Scalar::Negate(a), Scalar::Negate(b)) => same(a, b),
        (Scalar::AboveZero(a), Scalar::AboveZero(b)) => {
            a.function == b.function && same(&a.value, &b.value)
        }
        (Scalar::Chain(a, rest), Scalar::Chain(b, other)) => {
            let mut pairs = rest.iter().zip(other);
            same(a, b)
                && rest.len() == other.len()
                && pairs.all(|((sign, a), (other, b))| sign == other && same(a, b))
        }
        (Scalar::Call(f, a), Scalar::Call(g, b)) => {
            f == g && a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b))
        }
        _ => false,
    }
}

/// a − b, zero where they are one expression; `None` where no expression says it.
pub(super) fn difference(mechanism: &Mechanism, a: Scalar, b: Scalar) -> Option<Scalar> {
    match is_same(mechanism, &a, &b) {
        true => Some(Scalar::zero()),
        false => a.combined(Operator::Sub, b),
    }
}

/// The length of a vector, without a root where it lies along an axis. Of an expression that is not positive no length
/// is a bar's.
pub(super) fn hypotenuse(x: Scalar, y: Scalar) -> Option<Scalar> {
    let along = |value: Scalar| match value {
        Scalar::Negate(value) => *value,
        other => other,
    };
    if y.is_zero() {
        return Some(along(x));
    }
    if x.is_zero() {
        return Some(along(y));
    }
    Scalar::call(Function::Hypot, vec![x, y])
}
