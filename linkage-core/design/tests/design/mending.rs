//! Random machines that cannot be assembled over a turn are mended by the slopes of their clearances.

use std::f64::consts::TAU;

use linkage_core::mechanism;
use linkage_design::{Dual, free};

mechanism! {
    struct Four {
        input theta: angle;
        param a = 1m;
        param b = 3m;
        param c = 3m;
        param d = 4m;
        ground A(0, 0), D(d, 0);
        crank AB(A) -> B        { length: a, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (b, c), mode: left }
        output C;
    }
}

mechanism! {
    struct Six {
        input theta: angle;
        param b = 260mm;
        param c = 200mm;
        param d = 300mm;
        param ex = 150mm;
        param ey = 110mm;
        param gx = 150mm;
        param gy = 350mm;
        param link = 180mm;
        param lever = 140mm;
        ground A(0, 0), D(d, 0), G(gx, gy);
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (b, c), mode: left }
        point E on BC at (ex, ey);
        rrr   EF(E), GF(G) -> F { lengths: (link, lever), mode: right }
        output F;
    }
}

/// SplitMix64, seeded by the number of the machine, uniform between the ends of each range.
fn drawn<const N: usize>(seed: u64, ranges: [[f64; 2]; N]) -> [f64; N] {
    let mut state = seed;
    ranges.map(|[from, to]| {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let unit = (((z ^ (z >> 31)) >> 11) as f64 + 0.5) / (1_u64 << 53) as f64;
        from + (to - from) * unit
    })
}

fn turn(poses: i32) -> impl Iterator<Item = f64> + Clone {
    (0..poses).map(move |k| TAU * f64::from(k) / f64::from(poses))
}

/// Every machine, or every eighth without `LINKAGE_WHOLE`.
fn machines() -> impl Iterator<Item = u64> {
    let step = if std::env::var_os("LINKAGE_WHOLE").is_some() { 1 } else { 8 };
    (0..2000).step_by(step)
}

/// Counts machines that do not turn, and of these the mended ones.
fn counted(one: impl Fn(u64) -> Option<bool>) -> [usize; 2] {
    let looked: Vec<bool> = machines().filter_map(one).collect();
    [looked.len(), looked.iter().filter(|mended| **mended).count()]
}

#[test]
fn four_bars_are_mended() {
    const RANGES: [[f64; 2]; 4] = [[0.2, 3.0], [0.2, 5.0], [0.2, 5.0], [0.2, 5.0]];
    let [broken, mended] = counted(|seed| {
        let [a, b, c, d] = drawn(seed, RANGES);
        let found = free!(Four: a, b, c, d; of Four { a, b, c, d })
            .within(RANGES.map(|[from, to]| from..=to))
            .aim("turns", turn(12), |m, q| m.position(q.into()).map(|_| [Dual::from_re(0.0)]))
            .mended(turn(12))
            .run()
            .unwrap();
        (found.counts.mended + found.counts.redrawn > 0).then_some(found.counts.mended > 0)
    });
    println!("{mended} of {broken} four-bars mended");
    assert!(mended as f64 >= 0.99 * broken as f64, "{mended} of {broken}");
}

#[test]
fn six_bars_are_mended() {
    const RANGES: [[f64; 2]; 9] = [
        [0.12, 0.6],
        [0.1, 0.6],
        [0.12, 0.6],
        [-0.4, 0.6],
        [-0.4, 0.4],
        [-0.6, 0.9],
        [-0.6, 0.9],
        [0.05, 0.8],
        [0.05, 0.8],
    ];
    let [broken, mended] = counted(|seed| {
        let [b, c, d, ex, ey, gx, gy, link, lever] = drawn(seed, RANGES);
        let found = free!(Six: b, c, d, ex, ey, gx, gy, link, lever;
            of Six { b, c, d, ex, ey, gx, gy, link, lever })
        .within(RANGES.map(|[from, to]| from..=to))
        .aim("turns", turn(24), |m, q| m.position(q.into()).map(|_| [Dual::from_re(0.0)]))
        .mended(turn(24))
        .run()
        .unwrap();
        (found.counts.mended + found.counts.redrawn > 0).then_some(found.counts.mended > 0)
    });
    println!("{mended} of {broken} six-bars mended");
    assert!(mended as f64 >= 0.92 * broken as f64, "{mended} of {broken}");
}
