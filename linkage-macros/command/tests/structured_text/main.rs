//! Structured text of IEC 61131-3: what it computes beside printed C, what is refused, and its names.
//!
//! An evaluator of its own runs it, which stops at what a controller may stop at. `.ci/nightly c` takes every declaration
//! of the repository; two readers of others take them too, where they are installed.

#[allow(unreachable_pub, reason = "other tests have it in the interface of their crate")]
#[path = "../../../../tests/src/random.rs"]
mod random;
#[path = "../../../../tests/skipped.rs"]
mod skipped;

mod against_c;
mod evaluator;
mod functions;
mod in_c;
mod lexer;
mod names;
mod parsers;
mod poses;
mod printed;
mod reader;
mod units;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

use linkage_compiler::{File, declarations, st};
use proc_macro2::TokenStream;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("structured_text").join(name)
}

/// Every declaration of the repository, with the name of its file.
fn all() -> Vec<(String, TokenStream)> {
    let (mut files, mut found) = (Vec::new(), Vec::new());
    add_files(&root(), &mut files);
    files.sort();
    for path in files {
        let text = fs::read_to_string(&path).expect("it can be read");
        let blocks: Vec<&str> = match path.extension().is_some_and(|ending| ending == "md") {
            false => vec![&text],
            true => {
                let blocks = text.split("```").skip(1).step_by(2);
                blocks
                    .filter_map(|block| Some(block.strip_prefix("rust")?.split_once('\n')?.1))
                    .collect()
            }
        };
        for block in blocks {
            let Ok(tokens) = block.parse() else { continue };
            let of_file = declarations(tokens).into_iter();
            found.extend(of_file.map(|tokens| (path.display().to_string(), tokens)));
        }
    }
    found
}

fn add_files(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the folder can be read") {
        let path = entry.expect("the folder can be read").path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let is_elsewhere =
            name.starts_with('.') || ["target", "ui", "compiler"].contains(&&name[..]);
        let is_text = [".rs", ".md"].iter().any(|ending| name.ends_with(ending));
        match () {
            () if is_elsewhere => {}
            () if path.is_dir() => add_files(&path, files),
            () if is_text => files.push(path),
            () => {}
        }
    }
}

/// The texts of a declaration; without forces where something rubs, and none where there is a search.
fn texts(tokens: &TokenStream) -> Option<(Vec<File>, &'static [&'static str])> {
    const MOTION: &[&str] = &["position", "velocity", "motion", "coefficients"];
    for only in [&[][..], MOTION] {
        match st(tokens.clone(), only, None, false) {
            Ok(files) => return Some((files, only)),
            Err(mistakes) => {
                let message = &mistakes[0].message;
                let is_known =
                    ["structured text", "no entry point"].iter().any(|of| message.contains(of));
                assert!(is_known, "{message}");
            }
        }
    }
    None
}
