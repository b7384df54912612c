//! Mechanisms with masses and loads.

use linkage_core::mechanism;

mechanism! {
    /// Four-bar of uniform bars, whose weight can be switched off.
    pub struct HeavyFourBar {
        input theta: angle;
        param g = 9.81(m/s^2);
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        gravity (0, -g);
        mass 52.21g on AB uniform;
        mass 104.21g on BC uniform;
        mass 102.21g on DC uniform;
    }
}

mechanism! {
    /// The same, asked for its torque alone.
    pub struct DrivenFourBar {
        input theta: angle;
        param g = 9.81(m/s^2);
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        gravity (0, -g);
        mass 52.21g on AB uniform;
        mass 104.21g on BC uniform;
        mass 102.21g on DC uniform;
        output theta.drive;
    }
}

mechanism! {
    /// Six-bar of crank, RPR and RPP group.
    pub struct HeavySixBar {
        input theta: angle;
        ground A(0, 0), D(0, -1m);
        guide rail through (0, 800mm) along 0deg;
        crank AB(A) -> B { length: 400mm, angle: theta }
        rpr block(B), rod(D) {}
        point E on rod at (1.6m, 0);
        rpp slider(E), yoke(rail) { slot: 90deg }
        gravity (0, -9.8(m/s^2));
        mass 1.2kg on AB at (0.2m, 0) inertia 0.016(kg*m^2);
        mass 1.5kg on block at (0, 0);
        mass 10kg on rod at (0.8m, 0) inertia 2.2(kg*m^2);
        output block.B, block.rod, rod.D, AB.drive;
    }
}

mechanism! {
    /// A press with a load on its ram, and dimensions to tune.
    pub struct Press {
        input theta: angle;
        param r = 100mm;
        param counterweight = 2kg;
        load work: force;
        load friction: torque;
        ground A(0, 0);
        guide way through (0, 0) along -90deg;
        crank AB(A) -> B { length: r, angle: theta }
        rrp BC(B), ram(way) -> C { length: 400mm, mode: ahead }
        gravity (0, -9.81(m/s^2));
        mass counterweight on AB at (-r, 0);
        mass 3kg on BC uniform;
        mass 8kg on ram at (0, 0) inertia 0.1(kg*m^2);
        force (0, work) on C;
        torque friction between ground and AB;
    }
}

mechanism! {
    /// A lift on a cylinder, two inputs, a single load, a rod that moves with the length.
    pub struct Lift {
        input lift: length;
        input tilt: angle;
        load cargo: force;
        ground A(0, 0), D(0.8m, -0.2m);
        rrr tube(D), boom(A) -> C { lengths: (lift, 1.2m), mode: right }
        crank jib(C) -> T { length: 0.9m, angle: tilt, relative_to: boom }
        gravity (0, -9.81(m/s^2));
        mass 12kg on tube at (0.3m, 0) inertia 0.2(kg*m^2);
        mass 4kg on tube at (lift - 0.25m, 0);
        mass 20kg on boom uniform;
        mass 9kg on jib uniform;
        force (0, -cargo) on T;
    }
}

mechanism! {
    /// A crank between springs of every kind.
    pub struct SprungCrank {
        input theta: angle;
        param k = 150(N/m);
        param c = 3(N*s/m);
        ground A(0, 0), D(500mm, 0), E(200mm, 0), O(-300mm, 100mm);
        crank AB(A) -> B { length: 200mm, angle: theta }
        /// Between the crank's pin and the frame.
        spring shock between D and B { stiffness: k, free_length: 0.25m, damping: c }
        spring soft between O and B { stiffness: 20(N/m), free_length: 0 }
        spring coil between ground and AB { stiffness: 2(N*m/rad), free_angle: 30deg, damping: 0.1(N*m*s) }
        torque -0.4(N*m*s) * rate(AB.angle) on AB;
        output theta.drive, shock.force, coil.torque, shock.length, coil.angle;
    }
}

mechanism! {
    /// A pin that runs through the end of its spring, and a rope that only pulls.
    pub struct Meeting {
        input theta: angle;
        ground A(0, 0), E(200mm, 0), D(800mm, 0);
        crank AB(A) -> B { length: 200mm, angle: theta }
        spring between E and B { stiffness: 100(N/m), free_length: 50mm }
        let slack = distance(D, B) - 0.7m;
        force -500(N/m) * (slack + hypot(slack, 1mm)) / 2 between D and B;
        output theta.drive;
    }
}

mechanism! {
    /// A rocker on a torsion spring and two dampers against its coupler.
    pub struct SprungRocker {
        input theta: angle;
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        spring stop between ground and DC { stiffness: 12(N*m/rad), free_angle: 90deg }
        spring joint between BC and DC { damping: 0.7(N*m*s) }
        force (-2(N*s/m) * rate(C.x), -2(N*s/m) * rate(C.y)) on C;
    }
}

