//! Writes every mechanism of the examples, animated, to `target/gallery/index.html`; with
//! `--committed` also the pictures that the documentation and the README keep.

use std::path::Path;

use gallery::{figures, page, pieces};
use linkage_core::sketch::{SketchError, Theme};

fn main() -> Result<(), SketchError> {
    let folder = Path::new("target/gallery");
    std::fs::create_dir_all(folder)?;
    let pieces = pieces();
    let written: Result<Vec<String>, SketchError> =
        pieces.iter().map(|piece| page::figure(piece, folder)).collect();
    let index = folder.join("index.html");
    std::fs::write(&index, page::page(&written?))?;
    println!("{} films: {}", pieces.len(), index.display());
    for (name, figure) in figures::figures(Theme::Dark)? {
        std::fs::write(folder.join(format!("{name}_dark.svg")), figure)?;
    }
    for (name, figure) in figures::figures(Theme::Light)? {
        std::fs::write(folder.join(format!("{name}.svg")), figure)?;
    }
    if std::env::args().any(|argument| argument == "--committed") {
        committed()?;
    }
    Ok(())
}

/// Figures for the documentation, films for the README.
fn committed() -> Result<(), SketchError> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let kept = root.join("linkage-core/src/figures");
    std::fs::create_dir_all(&kept)?;
    for (name, figure) in figures::figures(Theme::Light)? {
        std::fs::write(kept.join(format!("{name}.svg")), figure)?;
    }
    let kept = root.join("examples/gallery/films");
    std::fs::create_dir_all(&kept)?;
    for piece in pieces().iter().take(4) {
        let name = piece.name.split("::").next().unwrap_or_default();
        std::fs::write(kept.join(format!("{name}.svg")), piece.film.to_svg()?)?;
        std::fs::write(kept.join(format!("{name}_dark.svg")), piece.film.to_svg_in(Theme::Dark)?)?;
    }
    Ok(())
}
