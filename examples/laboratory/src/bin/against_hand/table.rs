// Written by `draw_mechanisms` of this package, which says how.

drawn! { four_bar_01: crank 0.04, D(0.272, 0.0),
    lengths 0.41 0.247 right, P(0.205, 0.051),
    output [C P] [BC DC] }

drawn! { four_bar_02: crank 0.084, D(0.34, 0.0),
    lengths 0.473 0.427 left, P(0.298, 0.095),
    output [C P] [BC] }

drawn! { four_bar_03: crank 0.129, D(0.272, 0.023),
    lengths 0.288 0.262 right, P(0.255, -0.092),
    output [P] [DC] }

drawn! { four_bar_04: crank 0.041, D(0.3, 0.0),
    lengths 0.279 0.259 left, P(0.207, 0.05),
    output [C] [BC DC] }

drawn! { four_bar_05: crank 0.064, D(0.45, 0.187),
    lengths 0.473 0.402 right, P(0.123, 0.119),
    output [P] [BC DC] }

drawn! { four_bar_06: crank 0.072, D(0.378, 0.117),
    lengths 0.386 0.158 right, P(0.277, -0.116),
    output [C] [BC DC] }

drawn! { four_bar_07: crank 0.032, D(0.17, 0.0),
    lengths 0.306 0.312 right, P(0.241, -0.001),
    output [C P] [DC] }

drawn! { four_bar_08: crank 0.071, D(0.248, 0.0),
    lengths 0.315 0.186 left, P(0.082, 0.143),
    output [C P] [DC] }

drawn! { four_bar_09: crank 0.067, D(0.467, 0.076),
    lengths 0.262 0.385 left, P(0.26, -0.013),
    output [C P] [DC] }

drawn! { four_bar_10: crank 0.074, D(0.474, 0.081),
    lengths 0.254 0.438 right, P(0.208, 0.096),
    output [P] [BC] }

drawn! { four_bar_11: crank 0.039, D(0.158, 0.162),
    lengths 0.346 0.273 right, P(0.267, -0.057),
    output [C P] [DC] }

drawn! { four_bar_12: crank 0.047, D(0.388, 0.066),
    lengths 0.363 0.389 left, P(0.068, -0.123),
    output [C P] [BC] }

drawn! { four_bar_13: crank 0.102, D(0.397, 0.0),
    lengths 0.232 0.37 right, P(0.287, 0.015),
    output [C P] [BC DC] }

drawn! { four_bar_14: crank 0.051, D(0.316, 0.0),
    lengths 0.27 0.139 left, P(0.195, -0.035),
    output [P] [BC DC] }

drawn! { four_bar_15: crank 0.07, D(0.444, 0.164),
    lengths 0.492 0.309 right, P(0.157, -0.038),
    output [C] [BC DC] }

drawn! { four_bar_16: crank 0.069, D(0.309, 0.0),
    lengths 0.2 0.279 right, P(0.131, -0.123),
    output [P] [BC DC] }

drawn! { four_bar_17: crank 0.15, D(0.45, 0.093),
    lengths 0.473 0.35 left, P(0.265, -0.103),
    output [P] [BC DC] }

drawn! { four_bar_18: crank 0.034, D(0.226, 0.0),
    lengths 0.364 0.225 left, P(0.23, 0.046),
    output [P] [BC] }

drawn! { four_bar_19: crank 0.07, D(0.183, 0.199),
    lengths 0.414 0.42 left, P(0.025, -0.132),
    output [P] [BC DC] }

drawn! { four_bar_20: crank 0.031, D(0.224, 0.0),
    lengths 0.137 0.168 right, P(0.078, 0.125),
    output [P] [DC] }

drawn! { six_bar_01: crank 0.039, D(0.218, 0.0),
    lengths 0.389 0.327 right, P(0.282, 0.121),
    Q(0.078, 0.068), F(0.462, 0.244), second P F lengths 0.493 0.476 left,
    output [C P E] [BC XE] }

drawn! { six_bar_02: crank 0.129, D(0.478, 0.0),
    lengths 0.296 0.361 right, P(0.041, 0.068),
    Q(0.214, 0.114), F(0.173, 0.097), second Q F lengths 0.48 0.381 right,
    output [C E] [BC DC XE YE] }

drawn! { six_bar_03: crank 0.096, D(0.245, 0.134),
    lengths 0.329 0.189 right, P(0.112, 0.016),
    Q(0.094, -0.054), F(0.319, -0.129), second P Q lengths 0.197 0.225 left,
    output [P E] [BC DC] }

drawn! { six_bar_04: crank 0.033, D(0.323, 0.142),
    lengths 0.188 0.445 left, P(0.077, -0.139),
    Q(0.142, -0.005), F(0.243, -0.184), second P F lengths 0.393 0.362 right,
    output [C E] [BC DC YE] }

drawn! { six_bar_05: crank 0.049, D(0.489, 0.125),
    lengths 0.295 0.321 right, P(0.064, 0.134),
    Q(0.225, 0.077), F(0.136, -0.249), second Q F lengths 0.223 0.357 right,
    output [C P E] [BC DC] }

drawn! { six_bar_06: crank 0.091, D(0.466, 0.0),
    lengths 0.421 0.337 left, P(0.049, 0.027),
    Q(0.216, 0.131), F(0.69, 0.055), second P Q lengths 0.183 0.194 right,
    output [C E] [YE] }

drawn! { six_bar_07: crank 0.033, D(0.332, 0.0),
    lengths 0.127 0.246 left, P(0.13, -0.038),
    Q(0.063, -0.093), F(0.368, 0.08), second P F lengths 0.358 0.254 right,
    output [P E] [XE] }

drawn! { six_bar_08: crank 0.074, D(0.226, 0.134),
    lengths 0.304 0.279 right, P(0.258, 0.07),
    Q(0.165, -0.017), F(0.549, 0.083), second Q F lengths 0.376 0.306 left,
    output [C E] [XE YE] }

drawn! { six_bar_09: crank 0.059, D(0.451, 0.199),
    lengths 0.18 0.494 right, P(0.255, 0.036),
    Q(0.162, -0.106), F(0.336, 0.148), second P Q lengths 0.401 0.202 left,
    output [C E] [BC XE YE] }

drawn! { six_bar_10: crank 0.083, D(0.443, 0.054),
    lengths 0.257 0.322 left, P(0.276, 0.046),
    Q(0.16, 0.08), F(0.374, 0.048), second P F lengths 0.398 0.133 left,
    output [C E] [DC XE] }

every! { bars:
    four_bar_01
    four_bar_02
    four_bar_03
    four_bar_04
    four_bar_05
    four_bar_06
    four_bar_07
    four_bar_08
    four_bar_09
    four_bar_10
    four_bar_11
    four_bar_12
    four_bar_13
    four_bar_14
    four_bar_15
    four_bar_16
    four_bar_17
    four_bar_18
    four_bar_19
    four_bar_20
    six_bar_01
    six_bar_02
    six_bar_03
    six_bar_04
    six_bar_05
    six_bar_06
    six_bar_07
    six_bar_08
    six_bar_09
    six_bar_10
}
