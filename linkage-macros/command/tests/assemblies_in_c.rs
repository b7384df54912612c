//! Lists of all assemblies that printed C makes: those of Rust, in both widths, with a solver of each.
//!
//! The run-time of lists is written once more in C. Its sines, arc tangents and roots are those of <math.h>, whose last digits
//! are not those of Rust, so that numbers are compared by what both lists prove of them.

#[allow(unreachable_pub, reason = "other tests have it in the interface of their crate")]
#[path = "../../../tests/src/random.rs"]
mod random;
#[path = "../../../tests/skipped.rs"]
mod skipped;

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use linkage_core::assemblies::{Budget, List, Outcome};
use random::{Random, cases};
use skipped::skipped;

include!("data/triad.rs");
include!("data/seven.rs");

const TRIAD: [&str; 2] = [include_str!("data/triad.rs"), include_str!("data/triad_caller.c")];
const SEVEN: [&str; 2] = [include_str!("data/seven.rs"), include_str!("data/seven_caller.c")];

fn folder(name: &str, machine: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("assemblies_in_c").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder can be made");
    fs::write(folder.join("machine.rs"), machine).expect("a file can be written");
    folder
}

fn printed(folder: &Path, more: &[&str]) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    command.args(["export", "c", "machine.rs", "-o", "."]).args(more).current_dir(folder);
    let output: Output = command.output().expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Compiles all sources strictly with these arguments, and optimised with `LINKAGE_WHOLE`; nothing without a compiler.
fn compiled(folder: &Path, compiler: &str, arguments: &[&str]) -> Option<()> {
    let sources = fs::read_dir(folder).expect("it is there").flatten().map(|entry| entry.path());
    let sources = sources.filter(|path| path.extension().is_some_and(|ending| ending == "c"));
    let mut command = Command::new(compiler);
    command.args(["-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Wredundant-decls", "-Werror"]);
    command
        .arg(["-O0", "-O2"][cases(0, 1)])
        .args(arguments)
        .args(sources)
        .arg("-lm")
        .current_dir(folder);
    let Ok(output) = command.output() else {
        skipped(&format!("assemblies in C: no {compiler}"));
        return None;
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(())
}

/// The count of random machines.
fn count() -> usize {
    cases(400, 10_000)
}

/// Machines whose dimensions are `f32`, so that both widths have the same; an input, then the parameters.
fn machines() -> Vec<[f64; 11]> {
    let mut random = Random::new(60);
    let mut any = || {
        let mut draw = |low, high| random.between(low, high);
        let [bx, by, cx, cy] = [(); 4].map(|()| draw(-2.0, 3.0));
        let [first, second, third, side] = [(); 4].map(|()| draw(0.3, 3.0));
        [
            draw(-3.0, 3.0),
            bx,
            by,
            cx,
            cy,
            first,
            second,
            third,
            side,
            draw(-1.0, 2.0),
            draw(-2.0, 2.0),
        ]
    };
    let mut machines: Vec<_> = (0..count()).map(|_| any()).collect();
    // Parallel legs of one length move while the input stands still; a length is no number, and one is zero.
    machines.push([0.0, 3.0, 0.0, 1.0, 2.0, 1.5, 1.5, 1.5, 2.0, 0.0, 2.0]);
    let [mut no_number, mut zero] = [machines[0]; 2];
    (no_number[1], zero[6]) = (f64::NAN, 0.0);
    machines.extend([no_number, zero]);
    machines
}

fn wide([_, bx, by, cx, cy, first, second, third, side, u, v]: [f64; 11]) -> Triad {
    Triad { bx, by, cx, cy, first, second, third, side, u, v }
}

/// Numbers in the order in which C writes them.
struct Told<'t>(std::slice::Iter<'t, f64>);

impl Told<'_> {
    fn number(&mut self) -> f64 {
        *self.0.next().expect("C writes as many")
    }

    fn numbers<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.number())
    }
}

/// Counts of lists by what both say of them, and of the assemblies that were compared.
#[derive(Debug, Default)]
struct Compared {
    proved: usize,
    otherwise: usize,
    assemblies: usize,
}

