//! The functions of the run-time beside those of C: the same bits at numbers of every size, next to quarter turns, at
//! zeros of both signs, and at the ends of their ranges.

use std::fs;
use std::process::Command;

use linkage_compiler::{File, c, st};

use super::evaluator::{Machine, Value};
use super::folder;
use super::poses::Random;
use super::reader::{Basic, Project};
use super::skipped::skipped;

const CRANK: &str =
    "pub struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2, angle: t } }";

/// Names in structured text, their operands, and the call in C of `a`, `b`, `c` and `d`, which may write `more`.
const FUNCTIONS: [(&str, &[&str], &str); 9] = [
    ("SIN_COS", &["X"], "linkage_sin_cos@(a, &told, &more)"),
    ("ASIN", &["X"], "told = linkage_asin@(a)"),
    ("ACOS", &["X"], "told = linkage_acos@(a)"),
    ("ATAN", &["X"], "told = linkage_atan@(a)"),
    ("ATAN2", &["Y", "X"], "told = linkage_atan2@(a, b)"),
    ("DET", &["A", "B", "C", "D"], "told = linkage_det@(a, b, c, d)"),
    ("MUL_ERR", &["A", "B"], "told = linkage_mul_err@(a, b)"),
    ("ADD_ERR", &["A", "B"], "told = linkage_add_err@(a, b)"),
    ("ON_CIRCLE", &["COSINE", "SINE"], "(void)linkage_on_circle@(a, b, &told, &more)"),
];

/// Four operands of a function.
fn operands(function: &str, random: &mut Random) -> [f64; 4] {
    let pick = |of: &[f64], random: &mut Random| of[random.below(of.len())];
    let any = |random: &mut Random| random.unit() * 10_f64.powi(random.below(9) as i32 - 4);
    match function {
        "SIN_COS" => {
            let quarters = (random.below(2000) as f64 - 1000.0) * std::f64::consts::FRAC_PI_2;
            let far = random.unit() * 51_000.0;
            let near = quarters + random.unit() * pick(&[0.0, 1e-9, 1e-4], random);
            [pick(&[0.0, -0.0, 7.0 * random.unit(), far, near, 51_471.0], random), 0.0, 0.0, 0.0]
        }
        "ASIN" | "ACOS" => {
            let end = 1.0 - 10_f64.powi(-(random.below(17) as i32)) * random.unit().abs();
            [
                pick(&[0.0, -0.0, 1.0, -1.0, 0.5, -0.5, random.unit(), end, -end], random),
                0.0,
                0.0,
                0.0,
            ]
        }
        "ON_CIRCLE" => {
            let (angle, radius) = (7.0 * random.unit(), 1.0 + 0.09 * random.unit());
            [radius * angle.cos(), radius * angle.sin(), 0.0, 0.0]
        }
        _ => {
            let same = any(random);
            [
                same,
                pick(&[same, -same, any(random), 0.0], random),
                any(random),
                pick(&[same, any(random)], random),
            ]
        }
    }
}

