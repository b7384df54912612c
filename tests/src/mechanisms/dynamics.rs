//! Mechanisms that move under forces.

use linkage_core::{Point, mechanism};

mechanism! {
    /// Theo Jansen's leg, every bar uniform, its crank free to turn.
    pub struct FallingLeg {
        input theta: angle;

        ground A(0, 0), D(-38cm, -7.8cm);

        crank AB(A) -> B           { length: 15cm, angle: theta }
        rrr   upper(B), b(D) -> U  { lengths: (50cm, 41.5cm), mode: right }
        rrr   lower(B), c(D) -> L  { lengths: (61.9cm, 39.3cm), mode: left }
        point E on b at distances (40.1cm, 55.8cm) left;
        rrr   f(E), g(L) -> F      { lengths: (39.4cm, 36.7cm), mode: right }
        point foot on g at distances (49cm, 65.7cm) left;

        gravity (0, -9.81);
        mass 0.15kg on AB uniform;
        mass 0.5kg on upper uniform;
        mass 0.415kg on b uniform;
        mass 0.619kg on lower uniform;
        mass 0.393kg on c uniform;
        mass 0.394kg on f uniform;
        mass 0.367kg on g uniform;
        mass 0.1kg on g at foot;

        output B, U, L, E, F, foot, energy, theta.drive;
    }
}

/// By how much the worst of the eleven bars of Jansen's leg is not as long as declared. The points are
/// `B`, `U`, `L`, `E`, `F` and `foot`.
#[must_use]
pub fn leg_opening([b, u, l, e, f, foot]: [Point<f64>; 6]) -> f64 {
    let [a, d] = [Point { x: 0.0, y: 0.0 }, Point { x: -0.38, y: -0.078 }];
    let bars = [
        (a, b, 0.15),
        (b, u, 0.5),
        (d, u, 0.415),
        (b, l, 0.619),
        (d, l, 0.393),
        (d, e, 0.401),
        (u, e, 0.558),
        (e, f, 0.394),
        (l, f, 0.367),
        (l, foot, 0.49),
        (f, foot, 0.657),
    ];
    bars.iter().map(|(a, b, length)| (a.distance(*b) - length).abs()).fold(0.0, f64::max)
}

mechanism! {
    /// The four-bar of uniform bars, its rocker on a torsion spring.
    pub struct SwingingFourBar {
        input theta: angle;
        param k = 2(N*m/rad);
        param c = 0(N*m*s);
        ground A(0, 0), D(750mm, 0);
        crank AB(A) -> B { length: 250mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }
        gravity (0, -9.81);
        mass 52.21g on AB uniform;
        mass 104.21g on BC uniform;
        mass 102.21g on DC uniform;
        spring coil between ground and DC { stiffness: k, free_angle: 90deg, damping: c }
        output theta.drive, DC, energy;
    }
}

mechanism! {
    /// Andrews' squeezing mechanism: seven bodies, one input (Mazzia and Magherini, Test Set for Initial
    /// Value Problem Solvers, release 2.4).
    pub struct Squeezer {
        input beta: angle;
        ground O(0, 0), A(-69.34mm, -2.27mm), B(-36.35mm, 32.73mm), C(14mm, 72mm);
        crank K1(O) -> Q        { length: 7mm, angle: beta }
        rrr   K2(Q), K3(B) -> P { lengths: (28mm, 35mm), mode: left }
        rrr   K4(P), K5(A) -> E { lengths: (20mm, 40mm), mode: right }
        rrr   K6(P), K7(A) -> F { lengths: (20mm, 40mm), mode: left }
        point D on K3 at (18mm, 20mm);
        mass 43.25g on K1 at (0.92mm, 0) inertia 2.194e-6(kg*m^2);
        mass 3.65g on K2 at (11.5mm, 0) inertia 4.41e-7(kg*m^2);
        mass 23.73g on K3 at (10.43mm, 18.74mm) inertia 5.255e-6(kg*m^2);
        mass 7.06g on K4 at (14.21mm, 0) inertia 5.667e-7(kg*m^2);
        mass 70.5g on K5 at (23.08mm, 9.16mm) inertia 1.169e-5(kg*m^2);
        mass 7.06g on K6 at (14.21mm, 0) inertia 5.667e-7(kg*m^2);
        mass 54.98g on K7 at (12.28mm, 4.49mm) inertia 1.912e-5(kg*m^2);
        spring between D and C { stiffness: 4530(N/m), free_length: 77.85mm }
        output beta.drive, K3.P, K4.P, K6.P, energy;
    }
}

