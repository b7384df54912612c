//! Ratios of rates, poles and transmission angles: printed, and to the last bit what C answers, in both widths; or refused
//! by name. C is compared with Rust where the declarations stand.

use linkage_compiler::st;

use super::against_c::Counts;
use super::all;

/// The machines of a file by their names.
fn machines(file: &str) -> Vec<(String, proc_macro2::TokenStream)> {
    let named = all().into_iter().filter(|(path, _)| path.ends_with(file)).map(|(_, tokens)| {
        let mut words = tokens
            .to_string()
            .split_whitespace()
            .map(str::to_string)
            .collect::<Vec<_>>()
            .into_iter();
        words.find(|word| word == "struct").expect("a declaration has a struct");
        (words.next().expect("it has a name"), tokens)
    });
    named.collect()
}

#[test]
fn words_answer_as_c_does() {
    let mut counts = Counts::default();
    let (mut printed, mut refused) = (Vec::new(), Vec::new());
    for (nth, (name, tokens)) in machines("right/word_machines.rs").into_iter().enumerate() {
        match counts.compare_one(&(name.clone(), tokens), 200, &format!("words_{nth}"), nth) {
            Some(true) => printed.push(name),
            Some(false) => refused.push(name),
            None => return,
        }
    }
    assert_eq!(printed, ["Rear", "Groups", "EqualBars"]);
    assert_eq!(refused, ["ByTravel"]);
    println!("{counts:?}");
    assert!(counts.answered > 1000 && counts.refused > 500, "{counts:?}");
}

/// Words become numbers and points of the pose, with rates in a motion.
#[test]
fn words_are_results_of_blocks() {
    for (name, tokens) in machines("right/word_machines.rs") {
        let printed = st(tokens, &["motion", "f64"], None, false);
        let results: &[&str] = match &name[..] {
            "Rear" => &[
                "leverage : LREAL;",
                "size : LREAL;",
                "path : LREAL;",
                "I : LinkagePoint;",
                "K : LinkagePoint;",
            ],
            "Groups" => {
                &["stroke : LREAL;", "bar_transmission : LREAL;", "block_transmission : LREAL;"]
            }
            "EqualBars" => &["I : LinkagePoint;", "stroke : LREAL;"],
            _ => {
                let told = printed.expect_err("it has a search");
                assert_eq!(
                    told[0].message,
                    "structured text has no search for `lower` of `ByTravel`"
                );
                continue;
            }
        };
        let text = &printed.expect("it is printed")[0].text;
        results.iter().for_each(|part| assert!(text.contains(part), "no `{part}` in\n{text}"));
    }
}
