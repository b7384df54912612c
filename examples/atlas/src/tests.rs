//! The measure's invariances, the search, and files that are no paths.

use std::f64::consts::{PI, TAU};

use linkage_core::Side;

use crate::drawn_path::{DrawnPath, PathError};
use crate::four_bar::{Dimensions, Tracer};
use crate::grid::{self, Grid};
use crate::progress::Progress;
use crate::search;
use crate::shape::{Complex, Describer, Descriptor};

/// Rounding of a few hundred sums, magnified by the curve's size over the shift's step: far below what tells
/// neighbours of the grid apart, far above 2⁻⁵³.
const NOTHING: f64 = 1e-9;

type Curve = (Vec<f64>, Vec<f64>);

fn traced(dimensions: &Dimensions, poses: u32) -> Curve {
    let mut tracer = Tracer::new(poses);
    assert_eq!(tracer.trace(dimensions), Ok(true), "{dimensions:?}");
    (tracer.x, tracer.y)
}

fn described((x, y): &Curve) -> Descriptor {
    Describer::default().describe(x, y).expect("it has a size")
}

fn mapped((x, y): &Curve, to: impl Fn(f64, f64) -> [f64; 2]) -> Curve {
    x.iter().zip(y).map(|(&x, &y)| to(x, y)).map(|[x, y]| (x, y)).unzip()
}

/// A curve of no symmetry.
const BEAN: Dimensions = Dimensions {
    coupler: 3.0,
    follower: 3.5,
    base: 2.0,
    along: 2.2,
    across: 1.1,
    branch: Side::Left,
};

#[test]
fn the_atlas_has_the_curves_that_its_module_says() {
    let atlas = grid::atlas();
    assert_eq!((atlas.linkages.len(), atlas.count()), (156, 7800));
    assert_eq!(Grid::TEN_MILLION.candidates().count(), 10_086_300);
    // By the links' lengths alone: Grashof's rule, and the crank the shortest.
    for [a, b, c] in &atlas.linkages {
        let longest = a.max(*b).max(*c);
        assert!(1.0 + longest <= a + b + c - longest + 1e-12, "{a} {b} {c}");
    }
}

#[test]
fn every_pose_of_the_atlas_keeps_the_lengths_of_its_links() {
    let atlas = grid::atlas();
    for &lengths in &atlas.linkages {
        for &point in &[atlas.points[0], atlas.points[27]] {
            let dimensions = grid::curve(lengths, point);
            let Dimensions { coupler, follower, base, along, across, .. } = dimensions;
            let four_bar = dimensions.four_bar();
            for k in 0..72 {
                let pose = four_bar.position(TAU * f64::from(k) / 72.0).expect("the crank turns");
                let distance = |x: f64, y: f64| (x * x + y * y).sqrt();
                let (b, c, p) = (pose.B, pose.C, pose.P);
                let found = [
                    distance(b.x, b.y),
                    distance(c.x - b.x, c.y - b.y),
                    distance(c.x - base, c.y),
                    distance(p.x - b.x, p.y - b.y),
                ];
                let wanted = [1.0, coupler, follower, distance(along, across)];
                for (found, wanted) in found.iter().zip(wanted) {
                    // At a change point the root of a rounding, √(16 ε) times the lengths.
                    assert!((found - wanted).abs() < 3e-7, "{dimensions:?} at {k}: {found}");
                }
            }
        }
    }
}

#[test]
fn a_square_has_the_coefficients_of_its_symmetry() {
    // A quarter of a turn multiplies z(t) by i, so that all cₖ but those of k = 4n + 1 are 0; these are
    // 8/(π²k²), by two integrations by parts. Corners that are none, and a corner twice, change nothing.
    let square = (vec![1.0, 0.0, 0.0, -0.3, -1.0, 0.0], vec![0.0, 1.0, 1.0, 0.7, 0.0, -1.0]);
    let square = described(&square);
    for k in (-12..=12).filter(|&k| k != 0) {
        let size = if (k - 1) % 4 == 0 { 8.0 / (PI * f64::from(k)).powi(2) } else { 0.0 };
        let found = square.coefficient(k).expect("twelve on each side");
        let off = found - Complex { re: size, im: 0.0 };
        // A handful of roundings of numbers below 2.
        assert!(off.square().sqrt() < 1e-14, "{k}: {found:?}");
    }
    assert_eq!((square.coefficient(0), square.coefficient(13)), (None, None));
}

