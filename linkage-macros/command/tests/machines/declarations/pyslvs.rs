//! Every fixture as the program prints it, word for word.

use linkage_core::mechanism;

// pyslvs/eight_bar_01_g0_d01.txt
mechanism! {
    pub struct PyslvsEightBar01G0D01 {
        // Left out: colours.
        input theta: angle;
        ground J0(68.6mm, 66.2mm), J1(13.3mm, 76.8mm);
        pin J2(98.2mm, 96.9mm), J3(61.3mm, 4.4mm), J4(0.4mm, 13.4mm), J5(94.1mm, 30.3mm), J6(36.6mm, 89.8mm), J7(31.4mm, 54.9mm), J8(43.6mm, 6.5mm), J9(58.5mm, 84.4mm);
        link L1(J0, J2);
        link L6(J1, J4, J7, J9);
        link L7(J2, J5, J8, J9);
        link L2(J3, J4);
        link L3(J3, J5);
        link L4(J6, J7);
        link L5(J6, J8);
        drive L1.angle = theta;
    }
}

// pyslvs/eight_bar_02_g0_d06.txt
mechanism! {
    pub struct PyslvsEightBar02G0D06 {
        // Left out: colours.
        input theta: angle;
        ground J0(54.4mm, 95.3mm), J1(70.9mm, 38.8mm);
        pin J2(91mm, 78.8mm), J3(2.1mm, 49.3mm), J4(30.1mm, 30.5mm), J5(37mm, 83.6mm), J6(61mm, 24.6mm), J7(6.7mm, 15mm), J8(37.5mm, 54.2mm), J9(49.8mm, 42.6mm);
        link L1(J0, J2);
        link L6(J1, J4, J6, J8);
        link L7(J2, J5, J7, J9);
        link L2(J3, J4);
        link L3(J3, J5);
        link L4(J6, J7);
        link L5(J8, J9);
        drive L6.angle = theta;
    }
}

// pyslvs/eight_bar_03_g0_d05.txt
mechanism! {
    pub struct PyslvsEightBar03G0D05 {
        // Left out: colours.
        input theta: angle;
        ground J0(8.8mm, 60.4mm), J1(10.7mm, 85.7mm);
        pin J2(55.4mm, 75.3mm), J3(42.8mm, 14.5mm), J4(30mm, 57.1mm), J5(69.9mm, 93.5mm), J6(79.9mm, 78.3mm), J7(85.7mm, 36.6mm), J8(57.5mm, 17.6mm), J9(37mm, 82mm);
        link L1(J0, J2);
        link L5(J1, J6, J8);
        link L7(J2, J5, J8, J9);
        link L2(J3, J4);
        link L3(J3, J5);
        link L6(J4, J7, J9);
        link L4(J6, J7);
        drive L5.angle = theta;
    }
}

// pyslvs/eight_bar_04_g0_d05.txt
mechanism! {
    pub struct PyslvsEightBar04G0D05 {
        // Left out: colours.
        input theta: angle;
        ground J0(53.9mm, 28.9mm), J1(3mm, 65.4mm);
        pin J2(21mm, 25.7mm), J3(39.7mm, 64.2mm), J4(98.9mm, 46.2mm), J5(99.3mm, 99.3mm), J6(24.3mm, 7.3mm), J7(16mm, 84.2mm), J8(60mm, 91.7mm), J9(97.2mm, 65.4mm);
        link L1(J0, J2);
        link L5(J1, J6, J8);
        link L7(J2, J5, J7, J9);
        link L2(J3, J4);
        link L3(J3, J5);
        link L6(J4, J8, J9);
        link L4(J6, J7);
        drive L5.angle = theta;
    }
}

// pyslvs/eight_bar_06_g0_d01.txt
mechanism! {
    pub struct PyslvsEightBar06G0D01 {
        // Left out: colours.
        input theta: angle;
        ground J0(46.8mm, 80.6mm), J1(48.5mm, 39.6mm);
        pin J2(4.6mm, 77.4mm), J3(19.2mm, 56.3mm), J4(79.5mm, 4.9mm), J5(26.7mm, 15.4mm), J6(92.6mm, 49.9mm), J7(83.9mm, 66.4mm), J8(90.2mm, 21mm), J9(67mm, 66.8mm);
        link L1(J0, J2);
        link L5(J1, J3, J9);
        link L7(J2, J4, J6, J8);
        link L2(J3, J4);
        link L3(J5, J6);
        link L6(J5, J7, J9);
        link L4(J7, J8);
        drive L1.angle = theta;
    }
}

