//! Groups with numbers carried to twice the width, each with another share of its dimensions and
//! coordinates known as constants, none of which is a number of either width.

use linkage_core::mechanism;

mechanism! {
    /// Bars of 0.1 and 0.2 between driven points.
    pub struct ConstantBars {
        numerics compensated;
        input bx, by, dx, dy: length;
        param elbow: mode = left;

        point B at (bx, by);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (0.1m, 0.2m), mode: elbow }
        output BC, DC;
    }
}

mechanism! {
    /// The second bar alone known as a constant.
    pub struct HalfConstantBars {
        numerics compensated;
        input bx, by, dx, dy: length;
        param l1 = 0.1m;
        param elbow: mode = left;

        point B at (bx, by);
        point D at (dx, dy);
        rrr BC(B), DC(D) -> C { lengths: (l1, 0.2m), mode: elbow }
        output BC, DC;
    }
}

mechanism! {
    /// The joints 0.3 apart along x, as far as their slides are along y.
    pub struct ConstantBreadth {
        numerics compensated;
        input by, dy: length;
        param l1 = 0.1m;
        param l2 = 0.3m;
        param elbow: mode = left;

        point B at (0.1m, by);
        guide post through (0.4m, 0) along 90deg;
        slider ram(post) -> D { slide: dy }
        rrr BC(B), DC(D) -> C { lengths: (l1, l2), mode: elbow }
        output BC, DC;
    }
}

mechanism! {
    /// A cylinder with 0.2 of dead length between pivots of the ground.
    pub struct Cylinder {
        numerics compensated;
        input lift: length;

        ground B(0.1, 0.2), D(0.8, 0.3);
        rrr BC(B), DC(D) -> C { lengths: (lift + 0.2m, 0.4m), mode: left }
        output BC, DC;
    }
}

mechanism! {
    /// The same on an arm to tune.
    pub struct CylinderOnArm {
        numerics compensated;
        input lift: length;
        param arm = 0.4m;

        ground B(0.1, 0.2), D(0.8, 0.3);
        rrr BC(B), DC(D) -> C { lengths: (lift + 0.2m, arm), mode: left }
        output BC, DC;
    }
}

mechanism! {
    /// A bar of 0.3 between a driven point and a guide at y = 0.1.
    pub struct ConstantRrp {
        numerics compensated;
        input bx, by: length;

        point B at (bx, by);
        guide rail through (0, 0.1m) along 0deg;
        rrp BC(B), block(rail) -> C { length: 0.3m, offset: 0.2m, mode: ahead }
        output BC, block.slide;
    }
}

mechanism! {
    /// The bar alone known as a constant, and the guide turned the other way.
    pub struct HalfConstantRrp {
        numerics compensated;
        input bx, by: length;
        param e = 0.2m;

        point B at (bx, by);
        guide rail through (0, 0.1m) along 180deg;
        rrp BC(B), block(rail) -> C { length: 0.3m, offset: e, mode: ahead }
        output BC, block.slide;
    }
}

mechanism! {
    /// A block at a constant offset from a pivot in the ground; the plain form carries that too.
    pub struct ConstantRpr {
        input bx, by: length;

        ground D(0, 0);
        point B at (bx, by);
        rpr block(B), bar(D) { offset: 0.3m }
        output bar, block.slide;
    }
}

mechanism! {
    /// The same between driven points, at an offset to tune.
    pub struct CompensatedRpr {
        numerics compensated;
        input bx, by, dx, dy: length;
        param e = 0.3m;

        point B at (bx, by);
        point D at (dx, dy);
        rpr block(B), bar(D) { offset: e }
        output bar, block.slide;
    }
}
