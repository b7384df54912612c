//! Mechanisms whose joints rub and of which a load drives an input, with and without given loads.

use linkage_core::mechanism;

mechanism! {
    /// A crank that its piston pushes, against 1 N·m.
    pub struct PushedCrank {
        input theta: angle;
        load push: force;
        ground A(0, 0);
        guide bore through A along 0deg;
        crank AB(A) -> B              { length: 80mm, angle: theta }
        rrp   BC(B), piston(bore) -> C { length: 250mm, mode: ahead }
        torque -1(N*m) on AB;
        force (push, 0) on C;
        friction 0.15 at A radius 20mm;
        friction 0.15 at B radius 20mm;
        friction 0.15 on BC at C radius 20mm;
        drive theta by push;
    }
}

mechanism! {
    /// An engine whose joints all rub.
    pub struct RubbingEngine {
        input theta: angle;
        param mu = 0.1;
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
        force (gas - 20(N*s/m) * rate(piston.slide), 0) in piston on C;
        torque -brake on AB;
        friction mu at A radius 20mm;
        friction mu at B radius 20mm;
        friction mu on BC at C radius 15mm;
        friction mu on piston length 90mm;
        drive theta by gas;
        output gas, AB.A, BC.B, BC.C, piston.bore, losses, AB.A.friction, piston.bore.friction,
            taken = losses + brake * rate(theta);
    }
}

mechanism! {
    /// The same under a gas that is given.
    pub struct GivenRubbingEngine {
        input theta: angle;
        param mu = 0.1;
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
        force (gas - 20(N*s/m) * rate(piston.slide), 0) in piston on C;
        torque -brake on AB;
        friction mu at A radius 20mm;
        friction mu at B radius 20mm;
        friction mu on BC at C radius 15mm;
        friction mu on piston length 90mm;
        output theta.drive, AB.A, BC.B, BC.C, piston.bore, losses, AB.A.friction,
            piston.bore.friction, taken = losses + brake * rate(theta);
    }
}

mechanism! {
    /// An arm whose elbow a cylinder bends, and whose shoulder is driven.
    pub struct RubbingReach {
        input shoulder, elbow: angle;
        param mu = 0.1;
        load hand: force;
        load cylinder: force;
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
        friction mu at O radius 40mm;
        friction mu at E radius 30mm;
        drive elbow by cylinder;
        output cylinder, shoulder.drive, upper.O, fore.E, losses, fore.E.friction;
    }
}

mechanism! {
    /// The same under a cylinder that is given.
    pub struct GivenRubbingReach {
        input shoulder, elbow: angle;
        param mu = 0.1;
        load hand: force;
        load cylinder: force;
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
        friction mu at O radius 40mm;
        friction mu at E radius 30mm;
        output elbow.drive, shoulder.drive, upper.O, fore.E, losses, fore.E.friction;
    }
}
