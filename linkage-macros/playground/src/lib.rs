//! The compiler for a page: a text and a task in, an answer out.
//!
//! `room(bytes) → address` makes room for a text, `answer(address, bytes, task) → address` consumes it and answers with
//! a length of four bytes and as many bytes, `forget(address)` frees an answer. There are no imports: no clock, no file,
//! no thread.

#[path = "../../command/src/import/converted.rs"]
mod converted;
#[path = "../../command/src/zip.rs"]
#[expect(dead_code, reason = "the program compares archives as well")]
mod zip;

use std::ops::Range;

use linkage_compiler::{
    Diagnostic, Level, PageParts, WrittenPlace, by_set, declarations, machine_and_set, places,
    unbalanced,
};
use linkage_core::sketch::{Declared, Machine, Wishes, html_of_sets};
use proc_macro2::{LexError, TokenStream};
use serde_json::{Value, json};

/// The mistakes and notes of a text, and its page where it has none.
pub const CHECK: u32 = 0;
/// The solver as C99, in an archive.
pub const C: u32 = 1;
/// The FMU, in an archive.
pub const FMU: u32 = 2;
/// The program in Rust that declares the machine.
pub const RUST: u32 = 3;
/// All of these, the page and the text in one archive.
pub const ALL: u32 = 4;
/// A machine of PMKS+, pylinkage or pyslvs as a declaration.
pub const IMPORT: u32 = 5;

/// Room for a text.
#[unsafe(no_mangle)]
pub extern "C" fn room(bytes: usize) -> *mut u8 {
    Box::into_raw(vec![0_u8; bytes].into_boxed_slice()).cast()
}

/// Does a task.
///
/// # Safety
/// The text stands in room that [`room`] has made for as many bytes, and is given once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn answer(text: *mut u8, bytes: usize, task: u32) -> *mut u8 {
    // SAFETY: by the contract.
    let text = unsafe { Box::from_raw(core::ptr::slice_from_raw_parts_mut(text, bytes)) };
    let answer = answered(&String::from_utf8_lossy(&text), task);
    let mut bytes = u32::try_from(answer.len()).unwrap_or(0).to_le_bytes().to_vec();
    bytes.extend(answer);
    Box::into_raw(bytes.into_boxed_slice()).cast()
}

/// Frees an answer.
///
/// # Safety
/// It is one of [`answer`], and is given once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn forget(answer: *mut u8) {
    // SAFETY: the length stands in front.
    unsafe {
        let length = u32::from_le_bytes(*answer.cast::<[u8; 4]>()) as usize + 4;
        drop(Box::from_raw(core::ptr::slice_from_raw_parts_mut(answer, length)));
    }
}

/// The answer to a task. A text is a program with a declaration, or what stands between its braces.
#[must_use]
pub fn answered(text: &str, task: u32) -> Vec<u8> {
    let answer = done(text, task);
    // The places of a text are kept until they are forgotten.
    proc_macro2::extra::invalidate_current_thread_spans();
    answer
}

fn done(text: &str, task: u32) -> Vec<u8> {
    if task == IMPORT {
        return imported(text).to_string().into_bytes();
    }
    let tokens: TokenStream = match text.parse() {
        Ok(tokens) => tokens,
        Err(error) if task == CHECK => return unreadable(text, &error).to_string().into_bytes(),
        Err(_) => return Vec::new(),
    };
    let sets = first_machine(tokens);
    match task {
        CHECK => checked(text, &sets).to_string().into_bytes(),
        // Rust needs the declaration alone, but one without mistakes.
        RUST => parts_of(&sets).map_or(Vec::new(), |_| rust(text).into_bytes()),
        ALL => all(text, &sets),
        _ => archive(&printed(&sets, task, "")),
    }
}

/// The declarations of the first machine, one for each set of inputs that it has.
fn first_machine(tokens: TokenStream) -> Vec<TokenStream> {
    let mut sets = declarations(tokens.clone());
    if sets.is_empty() {
        sets = by_set(tokens);
    }
    let machine = |set: &TokenStream| machine_and_set(set).map(|[machine, _]| machine);
    let first = sets.first().and_then(machine);
    let others = sets.iter().skip(1).take_while(|set| first.is_some() && machine(set) == first);
    sets.truncate(1 + others.count());
    sets
}

/// The pages' texts of all sets. Of what sets find at one place the first mistake is told.
fn parts_of(sets: &[TokenStream]) -> Result<Vec<PageParts>, Vec<Diagnostic>> {
    let (mut parts, mut mistakes) = (Vec::new(), Vec::new());
    for set in sets {
        match linkage_compiler::page(set.clone()) {
            Ok(own) => parts.push(own),
            Err(mut own) => {
                own.retain(|one: &Diagnostic| !mistakes.iter().any(|other| one.is_told_by(other)));
                mistakes.extend(own);
            }
        }
    }
    if mistakes.is_empty() { Ok(parts) } else { Err(mistakes) }
}

fn imported(text: &str) -> Value {
    match converted::declaration(text.trim(), &[], [None, None]) {
        Ok(text) => json!({ "text": text }),
        Err(mistake) => json!({ "mistake": mistake }),
    }
}

/// Names and contents of files.
type Files = Vec<(String, Vec<u8>)>;

