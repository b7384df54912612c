//! Machines with mass and an unknown.

use linkage_core::mechanism;

/// A press on whose ram a second loop hangs, driven in one way or the other.
macro_rules! press {
    ($(#[$docs:meta])* $name:ident
        { $($input:tt)* } { $($unknown:tt)* } { $($solve:tt)* } { $($output:tt)* }) => {
        mechanism! {
            $(#[$docs])*
            pub struct $name {
                $($input)*
                param ram_mass = 8kg;
                load work: force;

                ground O(0, 0), D(0.45m, -0.25m);
                guide bed through (0, 20mm) along 0deg;

                $($unknown)*
                crank OB(O) -> B           { length: 80mm, angle: theta }
                rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
                $($solve)*
                rrr   CE(C), DE(D) -> E    { lengths: (0.3m, 0.25m), mode: left }

                gravity (0, -9.81);
                mass 2kg on OB uniform;
                mass 3kg on BC uniform;
                mass ram_mass on ram at (10mm, 5mm) inertia 0.1(kg*m^2);
                mass 1kg on DE at (0.1m, 0.02m) inertia 0.01(kg*m^2);
                mass 0.5kg on E;
                inertia 0.05(kg*m^2) on OB;
                force (work, 0) on C;
                torque -0.2(N*m*s) * rate(OB.angle) on OB;
                force (-3(N*s/m) * rate(C.x), 0) on C;
                spring balance between O and E
                    { stiffness: 900(N/m), free_length: 0.2m, damping: 30(N*s/m) }
                spring coil between ground and OB
                    { stiffness: 2(N*m/rad), free_angle: 30deg, damping: 0.1(N*m*s) }

                output balance.force, coil.torque, shaking, energy, centre_of_mass;
                output $($output)*
            }
        }
    };
}

press! {
    /// The ram's place is given, and the crank's angle is sought.
    RamDriven
        { input x: length; }
        { unknown theta: angle between (10deg, 165deg); }
        { solve theta { ram.slide = x, mode: falling } }
        { theta, E, x.drive, theta.drive; }
}

press! {
    /// The crank's angle is given.
    CrankDriven { input theta: angle; } {} {} { ram.slide, E, theta.drive; }
}

mechanism! {
    /// A plate of class III on three legs: the angle of one is sought, the length of another is the
    /// equation.
    pub struct HeavyTriad {
        input turn: angle;
        ground A1(0, 0), A2(2.6m, 0.1m), O(2m, 1.5m);
        crank drive(O) -> P { length: 0.15m, angle: turn }
        unknown phi: angle between (45deg, 66deg);
        crank leg1(A1) -> C1 { length: 1.6m, angle: phi }
        rrr   plate(P), leg2(C1) -> C2 { lengths: (0.9m, 0.7m), mode: left }
        point C3 on plate at (0.6m, 0.25m);
        solve phi { distance(A2, C3) = 1.1m, mode: rising }

        gravity (0.5, -9.81);
        mass 5kg on plate at (0.4m, 0.1m) inertia 0.8(kg*m^2);
        mass 2kg on leg1 uniform;
        mass 1kg on leg2 uniform;
        mass 0.7kg on C2;
        spring between A2 and C2 { stiffness: 300(N/m), free_length: 0.5m }
    }
}

mechanism! {
    /// Two unknowns and two inputs, the second unknown behind the first.
    pub struct HeavyPair {
        input x, h: length;
        ground A(0, 0), D(0.9m, 0);
        guide bed through (0, 0) along 0deg;
        guide post through (1.4m, 0) along 90deg;
        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: falling }
        unknown phi: angle between (-60deg, 60deg);
        crank DE(D) -> E { length: 0.3m, angle: phi, relative_to: BC }
        rrp   EF(E), block(post) -> F { length: 0.5m, mode: ahead }
        solve phi { block.slide = h, mode: rising }

        gravity (0, -9.81);
        mass 1kg on AB uniform;
        mass 3kg on BC uniform;
        mass 4kg on ram at (0, 10mm) inertia 0.02(kg*m^2);
        mass 2kg on DE at (0.1m, 0.03m) inertia 0.03(kg*m^2);
        mass 1kg on F;
        spring between C and E { stiffness: 200(N/m), free_length: 0.3m }
        output theta, phi, x.drive, h.drive, energy;
    }
}

mechanism! {
    /// A ram that turns back where its input is zero: there no drive at the crank can tell the input's.
    pub struct TurningBack {
        input x: length;
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = 0.25m + x * x / 1m, mode: falling }
        force (-100N, 0) on C;
        output theta, x.drive, theta.drive;
    }
}
