//! Friction: how a joint's reaction brakes the two bodies that meet there.
//!
//! At a pin of radius r a couple x = μ r |R| against the relative turning, at a guide a force x = μ |N| against
//! the slide. A block of length b that touches its guide at both ends has μ (|N₁| + |N₂|) there, which is
//! μ max(|N|, 2|T|/b). The other body is given the opposite.
//!
//! A pin's μ is couple over radius and load, as bearing catalogues have it: the line of a force that the
//! joint transmits touches the circle of the radius μ r. Coulomb's law at a dry pin's contact is μ = sin φ.
//!
//! # One equation a group
//! Going backwards, what presses a joint is known but for the friction of the group's own joints, and the
//! group's reactions are linear in that. So G and A of the [`system`] are the group's own formulas, of its
//! loads and of a unit of each friction. A driver's pin or guide depends on no friction of its own.
//!
//! # Direction
//! Against the slip w: s = sign w. At w = 0 the motion is just starting, and s = sign ẇ; at rest it is the
//! sign of the slip of a creep. Smoothed it is w/√(w² + e²), of which a creep leaves nothing.
//!
//! Bodies that are rigid with one another do not slip; elsewhere w and ẇ are zero below their [`SlipRounding`].
//!
//! # Source
//! R. L. Norton, Design of Machinery, ch. 11; A. S. Hall, Kinematics and Linkage Design, on friction
//! circles; J. E. Shigley, Mechanical Engineering Design, on bearings.

mod amount;
mod by_load;
mod forward;
mod straight;
mod system;

use crate::equations::forces::drawn_slides::reaction_as_drawn;
use crate::equations::forces::provided::share;
use crate::equations::forces::walk::{Rubs, Walk};
use crate::equations::jet::Jet;
use crate::equations::kinematics::Kinematics;
use crate::equations::reactions::{Acting, Inner, Loads, Reaction, Reactions};
use crate::equations::slip_rounding::SlipRounding;
use crate::equations::symbol::{Sym, Vector};
use crate::model::acting::{Contact, Effort, Friction};
use crate::model::mechanism::{Carrier, Group, Mechanism};
use crate::model::rigid::RigidBodies;
use amount::Row;
pub(super) use by_load::walked as walked_by_load;
pub(super) use forward::accelerations;
pub(in crate::equations) use forward::is_offered;
pub use system::amounts_of;
use system::solved;

/// The place of a contact in the group whose reactions press it.
#[derive(Clone, Copy)]
enum ContactPlace {
    /// The outer joint of the link with this index.
    Outer(usize),
    /// The inner pin, on the link with this index.
    Pin(usize),
    /// The first link in the second.
    Slide,
}

/// A contact that rubs.
struct Rubbing<'s> {
    friction: usize,
    contact: Contact,
    place: ContactPlace,
    /// Coefficient, of a pin times the radius.
    share: Sym<'s>,
    /// Factor of a guide's couple: 2/b, or zero where it does not count.
    by_couple: Sym<'s>,
    /// The sign s.
    way: Sym<'s>,
}

impl<'s> Rubbing<'s> {
    /// The equation of its amount, given what presses it without friction and what a unit of each amount changes
    /// in that.
    fn row(
        &self,
        mechanism: &Mechanism,
        free: [Sym<'s>; 2],
        changes: impl Iterator<Item = [Sym<'s>; 2]>,
    ) -> Row<'s> {
        Row {
            share: self.share,
            free,
            changes: changes.collect(),
            is_guide: matches!(self.contact, Contact::Guide(_)),
            joint: mechanism.contact_name(self.contact),
        }
    }
}

/// Reactions that press the contacts, as a walk has found them.
fn pressed<'s>(walk: &Walk<'_, 's>, contacts: &[Rubbing<'s>]) -> Vec<[Sym<'s>; 2]> {
    let of = |contact: &Rubbing<'s>| match (
        contact.contact,
        &walk.components(contact.contact.pressed_by())[..],
    ) {
        (Contact::Guide(_), &[normal, couple]) => [normal, contact.by_couple * couple],
        (Contact::Pin { .. }, &[x, y]) => [x, y],
        _ => unreachable!("a reaction has two components"),
    };
    contacts.iter().map(of).collect()
}