// pyslvs/eight_bar_11_g2_d26.txt
mechanism! {
    pub struct PyslvsEightBar11G2D26 {
        // Left out: colours.
        input theta: angle;
        ground J3(13.2mm, 49.7mm), J4(0.8mm, 75.3mm);
        pin J0(52.8mm, 19.3mm), J1(58.3mm, 39.2mm), J2(0.1mm, 0.6mm), J5(55.9mm, 65.2mm), J6(3.3mm, 93.2mm), J7(99.3mm, 62.5mm), J8(82mm, 47.4mm), J9(22.1mm, 11.8mm);
        link L0(J0, J1);
        link L1(J0, J2);
        link L4(J1, J3, J7);
        link L5(J2, J5, J8);
        link L6(J4, J8, J9);
        link L3(J5, J6);
        link L7(J6, J7, J9);
        drive L6.angle = theta;
    }
}

// pyslvs/eight_bar_13_g4_d04.txt
mechanism! {
    pub struct PyslvsEightBar13G4D04 {
        // Left out: colours.
        input theta: angle;
        ground J1(77.2mm, 57.3mm), J7(90.1mm, 41.7mm), J8(44.8mm, 97.8mm);
        pin J0(40mm, 17.2mm), J2(97.9mm, 81.7mm), J3(10.5mm, 27.3mm), J4(51.4mm, 6.5mm), J5(74.1mm, 35.1mm), J6(11.3mm, 2.8mm), J9(69.9mm, 0.6mm);
        link L0(J0, J1);
        link L1(J0, J2);
        link L5(J2, J7, J9);
        link L2(J3, J4);
        link L6(J3, J5, J8);
        link L7(J4, J6, J9);
        link L3(J5, J6);
        drive L0.angle = theta;
    }
}

// pyslvs/five_bar.txt
mechanism! {
    pub struct PyslvsFiveBar {
        // Left out: colours.
        input theta: angle;
        input theta_2: angle;
        ground J0(0, 0), J1(20mm, 0);
        pin J2(-10mm, 20mm), J3(30mm, 22mm), J4(11mm, 40mm);
        link AB(J0, J2);
        link ED(J1, J3);
        link BC(J2, J4);
        link DC(J3, J4);
        drive AB.angle = theta;
        drive ED.angle = theta_2;
    }
}

// pyslvs/four_bar.txt
mechanism! {
    pub struct PyslvsFourBar {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J3(400mm, 0);
        pin J1(50mm, 90mm), J2(320mm, 260mm);
        link AB(J0, J1);
        link BC(J1, J2);
        link DC(J2, J3);
        drive AB.angle = theta;
    }
}

// pyslvs/peaucellier.txt
mechanism! {
    pub struct PyslvsPeaucellier {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J1(13mm, 0);
        pin J2(24mm, 6.87mm), J3(28mm, 16.36mm), J4(32mm, 0.09mm), J5(36mm, 9.58mm);
        link OP(J0, J3);
        link OQ(J0, J4);
        link AB(J1, J2);
        link BP(J2, J3);
        link BQ(J2, J4);
        link PE(J3, J5);
        link QE(J4, J5);
        drive AB.angle = theta;
    }
}

// pyslvs/scissor.txt
mechanism! {
    pub struct PyslvsScissor {
        // Left out: colours.
        input s: length;
        ground J0(0, 0);
        pin J1(72mm, 0), J2(36mm, 48mm), J3(72mm, 96mm), J4(0, 96mm);
        guide guide_J1 through (72mm, 0) along 0deg;
        guide guide_J3 on deck through (72mm, 0) along 0deg;
        link AC(J0, J2, J3);
        link BD(J1, J2, J4);
        link B1(J1) on guide_J1;
        link B3(J3) on guide_J3;
        link deck(J4);
        drive B1.slide = s;
    }
}

// pyslvs/scotch_yoke.txt
mechanism! {
    pub struct PyslvsScotchYoke {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0);
        pin J1(4mm, 3mm);
        guide guide_J1 on yoke through (4mm, 3mm) along 90deg;
        guide guide_J2 through (0, 0) along 0deg;
        link AB(J0, J1);
        link B1(J1) on guide_J1;
        link yoke() on guide_J2;
        drive AB.angle = theta;
    }
}

// pyslvs/slider_crank.txt
mechanism! {
    pub struct PyslvsSliderCrank {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0);
        pin J1(6mm, 5mm), J2(26mm, 1mm);
        guide guide_J2 through (26mm, 1mm) along 0deg;
        link AB(J0, J1);
        link BC(J1, J2);
        link B2(J2) on guide_J2;
        drive AB.angle = theta;
    }
}