impl Compared {
    /// Compares a list, whose assemblies have more numbers behind them.
    fn list<const N: usize>(
        &mut self,
        told: &mut Told<'_>,
        list: &List<N>,
        mut more: impl FnMut(&mut Told<'_>, usize, [f64; 7]),
    ) {
        let [outcome, count, _, pieces] = told.numbers();
        assert!(pieces > 0.0, "pieces are counted");
        let own = match list.outcome {
            Outcome::Proved => 0.0,
            Outcome::Open { .. } => 1.0,
            Outcome::OutOfBudget => 2.0,
        };
        assert_eq!(outcome, own);
        self.proved += usize::from(own == 0.0);
        self.otherwise += usize::from(own != 0.0);
        if own == 0.0 {
            assert_eq!(count as usize, list.len());
        }
        for place in 0..count as usize {
            let numbers = told.numbers();
            more(told, place, numbers);
            let (Some(at), true) = (list.as_slice().get(place), own == 0.0) else { continue };
            let [unknown, from, to, room, within, sides, rises] = numbers;
            assert_eq!((sides as usize, rises == 1.0), (at.sides, at.rises), "{at:?}");
            // Both pairs of ends hold the zero, so that they meet.
            assert!(from <= at.between[1] && at.between[0] <= to, "{from} to {to} of {at:?}");
            assert!(from <= unknown && unknown <= to);
            // A room is half the distance of two zeros, each within its ends.
            assert!((room - at.room).abs() < 1e-8, "{room} of {at:?}");
            // The width is the room, halved some times: one halving more or less where a dyad is at its limit there.
            let halvings = (at.within / within).log2();
            assert!(halvings.abs() < 1.01, "{within} of {at:?}");
            self.assemblies += 1;
        }
    }
}

/// The numbers that a caller in C writes of those that it is given; nothing without a compiler.
fn told(name: &str, [machine, caller]: [&str; 2], given: &[f64]) -> Option<Vec<f64>> {
    let folder = folder(name, machine);
    printed(&folder, &[]);
    fs::write(folder.join("caller.c"), caller).expect("a file can be written");
    let flags = ["-std=c99", "-pedantic", "-Wmissing-prototypes", "-o", "caller"];
    compiled(&folder, "cc", &flags)?;
    let mut caller = Command::new(folder.join("caller"));
    let mut caller =
        caller.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().expect("it starts");
    let bytes: Vec<u8> = given.iter().flat_map(|number| number.to_ne_bytes()).collect();
    let mut input = caller.stdin.take().expect("there is one");
    let writer = std::thread::spawn(move || input.write_all(&bytes));
    let output = caller.wait_with_output().expect("it ends");
    writer.join().expect("no panic").expect("it reads all");
    let chunks = output.stdout.chunks_exact(8);
    let numbers = chunks.map(|chunk| f64::from_ne_bytes(chunk.try_into().expect("eight bytes")));
    Some(numbers.collect())
}

#[test]
fn lists_in_c_are_those_of_rust() {
    let machines = machines();
    let Some(numbers) = told("beside_rust", TRIAD, &machines.concat()) else { return };
    let mut told = Told(numbers.iter());
    let (mut compared, mut refused) = (Compared::default(), Vec::new());
    for given in &machines {
        compare(&mut told, given, &mut compared, &mut refused);
    }
    assert!(told.0.next().is_none());
    // The robot that moves is open in both widths, and the other two are refused.
    assert_eq!((compared.proved, compared.otherwise), (2 * count(), 2), "{compared:?}");
    assert!(compared.assemblies > 2 * count(), "{compared:?}");
    let [not_finite, no_length] = [4.0, 3.0];
    assert_eq!(refused, [not_finite, not_finite, no_length, no_length]);
}

/// A group of two dyads, whose sides are told apart.
#[test]
fn lists_of_two_dyads_in_c_are_those_of_rust() {
    // Exact in single precision.
    let inputs: Vec<f64> = (0..count() / 8).map(|at| f64::from(at as f32 * 0.125)).collect();
    let Some(numbers) = told("two_dyads", SEVEN, &inputs) else { return };
    let (mut told, mut compared) = (Told(numbers.iter()), Compared::default());
    let (wide, narrow) = (Seven::new(), Seven::<f32>::default());
    for t in inputs {
        assert_eq!(told.number(), 0.0);
        let list = wide.assemblies(t, Budget::default()).expect("nothing is refused");
        compared.list(&mut told, &list, |_, _, _| {});
        assert_eq!(told.number(), 0.0);
        let list = narrow.assemblies(t as f32, Budget::default()).expect("nothing is refused");
        compared.list(&mut told, &list, |_, _, _| {});
    }
    assert!(told.0.next().is_none());
    assert!(compared.otherwise == 0 && compared.assemblies > compared.proved, "{compared:?}");
}

/// Both widths of a machine.
fn compare(
    told: &mut Told<'_>,
    given: &[f64; 11],
    compared: &mut Compared,
    refused: &mut Vec<f64>,
) {
    let (t, machine) = (given[0], wide(*given));
    let status = told.number();
    let Ok(list) = machine.assemblies(t, Budget::default()) else {
        let _: [f64; 4] = told.numbers();
        let _: [f64; 3] = told.numbers();
        refused.extend([status, told.number()]);
        let _: [f64; 4] = told.numbers();
        return;
    };
    assert_eq!(status, 0.0);
    let mut unknowns = Vec::new();
    compared.list(told, &list, |told, place, [unknown, ..]| {
        unknowns.push(unknown);
        let [status, x, y] = told.numbers();
        let Some(at) = list.as_slice().get(place).filter(|_| list.is_proved()) else { return };
        let own = machine.with(at).position(t);
        assert_eq!(status == 0.0, own.is_ok(), "{status} of {own:?}");
        if let Ok(pose) = own {
            // Next to a dead point half of the digits of a root are left.
            assert!((pose.R.x - x).hypot(pose.R.y - y) < 1e-7, "({x}, {y}) of {:?}", pose.R);
        }
    });
    nearest(told, &unknowns);
    assert_eq!(told.number(), 0.0);
    let narrow = machine_in_f32(given);
    let list = narrow.assemblies(t as f32, Budget::default()).expect("it is not refused in f64");
    compared.list(told, &list, |told, _, [unknown, _, _, _, _, sides, rises]| {
        let [near, side, trend] = told.numbers();
        assert_eq!(near, f64::from(unknown as f32));
        assert_eq!([side, trend], [sides, rises].map(|bit| 2.0 * bit - 1.0));
    });
}

/// The nearest to 40 rad of all but the first.
fn nearest(told: &mut Told<'_>, unknowns: &[f64]) {
    let away = |unknown: f64| (unknown - 40.0).sin().atan2((unknown - 40.0).cos()).abs();
    let mut all: Vec<_> = unknowns.iter().copied().map(away).enumerate().skip(1).collect();
    all.sort_by(|a, b| a.1.total_cmp(&b.1));
    let [index, off, runner_up] = told.numbers();
    let Some(&(best, least)) = all.first() else {
        assert!(index == -1.0 && off.is_nan() && runner_up.is_nan());
        return;
    };
    // 40 less some turns is rounded to its last digits, 1e-14.
    assert!(index == best as f64 && (off - least).abs() < 1e-13);
    match all.get(1) {
        Some((_, second)) => assert!((runner_up - second).abs() < 1e-13),
        None => assert!(runner_up.is_nan()),
    }
}

fn machine_in_f32(given: &[f64; 11]) -> Triad<f32> {
    let [_, bx, by, cx, cy, first, second, third, side, u, v] = given.map(|number| number as f32);
    Triad { bx, by, cx, cy, first, second, third, side, u, v }
}

/// Printed lists are C and C++, with a prefix, and without either width.
#[test]
fn lists_are_c_and_cpp_without_a_width_and_with_a_prefix() {
    let folder = folder("strict", TRIAD[0]);
    printed(&folder, &["--prefix", "acme", "--only", "position"]);
    let names: Vec<_> = fs::read_dir(&folder).expect("it is there").flatten().collect();
    assert!(names.iter().all(|file| {
        let name = file.file_name();
        name == "machine.rs" || name.to_string_lossy().starts_with("acme_")
    }));
    let c = ["-std=c99", "-pedantic", "-c"];
    for more in [&[][..], &["-DLINKAGE_NO_DOUBLE"], &["-DLINKAGE_NO_SINGLE"]] {
        if compiled(&folder, "cc", &[&c, more].concat()).is_none() {
            return;
        }
    }
    let _ = compiled(&folder, "c++", &["-x", "c++", "-c"]);
}

/// A null pointer, a spent budget and a value between others are told as in Rust.
#[test]
fn a_list_without_an_answer_says_why() {
    let folder = folder("refusals", TRIAD[0]);
    printed(&folder, &["--only", "position,f64"]);
    let caller = r#"
#include "triad_assemblies.h"
#include <stdio.h>
#include <string.h>

int main(void)
{
    const LinkageBudget budget = { LINKAGE_SAMPLES, LINKAGE_PIECES }, small = { 30u, 100u }, none = { 1000u, 0u };
    const Triad machine = triad_default();
    LinkageAssembly found[TRIAD_ASSEMBLIES];
    LinkageAssemblies list;
    LinkageError error;
    const TriadAssembly declared = triad_assembly_default(), same = triad_with(NULL, found);
    printf("%d", (int)triad_assemblies(NULL, 0.0, budget, found, &list, &error));
    printf(" %.*s", (int)error.name_length, error.name);
    printf(" %d", (int)triad_assemblies(&machine, 0.0, budget, NULL, &list, NULL));
    printf(" %d", (int)triad_assemblies(&machine, 0.0, budget, found, NULL, NULL));
    printf(" %d", memcmp(&declared, &same, sizeof same));
    printf(" %d", (int)triad_assemblies(&machine, 0.0, small, found, &list, NULL));
    printf(" %d %d", (int)list.outcome, (int)list.samples);
    printf(" %d", (int)triad_assemblies(&machine, 0.0, none, found, &list, NULL));
    printf(" %d %d\n", (int)list.outcome, (int)list.pieces);
    return 0;
}
"#;
    fs::write(folder.join("caller.c"), caller).expect("a file can be written");
    if compiled(&folder, "cc", &["-std=c99", "-o", "caller"]).is_none() {
        return;
    }
    let output = Command::new(folder.join("caller")).output().expect("it starts");
    let small = Budget { samples: 30, pieces: 100 };
    let in_rust = Triad::new().assemblies(0.0, small).expect("a budget refuses nothing");
    assert_eq!(in_rust.outcome, Outcome::OutOfBudget);
    let told = format!("5 mechanism 5 5 0 0 2 {} 0 2 0\n", in_rust.samples);
    assert_eq!(String::from_utf8_lossy(&output.stdout), told);
}
