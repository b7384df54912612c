//! The words of the language: which begin a statement, and which cannot be chosen as names.

/// Words that `_` parts, in front of or behind a type's name: `left_hand` as `LeftHand`.
pub(crate) fn in_capitals(words: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<String>()
    };
    words.split('_').map(capital).collect()
}

/// Words that begin a statement with braces: drivers, then Assur groups.
pub(super) use super::anatomy::KEYWORDS as GROUPS;

/// Words that keep their place for the statements of today and of later versions.
const RESERVED: [&str; 22] = [
    "mass",
    "inertia",
    "force",
    "torque",
    "spring",
    "damper",
    "gravity",
    "load",
    "triad",
    "assembly",
    "all",
    "uniform",
    "between",
    "towards",
    "distances",
    "polar",
    "near",
    "mirrored",
    "on",
    "at",
    "along",
    "through",
];

/// Words that stand for something wherever an expression or a reference may stand.
const MEANINGFUL: [&str; 10] = [
    "pi",
    "ground",
    "left",
    "right",
    "ahead",
    "behind",
    // Outputs of the whole mechanism.
    "energy",
    "shaking",
    "centre_of_mass",
    "losses",
];

/// Strict and reserved keywords of every Rust edition; generated fields could not bear them.
const RUST: [&str; 53] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
    "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl",
    "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
    "return", "self", "Self", "static", "struct", "super", "trait", "true", "try", "type",
    "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield", "_",
];

/// The units a number may have.
pub const UNITS: [&str; 16] =
    ["m", "mm", "cm", "um", "in", "ft", "rad", "deg", "turn", "kg", "g", "t", "N", "kN", "s", "ms"];

/// Units that are as likely a name: `2 s` may want an operator.
pub(crate) const LIKELY_NAMES: [&str; 3] = ["s", "t", "N"];

pub(super) fn is_rust_keyword(word: &str) -> bool {
    RUST.contains(&word)
}

pub(super) fn is_reserved(word: &str) -> bool {
    // `in` is both; what counts for a statement is that its meaning is kept for later.
    RESERVED.contains(&word) || word == "in"
}

/// Why `word` cannot be chosen as a name: the end of a message and its reason.
pub(super) fn refusal(word: &str) -> Option<(&'static str, &'static str)> {
    const FIELD: &str = "names become fields and arguments of the generated code";
    match word {
        "_" => Some(("is not a name; choose one", FIELD)),
        _ if word.starts_with("r#") => Some(("is a raw identifier; choose another name", FIELD)),
        _ if is_rust_keyword(word) => Some(("is a Rust keyword; choose another name", FIELD)),
        _ if is_reserved(word) => Some((
            "is a reserved word; choose another name",
            "statements of this and of later versions are made of it",
        )),
        _ if MEANINGFUL.contains(&word) => Some((
            "already has a meaning; choose another name",
            "expressions and fields could not tell the two apart",
        )),
        _ => None,
    }
}

/// The statement meant by a word that other languages use for it.
pub(super) fn meant_by(word: &str) -> Option<&'static str> {
    match word {
        "const" | "static" | "var" | "def" => Some("let"),
        "fixed" | "pivot" | "base" | "frame" | "anchor" => Some("ground"),
        "line" | "rail" | "axis" => Some("guide"),
        "marker" => Some("point"),
        "parameter" | "variable" => Some("param"),
        "motor" | "driver" => Some("crank"),
        "piston" | "actuator" => Some("slider"),
        "find" => Some("solve"),
        _ => None,
    }
}

/// The construction that replaces an element for which the language has no word.
pub(crate) fn built_by(word: &str) -> Option<&'static str> {
    match word {
        "gear" | "wheel" | "pulley" | "sprocket" | "belt" | "chain" => Some(
            "a gear is a crank whose angle is a multiple of another's: \
             `crank G(O) { angle: -2 * AB.angle }`",
        ),
        "rack" => Some("a rack is a slider, and its pinion a crank: `angle: ram.slide / 40mm`"),
        "bar" | "rod" | "link" | "rocker" | "coupler" | "lever" | "arm" => Some(
            "bars come in pairs, as dyads: `rrr BC(B), DC(D) -> C { lengths: (…, …), mode: left }`",
        ),
        "cylinder" | "strut" => Some(
            "a cylinder is a bar whose length is an input: `rrr cyl(D), boom(A) -> C { lengths: \
             (lift, 2m), mode: right }`",
        ),
        "damper" | "dashpot" | "shock_absorber" => Some(
            "a damper is a spring without stiffness: `spring between P and Q { damping: \
             10(N*s/m) }`",
        ),
        "brake" | "drag" => Some(
            "a brake is a force or a torque by a rate: `torque -c * rate(AB.angle) on AB`; what a joint's \
             load brakes is `friction 0.1 at C radius 8mm`",
        ),
        "joint" | "pin" | "hinge" | "revolute" | "prismatic" => {
            Some("joints are made by the groups they belong to, and fixed ones by `ground`")
        }
        _ => None,
    }
}
