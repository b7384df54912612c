//! Machines that were refused, wrong or without words once: parallelograms, groups of class III, frames, names and friction.

#![allow(non_snake_case)]

use linkage_core::mechanism;

mechanism! {
    /// A parallelogram behind a rocker.
    pub struct Wiper {
        input theta: angle;
        ground A(0, 0), D(-250mm, 60mm), H(350mm, 60mm);
        pin B(45mm, 0), C(-245mm, -20mm), E(-320mm, 50mm), F(280mm, 50mm);
        link AB(A, B);
        link rod(B, C);
        link one(D, C, E);
        link tie(E, F);
        link two(H, F);
        drive AB.angle = theta;
    }
}

mechanism! {
    /// The same with its second rocker driven as the first.
    pub struct WiperByDrive {
        input theta: angle;
        ground A(0, 0), D(-250mm, 60mm), H(350mm, 60mm);
        pin B(45mm, 0), C(-245mm, -20mm), E(-320mm, 50mm), F(280mm, 50mm), tip1(-250mm, 660mm), tip2(350mm,
            610mm);
        link AB(A, B);
        link rod(B, C);
        link one(D, E, C, tip1);
        link two(H, F, tip2);
        drive AB.angle = theta;
        drive two.angle = one.angle;
    }
}

mechanism! {
    /// A parallelogram on the ground.
    pub struct Direct {
        input theta: angle;
        ground A(0, 0), D(600mm, 0);
        pin B(30mm, 60mm), C(630mm, 60mm);
        link AB(A, B);
        link BC(B, C);
        link DC(D, C);
        drive AB.angle = theta;
    }
}

mechanism! {
    /// A square that is driven at one crank.
    pub struct Square {
        input theta: angle;
        ground J0(0, 0), J1(100mm, 0);
        pin J2(0, 100mm), J3(100mm, 100mm);
        link link_1(J0, J2);
        link link_3(J1, J3);
        link link_2(J2, J3);
        drive link_1.angle = theta;
    }
}

mechanism! {
    /// A group of class III that turns fully.
    pub struct Turning {
        input theta: angle;
        ground J0(-45mm, -15.5mm), J5(85.25mm, -27.25mm);
        pin J1(-52mm, 25.5mm), J2(-36mm, 76.25mm), J3(-4mm, 3mm), J4(29mm, 27.5mm), J6(57.5mm, 77mm);
        link L1(J0, J1);
        link L2(J1, J2, J3);
        link L5(J2, J6);
        link L4(J3, J4);
        link L3(J4, J5, J6);
        drive L1.angle = theta;
    }
}

mechanism! {
    /// A machine of a nanometre, whose numbers have many digits.
    pub struct Tiny {
        input t25: angle;
        ground P1(-6.206000000000001e-10m, -5.371e-10m), P2(-1.0518000000000002e-09m, -7.996e-10m),
            P3(4.829000000000001e-10m, 4.844e-10m), P7(-1.7660000000000002e-10m, 3.312e-10m),
            P14(-4.2770000000000003e-10m, 3.1700000000000004e-10m);
        pin P4(3.9520000000000004e-10m, 2.736e-10m);
        pin P10(8.95492697486051e-10m, 5.597855773217777e-10m);
        pin P17(1.173e-10m, 2.582e-10m);
        pin P18(-5.082000000000001e-10m, 1.538e-10m);
        link L5(P3, P4);
        guide g8 on L5 through (-1.283e-10m, 2.8770000000000005e-10m) along 147.21deg;
        link Y9(P10) on g8;
        guide g11 on Y9 through (-1.0579931491749222e-09m, 4.5752431563114613e-10m) along 117.30563853421519deg;
        link S12(P7) on g11;
        point Q13 on S12 at (6.640000000000001e-11m, -3.816e-10m);
        point Q15 on S12 at (3.9100000000000006e-11m, 2.7620000000000004e-10m);
        link T19(P17, P18);
        guide g20 on T19 through (6.301778108776555e-11m, -5.526868147374421e-10m) along 82.67deg;
        link S21(Q13) on g20;
        link L22(P14, P17);
        guide g23 on L5 through (6.225497751167369e-10m, -7.95408018253588e-10m) along -118.02deg;
        link S24(P18) on g23;
        drive T19.angle - L22.angle = t25;
    }
}

