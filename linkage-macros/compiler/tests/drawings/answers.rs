//! The numbers of a machine's results, by their names.

use super::machine::Machine;
use crate::exact::Exact;
use crate::interface::entries::EntryPoint;
use crate::interface::{Interface, labels};
use crate::ir::interpret::{ProgramValues, Searched, interpret};

/// Numbers by name; of a direction first the cosine, then the sine.
pub(super) struct Answers(Vec<(String, f64)>);

impl Answers {
    pub(super) fn named(&self, name: &str) -> f64 {
        let found = self.0.iter().find(|(known, _)| known == name);
        found.unwrap_or_else(|| panic!("no `{name}` in {:?}", self.0)).1
    }

    /// The angle of a direction.
    pub(super) fn angle(&self, name: &str) -> f64 {
        let [cos, sin] = self.both(name);
        sin.atan2(cos)
    }

    fn both(&self, name: &str) -> [f64; 2] {
        let mut found = self.0.iter().filter(|(known, _)| known == name).map(|(_, value)| *value);
        [(); 2].map(|()| found.next().unwrap_or_else(|| panic!("no `{name}` in {:?}", self.0)))
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = (&str, f64)> {
        self.0.iter().map(|(name, value)| (&name[..], *value))
    }
}

impl Machine {
    /// The result of an entry point, at these inputs with their rates, in numbers of a kind.
    pub(super) fn answers_in<N: Searched>(
        &self,
        entry: &str,
        inputs: &[[f64; 3]],
        value: impl Fn(&N) -> f64,
    ) -> Answers {
        self.answers_with(entry, inputs, &[], value)
    }

    /// The same in double precision at these parameters, where nothing moves.
    pub(super) fn answers_at(&self, entry: &str, inputs: &[f64], params: &[f64]) -> Answers {
        let at_rest: Vec<_> = inputs.iter().map(|&input| [input, 0.0, 0.0]).collect();
        self.answers_with::<f64>(entry, &at_rest, params, |value| *value)
    }

    fn answers_with<N: Searched>(
        &self,
        entry: &str,
        inputs: &[[f64; 3]],
        params: &[f64],
        value: impl Fn(&N) -> f64,
    ) -> Answers {
        let float = |value: f64| N::exact(&Exact::float(value).expect("finite"));
        let given = ProgramValues {
            inputs: inputs.iter().map(|input| input.map(float)).collect(),
            params: params.iter().map(|&param| float(param)).collect(),
            loads: Vec::new(),
            drives: vec![float(0.0); inputs.len()],
            unit: None,
        };
        let values = interpret(self.program(), &given);
        let interface = Interface::of(&self.mechanism);
        let point = EntryPoint::named(entry);
        let declared = interface.entries.iter().find(|known| known.point == point);
        let declared = declared.unwrap_or_else(|| panic!("no `{entry}`"));
        let names = labels::of_result(&interface, &self.mechanism, declared);
        let sinks = &self.program().answer(entry).expect("it is offered").sinks;
        assert_eq!(names.len(), sinks.len());
        let number = |sink: &crate::ir::graph::Id| value(&values[sink.index()]);
        Answers(names.into_iter().zip(sinks.iter().map(number)).collect())
    }

    /// The same in double precision.
    pub(super) fn answers(&self, entry: &str, inputs: &[[f64; 3]]) -> Answers {
        self.answers_in::<f64>(entry, inputs, |value| *value)
    }
}
