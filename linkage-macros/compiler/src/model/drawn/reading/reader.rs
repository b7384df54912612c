//! Reads the names of a drawing: its pins, links and guides.

use std::collections::HashMap;

use proc_macro2::Ident;

use crate::chain::machine::GROUND;
use crate::diagnostics::nearest;
use crate::syntax::tree::{
    Declaration, DrawnLink, DriveStatement, Expr, GroundStatement, GroupFieldValue, GroupStatement,
    LinkStatement, PinStatement, PointStatement, Statement, StatementKind,
};

use crate::model::begun;
use crate::model::drawn::outline::bodies::{GuideLine, LinkOutline, PinPlace};
use crate::model::drawn::outline::loose;
use crate::model::drawn::reading::values::{Measured, drawn_points};
use crate::model::figures::Figure;
use crate::model::items::items;
use crate::model::names::Kind;
use crate::model::statements::declared_by;

/// Reads the names of a drawing one after the other.
pub struct Reader<'t, 'v, 'd> {
    pub tree: &'t Declaration,
    pub values: &'v mut Measured<'d>,
    pub pins: Vec<PinPlace<'t>>,
    pub(in crate::model::drawn) pin_of: HashMap<String, usize>,
    pub links: Vec<LinkOutline<'t>>,
    pub(in crate::model::drawn) link_of: HashMap<String, usize>,
    pub guides: Vec<GuideLine<'t>>,
    pub(in crate::model::drawn) guide_of: HashMap<String, usize>,
}

/// The links of a statement with what its braces say.
pub(in crate::model::drawn) fn drawn_links(statement: &Statement) -> &[DrawnLink] {
    match &statement.kind {
        StatementKind::Link(LinkStatement { links, .. }) => links,
        _ => &[],
    }
}

