//! Writes the playground, one HTML file: `cargo run -p linkage-playground -- target/play.html`.
//!
//! It builds the compiler for `wasm32-unknown-unknown`, which `rustup target add wasm32-unknown-unknown` installs. Where
//! that target is missing it says so, and writes nothing.

use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use flate2::Compression;
use flate2::write::GzEncoder;
use linkage_core::sketch::shortened;

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
    let Some(wasm) = built()? else {
        println!("the playground is left out: `rustup target add {TARGET}` installs what it needs");
        return Ok(());
    };
    let mut zipped = GzEncoder::new(Vec::new(), Compression::best());
    zipped.write_all(&wasm)?;
    let (wasm, zipped) = (wasm.len(), in_letters(&zipped.finish()?));
    let machines = serde_json::to_string(&MACHINES)?;
    let script = include_str!("../page/play.js").replace("{{machines}}", &machines);
    let script = script.replace("{{move}}", include_str!("../page/move.js"));
    let page = filled(&[
        ("style", include_str!("../page/play.css")),
        ("worker", include_str!("../page/worker.js")),
        ("wasm", &zipped),
        ("moved", &shortened(include_str!("../page/moved.js"))),
        // Only texts hold what would end the element, and there a backslash changes nothing.
        ("script", &script.replace("</", "<\\/")),
    ]);
    fs::write(&path, &page)?;
    println!(
        "{}: {} bytes, of them {} of the compiler, {wasm} unzipped",
        path.display(),
        page.len(),
        zipped.len()
    );
    Ok(())
}

/// The compiler for a browser; none where its target is not installed.
fn built() -> Result<Option<Vec<u8>>, Box<dyn Error>> {
    let sysroot = Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
        .args(["--print", "sysroot"])
        .output()?;
    let sysroot = String::from_utf8(sysroot.stdout)?;
    if !Path::new(sysroot.trim()).join("lib/rustlib").join(TARGET).join("lib").is_dir() {
        return Ok(None);
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/web");
    let status = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["build", "--lib", "-p", "linkage-playground", "--profile", "web"])
        .args(["--target", TARGET, "--target-dir"])
        .arg(&folder)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status()?;
    if !status.success() {
        return Err("the compiler could not be built for a browser".into());
    }
    Ok(Some(fs::read(folder.join(TARGET).join("web/linkage_playground.wasm"))?))
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

/// Five letters for four bytes, the first one the highest; at the end as many letters less as bytes are missing. They
/// weigh a sixteenth less than base 64, and none of them ends an element.
fn in_letters(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 85] =
        b"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.-:+=^!/*?&,>()[]{}@%$#";
    let mut letters = String::new();
    for chunk in bytes.chunks(4) {
        let mut word = [0; 4];
        word[..chunk.len()].copy_from_slice(chunk);
        let word = u32::from_be_bytes(word);
        let digits = [4, 3, 2, 1, 0].map(|power| word / 85_u32.pow(power) % 85);
        letters.extend(
            digits[..=chunk.len()].iter().map(|&digit| char::from(LETTERS[digit as usize])),
        );
    }
    letters
}