#[test]
fn a_curve_moved_turned_scaled_shifted_reversed_and_mirrored_is_itself() {
    let curve = traced(&BEAN, 64);
    let path = described(&curve);
    for (angle, scale, shift, reversed, mirrored) in [
        (0.0, 1.0, 0, false, false),
        (1.0, 1.0, 0, false, false),
        (0.0, 37.0, 0, false, false),
        (0.0, 1.0, 13, false, false),
        (0.0, 1.0, 0, true, false),
        (0.0, 1.0, 0, false, true),
        (-2.6, 1e-3, 41, true, true),
    ] {
        let turn = Complex::turn(angle);
        let move_it = |x: f64, y: f64| {
            let z =
                turn * Complex { re: scale * x, im: if mirrored { -scale * y } else { scale * y } };
            [z.re + 5.0 * scale, z.im - 3.0 * scale]
        };
        let mut moved = mapped(&curve, move_it);
        moved.0.rotate_left(shift);
        moved.1.rotate_left(shift);
        if reversed {
            moved.0.reverse();
            moved.1.reverse();
        }
        let other = described(&moved);
        let (distance, placement) = other.distance(&path);
        assert!(distance < NOTHING, "{angle} {scale} {shift} {reversed} {mirrored}: {distance}");
        assert!(other.bound(&path) <= distance + NOTHING);
        // And it is laid onto itself, point by point.
        for (&x, &y) in curve.0.iter().zip(&curve.1) {
            let ([px, py], [qx, qy]) = (placement.place([x, y]), move_it(x, y));
            assert!((px - qx).hypot(py - qy) < 1e-8 * scale, "{placement:?}");
        }
    }
}

#[test]
fn the_distance_is_the_mean_between_the_curves_laid_onto_each_other() {
    // An ellipse of half-axes 1 + e and 1 − e is e^{it} + e·e^{−it}. Along it t = s + e/2·sin 2s, but for e², so
    // that it is e^{is} + 3e/4·e^{−is} + e/4·e^{3is}: from the circle it is apart by e·√(9 + 1)/4.
    let ellipse = |e: f64| -> Curve {
        (0..720)
            .map(|k| TAU * f64::from(k) / 720.0)
            .map(|t| ((1.0 + e) * t.cos(), (1.0 - e) * t.sin()))
            .unzip()
    };
    let circle = described(&ellipse(0.0));
    for e in [0.01, 0.03] {
        let (distance, _) = circle.distance(&described(&ellipse(e)));
        let expected = e * 10.0_f64.sqrt() / 4.0;
        // The neglected terms are of the order of e², and so is the error of 720 corners.
        assert!((distance - expected).abs() < e * e, "{e}: {distance}");
    }
}

#[test]
fn no_distance_is_below_its_bound() {
    let candidates = grid::atlas();
    let path = described(&traced(&BEAN, 64));
    for &lengths in candidates.linkages.iter().step_by(13) {
        for &point in candidates.points.iter().step_by(7) {
            let other = described(&traced(&grid::curve(lengths, point), 64));
            let (bound, (distance, _)) = (path.bound(&other), path.distance(&other));
            assert!(bound <= distance + 1e-12 && distance <= 2.0_f64.sqrt() + 1e-12);
        }
    }
}

