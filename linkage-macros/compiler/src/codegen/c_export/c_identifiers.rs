//! Names in C: of types as in Rust, of functions in snake case, of fields and arguments as
//! declared wherever C allows that.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::codegen::identifiers::text;
use crate::interface::entries::Entry;

/// The number that a type or function is for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Width {
    Double,
    Single,
}

impl Width {
    pub(in crate::codegen) const ALL: [Self; 2] = [Self::Double, Self::Single];

    pub(in crate::codegen) fn in_rust(self) -> &'static str {
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

    /// A type of the header for numbers of this width.
    pub(in crate::codegen) fn type_name(self, name: &str) -> String {
        let suffix = if self == Self::Single { "F32" } else { "" };
        format!("{}{suffix}", ascii(name))
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

fn suffixed(solver: &Ident, action: &str, width: Width) -> String {
    let suffix = if width == Width::Single { "_f32" } else { "" };
    format!("{}_{action}{suffix}", snake_case(&text(solver)))
}

/// `FlyingShear` as `flying_shear`, `RRRDyad` as `rrr_dyad`.
pub(in crate::codegen) fn snake_case(name: &str) -> String {
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

/// The names of a record's fields or a function's arguments: different, and none a keyword.
pub(in crate::codegen) fn distinct(names: impl IntoIterator<Item = String>) -> Vec<String> {
    let mut taken = HashSet::new();
    let free = |name: String| {
        let mut name = ascii(&name);
        while is_keyword(&name) || !taken.insert(name.clone()) {
            name.push('_');
        }
        name
    };
    names.into_iter().map(free).collect()
}

fn is_keyword(name: &str) -> bool {
    KEYWORDS.split(' ').any(|keyword| keyword == name)
}

/// The name with every letter that a C compiler may not know by its number: `θ` as `u03b8`.
fn ascii(name: &str) -> String {
    let letter = |letter: char| match letter.is_ascii() {
        true => letter.to_string(),
        false => format!("u{:04x}", u32::from(letter)),
    };
    name.chars().map(letter).collect()
}

/// The words of C and C++; those that are Rust's too may come as `r#do`.
const KEYWORDS: &str = "\
    alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t \
    char32_t char8_t class co_await co_return co_yield compl concept const const_cast \
    consteval constexpr constinit continue decltype default delete do double dynamic_cast else \
    enum explicit export extern false float for friend goto if inline int long mutable \
    namespace new noexcept not not_eq nullptr operator or or_eq private protected public \
    register reinterpret_cast requires restrict return short signed sizeof static \
    static_assert static_cast struct switch template this thread_local throw true try typedef \
    typeid typename typeof union unsigned using virtual void volatile wchar_t while xor xor_eq";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_type_name_becomes_the_start_of_function_names() {
        for (name, snake) in [
            ("FlyingShear", "flying_shear"),
            ("FourBar2", "four_bar2"),
            ("Stage2Ram", "stage2_ram"),
            ("RRRDyad", "rrr_dyad"),
            ("Ω", "u03c9"),
        ] {
            assert_eq!(snake_case(name), snake);
        }
    }

    #[test]
    fn names_that_c_reserves_or_that_meet_get_a_tail() {
        let names = ["int", "int_", "BC", "θ", "void", "xor_eq", "do"].map(str::to_string);
        let distinct = distinct(names);
        assert_eq!(distinct, ["int_", "int__", "BC", "u03b8", "void_", "xor_eq_", "do_"]);
    }
}
