//! That no text lies on a joint, a link, a support, an arrow or another text, and nothing is cut off:
//! in every picture, small and large, at every time. Debian's `chromium` has to be there:
//! `cargo test --release -p gallery -- --ignored layout`.

use std::fmt::Write;

use gallery::{figures, pieces};
use linkage_core::sketch::Theme;

use super::chromium::run;

/// A page of pictures with their names, poses and durations.
#[derive(Default)]
struct Pictures {
    texts: String,
    names: String,
}

impl Pictures {
    fn push(&mut self, name: &str, text: &str, poses: usize, seconds: f64) {
        self.texts += text;
        write!(self.names, "[{name:?}, {poses}, {seconds}],").unwrap();
    }

    /// The number of texts examined, and the faults found.
    fn check(&self, name: &str) -> (usize, Vec<String>) {
        let page = format!(
            "<!DOCTYPE html><body><pre></pre>{}<script>const pictures = [{}];{}</script>",
            self.texts,
            self.names,
            include_str!("layout.js")
        );
        let found = run(&page, name, &["--virtual-time-budget=8000"]);
        let mut lines = found.lines().map(str::to_string);
        let count = lines.next().expect("a number comes first");
        (count.parse().expect("it is one"), lines.collect())
    }
}

fn no_text_lies_on_anything_at(width: f64) {
    let mut pictures = Pictures::default();
    for piece in pieces() {
        let film = piece.film.width(width);
        let (still, name) = (film.still().to_svg().unwrap(), piece.name);
        pictures.push(name, &film.to_svg().unwrap(), film.len(), film.duration());
        pictures.push(&format!("{name} still"), &still, 1, 1.0);
    }
    let (count, wrong) = pictures.check(&format!("films_{width}"));
    println!("{width} px: {count} texts");
    assert!(count > 5000, "{count}");
    assert!(wrong.is_empty(), "{width} px:\n{}", wrong.join("\n"));
}

// Two tests, which run at the same time.

#[test]
#[ignore = "needs chromium"]
fn no_text_of_a_small_film_lies_on_anything_and_nothing_is_cut_off() {
    no_text_lies_on_anything_at(360.0);
}

#[test]
#[ignore = "needs chromium"]
fn no_text_of_a_large_film_lies_on_anything_and_nothing_is_cut_off() {
    no_text_lies_on_anything_at(720.0);
}

#[test]
#[ignore = "needs chromium"]
fn no_text_of_a_figure_lies_on_anything_and_nothing_is_cut_off() {
    let mut pictures = Pictures::default();
    for (name, text) in figures::figures(Theme::Light).unwrap() {
        pictures.push(name, &text, 1, 1.0);
    }
    let (count, wrong) = pictures.check("figures");
    assert!(count > 60, "{count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The check itself finds what is wrong.
#[test]
#[ignore = "needs chromium"]
fn a_text_on_a_joint_a_link_a_text_and_the_edge_is_found() {
    let wrong = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 100" width="200" height="100"><rect width="200" height="100" fill="#fff"/><g data-link="AB"><path d="M20 50H180" stroke="#d55e00" stroke-width="5"/></g><circle data-point="A" cx="20" cy="20" r="4.6" stroke="#222222"/><text x="40" y="52" font-size="13">link</text><text x="18" y="23" font-size="13">joint</text><text x="60" y="55" font-size="13">text</text><text x="190" y="90" font-size="13">edge</text><text x="100" y="80" font-size="13">free</text></svg>"##;
    let mut pictures = Pictures::default();
    pictures.push("wrong", wrong, 1, 1.0);
    let (count, mut found) = pictures.check("wrong");
    found.sort();
    assert_eq!(count, 5);
    assert_eq!(
        found,
        [
            "wrong pose 0 edge on the edge",
            "wrong pose 0 joint on joint A",
            "wrong pose 0 link on link AB",
            "wrong pose 0 text on link AB",
            "wrong pose 0 text on text link",
        ]
    );
}
