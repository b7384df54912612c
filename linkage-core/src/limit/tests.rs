use super::*;

mod against_exact;

const F64: Width = Width { epsilon: f64::EPSILON, smallest: 5e-324 };
/// `f32` widened, which is exact.
const F32: Width = Width { epsilon: f32::EPSILON as f64, smallest: 1.401298464324817e-45 };

/// 3-4-5 triangles whose sides are whole numbers of units in the last place of the longest:
/// from 2⁵⁰ on, the hypotenuse lies between 2⁵² and 2⁵³, where the unit is one. For single
/// precision 2²¹.
const TRIANGLES: [(f64, Width); 4] = [
    (1_125_899_906_842_624.0, F64),
    (1_234_567_890_123_457.0, F64),
    (2_097_152.0, F32),
    (2_345_679.0, F32),
];

/// The same answer; the missing distance comes from a quotient and a root, four roundings.
fn assert_reach(answer: Reach, expected: Reach) {
    match (answer, expected) {
        (Reach::Beyond(by), Reach::Beyond(expected)) => {
            assert!((by - expected).abs() <= 2.0 * f64::EPSILON * expected, "{by} {expected}");
        }
        _ => assert_eq!(answer, expected),
    }
}

#[test]
fn widths_are_those_of_the_scalars() {
    assert_eq!(F32.smallest, f64::from(f32::from_bits(1)));
    assert_eq!(F64.smallest, f64::from_bits(1));
}

#[test]
fn the_outer_toggle_gives_way_to_four_last_places() {
    for (t, width) in TRIANGLES {
        let span = 5.0 * t;
        for (first, direction) in [
            (2.0 * t, [1.0, 0.0]),
            (0.5 * span, [0.0, -1.0]),
            (span - 8.0, [0.6, 0.8]),
            (t, [-0.8, 0.6]),
        ] {
            let second = span - first;
            // The joints (ulps) further apart than the span, in whole numbers along axes; on a
            // slant the span is shortened instead.
            for (ulps, expected) in [
                (-5.0, Reach::Meets),
                (-1.0, Reach::Meets),
                (0.0, Reach::Meets),
                (1.0, Reach::AtLimit),
                (4.0, Reach::AtLimit),
                (5.0, Reach::Beyond(5.0)),
            ] {
                let slanted = direction[0] * direction[1] != 0.0;
                let d = if slanted {
                    [(direction[0] * 5.0_f64).round() * t, (direction[1] * 5.0_f64).round() * t]
                } else {
                    direction.map(|c| c * (span + ulps))
                };
                let lengths = if slanted { [first - ulps, second] } else { [first, second] };
                assert_reach(circles(d, lengths, width), expected);
                let lengths = [lengths[1], lengths[0]];
                assert_reach(circles(d, lengths, width), expected);
            }
        }
    }
}

#[test]
fn the_inner_toggle_gives_way_to_four_last_places() {
    for (t, width) in TRIANGLES {
        // The long bar is the longest length, and its unit in the last place is one.
        let (long, d, axis) = (6.0 * t, [3.0 * t, -4.0 * t], [5.0 * t, 0.0]);
        for (ulps, expected) in [
            (-4.0, Reach::Meets),
            (0.0, Reach::Meets),
            (1.0, Reach::AtLimit),
            (4.0, Reach::AtLimit),
            (5.0, Reach::Beyond(5.0)),
            (1000.0, Reach::Beyond(1000.0)),
        ] {
            // The short bar ends that much inside the circle of the long one.
            let short = long - 5.0 * t - ulps;
            for d in [d, axis, [0.0, -5.0 * t]] {
                assert_reach(circles(d, [long, short], width), expected);
                assert_reach(circles(d, [short, long], width), expected);
            }
        }
    }
}

#[test]
fn a_line_gives_way_to_four_last_places() {
    for (t, width) in TRIANGLES {
        let l = 5.0 * t;
        for (ulps, expected) in [
            (-1.0, Reach::Meets),
            (0.0, Reach::Meets),
            (1.0, Reach::AtLimit),
            (4.0, Reach::AtLimit),
            (5.0, Reach::Beyond(5.0)),
        ] {
            assert_reach(line(l + ulps, l, width), expected);
            assert_reach(line(-l - ulps, l, width), expected);
        }
    }
}

#[test]
fn an_offset_gives_way_to_four_last_places() {
    for (t, width) in TRIANGLES {
        for (ulps, expected) in [
            (-1.0, Reach::Meets),
            (0.0, Reach::Meets),
            (1.0, Reach::AtLimit),
            (4.0, Reach::AtLimit),
            (5.0, Reach::Beyond(5.0)),
        ] {
            for d in [[3.0 * t, 4.0 * t], [-4.0 * t, 3.0 * t], [0.0, 5.0 * t], [-5.0 * t, 0.0]] {
                assert_reach(offset(d, 5.0 * t + ulps, width), expected);
                assert_reach(offset(d, -5.0 * t - ulps, width), expected);
            }
        }
    }
}

