//! An FMU: the printed model and solver as sources, and compiled for this machine where it has a C compiler.

use std::env;
use std::fs;
use std::path::Path;
use std::process::{self, Command};

use linkage_compiler::File;

use crate::output::{self, Failure};
use crate::zip;

/// Writes the archive, or says that it is stale: its sources are not these. The library is made of them, and needs a
/// compiler, so it is not compared.
pub(crate) fn write(path: &Path, files: Vec<File>, is_compared: bool) -> Result<(), Failure> {
    let mut all: Vec<(String, Vec<u8>)> =
        files.into_iter().map(|file| (file.name, file.text.into_bytes())).collect();
    if is_compared {
        let is_same = |own: &[u8]| zip::begins(own, &all, "binaries/");
        return if output::is_fresh(path, is_same) { Ok(()) } else { Err(Failure::Told) };
    }
    match binary(&all)? {
        Some(binary) => all.push(binary),
        None => eprintln!("note: there is no `cc` here, so the FMU holds sources alone"),
    }
    output::write(path, &zip::archive(&all))
}

/// The shared library of the sources; none without a compiler.
fn binary(files: &[(String, Vec<u8>)]) -> Result<Option<(String, Vec<u8>)>, Failure> {
    let folder = env::temp_dir().join(format!("linkage_fmu_{}", process::id()));
    let compiled = compile(files, &folder);
    let _ = fs::remove_dir_all(&folder);
    compiled.map_err(|why| Failure::Unusable(format!("the C compiler: {why}")))
}

fn compile(
    files: &[(String, Vec<u8>)],
    folder: &Path,
) -> Result<Option<(String, Vec<u8>)>, String> {
    let text = |error: std::io::Error| error.to_string();
    fs::create_dir_all(folder).map_err(text)?;
    let mut sources = Vec::new();
    for (name, content) in files {
        let Some(name) = name.strip_prefix("sources/") else { continue };
        fs::write(folder.join(name), content).map_err(text)?;
        if name.ends_with(".c") {
            sources.push(name.to_string());
        }
    }
    let of_all = ["fmi3.c", "linkage_run.c", "linkage_root.c", "linkage_friction.c"];
    let stem = sources.iter().find(|name| !of_all.contains(&&name[..]));
    let stem = stem.expect("a solver is printed").trim_end_matches(".c").to_string();
    let flags = ["-std=c99", "-O2", "-fPIC", "-shared", "-o", "library"];
    let command =
        Command::new("cc").args(flags).args(&sources).arg("-lm").current_dir(folder).output();
    let Ok(output) = command else { return Ok(None) };
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let (system, ending) = match env::consts::OS {
        "macos" => ("darwin", "dylib"),
        "windows" => ("windows", "dll"),
        other => (other, "so"),
    };
    let name = format!("binaries/{}-{system}/{stem}.{ending}", env::consts::ARCH);
    Ok(Some((name, fs::read(folder.join("library")).map_err(text)?)))
}
