//! Programs in C that tests compile, feed with calls and read numbers from.

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use super::skipped::skipped;
use crate::cases::cases;
use crate::codegen::c::run_time;

pub(super) const STRICT: [&str; 6] =
    ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Wconversion"];

/// The level at which a compiler optimises. Numbers are those of Rust at any level, and a run-time is compiled in a third of
/// the time at the lowest. `LINKAGE_WHOLE` asks for the one of releases.
pub(super) fn level() -> &'static str {
    ["-O0", "-O2"][cases(0, 1)]
}

/// A compiled program, in a folder that goes with it.
pub(super) struct Program {
    folder: PathBuf,
}

impl Program {
    /// A caller from the folder `c` beside this file, with the run-time and this part of it, compiled with these
    /// flags; none without a compiler.
    pub(super) fn compiled(
        compiler: &str,
        name: &str,
        flags: &[&str],
        caller: &str,
        (part, text): (&str, String),
    ) -> Option<Self> {
        let folder = std::env::temp_dir().join(format!("linkage_{}_{name}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder can be made");
        let callers = Path::new(env!("CARGO_MANIFEST_DIR")).join("codegen/c");
        for (file, text) in [
            ("linkage_run.h", run_time::header()),
            ("linkage_run.c", run_time::source()),
            (part, text),
            ("caller.c", std::fs::read_to_string(callers.join(caller)).expect("it can be read")),
        ] {
            std::fs::write(folder.join(file), text).expect("a file can be written");
        }
        let program = Self { folder };
        let command = Command::new(compiler)
            .args(flags)
            .args([level(), "-Werror", "-o", "caller", "caller.c", "linkage_run.c", part, "-lm"])
            .current_dir(&program.folder)
            .output();
        let Ok(output) = command else {
            skipped(&format!("the run-time in C: no {compiler}"));
            return None;
        };
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        Some(program)
    }

    /// The numbers that the program writes, having read these bytes.
    pub(super) fn numbers(&self, bytes: Vec<u8>) -> Vec<f64> {
        let mut child = Command::new(self.folder.join("caller"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut to = child.stdin.take().expect("it is piped");
        let writer = std::thread::spawn(move || to.write_all(&bytes).expect("it reads"));
        let mut read = Vec::new();
        child.stdout.take().expect("it is piped").read_to_end(&mut read).expect("it writes");
        writer.join().expect("nothing panics");
        assert!(child.wait().expect("it ends").success());
        let number = |x: &[u8]| f64::from_ne_bytes(x.try_into().expect("eight bytes"));
        read.chunks(8).map(number).collect()
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// Not a number is one answer, whatever its bits.
pub(super) fn bits(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}
