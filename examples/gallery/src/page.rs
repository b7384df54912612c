//! The gallery as a site: an index by kind of machine, and a page for each.

use std::path::Path;

use linkage_core::sketch::SketchError;

use crate::declarations::{NAMES, TEXTS};
use crate::{Kind, Piece, live};

const HEAD: &str = r##"<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Mechanisms</title>
<style>
body { margin: 0; padding: 16px; font: 15px/1.5 "Helvetica Neue", Arial, sans-serif; background: #f4f5f6; color: #222222; }
main, header { max-width: 1330px; margin: auto; }
h1 { font-size: 24px; margin: 8px 0; }
h2 { font-size: 19px; margin: 32px 0 12px; }
nav { display: flex; flex-wrap: wrap; gap: 4px 20px; }
section { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 320px), 1fr)); gap: 16px; }
section h2 { grid-column: 1 / -1; margin-bottom: 0; }
section { grid-auto-flow: dense; }
section a.tall { grid-row: span 2; }
section a { display: flex; flex-direction: column; justify-content: space-between; padding: 12px; border-radius: 6px; background: #ffffff; color: inherit; text-decoration: none; }
section a:hover, section a:focus-visible { outline: 2px solid #0072b2; }
img { display: block; max-width: 100%; height: auto; margin: auto; }
span { display: block; padding-top: 8px; }
code { font-size: 13px; }
nav a { color: inherit; }
@media (prefers-color-scheme: dark) {
  body { background: #161b22; color: #e6edf3; }
  section a { background: #0d1117; }
  section a:hover, section a:focus-visible { outline-color: #4ea1e0; }
}
</style>
<header>
<h1>Mechanisms</h1>
<p>Every machine that the examples declare. Each picture leads to a page on which the machine moves, with its declaration.</p>
"##;

/// The style that a machine's page adds to that of its film.
const STYLE: &str = r#"<style>
h1 { font-size: 20px; margin: 12px 0 4px; }
nav, p { line-height: 1.5; }
nav { display: flex; justify-content: space-between; gap: 12px; }
nav a { color: inherit; }
nav :not(:nth-child(2)) { white-space: nowrap; }
p code { overflow-wrap: anywhere; }
pre { overflow-x: auto; padding: 12px; border: 1px solid #8a9096; border-radius: 6px; font-size: 13px; line-height: 1.45; }
</style>"#;

/// Width of the pictures of the index, which shows them in their own size: their letters are equally large.
const WIDTH: f64 = 296.0;

/// Writes the index, and a still and a page of each machine.
///
/// # Errors
/// The first drawing or file that fails.
pub fn write(pieces: &[Piece], folder: &Path) -> Result<(), SketchError> {
    let (ordered, live) = (ordered(pieces), live::pages()?);
    for (name, page) in &live {
        std::fs::write(folder.join(live_file(name)), page)?;
    }
    for (nth, piece) in ordered.iter().enumerate() {
        let still = piece.film.still().width(WIDTH);
        std::fs::write(folder.join(format!("{}.svg", stem(piece))), still.to_svg()?)?;
        let beside = [nth.checked_sub(1), Some(nth + 1)];
        let beside = beside.map(|nth| Some(*ordered.get(nth?)?));
        let is_live = live.iter().any(|(name, _)| *name == piece.name);
        let page = machine(piece, beside, is_live)?;
        std::fs::write(folder.join(format!("{}.html", stem(piece))), page)?;
    }
    Ok(std::fs::write(folder.join("index.html"), index(pieces)?)?)
}

/// The pieces as the index has them.
fn ordered(pieces: &[Piece]) -> Vec<&Piece> {
    let of = |kind: Kind| pieces.iter().filter(move |piece| piece.kind == kind);
    Kind::ALL.into_iter().flat_map(of).collect()
}

fn stem(piece: &Piece) -> String {
    piece.name.replace("::", "_")
}

/// The file of the page on which a machine is dragged.
fn live_file(name: &str) -> String {
    format!("live_{}.html", name.replace("::", "_"))
}

/// True for a picture of which two lower ones are as high, with their texts.
fn is_tall(piece: &Piece) -> Result<bool, SketchError> {
    let still = piece.film.still().width(WIDTH).to_svg()?;
    let side = |name: &str| {
        let (_, behind) = still.split_once(&format!(" {name}=\""))?;
        behind.split('"').next()?.parse::<f64>().ok()
    };
    Ok(side("height").zip(side("width")).is_some_and(|(height, width)| height > 1.3 * width))
}

/// The index: a section for each kind of machine.
///
/// # Errors
/// The first drawing that fails.
pub fn index(pieces: &[Piece]) -> Result<String, SketchError> {
    let (mut links, mut sections) = (String::new(), String::new());
    for kind in Kind::ALL {
        let (id, heading) = (format!("{kind:?}"), kind.heading());
        links += &format!("<a href=\"#{id}\">{heading}</a>\n");
        sections += &format!("<section id=\"{id}\">\n<h2>{heading}</h2>\n");
        for piece in pieces.iter().filter(|piece| piece.kind == kind) {
            let (stem, text, name) = (stem(piece), piece.text, piece.name);
            let class = if is_tall(piece)? { " class=\"tall\"" } else { "" };
            sections += &format!(
                "<a href=\"{stem}.html\"{class}><img src=\"{stem}.svg\" loading=\"lazy\" alt=\"\">\
                 <span>{text}<br><code>{name}</code></span></a>\n"
            );
        }
        sections += "</section>\n";
    }
    Ok(format!("{HEAD}<nav>\n{links}</nav>\n</header>\n<main>\n{sections}</main>\n</html>\n"))
}

/// The page of a film with the machine's text, its declaration, and the machines before and behind.
///
/// # Errors
/// The first drawing that fails.
pub fn machine(
    piece: &Piece,
    beside: [Option<&Piece>; 2],
    is_live: bool,
) -> Result<String, SketchError> {
    let page = piece.film.to_html()?;
    let link = |(piece, word): (Option<&Piece>, &str)| match piece {
        Some(piece) => format!("<a href=\"{}.html\">{word}</a>", stem(piece)),
        None => format!("<span>{word}</span>"),
    };
    let [before, behind] = [(beside[0], "← before"), (beside[1], "next →")].map(link);
    let live = match is_live {
        true => format!(
            "\n<p><a href=\"{}\">Drag it, change its parameters, read its curves</a></p>",
            live_file(piece.name)
        ),
        false => String::new(),
    };
    let above = format!(
        "{STYLE}<main>\n<nav>{before}<a href=\"index.html#{:?}\">{}</a>{behind}</nav>\n\
         <h1>{}</h1>{live}",
        piece.kind,
        piece.kind.heading(),
        piece.text
    );
    let declared = NAMES.iter().position(|name| *name == piece.name);
    let below = declared.map_or(String::new(), |nth| {
        let (file, text) = TEXTS[nth];
        let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        format!("<p>Declared in <code>{file}</code>:</p>\n<pre><code>{text}</code></pre>\n</main>")
    });
    let page = page.replacen("<main>", &above, 1);
    Ok(page.replacen("</main>", &below, 1))
}
