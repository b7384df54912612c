//! Freedoms and constraints counted: what is too many, what is loose, and which bodies are a group.
//!
//! A body has three freedoms and a pin two; a body that a pin goes through has two constraints with
//! it, a slide is two and a drive one between its bodies. Each constraint is held by one of the two
//! that it is between, no more of them than it has freedoms: a maximum matching, found by
//! augmenting paths. What cannot be held is too many, and what can hold more is loose. Where all fits,
//! the holder of a constraint depends on the other end, and the strongly connected components of
//! this dependence are the groups (Shai, Servatius, Whiteley 2012; the count is that of
//! the pebble game of Lee and Streinu 2008).

use super::Trouble;
use super::machine::{GROUND, Machine};

/// The freedoms of a body.
const BODY: usize = 3;
/// The freedoms of a pin.
const PIN: usize = 2;
/// The most bodies of which each is tried as the one that stands still.
const TRIED: usize = 64;

/// One constraint between two nodes: bodies, then pins.
struct Unit {
    ends: [usize; 2],
    drive: Option<usize>,
}

/// Constraints, and the node that holds each.
struct Network {
    capacity: Vec<usize>,
    units: Vec<Unit>,
    /// The node that holds each unit.
    holder: Vec<Option<usize>>,
    /// The count of units that each node holds.
    held: Vec<usize>,
}

impl Network {
    /// All constraints of the machine, with this body at rest.
    fn of(machine: &Machine, root: usize) -> Self {
        let bodies = machine.bodies.len();
        let rests = |body: usize| body == root || machine.bodies[body].given.is_some();
        let counts = |body: usize| !(root != GROUND && machine.bodies[body].given.is_some());
        let mut capacity: Vec<_> =
            (0..bodies).map(|body| if rests(body) { 0 } else { BODY }).collect();
        let mut units = Vec::new();
        let mut add = |ends: [usize; 2], count: usize, drive: Option<usize>| {
            (0..count).for_each(|_| units.push(Unit { ends, drive }));
        };
        for pin in 0..machine.pins.len() {
            // A body that is given stands on others by other means.
            let has = |&body: &usize| counts(body) && !machine.stands_on(body, pin);
            let (resting, moving): (Vec<_>, Vec<_>) =
                machine.at(pin).filter(has).partition(|&body| rests(body));
            // All bodies at rest count as one body through the pin.
            let through: Vec<_> = resting.into_iter().take(1).chain(moving).collect();
            capacity.push(if through.len() > 1 { PIN } else { 0 });
            if through.len() > 1 {
                through.iter().for_each(|&body| add([body, bodies + pin], PIN, None));
            }
        }
        for slide in &machine.slides {
            if counts(slide.body) && counts(slide.carrier) {
                add([slide.body, slide.carrier], 2, None);
            }
        }
        for (index, drive) in machine.drives.iter().enumerate() {
            if drive.bodies.into_iter().all(counts) {
                add(drive.bodies, 1, Some(index));
            }
        }
        let (holder, held) = (vec![None; units.len()], vec![0; capacity.len()]);
        Self { capacity, units, holder, held }
    }

    /// Lets every unit be held, drives last. Of the first that cannot be, the nodes that are full.
    fn fill(&mut self) -> Option<Vec<usize>> {
        let mut first = None;
        for unit in 0..self.units.len() {
            let mut seen = vec![false; self.capacity.len()];
            if !self.place(unit, &mut seen) && first.is_none() {
                first = Some((0..seen.len()).filter(|&node| seen[node]).collect());
            }
        }
        first
    }

    /// Finds a holder for a unit along an augmenting path.
    fn place(&mut self, unit: usize, seen: &mut [bool]) -> bool {
        // Nodes to look at, and the unit that would move there.
        let mut open: Vec<_> = self.units[unit].ends.iter().map(|&end| (end, unit)).collect();
        let mut came = vec![None; self.capacity.len()];
        while let Some((node, moved)) = open.pop() {
            if std::mem::replace(&mut seen[node], true) {
                continue;
            }
            came[node] = Some(moved);
            if self.held[node] < self.capacity[node] {
                self.shift(node, &came);
                return true;
            }
            for (held, holder) in self.holder.iter().enumerate() {
                if *holder == Some(node) {
                    let [a, b] = self.units[held].ends;
                    open.push((if a == node { b } else { a }, held));
                }
            }
        }
        false
    }

    /// Moves units along the path that ends at a node with room.
    fn shift(&mut self, end: usize, came: &[Option<usize>]) {
        self.held[end] += 1;
        let mut node = end;
        while let Some(unit) = came[node] {
            match self.holder[unit].replace(node) {
                Some(before) => node = before,
                None => return,
            }
        }
    }

    /// The nodes that can hold more, and those that could if units were moved.
    fn loose(&self) -> Vec<bool> {
        let mut loose: Vec<_> =
            self.held.iter().zip(&self.capacity).map(|(held, capacity)| held < capacity).collect();
        loop {
            let mut grew = false;
            for (unit, holder) in self.units.iter().zip(&self.holder) {
                let Some(holder) = *holder else { continue };
                if !loose[holder] && unit.ends.iter().any(|&end| loose[end]) {
                    loose[holder] = true;
                    grew = true;
                }
            }
            if !grew {
                return loose;
            }
        }
    }
}

