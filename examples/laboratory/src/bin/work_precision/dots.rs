//! The results of one run, kept for the picture of the next one: with and without fused operations are two
//! programs, and one picture shows both.

use std::fs;

/// A method's point.
pub(crate) struct Dot {
    pub(crate) width: String,
    pub(crate) family: String,
    /// Time over the straightforward form's, error in ε.
    pub(crate) point: (f64, f64),
}

fn path(is_fused: bool) -> &'static str {
    if is_fused {
        "target/charts/work_precision_fused.txt"
    } else {
        "target/charts/work_precision_plain.txt"
    }
}

/// A line a point: width, family, time, error.
pub(crate) fn keep(is_fused: bool, dots: &[Dot]) {
    let line = |Dot { width, family, point: (time, error) }: &Dot| {
        format!("{width}\t{family}\t{time:e}\t{error:e}\n")
    };
    let text: String = dots.iter().map(line).collect();
    let written =
        fs::create_dir_all("target/charts").and_then(|()| fs::write(path(is_fused), text));
    if let Err(error) = written {
        eprintln!("not kept for the next picture: {}: {error}", path(is_fused));
    }
}

/// The kept results; empty where nothing can be read.
pub(crate) fn kept(is_fused: bool) -> Vec<Dot> {
    let text = fs::read_to_string(path(is_fused)).unwrap_or_default();
    text.lines().filter_map(dot).collect()
}

fn dot(line: &str) -> Option<Dot> {
    let mut parts = line.split('\t');
    let (width, family) = (parts.next()?.to_owned(), parts.next()?.to_owned());
    let point = (parts.next()?.parse().ok()?, parts.next()?.parse().ok()?);
    Some(Dot { width, family, point })
}
