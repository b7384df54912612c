//! Parameters by name, for code that serves every machine.

use crate::Scalar;

/// A machine whose declaration has numeric parameters: their names, their values, and the same machine with others.
///
/// Every `mechanism!` with a `param` that is a number implements it. Modes are no numbers, and stay as they are.
///
/// ```
/// use linkage_core::{Parameters, mechanism};
///
/// mechanism! {
///     struct Crank {
///         input q: angle;
///         param length = 80mm;
///         param start = 30deg;
///         ground A(0, 0);
///         crank AB(A) -> B { length: length, angle: q + start }
///     }
/// }
///
/// /// A line for each parameter.
/// fn table<P: Parameters<Number = f64>>(machine: &P) -> String {
///     let mut lines = String::new();
///     machine.each(|name, unit, value| lines += &format!("{name} = {value} {unit}\n"));
///     lines
/// }
///
/// let crank = Crank::new();
/// assert!(table(&crank).starts_with("length = 0.08 m\nstart = 0.52"));
/// let longer = crank.with_parameter("length", 0.1).expect("it has this name");
/// assert_eq!((longer.length, longer.start), (0.1, crank.start));
/// assert!(crank.with_parameter("lenght", 0.1).is_none());
/// // The same machine on other numbers.
/// let narrow: Crank<f32> = crank.map(|value| value as f32);
/// assert_eq!(narrow.length, 0.08_f32);
/// ```
pub trait Parameters: Sized {
    /// The numbers it computes with.
    type Number: Scalar;

    /// The machine on other numbers.
    type On<U: Scalar>;

    /// The names, in the order of the declaration.
    const NAMES: &'static [&'static str];

    /// The base unit of each, separated by a space: `m`, `rad`, `kg·m²`, or `1` for a plain number.
    const UNITS: &'static str;

    /// The machine with a number made of each parameter, in the order of [`NAMES`](Self::NAMES).
    #[must_use]
    fn map<U: Scalar>(&self, number: impl FnMut(Self::Number) -> U) -> Self::On<U>;

    /// Calls a function with the name, the unit and the value of each parameter.
    fn each(&self, mut told: impl FnMut(&'static str, &'static str, Self::Number)) {
        let mut named = Self::NAMES.iter().zip(Self::UNITS.split(' '));
        let _ = self.map(|value| {
            if let Some((name, unit)) = named.next() {
                told(name, unit, value);
            }
            value
        });
    }

    /// The value of the parameter of this name; none if there is none.
    #[must_use]
    fn parameter(&self, name: &str) -> Option<Self::Number> {
        let mut found = None;
        self.each(|own, _, value| found = if own == name { Some(value) } else { found });
        found
    }

    /// The machine with another value of the parameter of this name; none if there is none.
    #[must_use]
    fn with_parameter(&self, name: &str, value: Self::Number) -> Option<Self::On<Self::Number>> {
        Self::NAMES.contains(&name).then(|| self.with_named(|own| (own == name).then_some(value)))
    }

    /// The machine with other values where the function gives one for a name.
    #[must_use]
    fn with_named(
        &self,
        mut value: impl FnMut(&'static str) -> Option<Self::Number>,
    ) -> Self::On<Self::Number> {
        let mut names = Self::NAMES.iter();
        self.map(|own| names.next().and_then(|name| value(name)).unwrap_or(own))
    }
}
