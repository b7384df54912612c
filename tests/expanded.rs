//! `examples/four_bar_expanded.rs` computes what `examples/four_bar.rs` does, to the last bit.

#[allow(dead_code, unreachable_pub, reason = "only the declaration is used")]
#[path = "../examples/four_bar.rs"]
mod declared;

#[allow(dead_code, unreachable_pub, reason = "only the solver is used")]
#[path = "../examples/four_bar_expanded.rs"]
mod expanded;

#[test]
fn both_four_bars_agree_to_the_last_bit() {
    let (ours, theirs) = (declared::FourBar::new(), expanded::FourBar::new());
    let (ours_f32, theirs_f32) = (ours.lift::<f32>(), theirs.lift::<f32>());
    for step in 0..1000 {
        let theta = f64::from(step) * 0.0123;
        let (a, b) = (ours.motion(theta, 7.0, -3.0), theirs.motion(theta, 7.0, -3.0));
        // The text of a number is that of no other.
        assert_eq!(format!("{a:?}"), format!("{b:?}"));
        assert!(a.is_ok(), "{a:?}");
        let theta = theta as f32;
        let (a, b) = (ours_f32.motion(theta, 7.0, -3.0), theirs_f32.motion(theta, 7.0, -3.0));
        assert_eq!(format!("{a:?}"), format!("{b:?}"));
    }
}
