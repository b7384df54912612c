// Machines that are driven in several ways, one with a parameter, one with a guide, one with a search.

mechanism! {
    /// A five-bar robot.
    pub struct Arm {
        /// The upper arm.
        param upper = 114mm;
        ground A(-50mm, 0), E(50mm, 0);
        pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm);
        link BC(B, tool), CD(D, tool), ED(E, D);
        link AB(A, B) { length: upper }
        input motors { a = AB.angle, b = ED.angle }
        input hand { x = tool.x, y = tool.y }
    }
}

mechanism! {
    pub struct Slider {
        ground A(0, 0);
        guide bed through (0, 0) along 0deg;
        pin B(40mm, 69.282mm), C(280mm, 0);
        link AB(A, B), BC(B, C), ram(C) on bed;
        input crank_side { theta = AB.angle }
        input press { x = ram.slide }
    }
}

mechanism! {
    pub struct Bicycle {
        param frame = 330mm;
        ground M(0, 60mm), R(60mm, frame), U(190mm, 250mm);
        pin H(-390mm, 10mm), S(-20mm, 380mm), axle(-435mm, 25mm), T(110mm, 400mm);
        link chainstay(M, H), seatstay(H, S, axle), rocker(R, S, T);
        input shock { stroke = distance(T, U) }
        input wheel { travel = axle.y }
        input lever { lean = rocker.angle }
    }
}
