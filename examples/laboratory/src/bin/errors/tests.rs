//! The measured quantity is an error, in the promised units.

use linkage_core::SolveError;
use linkage_tests::measured::Width;
use linkage_tests::measured::poses::Source;

use crate::measure::measure;
use crate::poses::{self, Place, Pose};
use crate::twins::{Answer, Twin, WAYS, Way, all};

const WIDTHS: [Width; 2] = [Width::Double, Width::Single];

fn twin(name: &str) -> Twin {
    all().into_iter().find(|twin| twin.name == name).expect("it is in the table")
}

/// A four-bar's pose far from its limits.
fn pose() -> Pose {
    Pose { place: Place::Anywhere, q: vec![1.0], rate: vec![0.75], second: vec![0.5] }
}

fn too_narrow([q, rate, second]: [&[f64]; 3]) -> Answer<f64> {
    let narrow = |list: &[f64]| list.iter().map(|&x| x as f32).collect::<Vec<_>>();
    let lists = [q, rate, second].map(narrow);
    let rows = (twin("twin_01").single[0].motion)(lists.each_ref().map(|list| &list[..]))?;
    Ok(rows.into_iter().map(f64::from).collect())
}

/// An answer in f32 has some units of f32, of which each is 2^29 of f64.
#[test]
fn an_answer_of_the_other_width_is_off_by_the_ratio_of_both() {
    let mut twin = twin("twin_01");
    twin.double[1] = Way { motion: too_narrow, ..twin.double[1] };
    let [right, narrow] =
        measure(&twin, &pose(), Width::Double).errors.map(|errors| errors.expect("it is solved"));
    for (right, narrow) in right.into_iter().zip(narrow) {
        assert!(right < 4.0, "{right}");
        let single = narrow / 2_f64.powi(29);
        assert!((0.01..4.0).contains(&single), "{single}");
    }
}

/// One way refuses what the other solves, in the middle of its range: the data decide that.
#[test]
fn a_refusal_of_one_way_is_told() {
    let mut twin = twin("twin_01");
    assert!(!measure(&twin, &pose(), Width::Double).is_decided);
    let singular = SolveError::Singular { group: "BC, DC" };
    twin.double[1].position = |_| Err(SolveError::Singular { group: "BC, DC" });
    let sample = measure(&twin, &pose(), Width::Double);
    assert_eq!(sample.refusals, [[None, Some(singular)], [None, None]]);
    assert!(sample.is_decided);
}

/// Every mechanism is measured in both widths and with either kind of dimensions, those with limits next to them
/// too, and both kinds are of the same dimensions.
#[test]
fn every_mechanism_is_measured() {
    let twins = all();
    for (width, twin) in
        WIDTHS.into_iter().flat_map(|width| twins.iter().map(move |twin| (width, twin)))
    {
        let mut source = Source::new(3);
        let mut measured = [0; WAYS.len()];
        for _ in 0..200 {
            let pose = poses::draw(twin, &mut source, width);
            let errors = measure(twin, &pose, width).errors;
            // A dimension that differs by a thousandth is thousands of units of either width.
            let is_right = errors.iter().flatten().all(|[position, ..]| *position < 100.0);
            assert!(is_right, "{} {pose:?}: {errors:?}", twin.name);
            measured
                .iter_mut()
                .zip(errors)
                .for_each(|(count, errors)| *count += usize::from(errors.is_some()));
        }
        assert!(measured.iter().all(|&count| count > 10), "{} {measured:?}", twin.name);
    }
}
