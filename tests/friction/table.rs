//! Efforts and reactions of a slider-crank and a four-bar in thirty digits.
//!
//! They come from the full Newton-Euler matrix, in which every joint force is an unknown, solved in sixty
//! digits together with the amounts of friction; the digits agree with closed forms where there are some.

/// A state of the slider-crank: coefficient, length of the block, offset, input and its rates; drive and
/// reactions on the link that is named first.
pub(crate) struct Crank {
    pub name: &'static str,
    pub mu: f64,
    pub block: f64,
    pub offset: f64,
    pub state: [f64; 3],
    pub at_rest: bool,
    pub drive: f64,
    /// A, B, C in x and y, normal force and couple of the guide.
    pub reactions: [f64; 8],
    /// Amounts of A, B, C and the ram.
    pub amounts: [f64; 4],
}

/// Friction at every joint, pins of 20 mm.
#[rustfmt::skip]
#[expect(clippy::unreadable_literal, reason = "a table")]
pub(crate) const CRANKS: [Crank; 9] = [
    Crank {
        name: "crank_0_inverse", mu: 0.1, block: 0.06, offset: 0.0, at_rest: false,
        state: [1.0, 12.0, 30.0], drive: -9.427180316212864,
        reactions: [148.45429437943685, -35.72895416770332, 148.45429437943685, -35.72895416770332, -171.4712298127269, 52.56342385134817, 444.9634238513482, 0.3586937199364688],
        amounts: [0.30538654643329877, 0.30538654643329877, 0.3586937199364688, 44.49634238513482],
    },
    Crank {
        name: "crank_0_creep_forwards", mu: 0.1, block: 0.06, offset: 0.0, at_rest: true,
        state: [1.0, 1.0, 0.0], drive: -32.73119244874671,
        reactions: [447.54433068800836, -102.72669311991665, 447.54433068800836, -102.72669311991665, -447.54433068800836, 132.15669311991664, 524.5566931199166, 0.9332980648589585],
        amounts: [0.9183652898718045, 0.9183652898718045, 0.9332980648589585, 52.45566931199166],
    },
    Crank {
        name: "crank_0_creep_backwards", mu: 0.1, block: 0.06, offset: 0.0, at_rest: true,
        state: [1.0, -1.0, 0.0], drive: -46.33870289664256,
        reactions: [557.258365744642, -150.75365744641977, 557.258365744642, -150.75365744641977, -557.258365744642, 180.18365744641977, 572.5836574464198, -1.1713292220433296],
        amounts: [1.1545796662437142, 1.1545796662437142, 1.1713292220433296, 57.25836574464198],
    },
    Crank {
        name: "crank_1_inverse", mu: 0.2, block: 0.04, offset: 0.02, at_rest: false,
        state: [2.2, -7.0, 30.0], drive: -39.80009359330768,
        reactions: [635.382530645307, -105.10608520698376, 635.382530645307, -105.10608520698376, -633.7187542622402, 127.66352233040533, 520.0635223304054, 2.5857994800447814],
        amounts: [2.576069096578808, 2.576069096578808, 2.5857994800447814, 104.01270446608106],
    },
    Crank {
        name: "crank_1_creep_forwards", mu: 0.2, block: 0.04, offset: 0.02, at_rest: true,
        state: [2.2, 1.0, 0.0], drive: -20.09302408191306,
        reactions: [403.88720612752854, -58.733969362357335, 403.88720612752854, -58.733969362357335, -403.88720612752854, 88.16396936235734, 480.56396936235734, -1.6535912954160221],
        amounts: [1.6325418435338632, 1.6325418435338632, 1.6535912954160221, 96.11279387247147],
    },
    Crank {
        name: "crank_1_creep_backwards", mu: 0.2, block: 0.04, offset: 0.02, at_rest: true,
        state: [2.2, -1.0, 0.0], drive: -39.445923552487,
        reactions: [603.3238551108392, -94.78927555419608, 603.3238551108392, -94.78927555419608, -603.3238551108392, 124.21927555419607, 516.6192755541961, 2.4639159159841935],
        amounts: [2.4428988711148705, 2.4428988711148705, 2.4639159159841935, 103.32385511083922],
    },
    Crank {
        name: "crank_2_inverse", mu: 0.3, block: 0.06, offset: 0.0, at_rest: false,
        state: [0.02, 3.0, 30.0], drive: 7.539755721270517,
        reactions: [338.55068369978403, 31.274935569096904, 338.55068369978403, 31.274935569096904, -341.2226212200122, 1.732745894873976, 394.13274589487395, 2.0473621240663107],
        amounts: [2.039953120300544, 2.039953120300544, 2.0473621240663107, 118.23982376846219],
    },
    Crank {
        name: "crank_2_creep_forwards", mu: 0.3, block: 0.06, offset: 0.0, at_rest: true,
        state: [0.02, 1.0, 0.0], drive: 6.446886411520225,
        reactions: [382.6499644421565, 30.663214807188343, 382.6499644421565, 30.663214807188343, -382.6499644421565, -1.2332148071883424, 391.16678519281163, 2.2959117099375566],
        amounts: [2.3032594749780655, 2.3032594749780655, 2.2959117099375566, 117.3500355578435],
    },
    Crank {
        name: "crank_2_creep_backwards", mu: 0.3, block: 0.06, offset: 0.0, at_rest: true,
        state: [0.02, -1.0, 0.0], drive: -10.184552809483105,
        reactions: [632.4725447562412, -19.745149187470663, 632.4725447562412, -19.745149187470663, -632.4725447562412, 49.17514918747066, 441.5751491874707, -3.8062881848396133],
        amounts: [3.7966840885603528, 3.7966840885603528, 3.8062881848396133, 132.4725447562412],
    },
];

