//! Mechanisms whose joints rub.

use linkage_core::mechanism;

mechanism! {
    /// Slider-crank with friction at every joint, its ram a block that touches its guide at both ends.
    pub struct RubbingPress {
        input theta: angle;
        param pins = 0.1;
        param radius = 20mm;
        param ways = 0.1;
        param block = 60mm;
        param offset = 0mm;
        load work: force;
        ground A(0, 0);
        guide bed through (0, offset) along 0deg;
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        gravity (0, -9.81(m/s^2));
        inertia 0.05(kg*m^2) on AB;
        mass 3kg on BC uniform;
        mass 40kg on ram at (0, 0);
        force (work, 0) on C;
        friction pins at A radius radius;
        friction pins at B radius radius;
        friction pins on BC at C radius radius;
        friction ways on ram length block;
    }
}

mechanism! {
    /// The same with friction at its ram alone, whose couple does not count.
    pub struct RubbingRam {
        input theta: angle;
        load work: force;
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrp BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        gravity (0, -9.81(m/s^2));
        inertia 0.05(kg*m^2) on AB;
        mass 3kg on BC uniform;
        mass 40kg on ram at (0, 0);
        force (work, 0) on C;
        friction 0.15 on ram;
    }
}

mechanism! {
    /// Four-bar with friction at its four pins.
    pub struct RubbingFourBar {
        input theta: angle;
        param mu = 0.1;
        param radius = 20mm;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }
        gravity (0, -9.81(m/s^2));
        mass 2kg on AB at (40mm, 0) inertia 0.04(kg*m^2);
        mass 6kg on BC at (316mm, 0) inertia 0.12(kg*m^2);
        mass 4kg on DC at (187mm, 0) inertia 0.08(kg*m^2);
        torque 50(N*m) on DC;
        friction mu at A radius radius;
        friction mu at B radius radius;
        friction mu at C radius radius;
        friction mu at D radius radius;
    }
}

mechanism! {
    /// A wedge that lifts a follower; friction on bed, face and shaft, by the normal forces alone.
    pub struct Wedge {
        input x: length;
        param mu = 0.1;
        param face_angle = 20deg;
        ground O(0, 0);
        guide bed through (0, 0) along 0deg;
        guide shaft through (0, 0) along 90deg;
        slider wedge(bed) -> W { slide: x }
        guide face on wedge through (0, 0) along -face_angle;
        prp shoe(face), follower(shaft) -> C {}
        force (0, -1kN) on C;
        friction mu on wedge;
        friction mu on shoe;
        friction mu on follower;
    }
}

mechanism! {
    /// A block on a slope.
    pub struct Incline {
        input s: length;
        param mu = 0.3;
        guide slope through (0, 0) along 20deg;
        slider block(slope) -> P { slide: s }
        gravity (0, -9.81(m/s^2));
        mass 5kg on block at (0, 0);
        friction mu on block;
    }
}

mechanism! {
    /// A flywheel in its bearing.
    pub struct Journal {
        input theta: angle;
        ground A(0, 0);
        crank wheel(A) { angle: theta }
        gravity (0, -9.81(m/s^2));
        mass 20kg on wheel at (0, 0) inertia 0.9(kg*m^2);
        friction 0.08 at A radius 15mm;
    }
}

mechanism! {
    /// A drawer that a hand pulls beside its guide, against a load in line with it.
    pub struct Drawer {
        input x: length;
        param beside = 400mm;
        guide rail through (0, 0) along 0deg;
        guide path through (0, beside) along 0deg;
        slider hand(path) -> B { slide: x }
        rpp block(B), drawer(rail) { slot: 90deg }
        point F on drawer at (0, 0);
        force (-20N, 0) on F;
        friction 0.25 on drawer length 300mm;
    }
}

mechanism! {
    /// Groups of every kind behind a crank, with friction at each joint.
    pub struct RubbingGroups {
        input theta: angle;
        param mu = 0.1;
        param radius = 12mm;
        load push: force;
        ground A(0, 0), D(0.9m, -0.1m), F(-0.7m, 0.3m);
        guide post through (1.2m, 0) along 80deg;
        guide rail through (0, 0.9m) along 5deg;
        crank AB(A) -> B { length: 0.2m, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (0.8m, 0.5m), mode: left }
        rpr block(B), rod(F) { offset: 30mm }
        point E on rod at (0.9m, 0.1m);
        rpp slider(E), yoke(rail) { slot: 70deg, offsets: (20mm, -10mm) }
        guide arm on DC through (0.1m, 0) along 20deg;
        prp shoe(arm), follower(post) -> H {}
        rrp CK(C), ram(rail) -> K { length: 0.9m, mode: ahead }
        gravity (0, -9.81(m/s^2));
        mass 2kg on BC at (0.4m, 0.02m) inertia 0.1(kg*m^2);
        mass 3kg on DC at (0.2m, 0) inertia 0.1(kg*m^2);
        mass 1kg on block at (10mm, 0) inertia 0.01(kg*m^2);
        mass 2kg on rod at (0.4m, 0) inertia 0.2(kg*m^2);
        mass 1.5kg on slider at (0, 5mm) inertia 0.01(kg*m^2);
        mass 4kg on yoke at (0.1m, -0.2m) inertia 0.1(kg*m^2);
        mass 0.5kg on shoe at (0, 0) inertia 0.01(kg*m^2);
        mass 2kg on follower at (20mm, 0.1m) inertia 0.02(kg*m^2);
        mass 1kg on CK uniform;
        mass 5kg on ram at (0, 30mm) inertia 0.05(kg*m^2);
        force (push, 0) on K;
        friction mu at A radius radius;
        friction mu on BC at B radius radius;
        friction mu on BC at C radius radius;
        friction mu at D radius radius;
        friction mu on block at B radius radius;
        friction mu on block length 80mm;
        friction mu at F radius radius;
        friction mu at E radius radius;
        friction mu on slider;
        friction mu on yoke length 300mm;
        friction mu on shoe length 50mm;
        friction mu on follower length 200mm;
        friction mu on shoe at H radius radius;
        friction mu between CK and BC at C radius radius;
        friction mu on CK at K radius radius;
        friction mu on ram length 120mm;
    }
}

