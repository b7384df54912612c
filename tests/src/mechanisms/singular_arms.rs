//! Arms whose mass matrix is singular where they are stretched or folded.

use linkage_core::mechanism;

mechanism! {
    /// Two axes and one mass: stretched or folded, the mass moves along one line alone.
    pub struct ElbowArm {
        input a, b: angle;
        param wrist = 1kg;
        ground O(0, 0);
        crank K(O) -> P { length: 0.7m, angle: a }
        crank L(P) -> Q { length: 0.7m, angle: b, relative_to: K }
        mass wrist on Q;
        output a.drive, b.drive, Q;
    }
}

mechanism! {
    /// The same elbow, measured by its first angle in thousands of a turn and carried by a slide.
    pub struct CartArm {
        input slide: length;
        input a, b: angle;
        param hand = 1kg;
        param cart_mass = 2kg;
        ground O(0, 0);
        guide bed through O along 30deg;
        slider cart(bed) -> S { slide: slide }
        crank K(S) -> P { length: 0.7m, angle: 6.283e-3 * a }
        crank L(P) -> Q { length: 0.5m, angle: b, relative_to: K }
        mass hand on Q;
        mass cart_mass on cart at (0, 0);
        output slide.drive, a.drive, b.drive, Q;
    }
}

mechanism! {
    /// Three axes, with masses at the second joint and at the end.
    pub struct ThreeAxes {
        input a, b, c: angle;
        ground O(0, 0);
        crank K(O) -> P { length: 0.7m, angle: a }
        crank L(P) -> Q { length: 0.7m, angle: b, relative_to: K }
        crank N(Q) -> R { length: 0.4m, angle: c, relative_to: L }
        mass 1kg on Q;
        mass 0.5kg on R;
        output a.drive, b.drive, c.drive, R;
    }
}

mechanism! {
    /// A base that turns without mass of its own behind it, and a wrist as light as is wanted.
    pub struct LightWrist {
        input a, b: angle;
        param wrist = 1kg;
        ground O(0, 0);
        crank K(O) -> P { length: 0.7m, angle: a }
        crank L(P) -> Q { length: 0.7m, angle: b, relative_to: K }
        mass 1kg on P;
        mass wrist on Q;
        output a.drive, b.drive, Q;
    }
}
