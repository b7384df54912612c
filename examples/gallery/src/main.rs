//! Writes a site of every mechanism of the examples to `target/gallery/index.html`; with
//! `--committed` also the pictures that the documentation and the README keep, with `--sheets` pages
//! on which all pictures of a width and a theme can be looked at together.

use std::path::Path;

use gallery::{figures, page, pieces, sheet};
use linkage_core::sketch::{SketchError, Theme};

fn main() -> Result<(), SketchError> {
    let folder = Path::new("target/gallery");
    std::fs::create_dir_all(folder)?;
    let pieces = pieces();
    page::write(&pieces, folder)?;
    println!("{} machines: {}", pieces.len(), folder.join("index.html").display());
    let is_asked = |wanted| std::env::args().any(|argument| argument == wanted);
    if is_asked("--committed") {
        committed()?;
    }
    if is_asked("--sheets") {
        sheets(folder)?;
    }
    Ok(())
}

/// Pages of everything at two widths, light and dark; `#1.5` behind the address shows that second.
fn sheets(folder: &Path) -> Result<(), SketchError> {
    for (theme, name) in [(Theme::Light, "light"), (Theme::Dark, "dark")] {
        for width in [360.0, 720.0] {
            let films = pieces().into_iter().map(|piece| piece.film.width(width));
            let films: Vec<_> = films.collect();
            let moving: Result<Vec<_>, _> =
                films.iter().map(|film| film.to_svg_in(theme)).collect();
            let stills: Result<Vec<_>, _> =
                films.iter().map(|film| film.still().to_svg_in(theme)).collect();
            for (what, pictures) in [("films", moving?), ("stills", stills?)] {
                let file = folder.join(format!("sheet_{what}_{name}_{width}.html"));
                std::fs::write(file, sheet::sheet(&pictures, theme))?;
            }
        }
        let figures = figures::figures(theme)?.into_iter().map(|(_, figure)| figure);
        let page = sheet::sheet(&figures.collect::<Vec<_>>(), theme);
        std::fs::write(folder.join(format!("sheet_figures_{name}.html")), page)?;
    }
    Ok(())
}

/// Figures for the documentation, films for the README.
fn committed() -> Result<(), SketchError> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let kept = root.join("linkage-core/src/figures");
    std::fs::create_dir_all(&kept)?;
    for (name, figure) in figures::figures(Theme::Auto)? {
        std::fs::write(kept.join(format!("{name}.svg")), figure)?;
    }
    std::fs::write(kept.join("suspension.svg"), gallery::motions::of_unknowns().to_svg()?)?;
    std::fs::write(kept.join("drawn.md"), figures::addresses()?)?;
    std::fs::write(kept.join("drawn_limits.md"), figures::addresses_of_limits()?)?;
    std::fs::write(kept.join("drawn_searches.md"), figures::addresses_of_searches()?)?;
    let kept = root.join("examples/gallery/films");
    std::fs::create_dir_all(&kept)?;
    for (name, film) in gallery::readme() {
        std::fs::write(kept.join(format!("{name}.svg")), film.to_svg()?)?;
    }
    Ok(())
}
