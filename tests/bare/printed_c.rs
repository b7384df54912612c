//! The C that `linkage c` prints beside the library of `export c;`: each function of both is called with the same
//! random numbers, and answers with the same bytes, status and error.
//!
//! A program in C calls them: it is written here, from the prototypes in the headers. `LINKAGE_CALLS` says how
//! often each function is called; without it, 20 000 times.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::build::{directory, library, sources, text};

/// Random numbers, and the comparison of two answers.
const HARNESS: &str = include_str!("printed_c.c");

/// A folder with the printed C of all mechanisms that C is printed of.
fn printed() -> PathBuf {
    let folder = directory().join("printed");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("the tests' directory can be written");
    let source = sources().join("mechanisms.rs");
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--offline", "-p", "linkage-command", "--", "c"])
        .arg(&source)
        .arg("-o")
        .arg(&folder)
        .current_dir(sources())
        .output()
        .expect("Cargo starts");
    assert!(output.status.success(), "{}", text(&output.stderr));
    folder
}

/// A function of a header: its name, and the type and the name of each argument.
struct Function {
    name: String,
    arguments: Vec<(String, String)>,
}

/// The functions that return a status.
fn functions(header: &str) -> Vec<Function> {
    let prototypes = header.lines().filter_map(|line| line.strip_prefix("LinkageStatus "));
    let parsed = prototypes.map(|line| {
        let (name, arguments) = line.split_once('(').expect("arguments stand in parentheses");
        let arguments = arguments.trim_end_matches(");").split(", ").map(|argument| {
            let at = argument.rfind([' ', '*']).expect("a type stands before a name") + 1;
            (argument[..at].trim().to_string(), argument[at..].to_string())
        });
        Function { name: name.to_string(), arguments: arguments.collect() }
    });
    parsed.collect()
}

/// The types and names of a record's fields.
fn fields<'a>(header: &'a str, record: &str) -> Vec<(&'a str, &'a str)> {
    let start = format!("typedef struct {record} {{\n");
    let (_, rest) = header.split_once(&start).unwrap_or_else(|| panic!("no {record}"));
    let (body, _) = rest.split_once('}').expect("it ends");
    let lines = body.lines().map(str::trim).filter(|line| line.ends_with(';'));
    lines
        .map(|line| line.trim_end_matches(';').split_once(' ').expect("a type and a name"))
        .collect()
}

/// The line that sets a number, after what its name says it is.
fn set(place: &str, name: &str, ty: &str) -> String {
    let kind = match name {
        _ if ty == "int32_t" => return format!("{place} = mode();"),
        "cos" => "cos(angle_) * amplitude_",
        "sin" => "sin(angle_) * amplitude_",
        _ if name.contains("_rate") || name.contains("_acceleration") => "rate()",
        "x" => "stroke()",
        "h" => "span()",
        "theta" | "psi" | "first" | "second" | "swing" => "angle()",
        _ => "length()",
    };
    format!("{place} = ({ty})({kind});")
}

/// The C function that calls both functions of one name once.
fn called(header: &str, stem: &str, function: &Function) -> String {
    let name = &function.name;
    let suffix = if name.ends_with("_f32") { "_f32" } else { "" };
    let (inputs, answer) = function.arguments.split_at(function.arguments.len() - 2);
    let (mut lines, mut passed) = (String::new(), Vec::new());
    for (ty, argument) in inputs {
        let record = ty.trim_start_matches("const ").trim_end_matches('*').trim();
        let is_list = argument.ends_with(']');
        match ty.starts_with("const ") {
            true if is_list => {
                let (name, count) = argument.split_once('[').expect("a length");
                let count: usize = count.trim_end_matches(']').parse().expect("a number");
                let _ = writeln!(lines, "    {record} {name}_[{count}];");
                for at in 0..count {
                    let _ = writeln!(
                        lines,
                        "    {}",
                        set(&format!("{name}_[{at}]"), "drive_rate", record)
                    );
                }
                passed.push(format!("{name}_"));
            }
            true => {
                let (rates, _) = (argument == "rates" || argument == "accelerations", ());
                let default = format!("{stem}_default{suffix}()");
                let start = if argument == "mechanism" { default } else { "{ 0 }".to_string() };
                let _ = writeln!(lines, "    {record} {argument}_ = {start};");
                for (ty, field) in fields(header, record) {
                    let kind = if rates { "x_rate" } else { field };
                    let place = format!("{argument}_.{field}");
                    let line = match argument == "mechanism" && ty != "int32_t" && field != "swing"
                    {
                        true => format!("{place} = ({ty})changed({place});"),
                        false => set(&place, kind, ty),
                    };
                    let _ = writeln!(lines, "    {line}");
                }
                passed.push(format!("&{argument}_"));
            }
            false => {
                let _ = writeln!(
                    lines,
                    "    {ty} {argument}_;\n    {}",
                    set(&format!("{argument}_"), argument, ty)
                );
                passed.push(format!("{argument}_"));
            }
        }
    }
    let (ty, to) = &answer[0];
    let (to, dimensions) = to.split_at(to.find('[').unwrap_or(to.len()));
    let (record, by) =
        (ty.trim_end_matches('*').trim(), if dimensions.is_empty() { "&" } else { "" });
    let passed: String = passed.iter().map(|argument| format!("{argument}, ")).collect();
    format!(
        "static void call_{name}(void)\n{{\n    {record} {to}_a{dimensions}, {to}_b{dimensions};\n    \
         LinkageError a, b;\n    double angle_ = angle(), amplitude_ = amplitude();\n    LinkageStatus status;\n{lines}    \
         (void)angle_;\n    (void)amplitude_;\n    memset(&{to}_a, 0xa5, sizeof {to}_a);\n    \
         memset(&{to}_b, 0xa5, sizeof {to}_b);\n    status = {name}({passed}{by}{to}_a, &a);\n    \
         compare(status, printed_{name}({passed}{by}{to}_b, &b), &{to}_a, &{to}_b, sizeof {to}_a, &a, &b);\n}}\n\n"
    )
}

