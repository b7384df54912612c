//! Assembly modes as parameters: changing one at run time gives the other assembly of the same
//! group and nothing else.

use linkage_core::{Sense, Side};
use linkage_tests::mechanisms::driven_groups::*;
use linkage_tests::random::Random;

#[test]
fn sides_are_mirrored_in_the_line_of_centres() {
    let mut random = Random::new(6);
    for _ in 0..1000 {
        let q = [0.0, 0.0, random.between(1.0, 2.0), random.between(-1.0, 1.0)];
        let left = DrivenRrr { l1: 1.75, l2: 1.5, ..DrivenRrr::new() };
        let right = DrivenRrr { elbow: left.elbow.flipped(), ..left };
        assert_eq!((left.elbow, right.elbow), (Side::Left, Side::Right));
        let (one, other) = (left.position(q).unwrap().C, right.position(q).unwrap().C);
        let side = |x: f64, y: f64| q[2] * y - q[3] * x;
        assert!(side(one.x, one.y) > 0.0 && side(other.x, other.y) < 0.0);
        // Both on both circles: two roundings of squares up to 4, and the pose's own twenty.
        for c in [one, other] {
            assert!((c.x.hypot(c.y) - 1.75).abs() <= 40.0 * f64::EPSILON);
            assert!(((c.x - q[2]).hypot(c.y - q[3]) - 1.5).abs() <= 40.0 * f64::EPSILON);
        }
        // The middle between the two is on the line of centres.
        assert!(side(one.x + other.x, one.y + other.y).abs() <= 40.0 * f64::EPSILON);
    }
}

#[test]
fn senses_are_mirrored_in_the_foot() {
    let mut random = Random::new(7);
    for _ in 0..1000 {
        let q = [random.between(-1.0, 1.0), random.between(-0.5, 0.5), 0.0, 0.0, 0.0];
        let ahead = DrivenRrp { e: 0.25, ..DrivenRrp::new() };
        let behind = DrivenRrp { side: Sense::Behind, ..ahead };
        let (one, other) = (ahead.position(q).unwrap(), behind.position(q).unwrap());
        assert!(one.block.slide > q[0] && other.block.slide < q[0]);
        let middle = (one.block.slide + other.block.slide) / 2.0;
        assert!((middle - q[0]).abs() <= 4.0 * f64::EPSILON);
        assert_eq!((one.C.y, other.C.y), (0.25, 0.25));

        let d = [q[0], q[1], 2.0, 1.0];
        let ahead = DrivenRpr { e: 0.5, ..DrivenRpr::new() };
        let behind = DrivenRpr { side: ahead.side.flipped(), ..ahead };
        let (one, other) = (ahead.position(d).unwrap(), behind.position(d).unwrap());
        assert!(one.block.slide > 0.0);
        assert_eq!(other.block.slide, -one.block.slide);
        for pose in [one, other] {
            // B = D + slide u + e n.
            let x = 2.0 + pose.block.slide * pose.bar.cos - 0.5 * pose.bar.sin;
            let y = 1.0 + pose.block.slide * pose.bar.sin + 0.5 * pose.bar.cos;
            assert!((x - q[0]).abs() <= 40.0 * f64::EPSILON);
            assert!((y - q[1]).abs() <= 40.0 * f64::EPSILON);
        }
    }
}
