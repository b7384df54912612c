//! A program in C that reads poses and writes all that is carried over.

use std::fmt::Write as _;

/// A pair as both languages call it, and ranges of the inputs of the first.
struct Pair {
    function: &'static str,
    machine: &'static str,
    from: &'static str,
    to: &'static str,
    has_parameters: bool,
    count: usize,
}

const fn pair(
    machine: &'static str,
    [from, to]: [&'static str; 2],
    function: &'static str,
    (has_parameters, count): (bool, usize),
) -> Pair {
    Pair { function, machine, from, to, has_parameters, count }
}

const PAIRS: [Pair; 10] = [
    pair("Arm", ["Motors", "Hand"], "arm_motors_to_hand", (true, 2)),
    pair("Arm", ["Hand", "Motors"], "arm_hand_to_motors", (true, 2)),
    pair("Slider", ["CrankSide", "Press"], "slider_crank_side_to_press", (false, 1)),
    pair("Slider", ["Press", "CrankSide"], "slider_press_to_crank_side", (false, 1)),
    pair("Bicycle", ["Shock", "Wheel"], "bicycle_shock_to_wheel", (true, 1)),
    pair("Bicycle", ["Shock", "Lever"], "bicycle_shock_to_lever", (true, 1)),
    pair("Bicycle", ["Wheel", "Shock"], "bicycle_wheel_to_shock", (true, 1)),
    pair("Bicycle", ["Wheel", "Lever"], "bicycle_wheel_to_lever", (true, 1)),
    pair("Bicycle", ["Lever", "Shock"], "bicycle_lever_to_shock", (true, 1)),
    pair("Bicycle", ["Lever", "Wheel"], "bicycle_lever_to_wheel", (true, 1)),
];

/// A function in C that reads a pose, its rates, efforts and an inertia, and writes all that is carried over.
fn caller(pair: &Pair, is_single: bool) -> String {
    let Pair { function, machine, from, to, has_parameters, count } = pair;
    let [real, suffix, tail] =
        if is_single { ["float", "F32", "_f32"] } else { ["double", "", "_f64"] };
    let ending = if is_single { "_f32" } else { "" };
    let record = |set: &str| match count {
        1 => real.to_string(),
        _ => format!("{machine}{set}Input{suffix}"),
    };
    let by = if *count == 1 { "" } else { "&" };
    let (stem, set) = (machine.to_lowercase(), function.split("_to_").next().expect("it has one"));
    let parameters = match has_parameters {
        true => format!(
            "const {machine}{suffix} declared = {stem}_default{ending}();\n    const {machine}{from}{suffix} own = {set}_of{ending}(&declared);\n"
        ),
        false => String::new(),
    };
    let passed = if *has_parameters { "&own, " } else { "" };
    let (from_type, to_type, square) = (record(from), record(to), count * count);
    let written = |name: &str, numbers: usize| {
        format!("put_{real}(status, (const {real} *){name}, {numbers});\n")
    };
    format!(
        "static void {function}_all{tail}(long poses)\n{{\n{real} given[{all}], ratios[{count}][{count}], inertia[{count}][{count}], felt[{count}][{count}];\n\
         {machine}{from}To{to}{suffix} transfer;\n{from_type} q, rates, accelerations, carried;\n{to_type} there, moving[3], efforts;\nLinkageStatus status;\n\
         {parameters}while (poses-- > 0) {{\n\
         if (fread(given, sizeof given, 1, stdin) != 1) {{\nexit(3);\n}}\n\
         memcpy(&q, given, sizeof q);\nmemcpy(&rates, given + {count}, sizeof q);\nmemcpy(&accelerations, given + 2 * {count}, sizeof q);\n\
         memcpy(&efforts, given + 3 * {count}, sizeof efforts);\nmemcpy(inertia, given + 4 * {count}, sizeof inertia);\n\
         status = {function}{ending}({passed}{by}q, &transfer, NULL);\n{}\
         if (status != LINKAGE_OK) {{\ncontinue;\n}}\n\
         status = {function}_rates{ending}(&transfer, {by}rates, &there, NULL);\n{}\
         status = {function}_motion{ending}(&transfer, {by}rates, {by}accelerations, moving, NULL);\n{}\
         status = {function}_ratios{ending}(&transfer, ratios, NULL);\n{}\
         status = {function}_efforts{ending}(&transfer, {by}efforts, &carried, NULL);\n{}\
         status = {function}_inertia{ending}(&transfer, inertia, felt, NULL);\n{}}}\n}}\n",
        written("&transfer.coordinates", *count),
        written("&there", *count),
        written("moving", 3 * count),
        written("ratios", square),
        written("&carried", *count),
        written("felt", square),
        all = 4 * count + square,
    )
}

/// The program, with functions of both widths or of single precision alone.
pub(crate) fn source(has_double: bool) -> String {
    let widths = if has_double { &[false, true][..] } else { &[true] };
    let mut text = "#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n#include \"arm.h\"\n#include \"bicycle.h\"\n#include \"slider.h\"\n"
        .to_string();
    for &is_single in widths {
        let real = if is_single { "float" } else { "double" };
        write!(
            text,
            "\nstatic void put_{real}(LinkageStatus status, const {real} *numbers, size_t count)\n{{\nconst double told = (double)status;\nfwrite(&told, sizeof told, 1, stdout);\n\
             while (status == LINKAGE_OK && count-- > 0) {{\nconst double number = (double)*numbers++;\nfwrite(&number, sizeof number, 1, stdout);\n}}\n}}\n"
        )
        .expect("a text can be written");
    }
    text += "\n";
    for pair in &PAIRS {
        widths.iter().for_each(|&is_single| text += &caller(pair, is_single));
    }
    text += "int main(int count, char **words)\n{\nconst long poses = count > 2 ? atol(words[2]) : 0;\n";
    for Pair { function, .. } in &PAIRS {
        for &is_single in widths {
            let tail = if is_single { "_f32" } else { "_f64" };
            let name = format!("{function}_all{tail}");
            text += &format!(
                "if (count > 1 && strcmp(words[1], \"{name}\") == 0) {{\n{name}(poses);\n}}\n"
            );
        }
    }
    text + "return 0;\n}\n"
}
