//! The origin of a printed solver: the program's version, a hash of the declaration, and the words in front of every
//! name where two suppliers meet in one program.

use proc_macro2::{Ident, TokenStream, TokenTree};

use super::c_identifiers::{file_stem, snake_case};
use super::c_names::quoted;
use super::run_time;
use crate::codegen::identifiers::text;
use crate::interface::labels;
use crate::model::mechanism::Mechanism;
use crate::syntax::words::in_capitals;

/// The version of the compiler, which is the program's.
pub(crate) const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The word in front of the names of a supplier's types, functions and files.
#[derive(Clone, Default)]
pub struct Prefix(String);

impl Prefix {
    /// The prefix of this text: letters and digits behind a letter, in words that `_` parts; nothing else is one.
    pub fn new(text: &str) -> Option<Self> {
        let is_word = |word: &str| {
            !word.is_empty() && word.chars().all(|letter| letter.is_ascii_alphanumeric())
        };
        let is_prefix = text.starts_with(|first: char| first.is_ascii_alphabetic())
            && text.split('_').all(is_word);
        is_prefix.then(|| Self(text.to_ascii_lowercase()))
    }

    /// `Arm` as `AcmeArm`.
    pub fn named(&self, solver: &Ident) -> Ident {
        Ident::new(&format!("{}{}", in_capitals(&self.0), text(solver)), solver.span())
    }

    /// The name of a file of the run-time, or of a function.
    pub fn in_front_of(&self, name: &str) -> String {
        if self.0.is_empty() { name.to_string() } else { format!("{}_{name}", self.0) }
    }

    /// A source with the prefix in front of the run-time's functions and files. Fields keep their names, and so does
    /// what stands in a text.
    pub fn put_into(&self, source: &str) -> String {
        if self.0.is_empty() {
            return source.to_string();
        }
        let renamed = |line: &str| match line.strip_prefix("#include \"linkage_") {
            Some(rest) => format!("#include \"{}{rest}", self.in_front_of("linkage_")),
            None => self.in_line(line),
        };
        source.split_inclusive('\n').map(renamed).collect()
    }

    fn in_line(&self, line: &str) -> String {
        let is_of_a_name = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
        let (mut text, mut rest) = (String::with_capacity(line.len()), line);
        let (mut is_quoted, mut before) = (false, ' ');
        while let Some(first) = rest.chars().next() {
            let length = rest.find(|letter| !is_of_a_name(letter)).unwrap_or(rest.len());
            let (word, behind) = rest.split_at(length.max(first.len_utf8()));
            let is_function = word.starts_with("linkage_") && !['.', '>'].contains(&before);
            text += &match word {
                _ if is_quoted => word.to_string(),
                _ if is_function => self.in_front_of(word),
                _ if GUARDS.contains(&word) => self.in_front_of(word).to_uppercase(),
                _ => word.to_string(),
            };
            is_quoted ^= first == '"' && before != '\\';
            // Two backslashes are one letter of a text, and hide no quotation mark behind them.
            before = if first == '\\' && before == '\\' { ' ' } else { first };
            rest = behind;
        }
        text
    }
}

/// The macros by which a header is read once.
const GUARDS: [&str; 4] =
    ["LINKAGE_RUN_H", "LINKAGE_WORDS", "LINKAGE_ASSEMBLIES_H", "LINKAGE_LISTS_HASH"];

/// A number that tells declarations apart: 64 bits of FNV-1a over their words, whatever the layout and the comments.
pub fn hash(declaration: &TokenStream) -> u64 {
    let mut words = String::new();
    put_words(declaration, &mut words);
    run_time::fnv(words.bytes())
}

fn put_words(tokens: &TokenStream, to: &mut String) {
    for token in tokens.clone() {
        match token {
            TokenTree::Group(group) => {
                *to += &format!("{:?}\n", group.delimiter());
                put_words(&group.stream(), to);
                *to += "end\n";
            }
            other => *to += &format!("{other}\n"),
        }
    }
}

/// The origin of one mechanism's files.
pub struct Provenance<'a> {
    pub mechanism: &'a Mechanism,
    pub declaration: u64,
    pub prefix: Prefix,
}

impl Provenance<'_> {
    fn stem(&self) -> String {
        snake_case(&text(&self.mechanism.name))
    }

    /// The declarations that printed C has beside those of `export c;`.
    pub(super) fn in_header(&self) -> String {
        let stem = self.stem();
        let (capitals, words) = (stem.to_uppercase(), self.prefix.put_into(run_time::WORDS));
        format!(
            "\n#ifndef LINKAGE_VERSION\n#define LINKAGE_VERSION \"{VERSION}\"\n#endif\n\
             /* A hash of the declaration's words: layout and comments change nothing. */\n\
             #define {capitals}_DECLARATION \"{:016x}\"\n\n\
             /* The program, its version, the mechanism and the hash, for whoever looks into an object. */\n\
             extern const char {stem}_origin[];\n\n\
             /* The names of the inputs and of the outputs' rows, in their order; the last text is null. */\n\
             extern const char *const {stem}_input_labels[{capitals}_INPUTS + 1];\n\
             extern const char *const {stem}_output_labels[{capitals}_OUTPUTS + 1];\n{}\n{words}",
            self.declaration,
            self.drawn_in_header()
        )
    }

    /// The beginning of the source.
    pub(super) fn in_source(&self) -> String {
        let (stem, solver) = (self.stem(), text(&self.mechanism.name));
        let (capitals, file) = (stem.to_uppercase(), file_stem(&solver));
        let inputs: Vec<String> =
            self.mechanism.inputs.iter().map(|input| text(&input.name)).collect();
        let list = |labels: &[String]| {
            let labels = labels.iter().map(|label| quoted(label));
            labels.chain(["NULL".to_string()]).collect::<Vec<_>>().join(", ")
        };
        let outputs = labels::all_rows(self.mechanism);
        format!(
            "/* {file}.c: the solver of {solver}, printed by linkage {VERSION} from its declaration; do not edit.\n *\n\
             \x20* This text is yours: use, change and pass it on under any terms, with or without this notice. It comes\n\
             \x20* without any warranty. */\n\
             #include \"{file}.h\"\n#include \"linkage_run.h\"\n\n{}\n\
             const char {stem}_origin[] = {};\n\
             const char *const {stem}_input_labels[{capitals}_INPUTS + 1] = {{ {} }};\n\
             const char *const {stem}_output_labels[{capitals}_OUTPUTS + 1] = {{ {} }};\n",
            run_time::condition(),
            quoted(&format!("linkage {VERSION} {solver} {:016x}", self.declaration)),
            list(&inputs),
            list(&outputs),
        ) + &self.drawn_in_source()
    }

    /// The inputs as they are drawn, where the mechanism is a drawing.
    fn drawn_in_header(&self) -> String {
        if self.mechanism.drawn.is_none() {
            return String::new();
        }
        let stem = self.stem();
        format!(
            "\n/* The inputs as they are drawn, in SI. */\nextern const double {stem}_drawn[{}_INPUTS];\n",
            stem.to_uppercase()
        )
    }

    fn drawn_in_source(&self) -> String {
        let Some(drawn) = &self.mechanism.drawn else { return String::new() };
        let (stem, drawn) = (self.stem(), drawn.iter().map(|value| format!("{value:?}")));
        format!(
            "const double {stem}_drawn[{}_INPUTS] = {{ {} }};\n",
            stem.to_uppercase(),
            drawn.collect::<Vec<_>>().join(", ")
        )
    }
}