impl<'t, 'v, 'd> Reader<'t, 'v, 'd> {
    /// All names that are read, and what drives which body; `None` where a name is in error, which was
    /// reported.
    pub fn of(
        tree: &'t Declaration,
        values: &'v mut Measured<'d>,
    ) -> Option<(Self, Vec<(usize, &'t DriveStatement)>)> {
        let before = values.scope.diagnostics.count();
        let mut reader = Reader {
            tree,
            values,
            pins: Vec::new(),
            pin_of: HashMap::new(),
            links: Vec::new(),
            link_of: HashMap::new(),
            guides: Vec::new(),
            guide_of: HashMap::new(),
        };
        reader.names_are_given_once()?;
        reader.read_pins();
        reader.read_links();
        reader.read_given();
        reader.read_points();
        reader.pins_are_on_bodies();
        reader.read_guides();
        reader.guides_of_links();
        let drives = reader.read_drives();
        reader.bars_have_lengths();
        (reader.values.scope.diagnostics.count() == before).then_some((reader, drives))
    }

    pub(in crate::model::drawn) fn report(&mut self, at: &Ident, message: String, reason: String) {
        self.values.scope.diagnostics.error_because(at.span(), message, reason);
    }

    /// Reports that nothing makes or uses a name, unless a statement that could not be read may do so.
    fn report_missing(&mut self, name: &Ident, message: String, reason: String) {
        if !self.tree.unread.may_hold(&name.to_string()) {
            self.report(name, message, reason);
        }
    }

    /// A link has one declaration, and a pin one place.
    fn names_are_given_once(&mut self) -> Option<()> {
        let mut seen: HashMap<String, (Kind, bool)> = HashMap::new();
        let mut is_fine = Some(());
        for statement in &self.tree.statements {
            let names = declared_by(statement);
            let is_drawn = matches!(statement.kind, StatementKind::Pin(_) | StatementKind::Link(_));
            for (name, kind) in names {
                match seen.insert(name.to_string(), (kind, is_drawn)) {
                    // A group that is declared makes a pin whose place the drawing gives.
                    Some((Kind::Point, was_drawn))
                        if kind == Kind::Point && is_drawn != was_drawn => {}
                    Some((before, _)) => {
                        let message = format!("the name `{name}` is taken; choose another");
                        self.report(name, message, format!("`{name}` is {}", before.one()));
                        is_fine = None;
                    }
                    None => {}
                }
            }
        }
        is_fine
    }

    fn read_pins(&mut self) {
        for (name, _) in drawn_points(self.tree) {
            let Some(at) = self.values.places.get(&name.to_string()).cloned() else { continue };
            self.pin_of.insert(name.to_string(), self.pins.len());
            self.pins.push(PinPlace { name: name.clone(), at, on: None, apart: None });
        }
        for statement in &self.tree.statements {
            let StatementKind::Point(PointStatement { name, on, .. }) = &statement.kind else {
                continue;
            };
            let is_drawn = |on: &Ident| {
                self.tree.statements.iter().flat_map(drawn_links).any(|link| link.name == *on)
            };
            if on.as_ref().is_some_and(is_drawn) && !self.pin_of.contains_key(&name.to_string()) {
                self.pin_of.insert(name.to_string(), self.pins.len());
                let zero = Figure::zero();
                self.pins.push(PinPlace {
                    name: name.clone(),
                    at: [zero.clone(), zero],
                    on: None,
                    apart: None,
                });
            }
        }
    }

    /// The points that are declared on links go through them as pins do.
    fn read_points(&mut self) {
        for statement in &self.tree.statements {
            let StatementKind::Point(PointStatement { name, on: Some(on), place }) =
                &statement.kind
            else {
                continue;
            };
            let pin = self.pin_of.get(&name.to_string()).copied();
            let link = self.link_of.get(&on.to_string()).copied();
            let (Some(pin), Some(link)) = (pin, link) else { continue };
            if self.links[link].is_given {
                continue;
            }
            if self.links[link].pins.contains(&pin) {
                let message = format!("`{name}` is a pin of `{on}` already; remove one");
                let reason = "its place on the link follows from the drawing";
                self.report(name, message, reason.to_string());
                continue;
            }
            self.pins[pin].on = Some((link + 1, place));
            self.links[link].points.push(pin);
        }
    }

    fn read_links(&mut self) {
        for (index, statement) in self.tree.statements.iter().enumerate() {
            for link in drawn_links(statement) {
                let pins: Vec<_> = link.pins.iter().filter_map(|pin| self.pin(pin)).collect();
                if let Some(twice) = (1..pins.len()).find(|&i| pins[..i].contains(&pins[i])) {
                    let pin = &link.pins[twice];
                    let message = format!("`{pin}` is named twice; remove one");
                    let reason = format!("`{}` goes through it once", link.name);
                    self.report(pin, message, reason);
                }
                if link.pins.is_empty() && link.on.is_empty() {
                    self.link_has_joints(&link.name);
                }
                let length = self.length_of(statement, link);
                self.link_of.insert(link.name.to_string(), self.links.len());
                let outline = LinkOutline::given(&link.name, pins, index);
                self.links.push(LinkOutline { length, is_given: false, ..outline });
            }
        }
    }

    /// What the braces behind a link say: its length, where it has two pins.
    fn length_of(
        &mut self,
        statement: &'t Statement,
        link: &'t DrawnLink,
    ) -> Option<(&'t Expr, Option<Figure>)> {
        let StatementKind::Link(LinkStatement { links, fields: Some(fields) }) = &statement.kind
        else {
            return None;
        };
        if !links.last().is_some_and(|last| std::ptr::eq(last, link)) {
            return None;
        }
        for field in &fields.fields {
            if field.name != "length" {
                let message = format!("`link` has no field `{}`", field.name);
                let reason = "its only field is `length`; everything else is as drawn";
                self.report(&field.name, message, reason.to_string());
            }
        }
        let field = fields.fields.iter().find(|field| field.name == "length")?;
        if links.len() > 1 || link.pins.len() != 2 {
            let message = "a length is that of one link with two pins".to_string();
            let reason = match link.pins.len() {
                2 => {
                    let (name, pins) = (&link.name, loose::listed_names(&link.pins));
                    format!(
                        "write it in a statement of its own: `link {name}({pins}) {{ length: … }}`"
                    )
                }
                _ => "leave it out: the distances between the pins of this link are as drawn"
                    .to_string(),
            };
            self.report(&field.name, message, reason);
            return None;
        }
        match &field.value {
            GroupFieldValue::One(value) => Some((value, self.values.declared_length(value))),
            GroupFieldValue::Pair(_) => {
                self.report(
                    &field.name,
                    "a link has one length".to_string(),
                    "`length: 2m`".to_string(),
                );
                None
            }
        }
    }

    /// The bodies of groups that are declared, and points that move by themselves.
    fn read_given(&mut self) {
        for (index, statement) in self.tree.statements.iter().enumerate() {
            if let StatementKind::Point(PointStatement { name, on: None, .. }) = &statement.kind
                && let Some(&pin) = self.pin_of.get(&name.to_string())
            {
                self.links.push(LinkOutline::given(name, vec![pin], index));
            }
            let StatementKind::Group(group) = &statement.kind else { continue };
            if self.stands_on_a_drawing(group) {
                continue;
            }
            for leg in &group.legs {
                let joint = leg.joint.iter();
                let pins = joint.chain(&group.pin).chain(self.points_on(&leg.link));
                let pins =
                    pins.filter_map(|pin| self.pin_of.get(&pin.to_string()).copied()).collect();
                self.link_of.insert(leg.link.to_string(), self.links.len());
                self.links.push(LinkOutline::given(&leg.link, pins, index));
            }
        }
    }

    /// True if a group that is declared follows the drawing: it stands on a pin that the drawing makes, and nothing of
    /// the drawing stands on it.
    fn stands_on_a_drawing(&self, group: &GroupStatement) -> bool {
        let is_drawn = |joint: &Ident| self.pin_of.contains_key(&joint.to_string());
        let is_made_by_hand = |joint: &Ident| {
            self.tree.statements.iter().any(|statement| match &statement.kind {
                StatementKind::Group(group) => group.pin.as_ref() == Some(joint),
                StatementKind::Point(PointStatement { name, .. }) => name == joint,
                StatementKind::Ground(GroundStatement { points }) => {
                    points.iter().any(|(name, _)| name == joint)
                }
                _ => false,
            })
        };
        let mut joints = group.legs.iter().filter_map(|leg| leg.joint.as_ref());
        joints.any(|joint| is_drawn(joint) && !is_made_by_hand(joint))
            && group.pin.as_ref().is_some_and(|pin| !is_drawn(pin))
    }

    /// The points that are declared on a link.
    fn points_on(&self, link: &Ident) -> impl Iterator<Item = &'t Ident> {
        let link = link.clone();
        self.tree.statements.iter().filter_map(move |statement| match &statement.kind {
            StatementKind::Point(PointStatement { name, on: Some(on), .. }) if *on == link => {
                Some(name)
            }
            _ => None,
        })
    }

