//! The questions of a report: entry points, ranges, rates and numbers, from texts that are written as in the language.

use syn::ext::IdentExt;

use super::ReportOptions;
use crate::diagnostics::{Diagnostics, nearest};
use crate::exact::Exact;
use crate::function::HOOKED_SINE;
use crate::interface::EntryId;
use crate::interface::entries::{Analysis, Topic};
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::lower::routine::Lowered;
use crate::model;
use crate::model::mechanism::{Dimension, Mechanism, ParamKind, Sign};
use crate::prove::outward::OutwardInterval;
use crate::prove::premises::{Hooks, Leaf, Premises};
use crate::prove::sloped::INPUTS;

/// See the module's documentation.
pub(crate) struct Asked {
    pub entries: Vec<EntryId>,
    /// The name and the unit of each range.
    pub ranges: Vec<(String, String)>,
    /// Values of inputs, without rates; parameters, loads and drives.
    pub given: Premises,
    /// The rates; none where bounds are multiples of these.
    pub rates: Option<Vec<f64>>,
    /// Values that are not at their default, in words.
    pub words: Vec<String>,
    /// The largest error that is wished for, and its unit.
    pub within: Option<(f64, String)>,
}

/// Reads what is asked; what is a mistake is reported.
struct RequestReader<'a> {
    mechanism: &'a Mechanism,
    diagnostics: &'a mut Diagnostics,
    ranges: Vec<(String, String)>,
    ends: Vec<[f64; 2]>,
    words: Vec<String>,
    options: &'a ReportOptions,
}

/// Angles beyond are not followed, in rad: thousands of turns, where neighbouring `f32` are a degree apart.
const LARGEST_ANGLE: f64 = 50_000.0;

/// The largest error of a target's own square root, in last places.
const MOST_LAST_PLACES: f64 = 4.0;

impl Asked {
    pub(super) fn of(
        mechanism: &Mechanism,
        lowered: &Lowered<'_>,
        options: &ReportOptions,
        diagnostics: &mut Diagnostics,
    ) -> Option<Self> {
        let mut reader = RequestReader {
            mechanism,
            diagnostics,
            ranges: Vec::new(),
            ends: Vec::new(),
            words: Vec::new(),
            options,
        };
        reader.names_exist()?;
        let entries = reader.entries(lowered)?;
        let inputs = mechanism.inputs.iter().map(|input| {
            let name = input.name.unraw().to_string();
            Some([reader.input(&name, input.dimension)?, Leaf::ZERO, Leaf::ZERO])
        });
        let inputs: Vec<_> = inputs.collect::<Option<_>>()?;
        let params = mechanism.params.iter().map(|param| match &param.kind {
            ParamKind::Number { dimension, default, .. } => {
                reader.param(&param.name.unraw().to_string(), *dimension, default)
            }
            ParamKind::Mode { default, .. } => {
                Some(Leaf::number(if *default == Sign::Plus { 1.0 } else { -1.0 }))
            }
        });
        let params: Vec<_> = params.collect::<Option<_>>()?;
        let loads = mechanism
            .dynamics
            .loads
            .iter()
            .map(|load| reader.number(&load.name.unraw().to_string(), load.dimension, 0.0));
        let loads: Vec<_> = loads.collect::<Option<_>>()?;
        let rates = reader.rates()?;
        let drives = vec![Leaf::ZERO; mechanism.inputs.len()];
        reader.ranges_are_few()?;
        let within = reader.within()?;
        let hooks = reader.hooks()?;
        let RequestReader { ranges, ends, words, .. } = reader;
        let scales_with_rates = rates.is_none();
        let given =
            Premises { ranges: ends, inputs, params, loads, drives, hooks, scales_with_rates };
        Some(Self { entries, ranges, given, rates, words, within })
    }

    /// The premises with these rates and accelerations of all inputs.
    pub(super) fn at_rates(
        &self,
        rates: &[OutwardInterval],
        seconds: &[OutwardInterval],
        scales: bool,
    ) -> Premises {
        let mut given = Premises { scales_with_rates: scales, ..self.given.clone() };
        for (input, leaves) in given.inputs.iter_mut().enumerate() {
            leaves[1] = Leaf::Within(rates[input]);
            leaves[2] = Leaf::Within(seconds[input]);
        }
        given
    }
}

