//! Every fixture as the program prints it, word for word.

use linkage_core::mechanism;

// pmks/blocks_of_joints.txt
mechanism! {
    pub struct PmksBlocksOfJoints {
        // Left out: the speed of the input at `A`, 4 rpm.
        // Left out: locks.
        // Left out: colours.
        // `block_C` is welded to `CD` at `C`: both are `CD`.
        input theta: angle;
        ground A(0, 0);
        pin B(3cm, 0), C(3cm, -5cm), D(3cm, 5cm);
        guide guide_B on CD through C towards D;
        guide guide_C through (3cm, -5cm) along 0deg;
        link AB(A, B);
        link CD(C, D) on guide_C;
        link block_B(B) on guide_B;
        drive AB.angle = theta;
        mass 0.5g on block_B at (0, 0) inertia 0(kg*cm^2);
        mass 2g on AB at (1.5cm, 0) inertia 0.5(kg*cm^2);
        mass 3g on CD at (5cm, 0) inertia 4(kg*cm^2);
    }
}

// pmks/boom.txt
mechanism! {
    pub struct PmksBoom {
        // Left out: the speed of the input at `Z2`, 20.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        input s: length;
        ground A(0, 0), C(70cm, -20cm);
        pin B(150cm, 110cm), D(102cm, 32cm), T(210cm, 90cm);
        guide guide_Z2 on CR through C towards D;
        link AB(A, B, T);
        link CR(C, D);
        link rod(B) on guide_Z2;
        drive rod.slide = s;
    }
}

// pmks/driven_elbow.txt
mechanism! {
    pub struct PmksDrivenElbow {
        // Left out: the speed of the input at `B`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        input theta: angle;
        ground A(0, 0), D(400cm, 0);
        pin B(50cm, 90cm), C(320cm, 260cm);
        link AB(A, B);
        link BC(B, C);
        link DC(D, C);
        drive AB.angle - BC.angle = theta;
    }
}

// pmks/four_bar.txt
mechanism! {
    pub struct PmksFourBar {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        input theta: angle;
        ground A(0, 0), D(400cm, 0);
        pin B(50cm, 90cm), C(320cm, 260cm);
        link AB(A, B);
        link BC(B, C);
        link DC(D, C);
        drive AB.angle = theta;
    }
}

// pmks/loaded_four_bar.txt
mechanism! {
    pub struct PmksLoadedFourBar {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        input theta: angle;
        ground A(0, 0), D(400cm, 0);
        pin B(50cm, 90cm), C(320cm, 260cm);
        link AB(A, B);
        link BC(B, C);
        link DC(D, C);
        drive AB.angle = theta;
        mass 12.5g on AB at (51.478150704935cm, 0) inertia 0.025(kg*cm^2);
        mass 340g on BC at (163.291596180282cm, 15.357558949777cm) inertia 31.25(kg*cm^2);
        point F1 on BC at (159.530561335438cm, 0);
        force (0N, -42.5N) on F1;
        point F2 on DC at (136.014705087354cm, 0);
        force (2.940858488375N, 9.55779008722N) in DC on F2;
    }
}

// pmks/older.txt
mechanism! {
    pub struct PmksOlder {
        // Left out: the speed of the input at `a`, 10 rpm.
        // Left out: gravity.
        input theta: angle;
        ground a(0, 0);
        pin b(6cm, 5cm), c(26cm, 1cm);
        guide guide_d through (26cm, 1cm) along 45deg;
        link ab(a, b);
        link bc(b, c);
        link cd(c) on guide_d;
        drive ab.angle = theta;
        mass 1g on ab at (3.905124837953cm, 0) inertia 1(kg*cm^2);
        mass 2.5g on bc at (10.198039027186cm, 0) inertia 1(kg*cm^2);
        mass 1g on cd at (0, 0) inertia 0(kg*cm^2);
        point F1 on bc at (4.118438837902cm, -0.196116135138cm);
        force (3N, 4N) on F1;
    }
}

// pmks/peaucellier.txt
mechanism! {
    pub struct PmksPeaucellier {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        input theta: angle;
        ground O(0, 0), A(13cm, 0);
        pin B(24cm, 6.87cm), P(28cm, 16.36cm), Q(32cm, 0.09cm), E(36cm, 9.58cm);
        link AB(A, B);
        link OP(O, P);
        link OQ(O, Q);
        link BP(B, P);
        link BQ(B, Q);
        link PE(P, E);
        link QE(Q, E);
        drive AB.angle = theta;
    }
}

// pmks/rounded_parallelogram.txt
mechanism! {
    pub struct PmksRoundedParallelogram {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        // `C` was at (50.607, 10.606): `AB` and `DC` are made parallel and equal.
        input theta: angle;
        ground A(0, 0), D(40cm, 0);
        pin B(10.606cm, 10.607cm), C(50.606cm, 10.607cm);
        link AB(A, B);
        link BC(B, C);
        link DC(D, C);
        drive AB.angle = theta;
    }
}

