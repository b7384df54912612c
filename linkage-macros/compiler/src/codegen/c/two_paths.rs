//! A routine as two functions: one that compares and answers whether all is well, one that diagnoses. Stages
//! hand their results back through a pointer each, and the order says at which to stop.

use super::In;
use super::c_names::is_array;
use super::in_c::InC;
use crate::codegen::printer::{Dialect, Printer};
use crate::codegen::text::Text;
use crate::interface::entries::ArgumentKind;
use crate::interface::quantity::Order;
use crate::interface::records::{Shape, field_of_motion};
use crate::ir::graph::Node;
use crate::lower::places::{Place, place};
use crate::lower::routine::{Instruction, Routine};
use crate::lower::used::{Asks, Used};

impl In<'_> {
    pub(super) fn routine(self, routine: &Routine, to: &mut String) {
        for asks in [Asks::Compares, Asks::Diagnoses] {
            self.on_path(routine, asks, to);
        }
    }

    pub(super) fn on_path(self, routine: &Routine, asks: Asks, to: &mut String) {
        let used = Used::on(self.lowered, routine, asks);
        let (given, binding) = (&routine.given, self.width.binding());
        let dialect = InC { to: self, given, asks, used: &used, binding };
        let printer = Printer { lowered: self.lowered, routine, dialect };
        let mut lines = Text::long();
        self.begin(&printer, &mut lines);
        let is_staged = routine.stages.len() > 1;
        for (nth, statements) in used.stages.iter().enumerate() {
            printer.statements(statements, &mut lines);
            let stage = &routine.stages[nth];
            let places = self.components_behind(stage.result, &pointer(is_staged, nth));
            for (place, &sink) in places.iter().zip(&stage.sinks) {
                lines.put(place).put(" = ");
                printer.value(sink, &mut lines);
                lines.put(";\n");
            }
            if nth + 1 < routine.stages.len() {
                let answer = if asks == Asks::Compares { " ok" } else { "" };
                lines.put(&format!("if (order == {nth}) {{\nreturn{answer};\n}}\n"));
            }
        }
        if asks == Asks::Compares {
            lines.put("return ok;\n");
        }
        let (kind, arguments) = (self.kind(asks), self.arguments(routine, asks));
        let name = self.routine_name(routine, asks);
        *to += &format!("\n{kind} {name}({arguments})\n{{\n");
        to.push_str(&indented(lines.as_str()));
        *to += "}\n";
    }

    fn kind(self, asks: Asks) -> &'static str {
        match asks {
            Asks::Compares => "static LINKAGE_INLINE int",
            Asks::Diagnoses => "static LINKAGE_COLD void",
        }
    }

    /// Names what is not read, and binds the constants that are.
    fn begin(self, printer: &Printer<'_, InC<'_>>, to: &mut Text) {
        let (routine, used) = (printer.routine, printer.dialect.used);
        if printer.dialect.asks == Asks::Compares {
            to.put("int ok = 1;\n");
        } else if !diagnoses(routine) {
            to.put("(void)why;\n");
        }
        for name in self.unread(&routine.given, used.leaves()) {
            to.put(&format!("(void){name};\n"));
        }
        let constants = routine.constants.iter().filter(|(node, _)| used.reads_constant(*node));
        for (constant, name) in constants {
            to.put(printer.dialect.binding).put(name).put(" = ");
            printer.dialect.constant(*constant, to);
            to.put(";\n");
        }
    }

    /// The arguments that none of these leaves is read from.
    fn unread(self, given: &[ArgumentKind], leaves: &[Node]) -> Vec<String> {
        let (mechanism, interface) = (self.mechanism, self.interface());
        let place = |&leaf: &Node| place(mechanism, interface, given, leaf);
        let first = usize::from(self.has_params());
        let reads = |at: usize| {
            leaves.iter().filter_map(place).any(|place| match place {
                Place::Param(_) => first == 1 && at == 0,
                Place::Argument(argument, _) => at == argument + first,
            })
        };
        let names = self.names(given).into_iter().enumerate();
        names.filter(|&(at, _)| !reads(at)).map(|(_, name)| name).collect()
    }

    fn arguments(self, routine: &Routine, asks: Asks) -> String {
        let is_staged = routine.stages.len() > 1;
        let mut list = self.declared(&routine.given);
        if is_staged {
            list.insert(0, "int order".to_string());
        }
        if asks == Asks::Diagnoses {
            list.insert(0, "LinkageWhy *why".to_string());
        }
        let stages = routine.stages.iter().enumerate();
        list.extend(
            stages.map(|(nth, stage)| self.returned(stage.result, &pointer(is_staged, nth))),
        );
        list.join(", ")
    }

    fn routine_name(self, routine: &Routine, asks: Asks) -> String {
        let path = match asks {
            Asks::Compares => "compare",
            Asks::Diagnoses => "diagnose",
        };
        let name = routine.name.trim_end_matches('_');
        format!("{}_{path}_{name}{}", self.stem, self.ending())
    }

    /// The call of a stage with its entry point's arguments.
    pub(super) fn call(
        self,
        routine: &Routine,
        stage: usize,
        asks: Asks,
        given: &[ArgumentKind],
        to: Destination,
    ) -> String {
        let mut list = self.names(given);
        // A stage needs one order of the inputs less than the next, which are not read.
        list.extend(routine.given[given.len()..].iter().map(|&missing| self.at_rest(missing)));
        if routine.stages.len() > 1 {
            list.insert(0, stage.to_string());
        }
        if asks == Asks::Diagnoses {
            list.insert(0, "&why".to_string());
        }
        list.extend(self.targets(routine, stage, to));
        format!("{}({})", self.routine_name(routine, asks), list.join(", "))
    }

    /// Where each stage puts its result: those behind the wanted one nowhere. The last stage's entry point
    /// returns all of them in one record.
    fn targets(self, routine: &Routine, stage: usize, to: Destination) -> Vec<String> {
        let fields = match routine.result {
            Shape::Record(record) if routine.stages.len() > 1 => {
                &self.interface().record(record).fields
            }
            shape => return vec![to.whole(is_array(shape))],
        };
        let last = routine.stages.len() - 1;
        let target = |nth: usize| match nth {
            _ if stage == last => to.field(&fields[nth].name.to_string()),
            _ if nth == stage => to.whole(false),
            _ if nth < stage => format!("&{}", pointer(true, nth)),
            _ => "NULL".to_string(),
        };
        (0..=last).map(target).collect()
    }

    /// The locals that hold the results of earlier stages, which an entry point in between has no use for.
    pub(super) fn earlier_results(self, routine: &Routine, stage: usize) -> String {
        if stage + 1 == routine.stages.len() {
            return String::new();
        }
        let declare = |nth: usize| {
            format!("{};\n", self.result(routine.stages[nth].result, &pointer(true, nth)))
        };
        (0..stage).map(declare).collect()
    }

    /// An argument in place of rates that are not read.
    fn at_rest(self, given: ArgumentKind) -> String {
        match (given, self.interface().input_record()) {
            (ArgumentKind::Rate | ArgumentKind::Acceleration, Some(_)) => "q".to_string(),
            _ => self.number(0.0, 0.0),
        }
    }
}

