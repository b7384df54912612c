//! `export assemblies;` in C: a function that lists all assemblies, one that returns the solver of an assembly, and the
//! run-time of lists.

use std::sync::LazyLock;

use linkage_assemblies::{BodyPin, HungBar, PinnedGroup};

use super::In;
use super::c_identifiers::{
    PARAMETERS as MECHANISM, Width, arguments, file_stem, snake_case, suffixed,
};
use super::c_names::param;
use super::entry::REFUSED;
use super::header::comment;
use super::provenance::Provenance;
use super::public_function::{GivenInC, mode_tests, pointer_test};
use super::run_time::{OWN_HASH, hash_in_c};
use super::two_paths::{Destination, indented};
use crate::codegen::arguments::Signatures;
use crate::codegen::identifiers::text;
use crate::codegen::listing::Listing;
use crate::lower::used::Asks;
use crate::model::any_assembly::AnyAssembly;
use crate::model::mechanism::{Param, ParamId};

/// Prints the list of a mechanism and the solver of an assembly, for numbers of these widths: name and text of a header and a
/// source, then those of the run-time.
pub(crate) fn generate(
    listing: &Listing<'_>,
    any: &AnyAssembly,
    widths: &[Width],
    provenance: &Provenance<'_>,
) -> Vec<(String, String)> {
    let mechanism = provenance.mechanism;
    let signatures = Signatures::new(mechanism, &listing.pinned.interface);
    let solver = text(&mechanism.name);
    let stem = snake_case(&solver);
    let lists = widths.iter().map(|&width| List {
        to: In { mechanism, lowered: &listing.pinned, signatures: &signatures, width, stem: &stem },
        listing,
        any,
    });
    let (mut prototypes, mut functions) = (String::new(), String::new());
    for list in lists {
        list.listed(&mut prototypes, &mut functions);
        list.with(&mut prototypes, &mut functions);
    }
    let file = file_stem(&format!("{solver}Assemblies"));
    let [own, other] = [&mechanism.name, &any.mechanism.name].map(|name| file_stem(&text(name)));
    let header = format!(
        "/* The assemblies of {solver}, generated from its declaration in Rust; do not edit. */\n\
         #ifndef {guard}_H\n#define {guard}_H\n\n\
         #include \"{own}.h\"\n#include \"{other}.h\"\n#include \"linkage_assemblies.h\"\n\n\
         /* The most assemblies, whatever the lengths are. */\n#define {}_ASSEMBLIES {}\n\n\
         #ifndef LINKAGE_NO_DOUBLE\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n{prototypes}\n\
         #ifdef __cplusplus\n}}\n#endif\n\n#endif /* LINKAGE_NO_DOUBLE */\n\n#endif /* {guard}_H */\n",
        stem.to_uppercase(),
        2 * listing.degree.half,
        guard = file.to_uppercase(),
    );
    let source = format!(
        "#include \"linkage_run.h\"\n#include \"{file}.h\"\n\n{}\n#ifndef LINKAGE_NO_DOUBLE\n\n{}{functions}\n\
         #endif /* LINKAGE_NO_DOUBLE */\n",
        condition(),
        kind(listing),
    );
    let files = [(format!("{file}.h"), header), (format!("{file}.c"), source)];
    let files = files.map(|(name, text)| (name, provenance.prefix.put_into(&text)));
    let run_time =
        [("linkage_assemblies.h", run_time_header()), ("linkage_assemblies.c", run_time())];
    let run_time = run_time.map(|(name, text)| {
        (provenance.prefix.in_front_of(name), provenance.prefix.put_into(&text))
    });
    files.into_iter().chain(run_time).collect()
}

/// A hash of the lists' run-time, which is none of the other run-time's.
static HASH: LazyLock<String> = LazyLock::new(|| {
    hash_in_c(&[include_str!("run/assemblies/types.h"), &plain_run_time()].concat())
});

/// The text of `linkage_assemblies.h`.
fn run_time_header() -> String {
    include_str!("run/assemblies/types.h").replace(OWN_HASH, &HASH)
}

/// The text of `linkage_assemblies.c`. A closure is written once, for discs and for complex numbers.
fn run_time() -> String {
    plain_run_time().replacen(INCLUDE, &format!("{INCLUDE}\n{}", condition()), 1)
}

const INCLUDE: &str = "#include \"linkage_assemblies.h\"\n";