// pyslvs/stephenson_1.txt
mechanism! {
    pub struct PyslvsStephenson1 {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J1(400mm, 0);
        pin J2(60mm, 100mm), J3(100mm, 260mm), J4(360mm, 190mm), J5(330mm, 360mm), J6(220mm, 460mm);
        link ABE(J0, J2, J3);
        link DCF(J1, J4, J5);
        link BC(J2, J4);
        link EH(J3, J6);
        link FH(J5, J6);
        drive ABE.angle = theta;
    }
}

// pyslvs/stephenson_2.txt
mechanism! {
    pub struct PyslvsStephenson2 {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J1(400mm, 0);
        pin J2(50mm, 100mm), J3(130mm, 260mm), J4(220mm, 120mm), J5(340mm, 280mm), J6(360mm, 110mm);
        link AB(J0, J2);
        link DHF(J1, J5, J6);
        link BCE(J2, J3, J4);
        link CF(J3, J5);
        link EH(J4, J6);
        drive AB.angle = theta;
    }
}

// pyslvs/stephenson_3.txt
mechanism! {
    pub struct PyslvsStephenson3 {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J1(320mm, 20mm), J2(600mm, 10mm);
        pin J3(40mm, 100mm), J4(290mm, 220mm), J5(240mm, 340mm), J6(540mm, 230mm);
        link AB(J0, J3);
        link DC(J1, J4);
        link GF(J2, J6);
        link BCE(J3, J4, J5);
        link EF(J5, J6);
        drive AB.angle = theta;
    }
}

// pyslvs/stephenson_3_other_end.txt
mechanism! {
    pub struct PyslvsStephenson3OtherEnd {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J1(320mm, 20mm), J2(600mm, 10mm);
        pin J3(40mm, 100mm), J4(290mm, 220mm), J5(240mm, 340mm), J6(540mm, 230mm);
        link AB(J0, J3);
        link DC(J1, J4);
        link GF(J2, J6);
        link BCE(J3, J4, J5);
        link EF(J5, J6);
        drive GF.angle = theta;
    }
}

// pyslvs/stephenson_g0_d01.txt
mechanism! {
    pub struct PyslvsStephensonG0D01 {
        // Left out: colours.
        input theta: angle;
        ground J0(70.5mm, 5.7mm), J1(97.5mm, 2.3mm);
        pin J2(75mm, 84.5mm), J3(1.8mm, 78.8mm), J4(36.6mm, 57.9mm), J5(0.9mm, 4.7mm), J6(18.1mm, 95.5mm);
        link L1(J0, J2);
        link L4(J1, J3, J5);
        link L5(J2, J4, J6);
        link L2(J3, J4);
        link L3(J5, J6);
        drive L1.angle = theta;
    }
}

// pyslvs/triad.txt
mechanism! {
    pub struct PyslvsTriad {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J5(460mm, 20mm), J6(40mm, 420mm);
        pin J1(50mm, 90mm), J2(160mm, 160mm), J3(300mm, 190mm), J4(240mm, 300mm);
        link AB(J0, J1);
        link BP(J1, J2);
        link plate(J2, J3, J4);
        link DQ(J3, J5);
        link ER(J4, J6);
        drive AB.angle = theta;
    }
}

// pyslvs/watt_1.txt
mechanism! {
    pub struct PyslvsWatt1 {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J3(300mm, 0);
        pin J1(40mm, 100mm), J2(260mm, 200mm), J4(180mm, 290mm), J5(390mm, 300mm), J6(370mm, 160mm);
        link AB(J0, J1);
        link BC(J1, J2, J4);
        link DC(J2, J3, J6);
        link EF(J4, J5);
        link GF(J5, J6);
        drive AB.angle = theta;
    }
}

// pyslvs/watt_2.txt
mechanism! {
    pub struct PyslvsWatt2 {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J3(300mm, 0), J6(600mm, 10mm);
        pin J1(40mm, 100mm), J2(260mm, 200mm), J4(420mm, 190mm), J5(590mm, 180mm);
        link AB(J0, J1);
        link BC(J1, J2);
        link DCE(J2, J3, J4);
        link EF(J4, J5);
        link GF(J5, J6);
        drive AB.angle = theta;
    }
}

// pyslvs/whitworth.txt
mechanism! {
    pub struct PyslvsWhitworth {
        // Left out: colours.
        input theta: angle;
        ground J0(0, 0), J1(0, 30mm);
        pin J2(10mm, 42mm), J3(14mm, 58.8mm), J4(50mm, 62mm);
        guide guide_J2 on lever through (43.174066289846mm, 0) along -0.000000039204rad;
        guide guide_J4 through (50mm, 62mm) along 0deg;
        link lever(J0, J3);
        link AB(J1, J2);
        link B2(J2) on guide_J2;
        link CR(J3, J4);
        link B4(J4) on guide_J4;
        drive AB.angle = theta;
    }
}
