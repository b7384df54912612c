//! Machines in which a sign of the cut would show: drives backwards, blocks beside their rails, lengths that are declared
//! otherwise than drawn.

#![allow(non_snake_case)]

use linkage_core::mechanism;

mechanism! {
    /// A drive that is a formula of its input.
    pub struct Bent {
        input theta: angle;
        ground A(0, 0), D(4, 0);
        pin B(0.5, 0.9), C(3.2, 2.6);
        link AB(A, B);
        link BC(B, C);
        link DC(D, C);
        drive AB.angle = 60.945deg + 0.5 * sin(theta);
    }
}

mechanism! {
    /// A plate on a cylinder and two bars.
    pub struct Cylinder {
        input s: length;
        ground A(0, 0), D(4.6, 0.2), E(0.4, 4.2);
        pin P(1.6, 1.6), Q(3, 1.9), R(2.4, 3);
        link AP(A, P) { length: s };
        link plate(P, Q, R);
        link DQ(D, Q);
        link ER(E, R);
    }
}

mechanism! {
    /// A deck on a scissor, a little askew.
    pub struct Deck {
        input s: length;
        ground A(0, 0);
        pin B(0.72, 0), M(0.36, 0.48), C(0.72, 0.96), D(0.02, 0.94);
        link foot(B) on floor;
        link AC(A, M, C);
        link BD(B, M, D);
        link top(C) on table;
        link deck(D);
        guide floor through (0, 0) along 0deg;
        guide table on deck through (0, 0.02) along 2deg;
        drive foot.slide = s;
    }
}

mechanism! {
    /// A six-bar driven at its far end by twice its input.
    pub struct Geared {
        input theta: angle;
        ground A(0, 0), D(3.2, 0.2), G(6, 0.1);
        pin B(0.4, 1), C(2.9, 2.2), E(2.4, 3.4), F(5.4, 2.3);
        link AB(A, B);
        link BCE(B, C, E);
        link DC(D, C);
        link EF(E, F);
        link GF(G, F);
        drive GF.angle = 2 * theta + 0.3rad;
    }
}

mechanism! {
    /// Two links whose angle is given, between bars.
    pub struct HeldArms {
        input q: angle;
        ground A(0, 0), D(4, 0), G(1.5, 3);
        pin B(0.5, 0.9), P(1.7, 1.9), C(3.2, 2.6), R(2.4, 1.2);
        link AB(A, B);
        link BP(B, P);
        link PC(P, C);
        link DC(D, C, R);
        link GP(G, P);
        drive BP.angle - PC.angle = q;
    }
}

mechanism! {
    /// The same with a plate whose pins come in another order.
    pub struct HeldPlate {
        input q: angle;
        ground A(0, 0), D(4, 0);
        pin B(0.5, 0.9), C(3.2, 2.6), Z(4.3, 1.4);
        link AB(A, B);
        link BC(B, C);
        link DC(D, Z, C);
        drive BC.angle - DC.angle = q;
    }
}

mechanism! {
    /// A block whose pin is beside its rail.
    pub struct OffsetBlock {
        input theta: angle;
        ground A(0, 0), D(4.6, 0.2);
        pin B(0.5, 0.9), P(1.6, 1.6), Q(3, 1.9), R(2.4, 3);
        link AB(A, B);
        link BP(B, P);
        link plate(P, Q, R);
        link DQ(D, Q);
        link block(R) on rail;
        guide rail through (0.2, 3.2) along 4deg;
        drive AB.angle = theta;
    }
}

mechanism! {
    /// A ram whose pin is beside its bed.
    pub struct OffsetRam {
        input theta: angle;
        ground A(0, 0), G(6, 0.1);
        pin B(0.4, 1), C(2.9, 2.2), E(2.4, 3.4), F(5.4, 2.3);
        link AB(A, B);
        link BCE(B, C, E);
        link ram(C) on bed;
        guide bed through (0, 2) along 5deg;
        link EF(E, F);
        link GF(G, F);
        drive GF.angle = theta;
    }
}

mechanism! {
    /// A group of class III.
    pub struct Stephenson {
        input theta: angle;
        ground A(0, 0), D(4, 0);
        pin B(0.5, 1), C(1.3, 2.6), E(2.2, 1.2), F(3.4, 2.8), H(3.6, 1.1);
        link AB(A, B);
        link BCE(B, C, E);
        link CF(C, F);
        link EH(E, H);
        link DHF(D, H, F);
        drive AB.angle = theta;
    }
}

mechanism! {
    /// The angle between two links, backwards.
    pub struct TurnedBack {
        input q: angle;
        ground A(0, 0), D(3.2, 0.2), G(6, 0.1);
        pin B(0.4, 1), C(2.9, 2.2), E(2.4, 3.4), F(5.4, 2.3);
        link AB(A, B);
        link BCE(B, C, E);
        link DC(D, C);
        link EF(E, F);
        link GF(G, F);
        drive EF.angle - GF.angle = q;
    }
}

mechanism! {
    /// Two inputs, one against the other.
    pub struct TwoInputs {
        input theta: angle;
        input psi: angle;
        ground A(0, 0), D(4.6, 0.2), E(0.4, 4.2);
        pin B(0.5, 0.9), P(1.6, 1.6), Q(3, 1.9), R(2.4, 3), S(4.2, 0.9);
        link AB(A, B);
        link DS(D, S);
        link BP(B, P);
        link plate(P, Q, R);
        link SQ(S, Q);
        link ER(E, R);
        drive AB.angle = theta;
        drive DS.angle - AB.angle = psi;
    }
}

mechanism! {
    /// Lengths that are declared otherwise than drawn.
    pub struct TwoLengths {
        input theta: angle;
        param l = 0.9m;
        ground A(0, 0), D(3, 0);
        pin B(0.4, 1), C(2.6, 2), E(1.8, 2.9), F(3.9, 3), G(3.7, 1.6);
        link AB(A, B) { length: l };
        link BC(B, C, E);
        link DC(D, C, G);
        link EF(E, F);
        link GF(G, F) { length: 1.35m };
        drive AB.angle = theta;
    }
}

mechanism! {
    /// A lever that is driven, and a slot beside its pin.
    pub struct Whitworth {
        input theta: angle;
        ground O(0, 0), A(0, 0.3);
        pin B(0.1, 0.42), C(0.14, 0.588), R(0.5, 0.62);
        link AB(A, B);
        link lever(O, C);
        link block(B) on slot;
        link CR(C, R);
        link ram(R) on bed;
        guide slot on lever through (0.02, 0) along 76deg;
        guide bed through (0, 0.6) along 0deg;
        drive lever.angle = theta;
    }
}

mechanism! {
    /// A four-bar of a crank and a dyad.
    pub struct Bar {
        input theta: angle;
        param a = 80mm;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B { length: a, angle: theta }
        rrr BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }
    }
}

mechanism! {
    /// A crank of a parameter's length, which changes no other one.
    pub struct LongerCrank {
        input theta: angle;
        param crank = 80mm;
        ground A(0, 0), D(665.7mm, 0);
        pin B(80mm, 0), C(600mm, 360mm), blade(570mm, 90mm);
        link AB(A, B) { length: crank }
        link BC(B, C, blade), DC(D, C);
        drive AB.angle = theta;
    }
}
