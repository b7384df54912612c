// Two robots that are driven in two ways each. Their solvers in C, and what carries poses over:
//
//     linkage export c examples/firmware/robots.rs -o examples/firmware/solver/

mechanism! {
    /// A five-bar robot: two motors move a tool in the plane.
    pub struct FiveBar {
        ground A(-50mm, 0), E(50mm, 0);
        pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm);
        link AB(A, B), BC(B, tool), CD(D, tool), ED(E, D);
        input motors { a = AB.angle, b = ED.angle }
        input hand { x = tool.x, y = tool.y }
    }
}

mechanism! {
    /// A knee and an ankle whose motors both sit at the knee.
    pub struct Ankle {
        ground K(0, 0);
        pin A(0, -400mm), B(50mm, 0), H(60mm, -400mm);
        link shank(K, A), arm(K, B), rod(B, H), foot(A, H);
        input motors { knee = shank.angle + 90deg, motor = arm.angle }
        input joints { knee, ankle = foot.angle - shank.angle - 90deg }
    }
}