    /// Every pin is one of a link, or of a group.
    fn pins_are_on_bodies(&mut self) {
        for statement in &self.tree.statements {
            let StatementKind::Pin(PinStatement { points }) = &statement.kind else { continue };
            for (name, _) in points {
                let pin = self.pin_of.get(&name.to_string());
                let is_used = pin.is_none_or(|pin| {
                    self.links
                        .iter()
                        .any(|link| link.pins.contains(pin) || link.points.contains(pin))
                });
                if !is_used {
                    let message = format!("no link goes through `{name}`");
                    let outline =
                        self.links.iter().rev().find(|link| !link.is_given && link.pins.len() > 1);
                    let link = outline.map_or("BC(B".to_string(), |link| {
                        let pins = link.pins.iter().map(|&pin| self.pins[pin].name.clone());
                        format!("{}({}", link.name, loose::listed_names(&pins.collect::<Vec<_>>()))
                    });
                    let reason = format!(
                        "name it among the pins of one, `link {link}, {name})`, or leave it out"
                    );
                    self.report_missing(name, message, reason);
                }
            }
        }
    }

    /// A pin by its name.
    pub(in crate::model::drawn) fn pin(&mut self, name: &Ident) -> Option<usize> {
        if let Some(&pin) = self.pin_of.get(&name.to_string()) {
            return Some(pin);
        }
        if name == "ground" {
            let message =
                "a link goes through points of the ground, not through `ground`".to_string();
            self.report(name, message, "name a point: `ground M(…, …);`".to_string());
            return None;
        }
        let names = begun::names(&items(self.tree));
        if names.kind(name) == Some(Kind::Point) {
            let message = format!("`{name}` has no place in the drawing");
            let reason = format!("say where it is drawn: `pin {name}(…, …);`");
            self.report(name, message, reason);
            return None;
        }
        let message = none_is_named("pin", name, self.pins.iter().map(|pin| &pin.name));
        self.report_missing(name, message, format!("say where it is drawn: `pin {name}(…, …);`"));
        None
    }

    /// A body by the name of its link.
    pub(in crate::model::drawn) fn body(&mut self, name: &Ident) -> Option<usize> {
        if name == "ground" {
            return Some(GROUND);
        }
        if let Some(&link) = self.link_of.get(&name.to_string()) {
            return Some(link + 1);
        }
        if let Some(&pin) = self.pin_of.get(&name.to_string()) {
            let through = loose::links_through(&self.links, pin);
            let reason = match through.is_empty() {
                true => "name a link that goes through it".to_string(),
                false => format!("name a link: through `{name}` goes {through}"),
            };
            self.report(name, format!("`{name}` is a point, not a link"), reason);
            return None;
        }
        let message = none_is_named("link", name, self.links.iter().map(|link| link.name));
        let reason = "links are declared with the pins through them: `link BC(B, C);`";
        self.report_missing(name, message, reason.to_string());
        None
    }
}

/// The message about a name that is none of these.
fn none_is_named<'n>(what: &str, name: &Ident, known: impl Iterator<Item = &'n Ident>) -> String {
    let known: Vec<_> = known.map(ToString::to_string).collect();
    match nearest(&name.to_string(), known.iter().map(|name| &name[..])) {
        Some(near) => format!("no {what} named `{name}`; one with a similar name exists: `{near}`"),
        None => format!("no {what} named `{name}`"),
    }
}
