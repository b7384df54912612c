//! Forces of what stands in: every drive and every joint of every link, whatever is asked.

use proc_macro2::Ident;

use crate::model::dynamics::{Asked, Effort, Ends, Mass, MassPlace, Quantity, Spring};
use crate::model::mechanism::{Carrier, InputId, LinkId, PointId, SpringId};
use crate::model::springs::parts;
use crate::syntax::action::{ACTING, Action};
use crate::syntax::anatomy::{Anatomy, Pin};
use crate::syntax::tree::{Declaration, Group, StatementKind};

use super::{StandIn, Thing, zero};

impl StandIn {
    /// Nothing where nothing can have mass or act.
    pub(super) fn give_forces(&mut self, declaration: &Declaration) {
        let statements = || declaration.statements.iter().map(|statement| &statement.kind);
        let acts = |kind: &StatementKind| matches!(kind, StatementKind::Action(action) if !matches!(action, Action::Gravity { .. }));
        if !statements().any(acts) && !ACTING.iter().any(|word| declaration.unread.may_hold(word)) {
            return;
        }
        self.mechanism.dynamics.energy = true;
        // Where it is says nothing: it is there for what is offered where something has mass.
        let (mass, inertia) = (number(), number());
        let place = MassPlace::Pin(PointId(0));
        self.mechanism.dynamics.masses.push(Mass { place, mass, inertia });
        for index in 0..self.mechanism.inputs.len() {
            let input = self.mechanism.inputs[index].name.clone();
            self.ask(&input, "drive", Effort::Input(InputId(index as u32)));
        }
        for kind in statements() {
            match kind {
                StatementKind::Group(group) => self.give_forces_of(group),
                StatementKind::Action(Action::Spring { name: Some(name), ends, .. }) => {
                    self.give_spring(name, ends);
                }
                _ => {}
            }
        }
        let origin = Ident::new("shaking", declaration.name.span());
        self.ask(&origin, "shaking", Effort::Shaking);
    }

    fn give_forces_of(&mut self, group: &Group) {
        let Some(anatomy) = Anatomy::of(&group.keyword.to_string()) else { return };
        for (leg, slides) in group.legs.iter().zip(anatomy.slides) {
            let Some(&Thing::Link(link)) = self.things.get(&leg.link.to_string()) else { continue };
            let owner = &leg.link;
            if !anatomy.is_dyad() {
                self.ask(owner, "drive", Effort::Drive(link));
            }
            if anatomy.has_length() {
                self.ask(owner, "push", Effort::Push(link));
            }
            for joint in leg.joint.iter().chain(&group.pin) {
                // A name that nothing declares is that of a guide where the joint is prismatic.
                let is_guide = self.guides.contains(joint)
                    || slides && !self.things.contains_key(&joint.to_string());
                match is_guide {
                    true => self.ask(owner, &joint.to_string(), Effort::Guide(link)),
                    false => self.give_pin(owner, link, joint),
                }
            }
            if matches!(anatomy.pin, Pin::None(_))
                && let Some(other) = group.legs.iter().find(|other| other.link != *owner)
            {
                self.ask(owner, &other.link.to_string(), Effort::Guide(link));
            }
        }
    }

    fn give_pin(&mut self, owner: &Ident, link: LinkId, joint: &Ident) {
        if let Some(&Thing::Point(point, _)) = self.things.get(&joint.to_string()) {
            self.ask(owner, &joint.to_string(), Effort::Pin(link, point));
        }
    }

    fn give_spring(&mut self, name: &Ident, ends: &[Ident; 2]) {
        let is_body = |end: &Ident| {
            end == "ground" || matches!(self.things.get(&end.to_string()), Some(Thing::Link(_)))
        };
        let of_points = self.mechanism.points.first().map(|_| Ends::Points([PointId(0); 2]));
        let ends = match of_points {
            Some(points) if !ends.iter().any(is_body) => points,
            _ => Ends::Bodies([Carrier::Ground; 2]),
        };
        let [what, length] = parts(ends);
        let springs = &mut self.mechanism.dynamics.springs;
        let id = SpringId(springs.len() as u32);
        springs.push(Spring {
            name: Some(name.clone()),
            docs: Vec::new(),
            ends,
            stiffness: number(),
            damping: number(),
            free: number(),
        });
        self.ask(name, what, Effort::Spring(id));
        self.push(Ident::new(&format!("{name}_{length}"), name.span()), super::value());
    }

    /// Asks once for every field.
    fn ask(&mut self, owner: &Ident, field: &str, effort: Effort) {
        let asked = &mut self.mechanism.dynamics.asked;
        if asked.iter().any(|known| known.owner == *owner && known.field == field) {
            return;
        }
        let behind = asked.iter().rposition(|known| known.owner == *owner);
        let (owner, field) = (owner.clone(), Ident::new(field, owner.span()));
        let new = Asked { owner, field, docs: Vec::new(), effort };
        asked.insert(behind.map_or(asked.len(), |last| last + 1), new);
    }
}

fn number() -> Quantity {
    Quantity { value: zero(), name: String::new() }
}
