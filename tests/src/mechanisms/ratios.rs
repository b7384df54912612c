//! Ratios of rates and instant centres.

use linkage_core::mechanism;

mechanism! {
    /// The rear of a bicycle: a swingarm, and a rocker that drives the shock.
    pub struct Rear {
        input arm: angle;
        param stay = 300mm;
        param lever = 90mm;
        ground pivot(0, 0), R(20mm, 210mm), frame(190mm, 120mm);
        crank swingarm(pivot)           { angle: arm }
        point axle on swingarm at (430mm, 0);
        point seat on swingarm at (220mm, 40mm);
        rrr   seatstay(seat), rocker(R) -> J { lengths: (stay, lever), mode: left }
        point eye on rocker at (-20mm, -90mm);
        let shock = distance(eye, frame);
        output axle, shock, leverage = rate(axle.y) / rate(shock), I = pole(seatstay), seatstay, seat;
    }
}

mechanism! {
    /// The same with masses: the ratio stays with the pose, and the rate stands among the forces.
    pub struct HeavyRear {
        input arm: angle;
        ground pivot(0, 0), R(20mm, 210mm), frame(190mm, 120mm);
        crank swingarm(pivot)           { angle: arm }
        point axle on swingarm at (430mm, 0);
        point seat on swingarm at (220mm, 40mm);
        rrr   seatstay(seat), rocker(R) -> J { lengths: (300mm, 90mm), mode: left }
        point eye on rocker at (-20mm, -90mm);
        mass 2kg on axle;
        gravity (0, -9.81);
        let shock = distance(eye, frame);
        let leverage = rate(axle.y) / rate(shock);
        output axle, leverage, speed = rate(axle.y), wheel = arm.drive;
    }
}

mechanism! {
    /// Bars equal in pairs: while they are a parallelogram the coupler does not turn.
    pub struct EqualBars {
        input theta: angle;
        param ground_bar = 0.5m;
        ground A(0, 0), D(ground_bar, 0);
        crank AB(A) -> B        { length: 0.2m, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (0.5m, 0.2m), mode: left }
        output I = pole(BC), C;
    }
}

mechanism! {
    /// Two cranks, of which one is geared to the other with the ratio of a parameter.
    pub struct Geared {
        input theta: angle;
        param teeth: number = 2;
        ground A(0, 0), D(1m, 0);
        crank first(A) -> B  { length: 0.2m, angle: theta }
        crank second(D) -> E { length: 0.2m, angle: teeth * theta }
        output K = pole(second, first);
    }
}

mechanism! {
    /// A wishbone suspension by the travel of its wheel.
    pub struct ByTravel {
        input travel: length;
        unknown lower: angle between (-25deg, 25deg);
        ground A(350mm, 180mm), D(400mm, 430mm);
        crank lower_arm(A) -> B             { length: 380mm, angle: lower }
        rrr   upright(B), upper_arm(D) -> C { lengths: (260mm, 300mm), mode: right }
        point hub on upright at (120mm, -80mm);
        point patch on upright at (-180mm, -90mm);
        solve lower { hub.y = travel, mode: rising }
        output gain = rate(upright.angle) / rate(travel), I = pole(upright), patch, upright;
    }
}
