//! The same mechanisms as declared to the compiler.

use linkage_core::mechanism;

mechanism! {
    /// S1: the four-bar with a coupler point; no angle is asked for.
    pub struct FourBar {
        input theta: angle;

        ground A(0, 0), D(304.8mm, 0);

        crank AB(A) -> B        { length: 101.6mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }

        point P on BC at (150mm, 50mm);
        output P, BC, DC;
    }
}

mechanism! {
    /// S1 with its reach in compensated arithmetic.
    pub struct FourBarCompensated {
        numerics compensated;
        input theta: angle;

        ground A(0, 0), D(304.8mm, 0);

        crank AB(A) -> B        { length: 101.6mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }

        point P on BC at (150mm, 50mm);
        output P, BC, DC;
    }
}

mechanism! {
    /// S1 when only the coupler point is asked for.
    pub struct CouplerPoint {
        input theta: angle;

        ground A(0, 0), D(304.8mm, 0);

        crank AB(A) -> B        { length: 101.6mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }

        point P on BC at (150mm, 50mm);
        output P;
    }
}

mechanism! {
    /// S5: crank, RPR and RPP.
    pub struct SixBar {
        input theta: angle;

        ground A(0, 0), D(0, -1m);
        guide rail through (0, 0.8m) along 0deg;

        crank AB(A) -> B           { length: 0.4m, angle: theta }
        rpr   block(B), rod(D)     { mode: ahead }
        point E on rod at (1.6m, 0);
        rpp   pin(E), ram(rail)    { slot: 90deg }

        output rod, block.slide, ram.slide, pin.slide;
    }
}

mechanism! {
    /// Stephenson III: a dyad on the coupler point of a four-bar.
    pub struct Stephenson {
        input theta: angle;

        ground A(0, 0), D(100mm, 0), F(180mm, 60mm);

        crank AB(A) -> B        { length: 40mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (110mm, 90mm), mode: left }
        point P on BC at (70mm, 50mm);
        rrr   PE(P), FE(F) -> E { lengths: (120mm, 100mm), mode: left }

        output P, E, FE;
    }
}

mechanism! {
    /// Ten links: a crank and four dyads, each begun at a point of the last one's rocker.
    pub struct Chain {
        input theta: angle;

        ground A(0, 0), D1(100mm, 0), D2(200mm, 0), D3(300mm, 0), D4(400mm, 0);

        crank AB(A) -> B             { length: 40mm, angle: theta }
        rrr   B1(B), R1(D1) -> C1    { lengths: (110mm, 90mm), mode: left }
        point P1 on R1 at (60mm, 20mm);
        rrr   B2(P1), R2(D2) -> C2   { lengths: (110mm, 90mm), mode: left }
        point P2 on R2 at (60mm, 20mm);
        rrr   B3(P2), R3(D3) -> C3   { lengths: (110mm, 90mm), mode: left }
        point P3 on R3 at (60mm, 20mm);
        rrr   B4(P3), R4(D4) -> C4   { lengths: (110mm, 90mm), mode: left }

        output C4, R4;
    }
}

mechanism! {
    /// Stephenson III with its reaches in compensated arithmetic.
    pub struct StephensonCompensated {
        numerics compensated;
        input theta: angle;

        ground A(0, 0), D(100mm, 0), F(180mm, 60mm);

        crank AB(A) -> B        { length: 40mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (110mm, 90mm), mode: left }
        point P on BC at (70mm, 50mm);
        rrr   PE(P), FE(F) -> E { lengths: (120mm, 100mm), mode: left }

        output P, E, FE;
    }
}

mechanism! {
    /// The ten links with their reaches in compensated arithmetic.
    pub struct ChainCompensated {
        numerics compensated;
        input theta: angle;

        ground A(0, 0), D1(100mm, 0), D2(200mm, 0), D3(300mm, 0), D4(400mm, 0);

        crank AB(A) -> B             { length: 40mm, angle: theta }
        rrr   B1(B), R1(D1) -> C1    { lengths: (110mm, 90mm), mode: left }
        point P1 on R1 at (60mm, 20mm);
        rrr   B2(P1), R2(D2) -> C2   { lengths: (110mm, 90mm), mode: left }
        point P2 on R2 at (60mm, 20mm);
        rrr   B3(P2), R3(D3) -> C3   { lengths: (110mm, 90mm), mode: left }
        point P3 on R3 at (60mm, 20mm);
        rrr   B4(P3), R4(D4) -> C4   { lengths: (110mm, 90mm), mode: left }

        output C4, R4;
    }
}
