mechanism! {
    /// An engine: the piston's travel, its velocity and its acceleration.
    pub struct Engine {
        input theta: angle;
        param stroke = 86mm;
        ground A(0, 0);
        guide bore through A along 0deg;
        crank AB(A) -> B { length: stroke / 2, angle: theta }
        rrp   rod(B), piston(bore) -> C { length: 140mm, mode: ahead }
        output piston.slide, rod.angle;
    }
}
