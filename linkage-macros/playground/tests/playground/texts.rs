//! Texts as they are typed: every prefix, and every letter left out.

use linkage_playground::{ALL, C, CHECK, FMU, IMPORT, RUST, answered};
use serde_json::Value;

use super::MACHINES;

/// The answer to a text, each of whose messages lies inside it. True if there is a page.
fn is_whole(text: &str) -> bool {
    let answer: Value = serde_json::from_slice(&answered(text, CHECK)).expect("an answer is JSON");
    let length = text.encode_utf16().count() as u64;
    let messages = answer["messages"].as_array().expect("there is a list");
    for message in messages {
        let [from, to] =
            ["from", "to"].map(|end| message[end].as_u64().expect("a place is a number"));
        assert!(from <= to && to <= length, "{message} in {length} letters of {text}");
        assert!(message["message"].as_str().is_some_and(|text| !text.is_empty()), "{text}");
    }
    let is_whole = answer["page"].is_string();
    let is_mistaken = messages.iter().any(|message| message["level"] == "error");
    assert!(is_whole != is_mistaken, "a page beside a mistake, or neither: {text}");
    is_whole
}

#[test]
fn every_machine_to_begin_with_has_a_page_and_exports() {
    for (name, text) in MACHINES {
        assert!(is_whole(text), "{name}");
        for task in [C, FMU] {
            assert!(answered(text, task).starts_with(b"PK"), "{name}");
        }
        let rust = String::from_utf8(answered(text, RUST)).expect("it is a text");
        assert!(rust.starts_with("use linkage_core::mechanism;\n\nmechanism! {"), "{name}");
        let all = answered(text, ALL);
        for ending in [".html", ".fmu", ".rs", ".c"] {
            let is_there = all.windows(ending.len()).any(|part| part == ending.as_bytes());
            assert!(is_there, "{name}{ending}");
        }
        // The text between the braces is a declaration too.
        let (_, inner) = text.split_once('{').expect("it is a call");
        assert!(is_whole(inner.trim_end().trim_end_matches('}')), "{name}");
    }
}

/// A machine with two sets of inputs has one page and a solver each in C, and a mistake in either set is told once.
#[test]
fn sets_of_inputs_share_a_page_and_their_mistakes() {
    let text = |hand: &str| {
        format!(
            "mechanism! {{ struct FiveBar {{ ground A(-50mm, 0), E(50mm, 0);
             pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm);
             link AB(A, B), BC(B, tool), CD(D, tool), ED(E, D);
             input motors {{ a = AB.angle, b = ED.angle }} input hand {{ x = tool.x, {hand} }} }} }}"
        )
    };
    let of = |text: &str| -> Value {
        serde_json::from_slice(&answered(text, CHECK)).expect("an answer is JSON")
    };
    let well = text("y = tool.y");
    let answer = of(&well);
    assert_eq!(answer["name"], "FiveBar");
    let page = answer["page"].as_str().expect("there is a page");
    assert!(page.contains("[{set:\"motors\",") && page.contains(",{set:\"hand\","), "{page}");
    let c = answered(&well, C);
    for name in ["five_bar_motors.c", "five_bar_hand.c", "five_bar.h"] {
        assert!(c.windows(name.len()).any(|part| part == name.as_bytes()), "{name}");
    }
    for (hand, said) in [("", "hand"), ("y = tool.z", "tool.z"), ("y = tol.y", "tol")] {
        let wrong = text(hand);
        let answer = of(&wrong);
        assert!(answer["page"].is_null(), "{hand}");
        let messages = answer["messages"].as_array().expect("there is a list");
        let [message] = &messages[..] else { panic!("{answer}") };
        let [from, to] = ["from", "to"].map(|end| message[end].as_u64().expect("it is a place"));
        assert_eq!(&wrong[from as usize..to as usize], said, "{answer}");
    }
}

