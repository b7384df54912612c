//! The run-time in C: one header and one source for all mechanisms.
//!
//! Text that is the same in both widths is written once, with words for the number and its constants, and
//! printed for each. Answers are those of the run-time crate to the last bit; tests call both.

use std::sync::LazyLock;

use super::c_identifiers::Width;
use super::header::SHARED;

/// The word in place of which the hash of the run-time stands.
pub(super) const OWN_HASH: &str = "OWN_HASH";

/// 32 bits of a hash of all its texts, by which a source knows the run-time that it was printed with.
static HASH: LazyLock<String> = LazyLock::new(|| {
    let all = [plain_header(), plain_source().to_string(), plain_root(), plain_friction()];
    hash_in_c(&all.concat())
});

/// 32 bits of a hash of a text, as a number in C.
pub(super) fn hash_in_c(text: &str) -> String {
    let hash = fnv(text.bytes());
    format!("0x{:08x}u", (hash >> 32) ^ (hash & 0xffff_ffff))
}

/// FNV-1a: G. Fowler, L. C. Noll and K.-P. Vo.
pub(super) fn fnv(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

/// The lines by which a source asks for this run-time and no other.
pub(super) fn condition() -> String {
    hashed(include_str!("run/condition.h"))
}

fn hashed(text: &str) -> String {
    text.replace(OWN_HASH, &HASH)
}

/// A source behind its first lines, which include the header and ask for it.
fn conditional(source: &str) -> String {
    hashed(&source.replacen(INCLUDE, &format!("{INCLUDE}\n{}", include_str!("run/condition.h")), 1))
}

const INCLUDE: &str = "#include \"linkage_run.h\"\n";

/// The text of `linkage_run.h`.
pub fn header() -> String {
    hashed(&plain_header())
}

fn plain_header() -> String {
    let mut header = format!("{}{SHARED}\n{CODES}\n{WORDS}", include_str!("run/head.h"));
    for (width, near) in [
        (Width::Double, include_str!("run/sin_cos_f64.h")),
        (Width::Single, include_str!("run/sin_cos_f32.h")),
    ] {
        let hooks = of_width(include_str!("run/hooks.h"), width);
        let numbers = of_width(include_str!("run/numbers.h"), width);
        let directions = of_width(include_str!("run/directions.h"), width);
        header += &where_it_is(width, &[&hooks, &numbers, near, &directions].concat());
    }
    header += include_str!("run/pairs.h");
    let (foot, end) =
        include_str!("run/foot.h").split_once(ROOTS).expect("the roots of both widths stand there");
    let both = |text| Width::ALL.map(|width| where_it_is(width, &of_width(text, width))).concat();
    let [roots, friction] = [include_str!("run/root.h"), include_str!("run/friction.h")].map(both);
    header + foot + &roots + &friction + end
}

/// Parts in double precision, for targets that have it; what is in single precision decides for both.
fn where_it_is(width: Width, text: &str) -> String {
    match width {
        Width::Double => format!("\n#ifndef {0}\n{text}\n#endif /* {0} */\n", width.excluded()),
        Width::Single => text.to_string(),
    }
}

/// The functions of the run-time that callers call.
pub(super) const WORDS: &str = include_str!("run/words.h");

/// The line of the foot in place of which the functions stand that find roots.
const ROOTS: &str = "/* Roots. */\n";

/// The text of `linkage_root.c`, which is printed where something is searched.
pub fn root_source() -> String {
    conditional(&plain_root())
}

fn plain_root() -> String {
    let mut source = include_str!("run/root/head.c").to_string();
    for width in Width::ALL {
        let without = width.excluded();
        source += &format!("\n#ifndef {without}\n");
        for text in [
            include_str!("run/root/approach.c"),
            include_str!("run/root/equation.c"),
            include_str!("run/root/survey.c"),
            include_str!("run/root/unknown.c"),
        ] {
            source += &of_width(text, width);
        }
        source += &format!("\n#endif /* {without} */\n");
    }
    source
}

/// The text of `linkage_friction.c`, which is printed where joints rub. What is found without a branch is found in
/// either width, and anything else in double precision, or in pairs of floats where there is none.
pub fn friction_source() -> String {
    conditional(&plain_friction())
}

fn plain_friction() -> String {
    let system = |width| of_width(include_str!("run/friction/system.c"), width);
    let stepped = |width| of_width(include_str!("run/friction/stepped.c"), width);
    let mut source = include_str!("run/friction/head.c").to_string();
    let exact = system(Width::Double) + include_str!("run/friction/solved.c");
    source += &where_it_is(Width::Double, &exact);
    let in_pairs = system(Width::Single) + include_str!("run/friction/pairs.c");
    for (width, before) in [(Width::Double, String::new()), (Width::Single, in_pairs)] {
        let without = width.excluded();
        source += &format!("\n#ifndef {without}\n{before}{}", stepped(width));
        source += &format!("\n#endif /* {without} */\n");
    }
    source
}

/// The text of `linkage_run.c`.
pub fn source() -> String {
    conditional(plain_source())
}

fn plain_source() -> &'static str {
    concat!(
        include_str!("run/wide.c"),
        include_str!("run/conditions.c"),
        include_str!("run/exact.c"),
        include_str!("run/expansions.c"),
        include_str!("run/single.c"),
        include_str!("run/reach.c"),
        include_str!("run/words.c"),
        include_str!("run/far.c"),
    )
}

