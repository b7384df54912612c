//! Every answer against one that is made of exact sums alone, at a sample of the poses of `.ci/nightly`.

use super::*;
use crate::cases::cases;

/// The same question, every comparison without rounding.
fn exactly([dx, dy]: [f64; 2], [l1, l2]: [f64; 2], width: Width) -> Reach {
    let scale = Scale::of([dx, dy, l1, l2]).expect("finite");
    let [dx, dy, l1, l2] = [dx, dy, l1, l2].map(|x| scale.down(x).abs());
    let (long, short, d) = (l1.max(l2), l1.min(l2), distance([dx, dy]));
    let leading_bit = f64::from_bits(d.max(long).to_bits() & f64::INFINITY.to_bits());
    let slack = 4.0 * (leading_bit * width.epsilon).max(scale.down(width.smallest));
    let missing = excess_with([dx, dy], [long, short, 0.0]);
    let lacking = -excess_with([dx, dy], [long, -short, 0.0]);
    let is_near = exact_sum([long, -short, -slack]) <= 0.0
        || excess_with([dx, dy], [long, -short, -slack]) >= 0.0;
    if missing > 0.0 {
        match excess_with([dx, dy], [long, short, slack]) <= 0.0 {
            true => Reach::AtLimit,
            false => Reach::Beyond(scale.up(missing / (d + (long + short)))),
        }
    } else if lacking > 0.0 && !is_near {
        Reach::Beyond(scale.up(lacking / (d + (long - short))))
    } else if [dx, dy] == [0.0; 2] {
        Reach::Coincident
    } else if lacking > 0.0 {
        Reach::AtLimit
    } else {
        Reach::Meets
    }
}

struct Drawn(u64);

impl Drawn {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Bars of any ratio up to 2²⁰ and a distance next to a limit of theirs, by up to 10,000 last places
    /// in the one half and by up to all of it in the other; all of any size.
    fn pose(&mut self, width: Width) -> [[f64; 2]; 2] {
        let narrowed = |x: f64| if width.epsilon > 1e-10 { f64::from(x as f32) } else { x };
        let size = ((self.unit() - 0.5) * 60.0).exp2();
        let long = size * (1.0 + self.unit());
        let short = long * (-20.0 * self.unit() * self.unit()).exp2();
        let limit = if self.unit() < 0.5 { long + short } else { long - short };
        let off = 2.0 * self.unit() - 1.0;
        let off = if self.unit() < 0.5 { off } else { (off * 1e4).round() * width.epsilon };
        let (sin, cos) = (self.unit() * 7.0).sin_cos();
        let d = limit * (1.0 + off);
        let mut lengths = [long, short];
        if self.unit() < 0.5 {
            lengths.swap(0, 1);
        }
        [[d * cos, d * sin].map(narrowed), lengths.map(narrowed)]
    }
}

/// The kind is the same, and what is missing but for half a unit in the last place on top of the last of
/// five roundings: `excess` answers within one unit, and so does the exact sum.
fn every_answer_is_the_exact_one(poses: usize) {
    for width in [F64, F32] {
        let (mut drawn, mut kinds) = (Drawn(7), [0; 3]);
        for _ in 0..poses {
            let [d, lengths] = drawn.pose(width);
            let (found, exact) = (circles(d, lengths, width), exactly(d, lengths, width));
            kinds[match found {
                Reach::Meets => 0,
                Reach::AtLimit => 1,
                _ => 2,
            }] += 1;
            match (found, exact) {
                (Reach::Beyond(by), Reach::Beyond(exact)) => {
                    let ulps = (by - exact).abs() / (exact * f64::EPSILON);
                    assert!(ulps <= 2.0, "{d:?} {lengths:?}: {by:e} {exact:e}");
                }
                _ => assert_eq!(found, exact, "{d:?} {lengths:?}"),
            }
        }
        assert!(kinds.iter().all(|&count| count > poses / 10_000), "{kinds:?}");
    }
}

#[test]
fn next_to_a_limit_every_answer_is_the_exact_one() {
    every_answer_is_the_exact_one(cases(20_000, 100_000));
}

/// `cargo test --release -p linkage-core --lib limit -- --ignored`
#[test]
#[ignore = "takes a minute"]
fn ten_million_answers_are_the_exact_ones() {
    every_answer_is_the_exact_one(5_000_000);
}

/// The sign is the exact one and the last place off by no more than one, on either side of where two words
/// give way to exact sums.
#[test]
fn two_words_do_where_they_are_asked() {
    let (mut drawn, mut counts) = (Drawn(11), [0; 2]);
    let poses = cases(20_000, 100_000);
    for _ in 0..poses {
        let [[dx, dy], [a, b]] = drawn.pose(F64);
        let scale = Scale::of([dx, dy, a, b]).expect("finite");
        let [dx, dy, a, b] = [dx, dy, a, b].map(|x| scale.down(x).abs());
        for b in [b, -b] {
            let (found, exact) = (excess([dx, dy], [a, b]), excess_with([dx, dy], [a, b, 0.0]));
            assert_eq!(found.total_cmp(&0.0), exact.total_cmp(&0.0), "{dx} {dy} {a} {b}");
            assert!((found - exact).abs() <= f64::EPSILON * exact.abs(), "{found:e} {exact:e}");
            counts[usize::from(exact.abs() > TWO_WORDS)] += 1;
        }
    }
    assert!(counts.iter().all(|&count| count > poses / 100), "{counts:?}");
}
