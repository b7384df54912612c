linkage_core::mechanism! {
    /// A plate with the pins P, Q and R, on bars from A, B and C. A is on a crank, for an input.
    pub struct Triad {
        input t: angle;
        export assemblies;
        param bx = 4m; param by = 0m; param cx = 2m; param cy = 5m;
        param first = 1m; param second = 2m; param third = 1.5m;
        param side = 2m; param u = 1m; param v = 2m;
        ground O(0, 0), B(bx, by), C(cx, cy);
        crank OA(O) -> A { length: 1m, angle: t }
        unknown phi: angle between (-180deg, 180deg);
        crank AP(A) -> P { length: first, angle: phi }
        rrr PQ(P), BQ(B) -> Q { lengths: (side, second), mode: left }
        point R on PQ at (u, v);
        solve phi { distance(R, C) = third, mode: rising }
        output P, Q, R, plate = PQ.angle;
    }
}