mechanism! {
    /// A four-bar whose every number can be drawn.
    pub struct AnyFourBar {
        input theta: angle;
        param crank = 1m;
        param coupler = 3m;
        param rocker = 2.5m;
        param aside = 0.4m;
        param m1 = 2kg;
        param m2 = 3kg;
        param m3 = 1kg;
        param k = 40(N/m);
        param c = 3(N*s/m);
        load pull: force;
        load brake: number;
        ground A(0, 0), D(3m, aside), S(1m, 4m);
        crank AB(A) -> B { length: crank, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
        point P on BC at (1m, -0.5m);
        gravity (1, -9.81);
        mass m1 on AB at (0.3m, 0.1m) inertia 0.2(kg*m^2);
        mass m2 on BC at P inertia 0.5(kg*m^2);
        mass m3 on DC uniform;
        mass 0.4kg on C;
        spring between S and P { stiffness: k, free_length: 1.5m, damping: c }
        force (pull, 0) in BC on P;
        torque -0.6(N*m*s) * brake * rate(DC.angle) on DC;
        output theta.drive, P, BC, DC, reach = distance(S, P), energy;
    }
}

mechanism! {
    /// A quick return with a loaded ram: sliding blocks of every kind.
    pub struct HeavyShaper {
        input theta: angle;
        load cut: force;
        ground A(0, 0), D(0, -1m);
        guide rail through (0, 0.8m) along 0deg;
        crank AB(A) -> B          { length: 0.4m, angle: theta }
        rpr   block(B), rod(D)    { offset: 50mm }
        point E on rod at (1.6m, 0);
        rpp   pin(E), ram(rail)   { slot: 75deg, offsets: (20mm, -30mm) }
        guide post through (2.5m, 0) along 80deg;
        guide arm on AB through B along 70deg;
        prp   shoe(arm), follower(post) -> C { offsets: (0.1m, -0.2m) }
        gravity (0, -9.81);
        mass 4kg on AB at (-0.1m, 0.02m) inertia 0.3(kg*m^2);
        mass 1.5kg on block at (0.02m, 0.01m) inertia 0.01(kg*m^2);
        mass 6kg on rod at (0.7m, 0) inertia 1.1(kg*m^2);
        mass 1kg on pin at (0, 0.03m) inertia 0.004(kg*m^2);
        mass 12kg on ram at (0.2m, 0.1m) inertia 2(kg*m^2);
        mass 0.8kg on shoe at (0.05m, 0) inertia 0.002(kg*m^2);
        mass 2kg on follower at (0, 0.1m) inertia 0.1(kg*m^2);
        force (-cut - 5(N*s/m) * rate(ram.slide), 0) in ram on E;
        output theta.drive, E, ram, energy;
    }
}

mechanism! {
    /// A five-bar robot whose hand carries a load.
    pub struct HeavyRobot {
        input first, second: angle;
        ground A(0, 0), D(0.4m, 0);
        crank AB(A) -> B { length: 0.3m, angle: first }
        crank DE(D) -> E { length: 0.3m, angle: second }
        rrr BC(B), EC(E) -> C { lengths: (0.5m, 0.5m), mode: left }
        gravity (0, -9.81);
        mass 0.8kg on AB uniform;
        mass 0.8kg on DE uniform;
        mass 0.5kg on BC uniform;
        mass 0.5kg on EC uniform;
        mass 0.7kg on C;
        inertia 0.01(kg*m^2) on DE;
        spring between A and C { stiffness: 60(N/m), free_length: 0.5m, damping: 2(N*s/m) }
        output first.drive, second.drive, C, reach = distance(A, C), energy;
    }
}

mechanism! {
    /// A boom on a cylinder whose length is the second input: what swings with the first, moves with it.
    pub struct TiltedLift {
        input tilt: angle;
        input lift: length;
        ground A(0, 0), D(0.8m, -0.2m);
        rrr tube(D), boom(A) -> C { lengths: (lift, 1.2m), mode: right }
        rrr stay(D), mast(A) -> M { lengths: (1m, lift), mode: right }
        crank jib(M) -> T { length: 0.9m, angle: tilt, relative_to: boom }
        gravity (0, -9.81(m/s^2));
        mass 12kg on tube at (0.3m, 0) inertia 0.2(kg*m^2);
        mass 4kg on tube at (lift - 0.25m, 0);
        mass 20kg on boom uniform;
        mass 9kg on jib uniform;
        mass 3kg on M;
        output tilt.drive, lift.drive, energy;
    }
}

mechanism! {
    /// Three inputs and a gear: the second axis turns a third of what its motor turns.
    pub struct GearedArm {
        input base: length;
        input shoulder, motor: angle;
        ground O(0, 0);
        guide bed through O along 0deg;
        slider cart(bed) -> P { slide: base }
        crank upper(P) -> E { length: 0.4m, angle: shoulder }
        crank fore(E) -> H  { length: 0.3m, angle: motor / 3, relative_to: upper }
        gravity (0, -9.81);
        mass 6kg on P;
        mass 2kg on upper uniform;
        mass 1kg on fore uniform;
        mass 0.5kg on H;
        spring between upper and fore { stiffness: 3(N*m/rad), free_angle: 20deg, damping: 0.2(N*m*s) }
        output base.drive, shoulder.drive, motor.drive, energy;
    }
}

mechanism! {
    /// A rocker that drives a crank: at 90° coupler and crank are in line, and the rocker can go no further.
    pub struct RockerDriven {
        input rocker: angle;
        ground A(0, 0), D(1.6m, 0);
        crank AB(A) -> B { length: 1.2m, angle: rocker }
        rrr BC(B), DC(D) -> C { lengths: (1.25m, 0.75m), mode: left }
        mass 1kg on AB uniform;
        mass 1kg on BC uniform;
        mass 1kg on DC uniform;
        output rocker.drive, C, BC;
    }
}

mechanism! {
    /// A crank without mass that drives a piston with mass, which a dead centre leaves at rest.
    pub struct LightCrank {
        input theta: angle;
        param flywheel = 0(kg*m^2);
        ground A(0, 0);
        guide way through A along 0deg;
        crank AB(A) -> B          { length: 100mm, angle: theta }
        rrp BC(B), piston(way) -> C { length: 300mm, mode: ahead }
        mass 2kg on C;
        inertia flywheel on AB;
        output theta.drive, C;
    }
}

mechanism! {
    /// Both assemblies of one triangle, and mass on both.
    pub struct Twins {
        input theta: angle;
        ground A(0, 0), D(2m, 0);
        crank AB(A) -> P { length: 1m, angle: theta }
        rrr K4(P), K5(D) -> E { lengths: (1.5m, 1m), mode: right }
        rrr K6(P), K7(D) -> F { lengths: (1.5m, 1m), mode: left }
        mass 1kg on AB uniform;
        mass 1kg on K4 uniform;
        mass 2kg on K7 uniform;
        output theta.drive, E, F;
    }
}

mechanism! {
    /// The same with mass on the second alone.
    pub struct Twin {
        input theta: angle;
        ground A(0, 0), D(2m, 0);
        crank AB(A) -> P { length: 1m, angle: theta }
        rrr K4(P), K5(D) -> E { lengths: (1.5m, 1m), mode: right }
        rrr K6(P), K7(D) -> F { lengths: (1.5m, 1m), mode: left }
        mass 1kg on AB uniform;
        mass 2kg on K7 uniform;
        output theta.drive, E, F;
    }
}
