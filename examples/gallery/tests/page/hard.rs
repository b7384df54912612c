//! Machines of which a page could stumble: names that are words of JavaScript or of the page itself, texts that
//! would end a script, and every function.

#![allow(non_snake_case, non_camel_case_types)]

use linkage_core::mechanism;

mechanism! {
    /// Ends early: </script><script>alert("1")</script> <!-- and `${x}` \ too.
    pub struct Function {
        /// An angle, </script>.
        input arguments: angle;
        param class = 80mm;
        param p = 632mm;
        param MACHINE: mode = right;
        ground function(0, 0), document(665.7mm, 0);
        crank var(function) -> window { length: class, angle: arguments }
        rrr   q(window), NaN(document) -> c { lengths: (p, 374mm), mode: MACHINE }
        point constructor on q at (500mm, -60mm);
        output this = constructor.x + c.x, constructor, c, q, var;
    }
}

mechanism! {
    /// Functions, compensated.
    pub struct Compensated {
        input theta: angle;
        input s: length;
        param l = 0.25m;
        numerics compensated;
        ground A(0, 0), D(0.6m, 0);
        crank AB(A) -> B { length: hypot(0.06m, 0.04m + s), angle: 2 * theta + atan2(s, 1m) }
        rrr BC(B), DC(D) -> C { lengths: (0.5m, l + 0.2m), mode: left }
        let bent = asin(0.3 * sin(theta)) + acos(0.2 * cos(theta)) + atan(tan(0.1 * theta));
        crank DE(D) -> E { length: sqrt(l * l), angle: bent }
        output C, E, bent, size = abs(C.y) + max(C.x, E.x);
    }
}

mechanism! {
    /// Several roots of each trend and several dead points, between ends that are parameters.
    pub struct Rippled {
        input x: length;
        param way: mode = rising;
        param low: angle = -2rad;
        param high: angle = 3rad;
        ground A(0, 0);
        unknown arguments: angle between (low, high);
        crank AB(A) -> B { length: 1m, angle: arguments }
        solve arguments { sin(3 * arguments) + arguments / 8 = x / 1m, mode: way }
        output arguments, B;
    }
}

mechanism! {
    /// An unknown behind another one, a trial that cannot be assembled, and a given cosine.
    pub struct Chained {
        input x, h: length;
        param rod = 0.25m;
        ground A(0, 0), D(0.5m, 0);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: rod, mode: ahead }
        solve theta { x = ram.slide, mode: rising, near: 60deg }
        unknown phi: angle between (-60deg, 60deg);
        crank CE(C) -> E           { length: 300mm, angle: phi }
        rrr   EF(E), DF(D) -> F    { lengths: (0.3m, 0.33m), mode: left }
        solve phi { F.y = h + B.y / 10, mode: rising }
        mass 2kg on EF at (0.1m, 0);
        output theta, phi, F, x.drive, h.drive;
    }
}

mechanism! {
    /// Links and joints whose groups are of class III.
    pub struct EightBar {
        input theta: angle;
        ground p01(0.789, 0.304), p17(0.603, 0.18);
        pin p05(0.326, 0.572), p25(0.655, 0.835), p27(0.324, 0.929), p36(0.81, 0.838), p37(0.554, 0.589);
        pin p46(0.015, 0.486), p47(0.999, 0.972), p56(0.052, 0.978);
        link l0(p01, p05), l2(p25, p27), l3(p36, p37), l4(p46, p47), l5(p05, p25, p56), l6(p36, p46, p56);
        link l7(p17, p27, p37, p47);
        drive l7.angle = theta;
        output p56, p47, l3;
    }
}

mechanism! {
    /// An equation whose difference jumps by a turn: it has no root there.
    pub struct Jump {
        input psi: angle;
        unknown theta: angle between (90deg, 270deg);
        ground A(0, 0);
        crank AB(A) -> B { length: 1m, angle: theta }
        solve theta { AB.angle = psi, mode: falling }
        output B;
    }
}

mechanism! {
    /// Friction in pins and a guide, in part smooth, of a share at which joints jam.
    pub struct Rubbing {
        input theta: angle;
        param mu = 0.1;
        load push: force;
        ground A(0, 0), D(0.35m, -0.05m);
        guide bed through (0, 0) along 0deg;
        crank AB(A) -> B           { length: 0.1m, angle: theta }
        rrr   BC(B), DC(D) -> C    { lengths: (0.32m, 0.2m), mode: left }
        rrp   CE(C), ram(bed) -> E { length: 0.5m, mode: ahead }
        mass 2kg on BC uniform;
        mass 5kg on ram at (0, 0);
        force (-push, 0) on E;
        friction mu at A radius 40mm;
        friction mu at B radius 40mm;
        friction mu on BC at C radius 40mm;
        friction mu at D radius 30mm smooth 0.05(rad/s);
        friction mu on CE at E radius 30mm;
        friction mu on ram length 60mm;
        output theta.drive, C, ram, losses;
    }
}

