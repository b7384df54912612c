//! Declarations of links and joints beside the same machine with its groups declared: the two
//! expand to equal code.

use super::{fuzz, numbered_anew, parts, pipeline, texts};
use crate::pipeline::Options;

/// The code without its documentation, token by token, and the mistakes.
pub(super) fn expanded(source: &str) -> (Vec<String>, Vec<String>) {
    let tokens = source.parse().expect("these are tokens");
    let expansion = pipeline::compile(tokens, &Options::NONE).tokens;
    let messages = fuzz::messages(expansion.clone());
    let code = texts(expansion);
    (parts::without_docs(&code).iter().map(ToString::to_string).collect(), messages)
}

/// The place of these tokens.
fn place(code: &[String], words: &[&str]) -> Option<usize> {
    code.windows(words.len()).position(|window| window == words)
}

/// The code without the constant that only drawings have.
fn without_drawing(mut code: Vec<String>) -> Vec<String> {
    let Some(from) = place(&code, &["pub", "const", "DRAWN"]) else { return code };
    // Its type has a semicolon as well.
    let equals = from + place(&code[from..], &["="]).expect("a constant has a value");
    let end = equals + place(&code[equals..], &[";"]).expect("a constant ends");
    code.drain(from..=end);
    code
}

fn expand_alike(name: &str, drawn: &str, groups: &str) {
    let declared = |statements: &str| format!("pub struct {name} {{ {statements} }}");
    let [(a, messages), (b, none)] = [drawn, groups].map(|text| expanded(&declared(text)));
    assert_eq!(messages, Vec::<String>::new(), "{name}");
    assert_eq!(none, Vec::<String>::new(), "{name}");
    let [a, b] = [without_drawing(a), b];
    // Editors find other names in another text.
    let [a, b] = [&a, &b].map(|code| {
        let is_for_editors = |pair: &[String]| pair[0] == "struct" && pair[1].starts_with("Names_");
        let end = code.windows(2).position(is_for_editors).expect("it names its names");
        code[..end].iter().map(String::as_str).collect::<Vec<_>>()
    });
    if numbered_anew(&a) != numbered_anew(&b) {
        let same = a.iter().zip(&b).take_while(|(a, b)| a == b).count();
        let around = |code: &[&str]| {
            let from = same.saturating_sub(40);
            code[from..].iter().copied().take(80).collect::<Vec<_>>().join(" ")
        };
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
         pin B(0, 15cm), U(-47cm, 33cm), L(-21cm, -43cm), F(-57cm, -47cm);
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
         link ram() on rail; guide slot on ram through (0, 0) along 90deg; link pin(E) on slot;",
        "input theta: angle; ground A(0, 0), D(0, -1m); guide rail through (0, 0.8m) along 0deg;
         crank AB(A) -> B { length: 0.4m, angle: theta }
         rpr block(B), rod(D) { mode: ahead }
         point E on rod at (1.6m, 0);
         rpp pin(E), ram(rail) { slot: 90deg }",
    );
}

#[test]
fn machines_with_cylinders_points_and_parameters_are_cut_as_by_hand() {
    expand_alike(
        "Excavator",
        "input lift, crowd, curl: length; ground O(0, 1.7m), F(0.6m, 1.2m);
         pin G(2m, 3m), J(5m, 4.5m), V(5.9m, 1.4m), W(5.5m, 0.9m);
         link lift_ram(F, G) { length: lift } link boom(O, G) { length: 2.4m }
         point S on boom at (5.4m, -0.9m); point H on boom at (2.6m, 0.55m);
         link crowd_ram(H, J) { length: crowd } link stick(S, J) { length: 0.8m }
         point T on stick at (-2.7m, 0.2m); point N on stick at (-0.2m, -0.5m);
         point K on stick at (-2.3m, 0);
         link curl_ram(N, V) { length: curl } link lever(K, V) { length: 0.6m }
         link pull(V, W) { length: 0.6m } link bucket(T, W) { length: 0.45m }
         point tooth on bucket at (-0.4m, -1.4m);",
        "input lift, crowd, curl: length; ground O(0, 1.7m), F(0.6m, 1.2m);
         rrr lift_ram(F), boom(O) -> G { lengths: (lift, 2.4m), mode: right }
         point S on boom at (5.4m, -0.9m); point H on boom at (2.6m, 0.55m);
         rrr crowd_ram(H), stick(S) -> J { lengths: (crowd, 0.8m), mode: left }
         point T on stick at (-2.7m, 0.2m); point N on stick at (-0.2m, -0.5m);
         point K on stick at (-2.3m, 0);
         rrr curl_ram(N), lever(K) -> V { lengths: (curl, 0.6m), mode: left }
         rrr pull(V), bucket(T) -> W { lengths: (0.6m, 0.45m), mode: left }
         point tooth on bucket at (-0.4m, -1.4m);",
    );
}

