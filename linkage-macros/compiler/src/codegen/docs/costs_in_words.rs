//! The cost of a solver in words.

use crate::ir::cost::Operations;

/// The most evaluations between two ends, in double and in single precision, as the run-time crate
/// bounds them.
pub(crate) const MOST: [u32; 2] = [61, 32];

/// `20 additions, 31 multiplications and 1 square root`; `no operation` where it is free.
pub(crate) fn in_words(cost: Operations) -> String {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn searches_take_as_many_evaluations_as_at_run_time() {
        use linkage_core::find::Search;
        assert_eq!(MOST, [Search::<f64>::MOST, Search::<f32>::MOST]);
    }

    #[test]
    fn a_cost_reads_as_a_sentence() {
        let none = Operations::default();
        assert_eq!(in_words(none), "no operation");
        assert_eq!(in_words(Operations { divisions: 1, ..none }), "1 division");
        let several = Operations { additions: 2, multiplications: 1, roots: 3, ..none };
        assert_eq!(in_words(several), "2 additions, 1 multiplication and 3 square roots");
    }
}
