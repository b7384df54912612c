//! The groups that are found in machines of textbooks and in eight-bars.

use super::Case;
use super::machine::documentation;
use crate::diagnostics::Diagnostics;
use crate::model::mechanism::{LinkId, Mechanism, Mode, Sign, Step};
use crate::syntax::anatomy::{GroupSpec, Modes};
use crate::{model, syntax};

/// The mechanism that statements make, or what is said of it.
pub(super) fn resolved_text(statements: &str) -> Result<Mechanism, Vec<String>> {
    let mut diagnostics = Diagnostics::new();
    let tokens = format!("pub struct M {{ {statements} }}").parse().expect("these are tokens");
    let tree = syntax::parse(tokens, &mut diagnostics).expect("it has a name");
    let mechanism = model::resolve(&tree, &mut diagnostics).ok();
    let mistakes = diagnostics.into_mistakes();
    match mechanism {
        Some(mechanism) => Ok(mechanism),
        None => Err(mistakes.iter().map(|mistake| mistake.text()).collect()),
    }
}

/// The groups of a mechanism, the links of each in the order of the alphabet.
pub(super) fn groups(mechanism: &Mechanism) -> Vec<String> {
    let drawn = mechanism.steps.iter().filter_map(|step| group(mechanism, step));
    drawn.collect()
}

fn group(mechanism: &Mechanism, step: &Step) -> Option<String> {
    let Step::Group(group) = step else { return None };
    let (mode, of_group) = (group.mode(), &group.links);
    let keyword = mechanism.groups[group.id.index()].keyword.to_string();
    let modes = GroupSpec::of(&keyword).and_then(|anatomy| anatomy.modes);
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

/// The links of each search, in the order of the alphabet.
fn searches(mechanism: &Mechanism) -> Vec<String> {
    let name = |link: &LinkId| mechanism.links[link.index()].name.to_string();
    let links = |[from, to]: [usize; 2]| {
        let groups =
            mechanism.steps[from..].iter().enumerate().filter_map(|(index, step)| match step {
                Step::Group(group) => Some((from + index, &group.links)),
                _ => None,
            });
        let mut behind = groups.clone().filter(|(index, links)| {
            *index >= to && links.iter().any(|link| name(link).ends_with("_end"))
        });
        // The next link that was left out belongs to this search.
        let left_out = behind.next().map(|(_, links)| links);
        let groups = groups.take_while(|(index, _)| *index < to).map(|(_, links)| links);
        let groups = groups.chain(left_out);
        let mut links: Vec<_> =
            groups.flatten().map(name).filter(|name| !name.ends_with("_end")).collect();
        links.sort();
        format!("group {}", links.join(" "))
    };
    mechanism.unknowns.iter().map(|unknown| links(unknown.steps)).collect()
}

/// The groups or searches of a machine are those expected, or it is refused as expected.
pub(super) fn the_groups_are_those_expected(case: &Case, found: Result<&Mechanism, &Vec<String>>) {
    let mut expected = case.expected.clone();
    expected.sort_unstable();
    let resolved = || found.unwrap_or_else(|told| panic!("{}: {told:?}", case.name));
    match &expected[0][..5] {
        "refus" => assert!(found.is_err(), "{}", case.name),
        "group" => assert_eq!(searches(resolved()), expected, "{}", case.name),
        _ => {
            let mut found = groups(resolved());
            found.sort();
            assert_eq!(found, expected, "{}", case.name);
        }
    }
}

/// The code and the documentation of a machine.
fn printed(statements: &str) -> String {
    let tokens = format!("pub struct M {{ {statements} }}").parse().expect("these are tokens");
    crate::pipeline::compile(tokens, &crate::pipeline::Options::default()).tokens.to_string()
}

/// A drive between two links pushes the first one against the second, whichever of them its group turns.
#[test]
fn docs_of_a_drive_name_both_of_its_links() {
    for (drive, pushed, against) in
        [("CE.angle - DC.angle = b", "CE", "DC"), ("DC.angle - CE.angle = -b", "DC", "CE")]
    {
        let text = printed(&format!(
            "input a, b: angle; ground A(0, 0), D(4m, 0); pin B(0, 1m), C(3m, 2m), E(3.5m, 3m);
             link AB(A, B), BC(B, C), DC(D, C), CE(C, E); drive AB.angle = a; drive {drive};
             mass 1kg on CE uniform;"
        ));
        let told = format!("couple in N·m on `{pushed}`, exerted by its drive against `{against}`");
        assert!(text.contains(&told), "no {told} in {text}");
    }
}

/// Where a block stands in for a link that a search left out, the docs of forces name the link.
#[test]
fn docs_of_forces_name_links_that_are_drawn() {
    let statements = "input t: angle; ground A(-1, 0), D(4, 0), E(2, 5); \
                      pin B(-0.5, 0.6), P(0.8, 1.2), Q(3, 0.6), R(1.9, 3.1); \
                      link AB(A, B), BP(B, P), plate(P, Q, R), DQ(D, Q), ER(E, R); \
                      drive AB.angle = t; mass 2kg on plate at (0.5, 0.2);";
    let text = printed(statements);
    let others: Vec<_> = text.split("exerted by all that stand on it: ").skip(1).collect();
    assert!(!others.is_empty());
    for others in others {
        let names = others.split(['"', '\\']).next().expect("the sentence ends");
        assert!(!names.contains("_end"), "{names}");
    }
    assert!(text.contains("`plate` at `Q`, exerted by all that stand on it: `DQ`"), "{text}");
}

/// The declaration of the groups in the documentation of a solver.
fn declared_in_docs(mechanism: &Mechanism) -> String {
    let docs = documentation(mechanism);
    let lines: Vec<_> = docs.lines().collect();
    let from = lines.iter().position(|line| line.contains("pub struct")).expect("it is there");
    let to = lines.iter().rposition(|line| line.trim() == "}").expect("it ends");
    lines[from + 1..to - 1].join("\n")
}

/// The declaration in the documentation compiles as it stands, to the same groups.
pub(super) fn the_documentation_compiles_as_it_stands(mechanism: &Mechanism) {
    let text = declared_in_docs(mechanism);
    let by_hand = resolved_text(&text).unwrap_or_else(|told| panic!("{text}\n{told:?}"));
    assert_eq!(groups(&by_hand), groups(mechanism), "{text}");
    assert!(by_hand.drawn.is_none() && by_hand.links.len() == mechanism.links.len());
}
