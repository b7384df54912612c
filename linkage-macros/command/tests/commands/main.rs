//! The program as it is called.

mod told;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

const SHEAR: &str = "\
use linkage_core::mechanism;

mechanism! {
    /// A flying shear.
    pub struct FlyingShear {
        input theta: angle;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
        output C, BC;
    }
}

fn main() {}

mod second {
    linkage_core::mechanism! {
        struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2, angle: t } }
    }
}
";

fn linkage(arguments: &[&str], folder: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.args(arguments).current_dir(folder).output().expect("the program starts")
}

/// A folder of its own with these files.
fn folder(name: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    for (name, text) in files {
        fs::write(folder.join(name), text).expect("a file can be written");
    }
    folder
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn the_exit_status_tells_a_mistake_from_a_file_that_is_none() {
    let mistaken = SHEAR.replace("80mm", "80kg");
    let open = SHEAR.replace("(665.7mm, 0)", "(665.7mm, 0");
    let folder = folder(
        "status",
        &[
            ("shear.rs", SHEAR),
            ("mistaken.rs", &mistaken),
            ("empty.rs", "fn main() {}"),
            ("no.rs", "("),
            ("open.rs", &open),
        ],
    );
    for (arguments, status, words) in [
        (&["check", "shear.rs"][..], 0, ""),
        (&["check", "shear.rs", "mistaken.rs"], 1, " --> mistaken.rs:8:36"),
        (&["check", "mistaken.rs", "none.rs"], 2, "`none.rs`: "),
        (&["check", "empty.rs"], 2, "holds no `mechanism! { … }`"),
        (&["check", "no.rs"], 2, "no.rs:1:1: this is not a Rust program: `(` is not closed"),
        (&["check", "open.rs"], 2, "open.rs:7:26: this is not a Rust program: `(` is not closed"),
        (&["check", "none.rs"], 2, "`none.rs`: "),
        (&["check"], 2, "<FILE>"),
        (&["chekc", "shear.rs"], 2, "'check'"),
        (&["export", "rust", "mistaken.rs"], 1, "mistaken.rs:8"),
        (&["export", "c", "mistaken.rs", "-o", "out"], 1, "mistaken.rs:8"),
        (&["export", "c", "shear.rs", "-o", "out", "--only", "motoin"], 1, "there are position, "),
        (&["exprot", "c", "shear.rs"], 2, "'export'"),
        (&["fmu", "shear.rs"], 2, "'export fmu'"),
        (&["c", "shear.rs"], 2, "'export c'"),
        (&["solve", "shear.rs"], 2, "'check', "),
        (&["export", "fmuu", "shear.rs"], 2, "'fmu'"),
        (&["export", "c", "shear.rs", "--kinematic"], 2, "`--kinematic` belongs to `export fmu`"),
        (&["export", "rust", "shear.rs", "--only", "f32"], 2, "`--only` belongs to `export c`"),
        (&["export", "rust", "shear.rs", "--stale"], 2, "name it by `-o PATH`"),
        (&["export", "fmu", "shear.rs"], 2, "choose it by `--machine NAME`"),
        (&["check", "shear.rs", "--machine", "Crnk"], 2, "there are FlyingShear, Crank"),
        (&["check", "shear.rs", "-o", "out"], 2, "'-o'"),
        (&["export", "c", "shear.rs", "--json"], 2, "'--json'"),
    ] {
        let output = linkage(arguments, &folder);
        let errors = text(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {errors}");
        assert!(errors.contains(words), "{arguments:?}: {errors}");
        assert!(status != 0 || errors.is_empty(), "{errors}");
        assert!(status == 0 || output.stdout.is_empty(), "{arguments:?}");
    }
    assert!(!folder.join("out").exists(), "a file with a mistake is not printed");
}

#[test]
fn every_mechanism_of_a_file_is_printed() {
    let folder = folder("printed", &[("shear.rs", SHEAR)]);
    let output = linkage(&["export", "c", "shear.rs", "-o", "out/c"], &folder);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let mut names: Vec<String> = fs::read_dir(folder.join("out/c"))
        .expect("it was made")
        .map(|entry| entry.expect("it can be read").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    let expected = [
        "crank.c",
        "crank.h",
        "flying_shear.c",
        "flying_shear.h",
        "linkage_run.c",
        "linkage_run.h",
    ];
    assert_eq!(names, expected);
    assert_eq!(text(&output.stdout).lines().count(), expected.len());
}

#[test]
fn only_what_is_asked_for_is_printed() {
    let folder = folder("only", &[("shear.rs", SHEAR)]);
    let functions = |only: &str| {
        let output = linkage(&["export", "c", "shear.rs", "-o", "out", "--only", only], &folder);
        assert!(output.status.success(), "{}", text(&output.stderr));
        let header = fs::read_to_string(folder.join("out/flying_shear.h")).expect("it was written");
        let lines =
            header.lines().filter_map(|line| line.strip_prefix("LinkageStatus flying_shear_"));
        let names = lines.map(|line| line.split('(').next().unwrap_or_default().to_string());
        names.collect::<BTreeSet<_>>()
    };
    let functions = |only: &str| Vec::from_iter(functions(only));
    assert_eq!(functions("motion_at,f32"), ["motion_at_f32"]);
    // The angle's cosine and sine come first.
    assert_eq!(functions("position,f64"), ["position", "position_at"]);
    assert_eq!(functions("coefficients,f64"), ["coefficients", "velocity", "velocity_at"]);
    assert_eq!(functions("f32").len(), functions("f64").len());
}

#[test]
fn an_expansion_is_rust() {
    let folder = folder("expanded", &[("shear.rs", SHEAR)]);
    let output = linkage(&["export", "rust", "shear.rs"], &folder);
    assert!(output.status.success());
    let code = text(&output.stdout);
    let file = syn::parse_file(&code).expect("it is Rust");
    assert!(
        !file.items.is_empty()
            && code.contains("struct FlyingShear")
            && code.contains("struct Crank")
    );
}

#[test]
fn help_teaches_by_examples() {
    let folder = folder("help", &[]);
    let help = text(&linkage(&["--help"], &folder).stdout);
    for words in ["linkage check shear.rs", "linkage export c shear.rs -o control/", "export"] {
        assert!(help.contains(words), "{words}: {help}");
    }
    assert!(text(&linkage(&["export", "--help"], &folder).stdout).contains("--only motion_at,f32"));
}

#[test]
fn a_reader_may_see_enough() {
    let folder = folder("enough", &[("shear.rs", SHEAR)]);
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.args(["export", "rust", "shear.rs"]).current_dir(&folder);
    let mut child = command.stdout(Stdio::piped()).spawn().expect("the program starts");
    drop(child.stdout.take());
    assert!(child.wait().expect("it ends").success());
}

/// A declaration without the macro around it, with docs and without.
#[test]
fn a_file_may_hold_a_declaration_alone() {
    let crank =
        "struct Crank { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2, angle: t } }";
    let folder = folder(
        "alone",
        &[
            ("crank.mech", crank),
            ("docs.mech", &format!("// A comment.\n\n/// A crank.\npub(crate) {crank}\n")),
            ("mistaken.mech", &crank.replace("length: 2", "length: 2kg")),
            ("more.rs", &format!("{crank} fn main() {{}}")),
        ],
    );
    for (file, status, words) in [
        ("crank.mech", 0, ""),
        ("docs.mech", 0, ""),
        ("mistaken.mech", 1, " --> mistaken.mech:1:75"),
        ("more.rs", 2, "is not what stands between its braces"),
    ] {
        let output = linkage(&["check", file], &folder);
        let errors = text(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{file}: {errors}");
        assert!(errors.contains(words), "{file}: {errors}");
    }
    let output = linkage(&["export", "c", "docs.mech"], &folder);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(folder.join("crank.h").exists(), "C goes beside the source");
}

#[test]
fn one_mechanism_of_several_is_chosen() {
    let folder = folder("chosen", &[("shear.rs", SHEAR)]);
    let output = linkage(&["export", "c", "shear.rs", "--machine", "Crank", "-o", "out"], &folder);
    let written = text(&output.stdout);
    assert!(written.contains("crank.c") && !written.contains("flying_shear"), "{written}");
    let output = linkage(&["export", "rust", "shear.rs", "--machine", "Crank"], &folder);
    let code = text(&output.stdout);
    assert!(code.contains("struct Crank") && !code.contains("FlyingShear"));
}

/// Each format is written, is fresh, and is stale when the declaration changes or a file is lost.
#[test]
fn what_is_stale_is_told_and_left_alone() {
    let folder = folder("stale", &[("shear.rs", SHEAR)]);
    let formats: [(&[&str], &str); 3] = [
        (&["export", "c", "shear.rs", "-o", "out"], "out/crank.c"),
        (&["export", "rust", "shear.rs", "-o", "shear_solver.rs"], "shear_solver.rs"),
        (&["export", "fmu", "shear.rs", "--machine", "Crank", "-o", "crank.fmu"], "crank.fmu"),
    ];
    let compared = |arguments: &[&str]| {
        let output = linkage(&[arguments, &["--stale"]].concat(), &folder);
        assert!(output.stdout.is_empty());
        (output.status.code(), text(&output.stderr))
    };
    for (arguments, file) in formats {
        let (status, errors) = compared(arguments);
        assert_eq!(status, Some(1));
        assert!(errors.contains(&format!("`{file}` is stale: it is not there")), "{errors}");
        assert!(!folder.join(file).exists());
        assert!(linkage(arguments, &folder).status.success());
        assert_eq!(compared(arguments), (Some(0), String::new()), "{arguments:?}");
    }
    let changed = SHEAR.replace("length: 2,", "length: 3,");
    fs::write(folder.join("shear.rs"), changed).expect("a file can be written");
    for (arguments, file) in formats {
        let before = fs::read(folder.join(file)).expect("it was written");
        let (status, errors) = compared(arguments);
        assert_eq!(status, Some(1));
        // The header holds the declaration's hash.
        let files = [file.to_string(), file.replace("crank.c", "crank.h")];
        let told: BTreeSet<_> = errors.lines().map(str::to_string).collect();
        let stale = |file| format!("error: `{file}` is stale: it is not what would be written");
        assert_eq!(told, BTreeSet::from(files.map(stale)));
        assert_eq!(fs::read(folder.join(file)).expect("it stands there"), before);
    }
}

/// A machine that is imported into a file, which the program then reads.
#[test]
fn an_imported_machine_is_a_file_like_another() {
    let bar = "M[J[R, P[0, 0], L[ground, bar]], J[R, P[1, 0], L[bar]]]";
    let folder = folder("imported", &[("bar.txt", bar)]);
    let import = |more: &[&str]| {
        let arguments = ["import", "bar.txt", "--drive", "0,1", "-o", "bar.rs"];
        let output = linkage(&[&arguments[..], more].concat(), &folder);
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    };
    assert_eq!(import(&["--stale"]).0, Some(1));
    assert_eq!(import(&[]), (Some(0), "bar.rs\n".to_string(), String::new()));
    assert_eq!(import(&["--stale"]), (Some(0), String::new(), String::new()));
    assert_eq!(import(&["--stale", "--unit", "cm"]).0, Some(1));
    assert_eq!(linkage(&["check", "bar.rs"], &folder).status.code(), Some(0));
    for (arguments, status) in [(["import", "none.txt"], 2), (["import", "bar.rs"], 1)] {
        assert_eq!(linkage(&arguments, &folder).status.code(), Some(status), "{arguments:?}");
    }
}
