//! Constants that Rust, C and JavaScript share are printed from the items of Rust into the texts of the others, which
//! are written by hand beside them: `LINKAGE_RENEW=1 cargo test -p linkage-compiler-tests shared_constants`.

use std::path::PathBuf;

use proc_macro2::{TokenStream, TokenTree};

/// A constant where it is printed: what stands in front of it and behind it, and its digits.
struct Place {
    file: &'static str,
    before: &'static str,
    digits: String,
    after: &'static str,
}

const CORE: &str = "linkage-core/src";
const COMPILER: &str = "linkage-macros/compiler/src";

fn path(of: &str, file: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../..").join(of).join(file)
}

fn read(of: &str, file: &str) -> String {
    std::fs::read_to_string(path(of, file)).expect("the file can be read")
}

/// The digits of the numbers among tokens, as they are written.
fn digits(tokens: impl IntoIterator<Item = TokenTree>) -> Vec<String> {
    let (mut found, mut sign) = (Vec::new(), "");
    for token in tokens {
        match &token {
            TokenTree::Group(group) => found.extend(digits(group.stream())),
            TokenTree::Literal(number) => {
                found.push(format!("{sign}{}", number.to_string().replace('_', "")));
            }
            _ => {}
        }
        let is_minus = matches!(&token, TokenTree::Punct(minus) if minus.as_char() == '-');
        sign = if is_minus { "-" } else { "" };
    }
    found
}

/// The digits of everything by this name: of a constant, of a list behind a colon, and of the arguments of a call.
fn named(tokens: TokenStream, name: &str, found: &mut Vec<Vec<String>>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let is =
        |token: &TokenTree, sign| matches!(token, TokenTree::Punct(own) if own.as_char() == sign);
    for (at, token) in tokens.iter().enumerate() {
        match (token, tokens.get(at + 1)) {
            (TokenTree::Ident(own), Some(TokenTree::Group(arguments))) if own == name => {
                found.push(digits(arguments.stream()));
            }
            (TokenTree::Ident(own), Some(colon)) if own == name && is(colon, ':') => {
                let rest = tokens[at + 2..].iter();
                let value: Vec<_> =
                    rest.take_while(|token| !is(token, ';') && !is(token, ',')).cloned().collect();
                let start = value.iter().position(|token| is(token, '=')).unwrap_or_default();
                found.push(digits(value[start..].to_vec()));
            }
            (TokenTree::Group(group), _) => named(group.stream(), name, found),
            _ => {}
        }
    }
}

/// So many constants of this name, in the order in which they stand in a file.
fn constants<const N: usize>(of: &str, file: &str, name: &str) -> [Vec<String>; N] {
    let tokens: TokenStream = read(of, file).parse().expect("the file is Rust");
    let mut found = Vec::new();
    named(tokens, name, &mut found);
    found.retain(|digits| !digits.is_empty());
    found.try_into().unwrap_or_else(|found| panic!("{found:?} are called {name} in {file}"))
}

/// A list; in C a number in single precision ends in a letter.
fn list(digits: &[String], ending: &str) -> String {
    digits.iter().map(|digits| format!("{digits}{ending}")).collect::<Vec<_>>().join(", ")
}

/// A power of two in JavaScript.
fn power(digits: &str) -> String {
    let value: f64 = digits.parse().expect("it is a number");
    let exponent = value.log2();
    assert_eq!((exponent.fract(), exponent.exp2()), (0.0, value));
    format!("2 ** {exponent}")
}

fn whole(digits: &str) -> String {
    digits.strip_suffix(".0").expect("it is whole").to_string()
}

/// Constants of the kernels: the digits of both widths, the words in C and the places in JavaScript.
fn of_kernels() -> Vec<Place> {
    let [quarters, sines, tangents] = ["quarter", "asin", "atan"].map(|name| {
        let both: [Vec<String>; 2] = constants(CORE, "kernels/arc.rs", name);
        both
    });
    let splitters: [Vec<String>; 2] = constants(CORE, "kernels/arithmetic.rs", "SPLITTER");
    let limit = |file| -> Vec<String> {
        let [limit] = constants(CORE, file, "LIMIT");
        limit
    };
    let limits = ["kernels/sin_cos_f64.rs", "kernels/sin_cos_f32.rs"].map(limit);
    let mut places = Vec::new();
    for (before, widths) in [
        ("(\"SPLITTER\",", &splitters),
        ("(\"NEAR\",", &limits),
        ("(\"QUARTER_LOW\",", &quarters),
        ("\"ARC_SINE\",", &sines),
        ("\"ARC_TANGENT\",", &tangents),
    ] {
        for (of_width, ending) in widths.iter().zip(["", "f"]) {
            let digits = format!("\"{}\"", list(of_width, ending));
            places.push(Place { file: "codegen/c/run_time.rs", before, digits, after: ")," });
        }
    }
    let kernels = |before, digits: String, after| Place {
        file: "sketch/page/kernels.js",
        before,
        digits,
        after,
    };
    let of_turns = |name| -> Vec<String> {
        let [digits] = constants(CORE, "kernels/sin_cos_f64.rs", name);
        digits
    };
    let far = |before, after| Place {
        file: "codegen/c/run/far.c",
        before,
        digits: quarters[0][0].clone(),
        after,
    };
    places.extend([
        far("+ (rest[0] * ", " + rest[1]"),
        kernels("const scaled = ", whole(&splitters[0][0]), " * x,"),
        kernels("const scaled = x * ", whole(&splitters[0][0]), ", high"),
        kernels("const NEAR = ", power(&limits[0][0]), ", SHIFT"),
        kernels("QUARTER_LOW = ", quarters[0][0].clone(), ", EIGHTH"),
        kernels("const ASIN = [", list(&sines[0], ""), "];"),
        kernels("const ATAN = [", list(&tangents[0], ""), "];"),
        kernels(", REST = ", of_turns("REST").concat(), ";"),
        kernels("const [C1, C2, C3, C4] = [", list(&of_turns("PARTS"), ""), "];"),
        kernels("const [S0, S1, S2, S3, S4, S5] = [", list(&of_turns("SINE"), ""), "];"),
        kernels("const [K0, K1, K2, K3, K4, K5] = [", list(&of_turns("COSINE"), ""), "];"),
    ]);
    places
}

