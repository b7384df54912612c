//! A tipping lorry as it is sketched on paper: the poses of its solver beside those of triangles.

use super::machine::machine;

/// A cylinder turns an arm whose roller lifts the tray by its slot, and a strut opens the gate.
pub(crate) const LORRY: &str = "input s: length; ground O(0, 0), A(1.1m, -0.2m), F(1.75m, -0.4m), M(-0.5m, -0.1m); \
     pin G(1.3m, 0.1m), R(0.8m, 0.25m), T(2m, 0.3m), K(-0.1m, 0.5m), L(-0.45m, 0.35m); \
     guide slot on tray through O towards T; link tray(O, T, K), arm(A, G, R), roller(R) on slot; \
     link lift(F, G) { length: s } link gate(K, L), strut(M, L);";

const A: [f64; 2] = [1.1, -0.2];
const F: [f64; 2] = [1.75, -0.4];
const M: [f64; 2] = [-0.5, -0.1];

fn polar([x, y]: [f64; 2]) -> [f64; 2] {
    [x.hypot(y), y.atan2(x)]
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The place at a distance and an angle from another.
fn from([x, y]: [f64; 2], distance: f64, angle: f64) -> [f64; 2] {
    [x + distance * angle.cos(), y + distance * angle.sin()]
}

/// The angle of a triangle between sides of these lengths, opposite the third.
fn between(a: f64, b: f64, opposite: f64) -> f64 {
    ((a * a + b * b - opposite * opposite) / (2.0 * a * b)).acos()
}

/// The pins by triangles: G, R, T, K and L.
fn by_triangles(s: f64) -> [[f64; 2]; 5] {
    // The arm: A, F and G, with G to the left of the way from F to A as it is drawn.
    let [base, towards_f] = polar(minus(F, A));
    let [arm, drawn_g] = polar(minus([1.3, 0.1], A));
    let angle_g = towards_f + between(base, arm, s);
    let g = from(A, arm, angle_g);
    let [reach, drawn_r] = polar(minus([0.8, 0.25], A));
    let r = from(A, reach, drawn_r + angle_g - drawn_g);
    // The roller keeps its distance from the line of the slot, which goes through O.
    let [long, drawn_t] = polar([2.0, 0.3]);
    let beside = 0.25 * drawn_t.cos() - 0.8 * drawn_t.sin();
    let [away, seen] = polar(r);
    let tray = seen - (beside / away).asin();
    let turned = |place: [f64; 2]| {
        let [distance, angle] = polar(place);
        from([0.0, 0.0], distance, angle + tray - drawn_t)
    };
    let (t, k) = (from([0.0, 0.0], long, tray), turned([-0.1, 0.5]));
    // The gate: M, K and L, with L to the left of the way from M to K.
    let [gate, strut] = [[-0.1, 0.5], M].map(|end| polar(minus([-0.45, 0.35], end))[0]);
    let [far, towards_k] = polar(minus(k, M));
    let l = from(M, strut, towards_k + between(far, strut, gate));
    [g, r, t, k, l]
}

#[test]
fn a_lorry_tips_as_its_triangles_do() {
    let lorry =
        machine(&format!("pub struct M {{ {LORRY} }}")).unwrap_or_else(|told| panic!("{told:?}"));
    let drawn = lorry.drawn_inputs()[0];
    assert!((drawn - 0.45_f64.hypot(0.5)).abs() < 1e-15);
    let names = ["G", "R", "T", "K", "L"];
    let places = [[1.3, 0.1], [0.8, 0.25], [2.0, 0.3], [-0.1, 0.5], [-0.45, 0.35]];
    let mut tipped = Vec::new();
    for step in -5..=5 {
        let s = drawn + 0.02 * f64::from(step);
        let pins = lorry.pins::<f64>(&[s]);
        for ((name, wanted), drawn) in names.into_iter().zip(by_triangles(s)).zip(places) {
            let found = pins.iter().find(|(pin, _)| pin == name).expect("every pin is an output").1;
            let [off, moved] = [wanted, drawn].map(|other| polar(minus(found, other))[0]);
            // Some dozens of roundings of two metres, over sines of a tenth.
            assert!(off < 1e-13, "{name} is off by {off:e} m at {s}");
            assert!((moved < 1e-13) == (step == 0), "{name} moves by {moved:e} m at {s}");
        }
        tipped.push(polar(pins.iter().find(|(pin, _)| pin == "T").expect("a pin").1)[1]);
    }
    assert!(tipped.is_sorted() || tipped.iter().rev().is_sorted());
    assert!((tipped[0] - tipped[10]).abs() > 0.17, "{tipped:?}");
}
