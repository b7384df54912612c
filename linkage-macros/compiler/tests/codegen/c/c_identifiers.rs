//! Tests of `codegen/c/c_identifiers`.

pub(crate) use linkage_compiler::codegen::c::c_identifiers::*;
use proc_macro2::Ident;

#[test]
fn a_type_name_becomes_the_start_of_function_names() {
    for (name, snake) in [
        ("FlyingShear", "flying_shear"),
        ("FourBar2", "four_bar2"),
        ("Stage2Ram", "stage2_ram"),
        ("RRRDyad", "rrr_dyad"),
        ("Ω", "u03c9"),
    ] {
        assert_eq!(snake_case(name), snake);
    }
}

fn solver() -> Ident {
    Ident::new("Press", proc_macro2::Span::call_site())
}

#[test]
fn names_that_c_reserves_or_that_meet_get_a_tail() {
    for (name, tailed) in [
        ("int", "int_"),
        ("int_", "int__"),
        ("BC", "BC"),
        ("θ", "u03b8"),
        ("xor_eq", "xor_eq_"),
        ("do", "do_"),
        ("NAN", "NAN_"),
        ("NULL", "NULL_"),
        ("linux", "linux_"),
        ("DEC64_MAX", "DEC64_MAX_"),
        ("FLT32X_SNAN", "FLT32X_SNAN_"),
        ("FLTR_1", "FLTR_1"),
        ("near", "near_"),
        ("_B", "c_B"),
        ("__unix__", "c__unix__"),
        ("LinkagePoint", "LinkagePoint_"),
        ("PRESS_INPUTS", "PRESS_INPUTS_"),
        ("PRESS_H", "PRESS_H_"),
        ("PRESS_DECLARATION", "PRESS_DECLARATION_"),
        ("LEVER_INPUTS", "LEVER_INPUTS"),
        // Macros that are called stand for themselves elsewhere, and so do functions.
        ("isnan", "isnan"),
        ("sin", "sin"),
    ] {
        let names = ["int", name].map(str::to_string);
        let names = if name == "int" { &names[1..] } else { &names[..] };
        let names = distinct(&solver(), names.to_vec());
        assert_eq!(names.last().expect("there is one"), tailed);
    }
}

#[test]
fn arguments_hide_no_function() {
    let inputs = ["press_velocity", "press_origin", "linkage_sin_cos", "press_angle", "error"];
    let fixed = ["mechanism", "position", "error"];
    let names = arguments(&solver(), fixed, inputs.into_iter().map(str::to_string));
    assert_eq!(names[..3], fixed);
    let tailed = ["press_velocity_", "press_origin_", "linkage_sin_cos_", "press_angle", "error_"];
    assert_eq!(names[3..], tailed);
}

#[test]
fn types_and_files_are_clear_of_others() {
    let [double, single] = Width::ALL.map(|width| move |name| width.type_name(name));
    for (name, types) in [
        ("FourBar", ["FourBar", "FourBarF32"]),
        ("LinkagePoint", ["LinkagePoint_", "LinkagePointF32_"]),
        ("HUGE_VAL", ["HUGE_VAL_", "HUGE_VALF32"]),
        ("HUGE_VAL_", ["HUGE_VAL_", "HUGE_VAL_F32_"]),
        ("sin", ["sin_", "sinF32"]),
        ("timespec", ["timespec_", "timespecF32"]),
        ("fmi3Clock", ["fmi3Clock_", "fmi3ClockF32_"]),
    ] {
        assert_eq!([double(name), single(name)], types);
    }
    for (name, stem) in [
        ("FourBar", "four_bar"),
        ("Math", "math_mechanism"),
        ("LinkageRun", "linkage_run_mechanism"),
        ("Fmi3", "fmi3_mechanism"),
        ("Aux", "aux_mechanism"),
    ] {
        assert_eq!(file_stem(name), stem);
    }
}