mechanism! {
    /// A four-bar with masses of every kind, asked for what they do together.
    pub struct ShakenFourBar {
        input theta: angle;
        param extra = 30g;
        ground A(100mm, -50mm), D(850mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        point G on BC at (200mm, 80mm);
        gravity (0, -9.81);
        mass 52.21g on AB uniform;
        mass 104.21g on BC at G inertia 0.002(kg*m^2);
        mass 102.21g on DC uniform;
        mass extra on C;
        inertia 0.001(kg*m^2) on AB;
        mass 20g on BC at (100mm * sin(theta), -30mm) inertia 0.0001(kg*m^2);
        output energy, shaking, centre_of_mass, theta.drive, AB.drive, AB.A, DC.D, AB, BC, DC, B, C, G;
    }
}

mechanism! {
    /// A lift on a cylinder and a spring, asked for what its masses do together.
    pub struct SprungLift {
        input lift: length;
        input tilt: angle;
        ground A(0, 0), D(0.8m, -0.2m);
        rrr tube(D), boom(A) -> C { lengths: (lift, 1.2m), mode: right }
        crank jib(C) -> T { length: 0.9m, angle: tilt, relative_to: boom }
        gravity (0, -9.81(m/s^2));
        mass 12kg on tube at (0.3m, 0) inertia 0.2(kg*m^2);
        mass 4kg on tube at (lift - 0.25m, 0);
        mass 20kg on boom uniform;
        mass 9kg on jib uniform;
        mass 3kg on C;
        spring between D and T { stiffness: 900(N/m), free_length: 0.4m, damping: 40(N*s/m) }
        spring between boom and jib { stiffness: 30(N*m/rad), free_angle: 0.3rad, damping: 2(N*m*s) }
        output energy, shaking, centre_of_mass, lift.drive, tilt.drive, dT = distance(D, T);
    }
}

mechanism! {
    /// Loads that are called like what is given beside them.
    pub struct Loads {
        input theta: angle;
        load theta_rate: force;
        ground A(0, 0);
        crank AB(A) -> B { length: 100mm, angle: theta }
        force (0, -theta_rate) on B;
    }
}

mechanism! {
    /// Several inputs and one load of their name.
    pub struct Rates {
        input a, b: angle;
        load rates: torque;
        ground A(0, 0);
        crank AB(A) -> B { length: 100mm, angle: a }
        crank BC(B) -> C { length: 100mm, angle: b }
        torque rates between AB and BC;
    }
}

mechanism! {
    /// Two parallelogram four-bars in a row, links of 1 m and 1 kg: one pendulum (IFToMM benchmark A02).
    pub struct TwoParallelograms {
        input q: angle;
        ground A(0, 0), C(1m, 0), E(2m, 0);
        crank AB(A) -> B { length: 1m, angle: q }
        crank CD(C) -> D { length: 1m, angle: 0, relative_to: AB }
        crank EF(E) -> F { length: 1m, angle: 0, relative_to: AB }
        crank BD(B)      { angle: 0 }
        crank DF(D)      { angle: 0 }
        gravity (0, -9.81(m/s^2));
        mass 1kg on AB uniform;
        mass 1kg on CD uniform;
        mass 1kg on EF uniform;
        mass 1kg on BD at (0.5m, 0);
        mass 1kg on DF at (0.5m, 0);
    }
}

mechanism! {
    /// A mass on a spring and a damper.
    pub struct Oscillator {
        input x: length;
        param k = 15(N/m);
        param c = 0(N*s/m);
        load push: force;
        ground O(0, 0);
        guide rail through O along 0deg;
        slider body(rail) -> P { slide: x }
        mass 1.6632kg on P;
        force (push - k * x - c * rate(x), 0) on P;
    }
}

mechanism! {
    /// Two masses between springs, the second at the end.
    pub struct TwoMasses {
        input x, y: length;
        load push: force;
        ground O(0, 0);
        guide rail through O along 0deg;
        slider first(rail) -> P { slide: x }
        slider second(rail) -> Q { slide: y }
        mass 1.6632kg on P;
        mass 1.6632kg on Q;
        force (-15(N/m) * x, 0) on P;
        force (15(N/m) * (y - x), 0) on P;
        force (push - 15(N/m) * (y - x), 0) on Q;
    }
}

mechanism! {
    /// A trolley with a hanging load: its sway is an input without a drive.
    pub struct Crane {
        input x: length;
        input sway: angle;
        ground O(0, 0);
        guide rail through O along 0deg;
        slider trolley(rail) -> P { slide: x }
        crank rope(P) -> L { length: 2m, angle: sway - 90deg }
        gravity (0, -9.81);
        mass 5kg on P;
        mass 3kg on L;
        inertia 0.1(kg*m^2) on rope;
    }
}