mechanism! {
    /// A block on a guide of a rocker, which goes where its group is refused.
    pub struct Carried {
        input theta: angle;
        param coupler = 632mm;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, 374mm), mode: right }
        guide rail on DC through (100mm, 20mm) along 30deg;
        slider block(rail) -> P { slide: 50mm + 20mm * sin(theta) }
        output block;
    }
}

mechanism! {
    /// A crank whose only output is zero.
    pub struct AtRest {
        input theta: angle;
        ground A(0, 0), D(300mm, 0);
        crank AB(A) -> B { length: 80mm, angle: theta }
        output height = D.y - A.y;
    }
}

mechanism! {
    /// A knee whose shank is driven: outside its range a link's pin stands nowhere.
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
    /// A platform that a cylinder lifts: the page finds how far.
    pub struct Lift {
        input s: length;
        ground A(0, 0), D(0.5m, 0);
        pin B(0.9m, 0.6m), P(1.4m, 0.9m);
        link arm(A, B, P);
        link ram(D, B) { length: s }
    }
}

mechanism! {
    /// A bascule bridge: meganewtons, and accelerations without bound at both ends.
    pub struct Bridge {
        input stroke: length;
        param counterweight = 0(kg);
        ground A(0, 0), F(-14m, -9m);
        rrr ram(F), leaf(A) -> G { lengths: (stroke, 12m), mode: right }
        point nose_of_the_bascule_leaf on leaf at (120m, 6m);
        gravity (0, -9.81);
        mass 900000kg on leaf at (40m, 0) inertia 1e9(kg*m^2);
        mass counterweight on leaf at (-20m, 0);
        output leaf, nose_of_the_bascule_leaf, stroke.drive;
    }
}

mechanism! {
    /// A press with stops at a slide, an angle and a distance, springs, and friction at all joints.
    pub struct Stopped {
        input theta: angle;
        param mu = 0.1;
        param upper = 0.8m;
        param stiffness = 2e5(N/m);
        load push: force;
        ground A(0, 0), D(0.35m, -0.05m);
        guide bed through (0, 0) along 0deg;
        crank AB(A) -> B           { length: 0.1m, angle: theta }
        rrr   BC(B), DC(D) -> C    { lengths: (0.32m, 0.2m), mode: left }
        rrp   CE(C), ram(bed) -> E { length: 0.5m, mode: ahead }
        gravity (0, -9.81);
        mass 2kg on BC uniform;
        mass 5kg on ram at (0, 0.01m) inertia 0.02(kg*m^2);
        spring between D and E { stiffness: 900(N/m), free_length: 0.3m, damping: 20(N*s/m) }
        spring coil between AB and BC { stiffness: 3(N*m/rad), free_angle: 40deg }
        stop end ram.slide between (0.72m, upper) { stiffness: stiffness, damping: 300(N*s/m) }
        stop swing DC.angle between (20deg, 80deg) { stiffness: 400(N*m/rad) }
        stop apart distance(A, C) between (0.2m, 0.4m) { stiffness: 1e4(N/m) }
        force (-push, 0) on E;
        friction mu at A radius 40mm;
        friction mu at B radius 40mm;
        friction mu on BC at C radius 40mm;
        friction mu at D radius 30mm smooth 0.05(rad/s);
        friction mu on CE at E radius 30mm;
        friction mu on ram length 60mm;
        output theta.drive, C, ram, ram.bed, BC.C, CE.E.friction, losses, end.force, swing.gap, coil.torque;
    }
}

mechanism! {
    /// Functions of the browser's own, of an angle and of a speed, and a torque that is made of them.
    pub struct Library {
        input theta: angle;
        param mu = 0.1;
        ground A(0, 0), D(0.7m, 0);
        crank AB(A) -> B { length: 0.2m, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (0.7m, 0.4m), mode: left }
        let fading = exp(-theta / 4rad);
        let raised = pow(1.5 + C.x / 1m, 1.3);
        let level = ln(2 + C.y / 1m);
        let braked = tanh(rate(theta) / 3(rad/s));
        mass 2kg on BC at (0.35m, 0);
        torque -2(N*m) * braked on AB;
        friction mu at C radius 20mm;
        output fading, raised, level, C, theta.drive, braked, losses;
    }
}

