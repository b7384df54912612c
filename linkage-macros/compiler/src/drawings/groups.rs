//! The groups that are found in machines of textbooks and in eight-bars.

use super::{Case, cases};
use crate::diagnostics::Diagnostics;
use crate::model::mechanism::{Mechanism, Mode, Sign, Step};
use crate::syntax::anatomy::{Anatomy, Modes};
use crate::{model, syntax};

/// The mechanism of a machine, or what is said of it.
fn resolved(case: &Case) -> Result<Mechanism, Vec<String>> {
    let mut diagnostics = Diagnostics::new();
    let tokens = case.declaration().parse().expect("these are tokens");
    let tree = syntax::parse(tokens, &mut diagnostics).expect("it has a name");
    let mechanism = model::resolve(&tree, &mut diagnostics).ok();
    let mistakes = diagnostics.into_mistakes();
    match mechanism {
        Some(mechanism) => Ok(mechanism),
        None => Err(mistakes.iter().map(|mistake| mistake.text()).collect()),
    }
}

/// The groups of a mechanism, the links of each in the order of the alphabet.
fn groups(mechanism: &Mechanism) -> Vec<String> {
    let drawn = mechanism.steps.iter().filter_map(|step| group(mechanism, step));
    drawn.collect()
}

fn group(mechanism: &Mechanism, step: &Step) -> Option<String> {
    let Step::Group(group) = step else { return None };
    let (mode, of_group) = (group.mode(), &group.links);
    let keyword = mechanism.groups[group.id.index()].keyword.to_string();
    let modes = Anatomy::of(&keyword).and_then(|anatomy| anatomy.modes);
    let mode = mode.zip(modes.map(Modes::words));
    let mut links: Vec<_> =
        of_group.iter().map(|link| mechanism.links[link.index()].name.to_string()).collect();
    let is_sorted = links.is_sorted();
    let swaps = !is_sorted && ["rrr", "prp", "rpr"].contains(&&keyword[..]);
    let mode = mode.map(|(mode, words)| {
        let is_plus = matches!(mode, Mode::Fixed(Sign::Plus));
        words[usize::from(is_plus == swaps)]
    });
    if swaps {
        links.reverse();
    }
    let parts = [keyword].into_iter().chain(links).chain(mode.map(String::from));
    Some(parts.collect::<Vec<_>>().join(" "))
}

#[test]
fn the_groups_are_those_expected() {
    let mut count = 0;
    for case in cases() {
        let mut expected = case.expected.clone();
        expected.sort_unstable();
        match resolved(&case) {
            Ok(mechanism) => {
                let mut found = groups(&mechanism);
                found.sort();
                assert_eq!(found, expected, "{}", case.name);
                count += 1;
            }
            Err(messages) => {
                let is_higher = expected[0].starts_with("group") || expected[0].starts_with("two");
                assert!(is_higher || expected == ["refused"], "{}: {messages:?}", case.name);
            }
        }
    }
    assert!(count == 25, "{count} machines are dyads alone");
}
