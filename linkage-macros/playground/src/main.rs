//! Writes the playground, one HTML file: `cargo run -p linkage-playground -- target/play.html`.
//!
//! It builds the compiler for `wasm32-unknown-unknown`, which `rustup target add wasm32-unknown-unknown` installs. Where
//! that target is missing it says so, and writes nothing.

use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use linkage_core::sketch::shortened;
use lzma_rust2::{LzmaOptions, LzmaWriter};

const TARGET: &str = "wasm32-unknown-unknown";

/// The machines to begin with, the first one at first.
const MACHINES: [(&str, &str); 6] = [
    ("Four-bar", include_str!("../machines/four_bar.rs")),
    ("Slider-crank", include_str!("../machines/slider_crank.rs")),
    ("Quick return", include_str!("../machines/quick_return.rs")),
    ("Jansen's leg", include_str!("../machines/jansen.rs")),
    ("Lift by a cylinder", include_str!("../machines/lift.rs")),
    ("Press with friction", include_str!("../machines/press.rs")),
];

fn main() -> Result<(), Box<dyn Error>> {
    let path = env::args().nth(1).map_or_else(|| PathBuf::from("target/play.html"), PathBuf::from);
    let Some([wasm, unpack]) = built()? else {
        println!("the playground is left out: `rustup target add {TARGET}` installs what it needs");
        return Ok(());
    };
    let (wasm, packed) = (wasm.len(), in_letters(&packed(&wasm)?));
    let machines = serde_json::to_string(&MACHINES)?;
    let script = include_str!("../page/play.js").replace("{{machines}}", &machines);
    let script = script.replace("{{move}}", include_str!("../page/move.js"));
    let page = filled(&[
        ("style", include_str!("../page/play.css")),
        ("worker", include_str!("../page/worker.js")),
        ("unpack", &in_letters(&unpack)),
        ("wasm", &packed),
        ("moved", &shortened(include_str!("../page/moved.js"))),
        // Only texts hold what would end the element, and there a backslash changes nothing.
        ("script", &script.replace("</", "<\\/")),
    ]);
    fs::write(&path, &page)?;
    println!(
        "{}: {} bytes, of them {} of the compiler, {wasm} unpacked",
        path.display(),
        page.len(),
        packed.len()
    );
    Ok(())
}

/// The compiler for a browser, and what unpacks it there; none where their target is not installed.
fn built() -> Result<Option<[Vec<u8>; 2]>, Box<dyn Error>> {
    let sysroot = Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
        .args(["--print", "sysroot"])
        .output()?;
    let sysroot = String::from_utf8(sysroot.stdout)?;
    if !Path::new(sysroot.trim()).join("lib/rustlib").join(TARGET).join("lib").is_dir() {
        return Ok(None);
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/web");
    let status = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args([
            "build",
            "--lib",
            "-p",
            "linkage-playground",
            "-p",
            "linkage-unpack",
            "--profile",
            "web",
        ])
        .args(["--target", TARGET, "--target-dir"])
        .arg(&folder)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status()?;
    if !status.success() {
        return Err("the compiler could not be built for a browser".into());
    }
    let read = |name: &str| fs::read(folder.join(TARGET).join("web").join(name));
    Ok(Some([read("linkage_playground.wasm")?, read("linkage_unpack.wasm")?]))
}

/// The skeleton with these texts in its gaps.
fn filled(texts: &[(&str, &str)]) -> String {
    let mut parts = include_str!("../page/play.html").split("{{");
    let mut page = parts.next().unwrap_or_default().to_string();
    for part in parts {
        let (gap, rest) = part.split_once("}}").unwrap_or((part, ""));
        page += texts.iter().find(|(name, _)| *name == gap).map_or("", |(_, text)| text);
        page += rest;
    }
    page
}

/// Eleven letters for nine bytes, the first one the highest: all that can be printed but `<`, so that none of them ends an
/// element. At the end as many letters stand as the bytes need.
fn in_letters(bytes: &[u8]) -> String {
    let mut letters = String::new();
    for chunk in bytes.chunks(9) {
        let mut padded = [0; 16];
        padded[7..7 + chunk.len()].copy_from_slice(chunk);
        let word = u128::from_be_bytes(padded);
        let digits = (0..11).rev().map(|power| (word / 94_u128.pow(power) % 94) as u8);
        let needed = digits.take((11 * chunk.len()).div_ceil(9));
        letters
            .extend(needed.map(|digit| char::from(b' ' + digit + u8::from(digit >= b'<' - b' '))));
    }
    letters
}

/// An archive in the format of `.lzma`, a quarter smaller than what browsers unpack by themselves: like pieces of a compiler lie far
/// apart.
fn packed(bytes: &[u8]) -> std::io::Result<Vec<u8>> {
    let options = LzmaOptions {
        dict_size: 4 << 20,
        lc: 4,
        pb: 0,
        nice_len: LzmaOptions::NICE_LEN_MAX,
        ..LzmaOptions::with_preset(9)
    };
    let mut writer = LzmaWriter::new_use_header(Vec::new(), &options, Some(bytes.len() as u64))?;
    writer.write_all(bytes)?;
    writer.finish()
}
