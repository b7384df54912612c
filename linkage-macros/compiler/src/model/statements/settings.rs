//! Statements about the generated code: `numerics`, `crate`, `export`.

use proc_macro2::Ident;
use syn::Attribute;
use syn::spanned::Spanned;

use crate::syntax::tree::{CrateStatement, ExportStatement, NumericsStatement};

use crate::model::mechanism::Numerics;
use crate::model::scope::Scope;
use crate::model::statements::Rules;

impl Rules for NumericsStatement {
    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        numerics(scope, &self.mode);
    }
}

impl Rules for CrateStatement {
    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        crate_path(scope, &self.path);
    }
}

impl Rules for ExportStatement {
    fn resolve(&self, scope: &mut Scope<'_>, _docs: &[Attribute]) {
        export(scope, &self.what);
    }
}

/// The numerics are compensated or plain, and chosen once.
fn numerics(scope: &mut Scope<'_>, mode: &Ident) {
    let chosen = match mode.to_string().as_str() {
        "compensated" => Numerics::Compensated,
        "fast" => {
            let reason = "what it asked for is what every declaration has";
            scope.diagnostics.error_because(mode.span(), "leave `numerics fast;` out", reason);
            return;
        }
        _ => {
            let message = format!("no numerics named `{mode}`; write `compensated`");
            let reason = "`compensated` carries the rounding errors of a dyad along and takes \
                          longer; without the statement they are plain";
            scope.diagnostics.error_because(mode.span(), message, reason);
            return;
        }
    };
    if scope.mechanism.numerics != Numerics::Plain {
        scope.diagnostics.error(mode.span(), "`numerics` is given twice; remove one");
    }
    scope.mechanism.numerics = chosen;
}

/// The path of `linkage-core` is given once.
fn crate_path(scope: &mut Scope<'_>, path: &syn::Path) {
    if scope.mechanism.crate_path.is_some() {
        scope.diagnostics.error(path.span(), "`crate` is given twice; remove one");
        return;
    }
    scope.mechanism.crate_path = Some(path.clone());
}

/// Functions for C and the list of assemblies are exported, each once.
fn export(scope: &mut Scope<'_>, what: &Ident) {
    let is_given = match what.to_string().as_str() {
        "c" => std::mem::replace(&mut scope.mechanism.export_c, true),
        "assemblies" => scope.mechanism.export_assemblies.replace(what.clone()).is_some(),
        _ => {
            let message =
                format!("no export named `{what}`; write `export c;` or `export assemblies;`");
            scope.diagnostics.error(what.span(), message);
            scope.mechanism.export_c = true;
            return;
        }
    };
    if is_given {
        scope.diagnostics.error(what.span(), format!("`export {what}` is given twice; remove one"));
    }
}