/// Where a result goes.
#[derive(Clone, Copy)]
pub(super) enum Destination {
    /// Where this argument points.
    Pointer(&'static str),
    Local(&'static str),
}

impl Destination {
    fn whole(self, is_array: bool) -> String {
        match self {
            Self::Pointer(name) => name.to_string(),
            Self::Local(name) if is_array => name.to_string(),
            Self::Local(name) => format!("&{name}"),
        }
    }

    fn field(self, field: &str) -> String {
        match self {
            Self::Pointer(name) => format!("&{name}->{field}"),
            Self::Local(name) => format!("&{name}.{field}"),
        }
    }
}

/// The argument through which a stage hands back its result.
fn pointer(is_staged: bool, nth: usize) -> String {
    if is_staged { field_of_motion(Order::ALL[nth]) } else { "to" }.to_string()
}

/// True if the slow path of a routine contains a check, or solves something.
fn diagnoses(routine: &Routine) -> bool {
    let asks = |statement: &Instruction| {
        matches!(statement, Instruction::Check(_) | Instruction::Solve(_))
    };
    routine.stages.iter().flat_map(|stage| &stage.statements).any(asks)
}

/// Lines of a function's body, four blanks for each brace that is open.
pub(super) fn indented(lines: &str) -> String {
    let (mut depth, mut text) = (1_usize, String::with_capacity(lines.len() * 5 / 4));
    for line in lines.lines() {
        depth -= usize::from(line.starts_with('}'));
        text.push_str(&"    ".repeat(depth));
        text.push_str(line);
        text.push('\n');
        depth += usize::from(line.ends_with('{'));
    }
    text
}
