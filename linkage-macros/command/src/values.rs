//! Values of flags, `NAME=VALUE`, written as in the language.

use std::ops::RangeInclusive;

use linkage_compiler::quantity;

use crate::output::Failure;

/// An input, a parameter or a load.
#[derive(Clone, Copy)]
pub(crate) struct Known<'a> {
    pub name: &'a str,
    /// The unit in which it is declared.
    unit: &'a str,
    is_mode: bool,
    /// An input's value in the declared drawing.
    drawn: Option<f64>,
}

impl Known<'_> {
    /// The value at which an input is drawn where nothing is said: that of the declared drawing, one radian of an
    /// angle without one.
    pub(crate) fn first(&self) -> Option<f64> {
        self.drawn.or((self.unit == "rad").then_some(1.0))
    }
}

/// The settings of a text: `PageParts` says what a line holds.
pub(crate) fn known(settings: &str) -> Vec<Known<'_>> {
    let known = |line| {
        let mut parts = str::split(line, '\t');
        let (name, unit, size) = (parts.next()?, parts.next()?, parts.next()?);
        let drawn = parts.nth(1).and_then(|drawn| drawn.parse().ok());
        Some(Known { name, unit, is_mode: size.parse::<f64>().is_err(), drawn })
    };
    settings.lines().filter_map(known).collect()
}

/// A flag that sets something, and what it is given.
#[derive(Clone, Copy)]
pub(crate) struct FlagValue<'a> {
    flag: &'a str,
    pub name: &'a str,
    text: &'a str,
}

impl<'a> FlagValue<'a> {
    /// # Errors
    /// What holds no `=`.
    pub(crate) fn read(flag: &'a str, given: &'a str) -> Result<Self, Failure> {
        let (name, text) = given.split_once('=').ok_or_else(|| {
            Failure::Unusable(format!(
                "`--{flag} {given}` sets nothing: write `--{flag} NAME=VALUE`"
            ))
        })?;
        Ok(Self { flag, name: name.trim(), text: text.trim() })
    }

    /// The place of the one that is set, by its name.
    ///
    /// # Errors
    /// A name that is none of them.
    pub(crate) fn of(self, known: &[Known<'a>], kind: &str) -> Result<usize, Failure> {
        known.iter().position(|known| known.name == self.name).ok_or_else(|| {
            let names: Vec<String> =
                known.iter().map(|known| format!("`{}`", known.name)).collect();
            let names = if names.is_empty() { "there is none".into() } else { names.join(", ") };
            Failure::Unusable(format!("no {kind} is named `{}`: {names}", self.name))
        })
    }

    fn unusable(self, why: &str) -> Failure {
        Failure::Unusable(format!("`--{} {}={}`: {why}", self.flag, self.name, self.text))
    }

    /// The value in SI units.
    pub(crate) fn value(self, known: Known<'_>) -> Result<f64, Failure> {
        self.number(self.text, &in_si(known.unit))
    }

    /// The rate of an input, in SI units.
    pub(crate) fn rate(self, input: Known<'_>) -> Result<f64, Failure> {
        self.number(self.text, &format!("{}/s", in_si(input.unit)))
    }

    /// The ends `FROM..TO`, in SI units.
    pub(crate) fn ends(self, known: Known<'_>) -> Result<RangeInclusive<f64>, Failure> {
        let ends = self.text.split_once("..").filter(|_| !known.is_mode);
        let (from, to) = ends.ok_or_else(|| self.unusable("write `FROM..TO`"))?;
        let to = to.strip_prefix('=').unwrap_or(to);
        let unit = in_si(known.unit);
        let [from, to] = [self.number(from, &unit)?, self.number(to, &unit)?];
        match from < to {
            true => Ok(from..=to),
            false => Err(self.unusable("the first end is not below the second")),
        }
    }

    /// A bare number is in SI units, as in a declaration.
    fn number(self, text: &str, unit: &str) -> Result<f64, Failure> {
        let read = quantity(text).map_err(|mistakes| self.unusable(&mistakes.join("; ")))?;
        // A radian is a number.
        let unit = unit.replacen("rad/", "1/", 1);
        if read.unit != "1" && read.unit != unit {
            let why = format!("this is in {}, and `{}` is in {unit}", read.unit, self.name);
            return Err(self.unusable(&why));
        }
        Ok(read.value)
    }
}

/// The SI unit beside a unit of the language; any other text is one already.
fn in_si(unit: &str) -> String {
    quantity(&format!("1{unit}")).map_or_else(|_| unit.to_string(), |one| one.unit)
}
