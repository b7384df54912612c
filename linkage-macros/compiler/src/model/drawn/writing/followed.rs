//! The value that an unknown is measured from, where its interval follows the drive: a fit as named numbers.

use proc_macro2::Ident;

use crate::chain::fit::{DeadEnds, Following, NearDead, Terms};

use crate::model::drawn::writing::free_names::FreeNames;
use crate::model::figures::Figure;
use crate::model::mechanism::Dimension;
use crate::model::statements::made::MadeItem;
use crate::model::statements::named::made_let;

/// The names of an unknown's fit.
pub(in crate::model::drawn) struct TracedNames {
    /// The argument of its polynomials, and the sine in front of the odd one.
    argument: Ident,
    sine: Ident,
    pub traced: Ident,
}

/// Names that nothing has.
pub(in crate::model::drawn) fn traced_names(names: &mut FreeNames, unknown: &Ident) -> TracedNames {
    let mut free = |ending: &str| names.made(format!("{unknown}_{ending}"), "_", unknown.span());
    TracedNames { argument: free("u"), sine: free("s"), traced: free("traced") }
}

/// The values in the drawing.
pub(in crate::model::drawn) struct DrawnValues {
    pub drive: f64,
    pub unknown: f64,
}

/// The fit of an unknown over the first drive.
pub(in crate::model::drawn) struct Fitted<'f> {
    pub following: &'f Following,
    /// The value of the drive.
    pub drive: Figure,
    pub drawn: DrawnValues,
    /// True if the unknown is an angle.
    pub is_angle: bool,
}

impl Fitted<'_> {
    /// The numbers of the fit, the value itself last.
    pub(in crate::model::drawn) fn numbers(&self, names: TracedNames) -> Vec<MadeItem> {
        let Self { following, drive, drawn, is_angle } = self;
        let TracedNames { argument, sine, traced } = names;
        let [from, drawn] = [drawn.drive, drawn.unknown];
        let middle = from + following.middle;
        let from_middle = || drive.plus(&Figure::float(-middle));
        let (mut lets, fit) = (Vec::new(), Figure::named(&argument));
        let mut named = |name, value, of| lets.push(made_let(name, value, of));
        let traced_value = match &following.terms {
            Terms::Turning { center, reach, even, odd, turns } => {
                let (sin, cos) = middle.sin_cos();
                let [across, along] = [drive.sin(), drive.cos()];
                let shifted =
                    |[a, b]: [f64; 2]| along.product(&number(a)).plus(&across.product(&number(b)));
                let u = Figure::named(&argument);
                let s = Figure::named(&sine);
                let value = shifted([cos / reach, sin / reach]).plus(&number(-center / reach));
                named(argument, value, Dimension::NUMBER);
                named(sine, shifted([-sin, cos]), Dimension::NUMBER);
                let mut even = even.clone();
                even[0] += drawn;
                let fit = polynomial(&even, &u).plus(&s.product(&polynomial(odd, &u)));
                let fit = with_ends(fit, following.ends, number(1.0).plus(&u), &s);
                let bends = following.near.iter().map(|near| bend(near, middle, shifted));
                let fit = Figure::whole(1).product(&bends.fold(fit, |fit, bend| fit.plus(&bend)));
                match *turns {
                    0 => fit,
                    turns => fit.plus(&from_middle().product(&number(f64::from(turns)))),
                }
            }
            Terms::Sliding { reach, powers } => {
                named(argument, from_middle().over(&Figure::float(*reach)), Dimension::NUMBER);
                let mut powers = powers.to_vec();
                powers[0] += drawn;
                let falling = number(1.0).plus(&fit.product(&fit).negated());
                let fit = with_ends(polynomial(&powers, &fit), following.ends, falling, &fit);
                Figure::whole(1).product(&fit)
            }
        };
        let of = if *is_angle { Dimension::ANGLE } else { Dimension::LENGTH };
        named(traced, traced_value, of);
        lets
    }
}

/// A square beyond a dead point, so small that its root is a hundredth of the least room of a search.
const NEXT_TO_ZERO: f64 = 1e-10;

/// A plain number to ten digits behind the point: what it decides is where a search looks, to a thousandth.
fn number(value: f64) -> Figure {
    Figure::to_ten_digits(value)
}

/// The sum of a fit and the square roots towards dead points.
fn with_ends(fit: Figure, ends: Option<DeadEnds>, falling: Figure, odd: &Figure) -> Figure {
    let Some(DeadEnds { mean, skew }) = ends else { return fit };
    let factor = number(mean).plus(&odd.product(&number(skew)));
    // Beyond a dead point it is next to zero, (x + |x|)/2: the search then finds no root, where a root of a negative
    // number would be none itself. Next to zero, a root has a slope.
    let size = falling.product(&falling).root();
    let falling = falling.plus(&size).product(&number(0.5)).plus(&number(NEXT_TO_ZERO));
    fit.plus(&falling.root().product(&factor))
}

/// The bend next to a dead point, where `shifted` is a sum of the cosine and the sine of the drive.
fn bend(near: &NearDead, middle: f64, shifted: impl Fn([f64; 2]) -> Figure) -> Figure {
    let (sin, cos) = (middle + near.at).sin_cos();
    let square = number(2.0 + near.width * near.width);
    let bend = square.plus(&shifted([-2.0 * cos, -2.0 * sin])).root();
    bend.product(&number(near.even).plus(&shifted([-near.odd * sin, near.odd * cos])))
}

/// A polynomial by Horner's rule.
fn polynomial(powers: &[f64], argument: &Figure) -> Figure {
    let [rest @ .., last] = powers else { return Figure::zero() };
    rest.iter()
        .rev()
        .fold(number(*last), |inner, &power| number(power).plus(&argument.product(&inner)))
}
