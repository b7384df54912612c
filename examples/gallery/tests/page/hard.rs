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