/// Any direction: the decision agrees with whole numbers of 128 bits.
#[test]
fn slanted_limits_are_decided_exactly() {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 12) as i128
    };
    let (mut refused, mut at_limit) = (0, 0);
    for _ in 0..2000 {
        let (x, y) = (random(), random());
        let square = x * x + y * y;
        let d = (square as f64).sqrt() as i128;
        if !(1 << 52..1 << 53).contains(&d) {
            continue;
        }
        let l1 = d / 2 + random() % (d / 4);
        for short in -1..7 {
            // At 4, half of the distances are within reach and half are not.
            let span = d - short;
            let allowed = square <= (span + 4) * (span + 4);
            let meets = square <= span * span;
            let answer = circles([x as f64, -y as f64], [l1 as f64, (span - l1) as f64], F64);
            match answer {
                Reach::Meets => assert!(meets),
                Reach::AtLimit => assert!(allowed && !meets),
                Reach::Beyond(by) => {
                    assert!(!allowed);
                    // The distance is between d − 1 and d + 1, after a rounding of d.
                    assert!((by - short as f64).abs() <= 1.0, "{by} {short}");
                }
                _ => panic!("{answer:?}"),
            }
            refused += u32::from(matches!(answer, Reach::Beyond(_)) && short == 4);
            at_limit += u32::from(answer == Reach::AtLimit && short == 4);
        }
    }
    assert!(refused > 100 && at_limit > 100, "{refused} {at_limit}");
}

#[test]
fn squares_may_leave_the_range() {
    // The 3-4-5 triangle with its sides scaled by a power of two, up to the ends of the range.
    for exponent in [-1020, -600, 600, 1020] {
        let [t, ulp] = [1.0, f64::EPSILON * 4.0].map(|x| x * 2f64.powi(exponent));
        let d = [3.0 * t, 4.0 * t];
        assert_eq!(circles(d, [2.0 * t, 3.0 * t], F64), Reach::Meets);
        assert_eq!(circles(d, [2.0 * t, 3.0 * t - ulp], F64), Reach::AtLimit);
        assert_eq!(circles(d, [2.0 * t, 3.0 * t - 4.0 * ulp], F64), Reach::AtLimit);
        let beyond = Reach::Beyond(5.0 * ulp);
        assert_reach(circles(d, [2.0 * t, 3.0 * t - 5.0 * ulp], F64), beyond);
        assert_reach(offset(d, 5.0 * t + 5.0 * ulp, F64), beyond);
        assert_reach(line(5.0 * t + 5.0 * ulp, 5.0 * t, F64), beyond);
    }
    assert_eq!(circles([1e200, 0.0], [1e200, 1e200], F64), Reach::Meets);
    assert_eq!(circles([f64::MAX, f64::MAX], [1.0, 1.0], F64), Reach::Beyond(f64::MAX));
    assert_eq!(circles([f64::MAX, 0.0], [f64::MAX, f64::MAX], F64), Reach::Meets);
    // Among subnormal numbers the unit in the last place is the smallest number.
    let tiny = f64::from_bits(1);
    assert_eq!(circles([14.0 * tiny, 0.0], [4.0 * tiny, 6.0 * tiny], F64), Reach::AtLimit);
    assert_eq!(
        circles([15.0 * tiny, 0.0], [4.0 * tiny, 6.0 * tiny], F64),
        Reach::Beyond(5.0 * tiny)
    );
}

#[test]
fn coincident_centres_are_told_apart_from_unequal_radii() {
    assert_eq!(circles([0.0, -0.0], [3.0, 4.0], F64), Reach::Beyond(1.0));
    assert_eq!(circles([0.0; 2], [3.0, 3.0], F64), Reach::Coincident);
    assert_eq!(circles([0.0; 2], [3.0, 3.0_f64.next_up()], F64), Reach::Coincident);
    assert_eq!(circles([0.0; 2], [0.0; 2], F64), Reach::Coincident);
    assert_eq!(offset([0.0; 2], 0.0, F64), Reach::Coincident);
    assert_eq!(offset([0.0; 2], -2.0, F64), Reach::Beyond(2.0));
    assert_eq!(line(0.0, 0.0, F64), Reach::Meets);
}

#[test]
fn signs_of_lengths_do_not_matter_and_no_number_has_no_reach() {
    assert_eq!(circles([8.0, 0.0], [-3.0, 4.0], F64), Reach::Beyond(1.0));
    assert_eq!(line(-2.0, -3.0, F64), Reach::Meets);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..4 {
            let mut n = [1.0; 4];
            n[place] = bad;
            assert_eq!(circles([n[0], n[1]], [n[2], n[3]], F64), Reach::NotFinite);
            assert_eq!(line(n[0], n[3], F64) == Reach::NotFinite, place % 3 == 0);
            assert_eq!(offset([n[0], n[1]], n[2], F64) == Reach::NotFinite, place < 3);
        }
    }
}