impl RequestReader<'_> {
    fn error(&mut self, message: String, reason: &str) -> Option<()> {
        self.diagnostics.error_because(self.mechanism.name.span(), message, reason);
        None
    }

    /// Every name that is given a value or a range is one of the mechanism's.
    fn names_exist(&mut self) -> Option<()> {
        let own = |name: &proc_macro2::Ident| name.unraw().to_string();
        let inputs: Vec<String> =
            self.mechanism.inputs.iter().map(|input| own(&input.name)).collect();
        let is_number =
            |param: &&model::mechanism::Param| matches!(param.kind, ParamKind::Number { .. });
        let params = self.mechanism.params.iter().filter(is_number).map(|param| own(&param.name));
        let ranged: Vec<String> = inputs.iter().cloned().chain(params).collect();
        let loads = self.mechanism.dynamics.loads.iter().map(|load| own(&load.name));
        let set: Vec<String> = ranged.iter().cloned().chain(loads).collect();
        let ReportOptions { between, set: given, rate, .. } = self.options;
        for (texts, known, what) in [
            (between, &ranged, "an input or a parameter"),
            (given, &set, "an input, a parameter or a load"),
            (rate, &inputs, "an input"),
        ] {
            let unknown = texts.iter().find(|(name, _)| !known.contains(name));
            if let Some((name, _)) = unknown {
                let near = nearest(name, known.iter().map(String::as_str));
                let near = near.map_or_else(
                    || format!("there are {}", known.join(", ")),
                    |near| format!("a similar name exists: `{near}`"),
                );
                return self.error(format!("`{name}` is not {what}"), &near);
            }
        }
        Some(())
    }

    fn entries(&mut self, lowered: &Lowered<'_>) -> Option<Vec<EntryId>> {
        let interface = &lowered.interface;
        let by_value = |id: &EntryId| !interface.entry(*id).takes_cosine();
        let ids: Vec<EntryId> = interface.ids().filter(by_value).collect();
        let name = |id: EntryId| interface.entry(id).point.name();
        let unknown =
            self.options.only.iter().find(|only| ids.iter().all(|&id| name(id) != **only));
        if let Some(unknown) = unknown {
            let names: Vec<&str> = ids.iter().map(|&id| name(id)).collect();
            let reason = format!("there are {}", names.join(", "));
            self.error(format!("`{unknown}` is no entry point that a report tells of"), &reason)?;
        }
        let is_told = |id: &EntryId| {
            let point = interface.entry(*id).point;
            match self.options.only.is_empty() {
                true => {
                    point.analysis == Analysis::Motion || point.row().topic != Topic::Kinematics
                }
                false => self.options.only.iter().any(|only| only == point.name()),
            }
        };
        Some(ids.into_iter().filter(is_told).collect())
    }

    fn text<'t>(texts: &'t [(String, String)], name: &str) -> Option<&'t str> {
        texts.iter().rev().find(|(own, _)| own == name).map(|(_, text)| &text[..])
    }

    fn input(&mut self, name: &str, dimension: Dimension) -> Option<Leaf> {
        if let Some(range) = self.range(name, dimension)? {
            return Some(range);
        }
        if let Some(text) = Self::text(&self.options.set, name) {
            let value = self.value(name, text, dimension)?.to_f64();
            self.words.push(format!("{name} = {text}"));
            return Some(Leaf::number(value));
        }
        if dimension == Dimension::ANGLE {
            const TURN: [f64; 2] = [-core::f64::consts::PI, core::f64::consts::PI];
            return Some(self.ranged(name, dimension, TURN));
        }
        let message = format!("say over which range `{name}` goes: `--between {name}=0mm..100mm`");
        self.error(
            message,
            "an angle goes over a full turn; other inputs have no range of their own",
        )?;
        None
    }

    fn param(&mut self, name: &str, dimension: Dimension, default: &Exact) -> Option<Leaf> {
        if let Some(range) = self.range(name, dimension)? {
            return Some(range);
        }
        let Some(text) = Self::text(&self.options.set, name) else {
            return Some(Leaf::Decimal(default.clone()));
        };
        let value = self.value(name, text, dimension)?;
        self.words.push(format!("{name} = {text}"));
        Some(Leaf::Decimal(value))
    }

    fn number(&mut self, name: &str, dimension: Dimension, default: f64) -> Option<Leaf> {
        let Some(text) = Self::text(&self.options.set, name) else {
            self.words.push(format!("{name} = {default}"));
            return Some(Leaf::number(default));
        };
        let value = self.value(name, text, dimension)?;
        self.words.push(format!("{name} = {text}"));
        Some(Leaf::Decimal(value))
    }

    /// The range that was given, if one was.
    fn range(&mut self, name: &str, dimension: Dimension) -> Option<Option<Leaf>> {
        let Some(text) = Self::text(&self.options.between, name) else { return Some(None) };
        let Some((from, to)) = text.split_once("..") else {
            let message = format!("write the range of `{name}` as `{name}=FROM..TO`");
            self.error(message, "two dots stand between the ends, as in `theta=0deg..180deg`")?;
            return None;
        };
        let from = self.value(name, from, dimension)?.to_f64();
        let to = self.value(name, to, dimension)?.to_f64();
        if from >= to {
            let message = format!("write the lower end of the range of `{name}` first");
            self.error(message, &format!("{from} is not below {to}"))?;
        }
        if dimension == Dimension::ANGLE && from.abs().max(to.abs()) > LARGEST_ANGLE {
            let message = format!("reduce the range of `{name}` by whole turns");
            self.error(
                message,
                "errors repeat with every turn; beyond 8000 of them the slow path answers",
            )?;
        }
        Some(Some(self.ranged(name, dimension, [from, to])))
    }

    fn ranged(&mut self, name: &str, dimension: Dimension, ends: [f64; 2]) -> Leaf {
        self.ranges.push((name.to_string(), unit(dimension, Order::Position)));
        self.ends.push(ends);
        Leaf::Ranged(self.ends.len() - 1)
    }

    fn ranges_are_few(&mut self) -> Option<()> {
        if self.ends.len() <= INPUTS {
            return Some(());
        }
        let names: Vec<&str> = self.ranges.iter().map(|(name, _)| &name[..]).collect();
        let message = format!("set all but {INPUTS} of {}: `--set NAME=VALUE`", names.join(", "));
        self.error(message, "no more ranges are followed at once")?;
        None
    }

    /// The rates that were given, zero for those that were not; none where none was.
    fn rates(&mut self) -> Option<Option<Vec<f64>>> {
        if self.options.rate.is_empty() {
            return Some(None);
        }
        let inputs: Vec<_> = (self.mechanism.inputs.iter())
            .map(|input| (input.name.unraw().to_string(), input.dimension))
            .collect();
        let rates = inputs.iter().map(|(name, dimension)| {
            let Some(text) = Self::text(&self.options.rate, name) else { return Some(0.0) };
            let rate = dimension.times(Dimension::TIME, -1);
            self.words.push(format!("{name}_rate = {text}"));
            Some(self.value(name, text, rate)?.to_f64())
        });
        Some(Some(rates.collect::<Option<_>>()?))
    }

    fn within(&mut self) -> Option<Option<(f64, String)>> {
        let Some(text) = self.options.within.as_deref() else { return Some(None) };
        match quantity(text) {
            Ok((value, dimension)) => {
                Some(Some((value.to_f64(), unit(dimension, Order::Position))))
            }
            Err(why) => {
                self.error(format!("write an error with its unit in place of `{text}`"), &why)?;
                None
            }
        }
    }

    /// The errors of the target's own functions.
    fn hooks(&mut self) -> Option<Hooks> {
        let ReportOptions { sine_error, root_error, .. } = self.options;
        let sine = self.error_of(sine_error.as_deref(), HOOKED_SINE, "a sine", "2^-20")?;
        let root = self.error_of(root_error.as_deref(), MOST_LAST_PLACES, "a square root", "1")?;
        self.words.extend(sine_error.iter().map(|text| format!("sines within {text}")));
        let places = root_error.iter().map(|text| format!("roots within {text} last places"));
        self.words.extend(places);
        Some(Hooks { sine, root })
    }

    fn error_of(
        &mut self,
        text: Option<&str>,
        most: f64,
        of: &str,
        as_in: &str,
    ) -> Option<Option<f64>> {
        let Some(text) = text else { return Some(None) };
        match number(text) {
            Some(error) if (0.0..=most).contains(&error) => Some(Some(error)),
            _ => {
                let message = format!("write the error of {of} as `{as_in}` in place of `{text}`");
                self.error(message, &format!("it is a number, {most} at most"))?;
                None
            }
        }
    }

    fn value(&mut self, name: &str, text: &str, wanted: Dimension) -> Option<Exact> {
        match value(text, wanted) {
            Ok(value) => Some(value),
            Err(why) => {
                self.error(format!("write a value of `{name}` in place of `{text}`"), &why)?;
                None
            }
        }
    }
}

/// A number, or a power of two as `2^-20`.
fn number(text: &str) -> Option<f64> {
    match text.trim().strip_prefix("2^") {
        Some(power) => power.parse().ok().map(|power| 2f64.powi(power)),
        None => text.trim().parse().ok(),
    }
}

/// A value of this dimension.
fn value(text: &str, wanted: Dimension) -> Result<Exact, String> {
    let (value, dimension) = quantity(text)?;
    // A number without a unit is SI.
    if dimension == wanted || dimension == Dimension::NUMBER {
        return Ok(value);
    }
    let [own, wanted] = [dimension, wanted].map(|of| unit(of, Order::Position));
    Err(format!("it is in {own}, and {wanted} is wanted"))
}

/// A value as a parameter's default is written, and its dimension.
fn quantity(text: &str) -> Result<(Exact, Dimension), String> {
    model::written_value(text).map_err(|mistakes| {
        let first = mistakes.into_iter().next().map(|mistake| mistake.message);
        first.unwrap_or_else(|| "it is not a number".to_string())
    })
}
