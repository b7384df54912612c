//! The groups that were found in a drawing as a declaration, which the documentation of the solver shows.
//!
//! The declaration compiles as it stands, to the same groups. It holds what the machine moves by, and neither forces nor
//! outputs. Its frames and slides are those of the groups.

use std::collections::BTreeSet;

use proc_macro2::Ident;
use syn::{Attribute, parse_quote};

use crate::exact::Exact;
use crate::model::as_drawn::{SearchFollowed, Stretch};
use crate::model::mechanism::{
    AngleSum, Assembly, Axis, Carrier, Drive, Group, GuideDirection, GuideId, InputId, Joint,
    LinkId, Mechanism, Mode, Operator, ParamId, ParamKind, Placement, PointId, Scalar, Sign,
    Slideway, Step, Through, Unknown,
};
use crate::model::mechanism::{Dimension, Equation};
use crate::model::modes::PARALLEL;
use crate::syntax::anatomy::{GroupSpec, Modes};

/// The words of the author, and the groups that were found.
pub(crate) fn all_docs(mechanism: &Mechanism) -> Vec<Attribute> {
    let found = lines(mechanism);
    let found = found.iter().map(|line| parse_quote!(#[doc = #line]));
    mechanism.docs.iter().cloned().chain(found).collect()
}

/// The lines about the groups; none where nothing is drawn.
fn lines(mechanism: &Mechanism) -> Vec<String> {
    if !mechanism.as_drawn.is_found {
        return Vec::new();
    }
    let mut lines = vec![
        String::new(),
        " # Groups found in the drawing".to_string(),
        String::new(),
        " The links and joints of the drawing are these drivers and groups:".to_string(),
        String::new(),
        " ```text".to_string(),
        " mechanism! {".to_string(),
        format!("     pub struct {} {{", mechanism.name),
    ];
    let statements = statements(mechanism).into_iter();
    lines.extend(statements.map(|statement| format!("         {statement}")));
    lines.extend(["     }", " }", " ```"].map(String::from));
    for search in &mechanism.as_drawn.searches {
        lines.extend([String::new(), followed(search)]);
    }
    lines
}

/// The stretches over which a machine was followed with an unknown.
fn followed(SearchFollowed { unknown, traced, stretches }: &SearchFollowed) -> String {
    let goes = stretches.iter().map(goes).collect::<Vec<_>>().join(", and while ");
    let alone = if stretches.len() > 1 { ", the others as drawn" } else { "" };
    match traced {
        None => format!(
            " `{unknown}` is searched in one interval: it was followed while {goes} about the drawing{alone}."
        ),
        Some(traced) => format!(
            " `{unknown}` is searched beside `{traced}`, which is the motion of the drawing to \
             within a third of the interval while {goes} about the drawing."
        ),
    }
}

fn goes(Stretch { input, ends, is_angle }: &Stretch) -> String {
    let [from, to] = match is_angle {
        true => ends.map(|end| format!("{:.1}°", end.to_degrees() + 0.0)),
        false => ends.map(|end| format!("{:.3} m", end + 0.0)),
    };
    let who = input.as_ref().map_or("the first drive".to_string(), |input| format!("`{input}`"));
    format!("{who} goes from {from} to {to}")
}

/// The declaration, a statement each.
fn statements(mechanism: &Mechanism) -> Vec<String> {
    let mut declared = Declared { mechanism, inputs: BTreeSet::new(), params: BTreeSet::new() };
    let mut moving = Vec::new();
    for place in 0..=mechanism.steps.len() {
        for unknown in &mechanism.unknowns {
            let [begins, ends] = unknown.steps;
            if begins == place {
                moving.push(declared.unknown(unknown));
            }
            if ends == place {
                moving.push(declared.solve(unknown));
            }
        }
        moving.extend(mechanism.steps.get(place).map(|step| declared.step(step)));
    }
    let Declared { inputs, params, .. } = declared;
    let inputs = inputs.into_iter().map(|index| input(mechanism, index));
    let params = params.into_iter().map(|index| param(mechanism, index));
    inputs.chain(params).chain(moving).collect()
}

fn input(mechanism: &Mechanism, index: usize) -> String {
    let input = &mechanism.inputs[index];
    let kind = match input.dimension {
        Dimension::ANGLE => "angle",
        _ => "length",
    };
    format!("input {}: {kind};", input.name)
}

fn param(mechanism: &Mechanism, index: usize) -> String {
    let param = &mechanism.params[index];
    match &param.kind {
        ParamKind::Number { dimension, default, .. } => {
            let unit = match *dimension {
                Dimension::LENGTH => Unit::Length,
                Dimension::ANGLE => Unit::Angle,
                _ => Unit::Bare,
            };
            format!("param {} = {};", param.name, constant(default, unit))
        }
        ParamKind::Mode { of, default } => {
            format!("param {}: mode = {};", param.name, word(*of, *default))
        }
    }
}

fn word(of: Modes, sign: Sign) -> &'static str {
    of.words()[usize::from(sign == Sign::Minus)]
}

/// The unit in which a number is written.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Unit {
    Length,
    Angle,
    /// Metres or radians, or no unit at all.
    Bare,
}

