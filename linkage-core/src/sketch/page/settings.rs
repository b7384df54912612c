//! Where the sliders of a page begin, end and stand at first.

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use core::ops::RangeInclusive;
use std::string::{String, ToString};
use std::vec::Vec;

use super::declared::{Declared, Setting, settings};
use super::json::{list, number, object, string, strings};
use crate::sketch::SketchError;
use crate::sketch::traces::named;

/// The wishes for a page.
#[derive(Clone, Debug, Default)]
pub struct Wishes {
    /// A heading in place of the mechanism's name.
    pub title: Option<String>,
    /// The points whose paths are drawn.
    pub traces: Vec<String>,
    /// The outputs and forces whose curves are offered.
    pub curves: Vec<String>,
    /// The ends of sliders, by name.
    pub ranges: Vec<(String, RangeInclusive<f64>)>,
    /// The rates of inputs, by name.
    pub rates: Vec<(String, f64)>,
    /// The values of loads, by name.
    pub loads: Vec<(String, f64)>,
    /// The inputs of each pose that Play runs through.
    pub path: Vec<Vec<f64>>,
    /// The parameters whose curves are kept at first; none keeps none.
    pub before: Vec<f64>,
    /// Places that are marked in the picture, in metres.
    pub points: Vec<[f64; 2]>,
    /// Pairs of the first input and the wanted value of an output, in SI units, by the output's name.
    pub wanted: Vec<(String, Vec<[f64; 2]>)>,
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
    pub(super) fn check(&self, declared: &Declared<'_>) -> Result<(), SketchError> {
        fn names(text: &str) -> Vec<&str> {
            settings(text).iter().map(|setting| setting.name).collect()
        }
        let outputs: Vec<&str> = declared.outputs.lines().collect();
        let wanted = self.wanted.iter().map(|(name, _)| name);
        let mut asked = self.curves.iter().chain(wanted);
        asked.try_for_each(|name| named(&outputs, name, "output").map(drop))?;
        let (inputs, loads) = (names(declared.inputs), names(declared.loads));
        let all = [inputs.clone(), names(declared.params), loads.clone()].concat();
        let ranges = self.ranges.iter().map(|(name, _)| (&all, name, "input, parameter or load"));
        let rates = self.rates.iter().map(|(name, _)| (&inputs, name, "input"));
        let wanted = self.loads.iter().map(|(name, _)| (&loads, name, "load"));
        let mut asked = ranges.chain(rates).chain(wanted);
        asked.try_for_each(|(known, name, kind)| named(known, name, kind).map(drop))
    }

