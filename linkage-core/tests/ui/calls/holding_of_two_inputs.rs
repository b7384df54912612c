use linkage_core::mechanism;

mechanism! {
    pub struct M {
        input lift, curl: length;
        ground F(0.6m, -0.5m), O(0, 0);
        rrr cylinder(F), boom(O) -> G { lengths: (lift, 2.4m), mode: right }
        point J on boom at (4m, 0.2m);
        point tip on boom at (5.4m, -0.9m);
        rrr ram(J), stick(tip) -> H { lengths: (curl, 1m), mode: left }
        mass 100kg on tip;
        mass 50kg on H;
        friction 0.1 at O radius 40mm;
    }
}

fn main() {
    let _ = M::new().holding([2.3, 1.2]);
}