/// The bodies and drives whose freedoms and constraints do not match.
pub fn troubles(machine: &Machine) -> Vec<Trouble> {
    let mut network = Network::of(machine, GROUND);
    let full = network.fill();
    let mut troubles = Vec::new();
    if let Some(full) = full {
        troubles.push(too_many(machine, GROUND, &full));
    }
    if machine.bodies.len() <= TRIED {
        let floating = (1..machine.bodies.len()).filter(|&body| !machine.is_given(body));
        let found = floating.filter_map(|body| {
            let full = Network::of(machine, body).fill()?;
            Some(too_many(machine, body, &full))
        });
        let smallest = troubles.drain(..).chain(found).min_by_key(|trouble| match trouble {
            Trouble::TooMany { bodies, .. } => bodies.len(),
            _ => usize::MAX,
        });
        troubles.extend(smallest);
    }
    let loose = network.loose();
    let freedoms = network.capacity.iter().sum::<usize>() - network.held.iter().sum::<usize>();
    let bodies: Vec<_> = (0..machine.bodies.len()).filter(|&body| loose[body]).collect();
    if freedoms > 0 {
        troubles.push(Trouble::Loose { bodies, freedoms });
    }
    troubles
}

/// The bodies among nodes that are full, and how free they would be without their drives.
fn too_many(machine: &Machine, root: usize, full: &[usize]) -> Trouble {
    let count = machine.bodies.len();
    let bodies: Vec<_> = (0..count).filter(|body| *body == root || full.contains(body)).collect();
    let holds = |body: &usize| bodies.contains(body);
    let drives: Vec<_> = (0..machine.drives.len())
        .filter(|&drive| machine.drives[drive].bodies.iter().all(holds))
        .collect();
    let pins: usize = (0..machine.pins.len())
        .map(|pin| machine.at(pin).filter(holds).count().saturating_sub(1) * 2)
        .sum();
    let slides = machine.slides.iter().filter(|s| holds(&s.body) && holds(&s.carrier)).count() * 2;
    let freedoms = (BODY * (bodies.len() - 1)).saturating_sub(pins + slides);
    Trouble::TooMany { bodies, drives, freedoms }
}

/// The bodies of each group, every group behind those that it depends on. All constraints can be
/// held.
pub fn groups(machine: &Machine) -> Vec<Vec<usize>> {
    let mut network = Network::of(machine, GROUND);
    network.fill();
    let reached = reached(&dependence(machine, &network));
    let bodies = machine.bodies.len();
    let mut open: Vec<Vec<usize>> = Vec::new();
    for body in (1..bodies).filter(|&body| !machine.is_given(body)) {
        let among = |group: &&mut Vec<usize>| reached[group[0]][body] && reached[body][group[0]];
        match open.iter_mut().find(among) {
            Some(group) => group.push(body),
            None => open.push(vec![body]),
        }
    }
    let mut ordered = Vec::new();
    while !open.is_empty() {
        let is_next = |group: &Vec<usize>| {
            let others = open.iter().filter(|other| *other != group);
            !others.flatten().any(|&other| reached[group[0]][other])
        };
        let next = open.iter().position(is_next).unwrap_or(0);
        ordered.push(open.remove(next));
    }
    ordered
}

/// The nodes that each node depends on.
fn dependence(machine: &Machine, network: &Network) -> Vec<Vec<usize>> {
    let bodies = machine.bodies.len();
    let mut needs = vec![Vec::new(); network.capacity.len()];
    for (unit, holder) in network.units.iter().zip(&network.holder) {
        let Some(holder) = *holder else { continue };
        needs[holder].extend(unit.ends.iter().copied().filter(|&end| end != holder));
        if let Some(drive) = unit.drive {
            needs[holder].extend(&machine.drives[drive].reads);
        }
    }
    for (body, of) in machine.bodies.iter().enumerate() {
        needs[body].extend(&of.reads);
        if let Some(given) = &of.given {
            needs[body].extend(&given.bodies);
            needs[body].extend(given.pins.iter().map(|pin| bodies + pin));
            // The pin of one body alone is no joint that counts.
            for &pin in &given.pins {
                let mut moving = machine.at(pin).filter(|&other| !machine.is_given(other));
                if let (Some(only), None) = (moving.next(), moving.next()) {
                    needs[body].push(only);
                }
            }
            of.made().for_each(|pin| needs[bodies + pin].push(body));
        }
    }
    needs
}

/// The nodes that each node depends on, directly or through others.
fn reached(needs: &[Vec<usize>]) -> Vec<Vec<bool>> {
    let from = |node: usize| {
        let mut reached = vec![false; needs.len()];
        let mut open = vec![node];
        while let Some(next) = open.pop() {
            let new =
                needs[next].iter().filter(|&&need| !std::mem::replace(&mut reached[need], true));
            open.extend(new.copied().collect::<Vec<_>>());
        }
        reached
    };
    (0..needs.len()).map(from).collect()
}
