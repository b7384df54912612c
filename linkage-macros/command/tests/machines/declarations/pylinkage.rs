//! Every fixture as the program prints it, word for word.

use linkage_core::mechanism;

// pylinkage/coupler_curve.json
mechanism! {
    pub struct PylinkageCouplerCurve {
        // Left out: `angular_velocity` of `AB`, 0.1.
        // Left out: `initial_angle` of `AB`, 0.0.
        input theta: angle;
        ground A(0, 0), D(400mm, 0);
        pin B(50mm, 90mm), C(320mm, 260mm), P(160mm, 290mm);
        link AB(A, B);
        link BC(B, C, P);
        link DC(D, C);
        drive AB.angle = theta;
    }
}

// pylinkage/four_bar.json
mechanism! {
    pub struct PylinkageFourBar {
        // Left out: `angular_velocity` of `AB`, 0.1.
        // Left out: `initial_angle` of `AB`, 0.0.
        input theta: angle;
        ground A(0, 0), D(400mm, 0);
        pin B(50mm, 90mm), C(320mm, 260mm);
        link AB(A, B);
        link BC(B, C);
        link DC(D, C);
        drive AB.angle = theta;
    }
}

// pylinkage/slider_crank.json
mechanism! {
    pub struct PylinkageSliderCrank {
        // Left out: `angular_velocity` of `AB`, 0.1.
        // Left out: `initial_angle` of `AB`, 0.0.
        input theta: angle;
        ground A(0, 0);
        pin B(6mm, 5mm), C(26mm, 1mm);
        guide guide_C through (26mm, 1mm) along 0deg;
        link block_C(C) on guide_C;
        link AB(A, B);
        link BC(B, C);
        drive AB.angle = theta;
    }
}

// pylinkage/triangle.json
mechanism! {
    pub struct PylinkageTriangle {
        // Left out: `angular_velocity` of `AB`, 0.1.
        // Left out: `initial_angle` of `AB`, 0.0.
        // `BC`, `BP` and `CP` are a triangle: all are `BC`.
        // `BC`, `CQ` and `PQ` are a triangle: all are `BC`.
        input theta: angle;
        ground A(0, 0), D(400mm, 0);
        pin B(50mm, 90mm), C(320mm, 260mm), P(160mm, 290mm), Q(240mm, 330mm);
        link AB(A, B);
        link BC(B, C, P, Q);
        link DC(D, C);
        drive AB.angle = theta;
    }
}

// pylinkage/watt_1.json
mechanism! {
    pub struct PylinkageWatt1 {
        // Left out: `angular_velocity` of `AB`, 0.1.
        // Left out: `initial_angle` of `AB`, 0.0.
        input theta: angle;
        ground A(0, 0), D(300mm, 0);
        pin B(40mm, 100mm), C(260mm, 200mm), E(180mm, 290mm), F(390mm, 300mm), G(370mm, 160mm);
        link AB(A, B);
        link BC(B, C, E);
        link DC(D, C, G);
        link EF(E, F);
        link GF(G, F);
        drive AB.angle = theta;
    }
}
