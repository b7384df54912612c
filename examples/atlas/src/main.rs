//! Recomputes Hrones and Nelson's atlas, then looks for a four-bar that draws a given path.
//!
//! ```text
//! cargo run --release -p atlas
//! cargo run --release -p atlas -- my_path.txt
//! RUSTFLAGS="-C target-cpu=native" cargo run --release -p atlas
//! ```
//!
//! The file has a point of a closed curve in each line, its x and its y. Without one, the path is that of a
//! walking machine's foot, `paths/step.txt`; beside it are a straight line there and back, a figure of eight and
//! a D. Writes the atlas to `target/atlas/curves.csv` and a picture of
//! the path and the ten best curves to `target/charts/atlas.svg`. `compare.py` does a part of the same work by
//! `pylinkage` and compares both numbers and time.
//!
//! A larger search is done in parts, by any engine that runs programs:
//! ```text
//! atlas my_path.txt --grid 80,41,29 --part 3/1000 --out parts/part-3-of-1000.txt
//! atlas my_path.txt --grid 80,41,29 --missing 1000 parts
//! atlas my_path.txt --grid 80,41,29 --merge 1000 parts --best best.csv
//! ```
//! A part whose file is whole is kept, one that was cut off is done again, and the merged result is that of one
//! process, bit for bit. `cluster.py` runs the parts on Dask's `distributed`.

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::process::ExitCode;
use std::time::{Duration, Instant};

use atlas::drawn_path::DrawnPath;
use atlas::four_bar::{Dimensions, Tracer};
use atlas::grid::{self, Candidates};
use atlas::options::{Options, Work};
use atlas::part::{self, Part, PartError, Question};
use atlas::progress::Progress;
use atlas::search::{self, Found};
use atlas::shape::{Describer, Descriptor};
use atlas::{picture, refine};
use linkage_core::LengthMismatch;

/// Poses of a curve of the atlas: one every 5° of the crank, as the dashes of the book's curves.
const ATLAS_POSES: u32 = 72;

/// As many different designs are drawn.
const DRAWN: usize = 10;

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
    let options = Options::parse(std::env::args_os().skip(1))?;
    let path = match &options.path {
        None => DrawnPath::parse(include_str!("../paths/step.txt"))?,
        Some(file) => DrawnPath::read(file)?,
    };
    let described = Describer::default().describe(&path.x, &path.y);
    let described = described.ok_or("the path has no size; write the points of a closed curve")?;
    let question = Question::new(&path, options.grid)?;
    let found = match &options.work {
        Work::Part(part, out) => {
            return search_part(&described, &options, *part, &question, out);
        }
        Work::Missing(count, directory) => {
            for (part, _) in part::merged(directory, *count, &question).err().unwrap_or_default() {
                println!("{}", part.number());
            }
            return Ok(());
        }
        Work::Merge(count, directory) => {
            let list = part::merged(directory, *count, &question).map_err(list_of)?;
            search::compared_again(&described, &options.grid.candidates(), &list)?
        }
        Work::Whole => {
            if options.best.is_none() {
                describe_atlas(&described)?;
            }
            search_whole(&described, &options.grid.candidates())?
        }
    };
    finish(&path, &described, &options, &found)
}

/// All parts that have no file, and why.
fn list_of(errors: Vec<(Part, PartError)>) -> String {
    let lines = errors.iter().map(|(part, error)| format!("part {part}: {error}"));
    lines.collect::<Vec<_>>().join("\n")
}

fn search_part(
    path: &Descriptor,
    options: &Options,
    part: Part,
    question: &Question,
    out: &Path,
) -> Result<(), Box<dyn Error>> {
    match part::read(out, part, question) {
        Ok(_) => {
            println!("part {part} is whole: kept");
            return Ok(());
        }
        Err(PartError::Missing) => {}
        Err(PartError::NotWhole) => println!("part {part} is cut off: done again"),
        Err(error) => return Err(format!("{}: {error}", out.display()).into()),
    }
    let candidates = options.grid.candidates();
    let linkages = part.linkages(candidates.linkages.len());
    let count = linkages.len() * candidates.points.len();
    let (start, progress) = (Instant::now(), Progress::of("searching", count as u64));
    let list = search::short_list(path, &candidates, linkages, search::SHORT_LIST, &progress)?;
    drop(progress);
    part::write(out, part, question, &list)?;
    println!("part {part}: {count} curves in {:.1} s", start.elapsed().as_secs_f64());
    Ok(())
}

