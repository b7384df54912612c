//! Mistakes and notes as the program tells them, and how they look.

#[path = "../../../../tests/skipped.rs"]
mod skipped;

use std::fs;
use std::path::Path;
use std::process::Command;

use super::{SHEAR, folder, linkage, text};

/// Each message by itself, without blank lines. All that a macro says beside a message stands above its place; here it is
/// help below the tokens.
fn with_help_below(messages: &str) -> Vec<String> {
    let mut found = Vec::new();
    for line in messages.lines().map(str::trim_end).filter(|line| !line.is_empty()) {
        if line.starts_with("error: ") || line.ends_with(" mistakes") {
            found.push((vec![line.to_string()], Vec::new(), 0));
            continue;
        }
        let (lines, above, margin) = found.last_mut().expect("a message begins with its level");
        match line.find("--> ") {
            Some(at) => *margin = at,
            None if *margin == 0 => {
                above.push(line.trim_start().to_string());
                continue;
            }
            None => {}
        }
        lines.push(line.to_string());
    }
    let message = |(mut lines, above, margin): (Vec<String>, Vec<String>, usize)| {
        let blank = " ".repeat(margin);
        for (at, line) in above.iter().enumerate() {
            match at {
                0 => lines.extend([format!("{blank} |"), format!("{blank} = help: {line}")]),
                _ => lines.push(format!("{blank}         {line}")),
            }
        }
        lines.join("\n")
    };
    found.into_iter().map(message).collect()
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
    let found = with_help_below(&text(&output.stderr));
    let expected = with_help_below(&expected.join("\n"));
    let (counts, found) = found.split_last().expect("there are messages");
    assert!(counts.ends_with(&format!(" mechanisms: {} mistakes", expected.len())), "{counts}");
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!(found, expected);
    }
    assert_eq!(found.len(), expected.len());
}

/// A declaration in one line, as a file that is written by a program may hold it.
const LONG: &str = "struct Long { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 2kg, angle: t } \
    point P on AB at (1m, 0); point Q on AB at (2m, 0); point R on AB at (3m, 0); point S on AB at (4m, 0); }";

#[test]
fn a_long_line_is_cut_around_its_tokens() {
    let folder = folder("long", &[("long.mech", LONG)]);
    for (columns, line, marks) in [
        (
            "64",
            "1 | ...ank AB(A) -> B { length: 2kg, angle: t } point P on AB...",
            "  |                             ^^^",
        ),
        ("300", &format!("1 | {LONG}")[..], &format!("  | {}^^^", " ".repeat(73))),
        // There is room for some of the line however narrow the terminal is.
        ("1", "1 | ...gth: 2kg, angl...", "  |         ^^^"),
    ] {
        let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
        command.args(["check", "long.mech"]).env("COLUMNS", columns).current_dir(&folder);
        let errors = text(&command.output().expect("the program starts").stderr);
        let lines: Vec<&str> = errors.lines().collect();
        assert_eq!(lines[3..5], [line, marks], "{errors}");
    }
}

/// A missing token behind the end of a line, a tab, and letters of several bytes.
#[test]
fn marks_stand_below_their_tokens() {
    let source = "struct Tab {\n\tinput θ: angle;\n\tground A(0, 0), Ä(1kg, 0);\n\tcrank AB(A) -> B { length: 2, angle: θ }\n\toutput B\n}";
    let folder = folder("tab", &[("tab.mech", source)]);
    let errors = text(&linkage(&["check", "tab.mech"], &folder).stderr);
    assert!(
        errors.contains("3 | \tground A(0, 0), Ä(1kg, 0);\n  | \t                  ^^^\n"),
        "{errors}"
    );
    assert!(errors.ends_with("\nTab: 2 mistakes\n"), "{errors}");
}

/// One line at the end, on standard output where all is well.
#[test]
fn a_line_counts_what_was_told() {
    let mistaken = SHEAR.replace("80mm", "80kg").replace("length: 2,", "length: 2kg,");
    let folder = folder("counts", &[("shear.rs", SHEAR), ("mistaken.rs", &mistaken)]);
    let told = |arguments: &[&str]| {
        let output = linkage(&[&["check"], arguments].concat(), &folder);
        let last = text(&output.stderr).lines().last().map(str::to_string);
        (text(&output.stdout), last)
    };
    assert_eq!(told(&["shear.rs"]), ("FlyingShear, Crank: no mistake\n".to_string(), None));
    let six = ["shear.rs", "shear.rs", "shear.rs"];
    assert_eq!(told(&six), ("6 mechanisms: no mistake\n".to_string(), None));
    let last = |arguments: &[&str]| told(arguments).1.expect("mistakes are told");
    assert_eq!(last(&["mistaken.rs"]), "FlyingShear, Crank: 2 mistakes");
    assert_eq!(last(&["mistaken.rs", "--machine", "Crank"]), "Crank: 1 mistake");
    let output = linkage(&["export", "rust", "mistaken.rs"], &folder);
    assert!(text(&output.stderr).ends_with("\nFlyingShear, Crank: 2 mistakes\n"));
}