// pmks/slider_crank.txt
mechanism! {
    pub struct PmksSliderCrank {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        input theta: angle;
        ground A(0, 0);
        pin B(6cm, 5cm), C(26cm, 1cm);
        guide guide_Z2 through (26cm, 1cm) along 0deg;
        link AB(A, B);
        link BC(B, C);
        link ram(C) on guide_Z2;
        drive AB.angle = theta;
    }
}

// pmks/slotted_coupler.txt
mechanism! {
    pub struct PmksSlottedCoupler {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        input theta: angle;
        ground A(0, 0), D(70cm, 0), E(30cm, 55cm);
        pin B(10cm, 18cm), C(62cm, 30cm), F(36cm, 24cm);
        guide guide_Z4 on BC through B towards C;
        link AB(A, B);
        link BC(B, C);
        link CD(C, D);
        link EF(E, F);
        link FZ(F) on guide_Z4;
        drive AB.angle = theta;
    }
}

// pmks/stephenson_3.txt
mechanism! {
    pub struct PmksStephenson3 {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        input theta: angle;
        ground A(0, 0), D(320cm, 20cm), G(600cm, 10cm);
        pin B(40cm, 100cm), C(290cm, 220cm), E(240cm, 340cm), F(540cm, 230cm);
        link AB(A, B);
        link BCE(B, C, E);
        link DC(D, C);
        link EF(E, F);
        link GF(G, F);
        drive AB.angle = theta;
    }
}

// pmks/triad.txt
mechanism! {
    pub struct PmksTriad {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        input theta: angle;
        ground A(0, 0), D(460cm, 20cm), E(40cm, 420cm);
        pin B(50cm, 90cm), P(160cm, 160cm), Q(300cm, 190cm), R(240cm, 300cm);
        link AB(A, B);
        link BP(B, P);
        link plate(P, Q, R);
        link DQ(D, Q);
        link ER(E, R);
        drive AB.angle = theta;
    }
}

// pmks/upright_slider.txt
mechanism! {
    pub struct PmksUprightSlider {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        // `guide_Z` is along 90deg, which PMKS+ wrote as 1.571 rad.
        input theta: angle;
        ground A(0, 0);
        pin B(5cm, -3cm), C(1cm, 20cm);
        guide guide_Z through (1cm, 20cm) along 90deg;
        link AB(A, B);
        link BC(B, C);
        link ram(C) on guide_Z;
        drive AB.angle = theta;
    }
}

// pmks/watt_1.txt
mechanism! {
    pub struct PmksWatt1 {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        input theta: angle;
        ground A(0, 0), D(300cm, 0);
        pin B(40cm, 100cm), C(260cm, 200cm), E(180cm, 290cm), F(390cm, 300cm), G(370cm, 160cm);
        link AB(A, B);
        link BC(B, C, E);
        link DC(D, C, G);
        link EF(E, F);
        link GF(G, F);
        drive AB.angle = theta;
    }
}

// pmks/welded_cylinder.txt
mechanism! {
    pub struct PmksWeldedCylinder {
        // Left out: the speed of the input at `S`, 20.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        // `PS` is welded to `PC` at `P`: both are `PC`.
        input s: length;
        ground O(0, 0), G(4cm, 0);
        pin C(0, 5cm), N(2cm, 2.5cm), P(2.4cm, 2cm);
        guide guide_S on GN through G towards N;
        link OC(O, C);
        link GN(G, N);
        link PC(P, C) on guide_S;
        drive PC.slide = s;
    }
}

// pmks/welded_parts.txt
mechanism! {
    pub struct PmksWeldedParts {
        // Left out: the speed of the input at `O`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        // `block` stays pinned to `ABT` at `B`, where parts of `ABT` are welded.
        input theta: angle;
        ground O(0, 0);
        pin A(6cm, 5cm), B(26cm, 1cm), T(30cm, 8cm);
        guide guide_Z through (26cm, 1cm) along 0deg;
        link OA(O, A);
        link ABT(A, B, T);
        link block(B) on guide_Z;
        drive OA.angle = theta;
    }
}

// pmks/welded_yoke.txt
mechanism! {
    pub struct PmksWeldedYoke {
        // Left out: the speed of the input at `A`, 20 rpm.
        // Left out: colours.
        // Left out: masses of links, which are as PMKS+ sets them.
        // `CF` is welded to `CD` at `C`: both are `CD`.
        input theta: angle;
        ground A(0, 0);
        pin B(3cm, 0), C(3cm, -5cm), D(3cm, 5cm);
        guide guide_E on CD through C towards D;
        guide guide_F through (3cm, -5cm) along 0deg;
        link AB(A, B);
        link CD(C, D) on guide_F;
        link BE(B) on guide_E;
        drive AB.angle = theta;
    }
}
