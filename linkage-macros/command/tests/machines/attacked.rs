//! Texts that are no machine: changed, cut off or made up. Whatever comes in, the program prints a declaration or
//! says what is wrong.

use crate::program::{drives_of, fixture, fixtures, given_or_ended};

/// A generator of numbers by Marsaglia's xorshift.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count.max(1) as u64) as usize
    }
}

/// Pieces that the formats are made of, and such that are in none of them.
const PIECES: &[&str] = &[
    "M[",
    "J[",
    "R",
    "P",
    "RP",
    "L[",
    "A[",
    "]",
    "[",
    ",",
    ".",
    "..",
    "?",
    "{",
    "}",
    "\"",
    ":",
    "0",
    "-1",
    "1e999",
    "NaN",
    "ground",
    "#",
    "Y",
    "N",
    "Fe",
    "_",
    "-",
    "é",
    "∞",
    "\u{301}",
    " ",
    "\n",
    "null",
    "\"joints\"",
    "\"links\"",
    "\"id\"",
    "18446744073709551616",
    "color[",
    "\0",
    "zzzzzzzzzzzzzzzzzzzz",
];

/// The character that counts an address, so that what is behind it is read.
fn counted(text: &str) -> String {
    const DIGITS: &[u8] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    let Some((front, query)) = text.split_once('?') else { return text.to_string() };
    let Some((last, _)) = query.char_indices().last() else { return text.to_string() };
    let query = &query[..last];
    format!("{front}?{query}{}", DIGITS[query.encode_utf16().count() % 62] as char)
}

/// The text with one place changed: cut off, a piece put in, a piece taken out, or two characters exchanged.
fn changed(text: &str, random: &mut Random) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    let at = random.below(characters.len());
    match random.below(4) {
        0 => characters.truncate(at),
        1 => {
            let piece = PIECES[random.below(PIECES.len())];
            characters.splice(at..at, piece.chars());
        }
        2 => {
            let end = (at + 1 + random.below(12)).min(characters.len());
            characters.drain(at..end);
        }
        _ => {
            let other = random.below(characters.len());
            characters.swap(at, other);
        }
    }
    characters.into_iter().collect()
}

/// Checks that the program ended by itself, with a declaration or with one sentence.
fn answers(text: &str, drives: &[&str]) -> bool {
    let (code, printed, told) = given_or_ended(text, drives);
    match code {
        Some(0) => {
            assert!(printed.starts_with("mechanism! {") && told.is_empty(), "{text:?}\n{told}")
        }
        Some(1) => {
            let is_told = told.starts_with("error: ") && told.trim().len() > 12;
            assert!(is_told && printed.is_empty(), "{text:?}\n{told}");
        }
        code => panic!("{code:?} for {text:?}\n{told}"),
    }
    code == Some(0)
}

#[test]
fn changed_machines_are_read_or_refused() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut read, mut refused) = (0, 0);
    for name in fixtures() {
        let whole = std::fs::read_to_string(fixture(&name)).expect("it is there");
        for _ in 0..12 {
            let mut text = whole.clone();
            for _ in 0..1 + random.below(3) {
                text = changed(&text, &mut random);
            }
            if name.starts_with("pmks") && random.below(4) > 0 {
                text = counted(text.trim());
            }
            match answers(&text, &drives_of(&whole)) {
                true => read += 1,
                false => refused += 1,
            }
        }
    }
    println!("{read} read, {refused} refused");
    assert!(read > 30 && refused > 150, "{read} {refused}");
}

#[test]
fn texts_of_pieces_are_read_or_refused() {
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    for start in ["", "M[", "{", "x?", "M[J[R, P[0, 0], L[", "{\"joints\": [", "x?2P.Fe.K,0.1011."]
    {
        for _ in 0..20 {
            let mut text = start.to_string();
            for _ in 0..random.below(30) {
                text.push_str(PIECES[random.below(PIECES.len())]);
            }
            answers(&counted(&text), &[]);
        }
    }
}

/// Every beginning of a machine of each format.
#[test]
fn machines_that_are_cut_off_are_refused() {
    for (name, step) in [
        ("pmks/slotted_coupler.txt", 7),
        ("pyslvs/whitworth.txt", 9),
        ("pylinkage/watt_1.json", 61),
    ] {
        let whole = std::fs::read_to_string(fixture(name)).expect("it is there");
        let whole = whole.trim();
        let drives = drives_of(whole);
        for end in (0..whole.len()).step_by(step) {
            assert!(!answers(&whole[..end], &drives), "{name} to {end}");
        }
        // Counted anew, an address that lacks its last links may be a smaller machine.
        (0..whole.len())
            .step_by(step)
            .for_each(|end| _ = answers(&counted(&whole[..end]), &drives));
    }
}
