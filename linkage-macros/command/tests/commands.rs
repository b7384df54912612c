//! The program as it is called.

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

/// Every file whose mistakes the compiler reports inside rustc, with the messages that rustc shows. Some have
/// mistakes of another kind: calls that do not fit, and what is not even Rust. Of a path in a statement, rustc
/// underlines the first token alone, and of a whole call only rustc knows the place.
#[test]
fn messages_are_those_of_rustc() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../linkage-core");
    let mut files = Vec::new();
    for room in fs::read_dir(root.join("tests/ui")).expect("the folder is there") {
        let room = room.expect("it can be read").path();
        if room.is_dir() && !room.ends_with("calls") {
            let entries = fs::read_dir(&room).expect("it can be read");
            files.extend(entries.map(|entry| entry.expect("it can be read").path()));
        }
    }
    files.retain(|file| {
        file.extension().is_some_and(|extension| extension == "stderr")
            && !file.ends_with("outputs/crate_given_twice.stderr")
    });
    files.sort();
    let is_of_rustc = |text: &str| {
        text.contains("error[")
            || text.contains("unknown start of token")
            || text.contains("prefix `")
            || text.contains("originates in the macro")
    };
    let (mut names, mut expected) = (Vec::new(), Vec::new());
    for file in files {
        let messages = fs::read_to_string(&file).expect("it can be read");
        if is_of_rustc(&messages) {
            continue;
        }
        let source = file.with_extension("rs");
        names.push(source.strip_prefix(&root).expect("it stands there").display().to_string());
        expected.push(messages.trim().to_string());
    }
    assert!(names.len() > 60);
    let mut arguments = vec!["check"];
    arguments.extend(names.iter().map(String::as_str));
    let output = linkage(&arguments, &root);
    assert_eq!(output.status.code(), Some(1));
    let plain = |text: &str| {
        let lines = text.lines().map(str::trim_end).filter(|line| !line.is_empty());
        lines.map(str::to_string).collect::<Vec<_>>()
    };
    let (found, expected) = (plain(&text(&output.stderr)), plain(&expected.join("\n")));
    for (at, (found, expected)) in found.iter().zip(&expected).enumerate() {
        assert_eq!(found, expected, "line {at}");
    }
    assert_eq!(found.len(), expected.len());
}

#[test]
fn the_exit_status_tells_a_mistake_from_a_file_that_is_none() {
    let mistaken = SHEAR.replace("80mm", "80kg");
    let folder = folder(
        "status",
        &[
            ("shear.rs", SHEAR),
            ("mistaken.rs", &mistaken),
            ("empty.rs", "fn main() {}"),
            ("no.rs", "("),
        ],
    );
    for (arguments, status, words) in [
        (&["check", "shear.rs"][..], 0, ""),
        (&["check", "shear.rs", "mistaken.rs"], 1, " --> mistaken.rs:8:36"),
        (&["check", "empty.rs"], 2, "holds no `mechanism! { … }`"),
        (&["check", "no.rs"], 2, "no.rs:1:1: this is not a Rust program"),
        (&["check", "none.rs"], 2, "`none.rs`: "),
        (&["check"], 2, "<FILE>"),
        (&["chekc", "shear.rs"], 2, "'check'"),
        (&["expand", "mistaken.rs"], 1, "mistaken.rs:8"),
        (&["c", "mistaken.rs", "-o", "out"], 1, "mistaken.rs:8"),
        (&["c", "shear.rs", "-o", "out", "--only", "motoin"], 1, "there are position, "),
    ] {
        let output = linkage(arguments, &folder);
        let errors = text(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {errors}");
        assert!(errors.contains(words), "{arguments:?}: {errors}");
        assert!(status != 0 || errors.is_empty(), "{errors}");
    }
    assert!(!folder.join("out").exists(), "a file with a mistake is not printed");
}

#[test]
fn every_mechanism_of_a_file_is_printed() {
    let folder = folder("printed", &[("shear.rs", SHEAR)]);
    let output = linkage(&["c", "shear.rs", "-o", "out/c"], &folder);
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
        let output = linkage(&["c", "shear.rs", "-o", "out", "--only", only], &folder);
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
    let output = linkage(&["expand", "shear.rs"], &folder);
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
    for words in ["linkage check shear.rs", "linkage c shear.rs -o control/", "expand"] {
        assert!(help.contains(words), "{words}: {help}");
    }
    assert!(text(&linkage(&["c", "--help"], &folder).stdout).contains("--only motion_at,f32"));
}

#[test]
fn a_reader_may_see_enough() {
    let folder = folder("enough", &[("shear.rs", SHEAR)]);
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.args(["expand", "shear.rs"]).current_dir(&folder);
    let mut child = command.stdout(Stdio::piped()).spawn().expect("the program starts");
    drop(child.stdout.take());
    assert!(child.wait().expect("it ends").success());
}