/// The word of a width that stands for a general one: a number, or a list of them.
pub(in crate::codegen) fn spelling(width: Width, general: &str) -> &'static str {
    let own = words(width).iter().find(|(word, _)| *word == general);
    own.map(|(_, own)| *own).expect("it is a word of the run-time")
}

/// A text with the words of a width in the place of the general ones. `@` ends the names of functions and
/// literals.
fn of_width(text: &str, width: Width) -> String {
    words(width).iter().fold(text.to_string(), |text, (general, own)| text.replace(general, own))
}

type Spelling = [(&'static str, &'static str); 15];

fn words(width: Width) -> &'static Spelling {
    match width {
        Width::Double => &DOUBLE,
        Width::Single => &SINGLE,
    }
}

const DOUBLE: Spelling = [
    ("TYPE", "double precision"),
    ("LINKAGE_FUSES_", "LINKAGE_FUSES"),
    ("OF_WIDTH", "F64"),
    ("LEAST_", "DBL_"),
    ("SPLITTER", "134217729.0"),
    ("HALF_OF_BITS", "32"),
    ("BITS", "uint64_t"),
    ("NEAR", "1048576.0"),
    ("QUARTER_TURN", "1.5707963267948966"),
    ("QUARTER_LOW", "6.123233995736766e-17"),
    ("EIGHTH_TURN", "0.7853981633974483"),
    (
        "ARC_SINE",
        "\
        0.16666666666666669, 0.07499999999998433, 0.04464285714635543, 0.030381944138531247,
        0.02237217294214989, 0.017352392720869973, 0.013971212973552933, 0.011479177415184906,
        0.01032281435018578, 0.005457506718640358, 0.01740087944269402, -0.014851887071247204,
        0.028757851367421566",
    ),
    (
        "ARC_TANGENT",
        "\
        -0.3333333333333333, 0.19999999999999984, -0.14285714285711718, 0.11111111110929807,
        -0.09090909084093506, 0.07692307534369985, -0.06666664203478607, 0.0588232553920069,
        -0.05262931380521779, 0.04760471049395462, -0.043407182638729704, 0.03971908106924452,
        -0.036139320776507194, 0.03213544133307827, -0.02718155333081564, 0.021121594179966983,
        -0.014503079564732733, 0.00844989240397037, -0.004000209679906822,
        0.0014617449054205385, -0.00038394037972999467, 6.417524965866564e-05,
        -5.1088410388226665e-06",
    ),
    ("REAL", "double"),
    ("@", ""),
];

const SINGLE: Spelling = [
    ("TYPE", "single precision"),
    ("LINKAGE_FUSES_", "LINKAGE_FUSESF"),
    ("OF_WIDTH", "F32"),
    ("LEAST_", "FLT_"),
    ("SPLITTER", "4097.0f"),
    ("HALF_OF_BITS", "12"),
    ("BITS", "uint32_t"),
    ("NEAR", "51471.0f"),
    ("QUARTER_TURN", "1.5707964f"),
    ("QUARTER_LOW", "-4.371139e-08f"),
    ("EIGHTH_TURN", "0.7853982f"),
    (
        "ARC_SINE",
        "\
        0.16666666f, 0.07500094f, 0.044599403f, 0.031100662f, 0.017149238f, 0.033690847f",
    ),
    (
        "ARC_TANGENT",
        "\
        -0.33333334f, 0.1999995f, -0.14284004f, 0.11088262f, -0.08931827f, 0.070319146f,
        -0.048960514f, 0.026305001f, -0.009144629f, 0.0014886919f",
    ),
    ("REAL", "float"),
    ("@", "f"),
];

/// Codes that a mechanism's header has where it searches for something, or where something rubs.
const CODES: &str = "\
#define LINKAGE_NO_SOLUTION 8
#define LINKAGE_SEVERAL_DEAD_POINTS 9
#define LINKAGE_JAMS 10
#define LINKAGE_OTHER_ASSEMBLY 11
#define LINKAGE_NOT_CERTIFIED 12
";
