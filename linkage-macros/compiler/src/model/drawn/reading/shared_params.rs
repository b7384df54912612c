//! Parameters in the places of pins: one that moves a pin changes every link that is drawn through it.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::diagnostics::Diagnostics;
use crate::syntax::tree::{Declaration, GroundStatement, PinStatement, Statement, StatementKind};

use crate::model::drawn::outline::bodies::{Bodies, LinkOutline};

/// The parameters in the places of pins, and where they stand.
struct PlacedBy<'t> {
    /// By pin.
    params: HashMap<&'t Ident, HashSet<Ident>>,
    /// By parameter, the first place and its pin, in the order of the source.
    first: Vec<(Ident, &'t Ident)>,
}

impl<'t> PlacedBy<'t> {
    fn of(tree: &'t Declaration) -> Self {
        let params: HashSet<&Ident> = tree.statements.iter().filter_map(param).collect();
        let mut placed = Self { params: HashMap::new(), first: Vec::new() };
        let mut known = HashSet::new();
        for statement in &tree.statements {
            let (points, is_pin) = match &statement.kind {
                StatementKind::Pin(PinStatement { points }) => (points, true),
                StatementKind::Ground(GroundStatement { points }) => (points, false),
                _ => continue,
            };
            for (pin, at) in points {
                let mut note = |name: &Ident| {
                    if !params.contains(name) {
                        return;
                    }
                    placed.params.entry(pin).or_default().insert(name.clone());
                    if is_pin && known.insert(name.clone()) {
                        placed.first.push((name.clone(), pin));
                    }
                };
                at.iter().for_each(|coordinate| coordinate.each_name(&mut note));
            }
        }
        placed
    }

    /// True if the parameter moves some pins of the link, and others not.
    fn changes(&self, bodies: &Bodies<'_>, link: &LinkOutline<'_>, param: &Ident) -> bool {
        let moves = |pin: &usize| {
            let params = self.params.get(&bodies.pins[*pin].name);
            params.is_some_and(|params| params.contains(param))
        };
        let moved = link.pins.iter().filter(|pin| moves(pin)).count();
        link.length.is_none() && moved > 0 && moved < link.pins.len()
    }
}

fn param(statement: &Statement) -> Option<&Ident> {
    match &statement.kind {
        StatementKind::Param(param) => Some(&param.name),
        _ => None,
    }
}

/// Notes a parameter that places a pin and so changes several links.
pub(in crate::model::drawn) fn note_params_of_pins(
    bodies: &Bodies<'_>,
    diagnostics: &mut Diagnostics,
) {
    let placed = PlacedBy::of(bodies.tree);
    for (param, pin) in &placed.first {
        let links = bodies.links.iter().enumerate().filter(|(_, link)| !link.is_given);
        let changed: Vec<_> = links
            .filter(|(_, link)| placed.changes(bodies, link, param))
            .map(|(index, _)| index + 1)
            .collect();
        if changed.len() < 2 {
            continue;
        }
        let message =
            format!("`{param}` moves `{pin}`, and so changes {}", bodies.listed(&changed));
        let reason = format!(
            "to change the length of one link, draw `{pin}` with numbers and give it to the link: \
             `{{ length: {param} }}`"
        );
        diagnostics.note_because(param.span(), message, reason);
    }
}
