//! The verb `import`: a machine of PMKS+, pyslvs or pylinkage as a declaration, its pins, its links and what drives it.
//!
//! ```text
//! linkage import 'https://app.pmksplus.com/?2P.Fe.K,0.1011.MA,A,0,0,0…'
//! linkage import machine.json --unit m
//! linkage import machine.txt --drive 0,1
//! ```
//!
//! Each format is a module that maps its words to pins, links, guides and drives of one [`drawing`]. Lengths, groups
//! and assembly modes are the compiler's business: they follow from the drawing.

mod drawing;
mod names;
mod parallelograms;
mod pmks;
mod printed;
mod pylinkage;
mod pyslvs;
mod triangles;

use std::fs;
use std::io::{self, Read};
use std::path::Path;

use drawing::Drawing;

use crate::arguments::Import;
use crate::output::{self, Failure};
use crate::style;

/// The reason why a machine cannot be read or has no declaration.
type Mistake = String;

pub(crate) fn run(arguments: &Import) -> Result<(), Failure> {
    let text = text(&arguments.source)?;
    let text = text.trim();
    match declaration(text, arguments) {
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

fn declaration(text: &str, arguments: &Import) -> Result<String, Mistake> {
    let mut drawing = read(text, &arguments.drive)?;
    parallelograms::make_exact(&mut drawing);
    if let Some(name) = &arguments.name {
        drawing.name.clone_from(name);
    }
    if let Some(unit) = &arguments.unit {
        drawing.unit.clone_from(unit);
    }
    printed::declaration(&drawing)
}

/// The machine in whichever format the text is.
fn read(text: &str, drives: &[String]) -> Result<Drawing, Mistake> {
    let is_expression = pyslvs::is_expression(text);
    if !drives.is_empty() && !is_expression {
        return Err("`--drive` belongs to pyslvs expressions; other formats say what drives".into());
    }
    match () {
        () if is_expression => pyslvs::read(text, drives),
        () if text.starts_with('{') => pylinkage::read(text),
        () if text.contains('?') => pmks::read(text),
        () => Err("this is no address with `?`, no expression `M[…]` and no JSON object".into()),
    }
}
