//! What stands in where a declaration has mistakes, so that one mistake gives one message: the code
//! that uses the mechanism still finds the struct, its methods and its fields.
//!
//! There is no second generator. The tree is made into a mechanism that nobody could build, with
//! every name it mentions but no step that places anything; with a program whose results are all
//! zero, the code generated from it has the signatures of the real one. It never runs.

mod forces;
#[cfg(test)]
mod tests;

use std::collections::HashMap;

use proc_macro2::{Ident, Span};
use syn::Attribute;

use crate::exact::Exact;
use crate::model::dynamics::Load;
use crate::model::mechanism::{
    AngleSum, Dimension, Expr, GroupId, GroupName, Input, Link, LinkId, Mechanism, Output,
    OutputKind, Param, ParamKind, PartOf, Point, PointId, Sign,
};
use crate::syntax::anatomy::Anatomy;
use crate::syntax::tree::{self, Declaration, ExprKind, OutputItem, StatementKind};

const NUMBER: Dimension = Dimension::NUMBER;

/// What stands in for a declaration of which not everything was understood.
pub(crate) fn stand_in(declaration: &Declaration) -> Mechanism {
    let mut stand_in = StandIn::new(declaration);
    for statement in &declaration.statements {
        stand_in.declare(&statement.docs, &statement.kind);
    }
    stand_in.choose_outputs(declaration);
    stand_in.give_forces(declaration);
    stand_in.mechanism
}

/// The mechanism in the making, and what its names stand for.
struct StandIn {
    mechanism: Mechanism,
    /// The first declaration of every name that may be an output.
    things: HashMap<String, Thing>,
    /// Points and links as they were declared.
    order: Vec<Ident>,
    guides: Vec<Ident>,
}

#[derive(Clone, Copy)]
enum Thing {
    /// A fixed point is no output unless it is asked for.
    Point(PointId, Fixed),
    Link(LinkId),
    /// A named value, and whether it holds the angle of a link.
    Value(bool),
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Fixed {
    Yes,
    No,
}

impl StandIn {
    fn new(declaration: &Declaration) -> Self {
        let Declaration { docs, visibility, name, .. } = declaration;
        let empty = Mechanism::empty(docs.clone(), visibility.clone(), name.clone());
        let mechanism = Mechanism { stands_in: true, ..empty };
        Self { mechanism, things: HashMap::new(), order: Vec::new(), guides: Vec::new() }
    }

    fn declare(&mut self, docs: &[Attribute], statement: &StatementKind) {
        match statement {
            StatementKind::Input { names, kind } => {
                names.iter().for_each(|name| self.input(docs, name, kind.as_ref()));
            }
            StatementKind::Param { name, kind, default } => {
                self.param(docs, name, kind.as_ref(), default);
            }
            StatementKind::Let { name, value } => {
                let turns = self.holds_angle(value);
                self.things.entry(name.to_string()).or_insert(Thing::Value(turns));
            }
            StatementKind::Unknown { name, .. } => {
                let is_new = !self.things.contains_key(&name.to_string());
                self.things.entry(name.to_string()).or_insert(Thing::Value(false));
                if is_new {
                    self.order.push(name.clone());
                }
            }
            StatementKind::Ground { points } => {
                for (name, _) in points {
                    self.point(docs, name, Fixed::Yes, PartOf::Ground);
                }
            }
            StatementKind::Pin { points } => {
                for (name, _) in points {
                    self.point(docs, name, Fixed::No, PartOf::Driven(GroupId(0)));
                }
            }
            StatementKind::Link { links, .. } => {
                links.iter().for_each(|link| self.drawn_link(docs, link));
            }
            StatementKind::Point { name, .. } => {
                // On which link is not known: its name may be the mistake.
                self.point(docs, name, Fixed::No, PartOf::Driven(GroupId(0)));
            }
            StatementKind::Group(group) => self.group(docs, group),
            StatementKind::Crate { path } => self.mechanism.crate_path = Some(path.clone()),
            StatementKind::Export { language } => self.mechanism.export_c |= language == "c",
            StatementKind::Load { names, kind } => {
                names.iter().for_each(|name| self.load(docs, name, kind.as_ref()));
            }
            StatementKind::Action(_) => {}
            StatementKind::Guide { name, .. } => self.guides.push(name.clone()),
            StatementKind::Solve(_)
            | StatementKind::Drive(_)
            | StatementKind::Output { .. }
            | StatementKind::Numerics { .. } => {}
        }
    }

    fn input(&mut self, docs: &[Attribute], name: &Ident, kind: Option<&Ident>) {
        let inputs = &mut self.mechanism.inputs;
        if inputs.iter().all(|input| input.name != *name) {
            let (name, docs) = (name.clone(), docs.to_vec());
            inputs.push(Input { name, docs, dimension: dimension(kind) });
        }
    }

