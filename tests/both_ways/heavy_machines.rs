//! Machines with masses that are driven in several ways.

use linkage_core::mechanism;

mechanism! {
    pub struct HeavyExcavator {
        load fx, fy: force;
        ground O(0, 0), F(0.5m, -0.4m);
        pin G(2.4m, 1.6m), P(5m, 1m), H(2.6m, 2.1m), I(4.6m, 1.7m);
        pin N(5.3m, 0.9m), K(6.4m, -1.1m), T(6.6m, -1.5m), V(7m, -0.9m), W(7.05m, -1.45m), tip(6.9m, -3m);
        link boom(O, P, G, H), stick(P, T, I, N, K), lever(K, V), pull(V, W), bucket(T, W, tip);
        gravity (0, -9.81);
        mass 900kg on boom at (2.4m, 0.5m) inertia 2500(kg*m^2);
        mass 500kg on stick at (1m, 0.1m) inertia 600(kg*m^2);
        mass 40kg on lever uniform;
        mass 30kg on pull uniform;
        mass 400kg on bucket at (0.3m, -0.4m) inertia 120(kg*m^2);
        force (fx, fy) on tip;

        input cylinders { lift = distance(F, G), crowd = distance(H, I), curl = distance(N, V) }
        input joints { swing = boom.angle, reach = stick.angle - boom.angle, dig = bucket.angle - stick.angle }
        input teeth { x = tip.x, y = tip.y, attack = bucket.angle }
        output lift.drive, crowd.drive, curl.drive, swing.drive, reach.drive, dig.drive, x.drive, y.drive, attack.drive;
    }
}

mechanism! {
    pub struct HeavyFiveBar {
        load fx, fy: force;
        ground A(-50mm, 0), E(50mm, 0);
        pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm);
        link AB(A, B), BC(B, tool), CD(D, tool), ED(E, D);
        gravity (0, -9.81);
        mass 0.4kg on AB uniform;
        mass 0.3kg on BC uniform;
        mass 0.3kg on CD uniform;
        mass 0.4kg on ED uniform;
        mass 0.2kg on tool;
        force (fx, fy) on tool;

        input motors { a = AB.angle, b = ED.angle }
        input hand { x = tool.x, y = tool.y }
        output a.drive, b.drive, x.drive, y.drive;
    }
}

mechanism! {
    pub struct HeavyHorst {
        load ground_force: force;
        ground M(0, 60mm), R(60mm, 330mm), U(190mm, 250mm);
        pin H(-390mm, 10mm), S(-20mm, 380mm), axle(-435mm, 25mm), T(110mm, 400mm);
        link chainstay(M, H), seatstay(H, S, axle), rocker(R, S, T);
        gravity (0, -9.81);
        mass 0.7kg on chainstay uniform;
        mass 0.6kg on seatstay uniform;
        mass 0.3kg on rocker at (50mm, 20mm) inertia 0.001(kg*m^2);
        mass 2.2kg on axle;
        force (0, ground_force) on axle;

        input shock { stroke = distance(T, U) }
        input wheel { travel = axle.y }
        input lever { lean = rocker.angle }
        output stroke.drive, travel.drive, lean.drive;
    }
}

mechanism! {
    pub struct HeavyToggle {
        load work: force;
        ground A(0, 0), D(400mm, 300mm);
        guide bed through (400mm, 0) along -90deg;
        pin B(60mm, 40mm), C(360mm, 130mm), E(400mm, -120mm);
        link AB(A, B), BC(B, C), DC(D, C), CE(C, E), ram(E) on bed;
        gravity (0, -9.81);
        inertia 0.5(kg*m^2) on AB;
        mass 8kg on BC uniform;
        mass 10kg on DC uniform;
        mass 10kg on CE uniform;
        mass 60kg on E;
        force (0, work) on E;

        input crank_side { theta = AB.angle }
        input press { x = ram.slide }
        output theta.drive, x.drive;
    }
}

mechanism! {
    pub struct HeavyAnkle {
        load fx, fy: force;
        ground K(0, 0);
        pin A(0, -400mm), B(50mm, 0), H(60mm, -400mm), toe(120mm, -430mm);
        link shank(K, A), arm(K, B), rod(B, H), foot(A, H, toe);
        gravity (0, -9.81);
        mass 3kg on shank uniform;
        mass 0.3kg on arm uniform;
        mass 0.25kg on rod uniform;
        mass 1kg on foot at (30mm, -10mm) inertia 0.002(kg*m^2);
        force (fx, fy) on toe;

        input motors { knee = shank.angle + 90deg, motor = arm.angle }
        input joints { knee, ankle = foot.angle - shank.angle - 90deg }
        output knee.drive, motor.drive, ankle.drive;
    }
}
