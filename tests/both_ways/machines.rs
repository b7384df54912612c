//! Machines that are driven in several ways, as they are drawn.

use linkage_core::mechanism;

mechanism! {
    pub struct Ankle {
        ground K(0, 0);
        pin A(0, -400mm), B(50mm, 0), H(60mm, -400mm);
        link shank(K, A), arm(K, B), rod(B, H), foot(A, H);

        input motors { knee = shank.angle + 90deg, motor = arm.angle }
        input joints { knee, ankle = foot.angle - shank.angle - 90deg }
    }
}

mechanism! {
    pub struct Slider {
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        pin B(40mm, 69.282mm), C(280mm, 0);
        link AB(A, B), BC(B, C), ram(C) on bed;

        input crank_side { theta = AB.angle }
        input press { x = ram.slide }
    }
}

mechanism! {
    pub struct Excavator {
        ground O(0, 0), F(0.5m, -0.4m);
        pin G(2.4m, 1.6m), P(5m, 1m), H(2.6m, 2.1m), I(4.6m, 1.7m);
        pin N(5.3m, 0.9m), K(6.4m, -1.1m), T(6.6m, -1.5m), V(7m, -0.9m), W(7.05m, -1.45m), tip(6.9m, -3m);
        link boom(O, P, G, H), stick(P, T, I, N, K), lever(K, V), pull(V, W), bucket(T, W, tip);

        input cylinders { lift = distance(F, G), crowd = distance(H, I), curl = distance(N, V) }
        input joints { swing = boom.angle, reach = stick.angle - boom.angle, dig = bucket.angle - stick.angle }
        input teeth { x = tip.x, y = tip.y, attack = bucket.angle }
    }
}

mechanism! {
    pub struct FiveBar {
        ground A(-50mm, 0), E(50mm, 0);
        pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm);
        link AB(A, B), BC(B, tool), CD(D, tool), ED(E, D);

        input motors { a = AB.angle, b = ED.angle }
        input hand { x = tool.x, y = tool.y }
    }
}

mechanism! {
    pub struct Gripper {
        ground F(50mm, 30mm);
        guide axis through (0, 0) along 0deg;
        pin N(5mm, 0), H(42mm, 12mm), tip(100mm, 20mm);
        link nut(N) on axis, pull(N, H), horn(F, H, tip);

        input screw { s = nut.slide }
        input jaws { opening = 2 * tip.y }
    }
}

mechanism! {
    pub struct Horst {
        ground M(0, 60mm), R(60mm, 330mm), U(190mm, 250mm);
        pin H(-390mm, 10mm), S(-20mm, 380mm), axle(-435mm, 25mm), T(110mm, 400mm);
        link chainstay(M, H), seatstay(H, S, axle), rocker(R, S, T);

        input shock { stroke = distance(T, U) }
        input wheel { travel = axle.y }
        input lever { lean = rocker.angle }
    }
}

mechanism! {
    pub struct Pantograph {
        ground O(0, 0);
        pin A(100mm, 150mm), B(200mm, 300mm), P(200mm, 0), Q(300mm, 150mm), pen(400mm, 0);
        link OB(O, A, B), BQ(B, Q, pen), AP(A, P), PQ(P, Q);

        input stylus { x = P.x, y = P.y }
        input copy { u = pen.x, v = pen.y }
        input arms { a = OB.angle, b = BQ.angle }
    }
}

mechanism! {
    pub struct Platform {
        ground A1(0, 0), A2(400mm, 0), A3(200mm, 346mm);
        pin B1(60mm, 100mm), B2(310mm, -60mm), B3(260mm, 250mm);
        pin C1(150mm, 75mm), C2(250mm, 75mm), C3(200mm, 162mm), hand(200mm, 104mm);
        link arm1(A1, B1), arm2(A2, B2), arm3(A3, B3), rod1(B1, C1), rod2(B2, C2), rod3(B3, C3);
        link plate(hand, C1, C2, C3);

        input motors { q1 = arm1.angle, q2 = arm2.angle, q3 = arm3.angle }
        input tool { x = hand.x, y = hand.y, turn = plate.angle }
    }
}

mechanism! {
    pub struct Scissor {
        ground A(0, 0);
        guide floor through (0, 0) along 0deg;
        pin B(1.6m, 0), M(0.8m, 0.3m), C(0, 0.6m), D(1.6m, 0.6m), N(0.8m, 0.9m), E(0, 1.2m), Q(0.3m, 0.1125m);
        link foot(B) on floor;
        link a(A, D, M, Q), b(B, C, M), c(C, N), d(D, E, N);

        input cylinder { s = distance(Q, N) }
        input deck { h = E.y }
        input arm { lean = a.angle }
    }
}

