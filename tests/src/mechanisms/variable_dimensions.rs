//! Every dimension that a group or a point has, depending on an input.

use linkage_core::mechanism;

mechanism! {
    /// A crank, both bars of an RRR group, a slider's offset, and points by all coordinates.
    pub struct VariableFourBar {
        input theta: angle;
        input s: length;

        ground A(0, 0);
        guide bed through (3m, 0.4m) along 30deg;

        crank  AB(A) -> B        { length: 1.1m + s / 10, angle: theta }
        slider cart(bed) -> D    { slide: s, offset: s * s / 2m + 0.1m }
        rrr    BC(B), DC(D) -> C { lengths: (3.2m + s / 4, 2.4m - s / 8), mode: left }
        point P on BC at polar (1.7m + s / 2, s / 3m - 0.4rad);
        point R on BC at distances (2.1m + s / 6, 1.9m + s / 9) right;
    }
}

mechanism! {
    /// An RPR group's offset, and a point on its bar.
    pub struct VariableBar {
        input theta: angle;
        input s: length;

        ground A(0, 0), D(-0.3m, -2.1m);

        crank AB(A) -> B       { length: 1m + s / 4, angle: theta }
        rpr   block(B), bar(D) { offset: 0.35m + s * s / 2m, mode: ahead }
        point E on bar at (3.7m - s, s / 3);
    }
}

mechanism! {
    /// A PRP group's offsets and the angle of one of its guides.
    pub struct VariableCross {
        input theta: angle;
        input s: length;

        ground A(0, 0);
        guide post through (2.5m, 0) along 80deg;

        crank AB(A) -> B { length: 1m, angle: theta }
        guide arm on AB through B along 70deg + s / 2m;
        prp   shoe(arm), block(post) -> C { offsets: (0.1m + s / 3, s * s / 1m - 0.2m) }
        point W on shoe at (0.2m, s / 2);
    }
}

mechanism! {
    /// An RPP group's slot and offsets.
    pub struct VariableYoke {
        input theta: angle;
        input s: length;

        ground A(0, 0);
        guide rail through (-1m, -0.8m) along 5deg;

        crank AB(A) -> B           { length: 0.4m, angle: theta }
        rpp   block(B), yoke(rail)
            { slot: 75deg + s / 3m, offsets: (0.05m + s / 5, s * s / 4m - 0.07m) }
        point W on yoke at (0.3m, s);
        point V on block at (0.1m, -0.05m);
    }
}

mechanism! {
    /// An RRP group's length and offset on a carried guide that turns on its carrier.
    pub struct VariableRod {
        input theta: angle;
        input s: length;

        ground A(0, 0), D(2m, 0.3m);

        crank AB(A) -> B { length: 0.5m, angle: theta }
        crank table(D) { angle: theta / 2 + s / 1m }
        guide groove on table through (s / 2, 0.1m) along 40deg - s / 2m;
        rrp   BC(B), block(groove) -> C { length: 2.5m + s * s / 3m, offset: s / 4, mode: behind }
    }
}