/// A constant, without error where its text is not too long.
fn constant(value: &Exact, unit: Unit) -> String {
    match unit {
        _ if value.is_zero() => "0".to_string(),
        Unit::Bare => match decimal(value) {
            Some(number) => number,
            None => format!("({})", formula(value).unwrap_or_else(|| float(value))),
        },
        Unit::Length => length(value),
        Unit::Angle => {
            let degrees = Exact::pi().div(&Exact::integer(180)).and_then(|one| value.div(&one));
            match (degrees.as_ref().and_then(decimal), formula(value)) {
                (Some(degrees), _) => format!("{degrees}deg"),
                (None, Some(angle)) => angle.replace("pi", "180deg"),
                (None, None) => format!("{}rad", float(value)),
            }
        }
    }
}

/// In millimetres below a metre.
fn length(value: &Exact) -> String {
    let millimetres = value.mul(&Exact::integer(1000));
    let (number, unit) =
        if value.to_f64().abs() < 1.0 { (&millimetres, "mm") } else { (value, "m") };
    match (decimal(number), formula(number)) {
        (Some(number), _) => format!("{number}{unit}"),
        (None, Some(number)) => format!("({number}) * 1{unit}"),
        (None, None) => format!("{}{unit}", float(number)),
    }
}

/// The digits of a number that is a short decimal.
fn decimal(value: &Exact) -> Option<String> {
    let text = value.to_string();
    let digits = text.strip_prefix('-').unwrap_or(&text);
    let is_decimal = digits.bytes().all(|digit| digit.is_ascii_digit() || digit == b'.');
    is_decimal.then_some(text)
}

/// The operations that a number is made by, if these are few.
fn formula(value: &Exact) -> Option<String> {
    Some(value.to_string()).filter(|text| !text.contains(['~', '^']))
}

fn float(value: &Exact) -> String {
    format!("{:?}", value.to_f64())
}

/// Writes statements, and notes which inputs and parameters they read.
struct Declared<'m> {
    mechanism: &'m Mechanism,
    inputs: BTreeSet<usize>,
    params: BTreeSet<usize>,
}