mechanism! {
    pub struct FlyingShear {
        ground A(0, 0), D(665.7mm, 0);
        pin B(-30mm, 70mm), C(560mm, -360mm), blade(500mm, -410mm);
        link AB(A, B), BC(B, C, blade), DC(D, C);

        input crank_side { theta = AB.angle }
        input strip { x = blade.x }
    }
}

mechanism! {
    pub struct Steering {
        ground L(-0.6m, 0), R(0.6m, 0);
        guide rack through (0, -0.12m) along 0deg;
        pin l(-0.56m, -0.14m), r(0.56m, -0.14m), p(-0.3m, -0.12m), q(0.3m, -0.12m);
        link bar(p, q) on rack, left_rod(p, l), right_rod(q, r), left_wheel(L, l), right_wheel(R, r);

        input column { s = bar.slide }
        input inner { left_turn = left_wheel.angle }
        input outer { right_turn = right_wheel.angle }
    }
}

mechanism! {
    pub struct Toggle {
        ground A(0, 0), D(400mm, 300mm);
        guide bed through (400mm, 0) along -90deg;
        pin B(60mm, 40mm), C(360mm, 130mm), E(400mm, -120mm);
        link AB(A, B), BC(B, C), DC(D, C), CE(C, E), ram(E) on bed;

        input crank_side { theta = AB.angle }
        input press { x = ram.slide }
    }
}

mechanism! {
    pub struct ExcavatorMixed {
        ground O(0, 0), F(0.5m, -0.4m);
        pin G(2.4m, 1.6m), P(5m, 1m), H(2.6m, 2.1m), I(4.6m, 1.7m);
        pin N(5.3m, 0.9m), K(6.4m, -1.1m), T(6.6m, -1.5m), V(7m, -0.9m), W(7.05m, -1.45m), tip(6.9m, -3m);
        link boom(O, P, G, H), stick(P, T, I, N, K), lever(K, V), pull(V, W), bucket(T, W, tip);

        input flat { y = tip.y, crowd = distance(H, I), attack = bucket.angle }
        input reach_in { x = tip.x, lift = distance(F, G), curl = distance(N, V) }
        input deep { x, y, curl }
        input cylinders { lift, crowd, curl }
    }
}

mechanism! {
    pub struct Hoist {
        ground A(0, 0), B(1m, 0), C(0.5m, -0.3m);
        pin P(0.2m, 0.8m), Q(0.8m, 0.8m), M(0.5m, 0.8m), tip(0.5m, 1.3m);
        link plate(P, Q, M, tip);

        input cylinders { a = distance(A, P), b = distance(B, Q), c = distance(C, Q) }
        input pose { x = tip.x, y = tip.y, tilt = plate.angle }
        input half { x, a, b }
    }
}

mechanism! {
    pub struct Leg {
        ground A(0, 0), D(-38cm, -7.8cm);
        pin B(0, 15cm), U(-47cm, 33cm), L(-21cm, -43cm), F(-57cm, -47cm), E(-78cm, -3cm), foot(-30cm, -89cm);
        link AB(A, B), upper(B, U), b(D, U, E), lower(B, L), c(D, L), f(E, F), g(L, F, foot);

        input crank_side { theta = AB.angle }
        input sideways { x = foot.x }
        input up { y = foot.y }
    }
}

mechanism! {
    pub struct Six {
        ground A(0, 0), D(4m, 0), G(6m, 1m);
        pin B(0.5m, 0.8m), C(3.2m, 2.5m), E(4.5m, 3.5m), P(2m, 3m);
        link AB(A, B), BC(B, C, P), DC(D, C, E), EF(E, F), GF(G, F);
        pin F(6.5m, 3m);

        input crank_side { theta = AB.angle }
        input out { psi = GF.angle }
        input tracer { x = P.x }
        input gap { s = distance(P, F) }
    }
}

mechanism! {
    pub struct Planar {
        ground A(0, 0), B(1m, 0), C(1m, 0.1m);
        pin P(0.2m, 0.8m), Q(0.8m, 0.8m), R(0.8m, 0.9m);
        link plate(P, Q, R);

        input cylinders { a = distance(A, P), b = distance(B, Q), c = distance(C, P) }
        input pose { x = P.x, y = P.y, tilt = plate.angle }
    }
}