#[test]
fn machines_with_rods_blocks_and_searches_are_cut_as_by_hand() {
    expand_alike(
        "CrankRockerSlider",
        "input theta: angle; param crank_length = 60mm; param rod_length = 220mm;
         ground A(0, 0), D(200mm, -40mm); guide way through (0, 260mm) along 0deg;
         pin B(60mm, 0), C(190mm, 80mm), F(350mm, 260mm);
         link AB(A, B) { length: crank_length } link BC(B, C) { length: 190mm }
         link DC(D, C) { length: 120mm } drive AB.angle = theta;
         point E on DC at (210mm, 0);
         link EF(E, F) { length: rod_length } link block(F) on way;",
        "input theta: angle; param crank_length = 60mm; param rod_length = 220mm;
         ground A(0, 0), D(200mm, -40mm); guide way through (0, 260mm) along 0deg;
         crank AB(A) -> B { length: crank_length, angle: theta }
         rrr BC(B), DC(D) -> C { lengths: (190mm, 120mm), mode: left }
         point E on DC at (210mm, 0);
         rrp EF(E), block(way) -> F { length: rod_length, offset: 0, mode: ahead }",
    );
    expand_alike(
        "Shaper",
        "input theta: angle; ground A(0, 0), D(0, -250mm); guide way through (0, 50mm) along 180deg;
         pin B(120mm, 0), F(-380mm, 50mm); link AB(A, B); drive AB.angle = theta;
         guide rod on bar through D along 0deg; pin E(155.3mm, 2.4mm);
         link bar(D, E); link block(B) on rod;
         link EF(E, F) { length: 420mm } link ram(F) on way; output ram.slide;",
        "input theta: angle; ground A(0, 0), D(0, -250mm); guide way through (0, 50mm) along 180deg;
         crank AB(A) -> B { length: 120mm, angle: theta }
         rpr block(B), bar(D) {
             offset: (155.3mm * 250mm - 252.4mm * 120mm) / hypot(155.3mm, 252.4mm), mode: ahead
         }
         point E on bar at (hypot(155.3mm, 252.4mm), 0);
         rrp EF(E), ram(way) -> F { length: 420mm, mode: ahead } output ram.slide;",
    );
    expand_alike(
        "Press",
        "input x: length; param seed: near = 90deg; ground A(0, 0); guide bed through (0, 30mm) along 0deg;
         pin B(80mm, 0), C(330mm, 30mm); unknown theta: angle between (6deg, 189deg);
         link AB(A, B); link BC(B, C) { length: 250mm } link ram(C) on bed; drive AB.angle = theta;
         solve theta { ram.slide = x, mode: falling, near: seed } output theta, ram.slide;",
        "input x: length; param seed: near = 90deg; ground A(0, 0); guide bed through (0, 30mm) along 0deg;
         unknown theta: angle between (6deg, 189deg);
         crank AB(A) -> B { length: 80mm, angle: theta }
         rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
         solve theta { ram.slide = x, mode: falling, near: seed } output theta, ram.slide;",
    );
    expand_alike(
        "Inverse",
        "input x, y: length; ground A(-60mm, 0), D(60mm, 0); pin P(0, 300mm), B(-190mm, 120mm),
         E(190mm, 120mm); point P at (x, y);
         link AB(A, B) { length: 180mm } link PB(P, B) { length: 240mm }
         link DE(D, E) { length: 180mm } link PE(P, E) { length: 240mm } output AB, DE;",
        "input x, y: length; ground A(-60mm, 0), D(60mm, 0); point P at (x, y);
         rrr AB(A), PB(P) -> B { lengths: (180mm, 240mm), mode: left }
         rrr DE(D), PE(P) -> E { lengths: (180mm, 240mm), mode: right } output AB, DE;",
    );
}

#[test]
fn links_keep_the_frames_that_they_are_written_in() {
    // The rocker is written from its moving pin, the coupler from its far one.
    expand_alike(
        "Turned",
        "input t: angle; ground A(0, 0), D(400mm, 0); pin B(100mm, 0), C(300mm, 200mm);
         link AB(A, B); link CB(C, B); link DC(D, C); drive AB.angle = t;
         point P on CB at (20mm, 30mm); output C, P, tilt = CB.angle;",
        "input t: angle; ground A(0, 0), D(400mm, 0);
         crank AB(A) -> B { length: 100mm, angle: t }
         rrr CB(B), DC(D) -> C {
             lengths: (hypot(200mm, 200mm), hypot(100mm, 200mm)), mode: left
         }
         point P on CB at (hypot(200mm, 200mm) - 20mm, -30mm); output C, P, tilt = CB.angle + 180deg;",
    );
}
