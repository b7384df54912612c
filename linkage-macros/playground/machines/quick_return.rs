mechanism! {
    /// A shaper: the crank's block slides in the lever, and the tool comes back faster than it cuts.
    pub struct Shaper {
        input theta: angle;
        ground A(0, 0), D(0, -300mm);
        crank AB(A) -> B { length: 100mm, angle: theta }
        rpr   block(B), lever(D) {}
        point E on lever at (520mm, 0);
        guide bed through (0, 200mm) along 0deg;
        rrp   rod(E), tool(bed) -> F { length: 180mm, mode: behind }
        output tool.slide, lever.angle;
    }
}
