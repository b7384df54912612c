//! The functions of printed C beside the blocks of printed structured text, in the order of both.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use linkage_compiler::File;

use super::reader::{Basic, Unit};

/// A call: the number of a function, and what it is given.
pub(crate) type Call = (usize, Vec<f64>);

/// True where the fast path of C answers, and its numbers; of the slow path nothing is compared.
#[derive(Clone, Debug)]
pub(crate) struct Answer {
    pub is_fast: bool,
    pub numbers: Vec<f64>,
}

/// The answers of the functions that belong to these blocks; none where there is no compiler.
pub(crate) fn answers(
    folder: &Path,
    files: &[File],
    blocks: &[&Unit],
    calls: &[Call],
) -> Option<Vec<Answer>> {
    fs::create_dir_all(folder).expect("a folder can be made");
    let write =
        |name: &str, text: &str| fs::write(folder.join(name), text).expect("it can be written");
    files.iter().for_each(|file| write(&file.name, &file.text));
    write("calls.c", &caller(&files[0], blocks));
    // The slow path begins with `linkage_why`.
    let flags = ["-std=c99", "-O0", "-ffp-contract=off", "-Wl,--wrap=linkage_why", "-o", "calls"];
    let sources = files.iter().map(|file| &file.name[..]).filter(|name| name.ends_with(".c"));
    let sources = sources.chain(["calls.c", "-lm"]);
    let output = Command::new("cc").args(flags).args(sources).current_dir(folder).output().ok()?;
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let given: Vec<u8> = calls
        .iter()
        .flat_map(|(function, given)| {
            std::iter::once(*function as f64).chain(given.iter().copied())
        })
        .flat_map(f64::to_ne_bytes)
        .collect();
    fs::write(folder.join("given"), given).expect("it can be written");
    let input = fs::File::open(folder.join("given")).expect("it is there");
    let mut command = Command::new(folder.join("calls"));
    let output = command.stdin(Stdio::from(input)).output().expect("it starts");
    assert!(output.status.success());
    let mut numbers =
        output.stdout.chunks_exact(8).map(|bytes| f64::from_ne_bytes(bytes.try_into().unwrap()));
    let answers = calls.iter().map(|(function, _)| {
        let is_fast = numbers.next().expect("a call is answered") == 1.0;
        Answer { is_fast, numbers: numbers.by_ref().take(answer(blocks[*function]).1).collect() }
    });
    Some(answers.collect())
}

/// The place and the count of a block's results, which stand behind its status and what is refused.
pub(crate) fn answer(block: &Unit) -> (usize, usize) {
    let (_, at, count) = block.outputs[2];
    (at, count)
}

fn caller(header: &File, blocks: &[&Unit]) -> String {
    let mut functions = prototypes(&header.text);
    functions.retain(|(name, _)| !name.ends_with("_default") && !name.ends_with("_default_f32"));
    assert_eq!(functions.len(), blocks.len());
    let mut text = format!(
        "#include \"{}\"\n#include \"linkage_run.h\"\n#include <stdio.h>\n\nstatic int is_slow;\n\
         LinkageWhy __real_linkage_why(int is_single);\n\
         LinkageWhy __wrap_linkage_why(int is_single)\n{{\n    is_slow = 1;\n    return __real_linkage_why(is_single);\n}}\n",
        header.name
    );
    let mut cases = String::new();
    for (nth, ((name, parameters), block)) in functions.iter().zip(blocks).enumerate() {
        text += &function(nth, name, parameters, block);
        let given: usize = block.inputs.iter().map(|(_, _, count)| count).sum();
        cases += &format!(
            "        case {nth}:\n            if (fread(given, sizeof(double), {given}, stdin) != {given}) {{ return 1; }}\n\
             \x20           told[0] = call{nth}(given, told + 1);\n            count = {};\n            break;\n",
            answer(block).1
        );
    }
    text + &format!(
        "\nint main(void)\n{{\n    static double given[4096], told[4096];\n    double function;\n    size_t count;\n\
         \x20   while (fread(&function, sizeof function, 1, stdin) == 1) {{\n        switch ((int)function) {{\n{cases}\
         \x20       default:\n            return 1;\n        }}\n        fwrite(told, sizeof(double), count + 1, stdout);\n    }}\n    return 0;\n}}\n"
    )
}

/// The functions that a header declares for a mechanism, with their parameters.
fn prototypes(header: &str) -> Vec<(String, Vec<String>)> {
    let parts = header.split("\nLinkageStatus ").skip(1);
    let of = |part: &str| {
        let (name, rest) = part.split_once('(')?;
        let (parameters, _) = rest.split_once(");")?;
        Some((name.to_string(), parameters.split(", ").map(str::to_string).collect()))
    };
    parts.filter_map(of).collect()
}

fn function(nth: usize, name: &str, parameters: &[String], block: &Unit) -> String {
    let (at, count) = answer(block);
    let real = if block.fields[at].basic == Basic::Real { "float" } else { "double" };
    let (mut lines, mut passed, mut next) = (String::new(), Vec::new(), 0);
    let [given @ .., result, _] = parameters else { panic!("{name} has no result") };
    assert_eq!(given.len(), block.inputs.len(), "{name}");
    for (argument, (parameter, (_, first, count))) in given.iter().zip(&block.inputs).enumerate() {
        let values = block.fields[*first..first + count].iter().enumerate().map(|(of, field)| {
            let ty = if field.basic == Basic::Int { "int32_t" } else { real };
            format!("({ty})in[{}]", next + of)
        });
        let values = values.collect::<Vec<_>>().join(", ");
        next += count;
        let (ty, _) = parameter.rsplit_once([' ', '*']).expect("a parameter has a type");
        let ty = ty.trim_start_matches("const ").trim();
        match () {
            () if parameter.contains('*') => {
                lines += &format!("    const {ty} a{argument} = {{ {values} }};\n");
                passed.push(format!("&a{argument}"));
            }
            () if parameter.contains('[') => {
                lines += &format!("    const {real} a{argument}[] = {{ {values} }};\n");
                passed.push(format!("a{argument}"));
            }
            () => passed.push(values),
        }
    }
    let (declared, pointer) = match result.split_once('*') {
        Some((ty, _)) => (format!("{}result", ty), "&result"),
        None => {
            let (_, dimensions) = result.split_once('[').expect("a list");
            (format!("{real} result[{dimensions}"), "result")
        }
    };
    format!(
        "\nstatic int call{nth}(const double *in, double *out)\n{{\n{lines}    {declared};\n    int at, status;\n\
         \x20   char fits[sizeof result == {count} * sizeof({real}) ? 1 : -1];\n    (void)fits;\n    (void)in;\n\
         \x20   memset(&result, 0, sizeof result);\n    is_slow = 0;\n    status = {name}({}{}{pointer}, NULL);\n\
         \x20   for (at = 0; at < {count}; at++) {{\n        out[at] = ((const {real} *)&result)[at];\n    }}\n\
         \x20   return status == LINKAGE_OK && !is_slow;\n}}\n",
        passed.join(", "),
        if passed.is_empty() { "" } else { ", " },
    )
}
