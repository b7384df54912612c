//! Collects mistakes, and stops at the barriers between phases.

mod retold;
use proc_macro2::{Ident, Span, TokenStream, TokenTree};

/// The gravity of a diagnostic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// A mistake: there is no solver.
    Mistake,
    /// A remark on a solver that is complete.
    Note,
}

/// A mistake in a declaration or a remark on it, and the tokens that it is about.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Diagnostic {
    /// The gravity.
    pub level: Level,
    /// One line that says what to do.
    pub message: String,
    /// The reason, or the nearest name.
    pub note: Option<String>,
    /// The first token of the mistake.
    pub first: Span,
    /// The last token of the mistake. A stable compiler does not join two spans, but underlines what
    /// lies between them.
    pub last: Span,
}

impl Diagnostic {
    fn new(level: Level, at: Extent, message: String, note: Option<String>) -> Self {
        Self { level, message, note, first: at.first, last: at.last }
    }

    /// The mistakes that `syn` found.
    fn adopted(error: syn::Error) -> impl Iterator<Item = Self> {
        error.into_iter().map(|error| {
            let text = error.to_string();
            let (message, note) = match text.split_once('\n') {
                Some((message, note)) => (message.to_owned(), Some(note.to_owned())),
                None => (text, None),
            };
            // Only the tokens of an error tell where it ends.
            let tokens: Vec<_> = error.into_compile_error().into_iter().collect();
            let [first, .., last] = &tokens[..] else { unreachable!("an error is several tokens") };
            let at = Extent::between(first.span(), last.span());
            Self::new(Level::Mistake, at, message, note)
        })
    }

    /// The mistake as a compile error at its tokens.
    pub fn compile_error(&self) -> TokenStream {
        let at = [self.first, self.last].map(|span| TokenTree::Ident(Ident::new("_", span)));
        syn::Error::new_spanned(TokenStream::from_iter(at), self.text()).into_compile_error()
    }

    /// The message and its second line.
    pub fn text(&self) -> String {
        let note = self.note.iter().flat_map(|note| ["\n", note]);
        std::iter::once(&self.message[..]).chain(note).collect()
    }
}

/// The mistakes and notes found so far. Dropping it without asking is a bug of the compiler, so it panics.
#[derive(Default)]
pub struct Diagnostics {
    mistakes: Vec<Diagnostic>,
    notes: Vec<Diagnostic>,
    asked: bool,
}

/// The tokens of a mistake, from the first to the last.
#[derive(Clone, Copy)]
pub struct Extent {
    first: Span,
    last: Span,
}

impl From<Span> for Extent {
    fn from(span: Span) -> Self {
        Self { first: span, last: span }
    }
}

impl Extent {
    pub fn between(first: Span, last: Span) -> Self {
        Self { first, last }
    }

    /// The bytes of the source.
    pub(crate) fn bytes(self) -> std::ops::Range<usize> {
        self.first.byte_range().start..self.last.byte_range().end
    }

    /// From the first token of this to the last of the other.
    pub(crate) fn to(self, end: Self) -> Self {
        Self { first: self.first, last: end.last }
    }
}

/// All mistakes of one declaration, in the order of the source.
#[derive(Debug)]
pub struct Failure(pub Vec<Diagnostic>);

impl Diagnostics {
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes back what was reported after so many mistakes.
    pub(crate) fn forget_since(&mut self, count: usize) {
        self.mistakes.truncate(count);
    }

    /// Reports a mistake at the tokens that made it: one line that says what to do.
    pub fn error(&mut self, at: impl Into<Extent>, message: impl std::fmt::Display) {
        let mistake = Diagnostic::new(Level::Mistake, at.into(), message.to_string(), None);
        self.mistakes.push(mistake);
    }

    /// Reports a mistake whose second line carries the reason or the nearest name.
    pub fn error_because(
        &mut self,
        at: impl Into<Extent>,
        message: impl std::fmt::Display,
        reason: impl std::fmt::Display,
    ) {
        let note = Some(reason.to_string());
        let mistake = Diagnostic::new(Level::Mistake, at.into(), message.to_string(), note);
        self.mistakes.push(mistake);
    }

