//! Forces that are asked for: `theta.drive`, `AB.drive`, `BC.push`, `BC.B`, `block.rail`, and what is
//! the whole mechanism's: `energy`, `shaking`, `centre_of_mass`.

use proc_macro2::Ident;
use quote::format_ident;
use syn::Attribute;

use super::Resolver;
use super::acting::{Effort, RequestedEffort};
use super::mechanism::{
    Body, Group, InputId, JointKind, LinkId, Mechanism, OutputKind, PointId, Slideway, SpringId,
};
use super::names::{Entity, Kind};
use super::outputs::MEMBERS;
use super::spring_damper::parts;
use crate::syntax::action::ACTING;

/// Outputs of the whole mechanism.
const WHOLE: [&str; 4] = ["energy", "shaking", "centre_of_mass", "losses"];

/// The members that name the effort driving a link.
const EFFORTS: [&str; 2] = ["drive", "push"];

/// Words behind a link that mean something, whatever points are called.
fn is_meant(word: &str) -> bool {
    EFFORTS.contains(&word) || MEMBERS.contains(&word)
}

/// The efforts of a link: each field with its effort.
type Efforts = Vec<(Ident, Effort)>;

impl Resolver<'_> {
    /// Returns true if the output is about a force; it is then resolved or reported.
    pub(super) fn effort_output(
        &mut self,
        docs: &[Attribute],
        owner: &Ident,
        member: &Ident,
    ) -> bool {
        if self.names.kind(owner) == Some(Kind::Spring) {
            self.spring_output(docs, owner, member);
            return true;
        }
        let Some(found) = self.effort_named(owner, member) else { return false };
        if let Some(effort) = found {
            self.ask(docs, owner, member, effort);
        }
        true
    }

    /// The effort that a member is, none inside where that was reported; `None` if it is about no force.
    pub(super) fn effort_named(&mut self, owner: &Ident, member: &Ident) -> Option<Option<Effort>> {
        let word = member.to_string();
        if WHOLE.iter().any(|whole| owner == whole) {
            let message = format!("write `{owner}`");
            let reason = format!("`{word}` is a field of its result");
            self.diagnostics.error_because(member.span(), message, reason);
            return Some(None);
        }
        let is_of_a_drive = ["drive", "push", "force", "torque"].contains(&&word[..]);
        match self.names.kind(owner) {
            Some(Kind::Input) if is_of_a_drive => Some(self.input_effort(owner, member)),
            Some(Kind::Unknown) if is_of_a_drive => Some(self.unknown_effort(owner, member)),
            Some(Kind::Stop) => Some(self.effort_of_stop(owner, member)),
            Some(Kind::Link) if self.names.kind(member) == Some(Kind::Point) && is_meant(&word) => {
                match self.link(owner) {
                    Some(link) if self.touches(link, member) => {
                        self.point_is_renamed(owner, member);
                        Some(None)
                    }
                    Some(link) if EFFORTS.contains(&&word[..]) => {
                        Some(self.driven_effort(owner, link, member))
                    }
                    Some(_) => None,
                    None => Some(None),
                }
            }
            Some(Kind::Link) if EFFORTS.contains(&&word[..]) => {
                let link = self.link(owner);
                Some(link.and_then(|link| self.driven_effort(owner, link, member)))
            }
            Some(Kind::Link) => {
                let is_named =
                    matches!(self.names.kind(member), Some(Kind::Point | Kind::Guide | Kind::Link));
                if !is_named || is_meant(&word) {
                    return None;
                }
                let link = self.link(owner);
                Some(link.and_then(|link| self.joint_effort(owner, link, member)))
            }
            _ => None,
        }
    }

    /// Returns true if the output is one of the whole mechanism; it is then resolved or reported.
    pub(super) fn output_of_the_whole(&mut self, docs: &[Attribute], name: &Ident) -> bool {
        let dynamics = &self.mechanism.dynamics;
        let has_mass = !dynamics.masses.is_empty();
        let has_spring = !dynamics.springs.is_empty() || !dynamics.stops.is_empty();
        match name.to_string().as_str() {
            "energy" if has_mass || has_spring || self.a_force_may_be_unread() => {
                if std::mem::replace(&mut self.mechanism.dynamics.energy, true) {
                    self.diagnostics
                        .error(name.span(), "the output `energy` is given twice; remove one");
                }
            }
            "shaking" if has_mass || self.a_force_may_be_unread() => {
                self.ask(docs, name, name, Effort::Shaking);
            }
            "centre_of_mass" if has_mass || self.a_force_may_be_unread() => {
                self.give(name.span(), name.clone(), docs, OutputKind::CentreOfMass);
            }
            "losses" => {
                if self.something_rubs(name).is_some() {
                    self.ask(docs, name, name, Effort::Losses);
                }
            }
            word @ ("energy" | "shaking" | "centre_of_mass") => {
                let message = match word {
                    "energy" => "nothing has mass and nothing is sprung, so there is no energy",
                    _ => "nothing has mass; declare what has",
                };
                let reason = "as in `mass 2kg on BC uniform`";
                self.diagnostics.error_because(name.span(), message, reason);
            }
            _ => return false,
        }
        true
    }

    fn input_effort(&mut self, owner: &Ident, member: &Ident) -> Option<Effort> {
        if member != "drive" {
            let message = format!("write `{owner}.drive`");
            let reason = "an input's effort is a torque or a force, as the input is";
            self.diagnostics.error_because(member.span(), message, reason);
            return None;
        }
        match self.usable(owner, &[Kind::Input])? {
            Entity::Input(id) => self.has_a_drive(owner, id).map(|()| Effort::Input(id)),
            _ => None,
        }
    }

    /// `AB.drive`, `BC.push`
    fn driven_effort(&mut self, owner: &Ident, link: LinkId, member: &Ident) -> Option<Effort> {
        let efforts = self.efforts_of(link);
        let found = efforts.iter().find(|(field, effort)| {
            field == member && matches!(effort, Effort::Drive(_) | Effort::Push(_))
        });
        if let Some(&(_, effort)) = found {
            if effort == Effort::Drive(link) {
                self.link_has_a_drive(owner, link)?;
            }
            return Some(effort);
        }
        if !self.facts.links[link.index()].is_placed {
            return None;
        }
        let group = &self.mechanism.groups[self.mechanism.links[link.index()].made_by.index()];
        let (message, reason) = match (member == "drive", &group.keyword.to_string()[..]) {
            (true, "crank" | "slider") | (false, _) => (
                format!("no length of `{owner}` is driven, and nothing pushes its ends apart"),
                "`push` is the force of a bar whose length depends on an input".to_string(),
            ),
            (true, keyword) => (
                format!("`{owner}` is a link of `{keyword}` and has no drive"),
                format!("cranks and sliders are driven; {}", self.known_efforts(&efforts, owner)),
            ),
        };
        self.diagnostics.error_because(member.span(), message, reason);
        None
    }

    /// `BC.B`, `block.rail`
    pub(super) fn joint_effort(
        &mut self,
        owner: &Ident,
        link: LinkId,
        member: &Ident,
    ) -> Option<Effort> {
        let efforts = self.efforts_of(link);
        if let Some(&(_, effort)) = efforts.iter().find(|(field, _)| field == member) {
            return Some(effort);
        }
        if !self.facts.links[link.index()].is_placed {
            return None;
        }
        let message = format!("`{owner}` does not touch `{member}`");
        let reason = self.known_efforts(&efforts, owner);
        self.diagnostics.error_because(member.span(), message, reason);
        None
    }

    /// The first link that has the point as a joint.
    pub(super) fn link_that_touches(&self, point: &Ident) -> Option<&Ident> {
        let links = self.mechanism.links.iter().enumerate();
        let mut touching = links.filter(|&(id, _)| self.touches(LinkId(id as u32), point));
        touching.next().map(|(_, link)| &link.name)
    }

    /// True if the point is a joint of the link.
    fn touches(&self, link: LinkId, point: &Ident) -> bool {
        let is_joint = |effort: &Effort| matches!(effort, Effort::Pin(..) | Effort::Bearing(..));
        self.efforts_of(link).iter().any(|(field, effort)| field == point && is_joint(effort))
    }

    /// `AB.drive`, where a joint of `AB` is called `drive`, would be two things.
    fn point_is_renamed(&mut self, owner: &Ident, point: &Ident) {
        let message = format!("rename the point `{point}`");
        let reason = format!(
            "`{owner}.{point}` is something else of every link: the force at that joint needs another \
             name"
        );
        self.diagnostics.error_because(point.span(), message, reason);
    }

    fn known_efforts(&self, efforts: &Efforts, owner: &Ident) -> String {
        let known: Vec<_> = efforts.iter().map(|(field, _)| format!("`{owner}.{field}`")).collect();
        match known.is_empty() {
            true => format!("no force of `{owner}` is known"),
            false => format!("there is {}", super::names::listed(&known, "and")),
        }
    }

    /// The end of a list of a link's members: its forces, where something has mass or acts.
    pub(super) fn forces_too(&self, owner: &Ident) -> String {
        self.forces_of(owner).map_or(String::new(), |known| format!("; of its forces {known}"))
    }

    /// The forces of a link in words, where something has mass or acts.
    pub(super) fn forces_of(&self, owner: &Ident) -> Option<String> {
        let Entity::Link(link) = self.names.entity(owner)? else { return None };
        let efforts = self.efforts_of(link);
        let has_any = !self.mechanism.dynamics.is_empty() && !efforts.is_empty();
        has_any.then(|| self.known_efforts(&efforts, owner))
    }

    pub(super) fn ask(
        &mut self,
        docs: &[Attribute],
        owner: &Ident,
        member: &Ident,
        effort: Effort,
    ) {
        if self.mechanism.dynamics.is_empty() && !self.a_force_may_be_unread() {
            let message =
                format!("nothing has mass and nothing acts, so `{owner}.{member}` is zero");
            let reason = "declare what does: `mass 2kg on BC uniform`, `force (0, -10N) on P`";
            return self.diagnostics.error_because(member.span(), message, reason);
        }
        if self.effort_is_known(member, effort).is_none() {
            return;
        }
        let (own, field) = (owner.clone(), member.clone());
        let asked_for = RequestedEffort { owner: own, field, docs: docs.to_vec(), effort };
        let asked = &mut self.mechanism.dynamics.asked;
        if asked.iter().any(|known| known.effort == effort) {
            return self.output_is_given_twice(member.span(), &asked_for.path());
        }
        // Efforts of one owner form one field of the result.
        let behind = asked.iter().rposition(|known| known.owner == *owner);
        asked.insert(behind.map_or(asked.len(), |last| last + 1), asked_for);
    }

    /// True if a mistake may have hidden a statement that acts.
    pub(super) fn a_force_may_be_unread(&self) -> bool {
        ACTING.iter().any(|word| self.unread.may_hold(word)) || self.diagnostics.count() > 0
    }

    /// Every drive and reaction, where anything has mass or acts.
    pub(super) fn every_effort_is_given(&mut self) {
        let dynamics = &mut self.mechanism.dynamics;
        let has_spring = !dynamics.springs.is_empty() || !dynamics.stops.is_empty();
        dynamics.energy = !dynamics.masses.is_empty() || has_spring;
        if dynamics.is_empty() {
            return;
        }
        let drive = |name: &Ident| Ident::new("drive", name.span());
        let inputs = self.mechanism.inputs.iter().enumerate();
        let inputs: Vec<_> = inputs
            .map(|(index, input)| {
                let id = InputId(index as u32);
                if let Some((_, load)) = dynamics.driven().filter(|(driven, _)| *driven == id) {
                    let [owner, field] = [(); 2].map(|()| load.name.clone());
                    let docs = load.docs.clone();
                    return RequestedEffort { owner, field, docs, effort: Effort::Pull };
                }
                let (owner, field) = (input.name.clone(), drive(&input.name));
                RequestedEffort { owner, field, docs: Vec::new(), effort: Effort::Input(id) }
            })
            .collect();
        let links = (0..self.mechanism.links.len()).map(|index| LinkId(index as u32));
        let links = links.flat_map(|link| {
            let declared = &self.mechanism.links[link.index()];
            self.exerted(link).map(|(field, effort)| RequestedEffort {
                owner: declared.name.clone(),
                field,
                docs: declared.docs.clone(),
                effort,
            })
        });
        let links: Vec<_> = links.collect();
        let springs = self.mechanism.dynamics.springs.iter().enumerate();
        let springs = springs.filter_map(|(index, spring)| {
            let owner = spring.name.clone()?;
            let field = Ident::new(parts(spring.ends)[0], owner.span());
            let effort = Effort::Spring(SpringId(index as u32));
            Some(RequestedEffort { owner, field, docs: spring.docs.clone(), effort })
        });
        let springs: Vec<_> = springs.chain(self.efforts_of_stops()).collect();
        let losses = self.losses_of_all();
        let mut asked: Vec<RequestedEffort> =
            inputs.into_iter().chain(links).chain(springs).chain(losses).collect();
        if !self.mechanism.equations_are_held() {
            asked = self.mechanism.dynamics.what_is_of_power(asked);
        }
        for (nth, known) in asked.iter().enumerate() {
            let is_same =
                |other: &&RequestedEffort| other.owner == known.owner && other.field == known.field;
            // The effort of a drive comes first, and has the span of its link.
            if asked[..nth].iter().any(|other| is_same(&other)) {
                self.point_is_renamed(&known.owner, &known.field);
            }
        }
        self.mechanism.dynamics.asked = asked;
    }

    /// The output `losses`, where anything rubs.
    fn losses_of_all(&self) -> Option<RequestedEffort> {
        let owner = Ident::new("losses", self.mechanism.name.span());
        let (field, effort) = (owner.clone(), Effort::Losses);
        let rubs = !self.mechanism.dynamics.frictions.is_empty();
        rubs.then(|| RequestedEffort { owner, field, docs: Vec::new(), effort })
    }

    /// The efforts of a link but for that of an unknown or a load that drives it, which is none.
    fn exerted(&self, link: LinkId) -> impl Iterator<Item = (Ident, Effort)> + '_ {
        self.efforts_of(link).into_iter().filter(|(_, effort)| match effort {
            Effort::Drive(link) => {
                !self.mechanism.is_driven_by_an_unknown(*link)
                    && self.mechanism.driven_through(*link).is_none()
            }
            _ => true,
        })
    }

    /// Drive, push, joints and guides of a link.
    pub(super) fn efforts_of(&self, link: LinkId) -> Efforts {
        let group = self.mechanism.group_with(link);
        let mut efforts = group.map_or(Vec::new(), |group| self.of_group(group, link));
        // Points of its own that others stand on.
        let mut own: Vec<PointId> = Vec::new();
        for (point, _) in self.mechanism.standing() {
            let is_own = self.mechanism.owner(point) == Some(Body::Link(link));
            if is_own && !own.contains(&point) {
                own.push(point);
            }
        }
        let bearing = |point: PointId| (self.point_name(point), Effort::Bearing(link, point));
        efforts.extend(own.into_iter().map(bearing));
        efforts
    }

    /// The drive of a link of a group, and the reactions of its joints.
    fn of_group(&self, group: &Group, link: LinkId) -> Efforts {
        let Mechanism { links, guides, .. } = &self.mechanism;
        let (mut efforts, mut by_slideways) = (Vec::new(), Vec::new());
        let own = || group.joints().filter(|joint| joint.link() == link);
        if own().any(|joint| joint.drive.is_some()) {
            efforts.push((format_ident!("drive"), Effort::Drive(link)));
        }
        let mut bars = group.links.iter().zip(&group.lengths);
        let length = bars.find_map(|(own, length)| length.as_ref().filter(|_| *own == link));
        if length.is_some_and(|length| self.mechanism.moves(&length.value)) {
            efforts.push((format_ident!("push"), Effort::Push(link)));
        }
        for joint in own() {
            match &joint.kind {
                JointKind::Revolute(point) => {
                    efforts.push((self.point_name(*point), Effort::Pin(link, *point)));
                }
                JointKind::Prismatic { along, .. } => {
                    let by = match along {
                        Slideway::Guide(guide) => &guides[guide.index()].name,
                        Slideway::Bar(by) | Slideway::Slot { link: by, .. } => {
                            &links[by.index()].name
                        }
                    };
                    by_slideways.push((by.clone(), Effort::Guide(link)));
                }
            }
        }
        efforts.extend(by_slideways);
        efforts
    }

    fn point_name(&self, point: PointId) -> Ident {
        self.mechanism.points[point.index()].name.clone()
    }
}
