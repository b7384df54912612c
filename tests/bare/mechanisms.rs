//! Mechanisms that between them hold every driver, every group in each of its variants, and every
//! function of the language. All export C functions, so that each entry point has a symbol.

use linkage_core::mechanism;

mechanism! {
    /// A strip-mill flying shear: a crank-rocker whose coupler carries the upper blade.
    pub struct FlyingShear {
        input theta: angle;

        ground A(0, 0), D(665.7mm, 0);

        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
        point blade on BC at (500mm, -60mm);

        output blade, BC, DC, DC.margin, DC.transmission;
        export c;
    }
}

mechanism! {
    /// A six-bar of two dyads: the first behind a crank, the second between moving joints.
    pub struct WattSixBar {
        input theta: angle;

        ground A(0, 0), D(300mm, 125mm);

        crank AB(A) -> B        { length: 100mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (250mm, 200mm), mode: left }
        point P on BC at (150mm, 50mm);
        point Q on DC at (50mm, -20mm);
        rrr   PE(P), QE(Q) -> E { lengths: (300mm, 200mm), mode: right }

        output P, E, BC, DC, QE, DC.margin, QE.transmission;
        export c;
    }
}

mechanism! {
    /// A four-bar that can be tuned, with points placed in every way, to the last digit.
    pub struct TunedFourBar {
        input theta: angle;
        param coupler = 254mm;
        param rocker = 177.8mm;
        param elbow: mode = left;

        ground A(0, 0), D(304.8mm, 0);

        crank AB(A) -> B        { length: 101.6mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: elbow }
        point P on DC at polar (rocker / 2, 35deg);
        point Q on BC at distances (210mm, 190mm) right;

        output C, P, Q, BC, DC, fold = BC.angle - DC.angle, reach = coupler + rocker;
        numerics compensated;
        export c;
    }
}

mechanism! {
    /// A slider-crank beside its guide.
    pub struct SliderCrank {
        input theta: angle;
        param rod = 3.1m;
        param side: mode = ahead;

        ground A(0, 0);
        guide rail through (0.5m, 0.3m) along 0.15rad;

        crank AB(A) -> B              { length: 1m, angle: theta }
        rrp   BC(B), block(rail) -> C { length: rod, offset: 0.22m, mode: side }
        point P on BC at (1.2m, 0.5m);

        output C, P, BC, block, block.margin, block.transmission;
        export c;
    }
}

mechanism! {
    /// A quick return that drives a ram by a yoke.
    pub struct SixBar {
        input theta: angle;
        param side: mode = ahead;

        ground A(0, 0), D(0, -1m);
        guide rail through (0, 0.8m) along 0deg;

        crank AB(A) -> B          { length: 0.4m, angle: theta }
        rpr   block(B), rod(D)    { offset: 50mm, mode: side }
        point E on rod at (1.6m, 0);
        rpp   pin(E), ram(rail)   { slot: 75deg, offsets: (20mm, -30mm) }

        output E, rod, block, ram.slide, pin.slide, rod.margin, ram.transmission;
        export c;
    }
}

mechanism! {
    /// A pin between a guide on the crank and a fixed one.
    pub struct CrossedGuides {
        input theta: angle;

        ground A(0, 0);
        guide post through (2.5m, 0) along 80deg;

        crank AB(A) -> B { length: 1m, angle: theta }
        guide arm on AB through B along 70deg;
        prp   shoe(arm), block(post) -> C { offsets: (0.1m, -0.2m) }
        point W on shoe at (0.2m, 0.1m);

        output C, W, shoe, block.slide, block.transmission;
        export c;
    }
}

mechanism! {
    /// Boom, stick and bucket on three cylinders.
    pub struct Excavator {
        input lift, crowd, curl: length;

        ground O(0, 0), F(0.5m, -0.6m);

        rrr   lift_ram(F), boom(O) -> G    { lengths: (lift, 2.6m), mode: right }
        point S on boom at (5.2m, -1.1m);
        point H on boom at (2.9m, 0.5m);
        rrr   crowd_ram(H), stick(S) -> J  { lengths: (crowd, 0.8m), mode: right }
        point T on stick at (-2.8m, 0.3m);
        point N on stick at (-0.3m, 0.7m);
        point K on stick at (-2.4m, 0.35m);
        rrr   curl_ram(N), lever(K) -> V   { lengths: (curl, 0.6m), mode: right }
        rrr   pull(V), bucket(T) -> W      { lengths: (0.55m, 0.45m), mode: right }
        point tooth on bucket at (0.4m, -1.4m);

        output tooth, boom, stick, bucket, boom.margin;
        export c;
    }
}

