//! Where the sliders of a page begin, end and stand at first.

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use core::ops::RangeInclusive;
use std::string::{String, ToString};
use std::vec::Vec;

use super::declared::{Declared, Setting, settings};
use super::json::{list, number, object, string, strings};
use crate::sketch::SketchError;
use crate::sketch::traces::named;

/// The wishes for sliders, by name.
#[derive(Clone, Debug, Default)]
pub(super) struct Wishes {
    pub ranges: Vec<(String, RangeInclusive<f64>)>,
    pub rates: Vec<(String, f64)>,
    pub loads: Vec<(String, f64)>,
    /// The inputs of each pose that Play runs through.
    pub path: Vec<Vec<f64>>,
}

impl Wishes {
    /// The last wish of a name.
    fn of<'w, T>(wishes: &'w [(String, T)], name: &str) -> Option<&'w T> {
        wishes.iter().rev().find(|(wished, _)| wished == name).map(|(_, wish)| wish)
    }

    fn range(&self, name: &str) -> Option<[f64; 2]> {
        Self::of(&self.ranges, name).map(|range| [*range.start(), *range.end()])
    }

    /// Every name that is asked for is one of the declaration.
    pub(super) fn check(&self, declared: &Declared) -> Result<(), SketchError> {
        let names = |text| -> Vec<&'static str> {
            settings(text).iter().map(|setting| setting.name).collect()
        };
        let (inputs, loads) = (names(declared.inputs), names(declared.loads));
        let all = [inputs.clone(), names(declared.params), loads.clone()].concat();
        let ranges = self.ranges.iter().map(|(name, _)| (&all, name, "input, parameter or load"));
        let rates = self.rates.iter().map(|(name, _)| (&inputs, name, "input"));
        let wanted = self.loads.iter().map(|(name, _)| (&loads, name, "load"));
        let mut asked = ranges.chain(rates).chain(wanted);
        asked.try_for_each(|(known, name, kind)| named(known, name, kind).map(drop))
    }

    /// The inputs: an angle without a range turns fully, a length has that of the path.
    ///
    /// # Errors
    /// `NoRange` for a length of which nothing is known.
    pub(super) fn inputs(&self, declared: &Declared) -> Result<String, SketchError> {
        let input = |(nth, input): (usize, Setting)| {
            let is_angle = input.unit == "rad";
            let values = self.path.iter().filter_map(|pose| pose.get(nth).copied());
            let travelled = values.fold(None, |range: Option<[f64; 2]>, x| {
                Some(range.map_or([x, x], |[least, most]| [least.min(x), most.max(x)]))
            });
            let wished = self.range(input.name);
            let travelled = travelled.filter(|[from, to]| !is_angle && from < to);
            let [from, to] = match wished.or(travelled) {
                Some([from, to]) if from < to => [from, to],
                _ if is_angle => [0.0, TAU],
                _ => return Err(SketchError::NoRange { input: input.name }),
            };
            let first = self.path.first().and_then(|pose| pose.get(nth).copied());
            let middle = 0.5 * (from + to);
            let at = first.unwrap_or(if is_angle && wished.is_none() { 1.0 } else { middle });
            let usual = if is_angle { TAU } else { 0.25 * (to - from) };
            let rate = Self::of(&self.rates, input.name).copied().unwrap_or(usual);
            Ok(object([
                ("name", string(input.name)),
                ("docs", string(input.docs)),
                ("unit", string(input.unit)),
                ("isAngle", is_angle.to_string()),
                ("turns", (is_angle && wished.is_none()).to_string()),
                ("from", number(from)),
                ("to", number(to)),
                ("at", number(at)),
                ("rate", number(rate)),
            ]))
        };
        let inputs = settings(declared.inputs).into_iter().enumerate().map(input);
        Ok(list(inputs.collect::<Result<Vec<_>, _>>()?))
    }

    pub(super) fn params(&self, declared: &Declared, values: &[f64]) -> String {
        list(settings(declared.params).iter().zip(values).map(
            |(param, &value)| match param.modes {
                Some(words) => object([
                    ("name", string(param.name)),
                    ("docs", string(param.docs)),
                    ("value", number(value)),
                    ("words", strings(&words)),
                ]),
                None => self.slider(param, value, usual(param, value)),
            },
        ))
    }

    pub(super) fn loads(&self, declared: &Declared) -> String {
        list(settings(declared.loads).iter().map(|load| {
            let value = Self::of(&self.loads, load.name).copied().unwrap_or(0.0);
            let size = if value == 0.0 { IDLE } else { 2.0 * value.abs() };
            self.slider(load, value, [-size, size])
        }))
    }

    fn slider(&self, setting: &Setting, value: f64, usual: [f64; 2]) -> String {
        let [from, to] = self.range(setting.name).unwrap_or(usual);
        object([
            ("name", string(setting.name)),
            ("docs", string(setting.docs)),
            ("unit", string(setting.unit)),
            ("size", number(setting.size)),
            ("value", number(value)),
            ("from", number(from.min(value))),
            ("to", number(to.max(value))),
        ])
    }
}

/// A load of which nothing is known goes from minus this to this.
const IDLE: f64 = 1000.0;

/// From half to one and a half times the value; of none, a quarter turn or a hundred units either way.
fn usual(param: &Setting, value: f64) -> [f64; 2] {
    if value == 0.0 {
        let size =
            if param.unit == "deg" || param.unit == "rad" { FRAC_PI_2 } else { 100.0 * param.size };
        return [-size, size];
    }
    let ends = [0.5 * value, 1.5 * value];
    let [a, b] =
        if matches!(param.unit, "deg" | "rad") { ends.map(|x| x.clamp(-PI, PI)) } else { ends };
    [a.min(b), a.max(b)]
}
