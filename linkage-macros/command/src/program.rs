//! A file with declarations.

use std::fs;
use std::path::{Path, PathBuf};

use linkage_compiler::{
    Diagnostic, by_set, declarations, machine_and_set, solver_name, unbalanced,
};
use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};

use crate::arguments::Chosen;
use crate::messages::Place;
use crate::output::Failure;
use crate::parameters::{self, Setting};
use crate::report::Report;

/// A Rust program, or a declaration alone.
pub(crate) struct Program {
    pub path: PathBuf,
    text: String,
    machine: Option<String>,
    inputs: Vec<String>,
    settings: Vec<Setting>,
}

/// The tokens between the braces of `mechanism! { … }`.
#[derive(Clone)]
pub(crate) struct Declaration {
    /// The word behind `struct`.
    pub name: Option<Ident>,
    /// The machine and the set of inputs, of one that has several.
    pub driven: Option<[Ident; 2]>,
    pub tokens: TokenStream,
}

impl Program {
    pub(crate) fn read(path: &Path, chosen: &Chosen) -> Result<Self, Failure> {
        let settings =
            chosen.set.iter().map(|text| Setting::read(text)).collect::<Result<_, _>>()?;
        let text = fs::read_to_string(path).map_err(Failure::of(path))?;
        let (machine, inputs) = (chosen.machine.clone(), chosen.inputs.clone());
        Ok(Self { path: path.to_path_buf(), text, machine, inputs, settings })
    }

    /// The declarations, or the chosen one, with parameters as they are set. There is at least one.
    pub(crate) fn declarations(&self) -> Result<Vec<Declaration>, Failure> {
        let mut found = self.written()?;
        parameters::set(&mut found, &self.settings)?;
        Ok(found)
    }

    /// The same with parameters as they are declared.
    pub(crate) fn written(&self) -> Result<Vec<Declaration>, Failure> {
        let mut found = self.found()?;
        if let Some(machine) = &self.machine {
            let names: Vec<_> = found.iter().map(Declaration::name).collect();
            let there_are = names.join(", ");
            found.retain(|declaration| {
                let is_driven = declaration.driven.as_ref().is_some_and(|[of, _]| of == machine);
                is_driven || declaration.name() == *machine
            });
            if found.is_empty() {
                let path = self.path.display();
                let why = format!("`{path}` holds no mechanism `{machine}`; there are {there_are}");
                return Err(Failure::Unusable(why));
            }
        }
        self.keep_chosen_sets(&mut found)?;
        Ok(found)
    }

    /// Leaves the sets of inputs that are asked for; all where none is.
    fn keep_chosen_sets(&self, found: &mut Vec<Declaration>) -> Result<(), Failure> {
        if self.inputs.is_empty() {
            return Ok(());
        }
        let sets = found.iter().filter_map(|declaration| declaration.driven.as_ref());
        let mut sets: Vec<_> = sets.map(|[_, set]| set.to_string()).collect();
        sets.dedup();
        if let Some(unknown) = self.inputs.iter().find(|wanted| !sets.contains(wanted)) {
            let path = self.path.display();
            let there_are = match sets.is_empty() {
                true => "its inputs have no names of sets".to_string(),
                false => format!("there are {}", sets.join(", ")),
            };
            let why = format!("`{path}` has no set of inputs `{unknown}`; {there_are}");
            return Err(Failure::Unusable(why));
        }
        found.retain(|declaration| {
            let set = declaration.driven.as_ref().map(|[_, set]| set.to_string());
            set.is_some_and(|set| self.inputs.contains(&set))
        });
        Ok(())
    }

    fn found(&self) -> Result<Vec<Declaration>, Failure> {
        let tokens: TokenStream = self.text.parse().map_err(|error: proc_macro2::LexError| {
            let at = error.span().start();
            let (line, column, why) = match unbalanced(&self.text) {
                Some((bracket, why)) => {
                    let before = &self.text[..bracket.start];
                    let line = before.rsplit('\n').next().unwrap_or(before);
                    (before.matches('\n').count() + 1, line.chars().count(), why)
                }
                None => (at.line, at.column, error.to_string()),
            };
            let place = format!("{}:{line}:{}", self.path.display(), column + 1);
            Failure::Unusable(format!("{place}: this is not a Rust program: {why}"))
        })?;
        let mut found = declarations(tokens.clone());
        if found.is_empty() && is_declaration(&tokens) {
            found.extend(by_set(tokens));
        }
        if found.is_empty() {
            let why = format!(
                "`{}` holds no `mechanism! {{ … }}`, and is not what stands between its braces",
                self.path.display()
            );
            return Err(Failure::Unusable(why));
        }
        Ok(found
            .into_iter()
            .map(|tokens| {
                let (name, driven) = (solver_name(&tokens), machine_and_set(&tokens));
                Declaration { name, driven, tokens }
            })
            .collect())
    }

