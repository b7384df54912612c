//! Declarations of links and joints beside the same machine with its groups declared: the two
//! expand to equal code.

use proc_macro2::TokenStream;

use super::{fuzz, numbered_anew, parts, pipeline};
use crate::pipeline::Options;

/// The code without its documentation, and the mistakes.
fn expanded(source: &str) -> (TokenStream, Vec<String>) {
    let tokens = source.parse().expect("these are tokens");
    let expansion = pipeline::compile(tokens, &Options::NONE).tokens;
    let messages = fuzz::messages(expansion.clone());
    (parts::without_docs(expansion), messages)
}

fn tokens(text: &str) -> TokenStream {
    text.parse().expect("these are tokens")
}

/// The code without the constant that only drawings have.
fn without_drawing(code: TokenStream) -> TokenStream {
    let text = code.to_string();
    let Some(from) = text.find("pub const DRAWN") else { return code };
    // Its type has a semicolon as well.
    let equals = from + text[from..].find('=').expect("a constant has a value");
    let end = equals + text[equals..].find(';').expect("a constant ends");
    tokens(&(text[..from].to_string() + &text[end + 1..]))
}

/// The hash of a part of the code, whose delimiters need not fit.
fn numbered(code: &str) -> String {
    numbered_anew(tokens(&code.replace(['(', ')', '[', ']', '{', '}'], " ; ")))
}

fn expand_alike(name: &str, drawn: &str, groups: &str) {
    let declared = |statements: &str| format!("pub struct {name} {{ {statements} }}");
    let [(a, messages), (b, none)] = [drawn, groups].map(|text| expanded(&declared(text)));
    assert_eq!(messages, Vec::<String>::new(), "{name}");
    assert_eq!(none, Vec::<String>::new(), "{name}");
    // Editors find other names in another text.
    let for_editors =
        |text: String| text[..text.find("struct Names_").expect("it names its names")].to_string();
    let [a, b] = [without_drawing(a), b].map(|code| for_editors(code.to_string()));
    if numbered(&a) != numbered(&b) {
        let same = a.bytes().zip(b.bytes()).take_while(|(a, b)| a == b).count();
        let around =
            |text: &str| text[same.saturating_sub(200)..].chars().take(400).collect::<String>();
        panic!("{name}:\n{}\n\n{}", around(&a), around(&b));
    }
}

#[test]
fn machines_of_bars_are_cut_as_by_hand() {
    expand_alike(
        "FourBar",
        "input theta: angle; ground A(0, 0), D(304.8mm, 0);
         pin B(100mm, 10mm), C(320mm, 170mm);
         link AB(A, B) { length: 101.6mm } link BC(B, C) { length: 254mm }
         link DC(D, C) { length: 177.8mm }
         drive AB.angle = theta;",
        "input theta: angle; ground A(0, 0), D(304.8mm, 0);
         crank AB(A) -> B { length: 101.6mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }",
    );
    expand_alike(
        "FlyingShear",
        "input theta: angle; ground A(0, 0), D(665.7mm, 0);
         pin B(-30mm, 70mm), C(570mm, -360mm);
         link AB(A, B) { length: 80mm } link BC(B, C) { length: 632mm }
         link DC(D, C) { length: 374mm }
         drive AB.angle = theta;
         point blade on BC at (500mm, -60mm);",
        "input theta: angle; ground A(0, 0), D(665.7mm, 0);
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
         point blade on BC at (500mm, -60mm);",
    );
    expand_alike(
        "JansenLeg",
        "input theta: angle; ground A(0, 0), D(-38cm, -7.8cm);
         pin B(0, 15cm), U(-43cm, 33cm), L(-40cm, -35cm), F(-75cm, -30cm);
         link AB(A, B) { length: 15cm } drive AB.angle = theta;
         link upper(B, U) { length: 50cm } link b(D, U) { length: 41.5cm }
         link lower(B, L) { length: 61.9cm } link c(D, L) { length: 39.3cm }
         point E on b at distances (40.1cm, 55.8cm) left;
         link f(E, F) { length: 39.4cm } link g(L, F) { length: 36.7cm }
         point foot on g at distances (49cm, 65.7cm) left;",
        "input theta: angle; ground A(0, 0), D(-38cm, -7.8cm);
         crank AB(A) -> B { length: 15cm, angle: theta }
         rrr upper(B), b(D) -> U { lengths: (50cm, 41.5cm), mode: right }
         rrr lower(B), c(D) -> L { lengths: (61.9cm, 39.3cm), mode: left }
         point E on b at distances (40.1cm, 55.8cm) left;
         rrr f(E), g(L) -> F { lengths: (39.4cm, 36.7cm), mode: right }
         point foot on g at distances (49cm, 65.7cm) left;",
    );
    expand_alike(
        "Transplanter",
        "input first, second: angle; param r1 = 60mm; param r2 = 60mm; param l1 = 240mm;
         param l2 = 240mm; param tip_x = 380mm; param tip_y = -60mm;
         ground A(0, 0), D(160mm, 60mm); pin B(0, 60mm), E(160mm, 120mm), C(160mm, -110mm);
         link AB(A, B) { length: r1 } link DE(D, E) { length: r2 }
         link BC(B, C) { length: l1 } link EC(E, C) { length: l2 }
         drive AB.angle = first; drive DE.angle = second;
         point bill on BC at (tip_x, tip_y);",
        "input first, second: angle; param r1 = 60mm; param r2 = 60mm; param l1 = 240mm;
         param l2 = 240mm; param tip_x = 380mm; param tip_y = -60mm;
         ground A(0, 0), D(160mm, 60mm);
         crank AB(A) -> B { length: r1, angle: first } crank DE(D) -> E { length: r2, angle: second }
         rrr BC(B), EC(E) -> C { lengths: (l1, l2), mode: right }
         point bill on BC at (tip_x, tip_y);",
    );
}

#[test]
fn machines_with_slides_are_cut_as_by_hand() {
    expand_alike(
        "OffsetSliderCrank",
        "input theta: angle; param desaxe = 12mm; ground A(0, 0); guide bore through A along 90deg;
         pin B(43mm, 0), P(-desaxe, 130mm);
         link AB(A, B) { length: 43mm } link rod(B, P) { length: 136mm }
         link piston(P) on bore; drive AB.angle = theta;",
        "input theta: angle; param desaxe = 12mm; ground A(0, 0); guide bore through A along 90deg;
         crank AB(A) -> B { length: 43mm, angle: theta }
         rrp rod(B), piston(bore) -> P { length: 136mm, offset: desaxe, mode: ahead }",
    );
    expand_alike(
        "SixBar",
        "input theta: angle; ground A(0, 0), D(0, -1m); guide rail through (0, 0.8m) along 0deg;
         pin B(0, 0.4m), E(0, 0.6m);
         link AB(A, B); link rod(D, E); guide swing on rod through D towards E;
         link block(B) on swing; drive AB.angle = theta;
         link ram() on rail; guide slot on ram through E along 90deg; link pin(E) on slot;",
        "input theta: angle; ground A(0, 0), D(0, -1m); guide rail through (0, 0.8m) along 0deg;
         crank AB(A) -> B { length: 0.4m, angle: theta }
         rpr block(B), rod(D) { mode: ahead }
         point E on rod at (1.6m, 0);
         rpp pin(E), ram(rail) { slot: 90deg }",
    );
}