    /// What each of these declarations, which are driven by sets of inputs of one machine, is wished. A path is the
    /// first one's.
    pub(super) fn of_each(&self, sets: &[Declared<'_>]) -> Result<Vec<Self>, SketchError> {
        let single = self.each();
        for wish in &single {
            let refusals = sets.iter().map(|set| wish.check(set));
            refusals.reduce(Result::or).unwrap_or(Ok(()))?;
        }
        let of_set = |(nth, set): (usize, &Declared<'_>)| {
            let known = single.iter().filter(|wish| wish.check(set).is_ok());
            let path = if nth == 0 { self.path.clone() } else { Vec::new() };
            let begun = Self {
                title: self.title.clone(),
                traces: self.traces.clone(),
                path,
                before: if nth == 0 { self.before.clone() } else { Vec::new() },
                points: self.points.clone(),
                ..Self::default()
            };
            known.fold(begun, |mut all, wish| {
                all.curves.extend_from_slice(&wish.curves);
                all.wanted.extend_from_slice(&wish.wanted);
                all.ranges.extend_from_slice(&wish.ranges);
                all.rates.extend_from_slice(&wish.rates);
                all.loads.extend_from_slice(&wish.loads);
                all
            })
        };
        Ok(sets.iter().enumerate().map(of_set).collect())
    }

    /// Those that name something of the declaration, one by one.
    fn each(&self) -> Vec<Self> {
        let curves = self
            .curves
            .iter()
            .map(|name| Self { curves: [name.clone()].into(), ..Self::default() });
        let ranges = self
            .ranges
            .iter()
            .map(|wish| Self { ranges: [wish.clone()].into(), ..Self::default() });
        let rates =
            self.rates.iter().map(|wish| Self { rates: [wish.clone()].into(), ..Self::default() });
        let loads =
            self.loads.iter().map(|wish| Self { loads: [wish.clone()].into(), ..Self::default() });
        let wanted = self
            .wanted
            .iter()
            .map(|wish| Self { wanted: [wish.clone()].into(), ..Self::default() });
        curves.chain(ranges).chain(rates).chain(loads).chain(wanted).collect()
    }

    /// The inputs: an angle without a range turns fully, a length has that of the path, and one without any is
    /// found by the page. They begin at the path, or in the pose in which the mechanism is drawn.
    pub(super) fn inputs(&self, declared: &Declared<'_>) -> String {
        list(settings(declared.inputs).into_iter().enumerate().map(|(nth, input)| {
            let is_angle = input.unit == "rad";
            let values = self.path.iter().filter_map(|pose| pose.get(nth).copied());
            let travelled = values.fold(None, |range: Option<[f64; 2]>, x| {
                Some(range.map_or([x, x], |[least, most]| [least.min(x), most.max(x)]))
            });
            let wished = self.range(input.name).filter(|[from, to]| from < to);
            let travelled = travelled.filter(|[from, to]| !is_angle && from < to);
            let ends = wished.or(travelled).or(is_angle.then_some([0.0, TAU]));
            let first = self.path.first().and_then(|pose| pose.get(nth).copied());
            let within =
                |x: &f64| ends.is_none_or(|[from, to]| wished.is_none() || (from..=to).contains(x));
            let middle = match ends {
                Some(_) if is_angle && wished.is_none() => 1.0,
                Some([from, to]) => 0.5 * (from + to),
                None => f64::NAN,
            };
            let at = first.or(input.drawn.filter(within)).unwrap_or(middle);
            let usual = match ends {
                _ if is_angle => TAU,
                Some([from, to]) => 0.25 * (to - from),
                None => f64::NAN,
            };
            let rate = Self::of(&self.rates, input.name).copied().unwrap_or(usual);
            let [from, to] = ends.unwrap_or([f64::NAN; 2]);
            object([
                ("name", string(input.name)),
                ("docs", string(input.docs)),
                ("unit", string(input.unit)),
                ("isAngle", is_angle.to_string()),
                ("turns", (is_angle && wished.is_none()).to_string()),
                ("from", number(from)),
                ("to", number(to)),
                ("at", number(at)),
                ("rate", number(rate)),
            ])
        }))
    }

    pub(super) fn params(&self, declared: &Declared<'_>, values: &[f64]) -> String {
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

    pub(super) fn loads(&self, declared: &Declared<'_>) -> String {
        list(settings(declared.loads).iter().map(|load| {
            let value = Self::of(&self.loads, load.name).copied().unwrap_or(0.0);
            let size = if value == 0.0 { IDLE } else { 2.0 * value.abs() };
            self.slider(load, value, [-size, size])
        }))
    }

    fn slider(&self, setting: &Setting<'_>, value: f64, usual: [f64; 2]) -> String {
        let [from, to] = self.range(setting.name).unwrap_or(usual);
        object([
            ("name", string(setting.name)),
            ("docs", string(setting.docs)),
            ("unit", string(setting.unit)),
            ("size", number(setting.size)),
            ("value", number(value)),
            // The least of a number and none is the number.
            ("from", number(if from.is_nan() { from } else { from.min(value) })),
            ("to", number(if to.is_nan() { to } else { to.max(value) })),
        ])
    }
}

/// A load of which nothing is known goes from minus this to this.
const IDLE: f64 = 1000.0;

/// From half to one and a half times the value. Of none, a quarter turn either way; how far another number goes from
/// zero is found by the page, from the machine's size.
fn usual(param: &Setting<'_>, value: f64) -> [f64; 2] {
    let is_angle = matches!(param.unit, "deg" | "rad");
    if value == 0.0 {
        return if is_angle { [-FRAC_PI_2, FRAC_PI_2] } else { [f64::NAN; 2] };
    }
    let ends = [0.5 * value, 1.5 * value];
    let [a, b] = if is_angle { ends.map(|x| x.clamp(-PI, PI)) } else { ends };
    [a.min(b), a.max(b)]
}
