//! Files that are written, or compared with what stands there.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use crate::arguments::Target;
use crate::style;

/// The reason why nothing was done.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Mistakes or stale files, which were told.
    Told,
    /// Arguments or a file that cannot be used.
    Unusable(String),
}

impl Failure {
    /// A file that cannot be read or written.
    pub(crate) fn of(path: &Path) -> impl Fn(io::Error) -> Self {
        let path = path.display().to_string();
        move |error| Self::Unusable(format!("`{path}`: {error}"))
    }
}

/// Writes files, names and texts, into a folder, which is made where there is none, or says which of them are stale. Two of one name have
/// to be alike, as the run-time of two mechanisms is.
pub(crate) fn files(
    folder: &Path,
    files: impl Iterator<Item = (String, String)>,
    is_compared: bool,
) -> Result<(), Failure> {
    let mut texts: BTreeMap<PathBuf, String> = BTreeMap::new();
    for (name, text) in files {
        let path = folder.join(&name);
        if texts.get(&path).is_some_and(|other| *other != text) {
            return Err(Failure::Unusable(format!("two mechanisms would be written to `{name}`")));
        }
        texts.insert(path, text);
    }
    if is_compared {
        let stale =
            texts.iter().filter(|(path, text)| !is_fresh(path, |own| own == text.as_bytes()));
        // All of them are told.
        return if stale.count() == 0 { Ok(()) } else { Err(Failure::Told) };
    }
    fs::create_dir_all(folder).map_err(Failure::of(folder))?;
    for (path, text) in texts {
        write(&path, text.as_bytes())?;
    }
    Ok(())
}

/// Writes what comes of a source: a single text to the file of the target or standard output, several into its folder or
/// beside the source.
pub(crate) fn texts(
    target: &Target,
    source: &Path,
    made: Vec<(String, String)>,
) -> Result<(), Failure> {
    let Target { output, stale } = target;
    let is_folder =
        |path: &&PathBuf| path.is_dir() || path.as_os_str().to_string_lossy().ends_with('/');
    match (&made[..], output.as_ref().filter(is_folder)) {
        ([(_, made)], None) => text(output.as_deref(), made, *stale),
        _ => {
            let beside = source.parent().unwrap_or(Path::new(""));
            files(output.as_deref().unwrap_or(beside), made.into_iter(), *stale)
        }
    }
}

/// Writes a text to a file or, without one, to standard output; or says that the file is stale.
pub(crate) fn text(path: Option<&Path>, text: &str, is_compared: bool) -> Result<(), Failure> {
    match path {
        None if is_compared => {
            Err(Failure::Unusable("`--stale` compares with a file: name it by `-o PATH`".into()))
        }
        None => print(text),
        Some(path) if is_compared => match is_fresh(path, |own| own == text.as_bytes()) {
            true => Ok(()),
            false => Err(Failure::Told),
        },
        Some(path) => write(path, text.as_bytes()),
    }
}

/// Writes a file, and prints its name.
pub(crate) fn write(path: &Path, content: &[u8]) -> Result<(), Failure> {
    fs::write(path, content).map_err(Failure::of(path))?;
    print(&format!("{}\n", path.display()))
}

/// True where a file's content passes; otherwise the file is told.
pub(crate) fn is_fresh(path: &Path, passes: impl Fn(&[u8]) -> bool) -> bool {
    let why = match fs::read(path) {
        Ok(own) if passes(&own) => return true,
        Ok(_) => "is stale: it is not what would be written".to_string(),
        Err(error) if error.kind() == ErrorKind::NotFound => "is stale: it is not there".into(),
        Err(error) => format!("cannot be read: {error}"),
    };
    style::tell(&format!("`{}` {why}", path.display()));
    false
}

/// A reader that has seen enough, as `head` has, makes no mistake.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    match io::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Failure::Unusable(error.to_string()))
        }
        _ => Ok(()),
    }
}
