linkage_core::mechanism! {
    /// A five-bar robot.
    pub struct FiveBar {
        param upper = 114mm;
        ground A(-50mm, 0), E(50mm, 0);
        pin B(-120mm, 90mm), D(120mm, 90mm), tool(0, 200mm);
        link BC(B, tool), CD(D, tool), ED(E, D);
        link AB(A, B) { length: upper }
        input motors { a = AB.angle, b = ED.angle }
        input hand { x = tool.x, y = tool.y }
    }
}
