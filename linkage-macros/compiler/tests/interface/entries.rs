//! Tests of `interface/entries`.

pub(crate) use linkage_compiler::interface::entries::*;

#[test]
fn no_two_entry_points_have_one_name() {
    let points = Analysis::all().flat_map(|analysis| {
        let [own, at] = [false, true].map(|by_cosine| EntryPoint { analysis, by_cosine }.name());
        [Some(own), Some(at).filter(|&at| at != own)]
    });
    let mut names: Vec<&str> = points.flatten().collect();
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!((names.len(), count), (17, 17), "{names:?}");
}
