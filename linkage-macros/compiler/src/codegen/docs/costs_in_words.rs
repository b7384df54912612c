//! The cost of a solver in words.

use crate::ir::cost::Operations;

/// The most evaluations between two ends, in double and in single precision, as the run-time crate
/// bounds them.
pub const MOST: [u32; 2] = [61, 32];

/// `20 additions, 31 multiplications and 1 square root`; `no operation` where it is free.
pub fn in_words(cost: Operations) -> String {
    let counts = [
        (cost.additions, "addition"),
        (cost.multiplications, "multiplication"),
        (cost.divisions, "division"),
        (cost.roots, "square root"),
        (cost.sines, "sine-cosine pair"),
    ];
    let words: Vec<String> = counts
        .iter()
        .filter(|(count, _)| *count > 0)
        .map(|(count, word)| match count {
            1 => format!("1 {word}"),
            _ => format!("{count} {word}s"),
        })
        .collect();
    match &words[..] {
        [] => "no operation".to_string(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
