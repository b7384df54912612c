//! Prints a machine of PMKS+, pyslvs or pylinkage as a declaration: its pins, its links and what drives it.
//!
//! ```text
//! import 'https://app.pmksplus.com/?2P.Fe.K,0.1011.MA,A,0,0,0…'
//! import machine.json --unit m
//! import machine.txt --drive 0,1
//! ```
//!
//! Each format is a module that maps its words to pins, links, guides and drives of one [`drawing`]. Lengths, groups
//! and assembly modes are the compiler's business: they follow from the drawing.

mod drawing;
mod names;
mod pmks;
mod printed;
mod pylinkage;
mod pyslvs;

use std::io::Read;
use std::process::ExitCode;

use clap::Parser;

use drawing::Drawing;

/// The reason why a machine cannot be read or has no declaration.
type Mistake = String;

#[derive(Parser)]
#[command(about = "Prints a machine of PMKS+, pyslvs or pylinkage as a declaration")]
struct Arguments {
    /// An address of PMKS+, or a file with an address, a pyslvs expression or pylinkage's JSON; `-` is
    /// standard input
    machine: String,
    /// The name of the solver
    #[arg(long)]
    name: Option<String>,
    /// The unit of coordinates: m, mm, cm, in, ft. An address states its own; elsewhere millimetres
    #[arg(long)]
    unit: Option<String>,
    /// Two joints of a pyslvs expression, by their indices: the link through both is turned about the
    /// first. One joint twice: its block is slid
    #[arg(long, value_name = "I,J")]
    drive: Vec<String>,
}

fn main() -> ExitCode {
    match declaration(&Arguments::parse()) {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(mistake) => {
            eprintln!("error: {mistake}");
            ExitCode::FAILURE
        }
    }
}

fn declaration(arguments: &Arguments) -> Result<String, Mistake> {
    let text = text(&arguments.machine)?;
    let text = text.trim();
    let mut drawing = read(text, &arguments.drive)?;
    if let Some(name) = &arguments.name {
        drawing.name.clone_from(name);
    }
    if let Some(unit) = &arguments.unit {
        if !["m", "mm", "cm", "in", "ft"].contains(&&unit[..]) {
            return Err(format!("`{unit}` is no unit of length; choose m, mm, cm, in or ft"));
        }
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

fn text(machine: &str) -> Result<String, Mistake> {
    if machine == "-" {
        let mut text = String::new();
        let read = std::io::stdin().read_to_string(&mut text);
        return read.map(|_| text).map_err(|error| format!("standard input: {error}"));
    }
    match machine.contains("://") {
        true => Ok(machine.to_string()),
        false => std::fs::read_to_string(machine).map_err(|error| format!("{machine}: {error}")),
    }
}
