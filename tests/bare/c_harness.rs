//! The program in C that calls two functions of each name, written from the prototypes in the headers.

use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Random numbers, and the comparison of two answers.
const HARNESS: &str = include_str!("printed_c.c");

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

/// A number that is given: its place among the arguments, its type, its name, and whether it is a parameter.
struct Given {
    place: String,
    ty: String,
    name: String,
    is_parameter: bool,
}

impl Given {
    fn new(place: String, ty: &str, name: &str, is_parameter: bool) -> Self {
        Self { place, ty: ty.to_string(), name: name.to_string(), is_parameter }
    }

    /// The number at random, after what its name says it is.
    fn drawn(&self) -> String {
        let kind = match &self.name[..] {
            _ if self.ty == "int32_t" => "(double)mode()",
            "cos" => "angle()",
            "sin" => "amplitude()",
            "swing" => "angle()",
            _ if self.is_parameter => return format!("changed((double){})", self.place),
            name if name.contains("_rate") || name.contains("_acceleration") => "rate()",
            "work" | "push" | "friction" | "brake" | "gas" => "effort()",
            name if name.contains("drive") => "effort()",
            "x" => "stroke()",
            "h" => "span()",
            "theta" | "psi" | "first" | "second" | "shoulder" => "angle()",
            _ => "length()",
        };
        kind.to_string()
    }

    /// The number as it is passed. A cosine and a sine are those of one angle, times an amplitude.
    fn passed(&self, at: usize) -> String {
        let value = match &self.name[..] {
            "cos" => format!("cos(g[{at}]) * g[{}]", at + 1),
            "sin" => format!("sin(g[{}]) * g[{at}]", at - 1),
            _ => format!("g[{at}]"),
        };
        format!("{} = ({})({value});", self.place, self.ty)
    }
}

/// What a function is called with: declarations, the numbers that are set, and the arguments.
#[derive(Default)]
struct Inputs {
    declared: String,
    given: Vec<Given>,
    passed: String,
}

impl Inputs {
    fn of(header: &str, stem: &str, function: &Function) -> Self {
        let suffix = if function.name.ends_with("_f32") { "_f32" } else { "" };
        let mut inputs = Self::default();
        for (ty, argument) in &function.arguments[..function.arguments.len() - 2] {
            let number = ty.trim_start_matches("const ").trim_end_matches('*').trim();
            let (declared, by) = match argument.split_once('[') {
                Some((name, count)) => {
                    let count: usize = count.trim_end_matches(']').parse().expect("a number");
                    let places = (0..count).map(|at| format!("{name}_[{at}]"));
                    inputs.given.extend(places.map(|at| Given::new(at, number, name, false)));
                    (format!("{name}_[{count}]"), "")
                }
                None if ty.starts_with("const ") => {
                    inputs.record(header, number, argument);
                    let value = match &argument[..] {
                        "mechanism" => format!("{stem}_default{suffix}()"),
                        _ => "{ 0 }".to_string(),
                    };
                    (format!("{argument}_ = {value}"), "&")
                }
                None => {
                    let place = format!("{argument}_");
                    inputs.given.push(Given::new(place.clone(), number, argument, false));
                    (place, "")
                }
            };
            let _ = writeln!(inputs.declared, "    {number} {declared};");
            let name = argument.split('[').next().expect("a name");
            let _ = write!(inputs.passed, "{by}{name}_, ");
        }
        inputs
    }

    /// The fields of a record that is given.
    fn record(&mut self, header: &str, record: &str, argument: &str) {
        let is_of_rates = argument == "rates" || argument == "accelerations";
        for (ty, field) in fields(header, record) {
            let name = match argument {
                _ if is_of_rates => "_rate",
                "loads" => "work",
                _ => field,
            };
            let place = format!("{argument}_.{field}");
            self.given.push(Given::new(place, ty, name, argument == "mechanism"));
        }
    }
}

