//! Blocks of README and the pages of the documentation that are neither Rust nor declarations.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use linkage_core::mechanism;

mechanism! {
    /// The shear of README, for C.
    pub struct FlyingShear {
        input theta: angle;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
        point blade on BC at (500mm, -60mm);
        export c;
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("..")
        .canonicalize()
        .expect("the repository is there")
}

/// Every block in this language, with its page.
fn blocks(language: &str) -> Vec<(PathBuf, String)> {
    let docs = fs::read_dir(root().join("linkage-core/docs")).expect("the folder is there");
    let pages = docs.map(|entry| entry.expect("it can be read").path());
    let pages = pages.chain(["README.md", "CONTRIBUTING.md"].map(|page| root().join(page)));
    let mut blocks = Vec::new();
    for path in pages.filter(|path| path.extension().is_some_and(|extension| extension == "md")) {
        let page = fs::read_to_string(&path).expect("a page is text");
        for rest in page.split(&format!("```{language}\n")).skip(1) {
            let block = rest.split("```").next().expect("a block ends");
            blocks.push((path.clone(), block.to_string()));
        }
    }
    blocks
}

/// A folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = env::temp_dir().join(format!("linkage_pages_{name}_{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder for temporary files is there");
    folder
}

fn succeeds(command: &mut Command) -> Result<(), String> {
    let output = command.output().map_err(|error| error.to_string())?;
    match output.status.success() {
        true => Ok(()),
        false => Err(String::from_utf8_lossy(&output.stderr).into_owned()),
    }
}

/// Cargo resolves what a page says to write into `Cargo.toml`: paths and features exist.
#[test]
fn what_is_to_be_written_into_a_manifest_is_understood() {
    let folder = folder("manifest");
    let core = root().join("linkage-core");
    fs::create_dir_all(folder.join("src")).expect("it can be written");
    fs::write(folder.join("src/lib.rs"), "").expect("it can be written");
    let mut seen = 0;
    for (page, block) in blocks("toml") {
        // The lock file keeps Cargo from asking the registry.
        fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).expect("it is there");
        // A reader has the repository beside the program.
        let block = block.replace("\"../linkage/linkage-core\"", &format!("{core:?}"));
        let manifest = format!(
            "[package]\nname = \"reader\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n{block}"
        );
        fs::write(folder.join("Cargo.toml"), manifest).expect("it can be written");
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["metadata", "--offline", "--format-version", "1"]).current_dir(&folder);
        succeeds(&mut cargo).unwrap_or_else(|error| panic!("{}\n{block}\n{error}", page.display()));
        seen += 1;
    }
    assert!(seen >= 2, "README and the page about controllers have one each");
    let _ = fs::remove_dir_all(folder);
}
