//! Machines with an unknown that an equation fixes.

use linkage_core::mechanism;

mechanism! {
    /// A double wishbone in the plane across the car, driven by the wheel's travel.
    pub struct Wishbone {
        /// The height of the wheel's centre.
        input z: length;
        unknown theta: angle between (-25deg, 25deg);
        param upper_length = 280mm;
        ground A(0, 200mm), D(50mm, 450mm);
        crank lower(A) -> B             { length: 380mm, angle: theta }
        rrr   kingpin(B), upper(D) -> C { lengths: (250mm, upper_length), mode: right }
        point W on kingpin at (120mm, -60mm);
        solve theta { W.y = z, mode: rising }
        output theta, W, kingpin.angle;
    }
}

mechanism! {
    /// A press ram with an offset, between the dead points of its equation and a little beyond.
    pub struct Press {
        input x: length;
        param from = -17deg;
        param to = 217deg;
        param seed: near = 90deg;
        param r = 80mm;
        param l = 250mm;
        param e = 30mm;
        ground A(0, 0);
        guide bed through (0, e) along 0deg;
        unknown theta: angle between (from, to);
        crank AB(A) -> B           { length: r, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: l, mode: ahead }
        solve theta { ram.slide = x, mode: falling, near: seed }
        output theta, ram.slide, AB;
    }
}

mechanism! {
    /// The same without a seed, its ends the exact dead points of a ram in line with the shaft.
    pub struct InLine {
        input x: length;
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (0, 180deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: falling }
        output theta, C;
    }
}

mechanism! {
    /// A machine of class III: a plate on three legs, the third of which is the equation.
    pub struct Triad {
        input turn: angle;
        param third = 1.1m;
        ground A1(0, 0), A2(2.6m, 0.1m), O(2m, 1.5m);
        crank drive(O) -> P { length: 0.15m, angle: turn }
        unknown phi: angle between (45deg, 66deg);
        crank leg1(A1) -> C1 { length: 1.6m, angle: phi }
        rrr   plate(P), leg2(C1) -> C2 { lengths: (0.9m, 0.7m), mode: left }
        point C3 on plate at (0.6m, 0.25m);
        solve phi { distance(A2, C3) = third, mode: rising }
        output phi, C3, plate, leg2.angle, rest = distance(A2, C3);
    }
}

mechanism! {
    /// A crank's angle for a rocker's, and a follower behind it; the angle may be given by its
    /// cosine and sine.
    pub struct Generator {
        input psi: angle;
        unknown theta: angle between (20deg, 140deg);
        ground A(0, 0), D(665.7mm, 0);
        crank pointer(D)        { angle: psi }
        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
        solve theta { DC.angle = pointer.angle, mode: falling }
        output theta, C, DC.angle;
    }
}

mechanism! {
    /// The arm stops short of the bracket's end: its rod cannot be assembled there.
    pub struct Short {
        input y: length;
        param rod = 1.5m;
        ground A(0, 0), D(4m, 0);
        unknown theta: angle between (5deg, 80deg);
        crank AB(A) -> B        { length: 2m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (rod, 2m), mode: left }
        solve theta { C.y = y, mode: rising }
        output theta;
    }
}

mechanism! {
    /// An equation whose difference jumps where an angle passes half a turn.
    pub struct Jump {
        input psi: angle;
        unknown theta: angle between (90deg, 270deg);
        ground A(0, 0);
        crank AB(A) -> B { length: 1m, angle: theta }
        solve theta { AB.angle = psi, mode: falling }
        output theta;
    }
}

mechanism! {
    /// Two unknowns, the second behind the first.
    pub struct Pair {
        input x, h: length;
        ground A(0, 0), D(0.9m, 0);
        guide bed through (0, 0) along 0deg;
        guide post through (1.4m, 0) along 90deg;
        unknown theta: angle between (5deg, 175deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: 250mm, mode: ahead }
        solve theta { ram.slide = x, mode: falling, near: 80deg }
        unknown phi: angle between (-60deg, 60deg);
        crank DE(D) -> E { length: 0.3m, angle: phi, relative_to: BC }
        rrp   EF(E), block(post) -> F { length: 0.5m, mode: ahead }
        solve phi { block.slide = h, mode: rising }
        output theta, phi, C, F;
    }
}

mechanism! {
    /// Equations of an angle that stands on the right, and of areas.
    pub struct Ratio {
        input x: length;
        ground A(0, 0);
        guide rail through (0, 0) along 0deg;
        unknown theta: angle between (10deg, 80deg);
        crank AB(A) -> B { length: 1m, angle: theta }
        solve theta { 1 + x / 1m = theta, mode: falling }
        unknown s: length between (1m, 2m);
        slider block(rail) -> P { slide: s }
        solve s { P.x * P.x = x * x, mode: rising }
        output theta, s;
    }
}

mechanism! {
    /// A ram between the dead points of its crank, whose search has a seed, and a follower whose
    /// bracket overhangs one.
    pub struct RamAndFollower {
        input x, h: length;
        param r = 1m;
        param rod = 2.5m;
        param seed: near = 1rad;

        ground A(0, 0), D(4m, 0);
        guide bed through (0, 0) along 0deg;
        guide post through (5m, 0) along 90deg;

        unknown theta: angle between (0, 180deg);
        crank AB(A) -> B           { length: r, angle: theta }
        rrp   BC(B), ram(bed) -> C { length: rod, mode: ahead }
        solve theta { ram.slide = x, mode: falling, near: seed }

        unknown phi: angle between (-90deg, 90deg);
        crank DE(D) -> E { length: 1m, angle: phi }
        rrp   EF(E), block(post) -> F { length: 4m, mode: ahead }
        solve phi { block.slide = h, mode: rising }

        output theta, phi, AB, C, F, BC, BC.margin;
    }
}

mechanism! {
    /// An equation that turns forty times between the ends of its unknown.
    pub struct Comb {
        input x: length;
        ground A(0, 0);
        unknown theta: angle between (0, 180deg);
        crank AB(A) -> B { length: 1m, angle: theta }
        solve theta { sin(40 * theta) = x / 1m, mode: rising }
        output theta, B;
    }
}

mechanism! {
    /// A slide that is searched as far as a parameter says.
    pub struct Reach {
        input x: length;
        param to = 1m;
        ground A(0, 0);
        guide rail through (0, 0) along 30deg;
        unknown s: length between (0, to);
        slider block(rail) -> P { slide: s }
        solve s { P.x = x, mode: rising }
        output s;
    }
}