/// The C functions that draw what a function is called with, and that call both functions of one name; and the row
/// of the table with them.
fn called(header: &str, stem: &str, function: &Function) -> (String, String) {
    let name = &function.name;
    let Inputs { declared, given, passed } = Inputs::of(header, stem, function);
    let (ty, to) = &function.arguments[function.arguments.len() - 2];
    let (to, dimensions) = to.split_at(to.find('[').unwrap_or(to.len()));
    let (record, by) =
        (ty.trim_end_matches('*').trim(), if dimensions.is_empty() { "&" } else { "" });
    let lines = |line: &dyn Fn((usize, &Given)) -> String| {
        given.iter().enumerate().map(line).collect::<String>()
    };
    let drawn = lines(&|(at, given)| format!("    g[{at}] = {};\n", given.drawn()));
    let set = lines(&|(at, given)| format!("    {}\n", given.passed(at)));
    let modes = lines(&|(_, given)| (if given.ty == "int32_t" { "m" } else { "n" }).to_string());
    let mechanism = declared.lines().find(|line| line.contains(" mechanism_ = "));
    let parameters =
        mechanism.map_or(String::new(), |line| format!("{line}\n    (void)mechanism_;\n"));
    let is_single = u8::from(name.ends_with("_f32"));
    let code = format!(
        "static void draw_{name}(double *g)\n{{\n{parameters}{drawn}}}\n\n\
         static void call_{name}(const double *g)\n{{\n    {record} {to}_a{dimensions}, {to}_b{dimensions};\n    \
         LinkageError a, b;\n    LinkageStatus status;\n{declared}{set}    \
         a = b = untold;\n    \
         memset(&{to}_a, 0xa5, sizeof {to}_a);\n    \
         memset(&{to}_b, 0xa5, sizeof {to}_b);\n    status = {name}({passed}{by}{to}_a, &a);\n    \
         compare(status, printed_{name}({passed}{by}{to}_b, &b), &{to}_a, &{to}_b, sizeof {to}_a, {is_single}, &a, &b);\n}}\n\n"
    );
    let row =
        format!("    {{ \"{name}\", \"{modes}\", {is_single}, draw_{name}, call_{name} }},\n");
    (code, row)
}

/// The headers of all mechanisms, by the beginning of their functions' names.
pub(crate) fn headers(folder: &Path) -> Vec<(String, String)> {
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

/// Writes the program, `harness.c`, and the new names of the printed functions, `renamed.txt`.
pub(crate) fn write(folder: &Path) {
    let (mut renamed, mut calls, mut table) = (String::new(), String::new(), String::new());
    let headers = headers(folder);
    let includes: String =
        headers.iter().map(|(stem, _)| format!("#include \"{stem}.h\"\n")).collect();
    for (stem, header) in &headers {
        for function in functions(header) {
            let name = &function.name;
            let _ = writeln!(renamed, "#define {name} printed_{name}");
            let prototype = header.lines().find(|line| line.contains(&format!(" {name}(")));
            let prototype = prototype
                .expect("it stands there")
                .replace(&format!(" {name}("), &format!(" printed_{name}("));
            let (code, row) = called(header, stem, &function);
            let _ = writeln!(calls, "{prototype}\n{code}");
            table += &row;
        }
        for suffix in ["", "_f32"]
            .iter()
            .filter(|suffix| header.contains(&format!(" {stem}_default{suffix}(")))
        {
            let _ =
                writeln!(renamed, "#define {stem}_default{suffix} printed_{stem}_default{suffix}");
        }
    }
    fs::write(folder.join("renamed.txt"), renamed).expect("the tests' directory can be written");
    let (before, after) = HARNESS.split_once("/* FUNCTIONS */\n").expect("their place is there");
    let functions = format!("{calls}static const Function ALL[] = {{\n{table}}};\n");
    let (includes_place, before) = before.split_once("/* HEADERS */\n").expect("theirs too");
    let program = [includes_place, &includes, before, &functions, after].concat();
    fs::write(folder.join("harness.c"), program).expect("it can be written");
}
