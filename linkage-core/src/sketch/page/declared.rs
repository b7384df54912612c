//! The interface between generated code and pages: the formulas as a script, and what a reader may set.

use std::vec::Vec;

use crate::sketch::Drawn;

/// A solver that has a page; implemented by generated code.
pub trait Paged: Drawn {
    /// The declaration as a page has it.
    const PAGE: Declared<'static>;

    /// The parameters' values; of a mode +1 or −1.
    fn params(&self) -> Vec<f64>;
}

/// The declaration as a page has it: texts, since every token of generated code costs the compiler time.
#[derive(Clone, Copy, Debug)]
pub struct Declared<'a> {
    /// An object of JavaScript: the names of all parts, and the statements that place them.
    pub plan: &'a str,
    /// An object of JavaScript, the formulas among its fields.
    pub script: &'a str,
    /// The text of the declaration.
    pub text: &'a str,
    /// The inputs, a `Setting` a line.
    pub inputs: &'a str,
    /// The parameters.
    pub params: &'a str,
    /// The loads.
    pub loads: &'a str,
    /// The names that curves may be asked of, outputs and forces, a line each.
    pub outputs: &'a str,
}

impl<'a> Declared<'a> {
    /// All of it, in the order of the fields.
    #[must_use]
    pub const fn new([plan, script, text, inputs, params, loads, outputs]: [&'a str; 7]) -> Self {
        Self { plan, script, text, inputs, params, loads, outputs }
    }
}

/// A number or a mode that a reader may set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Setting<'a> {
    pub name: &'a str,
    /// The unit in which the declaration writes it; nothing for a mode.
    pub unit: &'a str,
    /// The unit in SI.
    pub size: f64,
    /// The words for +1 and −1.
    pub modes: Option<[&'a str; 2]>,
    pub docs: &'a str,
    /// The value in the pose in which the mechanism is drawn.
    pub drawn: Option<f64>,
}

/// The settings of a text. A line holds a name, a unit, its size in SI and what the declaration says about the
/// number, with tabs between, and of an input of a drawing its value there; of a mode the two words in place of unit
/// and size.
pub(super) fn settings(text: &str) -> Vec<Setting<'_>> {
    text.lines().filter_map(setting).collect()
}

fn setting(line: &str) -> Option<Setting<'_>> {
    let mut parts = line.split('\t');
    let (name, unit, size, docs) = (parts.next()?, parts.next()?, parts.next()?, parts.next()?);
    let drawn = parts.next().and_then(|value| value.parse().ok());
    Some(match size.parse() {
        Ok(size) => Setting { name, unit, size, modes: None, docs, drawn },
        Err(_) => Setting { name, unit: "", size: 1.0, modes: Some([unit, size]), docs, drawn },
    })
}

/// The declaration as a constant in memory.
pub(super) struct PageOf<S>(core::marker::PhantomData<S>);

impl<S: Paged> PageOf<S> {
    pub(super) const PAGE: Declared<'static> = S::PAGE;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_a_number_or_a_mode() {
        let (docs, drawn) = ("The bar.", None);
        let number = Setting { name: "l", unit: "mm", size: 0.001, modes: None, docs, drawn };
        let modes = Some(["left", "right"]);
        let mode = Setting { name: "m", unit: "", size: 1.0, modes, docs: "", drawn };
        assert_eq!(settings("l\tmm\t0.001\tThe bar.\nm\tleft\tright\t\n"), [number, mode]);
        assert_eq!(settings("l\tmm\t0.001\tThe bar.\t-0.5\n")[0].drawn, Some(-0.5));
        assert_eq!(settings(""), []);
    }
}
