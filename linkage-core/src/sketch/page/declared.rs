//! The interface between generated code and pages: the formulas as a script, and what a reader may set.

use std::vec::Vec;

use crate::sketch::Drawn;

/// A solver that has a page; implemented by generated code.
pub trait Paged: Drawn {
    /// The declaration as a page has it.
    const PAGE: Declared;

    /// The parameters' values; of a mode +1 or −1.
    fn params(&self) -> Vec<f64>;
}

/// The declaration as a page has it: texts, since every token of generated code costs the compiler time.
#[derive(Clone, Copy, Debug)]
pub struct Declared {
    /// An object of JavaScript, the formulas among its fields.
    pub script: &'static str,
    /// The text of the declaration.
    pub text: &'static str,
    /// The inputs, a `Setting` a line.
    pub inputs: &'static str,
    /// The parameters.
    pub params: &'static str,
    /// The loads.
    pub loads: &'static str,
    /// The names that curves may be asked of, outputs and forces, a line each.
    pub outputs: &'static str,
}

impl Declared {
    /// All of it, in the order of the fields.
    #[must_use]
    pub const fn new([script, text, inputs, params, loads, outputs]: [&'static str; 6]) -> Self {
        Self { script, text, inputs, params, loads, outputs }
    }
}

/// A number or a mode that a reader may set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Setting {
    pub name: &'static str,
    /// The unit in which the declaration writes it; nothing for a mode.
    pub unit: &'static str,
    /// The unit in SI.
    pub size: f64,
    /// The words for +1 and −1.
    pub modes: Option<[&'static str; 2]>,
    pub docs: &'static str,
}

/// The settings of a text. A line holds a name, a unit, its size in SI and what the declaration says about the
/// number, with tabs between; of a mode the two words in place of unit and size.
pub(super) fn settings(text: &'static str) -> Vec<Setting> {
    text.lines().filter_map(setting).collect()
}

fn setting(line: &'static str) -> Option<Setting> {
    let mut parts = line.split('\t');
    let (name, unit, size, docs) = (parts.next()?, parts.next()?, parts.next()?, parts.next()?);
    Some(match size.parse() {
        Ok(size) => Setting { name, unit, size, modes: None, docs },
        Err(_) => Setting { name, unit: "", size: 1.0, modes: Some([unit, size]), docs },
    })
}

/// The declaration as a constant in memory.
pub(super) struct PageOf<S>(core::marker::PhantomData<S>);

impl<S: Paged> PageOf<S> {
    pub(super) const PAGE: Declared = S::PAGE;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_a_number_or_a_mode() {
        let number = Setting { name: "l", unit: "mm", size: 0.001, modes: None, docs: "The bar." };
        let mode =
            Setting { name: "m", unit: "", size: 1.0, modes: Some(["left", "right"]), docs: "" };
        assert_eq!(settings("l\tmm\t0.001\tThe bar.\nm\tleft\tright\t\n"), [number, mode]);
        assert_eq!(settings(""), []);
    }
}