/// Texts with a mistake have no solver, in any language, and letters of two words are counted as a browser counts them.
#[test]
fn mistakes_have_their_letters_and_nothing_else() {
    let text = "mechanism! { /// 🦿 Ω\n struct Leg { input t: angle; ground A(0, 0); crank AB(Q) -> B { length: 1m, angle: t } } }";
    let answer: Value = serde_json::from_slice(&answered(text, CHECK)).expect("an answer is JSON");
    let from = answer["messages"][0]["from"].as_u64().expect("a place is a number") as usize;
    let units: Vec<u16> = text.encode_utf16().collect();
    assert_eq!(units[from], u16::from(b'Q'), "{answer}");
    for task in [C, FMU, RUST, ALL] {
        assert!(answered(text, task).is_empty() && answered("struct {", task).is_empty());
    }
    for text in
        ["", "}", "{", "\"", "mechanism!", "mechanism! {}", "struct A {}", "r#\"", "\u{0}", "'"]
    {
        assert!(!is_whole(text), "{text}");
    }
}

/// Every eleventh prefix, and every eleventh letter left out; `LINKAGE_WHOLE` takes all.
#[test]
fn a_text_that_is_typed_is_told_inside_it() {
    let step = if std::env::var_os("LINKAGE_WHOLE").is_some() { 1 } else { 11 };
    let (mut whole, mut broken) = (0, 0);
    for (_, text) in MACHINES {
        let places = text.char_indices().map(|(at, _)| at);
        for (nth, at) in places.enumerate().skip(5).step_by(step) {
            let next = text[at..].chars().next().map_or(at, |letter| at + letter.len_utf8());
            let left_out = [&text[..at], &text[next..]].concat();
            for typed in [&text[..at], &left_out] {
                match is_whole(typed) {
                    true => whole += 1,
                    false => broken += 1,
                }
            }
            assert!(nth < text.len());
        }
    }
    assert!(whole * 20 > broken && broken > 2 * whole, "{whole} whole, {broken} broken");
}

/// Each written pair of numbers has its letters, also beside a mistake.
#[test]
fn places_have_their_letters() {
    let text = "mechanism! { struct Ω { input t: angle; ground A(0, 0), D(-2 m, q); pin B(1m, 2 * l), C(3, 0);
        link AB(A, B), BC(B, C), DC(D, R); drive AB.angle = t; point P on BC at (20mm, 1cm); } }";
    let answer: Value = serde_json::from_slice(&answered(text, CHECK)).expect("an answer is JSON");
    assert!(answer["page"].is_null(), "{answer}");
    let units: Vec<u16> = text.encode_utf16().collect();
    let places = answer["places"].as_array().expect("there is a list");
    let found = places.iter().map(|place| {
        let numbers = place["numbers"].as_array().expect("two").iter().map(|ends| {
            let at = |end: usize| ends[end].as_u64().expect("a place is a number") as usize;
            String::from_utf16_lossy(&units[at(0)..at(1)])
        });
        let (name, on) = (place["name"].as_str(), place["on"].as_str());
        format!("{} {} {}", name.unwrap(), on.unwrap_or("-"), numbers.collect::<Vec<_>>().join("|"))
    });
    let found: Vec<String> = found.collect();
    let wanted = ["A - 0|0", "D - -2 m|q", "B - 1m|2 * l", "C - 3|0", "P BC 20mm|1cm"];
    assert_eq!(found, wanted);
}

/// Machines of other programs become a declaration that has a page; anything else is refused in words.
#[test]
fn machines_of_others_are_declarations() {
    for text in [
        include_str!("../../../command/tests/machines/pmks/four_bar.txt"),
        include_str!("../../../command/tests/machines/pmks/slider_crank.txt"),
        include_str!("../../../command/tests/machines/pylinkage/coupler_curve.json"),
    ] {
        let answer: Value =
            serde_json::from_slice(&answered(text, IMPORT)).expect("an answer is JSON");
        let declaration = answer["text"].as_str().expect("it is read");
        assert!(is_whole(declaration), "{declaration}");
    }
    for text in ["", "nonsense", "{", "{}", "https://app.pmksplus.com/?", "M[]", "?\u{0}"] {
        let answer: Value =
            serde_json::from_slice(&answered(text, IMPORT)).expect("an answer is JSON");
        assert!(answer["mistake"].as_str().is_some_and(|why| !why.is_empty()), "{text}: {answer}");
    }
}
