//! The numbers of the compiled machine in a pose, by names.

use std::collections::HashMap;

use super::super::machine::Machine;
use crate::exact::Exact;
use crate::interface::entries::EntryPoint;
use crate::interface::{Interface, labels};
use crate::ir::interpret::{Number, ProgramValues, interpret};

/// Numbers by name; of a direction first the cosine, then the sine.
pub(super) type Results = HashMap<String, Vec<f64>>;

/// The results of those of the entry points that are offered.
pub(super) fn results(
    machine: &Machine,
    entries: &[&str],
    inputs: &[[f64; 3]],
    params: &[f64],
    loads: &[f64],
) -> Results {
    let float = |value: f64| f64::exact(&Exact::float(value).expect("finite"));
    let given = ProgramValues {
        inputs: inputs.iter().map(|input| input.map(float)).collect(),
        params: params.to_vec(),
        loads: loads.to_vec(),
        drives: vec![0.0; inputs.len()],
        unit: None,
    };
    let values = interpret(machine.program(), &given);
    let interface = Interface::of(&machine.mechanism);
    let mut results = Results::new();
    for point in entries.iter().map(|entry| EntryPoint::named(entry)) {
        let Some(entry) = interface.entries.iter().find(|known| known.point == point) else {
            continue;
        };
        let names = labels::of_result(&interface, &machine.mechanism, entry);
        let sinks = &machine.program().answer(point.name()).expect("it is offered").sinks;
        assert_eq!(names.len(), sinks.len());
        for (name, sink) in names.into_iter().zip(sinks) {
            results.entry(name).or_default().push(values[sink.index()]);
        }
    }
    results
}