/// The slip of the link against the other body, and its rate.
pub fn slip<'s>(state: &Kinematics<'s>, contact: Contact) -> [Sym<'s>; 2] {
    if RigidBodies::of(state.mechanism).hold(state.mechanism, contact) {
        return [state.builder.zero(); 2];
    }
    match contact {
        Contact::Guide(link) => {
            let Jet { rate, accel, .. } = state.link(link).slide.expect("it slides");
            [rate, accel]
        }
        Contact::Pin { link, against, .. } => {
            let (own, other) = (state.link(link).frame, state.carrier(against));
            let (own, other) = (own.direction, other.direction);
            [own.omega - other.omega, own.alpha - other.alpha]
        }
    }
}

/// The sign of a dry slip: at zero that of a motion that starts, in a creep none. `rounding` bounds the slip's and that
/// of its rate; below it a number is zero.
fn dry<'s>(
    [slip, starting]: [Sym<'s>; 2],
    creeps: bool,
    rounding: impl FnOnce() -> [Sym<'s>; 2],
) -> Sym<'s> {
    let zero = slip.builder().zero();
    if slip.is_zero() && (creeps || starting.is_zero()) {
        return zero;
    }
    let is_exact = slip.is_multiple_of_input() && starting.is_multiple_of_input();
    let [least, least_starting] = if is_exact { [zero; 2] } else { rounding() };
    let starting = match () {
        () if creeps => zero,
        () if least_starting.is_zero() => starting,
        () => least_starting.at_least(starting.magnitude(), zero, starting),
    };
    let number = match () {
        () if slip.is_zero() => starting,
        () if !least.is_zero() => least.at_least(slip.magnitude(), starting, slip),
        () if creeps => slip,
        // The number that decides, then its sign: two choices and three.
        () => slip.at_least(zero, zero.at_least(slip, starting, slip), slip),
    };
    number.sign_or(zero)
}

impl<'k, 's> Walk<'k, 's> {
    /// Puts the friction of a group's joints on the bodies that meet there.
    pub(super) fn rub(&mut self, group: &Group) {
        if matches!(self.rubs, Rubs::Never) {
            return;
        }
        let contacts = self.contacts_of(group);
        if contacts.is_empty() {
            return;
        }
        let free = self.pressing(group, &self.loads_on(group), &contacts, None);
        let changes: Vec<_> = (contacts.iter())
            .map(|contact| {
                self.pressing(group, &self.unit(group, contact), &contacts, Some(contact))
            })
            .collect();
        let mechanism = self.kinematics.mechanism;
        let rows = contacts
            .iter()
            .enumerate()
            .map(|(j, contact)| contact.row(mechanism, free[j], changes.iter().map(|by| by[j])));
        let rows: Vec<_> = rows.collect();
        for (contact, amount) in contacts.iter().zip(solved(&rows)) {
            self.brake(contact, amount);
        }
    }

    /// A walk under nothing but what `act` puts on it.
    fn under(kinematics: &'k Kinematics<'s>, act: impl FnOnce(&mut Self)) -> Self {
        let mut walk = Self::start(kinematics, Rubs::Never);
        act(&mut walk);
        walk.back();
        walk
    }