#[test]
fn a_curve_of_the_atlas_is_found_again() {
    let mut atlas = grid::atlas();
    atlas.linkages = atlas.linkages.into_iter().skip(60).take(20).collect();
    let (lengths, point) = (atlas.linkages[7], atlas.points[33]);
    let wanted = grid::curve(lengths, point);
    // As the mirrored four-bar draws it, turned by a radian, an eighth as large and begun elsewhere.
    let curve = traced(&wanted.mirrored(), search::FINE_POSES);
    let turn = Complex::turn(1.0);
    let mut drawn = mapped(&curve, |x, y| {
        let z = turn * Complex { re: x / 8.0, im: y / 8.0 };
        [z.re + 2.0, z.im]
    });
    drawn.0.rotate_left(100);
    drawn.1.rotate_left(100);
    let found = search::nearest(&described(&drawn), &atlas, 15, &Progress::silent());
    let found = found.expect("slices of one length");
    assert_eq!(found.len(), 15);
    let first = &found[0];
    assert_eq!(first.dimensions, wanted);
    assert!(first.distance < NOTHING, "{}", first.distance);
    assert!(first.placement.is_mirrored());
    assert!((first.placement.scale() - 0.125).abs() < NOTHING, "{:?}", first.placement);
    // The next one is a neighbour of the grid, or a curve that is mirrored in itself, not this one again.
    assert!(found[1].distance > 1e-3, "{:?}", found[1]);
    let designs = search::designs(&found, 2);
    assert!(designs.len() == 2 && designs[0].dimensions == wanted);
}

#[test]
fn the_list_is_that_of_a_comparison_of_all_with_all() {
    let mut few = grid::atlas();
    few.linkages.truncate(12);
    let path = described(&traced(&BEAN, search::FINE_POSES));
    let all = 0..few.linkages.len();
    let found = search::short_list(&path, &few, all, 8, &Progress::silent());
    let found = found.expect("slices of one length");
    // Every linkage by the nearest of its curves, the first of the grid where two are as near.
    let mut nearest: Vec<(f64, usize)> = Vec::new();
    for linkage in 0..few.linkages.len() {
        let of_linkage = (0..few.points.len()).map(|nth| {
            let candidate = linkage * few.points.len() + nth;
            let dimensions = few.dimensions(candidate).expect("it is one");
            (path.distance(&described(&traced(&dimensions, search::POSES))).0, candidate)
        });
        nearest.extend(of_linkage.min_by(|one, two| one.0.total_cmp(&two.0)));
    }
    nearest.sort_by(|one, two| one.0.total_cmp(&two.0));
    let found: Vec<(f64, usize)> = found.iter().map(|one| (one.distance, one.candidate)).collect();
    assert_eq!(found, nearest[..8]);
}

#[test]
fn what_is_no_path_is_refused_in_words() {
    let refused = |text: &str| DrawnPath::parse(text).expect_err("it is no path");
    assert_eq!(refused("0 0\n1 0 # a comment\n"), PathError::TooFew { points: 2 });
    assert_eq!(refused("1 1\n1 1\n1 1"), PathError::NoSize);
    assert_eq!(refused("0 0\n1e300 0\n0 1"), PathError::NoSize);
    for (text, line) in [("0 0\n1\n", 2), ("0 0\n\n1 x\n", 3), ("0 nan", 1), ("0 0\n1 2 3", 2)] {
        let error = refused(text);
        assert!(matches!(error, PathError::NotAPoint { line: found, .. } if found == line));
        assert!(error.to_string().contains("write its x and its y"), "{error}");
    }
    let missing = DrawnPath::read("no/such/file.txt".as_ref()).expect_err("there is none");
    assert!(missing.to_string().starts_with("`no/such/file.txt` cannot be read: "), "{missing}");
    let path = DrawnPath::parse("0, 0\n1;0\n\n# nothing\n 0.5 1e0").expect("three points");
    assert_eq!(path.closed(), [(0.0, 0.0), (1.0, 0.0), (0.5, 1.0), (0.0, 0.0)]);
}

#[test]
fn the_committed_paths_are_paths() {
    for (text, points) in [
        (include_str!("../paths/step.txt"), 21),
        (include_str!("../paths/line.txt"), 40),
        (include_str!("../paths/eight.txt"), 72),
        (include_str!("../paths/d.txt"), 64),
    ] {
        let path = DrawnPath::parse(text).expect("it is drawn");
        assert_eq!(path.x.len(), points);
        assert!(Describer::default().describe(&path.x, &path.y).is_some());
    }
}