#[test]
fn functions_of_the_run_time_have_the_bits_of_c() {
    let tokens = || CRANK.parse().expect("these are tokens");
    let texts = st(tokens(), &[], None, false).expect("it is printed");
    let files = c(tokens(), &["position"], None).expect("it is printed");
    let mut project = Project::default();
    project.read(&texts[1].text);
    let machine = Machine { project: &project };
    let mut random = Random::new(7);
    let (mut given, mut told) = (Vec::new(), Vec::new());
    for nth in 0..60_000 {
        let (name, formal, _) = FUNCTIONS[nth % FUNCTIONS.len()];
        let is_narrow = nth / FUNCTIONS.len() % 2 == 1;
        let (ending, basic) = if is_narrow { ("_F32", Basic::Real) } else { ("", Basic::Lreal) };
        let mut numbers = operands(name, &mut random);
        if is_narrow {
            numbers = numbers.map(|x| f64::from(x as f32));
        }
        let unit = &project.units[&format!("LINKAGE_{name}{ending}")];
        let mut own = machine.fresh(unit);
        for (pin, number) in formal.iter().zip(numbers) {
            let (_, at, _) =
                unit.inputs.iter().find(|(known, ..)| known == pin).expect("it is a pin");
            own[*at] = Value::of(basic, number);
        }
        machine.run(unit, &mut own).unwrap_or_else(|why| panic!("{name}: {why} of {numbers:?}"));
        let handed: Vec<f64> = match &unit.in_outs[..] {
            [] => vec![own[0].number(), 0.0],
            pins => pins.iter().map(|(_, at, _)| own[*at].number()).collect(),
        };
        given.push((nth % FUNCTIONS.len(), is_narrow, numbers));
        told.push([handed[0], handed[1]]);
    }
    let Some(answers) = in_c(&files, &given) else {
        return skipped("structured text beside C: no cc");
    };
    for ((function, told), answer) in given.iter().zip(&told).zip(&answers) {
        let bits = |of: &[f64; 2]| of.map(f64::to_bits);
        assert_eq!(
            bits(told),
            bits(answer),
            "{} of {:?}: {told:?}, C {answer:?}",
            FUNCTIONS[function.0].0,
            function
        );
    }
}

fn in_c(files: &[File], given: &[(usize, bool, [f64; 4])]) -> Option<Vec<[f64; 2]>> {
    let folder = folder("functions");
    fs::create_dir_all(&folder).expect("a folder can be made");
    let mut cases = String::new();
    for (nth, (.., call)) in FUNCTIONS.iter().enumerate() {
        for (narrow, (real, ending)) in [("double", ""), ("float", "f")].into_iter().enumerate() {
            cases += &format!(
                "        case {}: {{\n            const {real} a = ({real})n[1], b = ({real})n[2], c = ({real})n[3], d = ({real})n[4];\n\
                 \x20           {real} told = 0, more = 0;\n            (void)b; (void)c; (void)d;\n            {};\n\
                 \x20           out[0] = told; out[1] = more;\n            break; }}\n",
                2 * nth + narrow,
                call.replace('@', ending)
            );
        }
    }
    let caller = format!(
        "#include \"linkage_run.h\"\n#include <stdio.h>\n\nint main(void)\n{{\n    double n[5], out[2];\n\
         \x20   while (fread(n, sizeof(double), 5, stdin) == 5) {{\n        switch ((int)n[0]) {{\n{cases}        }}\n\
         \x20       fwrite(out, sizeof(double), 2, stdout);\n    }}\n    return 0;\n}}\n"
    );
    let write =
        |name: &str, text: &[u8]| fs::write(folder.join(name), text).expect("it can be written");
    files.iter().for_each(|file| write(&file.name, file.text.as_bytes()));
    write("calls.c", caller.as_bytes());
    let flags =
        ["-std=c99", "-O0", "-ffp-contract=off", "-o", "calls", "calls.c", "linkage_run.c", "-lm"];
    let output = Command::new("cc").args(flags).current_dir(&folder).output().ok()?;
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let numbers = given.iter().flat_map(|(function, is_narrow, numbers)| {
        let case = (2 * function + usize::from(*is_narrow)) as f64;
        std::iter::once(case).chain(*numbers).flat_map(f64::to_ne_bytes)
    });
    write("given", &numbers.collect::<Vec<u8>>());
    let input = fs::File::open(folder.join("given")).expect("it is there");
    let output = Command::new(folder.join("calls")).stdin(input).output().expect("it starts");
    let numbers =
        output.stdout.chunks_exact(8).map(|of| f64::from_ne_bytes(of.try_into().unwrap()));
    let numbers: Vec<f64> = numbers.collect();
    assert_eq!(numbers.len(), 2 * given.len());
    Some(numbers.chunks_exact(2).map(|of| [of[0], of[1]]).collect())
}
