//! Mechanisms of which a load drives an input, each beside the same whose loads are all given.

use linkage_core::mechanism;

mechanism! {
    /// An engine: the gas at the piston turns the crank, against a brake.
    pub struct Engine {
        input theta: angle;
        param damping = 20(N*s/m);
        load brake: torque;
        load gas: force;
        ground A(0, 0);
        guide bore through (0, 10mm) along 5deg;
        crank AB(A) -> B              { length: 80mm, angle: theta }
        rrp   BC(B), piston(bore) -> C { length: 250mm, mode: ahead }
        gravity (0, -9.81(m/s^2));
        inertia 0.05(kg*m^2) on AB;
        mass 3kg on BC uniform;
        mass 4kg on piston at (10mm, 0);
        let on_piston = (gas - damping * rate(piston.slide)) * 2 - gas;
        force (on_piston, 0) in piston on C;
        force (0, 0.1 * gas / (1 + rate(theta) / 50(rad/s))) on B;
        torque -brake on AB;
        spring between A and C { stiffness: 300(N/m), free_length: 0.2m, damping: 5(N*s/m) }
        drive theta by gas;
        output gas, AB.A, BC.B, BC.C, piston.bore, shaking, energy, twice = 2 * gas * rate(piston.slide),
            on_piston;
    }
}

mechanism! {
    /// The same under a gas that is given.
    pub struct GivenEngine {
        input theta: angle;
        param damping = 20(N*s/m);
        load brake: torque;
        load gas: force;
        ground A(0, 0);
        guide bore through (0, 10mm) along 5deg;
        crank AB(A) -> B              { length: 80mm, angle: theta }
        rrp   BC(B), piston(bore) -> C { length: 250mm, mode: ahead }
        gravity (0, -9.81(m/s^2));
        inertia 0.05(kg*m^2) on AB;
        mass 3kg on BC uniform;
        mass 4kg on piston at (10mm, 0);
        let on_piston = (gas - damping * rate(piston.slide)) * 2 - gas;
        force (on_piston, 0) in piston on C;
        force (0, 0.1 * gas / (1 + rate(theta) / 50(rad/s))) on B;
        torque -brake on AB;
        spring between A and C { stiffness: 300(N/m), free_length: 0.2m, damping: 5(N*s/m) }
        output theta.drive, AB.A, BC.B, BC.C, piston.bore, shaking, energy,
            twice = 2 * gas * rate(piston.slide), on_piston;
    }
}

mechanism! {
    /// An arm whose elbow a cylinder bends.
    pub struct Arm {
        input shoulder, elbow: angle;
        load cylinder: force;
        load hand: force;
        ground O(0, 0);
        crank upper(O) -> E { length: 0.5m, angle: shoulder }
        crank fore(E) -> H  { length: 0.4m, angle: elbow, relative_to: upper }
        point P on upper at (0.1m, 60mm);
        point Q on fore at (0.1m, 50mm);
        gravity (0, -9.81(m/s^2));
        mass 4kg on upper uniform;
        mass 2kg on fore at (0.25m, 10mm) inertia 0.03(kg*m^2);
        force (0, -hand) on H;
        force cylinder - 8(N*s/m) * rate(distance(P, Q)) between P and Q;
        drive elbow by cylinder;
        output shoulder.drive, cylinder, upper.O, fore.E, energy;
    }
}

mechanism! {
    /// The same under a force of the cylinder that is given.
    pub struct GivenArm {
        input shoulder, elbow: angle;
        load cylinder: force;
        load hand: force;
        ground O(0, 0);
        crank upper(O) -> E { length: 0.5m, angle: shoulder }
        crank fore(E) -> H  { length: 0.4m, angle: elbow, relative_to: upper }
        point P on upper at (0.1m, 60mm);
        point Q on fore at (0.1m, 50mm);
        gravity (0, -9.81(m/s^2));
        mass 4kg on upper uniform;
        mass 2kg on fore at (0.25m, 10mm) inertia 0.03(kg*m^2);
        force (0, -hand) on H;
        force cylinder - 8(N*s/m) * rate(distance(P, Q)) between P and Q;
        output shoulder.drive, elbow.drive, upper.O, fore.E, energy;
    }
}

mechanism! {
    /// A press whose ram is commanded, its crank turned by a motor.
    pub struct Commanded {
        input x: length;
        load work: force;
        load motor: torque;
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: falling }
        mass 40kg on C;
        inertia 0.05(kg*m^2) on AB;
        force (work, 0) on C;
        torque motor on AB;
        drive x by motor;
        output theta, motor, energy;
    }
}

mechanism! {
    /// The same, asked for the drive at its crank.
    pub struct AskedPress {
        input x: length;
        load work: force;
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: falling }
        mass 40kg on C;
        inertia 0.05(kg*m^2) on AB;
        force (work, 0) on C;
        output theta, theta.drive, x.drive;
    }
}

mechanism! {
    /// A flywheel on a crank that a force along the ground turns.
    pub struct Lever {
        input theta: angle;
        load push: force;
        ground A(0, 0);
        crank AB(A) -> B { length: 0.3m, angle: theta }
        inertia 0.5(kg*m^2) on AB;
        force (push, 0) on B;
        drive theta by push;
        output push;
    }
}