    /// Notes what is no mistake, with a second line that says what to do. The same note twice is one.
    pub fn note_because(
        &mut self,
        at: impl Into<Extent>,
        message: impl std::fmt::Display,
        reason: impl std::fmt::Display,
    ) {
        let why = Some(reason.to_string());
        let note = Diagnostic::new(Level::Note, at.into(), message.to_string(), why);
        if !self.notes.iter().any(|other| other.is(&note)) {
            self.notes.push(note);
        }
    }

    /// The notes so far, in the order of the source.
    pub fn take_notes(&mut self) -> Vec<Diagnostic> {
        self.notes.sort_by_cached_key(|note| place(note.first));
        std::mem::take(&mut self.notes)
    }

    /// Takes over a mistake that `syn` found.
    pub fn adopt(&mut self, error: syn::Error) {
        self.mistakes.extend(Diagnostic::adopted(error));
    }

    /// The count of mistakes reported so far. Equal counts before and after a step mean that the step found
    /// none.
    pub fn count(&self) -> usize {
        self.mistakes.len()
    }

    /// The end of a phase: go on only where nothing was reported. Mistakes come in the order of
    /// the source, whichever phase found them.
    pub fn barrier(&mut self) -> Result<(), Failure> {
        if self.mistakes.is_empty() {
            return Ok(());
        }
        self.asked = true;
        self.mistakes.sort_by_cached_key(|mistake| place(mistake.first));
        Err(Failure(std::mem::take(&mut self.mistakes)))
    }

    /// The mistakes themselves, for tests that ask where they were made.
    pub fn into_mistakes(mut self) -> Vec<Diagnostic> {
        self.asked = true;
        std::mem::take(&mut self.mistakes)
    }

    /// The end of the last phase.
    pub fn finish(mut self) -> Result<(), Failure> {
        let result = self.barrier();
        self.asked = true;
        result
    }
}

impl Drop for Diagnostics {
    fn drop(&mut self) {
        if !self.asked && !std::thread::panicking() {
            panic!("diagnostics were dropped without a barrier");
        }
    }
}

/// Line and column of a token.
fn place(span: Span) -> (usize, usize) {
    // Inside a macro the compiler is asked: proc-macro2 counts columns anew from the text.
    #[cfg(feature = "macro")]
    if proc_macro::is_available() {
        let span = span.unwrap();
        return (span.line(), span.column());
    }
    let start = span.start();
    (start.line, start.column)
}

/// The candidate nearest to `name`, where one is near enough to have been meant; one that has
/// nothing in common with a short name is not.
pub fn nearest<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let length = name.chars().count();
    let allowed = length.div_ceil(3).min(length.saturating_sub(1));
    candidates
        .map(|candidate| (distance(name, candidate), candidate))
        .filter(|&(distance, _)| distance <= allowed)
        // Among equally near candidates, the one as long as the name wins: `mn` is taken for `mm`, not for
        // `m`.
        .min_by_key(|&(distance, near)| (distance, near.chars().count().abs_diff(length)))
        .map(|(_, candidate)| candidate)
}

/// Optimal string alignment distance, letter case free of charge.
pub fn distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.to_lowercase().chars().collect();
    let b: Vec<char> = b.to_lowercase().chars().collect();
    let mut rows = vec![vec![0; b.len() + 1]; a.len() + 1];
    for i in 0..=a.len() {
        for j in 0..=b.len() {
            rows[i][j] = if i == 0 || j == 0 {
                i + j
            } else {
                let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
                let mut best = replaced.min(rows[i - 1][j] + 1).min(rows[i][j - 1] + 1);
                if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                    best = best.min(rows[i - 2][j - 2] + 1);
                }
                best
            };
        }
    }
    rows[a.len()][b.len()]
}
