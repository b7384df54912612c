//! Mechanisms whose motion ends at stops.

use linkage_core::mechanism;

mechanism! {
    /// A block between two buffers.
    pub struct Buffered {
        input x: length;
        param from = -0.1m;
        param stiffness = 2000(N/m);
        guide bed through (0, 0) along 0deg;
        slider block(bed) -> P { slide: x }
        mass 2kg on block at (0, 0);
        stop buffer block.slide between (from, 0.2m) { stiffness: stiffness, damping: 30(N*s/m) }
        output x.drive, buffer.force, buffer.gap, energy;
    }
}

mechanism! {
    /// Four-bar whose rocker turns between two rubbers, and whose coupler point keeps its distance from a post.
    pub struct StoppedFourBar {
        input theta: angle;
        ground A(0, 0), D(750mm, 0), S(0.3m, 0.6m);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        point Q on BC at (0.2m, 0.1m);
        stop rubber DC.angle between (100deg, 130deg) { stiffness: 900(N*m/rad), damping: 4 }
        stop post distance(S, Q) between (0.3m, 0.5m) { stiffness: 5000(N/m), damping: 60(N*s/m) }
        output DC, Q, theta.drive, rubber.force, rubber.gap, post.force, post.gap, energy;
    }
}

mechanism! {
    /// Two cranks geared two to one, with half a degree of play.
    pub struct Backlash {
        input first: angle;
        input second: angle;
        ground A(0, 0), D(0.3m, 0);
        crank gear(A) { angle: first }
        crank pinion(D) { angle: second }
        inertia 0.1(kg*m^2) on gear;
        inertia 0.01(kg*m^2) on pinion;
        stop teeth pinion.angle + 2 * gear.angle between (-0.25deg, 0.25deg) {
            stiffness: 4000(N*m/rad), damping: 1
        }
        output first.drive, second.drive, teeth.force, teeth.gap;
    }
}
