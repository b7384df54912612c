//! The forms that textbooks print, as a program takes them from there: angles by arc cosine, arc
//! sine or the tangent of the half angle, directions by sine and cosine of rounded angles.
//!
//! Each answers with a position and an angular or sliding velocity of its group, for comparison.

use linkage_tests::measured::Pose;

/// The pin or a slide, and a velocity.
pub(super) type Answer = ([f64; 2], f64);

type Vector = [f64; 2];

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

fn unit(angle: f64) -> Vector {
    [angle.cos(), angle.sin()]
}

fn sign(plus: bool) -> f64 {
    if plus { 1.0 } else { -1.0 }
}

/// The pin and the first bar's angular velocity, from both bars' angles.
fn bars(pose: &Pose<4, 2>, theta2: f64, theta3: f64) -> Answer {
    let Pose { q, rate, params: [l2, _], .. } = *pose;
    let (u2, u3) = (unit(theta2), unit(theta3));
    let w = [rate[2] - rate[0], rate[3] - rate[1]];
    let omega = dot(w, u3) / (l2 * cross(u2, u3));
    ([q[0] + l2 * u2[0], q[1] + l2 * u2[1]], omega)
}

/// The law of cosines and an arc cosine at either outer joint.
pub(super) fn law_of_cosines(pose: &Pose<4, 2>) -> Answer {
    let Pose { q, params: [l2, l3], .. } = *pose;
    let (dx, dy) = (q[2] - q[0], q[3] - q[1]);
    let d = (dx * dx + dy * dy).sqrt();
    let (line, side) = (dy.atan2(dx), sign(pose.plus));
    let at_b = ((l2 * l2 + d * d - l3 * l3) / (2.0 * l2 * d)).acos();
    let at_d = ((l3 * l3 + d * d - l2 * l2) / (2.0 * l3 * d)).acos();
    bars(pose, line + side * at_b, line + core::f64::consts::PI - side * at_d)
}

/// A cos θ + B sin θ = C for either bar, solved for the tangent of the half angle.
pub(super) fn half_angles(pose: &Pose<4, 2>) -> Answer {
    let Pose { q, params: [l2, l3], .. } = *pose;
    let (dx, dy) = (q[2] - q[0], q[3] - q[1]);
    let side = sign(pose.plus);
    let square = dx * dx + dy * dy;
    let half_angle = |a: f64, b: f64, c: f64, side: f64| {
        2.0 * (b + side * (a * a + b * b - c * c).sqrt()).atan2(a + c)
    };
    let c2 = (square + l2 * l2 - l3 * l3) / (2.0 * l2);
    let c3 = -(square + l3 * l3 - l2 * l2) / (2.0 * l3);
    bars(pose, half_angle(dx, dy, c2, side), half_angle(dx, dy, c3, side))
}

/// The bar's angle against the guide by an arc sine.
pub(super) fn arc_sine_slider(pose: &Pose<5, 2>) -> Answer {
    let Pose { q, rate, params: [l, e], .. } = *pose;
    let (u, from) = (unit(q[4]), [q[0] - q[2], q[1] - q[3]]);
    let slope = ((e - cross(u, from)) / l).asin();
    let slope = if pose.plus { slope } else { core::f64::consts::PI - slope };
    let theta = q[4] + slope;
    let r = [l * theta.cos(), l * theta.sin()];
    let pin = [q[0] + r[0], q[1] + r[1]];
    // Velocity of the guide under the pin against B's, across the guide.
    let n = [-u[1], u[0]];
    let rho = minus(pin, [q[2], q[3]]);
    let w = [rate[2] - rate[4] * rho[1] - rate[0], rate[3] + rate[4] * rho[0] - rate[1]];
    (pin, dot(w, n) / (l * slope.cos()))
}

/// The bar's angle by an arc sine, the slide by Pythagoras.
pub(super) fn arc_sine_inversion(pose: &Pose<4, 1>) -> Answer {
    let Pose { q, rate, params: [e], .. } = *pose;
    let from = [q[0] - q[2], q[1] - q[3]];
    let b = dot(from, from).sqrt();
    let slide = sign(pose.plus) * (b * b - e * e).sqrt();
    let swing = (e / b).asin();
    let swing = if pose.plus { swing } else { core::f64::consts::PI - swing };
    let theta = from[1].atan2(from[0]) - swing;
    let v = [rate[0] - rate[2], rate[1] - rate[3]];
    let n = [-theta.sin(), theta.cos()];
    ([slide, 0.0], dot(v, n) / slide)
}

/// Cramer's rule on directions by sine and cosine of either angle.
pub(super) fn crossed_directions(pose: &Pose<6, 2>) -> Answer {
    let Pose { q, rate, params: [e1, e2], .. } = *pose;
    let (u1, u2) = (unit(q[2]), unit(q[5]));
    let (n1, n2) = ([-u1[1], u1[0]], [-u2[1], u2[0]]);
    let (k, j) = ([q[0] + e1 * n1[0], q[1] + e1 * n1[1]], [q[3] + e2 * n2[0], q[4] + e2 * n2[1]]);
    let sine = cross(u1, u2);
    let slides = |w: Vector| [cross(w, u2) / sine, cross(w, u1) / sine];
    let s = slides(minus(j, k));
    let carried = |v: Vector, omega: f64, s: f64, u: Vector, e: f64, n: Vector| {
        let rho = [s * u[0] + e * n[0], s * u[1] + e * n[1]];
        [v[0] - omega * rho[1], v[1] + omega * rho[0]]
    };
    let v1 = carried([rate[0], rate[1]], rate[2], s[0], u1, e1, n1);
    let v2 = carried([rate[3], rate[4]], rate[5], s[1], u2, e2, n2);
    ([s[0], 0.0], slides(minus(v2, v1))[0])
}

/// Two equations in x and y for the slides, on directions by sine and cosine of either angle.
pub(super) fn two_equations(pose: &Pose<5, 3>) -> Answer {
    let Pose { q, rate, params: [slot, e1, e2], .. } = *pose;
    let (u1, u2) = (unit(q[4]), unit(q[4] + slot));
    let (n1, n2) = ([-u1[1], u1[0]], [-u2[1], u2[0]]);
    let sine = cross(u1, u2);
    let slides = |w: Vector| [cross(w, u2) / sine, cross(u1, w) / sine];
    let h = |i: usize| q[i] - q[2 + i] - e1 * n1[i] - e2 * n2[i];
    let s = slides([h(0), h(1)]);
    let rho = |i: usize| s[0] * u1[i] + e1 * n1[i] + s[1] * u2[i] + e2 * n2[i];
    let w = [rate[0] - rate[2] + rate[4] * rho(1), rate[1] - rate[3] - rate[4] * rho(0)];
    ([s[0], 0.0], slides(w)[0])
}
