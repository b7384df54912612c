//! Every kind of driver, and dimensions that are inputs.

use linkage_core::mechanism;

mechanism! {
    /// A slider on a slider, each with its pin beside its guide.
    pub struct Gantry {
        input x, y: length;

        guide bed through (0.2m, -0.1m) along 20deg;
        slider saddle(bed) -> P { slide: x, offset: 0.15m }
        guide column on saddle through (0.05m, 0.1m) along 100deg;
        slider quill(column) -> Q { slide: y, offset: -0.04m }
    }
}

mechanism! {
    /// A telescope on a turning arm, with a wrist geared to the arm: the slide feels Coriolis.
    pub struct PolarArm {
        input phi: angle;
        input r: length;

        ground A(0.3m, 0.2m);
        crank arm(A) { angle: phi }
        guide groove on arm through (0.25m, -0.1m) along -0.4rad;
        slider ram(groove) -> P { slide: r, offset: 0.08m }
        crank wrist(P) -> H { length: 0.12m, relative_to: arm, angle: 2 * phi }
    }
}

mechanism! {
    /// Two geared cranks and one RRR group.
    pub struct GearedFiveBar {
        input theta: angle;

        ground A(0, 0), D(1.2m, 0);

        crank AB(A) -> B        { length: 0.5m, angle: theta }
        crank DE(D) -> E        { length: 0.4m, angle: -2 * AB.angle + 15deg }
        rrr   BC(B), EC(E) -> C { lengths: (1.1m, 1.3m), mode: left }
        point P on BC at (0.6m, 0.45m);
    }
}

mechanism! {
    /// A rack turns a pinion, an arm on the pinion is geared to the rack, and a rod on the arm
    /// pulls a block along a guide that runs towards −x.
    pub struct RackAndPinion {
        input s: length;

        ground K(0, 20mm);
        guide bed through (0, 0) along 0deg;
        guide way through (0, 50mm) along 180deg;

        slider rack(bed)                { slide: s }
        crank  pinion(K) -> R           { length: 15mm, angle: rack.slide / 20mm }
        crank  arm(R) -> T              { length: 30mm, relative_to: pinion, angle: rack.slide / 50mm + 0.3rad }
        rrp    TC(T), block(way) -> C   { length: 90mm, mode: behind }

        output R, T, C, pinion, arm, block.slide;
    }
}

mechanism! {
    /// Boom, stick and bucket on three cylinders; the inputs are the cylinders' lengths.
    pub struct Excavator {
        input lift, crowd, curl: length;

        ground O(0, 0), F(0.5m, -0.6m);

        rrr   lift_ram(F), boom(O) -> G    { lengths: (lift, 2.6m), mode: right }
        point S on boom at (5.2m, -1.1m);
        point H on boom at (2.9m, 0.5m);
        rrr   crowd_ram(H), stick(S) -> J  { lengths: (crowd, 0.8m), mode: right }
        point T on stick at (-2.8m, 0.3m);
        point N on stick at (-0.3m, 0.7m);
        point K on stick at (-2.4m, 0.35m);
        rrr   curl_ram(N), lever(K) -> V   { lengths: (curl, 0.6m), mode: right }
        rrr   pull(V), bucket(T) -> W      { lengths: (0.55m, 0.45m), mode: right }
        point tooth on bucket at (0.4m, -1.4m);

        output S, T, tooth, boom, stick, bucket;
    }
}

mechanism! {
    /// Everything about an RRP group depends on inputs: where its bar is pinned and how long it
    /// is, how its guide stands on the crank, the offset, and a point that wanders on the bar.
    pub struct SwingingGuide {
        input theta, psi: angle;
        input s: length;

        ground A(0, 0);
        crank AB(A) -> B { length: 0.5m, angle: theta }
        guide slot on AB through (0.3m, 0.1m) along psi;
        point P at (0.4 * s - 0.7m, 0.4m + s * s / 2m);
        rrp   PC(P), block(slot) -> C
            { length: sqrt(1.1m * 1.1m + s * s), offset: s / 4, mode: ahead }
        point Q on PC at (0.5 * s, hypot(s, 0.3m));
    }
}
