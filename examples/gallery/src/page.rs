//! The page of all films.

use linkage_core::sketch::{SketchError, Theme};

use crate::Piece;

const HEAD: &str = r##"<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Mechanisms</title>
<style>
body { margin: 0; padding: 24px; font: 15px/1.5 "Helvetica Neue", Arial, sans-serif; background: #f4f5f6; color: #222222; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 400px), 1fr)); gap: 24px; max-width: 1400px; margin: auto; }
figure { margin: 0; padding: 12px; background: #ffffff; border-radius: 6px; }
figure img { display: block; width: 100%; height: 360px; object-fit: contain; }
figcaption { padding-top: 8px; }
code { font-size: 13px; }
a { color: inherit; }
@media (prefers-color-scheme: dark) {
  body { background: #161b22; color: #e6edf3; }
  figure { background: #0d1117; }
}
</style>
<main>
"##;

/// Writes a film light and dark, a page of its own, and its place on the page of all.
///
/// # Errors
/// What cannot be drawn or written.
pub fn figure(piece: &Piece, folder: &std::path::Path) -> Result<String, SketchError> {
    let stem = piece.name.replace("::", "_");
    let path = |end: &str| folder.join(format!("{stem}{end}"));
    std::fs::write(path(".svg"), piece.film.to_svg()?)?;
    std::fs::write(path("_dark.svg"), piece.film.to_svg_in(Theme::Dark)?)?;
    piece.film.write_html(path(".html"))?;
    Ok(format!(
        "<figure><a href=\"{stem}.html\"><picture><source media=\"(prefers-color-scheme: dark)\" \
         srcset=\"{stem}_dark.svg\"><img src=\"{stem}.svg\" alt=\"{text}\"></picture></a>\
         <figcaption>{text}<br><code>{name}</code></figcaption></figure>\n",
        text = piece.text,
        name = piece.name,
    ))
}

/// Pictures side by side, stopped at the second that stands behind `#` in the address.
pub fn sheet(pictures: &[String], theme: Theme) -> String {
    let frame = theme.palette().quiet;
    format!(
        r#"<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<title>Pictures</title>
<style>body {{ margin: 0; background: {frame}; }} svg {{ margin: 2px; vertical-align: top; }}</style>
<body>{}</body>
<script>
addEventListener("load", () => setTimeout(() => {{
  for (const film of document.querySelectorAll("svg")) {{
    film.pauseAnimations();
    film.setCurrentTime(Number(location.hash.slice(1)));
  }}
}}, 300));
</script>
</html>
"#,
        pictures.concat()
    )
}

/// The page of all films.
pub fn page(figures: &[String]) -> String {
    format!("{HEAD}{}</main>\n</html>\n", figures.concat())
}