/// A state of the four-bar: coefficient, input and its rates, drive, reactions at A, B, C and D.
pub(crate) struct FourBar {
    pub mu: f64,
    pub state: [f64; 3],
    pub drive: f64,
    pub reactions: [f64; 8],
}

/// Friction at every pin, of 20 mm.
#[rustfmt::skip]
#[expect(clippy::unreadable_literal, reason = "a table")]
pub(crate) const FOUR_BARS: [FourBar; 2] = [
    FourBar {
        mu: 0.1, state: [0.7, 12.0, -20.0], drive: 1.0570995228043432,
        reactions: [41.107353771103405, 68.6523930653432, 48.887587469040405, 57.67752832197658, -111.20350814897381, -31.1568008778928, -137.18698787305541, 3.81395459809649],
    },
    FourBar {
        mu: 0.3, state: [2.9, -4.0, -20.0], drive: -15.807850549825604,
        reactions: [159.4696392842155, 133.50576188725216, 157.84401390608167, 112.63846796440673, -147.75857913503648, -47.420836785354545, -144.2862067106074, -6.437003845010654],
    },
];

/// Accelerations under given drives: coefficient, length of the block, offset, input and its rate, drive, and
/// the acceleration.
#[rustfmt::skip]
#[expect(clippy::unreadable_literal, reason = "a table")]
pub(crate) const CRANKS_FORWARD: [([f64; 3], [f64; 3], f64); 3] = [
    ([0.1, 0.06, 0.0], [1.0, 12.0, 20.0], 123.7430089898711),
    ([0.2, 0.04, 0.02], [2.2, -7.0, 20.0], 314.2712485289799),
    ([0.3, 0.06, 0.0], [0.02, 3.0, 20.0], 256.01125457958943),
];

/// The same of the four-bar by its coefficient.
#[rustfmt::skip]
#[expect(clippy::unreadable_literal, reason = "a table")]
pub(crate) const FOUR_BARS_FORWARD: [(f64, [f64; 3], f64); 2] = [
    (0.1, [0.7, 12.0, 15.0], 224.47729969544605),
    (0.3, [2.9, -4.0, 15.0], 381.42741587970926),
];