mechanism! {
    /// A guide through a pin that moves: where that is drawn.
    pub struct Guided {
        input theta: angle;
        ground A(0, 0);
        pin B(30mm, 40mm), C(150mm, 0);
        guide bed through C along 0deg;
        link AB(A, B), BC(B, C), ram(C) on bed;
        drive AB.angle = theta;
    }
}

mechanism! {
    /// A link on two pins of the ground.
    pub struct Frame {
        input theta: angle;
        ground A(0, 0), D(300mm, 0), E(300mm, 100mm);
        pin B(50mm, 80mm), C(300mm, 200mm);
        guide slot on frame through D towards E;
        link frame(D, E), AB(A, B), BC(B, C), block(C) on slot;
        drive AB.angle = theta;
    }
}

mechanism! {
    /// A link of given angle between two bars.
    pub struct Knee {
        input flexion: angle;
        ground A(0, 0), D(-35mm, 10mm);
        pin B(12mm, -70mm), C(-25mm, -62mm), ankle(0, -450mm);
        link front(A, B);
        link rear(D, C);
        link shank(B, C, ankle);
        drive shank.angle = 167.8deg - flexion;
    }
}

mechanism! {
    /// The same by a group.
    pub struct KneeByHand {
        input flexion: angle;
        ground A(0, 0), D(-35mm, 10mm);
        let gamma = 167.8deg - flexion;
        let l = hypot(37mm, 8mm);
        point V at (-35mm - l * cos(gamma), 10mm - l * sin(gamma));
        rrr front(A), ghost(V) -> B { lengths: (hypot(12mm, 70mm), hypot(10mm, 72mm)), mode: right }
        crank shank(B) -> C { length: l, angle: gamma }
        point ankle on shank at (-2596(mm^2) / hypot(-37mm, 8mm), 14156(mm^2) / hypot(-37mm, 8mm));
        output ankle;
    }
}

mechanism! {
    /// A pin that a group makes and `pin` places.
    pub struct ByCrank {
        input theta: angle;
        ground A(0, 0), D(4m, 0);
        crank AB(A) -> B { length: 1m, angle: theta }
        pin B(0, 1m), C(3m, 2m);
        link BC(B, C), DC(D, C);
        output DC.angle;
    }
}

mechanism! {
    /// A pin that `point` makes and `pin` places.
    pub struct ByPoint {
        input x, y: length;
        ground A(-50mm, 0);
        pin B(-120mm, 90mm), tool(0, 200mm);
        link AB(A, B), BC(B, tool);
        point tool at (x, y);
        output AB.angle;
    }
}

mechanism! {
    /// A mass on the bar that the compiler leaves out.
    pub struct Triad {
        input t: angle;
        ground A(0,0), D(3m,0), F(1.5m,-1m);
        pin B(0.5m,0.2m), C1(0.8m,1m), C2(2m,1.2m), C3(1.5m,0.5m);
        link AB(A,B), bar1(B,C1), plate(C1,C2,C3), bar2(D,C2), bar3(F,C3);
        drive AB.angle = t;
        mass 1kg on bar2 at C2;
    }
}

mechanism! {
    /// A rod and its block as one link.
    pub struct Yoke {
        input theta: angle;
        ground A(0, 0);
        pin B(3cm, 0), C(3cm, -5cm), D(3cm, 5cm);
        guide guide_E on CD through C towards D;
        guide guide_F through (3cm, -5cm) along 0deg;
        link AB(A, B);
        link CD(C, D) on guide_F;
        link BE(B) on guide_E;
        drive AB.angle = theta;
    }
}

