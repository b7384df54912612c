//! The verb `import`: a machine of PMKS+, pyslvs, pylinkage or MuJoCo as a declaration, its pins, its links and what drives it.
//!
//! ```text
//! linkage import 'https://app.pmksplus.com/?2P.Fe.K,0.1011.MA,A,0,0,0…'
//! linkage import machine.json --unit m
//! linkage import machine.txt --drive 0,1
//! ```
//!
//! Each format is a module that maps its words to pins, links, guides and drives of one [`drawing`]. Lengths, groups
//! and assembly modes are the compiler's business: they follow from the drawing.

#[path = "converted.rs"]
mod converted;

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use crate::arguments::Import;
use crate::output::{self, Failure};
use crate::style;

pub(crate) fn run(arguments: &Import) -> Result<(), Failure> {
    let text = text(&arguments.source)?;
    let text = text.trim();
    let Import { drive, name, unit, .. } = arguments;
    match converted::declaration(text, drive, [name.as_deref(), unit.as_deref()]) {
        Ok(text) => output::text(arguments.target.output.as_deref(), &text, arguments.target.stale),
        Err(mistake) => {
            style::tell(&mistake);
            Err(Failure::Told)
        }
    }
}

fn text(source: &str) -> Result<String, Failure> {
    if source == "-" {
        let mut text = String::new();
        let read = io::stdin().read_to_string(&mut text);
        return read.map(|_| text).map_err(Failure::of(Path::new("standard input")));
    }
    let path = Path::new(source);
    let is_address = source.contains("://") || source.contains('?') && !path.exists();
    match is_address {
        true => Ok(source.to_string()),
        false => fs::read_to_string(path).map_err(Failure::of(path)),
    }
}