/// On a terminal, which Python makes.
#[test]
fn a_terminal_shows_colours_and_nothing_else_does() {
    let folder = folder("colours", &[("shear.rs", &SHEAR.replace("80mm", "80kg"))]);
    let on_a_terminal = |variables: &[(&str, &str)]| {
        let code = "import pty, sys; pty.spawn(sys.argv[1:])";
        let mut command = Command::new("python3");
        command.args(["-c", code, env!("CARGO_BIN_EXE_linkage"), "check", "shear.rs"]);
        command.env_remove("NO_COLOR").env("TERM", "xterm").envs(variables.iter().copied());
        command.current_dir(&folder).output()
    };
    let Ok(output) = on_a_terminal(&[]) else {
        return skipped::skipped("colours on a terminal: no python3");
    };
    let coloured = text(&output.stdout);
    let [red, bold, plain] = ["\x1b[1;31m", "\x1b[1m", "\x1b[0m"];
    for part in [
        format!("{red}error{plain}{bold}: a mass where a length belongs{plain}\r\n"),
        format!("{red}^^^^{plain}\r\n"),
        "\x1b[1;34m-->\x1b[0m shear.rs:8:36".to_string(),
    ] {
        assert!(coloured.contains(&part), "{coloured:?}");
    }
    let piped = linkage(&["check", "shear.rs"], &folder);
    for variables in [("NO_COLOR", "1"), ("TERM", "dumb")] {
        let output = on_a_terminal(&[variables]).expect("it started before");
        assert_eq!(text(&output.stdout).replace('\r', ""), text(&piped.stderr));
    }
    assert!(!text(&piped.stderr).contains('\x1b'));
    assert!(text(&on_a_terminal(&[("NO_COLOR", "")]).expect("it started").stdout).contains(red));
}

/// Every message with its place, for an editor or a build.
#[test]
fn messages_are_json_where_asked() {
    let folder = folder("json", &[("shear.rs", &SHEAR.replace("80mm", "80kg"))]);
    let output = linkage(&["check", "shear.rs", "--json"], &folder);
    assert_eq!((output.status.code(), text(&output.stderr)), (Some(1), String::new()));
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).expect("it is JSON");
    let expected = serde_json::json!([
        { "file": "shear.rs", "mechanism": "FlyingShear", "messages": [{
            "level": "error", "message": "a mass where a length belongs",
            "help": "multiply or divide by what is missing",
            "in": "shear.rs", "from": [8, 36], "to": [8, 40],
        }] },
        { "file": "shear.rs", "mechanism": "Crank", "messages": [] },
    ]);
    assert_eq!(found, expected);
}

/// Another value than the declared one, in `check` and in what is exported; a mistake in it is told in its own text.
#[test]
fn a_parameter_is_set() {
    let source =
        "struct Arm { input t: angle; param crank = 80mm; param tilt: angle = 0.1; ground A(0, 0);
        crank AB(A) -> B { length: crank, angle: t + tilt } }";
    let folder = folder("set", &[("arm.mech", source), ("shear.rs", SHEAR)]);
    let export = |set: &str| {
        let output = linkage(&["export", "rust", "arm.mech", "--set", set], &folder);
        assert!(output.status.success(), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    let declared = linkage(&["export", "rust", "arm.mech"], &folder);
    assert_eq!(export("crank=80mm"), text(&declared.stdout));
    assert_eq!(export("crank = 3 * 30mm"), text(&declared.stdout).replace("0.08", "0.09"));
    let check = |set: &[&str]| {
        let flags = set.iter().flat_map(|set| ["--set", set]);
        let arguments: Vec<&str> = ["check", "arm.mech"].into_iter().chain(flags).collect();
        let output = linkage(&arguments, &folder);
        (output.status.code(), text(&output.stderr))
    };
    assert_eq!(check(&["crank=90mm", "tilt=5deg"]), (Some(0), String::new()));
    let (status, errors) = check(&["tilt=0.2", "crank=90mm", "tilt=0.3"]);
    assert!(status == Some(2) && errors.contains("`--set` gives `tilt` two values"), "{errors}");
    let (status, errors) = check(&["tilt=2kg"]);
    assert!(status == Some(1), "{errors}");
    assert!(errors.contains(" --> --set:1:6\n  |\n1 | tilt=2kg\n  |      ^^^\n"), "{errors}");
    for (set, words) in [
        ("crnk=90mm", "no parameter is named `crnk`; there are crank, tilt"),
        ("crank", "write a parameter and its value"),
        ("crank=", "write a parameter and its value"),
        ("crank=1; input s: angle", "write a parameter and its value"),
        ("crank=(", "as in the language"),
        ("t=1", "no parameter is named `t`"),
    ] {
        let (status, errors) = check(&[set]);
        assert!(status == Some(2) && errors.contains(words), "{set}: {errors}");
    }
    let output = linkage(&["check", "shear.rs", "--set", "crank=1m"], &folder);
    assert!(text(&output.stderr).contains("`crank`; there are none"));
}
