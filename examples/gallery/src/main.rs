//! Writes every mechanism of the examples, animated, to `target/gallery/index.html`.

use std::path::Path;

use linkage_core::sketch::SketchError;

fn main() -> Result<(), SketchError> {
    let folder = Path::new("target/gallery");
    std::fs::create_dir_all(folder)?;
    let pieces = gallery::pieces();
    let figures: Result<Vec<String>, SketchError> =
        pieces.iter().map(|piece| gallery::page::figure(piece, folder)).collect();
    let index = folder.join("index.html");
    std::fs::write(&index, gallery::page::page(&figures?))?;
    println!("{} films: {}", pieces.len(), index.display());
    Ok(())
}
