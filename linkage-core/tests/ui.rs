//! Messages that rustc alone can show: where it underlines, what it says once the macro is done,
//! and that a struct in error can be used without a second message. Each file is named for its
//! mistake, in a folder by its phase; `mixed` has several at once, `calls` uses a mechanism wrongly.
//!
//! The text of a message, and its token, is a row of the compiler's own tests, where it takes no
//! run of rustc. A few files of every phase show that the places come through the macro.
//!
//! `LINKAGE_MESSAGES=1 cargo test -p linkage-core --test ui` writes the messages down anew.
//!
//! Each file is given to the compiler with the library that Cargo has built already: building the
//! library and all below it once more, for the messages alone or with other features, takes a minute.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

const HERE: &str = env!("CARGO_MANIFEST_DIR");

/// `liblinkage_core-….rmeta` beside this program: that of the newest `….rlib` with default features,
/// which Cargo has made for it or found to be as new as its sources. What `cargo check` and Clippy leave
/// there has no `….rlib`, and is not for the compiler that this test runs.
fn library() -> PathBuf {
    let program = std::env::current_exe().expect("this program is a file");
    let folder = program.parent().expect("a file is in a folder");
    let entries = fs::read_dir(folder).expect("the folder is there");
    let libraries = entries.map(|entry| entry.expect("an entry").path()).filter(|path| {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        name.starts_with("liblinkage_core-") && name.ends_with(".rlib")
    });
    let mut libraries: Vec<_> = libraries.collect();
    let made = |path: &PathBuf| fs::metadata(path).and_then(|file| file.modified()).ok();
    libraries.sort_by_key(made);
    let mut newest_first = libraries.iter().rev().map(|path| path.with_extension("rmeta"));
    let with_default_features = newest_first
        .find(|library| compiled("tests/ui/default_features.rs", library).status.success());
    with_default_features.expect("Cargo has built the library")
}

/// The files with mistakes, as the messages name them.
fn mistakes() -> Vec<String> {
    let mut files = Vec::new();
    for folder in list("tests/ui").into_iter().filter(|name| !name.ends_with(".rs")) {
        files.extend(list(&folder).into_iter().filter(|file| file.ends_with(".rs")));
    }
    files
}

fn list(directory: &str) -> Vec<String> {
    let entries = fs::read_dir(Path::new(HERE).join(directory)).expect("the directory is there");
    let name = |entry: fs::DirEntry| entry.file_name().into_string().expect("names are text");
    let mut paths: Vec<_> =
        entries.map(|entry| format!("{directory}/{}", name(entry.expect("an entry")))).collect();
    paths.sort();
    paths
}

/// The compiler's run on a file.
fn compiled(file: &str, library: &Path) -> Output {
    Command::new(Path::new(env!("CARGO")).with_file_name("rustc"))
        .args(["--edition=2024", "--emit=metadata", "--color=never", "--diagnostic-width=140"])
        .args(["-Adead_code", "-o"])
        .arg(Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{}.ui", file.replace('/', "."))))
        .arg("-L")
        .arg(library.parent().expect("the library is in a directory"))
        .arg("--extern")
        .arg(format!("linkage_core={}", library.display()))
        .arg(file)
        .current_dir(HERE)
        .output()
        .expect("the compiler starts")
}

/// The compiler's messages for a file; empty if it compiles.
fn messages(file: &str, library: &Path) -> String {
    let output = compiled(file, library);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(i32::from(!said.is_empty())), "{file}: {said}");
    let of_the_file = said.split("\n\n").filter(|message| {
        !message.starts_with("error: aborting due to") && !message.starts_with("For more info")
    });
    let messages = of_the_file.collect::<Vec<_>>().join("\n\n");
    assert!(!messages.contains(HERE), "{file} shows a file of the library: {messages}");
    if messages.is_empty() { messages } else { messages.trim_end().to_owned() + "\n" }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// Compares what the compiler says with what is written down, or writes it down.
fn check(file: &str, library: &Path) -> Result<(), String> {
    let (found, expected) = (messages(file, library), file.replace(".rs", ".stderr"));
    let expected = Path::new(HERE).join(expected);
    if found.is_empty() {
        return Err(format!("{file} compiles"));
    }
    if std::env::var_os("LINKAGE_MESSAGES").is_some() {
        return fs::write(expected, found).map_err(|error| format!("{file}: {error}"));
    }
    let expected = fs::read_to_string(expected).unwrap_or_default();
    let is_same = found == expected;
    if is_same { Ok(()) } else { Err(format!("{file}, expected:\n{expected}\nfound:\n{found}")) }
}

#[test]
fn mistakes_are_reported_at_their_tokens() {
    let (files, library) = (mistakes(), library());
    assert!(files.len() > 80, "{} files only", files.len());
    let (next, failures) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some(file) = files.get(next.fetch_add(1, Ordering::Relaxed)) {
            match check(file, &library) {
                Ok(()) => println!("test {file} ... ok"),
                Err(failure) => failures.lock().expect("no thread panics here").push(failure),
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let failures = failures.into_inner().expect("no thread panics here");
    assert!(
        failures.is_empty(),
        "{} of {}:\n\n{}",
        failures.len(),
        files.len(),
        failures.join("\n")
    );
}
