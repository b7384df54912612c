//! A C program that calls a mechanism: builds the static library, whose build script writes the
//! header, compiles `main.c` with gcc against both, and runs it. An argument is the crank angle in
//! degrees.
//!
//! The same by hand:
//!
//! ```text
//! cargo build --release --manifest-path examples/c_caller/library/Cargo.toml \
//!     --target-dir target/c_caller
//! gcc -Wall -Wextra -pedantic -I examples/c_caller/library/include \
//!     examples/c_caller/main.c target/c_caller/release/libshear.a \
//!     -lm -Wl,--gc-sections -o target/c_caller/shear
//! target/c_caller/shear 292.5
//! ```
//!
//! `--gc-sections` leaves out what nothing calls: Rust's `core` comes whole, and parts of it that no
//! solver uses expect the rest of a Rust program.

use std::error::Error;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (source, target) = (here.join("examples/c_caller"), here.join("target/c_caller"));

    // The library is built with the versions that this workspace is tested with.
    fs::copy(here.join("Cargo.lock"), source.join("library/Cargo.lock"))?;
    run(Command::new("cargo")
        .args(["build", "--quiet", "--release", "--manifest-path"])
        .arg(source.join("library/Cargo.toml"))
        .arg("--target-dir")
        .arg(&target))?;
    run(Command::new("gcc")
        .args(["-Wall", "-Wextra", "-pedantic", "-O2", "-I"])
        .arg(source.join("library/include"))
        .arg(source.join("main.c"))
        .arg(target.join("release/libshear.a"))
        .args(["-lm", "-Wl,--gc-sections", "-o"])
        .arg(target.join("shear")))?;
    run(Command::new(target.join("shear")).args(env::args().nth(1)))
}

/// Runs a command and waits for it.
fn run(command: &mut Command) -> Result<(), Box<dyn Error>> {
    let status = command.status().map_err(|error| format!("{command:?}: {error}"))?;
    if status.success() { Ok(()) } else { Err(format!("{command:?}: {status}").into()) }
}