    /// The call of the macro around a declaration, as it is written, with layout and comments.
    pub(crate) fn call(&self, declaration: &Declaration) -> String {
        let spans = declaration.tokens.clone().into_iter().map(|tree| tree.span().byte_range());
        // The mark of a set of inputs stands in no text.
        let mut spans = spans.filter(|range| !range.is_empty());
        let first = spans.next().map_or(0, |range| range.start);
        let last = spans.last().map_or(self.text.len(), |range| range.end);
        let Some(word) = self.text[..first].rfind("mechanism!") else {
            return format!("mechanism! {{\n{}\n}}", self.text.trim_end());
        };
        // `linkage_core::mechanism!`
        let is_path = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == ':';
        let path = self.text[..word].trim_end_matches(is_path).len();
        self.text[path..self.end_of_call(last)].to_string()
    }

    /// The place behind the bracket that closes a call, `last` being that behind the call's last token: comments may
    /// stand between.
    fn end_of_call(&self, last: usize) -> usize {
        let mut at = last;
        loop {
            let rest = &self.text[at..];
            let trimmed = rest.trim_start();
            at += rest.len() - trimmed.len();
            let comment = match () {
                () if trimmed.starts_with("//") => trimmed.find('\n'),
                () if trimmed.starts_with("/*") => trimmed.find("*/").map(|end| end + 2),
                () => return (at + 1).min(self.text.len()),
            };
            at += comment.unwrap_or(trimmed.len());
        }
    }

    /// The results of the declarations where none has a mistake; otherwise all mistakes are told.
    pub(crate) fn all<T>(
        &self,
        make: impl Fn(TokenStream) -> Result<T, Vec<Diagnostic>>,
    ) -> Result<Vec<T>, Failure> {
        self.each(self.declarations()?, |declaration| make(declaration.tokens.clone()))
    }

    /// The same of these declarations.
    pub(crate) fn each<T>(
        &self,
        declarations: Vec<Declaration>,
        make: impl Fn(&Declaration) -> Result<T, Vec<Diagnostic>>,
    ) -> Result<Vec<T>, Failure> {
        let (mut made, mut report) = (Vec::new(), Report::default());
        for declaration in declarations {
            match make(&declaration) {
                Ok(one) => made.push(one),
                Err(found) => report.tell(self, &declaration, &found),
            }
        }
        report.close()?;
        Ok(made)
    }

    /// The sets of inputs of each machine that has several, one list a machine.
    pub(crate) fn machines(&self) -> Result<Vec<Vec<Declaration>>, Failure> {
        let mut machines: Vec<Vec<Declaration>> = Vec::new();
        for declaration in self.declarations()? {
            let Some([machine, _]) = &declaration.driven else { continue };
            let is_last = |sets: &&mut Vec<Declaration>| {
                let own = sets.last().and_then(|last| last.driven.as_ref());
                own.is_some_and(|[own, _]| own == machine)
            };
            match machines.last_mut().filter(is_last) {
                Some(sets) => sets.push(declaration),
                None => machines.push(vec![declaration]),
            }
        }
        Ok(machines)
    }

    /// The tokens of a message in the file, or in the value of a parameter that is set. What is about a whole
    /// declaration is told at its name.
    pub(crate) fn place(&self, declaration: &Declaration, found: &Diagnostic) -> Place<'_> {
        let (mut first, mut last) = (found.first, found.last);
        if first.byte_range().is_empty() {
            first = declaration.name.as_ref().map_or(Span::call_site(), Ident::span);
            last = first;
        }
        if last.file() != first.file() {
            last = first;
        }
        let is_own = |setting: &&Setting| setting.holds(first);
        let (name, text) = match self.settings.iter().find(is_own) {
            Some(setting) => ("--set".to_string(), &setting.text),
            None => (self.path.display().to_string(), &self.text),
        };
        Place { name, text, from: first.start(), to: last.end() }
    }
}

impl Declaration {
    /// The name as it is written; empty where there is none.
    pub(crate) fn name(&self) -> String {
        self.name.as_ref().map(Ident::to_string).unwrap_or_default()
    }
}

/// True if a file is what stands between the braces of `mechanism! { … }`: a struct with its docs, and nothing behind it.
fn is_declaration(tokens: &TokenStream) -> bool {
    let is_brace = |tree: &TokenTree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    let mut trees = tokens.clone().into_iter().skip_while(|tree| match tree {
        TokenTree::Ident(word) => word == "pub",
        TokenTree::Punct(sign) => sign.as_char() == '#',
        TokenTree::Group(group) => group.delimiter() != Delimiter::Brace,
        TokenTree::Literal(_) => false,
    });
    let is_struct = trees.next().is_some_and(|tree| tree.to_string() == "struct");
    is_struct && trees.by_ref().any(|tree| is_brace(&tree)) && trees.next().is_none()
}