mechanism! {
    /// The same without friction.
    pub struct SmoothGroups {
        input theta: angle;
        load push: force;
        ground A(0, 0), D(0.9m, -0.1m), F(-0.7m, 0.3m);
        guide post through (1.2m, 0) along 80deg;
        guide rail through (0, 0.9m) along 5deg;
        crank AB(A) -> B { length: 0.2m, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (0.8m, 0.5m), mode: left }
        rpr block(B), rod(F) { offset: 30mm }
        point E on rod at (0.9m, 0.1m);
        rpp slider(E), yoke(rail) { slot: 70deg, offsets: (20mm, -10mm) }
        guide arm on DC through (0.1m, 0) along 20deg;
        prp shoe(arm), follower(post) -> H {}
        rrp CK(C), ram(rail) -> K { length: 0.9m, mode: ahead }
        gravity (0, -9.81(m/s^2));
        mass 2kg on BC at (0.4m, 0.02m) inertia 0.1(kg*m^2);
        mass 3kg on DC at (0.2m, 0) inertia 0.1(kg*m^2);
        mass 1kg on block at (10mm, 0) inertia 0.01(kg*m^2);
        mass 2kg on rod at (0.4m, 0) inertia 0.2(kg*m^2);
        mass 1.5kg on slider at (0, 5mm) inertia 0.01(kg*m^2);
        mass 4kg on yoke at (0.1m, -0.2m) inertia 0.1(kg*m^2);
        mass 0.5kg on shoe at (0, 0) inertia 0.01(kg*m^2);
        mass 2kg on follower at (20mm, 0.1m) inertia 0.02(kg*m^2);
        mass 1kg on CK uniform;
        mass 5kg on ram at (0, 30mm) inertia 0.05(kg*m^2);
        force (push, 0) on K;
    }
}

mechanism! {
    /// A coefficient of zero, which leaves nothing behind.
    pub struct UnloadedFourBar {
        input theta: angle;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }
        mass 6kg on BC uniform;
        mass 4kg on DC uniform;
        friction 0 at B radius 20mm;
        friction 0 at C radius 20mm;
        output AB.A, BC.B, BC.C, DC.D, theta.drive;
    }
}

mechanism! {
    /// The same, never said to rub.
    pub struct FreeFourBar {
        input theta: angle;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B { length: 80mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: left }
        mass 6kg on BC uniform;
        mass 4kg on DC uniform;
        output AB.A, BC.B, BC.C, DC.D, theta.drive;
    }
}

mechanism! {
    /// A block whose coefficient falls with its speed, and one whose sign is smooth.
    pub struct Laws {
        input x: length;
        input y: length;
        guide bed through (0, 0) along 0deg;
        guide other through (0, 1m) along 0deg;
        slider block(bed) -> P { slide: x }
        slider smoothed(other) -> Q { slide: y }
        gravity (0, -10(m/s^2));
        mass 2kg on block at (0, 0);
        mass 3kg on smoothed at (0, 0);
        friction 0.1 + 0.2 / (1 + abs(rate(block.slide)) / 1(m/s)) on block;
        friction 0.4 on smoothed smooth 0.5(m/s);
        output x.drive, y.drive, losses;
    }
}

mechanism! {
    /// Painlevé and Klein's frame: two blocks on parallel guides, joined by a rod; the first rubs.
    pub struct PainleveKlein {
        input x: length;
        param mu = 0.4;
        param angle = 1rad;
        ground O(0, 0);
        guide lower through (0, 0) along 0deg;
        guide upper through (0, 100mm) along 0deg;
        slider one(lower) -> P { slide: x }
        rrp rod(P), two(upper) -> Q { length: 100mm / sin(angle), mode: ahead }
        mass 2kg on one at (0, 0);
        mass 3kg on two at (0, 0);
        force (4N, 0) on P;
        force (-7N, 0) on Q;
        friction mu on one;
    }
}

mechanism! {
    /// A block on a spring, with dry friction.
    pub struct Oscillator {
        input x: length;
        ground O(0, 0);
        guide bed through O along 0deg;
        slider block(bed) -> P { slide: x }
        gravity (0, -9.81(m/s^2));
        mass 2kg on block at (0, 0);
        force (-800(N/m) * x, 0) on P;
        friction 0.25 on block;
    }
}

mechanism! {
    /// An arm of two cranks, their signs smooth.
    pub struct RubbingArm {
        input shoulder: angle;
        input elbow: angle;
        param mu = 0.2;
        ground A(0, 0);
        crank upper(A) -> B { length: 0.5m, angle: shoulder }
        crank lower(B) -> C { length: 0.4m, angle: elbow, relative_to: upper }
        gravity (0, -9.81(m/s^2));
        mass 3kg on upper at (0.2m, 0.05m) inertia 0.1(kg*m^2);
        mass 2kg on lower at (0.2m, 0) inertia 0.05(kg*m^2);
        friction mu at A radius 30mm smooth 0.1(rad/s);
        friction mu at B radius 20mm smooth 0.1(rad/s);
    }
}
