//! Andrews' squeezer after 0.03 s, to more digits than are published.
//!
//! The Test Set for Initial Value Problem Solvers (Mazzia and Magherini, release 2.4, problem "Andrews'
//! squeezing mechanism") has a reference of 16 digits, of which about 10 are right in β, 7 in rates and 6
//! in accelerations and reactions: it is an index-3 run at a tolerance of 1e-14. These numbers come from the
//! equation of one degree of freedom in closed form, in 40 decimal digits, by Gragg, Bulirsch and Stoer's
//! extrapolation with 240 and with 300 steps, which agree to 1e-34 in β and to 1e-33 in its rate; its
//! energy is constant to 2e-36, and it has the test set's initial values to all their digits. Here they are
//! rounded to `f64`.

/// β, Θ, γ, Φ, δ, Ω, ε, as the test set's initial values have them.
pub(crate) const START: [f64; 7] = [
    -0.061_713_890_014_276_45,
    0.0,
    0.455_279_819_163_070_37,
    0.222_668_390_165_885_88,
    0.487_364_979_543_842_56,
    -0.222_668_390_165_885_88,
    1.230_547_444_549_821_2,
];

/// Angles, their rates in rad/s, their accelerations in rad/s², all in the order of [`START`]; the forces on
/// K3, K4 and K6 at P, in N, x and y.
#[rustfmt::skip]
pub(crate) const ROW: [f64; 27] = [
    15.810_771_195_153_707, -15.756_371_058_411_839, 0.040_822_240_119_645_8, -0.534_730_116_342_079_6,
    0.524_409_965_879_954, 0.534_730_116_342_079_6, 1.048_080_741_041_938,
    1_139.920_302_259_106_2, -1_424.379_295_177_540_1, 11.032_911_910_618_594, 19.293_374_105_032_04,
    0.573_569_914_829_502_5, -19.293_374_105_032_04, 0.323_179_149_249_130_9,
    -24_631.763_122_874_636, 51_850.319_636_464_23, 324_102.600_707_578_6, 566_749.422_000_995_4,
    16_743.635_418_345_446, -566_749.422_000_995_4, 9_826.507_801_544_163,
    199.175_348_104_538_64, -29.755_309_974_971_762, 23.066_543_611_622_15,
    31.452_725_275_771_137, 22.642_494_786_394_38, 11.617_392_352_611_256,
];
