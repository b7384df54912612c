//! Machines with ratios of rates, poles and transmission angles of every group.

#![allow(non_snake_case)]

use linkage_core::mechanism;

mechanism! {
    /// The rear of a bicycle: a swingarm, and a rocker that drives the shock.
    pub struct Rear {
        input arm: angle;
        param stay = 300mm;
        ground pivot(0, 0), R(20mm, 210mm), frame(190mm, 120mm);
        crank swingarm(pivot) { angle: arm }
        point axle on swingarm at (430mm, 0);
        point seat on swingarm at (220mm, 40mm);
        rrr seatstay(seat), rocker(R) -> J { lengths: (stay, 90mm), mode: left }
        point eye on rocker at (-20mm, -90mm);
        let shock = distance(eye, frame);
        let size = abs(rate(axle.y)) / abs(rate(shock));
        output leverage = rate(axle.y) / rate(shock), size, path = hypot(rate(axle.x), rate(axle.y)) / abs(rate(arm));
        output I = pole(seatstay), K = pole(rocker, swingarm), rocker.transmission;
    }
}

mechanism! {
    /// A dyad of each kind behind one crank.
    pub struct Groups {
        input theta: angle;
        ground A(0, 0), D(500mm, 50mm), F(-300mm, 400mm);
        guide bed through (0, -400mm) along 10deg;
        guide rail through (0, 800mm) along 0deg;
        guide post through (300mm, 0) along 80deg;
        crank AB(A) -> B { length: 80mm, angle: theta }
        guide arm on AB through B along 70deg;
        rrr BC(B), DC(D) -> C { lengths: (450mm, 250mm), mode: left }
        rrp CE(C), ram(bed) -> E { length: 800mm, mode: ahead }
        rpr sleeve(B), bar(F) { offset: 20mm, mode: ahead }
        point P on bar at (200mm, 0);
        rpp pin(P), yoke(rail) { slot: 75deg + 0.3rad * cos(theta), offsets: (20mm, -30mm) }
        prp shoe(arm), block(post) -> G { offsets: (10mm, -20mm) }
        output DC.transmission, ram.transmission, bar.transmission, yoke.transmission, block.transmission;
        output stroke = rate(ram.slide) / rate(theta), swing = rate(bar.angle) / rate(theta);
        output I = pole(BC), K = pole(CE, bar), DC.margin;
    }
}

mechanism! {
    /// A wishbone suspension by the travel of its wheel.
    pub struct ByTravel {
        input travel: length;
        unknown lower: angle between (-25deg, 25deg);
        ground A(350mm, 180mm), D(400mm, 430mm);
        crank lower_arm(A) -> B { length: 380mm, angle: lower }
        rrr upright(B), upper_arm(D) -> C { lengths: (260mm, 300mm), mode: right }
        point hub on upright at (120mm, -80mm);
        solve lower { hub.y = travel, mode: rising }
        output gain = rate(upright.angle) / rate(travel), I = pole(upright), upper_arm.transmission;
    }
}

mechanism! {
    /// Bars equal in pairs: while they are a parallelogram the coupler does not turn.
    pub struct EqualBars {
        input theta: angle;
        ground A(0, 0), D(500mm, 0);
        crank AB(A) -> B { length: 200mm, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (500mm, 200mm), mode: left }
        output I = pole(BC), stroke = rate(C.x) / rate(C.y);
    }
}