    fn load(&mut self, docs: &[Attribute], name: &Ident, kind: Option<&Ident>) {
        let loads = &mut self.mechanism.dynamics.loads;
        if loads.iter().all(|load| load.name != *name) {
            let (name, docs) = (name.clone(), docs.to_vec());
            loads.push(Load { name, docs, dimension: dimension(kind) });
        }
    }

    fn param(
        &mut self,
        docs: &[Attribute],
        name: &Ident,
        kind: Option<&Ident>,
        default: &tree::Expr,
    ) {
        if self.mechanism.params.iter().any(|param| param.name == *name) {
            return;
        }
        let word = match &default.kind {
            ExprKind::Name(word) => word.to_string(),
            _ => String::new(),
        };
        let kind = match word.as_str() {
            "left" | "right" => ParamKind::Side { default: Sign::Plus },
            "ahead" | "behind" => ParamKind::Sense { default: Sign::Plus },
            "rising" | "falling" => ParamKind::Trend { default: Sign::Plus },
            _ if kind.is_some_and(|kind| kind == "mode") => ParamKind::Side { default: Sign::Plus },
            _ => ParamKind::Number { dimension: NUMBER, default: Exact::integer(0) },
        };
        self.mechanism.params.push(Param { name: name.clone(), docs: docs.to_vec(), kind });
    }

    fn point(&mut self, docs: &[Attribute], key: &Ident, fixed: Fixed, part_of: PartOf) {
        if self.things.contains_key(&key.to_string()) {
            return;
        }
        let id = PointId(self.mechanism.points.len() as u32);
        let (name, docs) = (key.clone(), docs.to_vec());
        self.mechanism.points.push(Point { name, docs, part_of });
        self.things.insert(key.to_string(), Thing::Point(id, fixed));
        self.order.push(key.clone());
    }

    fn group(&mut self, docs: &[Attribute], group: &tree::Group) {
        let made_by = GroupId(self.mechanism.groups.len() as u32);
        let (keyword, title) = (group.keyword.clone(), group.title());
        self.mechanism.groups.push(GroupName { keyword, title });
        let slides = sliding(&group.keyword.to_string());
        for (leg, slides) in group.legs.iter().zip(slides) {
            if self.things.contains_key(&leg.link.to_string()) {
                continue;
            }
            let id = LinkId(self.mechanism.links.len() as u32);
            self.things.insert(leg.link.to_string(), Thing::Link(id));
            self.order.push(leg.link.clone());
            let name = leg.link.clone();
            self.mechanism.links.push(Link { name, docs: docs.to_vec(), made_by, slides });
        }
        if let Some(pin) = &group.pin {
            self.point(docs, pin, Fixed::No, PartOf::Pin(made_by));
        }
    }

    /// A link that no group has placed yet.
    fn drawn_link(&mut self, docs: &[Attribute], link: &tree::DrawnLink) {
        let mut group = tree::Group::of_link(&link.name);
        group.legs.push(tree::Leg { link: link.name.clone(), joint: None });
        self.group(docs, &group);
    }

    /// Whether an expression holds the angle of a link, itself or under a name.
    fn holds_angle(&self, value: &tree::Expr) -> bool {
        match &value.kind {
            ExprKind::Member(_, member) => member == "angle",
            ExprKind::Name(name) => {
                matches!(self.things.get(&name.to_string()), Some(Thing::Value(true)))
            }
            _ => value.parts().any(|part| self.holds_angle(part)),
        }
    }

    /// What is asked for, where all of it is understood. Where something is not, it may be any of
    /// the names, and all of them become fields.
    fn choose_outputs(&mut self, declaration: &Declaration) {
        if self.mechanism.inputs.is_empty() {
            self.input(&[], &Ident::new("input", Span::call_site()), None);
        }
        let items: Vec<&OutputItem> = declaration.statements.iter().flat_map(asked_for).collect();
        let understood: Vec<bool> = items.iter().map(|item| self.output(item)).collect();
        if items.is_empty() {
            self.every_thing(Fixed::No);
        } else if understood.contains(&false) {
            self.every_thing(Fixed::Yes);
        }
        if self.mechanism.outputs.is_empty() {
            // A record without a field could not have a type parameter.
            self.push(Ident::new("nothing_", Span::call_site()), value());
        }
    }