mechanism! {
    /// Everything depends on the inputs, through every function of the language.
    pub struct Everything {
        input theta, psi: angle;
        input s: length;
        param swing = 0.25rad;

        ground A(0, 0);
        guide bed through (-2m, -1m) towards A;

        crank  AB(A) -> B      { length: 0.5m + 0.01m * tan(psi), angle: theta }
        guide  slot on AB through (0.3m, 0.1m) along psi + atan(theta);
        slider ram(bed) -> R   { slide: s, offset: 0.1m * asin(psi / 4) }
        crank  arm(R) -> T     { length: 0.2m, relative_to: AB, angle: 2 * AB.angle + acos(psi / 4) }
        point  P at (0.4 * s - 0.7m, 0.4m + s * s / 2m);
        rrp    PC(P), block(slot) -> C
            { length: sqrt(1.1m * 1.1m + s * s), offset: s / 4, mode: ahead }
        point  Q on PC at (0.5 * s, hypot(s, 0.3m));
        rpr    sleeve(T), bar(Q) { offset: 0.01m * sin(swing) }
        rpp    pin(C), yoke(bed) { slot: 60deg + swing * cos(theta), offsets: (s / 8, 0) }

        output Q, T, PC, block, bar, yoke.slide, lead = atan2(s, 1m + s);
        export c;
    }
}

mechanism! {
    /// A press with mass, springs and loads.
    pub struct HeavyPress {
        input theta: angle;
        param counterweight = 2kg;
        load work: force;
        load friction: torque;

        ground A(0, 0), O(0.3m, -0.6m);
        guide way through (0, 0) along -90deg;

        crank AB(A) -> B          { length: 100mm, angle: theta }
        rrp   BC(B), ram(way) -> C { length: 400mm, mode: ahead }

        gravity (0, -9.81);
        mass counterweight on AB at (-100mm, 0);
        mass 3kg on BC uniform;
        mass 8kg on ram at (0, 0) inertia 0.1(kg*m^2);
        force (0, work) on C;
        torque friction - 0.2(N*m*s) * rate(theta) on AB;
        spring balance between O and C { stiffness: 900(N/m), free_length: 0.2m, damping: 30(N*s/m) }

        output AB, C, theta.drive, AB.A, BC.C, ram.way, balance.force, shaking, energy;
        export c;
    }
}

mechanism! {
    /// Four-bar of uniform bars, asked for its torque alone.
    pub struct DrivenFourBar {
        input theta: angle;

        ground A(0, 0), D(750mm, 0);

        crank AB(A) -> B        { length: 250mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (510mm, 500mm), mode: left }

        gravity (0, -9.81);
        mass 52.21g on AB uniform;
        mass 104.21g on BC uniform;
        mass 102.21g on DC uniform;

        output C, theta.drive;
        export c;
    }
}

mechanism! {
    /// A five-bar robot that moves under the torques of both cranks, one on a spring.
    pub struct HeavyRobot {
        input first, second: angle;

        ground A(0, 0), D(0.4m, 0);

        crank AB(A) -> B        { length: 0.3m, angle: first }
        crank DE(D) -> E        { length: 0.3m, angle: second }
        rrr   BC(B), EC(E) -> C { lengths: (0.5m, 0.5m), mode: left }

        gravity (0, -9.81);
        mass 0.8kg on AB uniform;
        mass 0.8kg on DE uniform;
        mass 0.5kg on BC uniform;
        mass 0.7kg on C;
        spring between ground and AB { stiffness: 3(N*m/rad), free_angle: 100deg, damping: 0.2(N*m*s) }

        output C, first.drive, second.drive;
        export c;
    }
}

mechanism! {
    /// A press whose drive is searched, and a leg of class III behind it.
    pub struct SearchedPress {
        input x, h: length;
        param seed: near = 80deg;

        ground A(0, 0), D(0.9m, 0);
        guide bed through (0, 0) along 0deg;
        guide post through (1.4m, 0) along 90deg;

        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: falling, near: seed }
        unknown phi: angle between (-60deg, 60deg);
        crank DE(D) -> E { length: 0.3m, angle: phi, relative_to: BC }
        rrp   EF(E), block(post) -> F { length: 0.5m, mode: ahead }
        solve phi { distance(C, F) = h, mode: rising }

        gravity (0, -9.81);
        mass 3kg on BC uniform;
        mass 8kg on ram at (0, 10mm) inertia 0.1(kg*m^2);
        mass 2kg on DE at (0.1m, 0) inertia 0.02(kg*m^2);
        mass 1kg on F;

        output theta, phi, C, F, BC, BC.margin, x.drive, h.drive, energy;
        export c;
    }
}

mechanism! {
    /// A set-point of a press whose interval and trend are chosen at run time.
    pub struct ChosenPress {
        input x: length;
        param lower = 5deg;
        param upper = 175deg;
        param way: mode = falling;

        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (lower, upper);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: way }

        output theta, C;
        export c;
    }
}

mechanism! {
    /// A pin in the blocks of two bars. The offset bounds the reach of one, and the other ends where the pin is on
    /// its pivot.
    pub struct TurningBars {
        input x: length;
        param offset = 50mm;
        param side: mode = behind;

        // The ends of the stroke that the caller of printed C draws.
        ground D(0.1702071748570875m, 0), E(0.3295983265517668m, 0);
        guide bed through (0, 0) along 0deg;

        slider pin(bed) -> B      { slide: x }
        rpr    sleeve(B), bar(E)  { offset: offset, mode: side }
        rpr    shoe(B), rod(D)    {}

        gravity (0, -9.81);
        mass 2kg on bar at (0.2m, 0) inertia 0.1(kg*m^2);
        mass 1kg on rod at (0.1m, 20mm) inertia 0.02(kg*m^2);

        output bar, rod, sleeve.slide, bar.margin, bar.E, rod.D, x.drive;
        export c;
    }
}
