//! Compile times of declarations: scratch crates, built by Cargo as a user would.
//!
//! Times depend on the machine, so nothing is measured unless asked for:
//! `cargo test -p linkage-core --test compile_time -- --ignored --nocapture`. Where others use the
//! machine as well, the processor's time says more than the clock's.

use std::fmt::{self, Display, Formatter, Write};
use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::time::{Duration, Instant};

/// A crate outside the workspace that declares mechanisms and nothing else.
struct Scratch {
    root: PathBuf,
    /// By `[profile.dev.build-override] opt-level = 1` in its manifest.
    macro_is_optimised: bool,
    /// As Cargo builds by default: it takes what has not changed from the build before.
    is_incremental: bool,
}

impl Scratch {
    fn new(name: &str, source: &str) -> Self {
        Self::with(&["macros"], name, source)
    }

    /// One that has these features of the library.
    fn with(features: &[&str], name: &str, source: &str) -> Self {
        let root = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::create_dir_all(root.join("src")).expect("the scratch directory can be made");
        let manifest = format!(
            "[package]\nname = \"{name}\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
             linkage-core = {{ path = {:?}, default-features = false, features = {features:?} }}\n\
             [profile.release]\nstrip = true\n",
            env!("CARGO_MANIFEST_DIR")
        );
        fs::write(root.join("Cargo.toml"), manifest).expect("the manifest can be written");
        fs::write(root.join("src/lib.rs"), source).expect("the source can be written");
        let lock = concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.lock");
        fs::copy(lock, root.join("Cargo.lock")).expect("the lock file can be copied");
        Self { root, macro_is_optimised: false, is_incremental: true }
    }

    fn cargo(&self, arguments: &[&str]) {
        self.cargo_with(arguments, &[]);
    }

    fn cargo_with(&self, arguments: &[&str], variables: &[(&str, &str)]) {
        let [target, level] = match self.macro_is_optimised {
            false => [concat!(env!("CARGO_TARGET_TMPDIR"), "/compile_time"), "0"],
            true => [concat!(env!("CARGO_TARGET_TMPDIR"), "/compile_time_optimised"), "1"],
        };
        let status = Command::new(env!("CARGO"))
            .args(arguments)
            .args(["--quiet", "--offline"])
            .current_dir(&self.root)
            .env("CARGO_TARGET_DIR", target)
            .env("CARGO_PROFILE_DEV_BUILD_OVERRIDE_OPT_LEVEL", level)
            .env("CARGO_INCREMENTAL", if self.is_incremental { "1" } else { "0" })
            .envs(variables.iter().copied())
            .status()
            .expect("cargo can be started");
        assert!(status.success(), "cargo {arguments:?} failed in {}", self.root.display());
    }

    /// The least of three times, everything but the declarations compiled before.
    fn time(&self, arguments: &[&str]) -> Cost {
        self.cargo(arguments);
        let costs: [Cost; 3] = std::array::from_fn(|_| self.once(arguments));
        costs.into_iter().reduce(Cost::least).expect("there are three")
    }

    /// The time of one more build.
    fn once(&self, arguments: &[&str]) -> Cost {
        let source = self.root.join("src/lib.rs");
        let text = fs::read_to_string(&source).expect("the source can be read");
        fs::write(&source, &text).expect("the source can be written");
        let (start, before) = (Instant::now(), processor_time_of_children());
        self.cargo(arguments);
        Cost { clock: start.elapsed(), processor: processor_time_of_children() - before }
    }
}

