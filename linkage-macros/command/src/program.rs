//! A file with declarations, and files that are written.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use linkage_compiler::{Diagnostic, File, declarations};
use proc_macro2::TokenStream;

use crate::messages;

/// The reason why nothing was done.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Mistakes in declarations, which were reported.
    Mistakes,
    /// A file that cannot be used.
    Unusable(String),
}

/// A Rust program.
pub(crate) struct Program {
    path: PathBuf,
    text: String,
}

impl Program {
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        let text = fs::read_to_string(path)
            .map_err(|error| Failure::Unusable(format!("`{}`: {error}", path.display())))?;
        Ok(Self { path: path.to_path_buf(), text })
    }

    /// The declarations, of which there is at least one.
    pub(crate) fn declarations(&self) -> Result<Vec<TokenStream>, Failure> {
        let tokens: TokenStream = self.text.parse().map_err(|error: proc_macro2::LexError| {
            let at = error.span().start();
            let place = format!("{}:{}:{}", self.path.display(), at.line, at.column + 1);
            Failure::Unusable(format!("{place}: this is not a Rust program: {error}"))
        })?;
        let found = declarations(tokens);
        if found.is_empty() {
            let why = format!("`{}` holds no `mechanism! {{ … }}`", self.path.display());
            return Err(Failure::Unusable(why));
        }
        Ok(found)
    }

    /// The results of all declarations where none has a mistake; otherwise all mistakes are reported.
    pub(crate) fn all<T>(
        &self,
        make: impl Fn(TokenStream) -> Result<T, Vec<Diagnostic>>,
    ) -> Result<Vec<T>, Failure> {
        let (mut made, mut is_clean) = (Vec::new(), true);
        for declaration in self.declarations()? {
            match make(declaration) {
                Ok(one) => made.push(one),
                Err(found) => {
                    is_clean = false;
                    self.report(&found);
                }
            }
        }
        if is_clean { Ok(made) } else { Err(Failure::Mistakes) }
    }

    /// Writes mistakes to the standard error output.
    pub(crate) fn report(&self, mistakes: &[Diagnostic]) {
        for mistake in mistakes {
            eprintln!("{}", messages::text(mistake, &self.path, &self.text));
        }
    }
}

/// Writes files into a folder, which is made where there is none. Two of one name have to be alike, as the run-time
/// of two mechanisms is.
pub(crate) fn write(folder: &Path, files: impl Iterator<Item = File>) -> Result<(), Failure> {
    let mut texts: BTreeMap<String, String> = BTreeMap::new();
    for File { name, text, .. } in files {
        if texts.get(&name).is_some_and(|other| *other != text) {
            return Err(Failure::Unusable(format!("two mechanisms would be written to `{name}`")));
        }
        texts.insert(name, text);
    }
    let unusable = |path: &Path| {
        let path = path.display().to_string();
        move |error: io::Error| Failure::Unusable(format!("`{path}`: {error}"))
    };
    fs::create_dir_all(folder).map_err(unusable(folder))?;
    for (name, text) in texts {
        let path = folder.join(name);
        fs::write(&path, text).map_err(unusable(&path))?;
        print(&format!("{}\n", path.display()))?;
    }
    Ok(())
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
