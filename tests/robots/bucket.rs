//! An excavator's bucket: the length of its cylinder to the bucket's angle, and back.

use linkage_core::mechanism;
use linkage_tests::random::Random;

mechanism! {
    /// From the cylinder to the bucket, in axes of the stick.
    pub struct FromCylinder {
        input curl: length;
        load dig: torque;

        ground N(-0.2m, -0.5m), K(-2.3m, 0), T(-2.7m, 0.2m);
        rrr ram(N), lever(K) -> V    { lengths: (curl, 0.6m), mode: left }
        rrr pull(V), bucket(T) -> W  { lengths: (0.6m, 0.45m), mode: left }

        torque -dig on bucket;
        inertia 400(kg*m^2) on bucket;
        output bucket, V, W, curl.drive;
    }
}

mechanism! {
    /// From the bucket to the cylinder.
    pub struct FromBucket {
        input angle: angle;
        load push: force;

        ground N(-0.2m, -0.5m), K(-2.3m, 0), T(-2.7m, 0.2m);
        crank bucket(T) -> W        { length: 0.45m, angle: angle }
        rrr   pull(W), lever(K) -> V { lengths: (0.6m, 0.6m), mode: right }

        force -push between N and V;
        output curl = distance(N, V), V, W, angle.drive;
    }
}

#[test]
fn power_is_the_same_on_both_sides_of_a_bucket() {
    let (cylinder, bucket) = (FromCylinder::new(), FromBucket::new());
    let mut random = Random::new(42);
    let mut worst = [0.0_f64; 4];
    for _ in 0..100_000 {
        let curl = random.anywhere(1.8, 2.35);
        let [rate, dig] = [random.anywhere(-0.5, 0.5), random.anywhere(-2e4, 2e4)];
        let pose = cylinder.position(curl).expect("it reaches");
        let omega = cylinder.velocity(curl, rate).expect("it moves").bucket.omega;
        let push = cylinder.statics(curl, dig).expect("it stands").curl.drive;
        let apart = |one: f64, two: f64| (one - two).abs() / (one.abs() + two.abs());
        worst[0] = worst[0].max(apart(push * rate, dig * omega));

        // And back, by the other declaration.
        let angle = pose.bucket.angle();
        let back = bucket.position(angle).expect("it reaches");
        worst[1] = worst[1].max((back.curl - curl).abs() / curl);
        let held = bucket.statics(angle, push).expect("it stands").angle.drive;
        worst[2] = worst[2].max(apart(held, dig));
        // The bucket as the cylinder feels it.
        let [[felt]] = cylinder.equations_of_motion(curl, 0.0, 0.0).expect("it moves").mass;
        let ratio = omega / rate;
        worst[3] = worst[3].max(apart(felt, 400.0 * ratio * ratio));
        // The other assembly of the lever is more than a length apart from this one, or nearly.
        assert!(back.V.distance(pose.V) < 1e-12, "{curl}");
    }
    let [power, lengths, torques, inertia] = worst.map(|error| error / f64::EPSILON);
    println!(
        "power {power:.2} ε, lengths {lengths:.1} ε, torques {torques:.1} ε, inertia {inertia:.1} ε"
    );
    assert!(power <= 8.0, "{power}");
    // There and back through two groups each.
    assert!(lengths <= 32.0 && torques <= 64.0 && inertia <= 16.0, "{worst:?}");
}