/// The words before the difference that an equation may leave, without `double` and with it.
const PERMITTED: &str = "float size)\n{\n    (void)why;\n    return ";
const WIDELY: &str = "    return why->is_single ? (double)(";

/// Constants of conditions, and the most joints whose friction depends on each other.
fn of_conditions() -> Vec<Place> {
    let [roundings] = constants(CORE, "limit.rs", "ROUNDINGS");
    let [open] = constants(CORE, "diagnosis/search.rs", "lit");
    let [joints] = constants(COMPILER, "equations/forces/friction/forward.rs", "MOST");
    let place = |file, before, digits: String, after| Place { file, before, digits, after };
    vec![
        place("lower/ranges.rs", "const ROUNDINGS: f64 = ", roundings[0].clone(), ";"),
        place("codegen/c/run/wide.c", "#define ROUNDINGS ", whole(&roundings[0]), "\n"),
        place("sketch/page/limit.js", "const ROUNDINGS = ", whole(&roundings[0]), ", ULPS"),
        place("codegen/c/in_c.rs", "const OPEN_BY: (f64, f32) = (", list(&open, ""), ");"),
        place("codegen/c/run/wide.c", PERMITTED, format!("{}f", open[1]), " * size;"),
        place("codegen/c/run/wide.c", WIDELY, format!("{}f", open[1]), " * (float)size"),
        place("codegen/c/run/wide.c", "(float)size) : ", open[0].clone(), " * size;"),
        place("sketch/page/checks.js", "const OPEN = ", power(&open[0]), ", ENDS"),
        place("codegen/c/run/friction/head.c", "#define MOST ", joints[0].clone(), "\n"),
        place("model/statements/contacts.rs", "const MOST: usize = ", joints[0].clone(), ";"),
    ]
}

/// A text without what is set by hand: spaces, the ends of lines, and commas behind the last.
fn squeezed(text: &str) -> String {
    let kept: String =
        text.chars().filter(|c| !c.is_whitespace() && !['_', '\\'].contains(c)).collect();
    kept.trim_end_matches(',').to_string()
}

/// The digits in the lines of those that stood there, if there are as many.
fn relaid(old: &str, digits: &str) -> String {
    let (mut text, mut rest) = (String::new(), old);
    for number in digits.trim_matches('"').split(", ") {
        let start = rest.find(|c: char| c.is_ascii_digit() || c == '-').unwrap_or(rest.len());
        let end = rest[start..].find([',', '"', '\n']).map_or(rest.len(), |at| start + at);
        text += &[&rest[..start], number].concat();
        rest = &rest[end..];
    }
    text += rest;
    if squeezed(&text) == squeezed(digits) { text } else { digits.to_string() }
}

/// Two places that begin alike follow each other in a file: that of double precision stands first.
#[test]
fn shared_constants_are_those_of_rust() {
    let renews = std::env::var_os("LINKAGE_RENEW").is_some();
    let (mut last, mut stale) = (("", ""), Vec::new());
    let mut from = 0;
    for Place { file, before, digits, after } in of_kernels().into_iter().chain(of_conditions()) {
        let of = if file.ends_with(".js") { CORE } else { COMPILER };
        let text = read(of, file);
        from = if last == (file, before) { from } else { 0 };
        let start = text[from..].find(before).map(|at| from + at + before.len());
        let start = start.unwrap_or_else(|| panic!("{before} stands in {file}"));
        let end = text[start..].find(after).map(|at| start + at);
        let end = end.unwrap_or_else(|| panic!("{after} stands behind {before} in {file}"));
        if squeezed(&text[start..end]) != squeezed(&digits) {
            stale.push(format!("{file}: {before} {digits}"));
            if renews {
                let printed = relaid(&text[start..end], &digits);
                let text = [&text[..start], &printed, &text[end..]].concat();
                std::fs::write(path(of, file), text).expect("the file can be written");
            }
        }
        (last, from) = ((file, before), start);
    }
    assert!(renews || stale.is_empty(), "not as in Rust:\n{}", stale.join("\n"));
}
