//! A crate whose compilation measures a machine: what a step takes is told in multiples of it, so that a slow or a busy
//! machine changes little. It never changes, or all that is stored in `steps.txt` does.
#![allow(missing_docs)]

use std::collections::BTreeMap;

macro_rules! functions {
    ($($name:ident: $kind:ty = $factor:literal;)*) => { $(
        pub fn $name(numbers: &[$kind]) -> Vec<(String, $kind)> {
            let mut found = BTreeMap::new();
            for (index, pair) in numbers.windows(2).enumerate() {
                let key = format!("{}:{index}", stringify!($name));
                let value = (pair[0] as f64 * $factor).hypot(pair[1] as f64) as $kind;
                found.entry(key).or_insert_with(Vec::new).push(value);
            }
            let mut sums: Vec<_> = found
                .into_iter()
                .map(|(key, values)| (key, values.iter().rev().zip(&values).map(|(a, b)| a * b).sum()))
                .collect();
            sums.sort_by(|(a, _), (b, _)| a.len().cmp(&b.len()).then_with(|| b.cmp(a)));
            sums.dedup_by(|(a, _), (b, _)| a.chars().eq(b.chars()));
            sums
        }
    )* };
}

functions! {
    a: f64 = 1.0; b: f32 = 2.0; c: i64 = 3.0; d: i32 = 4.0; e: u64 = 5.0; f: u32 = 6.0;
    g: i16 = 7.0; h: u16 = 8.0; i: i128 = 9.0; j: u128 = 10.0;
}