/// The instructions of a cold check of the declarations alone, in thousand millions. They hardly depend on what else
/// the machine does.
fn instructions(scratch: &Scratch) -> f64 {
    let counts = scratch.root.join("counts");
    let _ = fs::remove_dir_all(&counts);
    fs::create_dir_all(&counts).expect("the folder can be made");
    // Cargo puts this program in front of the compiler for the scratch crate, and for nothing that it builds on.
    let program = scratch.root.join("counted");
    let tool = "--tool=cachegrind --cache-sim=no --trace-children=yes --log-file=/dev/null";
    let counted = format!(
        "#!/bin/sh\nexec valgrind {tool} --cachegrind-out-file='{}/%p' \"$@\"\n",
        counts.display()
    );
    fs::write(&program, counted).expect("the script can be written");
    let status = Command::new("chmod").arg("+x").arg(&program).status();
    assert!(status.is_ok_and(|status| status.success()), "the script can be run");
    scratch.cargo(&["check"]);
    let source = scratch.root.join("src/lib.rs");
    let text = fs::read_to_string(&source).expect("the source can be read");
    fs::write(&source, &text).expect("the source can be written");
    let program = program.to_str().expect("the path is text");
    scratch.cargo_with(&["check"], &[("RUSTC_WORKSPACE_WRAPPER", program)]);
    let counted = fs::read_dir(&counts).expect("the folder is there").filter_map(|file| {
        let text = fs::read_to_string(file.ok()?.path()).ok()?;
        text.rsplit_once("summary: ")?.1.trim().parse::<f64>().ok()
    });
    // Cargo asks the compiler for its version as well, which takes far less.
    counted.fold(0.0, f64::max) * 1e-9
}

/// The cost of a build.
#[derive(Clone, Copy)]
struct Cost {
    clock: Duration,
    /// The time of all processors together; zero if it is not known.
    processor: Duration,
}

impl Cost {
    fn least(self, other: Self) -> Self {
        Self { clock: self.clock.min(other.clock), processor: self.processor.min(other.processor) }
    }
}

impl Display for Cost {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{:6.2} {:6.2}", self.clock.as_secs_f64(), self.processor.as_secs_f64())
    }
}

/// The processor time of all processes that were started from here and have ended, as Linux counts
/// it, in hundredths of a second.
fn processor_time_of_children() -> Duration {
    let stat = fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The numbers stand behind the name of the program, which may hold anything but `)`.
    let numbers = stat.rsplit(')').next().unwrap_or_default().split_whitespace();
    let ticks: u64 = numbers.skip(13).take(2).filter_map(|n| n.parse::<u64>().ok()).sum();
    Duration::from_millis(ticks * 10)
}

/// A crank and four dyads, one of each kind that closes a loop on the ground.
fn five_bodies(i: usize) -> String {
    let crank = 80 + i;
    format!(
        "linkage_core::mechanism! {{ pub struct M{i} {{
            input theta: angle;
            ground A(0, 0), D(665.7mm, 0), E(900mm, 20mm);
            guide rail through (0, 300mm) along 10deg;
            crank AB(A) -> B {{ length: {crank}mm, angle: theta }}
            rrr BC(B), DC(D) -> C {{ lengths: (632mm, 374mm), mode: left }}
            point P on BC at (500mm, -60mm);
            rrp PQ(P), block(rail) -> Q {{ length: 700mm, mode: ahead }}
            rpr sleeve(C), bar(E) {{ }}
            point R on bar at (100mm, 50mm);
            rpp pin(R), yoke(rail) {{ slot: 80deg }}
        }} }}\n"
    )
}

/// Dyads on dyads: each stands on the ground and on the pin of the one before.
fn chain(groups: usize) -> String {
    let mut source = String::from(
        "linkage_core::mechanism! { pub struct Chain { input theta: angle; ground A(0, 0);
         crank AB(A) -> P0 { length: 100mm, angle: theta }\n",
    );
    for i in 1..=groups {
        let (x, before) = (i * 600, i - 1);
        writeln!(
            source,
            "ground D{i}({x}mm, 0); rrr a{i}(P{before}), b{i}(D{i}) -> P{i} \
             {{ lengths: (605mm, 300mm), mode: left }}"
        )
        .expect("a string takes everything");
    }
    source + &format!("output P{groups}, b{groups}; }} }}\n")
}

