//! Several sets of inputs of one machine in C: its parameters, and what carries a pose of one solver over to another.
//!
//! Each solver has files of its own; here are the structure and the functions of each pair, with the numbers of the
//! run-time crate's `Transfer` to the last bit.

mod pair;
mod pose_numbers;
mod set_in_c;
mod sides;

use proc_macro2::Ident;

use self::pair::TransferInC;
pub(crate) use self::set_in_c::SetInC;
use super::c_identifiers::{Width, default, file_stem, snake_case};
use super::c_names::param_of;
use super::header::{comment, parameters};
use super::provenance::Prefix;
use super::run_time;
use crate::codegen::identifiers::text;
use crate::interface::entries::Analysis;
use crate::model::mechanism::Mechanism;

/// The status of a pose on another assembly.
pub(super) const OTHER_ASSEMBLY: &str = "\
#ifndef LINKAGE_OTHER_ASSEMBLY
/* The links `group` stand on the other side than the one that they have for the solver `name`. */
#define LINKAGE_OTHER_ASSEMBLY 11
#endif
";

/// A machine, and the solvers of its sets.
pub(crate) struct Transfers<'a> {
    pub machine: Ident,
    pub sets: Vec<SetInC<'a>>,
    pub widths: Vec<Width>,
    pub prefix: Prefix,
}

impl Transfers<'_> {
    /// Name and text of the header and of the source; nothing where no solver has what is needed.
    pub(crate) fn files(&self) -> Vec<(String, String)> {
        let pairs: Vec<_> = self.pairs().collect();
        if pairs.is_empty() {
            return Vec::new();
        }
        let file = file_stem(&text(&self.machine));
        let (header, source) = (self.header(&file, &pairs), self.source(&file, &pairs));
        vec![(format!("{file}.h"), header), (format!("{file}.c"), self.prefix.put_into(&source))]
    }

    fn pairs(&self) -> impl Iterator<Item = TransferInC<'_>> {
        let froms = self.sets.iter().filter(|from| from.interface.has(Analysis::Position));
        froms.flat_map(|from| {
            let others = self.sets.iter().filter(|to| to.set != from.set);
            others.filter_map(|to| TransferInC::between(from, to))
        })
    }

    fn header(&self, file: &str, pairs: &[TransferInC<'_>]) -> String {
        let (machine, guard) = (text(&self.machine), file.to_uppercase());
        let about = [
            format!("{machine}, driven in several ways: each solver's poses as those of the others; do not edit."),
            String::new(),
            "A pose is carried over where the other solver has it, too: on the other's assembly of the drawing.".to_string(),
            "Functions and errors are as in the headers of the solvers.".to_string(),
        ];
        let includes = self.sets.iter().map(|set| format!("#include \"{}.h\"\n", set.file()));
        let mut header = format!(
            "{}\n#ifndef {guard}_H\n#define {guard}_H\n\n{}\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n{OTHER_ASSEMBLY}",
            comment(&about, ""),
            includes.collect::<String>()
        );
        for &width in &self.widths {
            header += &self.declared_parameters(width);
            pairs.iter().for_each(|pair| header += &pair.declared(width));
        }
        header + &format!("\n#ifdef __cplusplus\n}}\n#endif\n\n#endif /* {guard}_H */\n")
    }

    fn source(&self, file: &str, pairs: &[TransferInC<'_>]) -> String {
        let machine = text(&self.machine);
        let stem = snake_case(&machine);
        let sides = pairs.iter().flat_map(|pair| &pair.carried.sides);
        let is_compared = pairs.iter().any(|pair| !pair.carried.compared.is_empty());
        let mut source = format!(
            "/* {file}.c: poses of {machine} from each of its solvers to the others, printed by linkage; do not edit.\n *\n\
             \x20* This text is yours: use, change and pass it on under any terms, with or without this notice. It comes\n\
             \x20* without any warranty. */\n\
             #include \"{file}.h\"\n#include \"linkage_run.h\"\n\n{}\n{}",
            run_time::condition(),
            sides::functions(&stem, sides, is_compared)
        );
        for &width in &self.widths {
            let without = width.excluded();
            source += &format!("\n#ifndef {without}\n");
            source += &self.defined_parameters(width);
            pairs.iter().for_each(|pair| source += &pair.defined(&stem, width));
            source += &format!("\n#endif /* {without} */\n");
        }
        source
    }

    /// Any of the solvers: all have the same parameters.
    fn parameters(&self) -> Option<&Mechanism> {
        let mechanism = self.sets.first().map(|set| set.mechanism);
        mechanism.filter(|mechanism| !mechanism.params.is_empty())
    }

    fn declared_parameters(&self, width: Width) -> String {
        let Some(mechanism) = self.parameters() else { return String::new() };
        let mut text = parameters(&self.machine, mechanism, width).text(&self.machine);
        let about = comment(&["The parameters as declared.".to_string()], "");
        text += &format!("\n{about}{};\n", self.default(width));
        for set in &self.sets {
            let about = format!("The parameters of {}.", set.name());
            text += &format!("\n{}{};\n", comment(&[about], ""), self.of_set(set, width));
        }
        text
    }

    fn defined_parameters(&self, width: Width) -> String {
        let (Some(mechanism), Some(first)) = (self.parameters(), self.sets.first()) else {
            return String::new();
        };
        let names: Vec<String> = mechanism.params.iter().map(|of| text(&of.name)).collect();
        let copied = |to: &Ident, from: &str, of: &Ident| -> String {
            let field = |record, name| param_of(record, mechanism, name);
            let pairs = names.iter().map(|name| [field(to, name), field(of, name)]);
            pairs.map(|[to, name]| format!("    own.{to} = {from}{name};\n")).collect()
        };
        let (ty, theirs) = (width.type_name(&text(&self.machine)), first.parameters(width));
        let mut source = format!(
            "\n{}\n{{\n    const {theirs} declared = {}();\n    {ty} own;\n{}    return own;\n}}\n",
            self.default(width),
            default(&first.mechanism.name, width),
            copied(&self.machine, "declared.", &first.mechanism.name)
        );
        for set in &self.sets {
            source += &format!(
                "\n{}\n{{\n    {} own;\n{}    return own;\n}}\n",
                self.of_set(set, width),
                set.parameters(width),
                copied(&set.mechanism.name, "mechanism->", &self.machine)
            );
        }
        source
    }

    fn default(&self, width: Width) -> String {
        let ty = width.type_name(&text(&self.machine));
        format!("{ty} {}(void)", default(&self.machine, width))
    }

    /// The function that gives a solver the machine's parameters.
    fn of_set(&self, set: &SetInC<'_>, width: Width) -> String {
        let machine = width.type_name(&text(&self.machine));
        format!(
            "{} {}(const {machine} *mechanism)",
            set.parameters(width),
            set.function("of", width)
        )
    }
}