impl Declared<'_> {
    fn step(&mut self, step: &Step) -> String {
        match step {
            Step::Ground { point, at } => {
                let at = self.pair(at);
                format!("ground {}{at};", self.point(*point))
            }
            Step::Guide { guide, carrier, through, course } => {
                let through = match through {
                    Through::At(at) => self.pair(at),
                    Through::Point(point) => self.point(*point).to_string(),
                };
                let course = match course {
                    GuideDirection::Along(angle) => format!("along {}", self.turn(angle)),
                    GuideDirection::Towards(point) => format!("towards {}", self.point(*point)),
                };
                let (name, on) = (self.guide(*guide), self.on(*carrier));
                format!("guide {name}{on} through {through} {course};")
            }
            Step::Point { point, carrier, place, .. } => {
                let place = self.placement(place);
                format!("point {}{} at {place};", self.point(*point), self.on(*carrier))
            }
            Step::Group(group) => self.group(group),
        }
    }

    fn placement(&mut self, place: &Placement) -> String {
        match place {
            Placement::Cartesian(at) => self.pair(at),
            Placement::Polar(radius, angle) => {
                let radius = self.number(radius, Unit::Length);
                format!("polar ({radius}, {})", self.number(angle, Unit::Angle))
            }
            Placement::Distances { distances, side, .. } => {
                let [first, second] =
                    distances.each_ref().map(|distance| self.number(&distance.value, Unit::Length));
                format!("distances ({first}, {second}) {}", word(Modes::Side, *side))
            }
        }
    }

    fn group(&mut self, group: &Group) -> String {
        let keyword = self.mechanism.groups[group.id.index()].keyword.to_string();
        let leg = |(link, joint): (&LinkId, &Joint)| {
            let joint = match (joint.point(), joint.guide()) {
                (Some(point), _) => self.point(point).to_string(),
                (None, Some(guide)) => self.guide(guide).to_string(),
                (None, None) => String::new(),
            };
            format!("{}({joint})", self.link(*link))
        };
        let legs = group.links.iter().zip(&group.outer).map(leg).collect::<Vec<_>>().join(", ");
        let pin = group.pin.map_or(String::new(), |pin| format!(" -> {}", self.point(pin)));
        let mut fields = self.dimensions(group);
        fields.extend(self.mode(group, &keyword));
        let fields = match fields.is_empty() {
            true => "{ }".to_string(),
            false => format!("{{ {} }}", fields.join(", ")),
        };
        format!("{keyword} {legs}{pin} {fields}")
    }

    /// The fields with numbers.
    fn dimensions(&mut self, group: &Group) -> Vec<String> {
        let mut fields = Vec::new();
        match &group.lengths.iter().flatten().collect::<Vec<_>>()[..] {
            [length] => {
                fields.push(format!("length: {}", self.number(&length.value, Unit::Length)));
            }
            [first, second] => {
                let [first, second] =
                    [first, second].map(|length| self.number(&length.value, Unit::Length));
                fields.push(format!("lengths: ({first}, {second})"));
            }
            _ => {}
        }
        match &group.outer[0].drive {
            Some(Drive::Angle { angle, relative_to }) => {
                fields.push(format!("angle: {}", self.turn(angle)));
                if let Carrier::Link(link) = relative_to {
                    fields.push(format!("relative_to: {}", self.link(*link)));
                }
            }
            Some(Drive::Slide(slide)) => {
                fields.push(format!("slide: {}", self.number(slide, Unit::Length)));
            }
            None => {}
        }
        if let Some(Slideway::Slot { angle, .. }) = group.inner.first().and_then(Joint::slideway) {
            fields.push(format!("slot: {}", self.turn(angle)));
        }
        let offsets = group.offsets();
        match &offsets[..] {
            all if all.iter().all(|offset| offset.is_zero()) => {}
            [offset] => fields.push(format!("offset: {}", self.number(offset, Unit::Length))),
            [first, second, ..] => {
                let [first, second] =
                    [first, second].map(|offset| self.number(offset, Unit::Length));
                fields.push(format!("offsets: ({first}, {second})"));
            }
            [] => {}
        }
        fields
    }

    fn mode(&mut self, group: &Group, keyword: &str) -> Option<String> {
        let mode = match group.assembly {
            Assembly::Unique => return None,
            Assembly::Parallel(_) => PARALLEL.to_string(),
            Assembly::Signed(mode) => self.word(GroupSpec::of(keyword)?.modes?, mode),
        };
        Some(format!("mode: {mode}"))
    }

    /// A mode by its word or its parameter.
    fn word(&mut self, of: Modes, mode: Mode) -> String {
        match mode {
            Mode::Fixed(sign) => word(of, sign).to_string(),
            Mode::Param(param) => self.param(param),
        }
    }

    fn unknown(&mut self, unknown: &Unknown) -> String {
        let (kind, unit) = match unknown.dimension {
            Dimension::ANGLE => ("angle", Unit::Angle),
            _ => ("length", Unit::Length),
        };
        let [from, to] = unknown.between.each_ref().map(|end| self.number(end, unit));
        format!("unknown {}: {kind} between ({from}, {to});", unknown.name)
    }

    fn solve(&mut self, unknown: &Unknown) -> String {
        let unit = if unknown.measure == Dimension::LENGTH { Unit::Length } else { Unit::Bare };
        let equation = match &unknown.equation {
            Equation::Difference(sides) => {
                sides.each_ref().map(|side| self.number(side, unit)).join(" = ")
            }
            Equation::Turn(angle) => format!("{} = 0", self.turn(angle)),
            Equation::Distance { points: [p, q], length, .. } => {
                let length = self.number(&length.value, Unit::Length);
                format!("distance({}, {}) = {length}", self.point(*p), self.point(*q))
            }
        };
        let mode = self.word(Modes::Trend, unknown.mode);
        let near = unknown.near.as_ref().map(|near| self.number(near, Unit::Bare));
        let near = near.map_or(String::new(), |near| format!(", near: {near}"));
        format!("solve {} {{ {equation}, mode: {mode}{near} }}", unknown.name)
    }

    fn on(&self, carrier: Carrier) -> String {
        match carrier {
            Carrier::Ground => String::new(),
            Carrier::Link(link) => format!(" on {}", self.link(link)),
        }
    }

    /// Coordinates.
    fn pair(&mut self, at: &[Scalar; 2]) -> String {
        let [x, y] = at.each_ref().map(|part| self.number(part, Unit::Length));
        format!("({x}, {y})")
    }

    fn turn(&mut self, AngleSum { links, rest }: &AngleSum) -> String {
        let mut text = String::new();
        for (link, times) in links {
            let angle = format!("{}.angle", self.link(*link));
            let sign = match (text.is_empty(), *times < 0) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            };
            text += sign;
            text += &match times.abs() {
                1 => angle,
                times => format!("{times} * {angle}"),
            };
        }
        match (text.is_empty(), rest.is_zero()) {
            (true, _) => self.number(rest, Unit::Angle),
            (false, true) => text,
            (false, false) => format!("{text} + {}", self.operand(rest, Unit::Angle)),
        }
    }

    fn number(&mut self, value: &Scalar, unit: Unit) -> String {
        match value {
            Scalar::Constant(value) => constant(value, unit),
            Scalar::Input(input) => self.input(*input),
            Scalar::Param(param) => self.param(*param),
            Scalar::Load(load) => self.mechanism.dynamics.loads[load.index()].name.to_string(),
            Scalar::Unknown(unknown) => self.mechanism.unknowns[unknown.index()].name.to_string(),
            Scalar::Let(id) => self.number(&self.mechanism.lets[id.index()].rest, unit),
            Scalar::Slide(link) => format!("{}.slide", self.link(*link)),
            Scalar::Coordinate(point, axis) => {
                let axis = if *axis == Axis::X { "x" } else { "y" };
                format!("{}.{axis}", self.point(*point))
            }
            Scalar::Distance([p, q]) => format!("distance({}, {})", self.point(*p), self.point(*q)),
            Scalar::Offset(point, guide) => {
                format!("offset({}, {})", self.point(*point), self.guide(*guide))
            }
            Scalar::AboveZero(number) => self.number(&number.value, Unit::Bare),
            Scalar::Negate(inner) => format!("-{}", self.operand(inner, unit)),
            Scalar::Chain(first, rest) => self.chain(first, rest, unit),
            Scalar::Call(function, arguments) => {
                let arguments: Vec<_> =
                    arguments.iter().map(|argument| self.number(argument, Unit::Bare)).collect();
                format!("{}({})", function.name(), arguments.join(", "))
            }
            // Nothing that moves the machine reads them.
            Scalar::Pull
            | Scalar::Law(_)
            | Scalar::Twist(_)
            | Scalar::Effort(..)
            | Scalar::Rate(_) => "…".to_string(),
        }
    }

    /// Operations, each on what the one before has made.
    fn chain(&mut self, first: &Scalar, rest: &[(Operator, Scalar)], unit: Unit) -> String {
        let is_sum = rest.iter().all(|(sign, _)| matches!(sign, Operator::Add | Operator::Sub));
        let unit = if is_sum { unit } else { Unit::Bare };
        let mut text = self.operand(first, unit);
        for (index, (operator, operand)) in rest.iter().enumerate() {
            let is_product = |sign| matches!(sign, Operator::Mul | Operator::Div);
            if is_product(*operator) && rest[..index].iter().any(|(sign, _)| !is_product(*sign)) {
                text = format!("({text})");
            }
            let sign = match operator {
                Operator::Add => '+',
                Operator::Sub => '-',
                Operator::Mul => '*',
                Operator::Div => '/',
            };
            text += &format!(" {sign} {}", self.operand(operand, unit));
        }
        text
    }

    /// An operand, in parentheses where it is a chain itself.
    fn operand(&mut self, value: &Scalar, unit: Unit) -> String {
        let text = self.number(value, unit);
        match text.contains(' ') && !text.ends_with(')') || matches!(value, Scalar::Chain(..)) {
            true => format!("({text})"),
            false => text,
        }
    }

    fn input(&mut self, input: InputId) -> String {
        self.inputs.insert(input.index());
        self.mechanism.inputs[input.index()].name.to_string()
    }

    fn param(&mut self, param: ParamId) -> String {
        self.params.insert(param.index());
        self.mechanism.params[param.index()].name.to_string()
    }

    fn point(&self, point: PointId) -> &Ident {
        &self.mechanism.points[point.index()].name
    }

    fn link(&self, link: LinkId) -> &Ident {
        &self.mechanism.links[link.index()].name
    }

    fn guide(&self, guide: GuideId) -> &Ident {
        &self.mechanism.guides[guide.index()].name
    }
}
