//! Names in C: of types as in Rust, of functions in snake case, of fields and arguments as
//! declared wherever C allows that. Where it does not, the name gets a tail.

use std::collections::HashSet;

use proc_macro2::Ident;

use super::reserved;
use crate::codegen::identifiers::text;
use crate::interface::entries::Entry;

/// The name of the parameter that points to the declaration's parameters.
pub(in crate::codegen) const PARAMETERS: &str = "mechanism";

/// The number that a type or function is for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Width {
    Double,
    Single,
}

impl Width {
    pub const ALL: [Self; 2] = [Self::Double, Self::Single];

    pub fn in_rust(self) -> &'static str {
        match self {
            Self::Double => "f64",
            Self::Single => "f32",
        }
    }

    pub(in crate::codegen) fn in_c(self) -> &'static str {
        match self {
            Self::Double => "double",
            Self::Single => "float",
        }
    }

    /// The words in front of a name that is bound once.
    pub(in crate::codegen) fn binding(self) -> &'static str {
        match self {
            Self::Double => "const double ",
            Self::Single => "const float ",
        }
    }

    /// The macro with which a user leaves this width out.
    pub(in crate::codegen) fn excluded(self) -> &'static str {
        match self {
            Self::Double => "LINKAGE_NO_DOUBLE",
            Self::Single => "LINKAGE_NO_SINGLE",
        }
    }

    /// A mechanism's type for numbers of this width.
    pub fn type_name(self, name: &str) -> String {
        let mut name = clear_of_compilers(format!("{}{}", ascii(name), self.suffix()));
        if reserved::is_a_printed_function(&name) {
            name.push('_');
        }
        while reserved::is_declared(&name) {
            name.push('_');
        }
        name
    }

    /// A type that all mechanisms share.
    pub(in crate::codegen) fn shared_type_name(self, record: &str) -> String {
        format!("Linkage{record}{}", self.suffix())
    }

    fn suffix(self) -> &'static str {
        if self == Self::Single { "F32" } else { "" }
    }
}

/// `flying_shear_position` or `flying_shear_position_f32`.
pub(in crate::codegen) fn function(solver: &Ident, entry: &Entry, width: Width) -> String {
    suffixed(solver, entry.name(), width)
}

/// The function that returns the parameters as declared.
pub(in crate::codegen) fn default(solver: &Ident, width: Width) -> String {
    suffixed(solver, "default", width)
}

pub(super) fn suffixed(solver: &Ident, action: &str, width: Width) -> String {
    let suffix = if width == Width::Single { "_f32" } else { "" };
    format!("{}_{action}{suffix}", snake_case(&text(solver)))
}

/// `FlyingShear` as `flying_shear`, `RRRDyad` as `rrr_dyad`.
pub fn snake_case(name: &str) -> String {
    let letters: Vec<char> = name.chars().collect();
    let mut snake = String::new();
    for (i, letter) in letters.iter().enumerate() {
        let before = i.checked_sub(1).map(|i| letters[i]);
        let after_word = before.is_some_and(|before| before.is_lowercase() || before.is_numeric());
        let before_word = letters.get(i + 1).is_some_and(|after| after.is_lowercase())
            && before.is_some_and(char::is_uppercase);
        if letter.is_uppercase() && (after_word || before_word) {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    ascii(&snake)
}

/// The name of a mechanism's files without their ending: that of its functions, and a longer one where it is another
/// header's.
pub fn file_stem(solver: &str) -> String {
    let stem = snake_case(solver);
    if reserved::is_file(&stem) { format!("{stem}_mechanism") } else { stem }
}

/// The names of a record's fields or a function's arguments: different, and none a keyword or a macro.
pub fn distinct(solver: &Ident, names: impl IntoIterator<Item = String>) -> Vec<String> {
    let own = own_macros(&text(solver));
    let mut taken = HashSet::new();
    let free = |name: String| {
        let mut name = clear_of_compilers(ascii(&name));
        while reserved::is_word(&name) || own.contains(&name) || !taken.insert(name.clone()) {
            name.push('_');
        }
        name
    };
    names.into_iter().map(free).collect()
}

/// The names of the arguments of a function, which also hide none of the functions that it calls: first those that
/// are always there, to which others give way.
pub fn arguments(
    solver: &Ident,
    fixed: [&str; 3],
    others: impl Iterator<Item = String>,
) -> Vec<String> {
    let stem = snake_case(&text(solver));
    let clear = |name: String| {
        let tail = if reserved::is_called(&name, &stem) { "_" } else { "" };
        name + tail
    };
    distinct(solver, fixed.map(str::to_string).into_iter().chain(others.map(clear)))
}

/// The macros of a mechanism's header: two numbers, a hash, and what says that it was included.
fn own_macros(solver: &str) -> [String; 4] {
    let [inputs, outputs, hash] =
        ["inputs", "outputs", "declaration"].map(|of| format!("{}_{of}", snake_case(solver)));
    [inputs, outputs, hash, format!("{}_h", file_stem(solver))].map(|name| name.to_uppercase())
}

/// The name behind a letter if it could be one of the compiler's, which may have tails of their own.
fn clear_of_compilers(name: String) -> String {
    if reserved::is_the_compilers(&name) { format!("c{name}") } else { name }
}

/// The name with every letter that a C compiler may not know by its number: `θ` as `u03b8`.
pub(in crate::codegen) fn ascii(name: &str) -> String {
    let letter = |letter: char| match letter.is_ascii() {
        true => letter.to_string(),
        false => format!("u{:04x}", u32::from(letter)),
    };
    name.chars().map(letter).collect()
}