#[test]
#[ignore = "takes minutes, and measures the machine as well"]
fn many_mechanisms_and_long_chains() {
    let fifty: String = (0..50).map(five_bodies).collect();
    let rows = [
        ("fifty_mechanisms", fifty),
        ("chain_of_25", chain(25)),
        ("chain_of_50", chain(50)),
        ("chain_of_100", chain(100)),
    ];
    println!("seconds by the clock, and of the processor");
    println!("{:>20} {:>13} {:>13} {:>13}", "", "check", "debug", "release");
    for (name, source) in rows {
        let scratch = Scratch::new(name, &source);
        let [check, debug, release] =
            [&["check"][..], &["build"], &["build", "--release"]].map(|a| scratch.time(a));
        println!("{name:>20} {check} {debug} {release}");
    }
    let fifty: String = (0..50).map(five_bodies).collect();
    let optimised = Scratch { macro_is_optimised: true, ..Scratch::new("macro_optimised", &fifty) };
    println!("{:>20} {}", "macro optimised", optimised.time(&["check"]));
}

/// Features of the library that every declaration pays for, each with those it brings.
const PAID: [(&str, &[&str]); 3] = [
    ("bare", &["macros", "std"]),
    ("sketch", &["macros", "sketch"]),
    ("page", &["macros", "page"]),
];

/// Cold, as the first build is. Instructions are counted by Debian's `valgrind`, since times vary by more from one
/// build to the next than `page` takes.
#[test]
#[ignore = "takes minutes, and needs valgrind"]
fn features_that_draw() {
    let fifty: String = (0..50).map(five_bodies).collect();
    let counts = PAID.map(|(name, features)| {
        instructions(&Scratch {
            is_incremental: false,
            ..Scratch::with(features, &format!("fifty_{name}"), &fifty)
        })
    });
    println!("thousand million instructions, and the share beyond the row before");
    for (k, (name, _)) in PAID.iter().enumerate() {
        let before = counts[k.saturating_sub(1)];
        println!("{name:>20} {:6.2} {:5.1} %", counts[k], 100.0 * (counts[k] / before - 1.0));
    }
    // A count that is no whole compiler's would be that of a question for its version.
    assert!(counts.iter().all(|&count| count > 1.0), "{counts:?}");
    assert!(counts[0] < counts[1] && counts[1] < counts[2], "{counts:?}");
    assert!(counts[2] < 1.05 * counts[1], "who draws pays for pages: {counts:?}");
}

/// The bytes of a program, stripped of names.
fn program(features: &[&str], name: &str, main: &str) -> u64 {
    let declared = five_bodies(1);
    let source = format!("{declared} fn main() {{ {main} }}");
    let scratch = Scratch::with(features, name, "");
    fs::write(scratch.root.join("src/main.rs"), source).expect("the source can be written");
    // Without this, tables for unwinding stay whose functions go.
    scratch.cargo(&["build", "--release", "--config", "profile.release.lto=true"]);
    let built = format!("{}/compile_time/release/{name}", env!("CARGO_TARGET_TMPDIR"));
    fs::metadata(built).expect("it is built").len()
}

/// Texts and functions that nothing reads are in no program. A page that is written is.
#[test]
#[ignore = "builds the library four times"]
fn what_draws_is_in_no_program_that_does_not_draw() {
    let solves = "println!(\"{:?}\", M1::new().position(std::env::args().len() as f64));";
    let sizes = PAID.map(|(name, features)| program(features, &format!("size_{name}"), solves));
    println!("{sizes:?}");
    // Another alignment of constants may bring some bytes less.
    assert!(sizes.iter().all(|&size| size <= sizes[0]), "{sizes:?}");
    assert_eq!(sizes[1], sizes[2], "who draws has nothing of pages");
    let draws = "println!(\"{}\", M1::new().page().to_html().unwrap().len());";
    assert!(program(PAID[2].1, "size_drawn", draws) > sizes[0] + 50_000);
}
