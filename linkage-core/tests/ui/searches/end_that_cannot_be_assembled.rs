linkage_core::mechanism! {
    pub struct M {
        input x: length;
        ground A(0, 0), D(300mm, 0);
        guide bed through (0, 0) along 0deg;
        unknown theta: angle between (-90deg, 90deg);
        crank AB(A) -> B           { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C    { lengths: (150mm, 130mm), mode: left }
        solve theta { C.y = x, mode: rising }
    }
}

fn main() {}
