//! Four-bars whose longest and shortest bar are together as long as the other two: they pass
//! through poses in which all bars lie on one line.

use linkage_core::mechanism;

mechanism! {
    /// Bars equal in pairs: a parallelogram or, after a change of mode, an antiparallelogram.
    pub struct Parallelogram {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// Bars 4, 1, 2 and 3: one change point a turn, two turns a period.
    pub struct FourOneTwoThree {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 3m), mode: elbow }

        output C, BC, DC;
    }
}

mechanism! {
    /// Crank and rod of one length: the rod stands across the rail at a quarter turn.
    pub struct EqualSliderCrank {
        input theta: angle;
        param side: mode = ahead;

        ground A(0, 0);
        guide rail through (0, 0) along 0deg;
        crank AB(A) -> B              { length: 1m, angle: theta }
        rrp   BC(B), block(rail) -> C { length: 1m, mode: side }

        output BC, block;
    }
}

mechanism! {
    /// Crank and ground of one length: the moving pins meet the fixed one at θ = 0.
    pub struct TurningKite {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(1m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 2m), mode: elbow }

        output C, DC;
    }
}

mechanism! {
    /// The crank's pin passes over the bar's pivot at half a turn.
    pub struct OverThePivot {
        input theta: angle;
        param side: mode = ahead;

        ground A(0, 0), D(-1m, 0);
        crank AB(A) -> B       { length: 1m, angle: theta }
        rpr   block(B), bar(D) { mode: side }

        output bar, block.slide;
    }
}

mechanism! {
    /// The crank's pin comes as close to the pivot as the block's offset lets it, at half a turn.
    pub struct TouchingOffset {
        input theta: angle;
        param side: mode = ahead;

        ground A(0, 0), D(-1.5m, 0);
        crank AB(A) -> B       { length: 1m, angle: theta }
        rpr   block(B), bar(D) { offset: 0.5m, mode: side }

        output bar, block.slide;
    }
}

mechanism! {
    /// Two parallelograms in a row, flat at the same time, and a rocker behind them.
    pub struct ThreeCranks {
        input theta: angle;
        param first: mode = left;
        param second: mode = left;
        param third: mode = left;

        ground A(0, 0), D(2m, 0), F(4m, 0), G(6m, 1m);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: first }
        rrr   CE(C), FE(F) -> E { lengths: (2m, 1m), mode: second }
        rrr   EH(E), GH(G) -> H { lengths: (3m, 2.5m), mode: third }

        output C, E, H, GH;
    }
}

mechanism! {
    /// The same with one parameter for the modes of both parallelograms.
    pub struct OneModeForTwo {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2m, 0), F(4m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }
        rrr   CE(C), FE(F) -> E { lengths: (2m, 1m), mode: elbow }

        output FE;
    }
}

mechanism! {
    /// One parameter for a group that changes its mode and one that does not.
    pub struct TornMode {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2m, 0), F(4m, 1m);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }
        rrr   CE(C), FE(F) -> E { lengths: (3m, 2.5m), mode: elbow }

        output FE;
    }
}

mechanism! {
    /// The same in the other order: the parallelogram comes second.
    pub struct TornBehind {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2m, 0), F(3m, 1m);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BE(B), FE(F) -> E { lengths: (3m, 2.5m), mode: elbow }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }

        output FE, DC;
    }
}

mechanism! {
    /// A parallelogram whose mode cannot change.
    pub struct ConstantMode {
        input theta: angle;

        ground A(0, 0), D(2m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: left }

        output DC;
    }
}

mechanism! {
    /// A four-bar whose crank cannot turn fully.
    pub struct StoppingCrank {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(3m, 0);
        crank AB(A) -> B        { length: 1.5m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (1.2m, 1.3m), mode: elbow }

        output C, DC;
    }
}

mechanism! {
    /// Two bars between a pin that the inputs put anywhere and the origin.
    pub struct FoldingBars {
        input x, y: length;
        param elbow: mode = left;

        ground D(0, 0);
        point B at (x, y);
        rrr   BC(B), DC(D) -> C { lengths: (3m, 2m), mode: elbow }

        output C, DC;
    }
}

mechanism! {
    /// Nearly a parallelogram: it comes within a thousandth of the change point and turns back.
    pub struct NearlyFlat {
        input theta: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2.001m, 0);
        crank AB(A) -> B        { length: 1m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (2.002m, 1.01m), mode: elbow }

        output C, DC;
    }
}

mechanism! {
    /// Every group with a mode, one behind the other, between two inputs, with a parameter.
    pub struct Row {
        input theta: angle;
        input lift: length;
        param rod = 495mm;
        param elbow: mode = left;
        ground A(0, 0), D(534mm, 22mm), E(995mm, 108mm);
        crank AB(A) -> B { length: 68mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (rod, 331mm + lift), mode: elbow }
        point P on BC at (297mm, 77mm);
        rrr PQ(P), EQ(E) -> Q { lengths: (560mm, 441mm), mode: right }
        guide rail through (153mm, -600mm) along -4deg;
        rrp CR(C), block(rail) -> R { length: 1749mm, mode: ahead }
        rpr cyl(E), stem(R) { offset: 30mm, mode: ahead }
        output Q, block, cyl;
    }
}

mechanism! {
    /// A parallelogram with masses: its crank is a pendulum, 8/3 q̈ = −3 g cos q + torque, in N·m.
    pub struct HeavyParallelogram {
        input q: angle;
        param elbow: mode = left;

        ground A(0, 0), D(2m, 0);
        crank AB(A) -> B        { length: 1m, angle: q }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }

        gravity (0, -9.81(m/s^2));
        mass 1kg on AB uniform;
        mass 2kg on BC uniform;
        mass 1kg on DC uniform;
        output DC, AB.drive, energy;
    }
}

mechanism! {
    /// The same carried by a carriage of 3 kg on a level rail.
    pub struct CarriedParallelogram {
        input x: length;
        input q: angle;
        param elbow: mode = left;

        ground O(0, 0);
        guide rail through O along 0deg;
        slider carriage(rail) -> A { slide: x }
        point D on carriage at (2m, 0);
        crank AB(A) -> B        { length: 1m, angle: q }
        rrr   BC(B), DC(D) -> C { lengths: (2m, 1m), mode: elbow }

        gravity (0, -9.81(m/s^2));
        mass 3kg on carriage at (0, 0);
        mass 1kg on AB uniform;
        mass 2kg on BC uniform;
        mass 1kg on DC uniform;
        output DC, energy;
    }
}