mechanism! {
    /// A boom that a cylinder moves.
    pub struct Boom {
        input s: length;
        ground O(0, 0), G(4cm, 0);
        pin C(0, 5cm), N(2cm, 2.5cm), P(2.4cm, 2cm);
        guide guide_S on GN through G towards N;
        link OC(O, C);
        link GN(G, N);
        link PC(P, C) on guide_S;
        drive PC.slide = s;
    }
}

mechanism! {
    /// A force by the rate of a drawn pin.
    pub struct Law {
        input t: angle;
        ground A(0, 0), D(665.7mm, 0);
        pin B(80mm, 0), C(600mm, 360mm), E(570mm, 90mm);
        link AB(A, B), BC(B, C, E), DC(D, C);
        drive AB.angle = t;
        let w = -2(N*s/m) * rate(E.x);
        force (w, 0) on E;
    }
}

mechanism! {
    /// An output with the name of what is searched.
    pub struct Named {
        input x: length;
        ground A(0, 0), D(665.7mm, 0);
        guide floor through (0, 0) along 0deg;
        pin B(-30mm, 70mm), C(560mm, -360mm), blade(500mm, -410mm);
        link AB(A, B), BC(B, C, blade), DC(D, C), cross() on floor;
        guide way on cross through blade along 90deg;
        link ride(blade) on way;
        drive cross.slide = x;
        output phi = AB.angle;
    }
}

mechanism! {
    /// Friction at a pin of a block that does not turn.
    pub struct Still {
        input t: angle;
        ground A(0, 0), D(0.4m, 0);
        guide rail through (0, -0.3m) along 0deg;
        crank AB(A) -> B { length: 0.15m, angle: t }
        rrr BC(B), DC(D) -> C { lengths: (0.4m, 0.15m), mode: left }
        point P on BC at (0.2m, -0.05m);
        rpp block(P), yoke(rail) { slot: 90deg, offsets: (0, 0) }
        mass 5kg on yoke at (0, 0) inertia 0.01(kg*m^2);
        mass 1kg on BC at (0.2m, 0) inertia 0.01(kg*m^2);
        load push: force;
        force (-push, 0) on P;
        friction 0.2 on block at P radius 30mm;
        output t.drive, BC.B, DC.D, block.P, block.P.friction, losses;
    }
}

mechanism! {
    /// Friction in a truss on a crank.
    pub struct Truss {
        input t: angle;
        ground A(0, 0), D(0.9m, 0);
        crank AB(A) -> B { length: 0.3m, angle: t }
        rrr BK(B), DK(D) -> K { lengths: (0.8m, 0.5m), mode: left }
        point E on BK at (0.5m, 0.1m);
        rrr p(B), q(E) -> C { lengths: (0.31m, 0.27m), mode: left }
        point F on p at (0.2m, 0.15m);
        point G on BK at (0.6m, -0.1m);
        rrr r(F), s(G) -> H { lengths: (0.4m, 0.45m), mode: right }
        gravity (0, -9.81);
        mass 2kg on p at (0.2m, 0.05m) inertia 0.01(kg*m^2);
        mass 5kg on r at (0.15m, 0.02m) inertia 0.01(kg*m^2);
        mass 2kg on s at (0.15m, 0.02m) inertia 0.01(kg*m^2);
        friction 0.2 on r at F radius 20mm;
        friction 0.2 at H radius 20mm;
        output t.drive, r.H, r.H.friction, r.F.friction, losses;
    }
}

mechanism! {
    /// Smooth friction.
    pub struct Smooth {
        input x: length;
        guide bed through (0, 0) along 0deg;
        slider block(bed) -> P { slide: x }
        gravity (0, -9.81);
        mass 3kg on block at (0, 0) inertia 0.1(kg*m^2);
        friction 0.1 on block smooth 0.01(m/s);
        output x.drive;
    }
}