/// The headers of all mechanisms, by the beginning of their functions' names.
fn headers(folder: &Path) -> Vec<(String, String)> {
    let mut found: Vec<_> = fs::read_dir(folder)
        .expect("it was made")
        .map(|entry| entry.expect("it can be read").path())
        .filter(|path| {
            path.extension().is_some_and(|ending| ending == "h") && !path.ends_with("linkage_run.h")
        })
        .map(|path| {
            let stem = path.file_stem().expect("a name").to_string_lossy().into_owned();
            (stem, fs::read_to_string(path).expect("it can be read"))
        })
        .collect();
    found.sort();
    found
}

/// Writes the program, and the new names of the printed functions.
fn write_harness(folder: &Path) {
    let (mut renamed, mut program) = (String::new(), String::from(HARNESS));
    let (mut calls, mut table) = (String::new(), String::new());
    for (stem, header) in headers(folder) {
        let _ = writeln!(program, "#include \"{stem}.h\"");
        for function in functions(&header) {
            let name = &function.name;
            let _ = writeln!(renamed, "#define {name} printed_{name}");
            let prototype = header.lines().find(|line| line.contains(&format!(" {name}(")));
            let prototype = prototype
                .expect("it stands there")
                .replace(&format!(" {name}("), &format!(" printed_{name}("));
            let _ = writeln!(calls, "{prototype}");
            calls += &called(&header, &stem, &function);
            let _ = writeln!(table, "    {{ \"{name}\", call_{name} }},");
        }
        for suffix in ["", "_f32"]
            .iter()
            .filter(|suffix| header.contains(&format!(" {stem}_default{suffix}(")))
        {
            let _ =
                writeln!(renamed, "#define {stem}_default{suffix} printed_{stem}_default{suffix}");
        }
    }
    let end = format!(
        "static const struct {{ const char *name; void (*call)(void); }} ALL[] = {{\n{table}}};\n\n\
         int main(int count, char **arguments)\n{{\n    \
         return compare_all(count > 1 ? atol(arguments[1]) : 1);\n}}\n\n\
         static int compare_all(long calls)\n{{\n    size_t at;\n    long i;\n    int is_equal = 1;\n    \
         for (at = 0; at < sizeof ALL / sizeof ALL[0]; at++) {{\n        begin();\n        \
         for (i = 0; i < calls; i++) {{ ALL[at].call(); }}\n        is_equal &= report(ALL[at].name);\n    }}\n    \
         return is_equal ? 0 : 1;\n}}\n"
    );
    fs::write(folder.join("renamed.txt"), renamed).expect("the tests' directory can be written");
    fs::write(folder.join("harness.c"), format!("{program}\n{calls}{end}"))
        .expect("it can be written");
}

/// Compiles and runs the program, the printed C with these flags.
fn compared(folder: &Path, library: &Path, flags: &[&str]) -> String {
    let printed = headers(folder).into_iter().map(|(stem, _)| format!("{stem}.c"));
    let mut objects = vec!["linkage_run.c".to_string(), "linkage_root.c".to_string()];
    objects.extend(printed);
    let mut names = Vec::new();
    for source in objects {
        let object = source.replace(".c", ".o");
        let output = Command::new("gcc")
            .args(flags)
            .args([
                "-O2",
                "-Wall",
                "-Wextra",
                "-Werror",
                "-include",
                "renamed.txt",
                "-c",
                &source,
                "-o",
                &object,
            ])
            .current_dir(folder)
            .output()
            .expect("gcc starts");
        assert!(output.status.success(), "{}", text(&output.stderr));
        names.push(object);
    }
    let output = Command::new("gcc")
        .args(["-std=c99", "-O1", "-D_GNU_SOURCE", "harness.c"])
        .args(&names)
        .arg(library)
        .args(["-Wl,--gc-sections", "-lm", "-o", "harness"])
        .current_dir(folder)
        .output()
        .expect("gcc starts");
    assert!(output.status.success(), "{}", text(&output.stderr));
    let calls = std::env::var("LINKAGE_CALLS").unwrap_or_else(|_| "20000".to_string());
    let output = Command::new(folder.join("harness")).arg(calls).output().expect("it starts");
    let report = text(&output.stdout);
    assert!(output.status.success(), "{report}");
    report
}

#[test]
#[ignore = "a release build of all solvers: `.ci/run` makes it"]
fn printed_c_is_the_library() {
    let library = library("", "3").unwrap_or_else(|error| panic!("{error}"));
    let folder = printed();
    write_harness(&folder);
    let report = compared(&folder, &library, &["-std=c99"]);
    // Every function answers and refuses, each often enough to mean something.
    for line in report.lines() {
        let numbers: Vec<u64> =
            line.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        let [answered, refused] = numbers[..] else { panic!("{line}") };
        assert!(answered > 100 && refused > 50, "{line}");
    }
    assert!(report.lines().count() > 150, "{report}");
    println!("{report}");
    // Products that a compiler may contract into sums, where the instruction is there and the run-time is told that
    // it is not: whatever were contracted would show.
    if cfg!(target_arch = "x86_64") && std::is_x86_feature_detected!("fma") {
        let hidden = ["-U__FMA__", "-U__FP_FAST_FMA", "-U__FP_FAST_FMAF"];
        compared(&folder, &library, &[&["-std=gnu17", "-march=x86-64-v3"], &hidden[..]].concat());
    }
}
