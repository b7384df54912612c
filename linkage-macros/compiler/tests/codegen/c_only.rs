//! Every entry point of a declaration by itself, in either width and in both: compilers accept what `--only` prints.

use std::collections::BTreeSet;
use std::path::Path;

use super::c_printed::{STRICT, compiled};
use crate::cases::cases;
use crate::codegen::c;
use crate::codegen::c::c_identifiers::Width;
use crate::codegen::c::provenance::{Prefix, Provenance};
use crate::codegen::c::selection::Selection;
use crate::diagnostics::Diagnostics;
use crate::exact::AtomScope;
use crate::expansions::declarations;
use crate::{lower, pipeline};
use proc_macro2::TokenStream;

/// A press with a load, friction and a search, and a crank of two inputs and loads.
const SAMPLE: [&str; 4] = [
    "pub struct Plain { input theta: angle; ground A(0, 0); guide bed through A along 0deg;
     crank AB(A) -> B { length: 80mm, angle: theta }
     rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
     mass 4kg on C; output theta.drive, AB.A; }",
    "pub struct Press { input theta: angle; load work: force; param mu = 0.1;
     ground A(-500mm, 0); guide way through (0, 0) along 0deg; guide column through (0, 0) along 90deg;
     pin B(-450mm, 50mm), K(-60mm, 0), U(0, 240mm), V(0, -240mm);
     link AB(A, B); link BK(B, K); link shoe(K) on way; link KU(K, U); link KV(K, V);
     link upper(U) on column; link lower(V) on column; drive AB.angle = theta;
     gravity (0, -9.81); mass 30kg on U; mass 45kg on V; force (0, -work) on U; force (0, work) on V;
     friction mu on upper; friction mu on lower; friction 0.08 at A radius 20mm; }",
    "pub struct Two { input q: angle; input s: angle; load work: force; load brake: torque;
     param way: mode = left; ground A(0, 0), D(1m, 0);
     crank AB(A) -> B { length: 300mm, angle: q } crank DE(D) -> E { length: 300mm, angle: s }
     rrr BC(B), EC(E) -> C { lengths: (700mm, 600mm), mode: way }
     mass 4kg on C; force (-work, 0) on C; torque -brake on AB; output C, BC, q.drive, AB.A, energy; }",
    "pub struct Found { input z: length; unknown theta: angle between (-25deg, 25deg);
     ground A(0, 0.2), D(0.05, 0.45); crank lower(A) -> B { length: 0.38, angle: theta }
     rrr kingpin(B), upper(D) -> C { lengths: (0.25, 0.28), mode: right }
     point W on kingpin at (0.12, -0.06); mass 2kg on W;
     solve theta { W.y = z, mode: rising } output W, theta, z.drive, energy, upper.margin; }",
];

/// Prints each entry point in each width and in both into a folder of its own; returns the names of the sources.
fn print_each(source: TokenStream, name: &str, root: &Path) -> Vec<String> {
    let _atoms = AtomScope::begin();
    let mut diagnostics = Diagnostics::new();
    let (_, resolved) = pipeline::read(source, &mut diagnostics);
    let Some(Ok(mechanism)) = resolved else {
        panic!("{name}: {:?}", diagnostics.finish().err());
    };
    let program = pipeline::program(&mechanism);
    let points = program.answers.iter().filter_map(|answer| answer.entry);
    let points = points.map(|point| point.name());
    // Each in one width, and in all of them with `LINKAGE_WHOLE`.
    let selected = points.enumerate().flat_map(|(nth, point)| {
        let [one, other] = Width::ALL.map(|width| vec![point, width.in_rust()]);
        let mut all = [one, other, vec![point]];
        all.rotate_left(nth % 3);
        all.into_iter().take(cases(1, 3))
    });
    let mut sources = Vec::new();
    let provenance =
        Provenance { mechanism: &mechanism, declaration: 0, prefix: Prefix::default() };
    for only in selected {
        let selection = Selection::of(&mechanism, &program, &only, &mut diagnostics);
        let printed = selection.apply(program.clone());
        let lowered = lower::lower(&mechanism, &printed);
        let folder = format!("{name}_{}", only.join("_"));
        std::fs::create_dir_all(root.join(&folder)).expect("a folder can be made");
        let files = c::generate(&mechanism, &lowered, &selection, &provenance);
        for (file, text) in &files {
            std::fs::write(root.join(&folder).join(file), text).expect("it can be written");
        }
        sources.push(format!("{folder}/{}", files[1].0));
    }
    diagnostics.finish().expect("every entry point is known");
    sources
}

/// The count of sources that a compiler takes, all of them without a warning.
fn each_is_c(name: &str, of: impl Iterator<Item = (String, TokenStream)>) -> usize {
    let root = std::env::temp_dir().join(format!("linkage_c_{}_{name}", std::process::id()));
    let mut count = 0;
    let mut failed = BTreeSet::new();
    for (name, source) in of {
        let sources = print_each(source, &name, &root);
        count += sources.len();
        for errors in compiled("cc", &STRICT, &sources, &root).into_iter().flatten() {
            failed.extend(errors.lines().filter(|line| line.contains("error")).map(str::to_string));
        }
        // A folder that failed is kept, to be looked at.
        if failed.is_empty() {
            std::fs::remove_dir_all(&root).expect("the folder was made here");
        }
    }
    assert!(failed.is_empty(), "{count} sources: {failed:#?}");
    count
}

#[test]
fn every_function_asks_whether_a_mode_is_one() {
    let files = pipeline::c(SAMPLE[2].parse().expect("these are tokens"), &[], None);
    let text = &files.expect("there is no mistake")[1].text;
    let functions = text.matches("\nLinkageStatus two_").count();
    assert_eq!(text.matches("LINKAGE_INVALID_MODE, \"way\"").count(), functions);
    assert!(functions > 10, "{functions}");
}

#[test]
fn an_entry_point_by_itself_is_c() {
    let sample = SAMPLE
        .iter()
        .enumerate()
        .map(|(nth, source)| (nth.to_string(), source.parse().expect("these are tokens")));
    assert!(each_is_c("only", sample) > cases(40, 120));
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn an_entry_point_of_any_declaration_by_itself_is_c() {
    let all = declarations::all().enumerate().map(|(nth, of)| (nth.to_string(), of.tokens));
    assert!(each_is_c("only_any", all) > cases(2500, 7500));
}
