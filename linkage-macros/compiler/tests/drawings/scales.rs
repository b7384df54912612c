//! One machine from a billionth of a metre to a million metres: slides on slides, whose numbers have the digits of all
//! that they stand on.

use super::machine::machine;

/// Coordinates of the machine, of about one.
const COORDINATES: [(&str, [f64; 2]); 9] = [
    ("P3", [0.4829, 0.4844]),
    ("P7", [-0.1766, 0.3312]),
    ("P14", [-0.4277, 0.317]),
    ("P4", [0.3952, 0.2736]),
    ("P10", [0.895492697486051, 0.5597855773217777]),
    ("P17", [0.1173, 0.2582]),
    ("P18", [-0.5082, 0.1538]),
    ("Q13", [0.0664, -0.3816]),
    ("Q15", [0.03991, 0.2762]),
];

fn scaled(scale: f64) -> String {
    let at = |x: f64, y: f64| format!("({:?}m, {:?}m)", x * scale, y * scale);
    let place = |name: &str| {
        let (_, [x, y]) =
            COORDINATES.iter().find(|(known, _)| *known == name).expect("it is there");
        at(*x, *y)
    };
    let named = |name: &str| format!("{name}{}", place(name));
    format!(
        "pub struct M {{ input t: angle; ground {}, {}, {}; pin {}, {}, {}, {};
         link L5(P3, P4); guide g8 on L5 through {} along 147.21deg; link Y9(P10) on g8;
         guide g11 on Y9 through {} along 117.30563853421519deg; link S12(P7) on g11;
         point Q13 on S12 at {}; point Q15 on S12 at {}; link T19(P17, P18);
         guide g20 on T19 through {} along 82.67deg; link S21(Q13) on g20; link L22(P14, P17);
         guide g23 on L5 through {} along -118.02deg; link S24(P18) on g23; drive T19.angle - L22.angle = t; }}",
        named("P3"),
        named("P7"),
        named("P14"),
        named("P4"),
        named("P10"),
        named("P17"),
        named("P18"),
        at(-0.1283, 0.2877),
        at(-1.0579931491749222, 0.45752431563114613),
        place("Q13"),
        place("Q15"),
        at(0.06301778108776555, -0.5526868147374421),
        at(0.6225497751167369, -0.795408017253588),
    )
}

/// Points stand where they are drawn, and slides are those of the machine of size one.
#[test]
fn a_machine_compiles_at_every_scale() {
    let mut before: Option<Vec<f64>> = None;
    for scale in [1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6] {
        let machine = machine(&scaled(scale)).unwrap_or_else(|told| panic!("{scale:e}: {told:?}"));
        let drawn = machine.drawn_inputs()[0];
        let position = machine.answers("position", &[[drawn, 0.0, 0.0]]);
        for pin in ["P4", "P10", "P17", "P18"] {
            let (_, [x, y]) = COORDINATES.iter().find(|(known, _)| *known == pin).expect("a pin");
            for (part, wanted) in [("x", x), ("y", y)] {
                let found = position.named(&format!("{pin}.{part}")) / scale;
                // The drawn input is a float, and dyads stand on each other.
                assert!((found - wanted).abs() < 1e-11, "{scale:e}: {pin}.{part} is {found}");
            }
        }
        let slides = ["Y9", "S12", "S21", "S24"];
        let slides = slides.map(|link| position.named(&format!("{link}.slide")) / scale).to_vec();
        if let Some(before) = before.replace(slides.clone()) {
            for (one, other) in before.iter().zip(&slides) {
                assert!((one - other).abs() < 1e-11, "{scale:e}: {one} and {other}");
            }
        }
    }
}