fn search_whole(path: &Descriptor, candidates: &Candidates) -> Result<Vec<Found>, LengthMismatch> {
    let (start, count) = (Instant::now(), candidates.count());
    let progress = Progress::of("searching", count as u64);
    let found = search::nearest(path, candidates, search::SHORT_LIST, &progress)?;
    drop(progress);
    let seconds = start.elapsed().as_secs_f64();
    let poses = count as f64 * f64::from(search::POSES);
    let cores = rayon::current_num_threads();
    println!("{count} curves searched in {seconds:.1} s on {cores} cores:");
    println!("{:.1} million poses a second, traced and compared\n", poses / seconds / 1e6);
    Ok(found)
}

/// Writes the atlas and says how fast it is traced and what in it is nearest.
fn describe_atlas(path: &Descriptor) -> Result<(), Box<dyn Error>> {
    let atlas = grid::atlas();
    write_curves(&atlas)?;
    println!("Sweeps alone: {:.1} million poses a second on one core", rate(&atlas)? / 1e6);
    let found = search::nearest(path, &atlas, search::SHORT_LIST, &Progress::silent())?;
    if let Some(nearest) = found.first() {
        println!("Nearest in the atlas:\n{HEADING}\n{:14} {}", "atlas", row(nearest));
    }
    println!();
    Ok(())
}

const HEADING: &str = "                 A     B     C  coupler point    distance   crank";

/// Refines what was found, prints and draws the best designs and writes all of them.
fn finish(
    path: &DrawnPath,
    described: &Descriptor,
    options: &Options,
    found: &[Found],
) -> Result<(), Box<dyn Error>> {
    let few = &found[..found.len().min(options.refine)];
    let (start, progress) = (Instant::now(), Progress::of("refining", few.len() as u64));
    let refined = refine::refine(described, few, &progress)?;
    drop(progress);
    println!("{} curves refined in {:.1} s", few.len(), start.elapsed().as_secs_f64());
    // From most nodes of the grid the refinement leads to one optimum: the other designs are the grid's.
    let both = [&refined[..], found].concat();
    let designs = search::designs(&both, DRAWN);
    println!("{HEADING}");
    for design in found.iter().take(1).chain(&designs) {
        let is_node = found.iter().any(|node| node.dimensions == design.dimensions);
        println!("{:14} {}", if is_node { "grid" } else { "refined" }, row(design));
    }
    if let (Some(before), Some(after)) = (found.first(), refined.first()) {
        let factor = before.distance / after.distance;
        println!("\nThe best refined curve is {factor:.1} times nearer than the grid's best");
    }
    if let Some(file) = &options.best {
        write_best(file, &refined)?;
    }
    let name = options.path.as_deref().and_then(Path::file_stem);
    let name = name.map(|name| format!("atlas_{}", name.to_string_lossy()));
    picture::write(name.as_deref().unwrap_or("atlas"), path, &designs)?;
    Ok(())
}

/// Every number with as many digits as lead back to it.
fn write_best(file: &Path, refined: &[Found]) -> Result<(), Box<dyn Error>> {
    let mut text = "candidate,coupler,follower,base,along,across,mirrored,distance\n".to_owned();
    for Found { candidate, dimensions, distance, placement } in refined {
        let Dimensions { coupler, follower, base, along, across, .. } = dimensions;
        let mirrored = placement.is_mirrored();
        write!(text, "{candidate},{coupler},{follower},{base},{along},{across}")?;
        writeln!(text, ",{mirrored},{distance}")?;
    }
    Ok(std::fs::write(file, text)?)
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
