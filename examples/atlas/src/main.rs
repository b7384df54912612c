//! Recomputes Hrones and Nelson's atlas, then looks for a four-bar that draws a given path.
//!
//! ```text
//! cargo run --release -p atlas
//! cargo run --release -p atlas -- my_path.txt
//! RUSTFLAGS="-C target-cpu=native" cargo run --release -p atlas
//! ```
//!
//! The file has a point of a closed curve in each line, its x and its y. Without one, the path is that of a
//! walking machine's foot, `paths/step.txt`. Writes the atlas to `target/atlas/curves.csv` and a picture of
//! the path and the nearest curves to `target/charts/atlas.svg`. `compare.py` does a part of the same work by
//! `pylinkage` and compares both numbers and time.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use atlas::drawn_path::DrawnPath;
use atlas::four_bar::Tracer;
use atlas::grid::{self, Candidates};
use atlas::picture::{self, Drawn};
use atlas::progress::Progress;
use atlas::search::{self, Found};
use atlas::shape::Describer;
use linkage_core::LengthMismatch;

/// Poses of a curve of the atlas: one every 5° of the crank, as the dashes of the book's curves.
const ATLAS_POSES: u32 = 72;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let path = match &arguments[..] {
        [] => DrawnPath::parse(include_str!("../paths/step.txt"))?,
        [file] => DrawnPath::read(Path::new(file))?,
        _ => return Err("one path is searched at a time; give one file".into()),
    };
    let described = Describer::default().describe(&path.x, &path.y);
    let described = described.ok_or("the path has no size; write the points of a closed curve")?;

    let atlas = grid::atlas();
    write_curves(&atlas)?;
    println!("Sweeps alone: {:.1} million poses a second on one core\n", rate(&atlas)? / 1e6);

    let in_atlas = search::nearest(&described, &atlas, search::SHORT_LIST, &Progress::silent())?;
    let candidates = Candidates::ten_million();
    let (start, count) = (Instant::now(), candidates.count());
    let progress = Progress::of("searching", count as u64);
    let found = search::nearest(&described, &candidates, search::SHORT_LIST, &progress)?;
    drop(progress);
    let seconds = start.elapsed().as_secs_f64();
    let poses = count as f64 * f64::from(search::POSES);
    println!(
        "{count} curves searched in {seconds:.1} s on {} cores:",
        rayon::current_num_threads()
    );
    println!("{:.1} million poses a second, traced and compared\n", poses / seconds / 1e6);

    let mut drawn: Vec<Drawn> = Vec::new();
    let nearest = in_atlas.first().map(|found| ("atlas".to_owned(), found));
    let designs = search::designs(&found, 3);
    let numbered = (1..).zip(&designs).map(|(nth, found)| (format!("search, {nth}"), found));
    println!("                 A     B     C  coupler point    distance   crank");
    for (title, found) in nearest.into_iter().chain(numbered) {
        println!("{title:14} {}", row(found));
        let title = format!("{title}: apart by {:.4} of its size", found.distance);
        drawn.push(Drawn { title, found: *found });
    }
    picture::write(&path, &drawn)?;
    Ok(())
}

/// A mirrored curve is that of the mirrored four-bar.
fn row(found: &Found) -> String {
    let mirrored = found.placement.is_mirrored();
    let shown = if mirrored { found.dimensions.mirrored() } else { found.dimensions };
    let mut row = format!("{:5.2} {:5.2} {:5.2}", shown.coupler, shown.follower, shown.base);
    let _ = write!(row, "  ({:6.3}, {:6.3})", shown.along, shown.across);
    let _ = write!(row, " {:9.5} {:7.3}", found.distance, found.placement.scale());
    let branch = if mirrored { "right" } else { "left" };
    row + &format!("  mode {branch}")
}

/// Every curve of the atlas as a row of its dimensions and the coordinates of its poses.
fn write_curves(atlas: &Candidates) -> Result<(), Box<dyn Error>> {
    let mut tracer = Tracer::new(ATLAS_POSES);
    let (mut text, mut curves) = (String::new(), 0);
    for &lengths in &atlas.linkages {
        for &point in &atlas.points {
            let dimensions = grid::curve(lengths, point);
            if !tracer.trace(&dimensions)? {
                return Err(format!("{dimensions:?} cannot be assembled all the way round").into());
            }
            let [a, b, c] = lengths;
            write!(text, "{a},{b},{c},{},{}", dimensions.along, dimensions.across)?;
            for (x, y) in tracer.x.iter().zip(&tracer.y) {
                write!(text, ",{x},{y}")?;
            }
            text.push('\n');
            curves += 1;
        }
    }
    std::fs::create_dir_all("target/atlas")?;
    std::fs::write("target/atlas/curves.csv", text)?;
    let linkages = atlas.linkages.len();
    println!("The atlas: {linkages} linkages, {curves} curves, {} poses", curves * ATLAS_POSES);
    println!("written to target/atlas/curves.csv\n");
    Ok(())
}

/// Poses a second on one core. Every linkage's curves are traced several times, and the quickest counts, in
/// which the machine did the least besides.
fn rate(atlas: &Candidates) -> Result<f64, LengthMismatch> {
    let (mut tracer, mut total) = (Tracer::new(ATLAS_POSES), Duration::ZERO);
    for &lengths in &atlas.linkages {
        let mut quickest = Duration::MAX;
        for _ in 0..20 {
            let start = Instant::now();
            for &point in &atlas.points {
                tracer.trace(&grid::curve(lengths, point))?;
                std::hint::black_box(&mut tracer);
            }
            quickest = quickest.min(start.elapsed());
        }
        total += quickest;
    }
    Ok(atlas.count() as f64 * f64::from(ATLAS_POSES) / total.as_secs_f64())
}
