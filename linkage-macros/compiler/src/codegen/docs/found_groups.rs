//! The groups that were found in a drawing as a declaration, which the documentation of the solver shows.
//!
//! The declaration compiles as it stands, to the same groups. It holds what the machine moves by, and neither forces nor
//! outputs. Its frames and slides are those of the groups.

use std::collections::BTreeSet;

use syn::{Attribute, parse_quote};

use crate::codegen::docs::numbers_as_declared::{Declared, constant};
use crate::codegen::docs::powers_of_lengths::DeclaredUnit;
use crate::codegen::docs::ranges_in_words::goes;
use crate::codegen::docs::solved_together;
use crate::model::as_drawn::SearchFollowed;
use crate::model::mechanism::{
    AngleSum, Assembly, Carrier, Drive, Group, GuideDirection, Joint, LinkId, Mechanism, Mode,
    ParamKind, Placement, Scalar, Sign, Slideway, Step, Through, Unknown,
};
use crate::model::mechanism::{Dimension, Equation};
use crate::model::modes::PARALLEL;
use crate::syntax::anatomy::{GroupSpec, Modes};

/// The words of the author, and the groups that were found.
pub fn all_docs(mechanism: &Mechanism) -> Vec<Attribute> {
    let found = lines(mechanism);
    let found = found.iter().map(|line| parse_quote!(#[doc = #line]));
    mechanism.docs.iter().cloned().chain(found).collect()
}

/// The lines about the groups; none where nothing is drawn.
fn lines(mechanism: &Mechanism) -> Vec<String> {
    if !mechanism.as_drawn.is_found {
        return Vec::new();
    }
    let mut lines =
        vec![String::new(), " # Groups found in the drawing".to_string(), String::new()];
    lines.extend(match mechanism.tracked.is_empty() {
        true => declaration(mechanism),
        false => {
            let mut declared = declared(mechanism);
            solved_together::lines(mechanism, |place| moving(&mut declared, place))
        }
    });
    for search in &mechanism.as_drawn.searches {
        lines.extend([String::new(), followed(search)]);
        lines.extend(assembled(search));
    }
    lines
}

/// The groups as a declaration.
fn declaration(mechanism: &Mechanism) -> Vec<String> {
    let mut lines = vec![
        " The links and joints of the drawing are these drivers and groups:".to_string(),
        String::new(),
        " ```text".to_string(),
        " mechanism! {".to_string(),
        format!("     pub struct {} {{", mechanism.name),
    ];
    let statements = statements(mechanism).into_iter();
    lines.extend(statements.map(|statement| format!("         {statement}")));
    lines.extend(["     }", " }", " ```"].map(String::from));
    lines
}

/// The stretches over which a machine was followed with an unknown.
fn followed(search: &SearchFollowed) -> String {
    let SearchFollowed { unknown, traced, stretches, .. } = search;
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

/// The count of ways to assemble its group where it is drawn.
fn assembled(SearchFollowed { unknown, assemblies, .. }: &SearchFollowed) -> Option<String> {
    let list = assemblies.as_ref()?;
    let at_most = list.at_most;
    if !list.is_proved() {
        return Some(format!(" Its group has at most {at_most} assemblies."));
    }
    let nearest = list.nearest_other().map_or(String::new(), |nearest| {
        let away = nearest.abs().to_degrees();
        format!(": in the nearest other `{unknown}` is {away:.1}° away")
    });
    let count = list.list.len();
    Some(format!(
        " Where it is drawn its group has {count} assemblies, of at most {at_most}{nearest}."
    ))
}

/// The declaration, a statement each.
fn statements(mechanism: &Mechanism) -> Vec<String> {
    let mut declared = declared(mechanism);
    let places = 0..=mechanism.steps.len();
    let moving: Vec<_> = places.flat_map(|place| moving(&mut declared, place)).collect();
    let Declared { inputs, params, .. } = declared;
    let inputs = inputs.into_iter().map(|index| input(mechanism, index));
    let params = params.into_iter().map(|index| param(mechanism, index));
    inputs.chain(params).chain(moving).collect()
}

fn declared(mechanism: &Mechanism) -> Declared<'_> {
    Declared { mechanism, inputs: BTreeSet::new(), params: BTreeSet::new() }
}

/// The step at a place, and in front of it what begins and ends there.
fn moving(declared: &mut Declared<'_>, place: usize) -> Vec<String> {
    let (mechanism, mut moving) = (declared.mechanism, Vec::new());
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
    moving
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
                Dimension::LENGTH => DeclaredUnit::Length,
                Dimension::ANGLE => DeclaredUnit::Angle,
                _ => DeclaredUnit::Bare,
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
                let radius = self.number(radius, DeclaredUnit::Length);
                format!("polar ({radius}, {})", self.number(angle, DeclaredUnit::Angle))
            }
            Placement::Distances { distances, side, .. } => {
                let [first, second] = distances
                    .each_ref()
                    .map(|distance| self.number(&distance.value, DeclaredUnit::Length));
                let side = word(Modes::Side, *side);
                format!("distances ({first}, {second}) {side}")
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
                fields
                    .push(format!("length: {}", self.number(&length.value, DeclaredUnit::Length)));
            }
            [first, second] => {
                let [first, second] =
                    [first, second].map(|length| self.number(&length.value, DeclaredUnit::Length));
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
                fields.push(format!("slide: {}", self.number(slide, DeclaredUnit::Length)));
            }
            None => {}
        }
        if let Some(Slideway::Slot { angle, .. }) = group.inner.first().and_then(Joint::slideway) {
            fields.push(format!("slot: {}", self.turn(angle)));
        }
        let offsets = group.offsets();
        match &offsets[..] {
            all if all.iter().all(|offset| offset.is_zero()) => {}
            [offset] => {
                fields.push(format!("offset: {}", self.number(offset, DeclaredUnit::Length)))
            }
            [first, second, ..] => {
                let [first, second] =
                    [first, second].map(|offset| self.number(offset, DeclaredUnit::Length));
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
            Dimension::ANGLE => ("angle", DeclaredUnit::Angle),
            _ => ("length", DeclaredUnit::Length),
        };
        let [from, to] = unknown.between.each_ref().map(|end| self.number(end, unit));
        format!("unknown {}: {kind} between ({from}, {to});", unknown.name)
    }

    fn solve(&mut self, unknown: &Unknown) -> String {
        let unit = if unknown.measure == Dimension::LENGTH {
            DeclaredUnit::Length
        } else {
            DeclaredUnit::Bare
        };
        let equation = match &unknown.equation {
            Equation::Difference(sides) => {
                sides.each_ref().map(|side| self.number(side, unit)).join(" = ")
            }
            Equation::Turn(angle) => format!("{} = 0", self.turn(angle)),
            Equation::Distance { points: [p, q], length, .. } => {
                let length = self.number(&length.value, DeclaredUnit::Length);
                format!("distance({}, {}) = {length}", self.point(*p), self.point(*q))
            }
        };
        let mode = self.word(Modes::Trend, unknown.mode);
        let near = unknown.near.as_ref().map(|near| self.number(near, DeclaredUnit::Bare));
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
        let [x, y] = at.each_ref().map(|part| self.number(part, DeclaredUnit::Length));
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
            (true, _) => self.number(rest, DeclaredUnit::Angle),
            (false, true) => text,
            (false, false) => format!("{text} + {}", self.operand(rest, DeclaredUnit::Angle)),
        }
    }
}
