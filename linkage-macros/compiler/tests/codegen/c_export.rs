//! The additions of `export c;`, and the code that it leaves unchanged.

use super::fixture::{four_bar, ident, table};
use super::{associated_items, expand, generate, squeezed};
use crate::ir::program::Program;
use crate::model::mechanism::Mechanism;
use quote::ToTokens;
use syn::{Expr, ExprLit, ImplItem, Lit};

fn exported((mut mechanism, program): (Mechanism, Program)) -> (Mechanism, Program) {
    mechanism.export_c = true;
    (mechanism, program)
}

/// The text of `C_HEADER`.
fn header((mechanism, program): &(Mechanism, Program)) -> String {
    let file = super::file(generate(mechanism, program));
    let text = associated_items(&file).into_iter().find_map(|item| match item {
        ImplItem::Const(item) if item.ident == "C_HEADER" => match &item.expr {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) => Some(text.value()),
            other => panic!("a header that is no text: {}", other.to_token_stream()),
        },
        _ => None,
    });
    text.expect("there is a header")
}

#[test]
fn nothing_unsafe_comes_without_the_statement() {
    for text in [expand(&four_bar()), expand(&table())] {
        for word in ["unsafe", "extern", "*const", "*mut", "repr", "C_HEADER"] {
            assert!(!text.contains(word), "`{word}` in\n{text}");
        }
    }
}

#[test]
fn every_entry_point_is_a_function_in_both_widths() {
    let (mechanism, program) = exported(four_bar());
    let entries = program.answers.len();
    let text = expand(&(mechanism, program));
    // Beside the entry points, the defaults in both widths.
    assert_eq!(text.matches("#[unsafe(no_mangle)]").count(), 2 * (entries + 1), "{text}");
    let all = squeezed(&text);
    for part in [
        "extern \"C\" fn four_bar_default() -> Parameters_<f64> { Parameters_ { crank: 0.08, elbow: 1 } }",
        "unsafe extern \"C\" fn four_bar_position(mechanism_: *const Parameters_<f64>, q0_: f64, \
         to_: *mut FourBarPosition<f64>, why_: *mut private::CError) \
         -> private::i32 {",
        "unsafe { read_(mechanism_, \"mechanism\") }?.solver_()?.position(q0_)?",
        "unsafe { reply_(answer_, to_, \"position\", why_) }",
        "elbow: private::c_side(self.elbow, \"elbow\")? }",
        "to_: *mut FourBarMotion<private::f32>,",
    ] {
        assert!(all.contains(part), "no `{part}` in\n{text}");
    }
}

#[test]
fn records_that_c_sees_are_laid_out_as_c_lays_them_out() {
    let text = squeezed(&expand(&exported(table())));
    let records = ["Input", "Position", "Velocity", "Acceleration", "Motion"];
    for record in records {
        let (before, _) =
            text.split_once(&format!("struct Table{record}<T = f64>")).expect("a record");
        let attributes = before.rsplit_once("[derive(").expect("attributes").1;
        assert!(attributes.contains("#[repr(C)]"), "{record}: {attributes}");
    }
}

#[test]
fn several_inputs_come_by_pointers_and_modes_as_numbers() {
    let text = squeezed(&expand(&exported(table())));
    for part in [
        "fn table_velocity(mechanism_: *const Parameters_<f64>, q0_: *const TableInput<f64>, \
         q1_: *const TableInput<f64>,",
        "let q1_ = unsafe { read_(q1_, \"rates\") }?;",
        "way: private::c_sense(self.way, \"way\")?,",
        "Parameters_ { way: -1, use_new_: PhantomData }",
    ] {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
}

#[test]
fn the_header_declares_what_is_generated() {
    let header = header(&exported(table()));
    for part in [
        "#ifndef TABLE_H\n",
        "#define TABLE_INPUTS 2\n#define TABLE_OUTPUTS 5\n",
        "typedef struct Table {\n    /* LINKAGE_AHEAD or LINKAGE_BEHIND */\n    int32_t way;\n} Table;\n",
        "typedef struct TableInput {\n    /* In m, its rates in m/s and m/s^2 */\n    double s;\n",
        "    LinkageSlidingDirection ram;\n",
        "    LinkageSlide bed;\n",
        "    double area;\n",
        "    LinkageDirection turn;\n",
        "    LinkageAngularVelocityF32 turn;\n",
        "} TableMotionF32;\n",
        "LinkageStatus table_velocity(const Table *mechanism, const TableInput *inputs, \
         const TableInput *rates, TableVelocity *velocity, LinkageError *error);\n",
        "LinkageStatus table_coefficients_f32(const TableF32 *mechanism, \
         const TableInputF32 *inputs, float coefficients[5][2], LinkageError *error);\n",
        "TableF32 table_default_f32(void);\n",
    ] {
        assert!(header.contains(part), "no `{part}` in\n{header}");
    }
}

#[test]
fn the_users_words_neither_end_a_comment_nor_meet_a_keyword() {
    let (mut mechanism, program) = exported(four_bar());
    mechanism.docs = super::fixture::docs(" Lengths */ int x; /* in cm²: θ.");
    mechanism.inputs[0].name = ident("Int");
    mechanism.outputs[0].field = ident("register");
    mechanism.outputs[1].field = ident("register_");
    let header = header(&(mechanism, program));
    assert!(header.contains(" * Lengths * / int x; / * in cm^2: θ.\n"), "{header}");
    assert!(header.contains("double int_, FourBarPosition *position"), "{header}");
    assert!(header.contains(" register_;\n") && header.contains(" register__;\n"), "{header}");
}
