//! Writes the C header, `include/flying_shear.h`, at every build that follows a change of the
//! declaration. It holds the declaration's own file, so that the machine is declared once; it runs on
//! the machine that builds, whatever the library is for.

#[path = "src/mechanism.rs"]
mod mechanism;

use std::path::Path;
use std::{fs, io};

use mechanism::FlyingShear;

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=src/mechanism.rs");
    // A header that is gone is written again.
    println!("cargo::rerun-if-changed=include/flying_shear.h");
    let include = Path::new(&std::env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("include");
    let header = include.join("flying_shear.h");
    // An unchanged header is left alone, so that no C file is compiled again.
    if fs::read(&header).is_ok_and(|held| held == FlyingShear::C_HEADER.as_bytes()) {
        return Ok(());
    }
    fs::create_dir_all(&include)?;
    fs::write(header, FlyingShear::C_HEADER)
}
