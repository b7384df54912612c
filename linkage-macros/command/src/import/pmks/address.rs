//! The query of an address: what stands behind its `?`, as PMKS+ wrote it.

use super::Mistake;
use super::today::DIGITS;

/// The characters that count an address: the digits of letters and numbers.
const COUNTED: usize = 62;

/// The query without a fragment, with `%2C` and its like as the characters that they stand for.
pub(super) fn query(address: &str) -> String {
    let query = address.split_once('?').map_or("", |(_, query)| query);
    let query = query.split('#').next().unwrap_or_default();
    decoded(query)
}

fn decoded(text: &str) -> String {
    let mut bytes = Vec::new();
    let mut rest = text.as_bytes();
    while let [first, behind @ ..] = rest {
        let digit = |at: usize| behind.get(at).and_then(|&digit| (digit as char).to_digit(16));
        match (first, digit(0), digit(1)) {
            (b'%', Some(high), Some(low)) => {
                bytes.push((16 * high + low) as u8);
                rest = &behind[2..];
            }
            _ => {
                bytes.push(*first);
                rest = behind;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The sections without the character behind them, which counts the others, and without a star and what PMKS+ made of them
/// to find changes. Parameters that a mailer or a search engine
/// hangs on the address, `&utm_source=…`, are none of it.
pub(super) fn counted(query: &str) -> Result<&str, Mistake> {
    if query.is_empty() {
        return Err("there is nothing behind `?`".into());
    }
    let shorter = query.rmatch_indices('&').map(|(at, _)| &query[..at]);
    let mut all = std::iter::once(query).chain(shorter);
    let cut = "the address is cut off or changed: its last character does not count its length";
    all.find_map(without_count).ok_or_else(|| cut.into())
}

fn without_count(query: &str) -> Option<&str> {
    let query = query.rsplit_once('*').map_or(query, |(counted, _)| counted);
    let (at, last) = query.char_indices().last()?;
    let sections = &query[..at];
    // JavaScript counts in units of UTF-16.
    (DIGITS.find(last)? == sections.encode_utf16().count() % COUNTED).then_some(sections)
}
