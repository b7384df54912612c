//! The query of an address: what stands behind its `?`, as PMKS+ wrote it.

use super::Mistake;
use super::today::DIGITS;

/// The characters that count an address: the digits of letters and numbers.
const COUNTED: usize = 62;
/// The digits of a digest.
const DIGEST: usize = 6;

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

/// The sections without what checks them behind: a character that counts them and, since 2026, a star and a digest of them.
/// Parameters that a mailer or a search engine hangs on the address, `&utm_source=…`, are none of it.
pub(super) fn counted(query: &str) -> Result<&str, Mistake> {
    if query.is_empty() {
        return Err("there is nothing behind `?`".into());
    }
    if query.starts_with("pmks2:") {
        return Err("the address holds a body document, `pmks2:`, which is not read: share the drawing by joints and links".into());
    }
    let shorter = query.rmatch_indices('&').map(|(at, _)| &query[..at]);
    let mut all = std::iter::once(query).chain(shorter);
    let cut = "the address is cut off or changed: its last character does not count its length";
    let (sections, is_changed) = all.find_map(without_count).ok_or(cut)?;
    match is_changed {
        true => Err("the address was changed on its way: what stands behind `*` is not the digest of the rest".into()),
        false => Ok(sections),
    }
}

/// The sections, and whether their digest is that of others.
fn without_count(query: &str) -> Option<(&str, bool)> {
    let (counted, told) = match query.rsplit_once('*') {
        Some((counted, told)) if told.len() == DIGEST => (counted, Some(told)),
        _ => (query, None),
    };
    let (at, last) = counted.char_indices().last()?;
    let sections = &counted[..at];
    // JavaScript counts in units of UTF-16.
    let is_counted = DIGITS.find(last)? == sections.encode_utf16().count() % COUNTED;
    is_counted.then(|| (sections, told.is_some_and(|told| told != digest(counted))))
}

/// The hash FNV-1a of 32 bits over units of UTF-16, in six digits.
fn digest(text: &str) -> String {
    let step = |hash: u32, unit: u16| (hash ^ u32::from(unit)).wrapping_mul(0x0100_0193);
    let mut hash = text.encode_utf16().fold(0x811c_9dc5, step) as usize;
    let mut digits = [0; DIGEST];
    for digit in digits.iter_mut().rev() {
        *digit = DIGITS.as_bytes()[hash % COUNTED];
        hash /= COUNTED;
    }
    digits.map(char::from).iter().collect()
}
