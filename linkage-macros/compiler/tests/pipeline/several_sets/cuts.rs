//! The groups that each set of inputs of the tested machines is solved by: dyads with a side, driven points, and
//! searches.

use crate::blocks::{declarations, solver_name};
use crate::diagnostics::Diagnostics;
use crate::model::mechanism::{Assembly, Step};
use crate::pipeline::read;

const MACHINES: &str = "../../../tests/both_ways/machines.rs";

/// A line per solver: its name, then its dyads, points that inputs move, and searches.
fn cuts() -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(MACHINES);
    let source = std::fs::read_to_string(path).expect("the machines can be read");
    let mut table = String::new();
    for declaration in declarations(source.parse().expect("these are tokens")) {
        let name = solver_name(&declaration).expect("it has a name");
        let mut diagnostics = Diagnostics::new();
        let (_, mechanism) = read(declaration, &mut diagnostics);
        drop(diagnostics.take_notes());
        assert!(diagnostics.finish().is_ok(), "{name}");
        let Some(Ok(mechanism)) = mechanism else { panic!("{name} has no meaning") };
        let dyads = mechanism.steps.iter().filter(|step| match step {
            Step::Group(group) => matches!(group.assembly, Assembly::Signed(_)),
            _ => false,
        });
        let points = mechanism
            .points
            .iter()
            .filter(|point| matches!(point.part_of, crate::model::mechanism::PartOf::Driven(_)));
        let [dyads, points, searches] = [dyads.count(), points.count(), mechanism.unknowns.len()];
        table += &format!("{name} {dyads} {points} {searches}\n");
    }
    table
}

#[test]
fn each_set_has_the_groups_of_the_table() {
    let expected = include_str!("cuts.txt");
    let found = cuts();
    assert!(found == expected, "{found}");
}