/// The files of a solver in C or of an FMU, in a folder; none where there are mistakes.
fn printed(sets: &[TokenStream], task: u32, folder: &str) -> Files {
    let of_each = sets.iter().map(|set| match task {
        C => linkage_compiler::c(set.clone(), &[], None),
        _ => linkage_compiler::fmu(set.clone(), false),
    });
    let files = match task {
        C => of_each.chain([linkage_compiler::c_transfers(sets, &[], None)]).collect(),
        // An FMU has one set of inputs.
        _ => of_each.take(1).collect::<Result<Vec<_>, _>>(),
    };
    let mut files: Vec<_> = files.unwrap_or_default().into_iter().flatten().collect();
    // Solvers share a run-time.
    files.sort_by(|one, other| one.name.cmp(&other.name));
    files.dedup_by(|one, other| one.name == other.name);
    let files = files.into_iter();
    files.map(|file| (format!("{folder}{}", file.name), file.text.into_bytes())).collect()
}

/// The text as a program in Rust.
fn rust(text: &str) -> String {
    let call = match text.contains("mechanism!") {
        true => text.to_string(),
        false => format!("mechanism! {{\n{}\n}}\n", text.trim_end()),
    };
    let is_whole = call.contains("linkage_core");
    if is_whole { call } else { format!("use linkage_core::mechanism;\n\n{call}") }
}

fn archive(files: &Files) -> Vec<u8> {
    if files.is_empty() { Vec::new() } else { zip::archive(files) }
}

/// The text, its page, its solver in every language, and its FMU.
fn all(text: &str, sets: &[TokenStream]) -> Vec<u8> {
    let Ok(parts) = parts_of(sets) else { return Vec::new() };
    let name = name_of(sets, &parts);
    let fmu = archive(&printed(sets, FMU, ""));
    let mut files = printed(sets, C, "c/");
    files.extend([
        (format!("{name}.rs"), rust(text).into_bytes()),
        (format!("{name}.html"), page(sets, &parts, text).into_bytes()),
        (format!("{name}.fmu"), fmu),
    ]);
    archive(&files)
}

fn unreadable(text: &str, error: &LexError) -> Value {
    let (at, message) = unbalanced(text).unwrap_or_else(|| {
        (error.span().byte_range(), "a text or a comment is not closed".to_string())
    });
    json!({ "messages": [told(text, &message, None, "error", at)] })
}

fn checked(text: &str, sets: &[TokenStream]) -> Value {
    // What is about the machine is said of each set.
    let told = |found: Vec<Diagnostic>| {
        let mut told: Vec<Value> = Vec::new();
        for found in found.iter().map(|found| message(text, found)) {
            if !told.contains(&found) {
                told.push(found);
            }
        }
        told
    };
    let places = sets.first().map_or(Vec::new(), |set| places(set.clone()));
    let places: Vec<Value> = places.iter().map(|place| written(text, place)).collect();
    match parts_of(sets) {
        Err(mistakes) => json!({ "messages": told(mistakes), "places": places }),
        Ok(parts) => json!({
            "name": name_of(sets, &parts),
            "page": page(sets, &parts, text),
            "messages": told(parts.into_iter().flat_map(|parts| parts.notes).collect()),
            "places": places,
        }),
    }
}

/// The name of the machine.
fn name_of(sets: &[TokenStream], parts: &[PageParts]) -> String {
    let machine = sets.first().and_then(machine_and_set).map(|[machine, _]| machine.to_string());
    machine.unwrap_or_else(|| parts[0].name.clone())
}

/// The page of a machine.
fn page(sets: &[TokenStream], parts: &[PageParts], text: &str) -> String {
    let machines = parts.iter().map(|parts| {
        let PageParts { plan, script, inputs, params, loads, outputs, .. } = parts;
        let declared = Declared::new([plan, script, text, inputs, params, loads, outputs]);
        let (name, docs, values) = (&parts.name[..], &parts.docs[..], &parts.values[..]);
        Machine { name, docs, declared, values }
    });
    let names: Vec<_> = sets
        .iter()
        .map(|set| machine_and_set(set).map_or(String::new(), |[_, set]| set.to_string()))
        .collect();
    let machines: Vec<_> = names.iter().map(String::as_str).zip(machines).collect();
    let page = html_of_sets(&name_of(sets, parts), &machines, &Wishes::default());
    page.expect("nothing is wished that could be unknown")
}

fn message(text: &str, found: &Diagnostic) -> Value {
    let level = match found.level {
        Level::Mistake => "error",
        Level::Note => "note",
    };
    let [first, last] = [found.first, found.last].map(|span| span.byte_range());
    told(text, &found.message, found.note.as_deref(), level, first.start..last.end)
}

/// A message, and the letters of the text from which to which it is about, counted as JavaScript counts them. What is
/// about a whole declaration has no letters.
fn told(text: &str, message: &str, help: Option<&str>, level: &str, at: Range<usize>) -> Value {
    let [from, to] = [at.start, at.end].map(|at| letters(text, at));
    json!({ "message": message, "help": help, "level": level, "from": from, "to": to.max(from) })
}

/// A place, and the letters of its two numbers.
fn written(text: &str, place: &WrittenPlace) -> Value {
    let numbers = place.numbers.clone().map(|at| [at.start, at.end].map(|at| letters(text, at)));
    json!({ "name": place.name, "on": place.on, "numbers": numbers })
}

/// The letters before a byte, as JavaScript counts them.
fn letters(text: &str, at: usize) -> usize {
    text.get(..at).unwrap_or(text).encode_utf16().count()
}