fn plain_run_time() -> String {
    let closing = include_str!("run/assemblies/closing.c");
    let of = |number: &str, ending: &str| closing.replace("NUMBER", number).replace('@', ending);
    let parts = [
        include_str!("run/assemblies/numbers.c"),
        &of("Complex", "_complex"),
        &of("Disc", "_disc"),
        include_str!("run/assemblies/polynomial.c"),
        include_str!("run/assemblies/zero.c"),
        include_str!("run/assemblies/circle.c"),
        include_str!("run/assemblies/listed.c"),
    ];
    parts.concat()
}

/// The lines by which a source asks for this text of the run-time and no other.
fn condition() -> String {
    let condition =
        include_str!("run/condition.h").replace("LINKAGE_RUN_TIME", "LINKAGE_LISTS_HASH");
    condition.replace("linkage_run.h", "linkage_assemblies.h").replace(OWN_HASH, &HASH)
}

/// The kind of the group, as the run-time reads it.
fn kind(Listing { group, degree, .. }: &Listing<'_>) -> String {
    let PinnedGroup { pivot, equation, .. } = group;
    let pin = |BodyPin { body, place }: BodyPin| format!("{{ {body}, {place} }}");
    let bar = |HungBar { body, outer, ends }: HungBar| {
        format!("{{ {body}, {}, {{ {}, {} }} }}", pin(outer), ends[0], ends[1])
    };
    let mut dyads: Vec<String> = group
        .dyads()
        .map(|(_, dyad)| format!("{{ {}, {} }}", bar(dyad.bars[0]), bar(dyad.bars[1])))
        .collect();
    let none = BodyPin { body: 0, place: 0 };
    let nothing = bar(HungBar { body: 0, outer: none, ends: [0; 2] });
    dyads.resize(group.dyads.len(), format!("{{ {nothing}, {nothing} }}"));
    let powers = degree.powers.map(|power| power.to_string()).join(", ");
    format!(
        "static const LinkagePinned kind = {{\n    {{ {}, {} }}, {}, {{\n        {}\n    }},\n    {{ {}, {} }}, {{ {powers} }}, {}\n}};\n",
        pivot[0],
        pivot[1],
        group.count(),
        dyads.join(",\n        "),
        pin(equation[0]),
        pin(equation[1]),
        degree.half
    )
}

/// The functions of one width.
struct List<'a> {
    to: In<'a>,
    listing: &'a Listing<'a>,
    any: &'a AnyAssembly,
}

