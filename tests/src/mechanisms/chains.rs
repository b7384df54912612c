//! Chains of one to ten RRR groups, each standing on the pin of the one before.

use linkage_core::mechanism;

macro_rules! chain {
    ($(#[$doc:meta])* $name:ident: $(
        $bar:ident($from:ident), $rocker:ident($pivot:ident at $x:tt, $y:tt) -> $pin:ident
        [$l1:ident $l2:ident $side:ident]
    )+) => {
        mechanism! {
            $(#[$doc])*
            pub struct $name {
                input theta: angle;
                $(param $l1 = 1m; param $l2 = 1m; param $side: mode = left;)+

                ground A(0, 0) $(, $pivot($x, $y))+;

                crank AB(A) -> C0 { length: 0.5m, angle: theta }
                $(rrr $bar($from), $rocker($pivot) -> $pin { lengths: ($l1, $l2), mode: $side })+

                output C0 $(, $pin)+;
            }
        }

        impl $name {
            /// The chain with the bars' and rockers' lengths and the modes, group by group.
            pub fn planned(groups: &[(f64, f64, linkage_core::Side)]) -> Self {
                let mut chain = Self::new();
                let mut groups = groups.iter();
                $(if let Some(&group) = groups.next() {
                    (chain.$l1, chain.$l2, chain.$side) = group;
                })+
                chain
            }
        }
    };
}

chain! {
    /// One RRR group in a row.
    Chain1:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
}

chain! {
    /// Two RRR groups in a row.
    Chain2:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
    B2(C1), R2(D2 at 4m, 0.25m) -> C2 [b2 r2 m2]
}

chain! {
    /// Three RRR groups in a row.
    Chain3:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
    B2(C1), R2(D2 at 4m, 0.25m) -> C2 [b2 r2 m2]
    B3(C2), R3(D3 at 6m, 0.5m) -> C3 [b3 r3 m3]
}

chain! {
    /// Four RRR groups in a row.
    Chain4:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
    B2(C1), R2(D2 at 4m, 0.25m) -> C2 [b2 r2 m2]
    B3(C2), R3(D3 at 6m, 0.5m) -> C3 [b3 r3 m3]
    B4(C3), R4(D4 at 8m, 0.25m) -> C4 [b4 r4 m4]
}

chain! {
    /// Five RRR groups in a row.
    Chain5:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
    B2(C1), R2(D2 at 4m, 0.25m) -> C2 [b2 r2 m2]
    B3(C2), R3(D3 at 6m, 0.5m) -> C3 [b3 r3 m3]
    B4(C3), R4(D4 at 8m, 0.25m) -> C4 [b4 r4 m4]
    B5(C4), R5(D5 at 10m, 0.5m) -> C5 [b5 r5 m5]
}

chain! {
    /// Six RRR groups in a row.
    Chain6:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
    B2(C1), R2(D2 at 4m, 0.25m) -> C2 [b2 r2 m2]
    B3(C2), R3(D3 at 6m, 0.5m) -> C3 [b3 r3 m3]
    B4(C3), R4(D4 at 8m, 0.25m) -> C4 [b4 r4 m4]
    B5(C4), R5(D5 at 10m, 0.5m) -> C5 [b5 r5 m5]
    B6(C5), R6(D6 at 12m, 0.25m) -> C6 [b6 r6 m6]
}

chain! {
    /// Seven RRR groups in a row.
    Chain7:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
    B2(C1), R2(D2 at 4m, 0.25m) -> C2 [b2 r2 m2]
    B3(C2), R3(D3 at 6m, 0.5m) -> C3 [b3 r3 m3]
    B4(C3), R4(D4 at 8m, 0.25m) -> C4 [b4 r4 m4]
    B5(C4), R5(D5 at 10m, 0.5m) -> C5 [b5 r5 m5]
    B6(C5), R6(D6 at 12m, 0.25m) -> C6 [b6 r6 m6]
    B7(C6), R7(D7 at 14m, 0.5m) -> C7 [b7 r7 m7]
}

chain! {
    /// Eight RRR groups in a row.
    Chain8:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
    B2(C1), R2(D2 at 4m, 0.25m) -> C2 [b2 r2 m2]
    B3(C2), R3(D3 at 6m, 0.5m) -> C3 [b3 r3 m3]
    B4(C3), R4(D4 at 8m, 0.25m) -> C4 [b4 r4 m4]
    B5(C4), R5(D5 at 10m, 0.5m) -> C5 [b5 r5 m5]
    B6(C5), R6(D6 at 12m, 0.25m) -> C6 [b6 r6 m6]
    B7(C6), R7(D7 at 14m, 0.5m) -> C7 [b7 r7 m7]
    B8(C7), R8(D8 at 16m, 0.25m) -> C8 [b8 r8 m8]
}

chain! {
    /// Nine RRR groups in a row.
    Chain9:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
    B2(C1), R2(D2 at 4m, 0.25m) -> C2 [b2 r2 m2]
    B3(C2), R3(D3 at 6m, 0.5m) -> C3 [b3 r3 m3]
    B4(C3), R4(D4 at 8m, 0.25m) -> C4 [b4 r4 m4]
    B5(C4), R5(D5 at 10m, 0.5m) -> C5 [b5 r5 m5]
    B6(C5), R6(D6 at 12m, 0.25m) -> C6 [b6 r6 m6]
    B7(C6), R7(D7 at 14m, 0.5m) -> C7 [b7 r7 m7]
    B8(C7), R8(D8 at 16m, 0.25m) -> C8 [b8 r8 m8]
    B9(C8), R9(D9 at 18m, 0.5m) -> C9 [b9 r9 m9]
}

chain! {
    /// Ten RRR groups in a row.
    Chain10:
    B1(C0), R1(D1 at 2m, 0.5m) -> C1 [b1 r1 m1]
    B2(C1), R2(D2 at 4m, 0.25m) -> C2 [b2 r2 m2]
    B3(C2), R3(D3 at 6m, 0.5m) -> C3 [b3 r3 m3]
    B4(C3), R4(D4 at 8m, 0.25m) -> C4 [b4 r4 m4]
    B5(C4), R5(D5 at 10m, 0.5m) -> C5 [b5 r5 m5]
    B6(C5), R6(D6 at 12m, 0.25m) -> C6 [b6 r6 m6]
    B7(C6), R7(D7 at 14m, 0.5m) -> C7 [b7 r7 m7]
    B8(C7), R8(D8 at 16m, 0.25m) -> C8 [b8 r8 m8]
    B9(C8), R9(D9 at 18m, 0.5m) -> C9 [b9 r9 m9]
    B10(C9), R10(D10 at 20m, 0.25m) -> C10 [b10 r10 m10]
}