    /// Adds an output that was asked for, as far as it is understood.
    fn output(&mut self, item: &OutputItem) -> bool {
        if let Some(name) = &item.name {
            // A point under another name is a mistake, and its coordinates may be asked for.
            let thing = match &item.value.kind {
                ExprKind::Name(value) => self.things.get(&value.to_string()).copied(),
                _ => None,
            };
            let kind = match thing {
                Some(thing) => self.whole(thing),
                None => self.value_of(self.holds_angle(&item.value)),
            };
            self.push(name.clone(), kind);
            return true;
        }
        match &item.value.kind {
            ExprKind::Name(name) if name == "energy" || name == "shaking" => true,
            ExprKind::Name(name) if name == "centre_of_mass" => {
                self.push(name.clone(), OutputKind::CentreOfMass);
                true
            }
            ExprKind::Name(name) => match self.things.get(&name.to_string()) {
                Some(&thing) => {
                    let kind = self.whole(thing);
                    self.push(name.clone(), kind);
                    true
                }
                None => false,
            },
            ExprKind::Member(link, member) => self.is_a_force(member) || self.member(link, member),
            _ => false,
        }
    }

    /// Whether a link or an input has this about forces: all of that is given in any case.
    fn is_a_force(&self, member: &Ident) -> bool {
        let is_word = ["drive", "push", "force", "torque"].iter().any(|word| member == word);
        is_word || self.things.contains_key(&member.to_string()) || self.guides.contains(member)
    }

    fn member(&mut self, name: &Ident, member: &Ident) -> bool {
        let link = match self.things.get(&name.to_string()) {
            Some(&Thing::Link(link)) => link,
            Some(Thing::Point(..)) if member == "x" || member == "y" => {
                self.push(Ident::new(&format!("{name}_{member}"), member.span()), value());
                return true;
            }
            _ => return false,
        };
        let group = self.mechanism.links[link.index()].made_by;
        let (direction, slide) = match member.to_string().as_str() {
            "angle" => (true, false),
            "slide" => (false, true),
            word @ ("margin" | "transmission") => {
                let field = Ident::new(&format!("{name}_{word}"), member.span());
                let margin = word == "margin";
                let kind = if margin {
                    OutputKind::Margin(group)
                } else {
                    OutputKind::Transmission(group)
                };
                self.push(field, kind);
                return true;
            }
            _ => return false,
        };
        // `ram.angle` and `ram.slide` share the field `ram`.
        let known = self.mechanism.outputs.iter_mut().find(|output| output.field == *name);
        match known.map(|output| &mut output.kind) {
            Some(OutputKind::Link { direction: d, slide: s, .. }) => {
                (*d, *s) = (*d || direction, *s || slide);
            }
            _ => self.push(name.clone(), OutputKind::Link { link, direction, slide }),
        }
        true
    }

    /// Adds what was not asked for: points and links in the order they were declared.
    fn every_thing(&mut self, fixed: Fixed) {
        for name in self.order.clone() {
            match self.things.get(&name.to_string()) {
                Some(Thing::Point(_, Fixed::Yes)) if fixed == Fixed::No => {}
                Some(&thing) => {
                    let kind = self.whole(thing);
                    self.push(name, kind);
                }
                None => {}
            }
        }
    }

    fn whole(&self, thing: Thing) -> OutputKind {
        match thing {
            Thing::Point(point, _) => OutputKind::Point(point),
            Thing::Link(link) => {
                let slide = self.mechanism.links[link.index()].slides;
                OutputKind::Link { link, direction: true, slide }
            }
            Thing::Value(turns) => self.value_of(turns),
        }
    }

    fn value_of(&self, turns: bool) -> OutputKind {
        match turns {
            true => OutputKind::Angle(AngleSum { links: Vec::new(), rest: zero() }),
            false => value(),
        }
    }

    /// Adds an output unless there is one of that name.
    fn push(&mut self, field: Ident, kind: OutputKind) {
        if self.mechanism.outputs.iter().all(|output| output.field != field) {
            self.mechanism.outputs.push(Output { field, docs: Vec::new(), kind });
        }
    }
}

fn asked_for(statement: &tree::Statement) -> &[OutputItem] {
    match &statement.kind {
        StatementKind::Output { items } => items,
        _ => &[],
    }
}

/// Which legs of a group slide; where the group is not known, its links have every field.
fn sliding(keyword: &str) -> [bool; 2] {
    Anatomy::of(keyword).map_or([true; 2], |anatomy| anatomy.slides)
}

/// The dimension of a kind as it is written; a number where the word is none.
fn dimension(kind: Option<&Ident>) -> Dimension {
    match kind.map(ToString::to_string).as_deref() {
        Some("angle") => Dimension::ANGLE,
        Some("length") => Dimension::LENGTH,
        Some("force") => Dimension::FORCE,
        Some("torque") => Dimension::TORQUE,
        _ => NUMBER,
    }
}

fn value() -> OutputKind {
    OutputKind::Value { value: zero(), dimension: NUMBER }
}

fn zero() -> Expr {
    Expr::Constant(Exact::integer(0))
}
