// Five machines that turn fully, and five that cannot: the errors of their printed C stay within what is proved.

linkage_core::mechanism! {
    pub struct CouplerPoint {
        input theta: angle;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
        point P on BC at (434mm, 190mm);
        output P, DC.angle;
    }
}

linkage_core::mechanism! {
    pub struct OffsetSliderCrank {
        input theta: angle;
        ground A(0, 0), O(0, 30mm);
        guide  rail through O along 10deg;
        crank  AB(A) -> B            { length: 90mm, angle: theta }
        rrp    BC(B), block(rail) -> C { length: 310mm, mode: ahead }
        output C, BC.angle, block.slide;
    }
}

linkage_core::mechanism! {
    pub struct QuickReturn {
        input theta: angle;
        ground A(0, 240mm), O(0, 0), K(0, 520mm);
        guide  rail through K along 0deg;
        crank  AB(A) -> B       { length: 110mm, angle: theta }
        rpr    slide(B), OB(O)  { offset: 15mm, mode: ahead }
        point  E on OB at (480mm, 0);
        rrp    EF(E), ram(rail) -> F { length: 260mm, mode: behind }
        output F, OB.angle;
    }
}

linkage_core::mechanism! {
    pub struct StephensonThree {
        input theta: angle;
        ground A(0, 0), D(300mm, 0), G(150mm, 350mm);
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (260mm, 200mm), mode: left }
        point E on BC at (150mm, 110mm);
        rrr   EF(E), GF(G) -> F { lengths: (180mm, 140mm), mode: right }
        output F, GF.angle;
    }
}

linkage_core::mechanism! {
    pub struct Yoke {
        input theta: angle;
        ground A(0, 0), O(0, 200mm);
        guide  rail through O along 0deg;
        crank  AB(A) -> B             { length: 70mm, angle: theta }
        rpp    pin(B), yoke(rail)     { slot: 75deg }
        output yoke.slide, pin.slide;
    }
}

linkage_core::mechanism! {
    pub struct DoubleRocker {
        input theta: angle;
        ground A(0, 0), D(400mm, 0);
        crank AB(A) -> B        { length: 250mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (180mm, 290mm), mode: left }
        output C, BC.angle;
    }
}

linkage_core::mechanism! {
    pub struct LongCrank {
        input theta: angle;
        ground A(0, 0), O(0, 0);
        guide  rail through O along 0deg;
        crank  AB(A) -> B              { length: 200mm, angle: theta }
        rrp    BC(B), block(rail) -> C { length: 130mm, mode: ahead }
        output C, BC.angle;
    }
}

linkage_core::mechanism! {
    pub struct BarBesideItsPin {
        input theta: angle;
        ground A(0, 0), O(150mm, 0);
        crank AB(A) -> B      { length: 100mm, angle: theta }
        rpr   block(B), OB(O) { offset: 80mm, mode: ahead }
        point P on OB at (210mm, 25mm);
        output P, OB.angle, block.slide;
    }
}

linkage_core::mechanism! {
    pub struct ShortCoupler {
        input theta: angle;
        ground A(0, 0), D(300mm, 0), G(150mm, 350mm);
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (260mm, 200mm), mode: left }
        point E on BC at (150mm, 110mm);
        rrr   EF(E), GF(G) -> F { lengths: (90mm, 120mm), mode: right }
        output F, GF.angle;
    }
}

linkage_core::mechanism! {
    pub struct RamOutOfReach {
        input theta: angle;
        ground A(0, 0), D(300mm, 0), O(0, 330mm);
        guide rail through O along 0deg;
        crank AB(A) -> B             { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C      { lengths: (260mm, 200mm), mode: left }
        rrp   CF(C), block(rail) -> F { length: 140mm, mode: ahead }
        output F, CF.angle;
    }
}