impl List<'_> {
    /// The function that lists, and the one behind it whose arguments have names of our own.
    fn listed(&self, prototypes: &mut String, functions: &mut String) {
        let to = self.to;
        let routine = &self.listing.pinned.routines[0];
        to.on_path(routine, Asks::Diagnoses, functions);
        let name = suffixed(&to.mechanism.name, "assemblies", to.width);
        let inner = format!("{}_list{}", to.stem, to.ending());
        let mut list = to.declared(&routine.given);
        let beside = [
            "LinkageBudget budget",
            "LinkageAssembly *assemblies",
            "LinkageAssemblies *list",
            "LinkageError *error",
        ];
        list.extend(beside.map(str::to_string));
        let is_single = !to.ending().is_empty();
        let stage = routine.stages.first().expect("a list of numbers has one stage");
        let count = stage.sinks.len();
        let mut body = format!(
            "LinkageWhy why = linkage_why({});\n{} found[{count}];\n",
            usize::from(is_single),
            to.real()
        );
        if is_single {
            body += &format!("double numbers[{count}];\nint at;\n");
        }
        to.given_finite(&routine.given, &routine.reads, &mut body);
        let call =
            to.call(routine, 0, Asks::Diagnoses, &routine.given, Destination::Local("found"));
        body += &format!("{call};\n{REFUSED}");
        if is_single {
            body += &format!(
                "for (at = 0; at < {count}; at++) {{\nnumbers[at] = (double)found[at];\n}}\n"
            );
        }
        let numbers = if is_single { "numbers" } else { "found" };
        body += &format!(
            "linkage_list_assemblies(&kind, {numbers}, budget, assemblies, list);\nreturn LINKAGE_OK;\n"
        );
        *functions += &format!(
            "\nstatic LinkageStatus {inner}({})\n{{\n{}}}\n",
            list.join(", "),
            indented(&body)
        );
        self.public(&name, &inner, prototypes, functions);
    }

    /// The public function: it tests what C may get wrong, and calls the other.
    fn public(&self, name: &str, inner: &str, prototypes: &mut String, functions: &mut String) {
        let (to, routine) = (self.to, &self.listing.pinned.routines[0]);
        let given = to.signatures.arguments(&routine.given);
        let others = given.names().iter().map(text).chain(["budget", "list"].map(str::to_string));
        let all = arguments(&to.mechanism.name, [MECHANISM, "assemblies", "error"], others);
        let [budget, list] = [0, 1].map(|at| &all[3 + given.names().len() + at]);
        let GivenInC { mut declared, names: mut handed, pointers } = GivenInC::of(to, &given, &all);
        let most = format!("{}_ASSEMBLIES", to.stem.to_uppercase());
        declared.push(format!("LinkageBudget {budget}"));
        declared.push(format!("LinkageAssembly assemblies[{most}]"));
        declared.push(format!("LinkageAssemblies *{list}"));
        declared.push("LinkageError *error".to_string());
        handed.extend([budget.as_str(), "assemblies", list, "error"].map(str::to_string));
        let answers = [pointer_test("assemblies", "assemblies"), pointer_test(list, "list")];
        let given = pointers.iter().map(|(name, label)| pointer_test(name, label));
        let mut body: String = answers.into_iter().chain(given).collect();
        if to.has_params() {
            body += &mode_tests(to.mechanism, &all[0]);
        }
        body += &format!("return {inner}({});\n", handed.join(", "));
        let declared = declared.join(", ");
        let about = [
            "All ways to assemble the first group that is searched, at these inputs, by at most as many samples and".to_string(),
            "pieces as the budget has. The list says if it is proved. A group that cannot be assembled has an empty list."
                .to_string(),
        ];
        *prototypes += &format!("\n{}LinkageStatus {name}({declared});\n", comment(&about, ""));
        *functions += &format!("\nLinkageStatus {name}({declared})\n{{\n{}}}\n", indented(&body));
    }

    /// The function that returns the solver of an assembly.
    fn with(&self, prototypes: &mut String, functions: &mut String) {
        let (to, any) = (self.to, &self.any.mechanism);
        let name = suffixed(&to.mechanism.name, "with", to.width);
        let ty = to.width.type_name(&text(&any.name));
        let default = suffixed(&any.name, "default", to.width);
        let is = |param: &Param, id: ParamId| any.params[id.index()].name == param.name;
        let value = |param: &Param| match () {
            () if is(param, self.any.near) => Some(format!("({})assembly->unknown", to.real())),
            () if is(param, self.any.room) => Some(format!("({})assembly->within", to.real())),
            () if is(param, self.any.trend) => {
                let [rising, falling] = if self.any.is_left { [1, -1] } else { [-1, 1] };
                Some(format!("assembly->rises != 0 ? {rising} : {falling}"))
            }
            () => {
                let dyad = self.any.sides.iter().position(|&own| is(param, own))?;
                Some(format!(
                    "((assembly->sides >> {dyad}) & 1u) != 0u ? LINKAGE_LEFT : LINKAGE_RIGHT"
                ))
            }
        };
        let mut body = format!("{ty} made = {default}();\n");
        let test = if to.has_params() {
            "mechanism == NULL || assembly == NULL"
        } else {
            "assembly == NULL"
        };
        body += &format!("if ({test}) {{\nreturn made;\n}}\n");
        for of in &any.params {
            let field = text(&of.name);
            let from = value(of)
                .unwrap_or_else(|| format!("{MECHANISM}->{}", param(to.mechanism, &field)));
            body += &format!("made.{} = {from};\n", param(any, &field));
        }
        body += "return made;\n";
        let own = to.has_params().then(|| format!("const {} *{MECHANISM}, ", to.params_type()));
        let declared = format!("{}const LinkageAssembly *assembly", own.unwrap_or_default());
        let about = [
            "The solver of one assembly: it begins at the unknown in the list, and looks no farther than half way to the".to_string(),
            "next assembly there. Of null pointers it is the one as declared.".to_string(),
        ];
        *prototypes += &format!("\n{}{ty} {name}({declared});\n", comment(&about, ""));
        *functions += &format!("\n{ty} {name}({declared})\n{{\n{}}}\n", indented(&body));
    }
}
