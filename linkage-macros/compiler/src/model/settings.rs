//! Statements about the generated code: `numerics`, `crate`, `export`.

use proc_macro2::Ident;
use syn::spanned::Spanned;

use super::Resolver;
use super::mechanism::Numerics;

impl Resolver<'_> {
    /// The numerics are compensated or plain, and chosen once.
    pub(super) fn numerics(&mut self, mode: &Ident) {
        let chosen = match mode.to_string().as_str() {
            "compensated" => Numerics::Compensated,
            "fast" => {
                let reason = "what it asked for is what every declaration has";
                self.diagnostics.error_because(mode.span(), "leave `numerics fast;` out", reason);
                return;
            }
            _ => {
                let message = format!("no numerics named `{mode}`; write `compensated`");
                let reason = "`compensated` carries the rounding errors of a dyad along and takes \
                              longer; without the statement they are plain";
                self.diagnostics.error_because(mode.span(), message, reason);
                return;
            }
        };
        if self.mechanism.numerics != Numerics::Plain {
            self.diagnostics.error(mode.span(), "`numerics` is given twice; remove one");
        }
        self.mechanism.numerics = chosen;
    }

    /// The path of `linkage-core` is given once.
    pub(super) fn crate_path(&mut self, path: &syn::Path) {
        if self.mechanism.crate_path.is_some() {
            self.diagnostics.error(path.span(), "`crate` is given twice; remove one");
            return;
        }
        self.mechanism.crate_path = Some(path.clone());
    }

    /// The only language to export to is C.
    pub(super) fn export(&mut self, language: &Ident) {
        if language != "c" {
            let message = format!("no export named `{language}`; write `export c;`");
            self.diagnostics.error(language.span(), message);
        } else if self.mechanism.export_c {
            self.diagnostics.error(language.span(), "`export c` is given twice; remove one");
        }
        self.mechanism.export_c = true;
    }
}
