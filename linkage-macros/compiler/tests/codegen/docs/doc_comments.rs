//! Tests of `codegen/docs/doc_comments`.

pub(crate) use linkage_compiler::codegen::docs::doc_comments::*;

#[test]
fn long_lines_are_wrapped_and_their_words_kept() {
    let words = vec!["word"; 40].join(" ");
    let wrapped = |line: &str| {
        let mut text = String::new();
        wrap(line, &mut text);
        text.split('\n').map(|line| line[1..].to_string()).collect::<Vec<_>>()
    };
    let lines = wrapped(&format!("- {words}"));
    assert!(lines.iter().all(|line| line.len() <= WIDTH), "{lines:?}");
    assert!(lines[1].starts_with("  word") && lines.len() == 3, "{lines:?}");
    let text: Vec<&str> = lines.iter().flat_map(|line| line.split_whitespace()).collect();
    assert_eq!(text.join(" "), format!("- {words}"));
    assert_eq!(wrapped("short"), ["short"]);
    let mut text = String::new();
    wrap("", &mut text);
    assert_eq!(text, "");
}