    /// All contacts that rub.
    fn contacts(&self) -> Vec<Rubbing<'s>> {
        let groups = self.kinematics.mechanism.group_steps();
        groups.flat_map(|group| self.contacts_of(group)).collect()
    }

    fn contacts_of(&self, group: &Group) -> Vec<Rubbing<'s>> {
        let frictions = self.kinematics.mechanism.dynamics.frictions.iter().enumerate();
        let own = frictions.filter(|(_, friction)| group.links.contains(&friction.contact.link()));
        let rubbing = own.map(|(index, friction)| self.rubbing(group, index, friction));
        rubbing.filter(|rubbing| !rubbing.share.is_zero() && !rubbing.way.is_zero()).collect()
    }

    fn rubbing(&self, group: &Group, friction: usize, declared: &Friction) -> Rubbing<'s> {
        let (kinematics, title) = (self.kinematics, group.id.0);
        let index = group.links.iter().position(|link| *link == declared.contact.link());
        let index = index.expect("the group makes the link");
        let place = match declared.contact {
            Contact::Pin { pin, .. } if group.pin == Some(pin) && group.links.len() == 2 => {
                ContactPlace::Pin(index)
            }
            Contact::Guide(_) if group.outer[index].guide().is_none() => ContactPlace::Slide,
            Contact::Pin { .. } | Contact::Guide(_) => ContactPlace::Outer(index),
        };
        let length = declared.length.as_ref().map(|b| kinematics.length(b, title).value);
        let by_couple = length.map_or(self.builder().zero(), |b| self.builder().integer(2) / b);
        let share = share(kinematics, declared, title);
        let share = if let Rubs::Sticking(_, times) = self.rubs { times * share } else { share };
        let way = if share.is_zero() { share } else { self.way(declared, title) };
        Rubbing { friction, contact: declared.contact, place, share, by_couple, way }
    }

    /// The state whose slips friction is against.
    fn slipping(&self) -> &Kinematics<'s> {
        match self.rubs {
            Rubs::Creeping(state) | Rubs::Sticking(state, _) => state,
            Rubs::Slipping | Rubs::Never => self.kinematics,
        }
    }

    pub fn slip(&self, contact: Contact) -> [Sym<'s>; 2] {
        slip(self.slipping(), contact)
    }

    fn way(&self, friction: &Friction, title: u32) -> Sym<'s> {
        let state = self.slipping();
        let creeps = matches!(self.rubs, Rubs::Creeping(_) | Rubs::Sticking(..));
        let Some(smooth) = &friction.smooth else {
            let contact = friction.contact;
            let rounding =
                || self.rounding.get_or_init(|| SlipRounding::of(state)).of_slip(contact);
            return dry(slip(state, contact), creeps, rounding);
        };
        if creeps {
            return self.builder().zero();
        }
        let [slip, _] = self.slip(friction.contact);
        slip / slip.hypot(self.kinematics.length(smooth, title).value)
    }

    /// The loads on a group of a unit of friction at one of its joints.
    fn unit(&self, group: &Group, contact: &Rubbing<'s>) -> Loads<'s> {
        let (zero, nothing) = (self.builder().zero(), self.builder().zero_vector());
        let mut links = [Acting { force: nothing, moment: zero }; 2];
        let (back, mut along) = (-contact.way, zero);
        let direction = |index: usize| self.kinematics.link(group.links[index]).frame.direction.u;
        match (contact.contact, contact.place) {
            (Contact::Pin { .. }, ContactPlace::Pin(index)) => {
                (links[index].moment, links[1 - index].moment) = (back, contact.way);
            }
            (Contact::Pin { .. }, ContactPlace::Outer(index)) => links[index].moment = back,
            (Contact::Guide(_), ContactPlace::Outer(index)) => {
                links[index].force = back * direction(index);
            }
            (Contact::Guide(_), _) => {
                (links[0].force, along) = (back * direction(0), back);
            }
            (Contact::Pin { .. }, ContactPlace::Slide) => unreachable!("a pin does not slide"),
        }
        Loads { links, pin: nothing, along }
    }

    /// The reaction at each contact under these loads, or under a unit of friction at one: both components, as sizes
    /// are taken of them.
    fn pressing(
        &self,
        group: &Group,
        loads: &Loads<'s>,
        contacts: &[Rubbing<'s>],
        braked: Option<&Rubbing<'s>>,
    ) -> Vec<[Sym<'s>; 2]> {
        let (outer, by_pin, slide) = match group.links.len() {
            1 => (vec![self.by_driver(&group.outer[0], loads.links[0])], Vec::new(), None),
            _ => {
                let Reactions { outer, inner } = self.kinematics.levers(group.id).reactions(loads);
                match inner {
                    Inner::Pin(forces) => (outer.into(), forces.to_vec(), None),
                    Inner::Slide(reaction) => (outer.into(), Vec::new(), Some(reaction)),
                }
            }
        };
        let components = |contact: &Rubbing<'s>, reaction: &Reaction<'s>| match reaction {
            Reaction::Force(Vector { x, y }) => [*x, *y],
            Reaction::Guide(guide) => {
                let along = self.along(group, contact, braked);
                let by = contact.contact.link();
                let guide = reaction_as_drawn(self.kinematics, by, *guide, along);
                [guide.normal, contact.by_couple * guide.couple]
            }
        };
        let of = |contact: &Rubbing<'s>| match contact.place {
            ContactPlace::Outer(index) => components(contact, &outer[index]),
            ContactPlace::Pin(index) => components(contact, &Reaction::Force(by_pin[index])),
            ContactPlace::Slide => {
                let reaction = slide.expect("its first link slides in the second");
                components(contact, &Reaction::Guide(reaction))
            }
        };
        contacts.iter().map(of).collect()
    }

    /// The force along the guide at a contact, under what is on the links or under a unit of friction. A driver
    /// balances that of its own contact.
    fn along(&self, group: &Group, contact: &Rubbing<'s>, braked: Option<&Rubbing<'s>>) -> Sym<'s> {
        let by = contact.contact.link();
        match (braked, group.links.len()) {
            (None, 1) => {
                let u = self.kinematics.link(by).frame.direction.u;
                -self.links[by.index()].force.dot(u)
            }
            (None, _) => self.slide(by),
            (Some(braked), 2) if braked.friction == contact.friction => -contact.way,
            (Some(_), _) => self.builder().zero(),
        }
    }

    /// A unit of friction and its opposite, so many times.
    fn brake(&mut self, contact: &Rubbing<'s>, amount: Sym<'s>) {
        let braking = contact.way * amount;
        match contact.contact {
            Contact::Pin { link, against, .. } => {
                self.turn(Carrier::Link(link), -braking);
                self.turn(against, braking);
            }
            Contact::Guide(link) => self.push_slide(link, -braking),
        }
        let [slip, _] = self.slip(contact.contact);
        self.losses = self.losses + braking * slip;
        self.amounts.insert(contact.friction, amount);
        self.braking.insert(contact.friction, braking);
    }

    /// The couple of friction on a link at a pin, or the force along its slide.
    pub(super) fn friction_on(&self, asked: Effort) -> Sym<'s> {
        let frictions = self.kinematics.mechanism.dynamics.frictions.iter().enumerate();
        frictions.fold(self.builder().zero(), |sum, (index, friction)| {
            let Some(braking) = self.braking.get(&index).copied() else { return sum };
            match (asked, friction.contact) {
                (Effort::GuideFriction(on), Contact::Guide(by)) if on == by => {
                    let drawn = self.kinematics.mechanism.slide_as_drawn(by);
                    match drawn.is_some_and(|slide| slide.is_reversed) {
                        true => sum + braking,
                        false => sum - braking,
                    }
                }
                (Effort::PinFriction(on, at), Contact::Pin { link, pin, against }) if at == pin => {
                    match () {
                        () if on == link => sum - braking,
                        () if Carrier::Link(on) == against => sum + braking,
                        () => sum,
                    }
                }
                _ => sum,
            }
        })
    }
}
