//! A file is read at one sitting, and a function at one look.

use std::path::Path;

use syn::visit::{Visit, visit_file, visit_impl_item_fn, visit_item_fn};
use syn::{File, ImplItemFn, ItemFn, Signature};

use super::sources::{crates, visit};

/// Lines of a file.
const FILE: usize = 400;

/// Lines of a function.
const FUNCTION: usize = 60;

/// Files that programs print.
const PRINTED: [&str; 2] = ["solver/linkage_run.h", "solver/linkage_run.c"];

#[derive(Default)]
struct Functions {
    long: Vec<String>,
}

impl Functions {
    fn look(&mut self, signature: &Signature, end: usize) {
        let lines = end + 1 - signature.ident.span().start().line;
        if lines > FUNCTION {
            self.long.push(format!("{} has {lines} lines", signature.ident));
        }
    }
}

impl<'ast> Visit<'ast> for Functions {
    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.look(&item.sig, item.block.brace_token.span.close().end().line);
        visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        self.look(&item.sig, item.block.brace_token.span.close().end().line);
        visit_impl_item_fn(self, item);
    }
}

/// The functions of a file that are too long.
pub(crate) fn long_functions(file: &File) -> Vec<String> {
    let mut functions = Functions::default();
    visit_file(&mut functions, file);
    functions.long
}

#[test]
fn no_file_is_longer_than_one_sitting() {
    let mut long = Vec::new();
    let root = Path::new(&std::env::var("CARGO_MANIFEST_DIR").expect("cargo sets it")).join("..");
    visit(&root, &["rs", "js", "c", "h", "py", "css"], &mut |path, source| {
        let lines = source.lines().count();
        let is_printed = PRINTED.iter().any(|end| path.ends_with(end));
        if lines > FILE && !is_printed {
            long.push(format!("{}: {lines}", path.display()));
        }
    });
    assert!(long.is_empty(), "files of more than {FILE} lines:\n{}", long.join("\n"));
}

/// Tables of cases make some tests longer.
#[test]
fn no_function_of_a_crate_is_longer_than_one_look() {
    let mut long = Vec::new();
    for source in crates().iter().flat_map(|known| &known.sources) {
        let found = source.long_functions.iter();
        long.extend(found.map(|found| format!("{}: {found}", source.path)));
    }
    assert!(long.is_empty(), "functions of more than {FUNCTION} lines:\n{}", long.join("\n"));
}
