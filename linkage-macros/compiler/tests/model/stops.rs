//! Stops: what they stop, and their ends and fields.

use super::*;

#[test]
fn a_stop_pushes_on_links_or_points() {
    const REFUSED: &str = "a stop cannot push on this / it is of a link's `angle`, a sum of links' angles, a \
                           `slide` or a `distance(P, Q)`; of an input, name its link: `stop AB.angle between …`";
    for stopped in ["AB.angle", "2 * AB.angle - BC.angle"] {
        let stop = format!("stop {stopped} between (0, 1) {{ stiffness: 5(N*m) }}");
        check(&[(SIX_BAR, &stop, "")]);
    }
    for stopped in ["block.slide", "distance(B, D)"] {
        let stop = format!("stop {stopped} between (0.2m, 0.3m) {{ stiffness: 5(N/m) }}");
        check(&[(SIX_BAR, &stop, "")]);
    }
    for (stopped, end) in [("E.x", "0.3m"), ("t", "1")] {
        let stop = format!("stop {stopped} between (0, {end}) {{ stiffness: 5 }}");
        check(&[(SIX_BAR, &stop, &format!("{stopped}: {REFUSED}"))]);
    }
}

#[test]
fn the_ends_of_a_stop_are_fixed_and_in_order() {
    const METRES: &str = "a length where an angle belongs / write";
    check(&[
        (
            SIX_BAR,
            "stop block.slide between (0.2m, 1m * t) { stiffness: 5(N/m) }",
            "t: an end of a stop cannot depend on an input / it is made of constants and parameters",
        ),
        (
            SIX_BAR,
            "stop block.slide between (0.3m, 0.2m) { stiffness: 5(N/m) }",
            "0.2m: the second end of a stop lies above the first / the motion is free between them: \
             `between (0.2m, 0.3m)`",
        ),
        (
            SIX_BAR,
            "stop BC.angle between (0.2m, 0.3m) { stiffness: 5(N/m) }",
            &format!(
                "0.2m: {METRES} `0.2deg`\n0.3m: {METRES} `0.3deg`\n5(N/m): a force over a length (N/m) where a torque \
                 belongs / write `5(N*m)`"
            ),
        ),
    ]);
}

#[test]
fn a_stop_has_a_stiffness_a_force_and_a_gap() {
    check(&[
        (
            SIX_BAR,
            "stop block.slide between (0.2m, 0.3m) { damping: 20(N*s/m) }",
            "}: missing field `stiffness` / the force or couple over the way beyond an end, \
             `2e4(N*m/rad)`",
        ),
        (
            SIX_BAR,
            "stop end block.slide between (0.2m, 0.3m) { stiffness: 5(N/m) } output end.torque;",
            "torque: the stop `end` has no `torque` / it has `force` and `gap`",
        ),
    ]);
}
