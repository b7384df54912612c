//! Values that stand outside a declaration and are written as in one.

use crate::diagnostics::Diagnostic;
use crate::exact::AtomScope;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::model;

/// A value that is written as in a declaration: `90mm`, `-30deg`, `2 * pi`, `12(rad/s)`.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct WrittenValue {
    /// The value in SI units.
    pub value: f64,
    /// The SI unit, such as `rad/s`; `1` for a number without one.
    pub unit: String,
}

/// Reads a value that is written as in a declaration.
///
/// # Errors
/// The reasons why it is none.
///
/// ```
/// let length = linkage_compiler::quantity("2 * 45mm").expect("it is one");
/// assert_eq!((length.value, &length.unit[..]), (0.09, "m"));
/// assert!(linkage_compiler::quantity("90 mm mm").is_err());
/// ```
pub fn quantity(text: &str) -> Result<WrittenValue, Vec<String>> {
    let _atoms = AtomScope::begin();
    match model::written_value(text) {
        Ok((value, dimension)) => {
            Ok(WrittenValue { value: value.to_f64(), unit: unit(dimension, Order::Position) })
        }
        Err(mistakes) if mistakes.is_empty() => Err(vec![format!("`{text}` is no value")]),
        Err(mistakes) => Err(mistakes.iter().map(Diagnostic::text).collect()),
    }
}
