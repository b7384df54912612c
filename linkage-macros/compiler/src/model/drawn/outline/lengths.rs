//! Lengths that are declared beside a drawing in which they are others: the drawing only says which way the
//! machine assembles, and it is asked in the pose that has the lengths.

use crate::chain::redrawn::{Resized, redrawn};
use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Expr, ExprKind};
use crate::syntax::words::UNITS;

use crate::model::dimension::Dimension;
use crate::model::drawn::outline::bodies::Bodies;
use crate::model::units::unit;

/// The part of a drawn length by which a declared one may differ before it is taken for a slip.
const A_THIRD: f64 = 1.0 / 3.0;
/// The part of a length below which a difference is one of rounding.
const ROUNDING: f64 = 1e-12;

/// A bar whose declared length is not the drawn one.
struct Differing<'t> {
    bar: Resized,
    drawn: f64,
    written: &'t Expr,
}

/// Brings the machine into the pose in which bars have their declared lengths. True if it is another
/// one than the drawing; `None` if there is none beside it, which was reported.
pub(in crate::model::drawn) fn pose_has_declared_lengths(
    bodies: &mut Bodies<'_>,
    diagnostics: &mut Diagnostics,
) -> Option<bool> {
    let differing = differing(bodies);
    if differing.is_empty() {
        return Some(false);
    }
    let before = diagnostics.count();
    for Differing { bar, drawn, written } in &differing {
        if (bar.length - drawn).abs() > A_THIRD * drawn {
            let (metres, [drawn, declared]) = (*drawn, [*drawn, bar.length].map(in_words));
            let link = bodies.name(bar.body);
            let meant = unit_that_is_meant(written, metres);
            let doubt = if meant.is_some() { ": a unit?" } else { "" };
            let message = format!("{link} is drawn {drawn} long and declared {declared}{doubt}");
            let meant = meant.map_or(String::new(), |meant| format!("write `{meant}`, or "));
            let reason = format!(
                "{meant}draw it about as long as it is; the pose says which way the machine assembles"
            );
            diagnostics.error_because(written.span, message, reason);
        }
    }
    if diagnostics.count() != before {
        return None;
    }
    let bars: Vec<_> = differing.iter().map(|differing| differing.bar).collect();
    let Some(pose) = redrawn(&bodies.machine, &bars) else {
        let Differing { bar, drawn, written } = &differing[0];
        let [drawn, declared] = [*drawn, bar.length].map(in_words);
        let link = bodies.name(bar.body);
        let message = format!(
            "no pose beside the drawing has {link} {declared} long; it is drawn {drawn} long"
        );
        let reason = "the machine comes to a limit in between: draw a pose with this length";
        diagnostics.error_because(written.span, message, reason);
        return None;
    };
    bodies.machine = pose.machine;
    bodies.displacements = pose.displacements;
    Some(true)
}

/// The number with the unit by which it is about as long as drawn, where there is one.
fn unit_that_is_meant(written: &Expr, drawn: f64) -> Option<String> {
    let ExprKind::Number { digits, .. } = &written.kind else { return None };
    let number: f64 = digits.parse().ok()?;
    let units = UNITS.into_iter().filter_map(|name| Some((name, unit(name)?)));
    let mut lengths = units.filter(|(_, (dimension, _))| *dimension == Dimension::LENGTH);
    let name = lengths.find_map(|(name, (_, metres))| {
        let off = number * metres.to_f64() - drawn;
        (off.abs() <= A_THIRD * drawn).then_some(name)
    })?;
    Some(format!("{digits}{name}"))
}

fn differing<'t>(bodies: &Bodies<'t>) -> Vec<Differing<'t>> {
    let links = bodies.links.iter().enumerate();
    let differing = links.filter_map(|(index, link)| {
        let (written, Some(declared)) = link.length.as_ref()? else { return None };
        let pins: [usize; 2] = link.pins[..].try_into().ok()?;
        let [from, to] = pins.map(|pin| bodies.machine.pins[pin]);
        let (drawn, length) = ((to - from).length(), declared.value);
        let bar = Resized { body: index + 1, pins, length };
        ((length - drawn).abs() > ROUNDING * drawn).then_some(Differing { bar, drawn, written })
    });
    differing.collect()
}

/// A number to four digits.
pub(in crate::model::drawn) fn to_four_digits(value: f64) -> String {
    let digits = (3.0 - value.abs().max(1e-9).log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{value:.digits$}")
}

/// A length to four digits.
pub(in crate::model::drawn) fn in_words(metres: f64) -> String {
    let (value, unit) = if metres.abs() < 1.0 { (metres * 1e3, "mm") } else { (metres, "m") };
    let text = to_four_digits(value);
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    format!("{text} {unit}")
}