mechanism! {
    /// The place of a press that is stopped and sprung: the crank's angle for the ram's slide.
    pub struct Sought {
        input x: length;
        param rod = 0.25m;
        param lower = 0.2m;
        load push: force;
        ground A(0, 0), D(0.3m, 0.2m);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: rod, mode: ahead }
        solve theta { x = ram.slide, mode: falling }
        rrr   BE(B), DE(D) -> E    { lengths: (0.3m, 0.25m), mode: left }
        gravity (0, -9.81);
        mass 2kg on BC uniform;
        mass 3kg on E;
        spring between D and C { stiffness: 500(N/m), free_length: 0.1m, damping: 30(N*s/m) }
        stop low ram.slide between (lower, 0.3m) { stiffness: 1e5(N/m), damping: 100(N*s/m) }
        stop lever DE.angle between (-170deg, -60deg) { stiffness: 200(N*m/rad), damping: 2(N*m*s/rad) }
        force (-push, 0) on C;
        output theta, E, x.drive, low.force, lever.gap;
    }
}

mechanism! {
    /// A parallelogram whose coupler does not turn, a truss that moves with it, and an antiparallelogram behind the
    /// change point.
    pub struct Parallel {
        input theta: angle;
        param mu = 0.2;
        load push: force;
        ground A(0, 0), D(0.4m, 0);
        guide rail through (0, -0.3m) along 0deg;
        crank AB(A) -> B { length: 0.15m, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (0.4m, 0.15m), mode: left }
        point P on BC at (0.2m, -0.05m);
        rpp block(P), yoke(rail) { slot: 90deg, offsets: (0, 0) }
        rrr p(B), q(P) -> H { lengths: (0.3m, 0.25m), mode: left }
        point F on p at (0.2m, 0.15m);
        rrr r(F), s(C) -> K { lengths: (0.4m, 0.45m), mode: right }
        mass 5kg on yoke at (0, 0) inertia 0.01(kg*m^2);
        mass 1kg on r at (0.2m, 0) inertia 0.01(kg*m^2);
        force (-push, 0) on P;
        friction mu on block at P radius 30mm;
        friction mu at K radius 20mm;
        output theta.drive, block.P, block.P.friction, r.K, r.K.friction, losses;
    }
}

mechanism! {
    /// Masses of every kind under gravity, couples, a pair of gears, a planet and drives.
    pub struct Marked {
        input theta: angle;
        param far = 0.1m;
        param heavy = 12(kg);
        param base = 0.3m;
        param times = 2;
        load push: force;
        load twist: torque;
        ground A(0, 0), D(base, 0);
        guide bed through D along 0deg;
        crank pinion(A) -> B { length: 60mm, angle: theta }
        crank wheel(D) -> C  { length: 100mm, angle: -times * theta - 90deg }
        rrp rod(C), ram(bed) -> P { length: 0.4m, mode: ahead }
        crank planet(B) -> T { length: 30mm, angle: -3 * theta, relative_to: pinion }
        point G on rod at (200mm, -20mm);
        point M on rod at (far, 30mm);
        gravity (1(m/s^2), -9.81(m/s^2));
        mass heavy on rod at (far, 30mm);
        mass 2kg on P;
        mass 3kg on pinion uniform;
        mass 1kg on rod at G;
        torque twist on wheel;
        torque 5(N*m) on pinion;
        force (-push, 0) on P;
        output G, M, P, B, T, theta.drive, rod.C;
    }
}

mechanism! {
    /// Two sliders behind each other, the second on a slope, which a longer crank leaves behind.
    pub struct Slanted {
        input theta: angle;
        param arm = 60mm;
        ground A(0, 0), E(400mm, -50mm);
        guide bed through A along 20deg;
        guide slope through E along 65deg;
        crank AB(A) -> B { length: arm, angle: theta }
        rrp BC(B), ram(bed) -> C { length: 150mm, mode: ahead }
        rrp CD(C), block(slope) -> F { length: 260mm, mode: ahead }
        output C, F;
    }
}

mechanism! {
    /// A boom on a cylinder, and a block that is pushed along a slope.
    pub struct Pushed {
        input s, x: length;
        ground A(0, 0), F(0.3m, -0.2m), E(1m, 0);
        guide slope through E along 30deg;
        rrr lift(F), boom(A) -> G { lengths: (s, 0.55m), mode: right }
        slider block(slope) -> P { slide: x }
        gravity (0, -9.81(m/s^2));
        mass 30kg on boom at (0.4m, 0);
        mass 20kg on P;
        output G, P, s.drive, x.drive;
    }
}
