//! Points that are declared on links, as joints: the machine is that with the pin where the point is.

use super::machine::machine;

/// A drawing with `R` on its plate by a statement, and the same with a pin there; the documentation of the first.
fn move_alike(declared: &str, point: &str, drawn: &str) -> String {
    let text = |statements: &str| format!("pub struct M {{ {statements} }}");
    let [a, b] = [format!("{declared}\n{point}"), drawn.to_string()]
        .map(|statements| machine(&text(&statements)).unwrap_or_else(|told| panic!("{told:?}")));
    let [inputs, same] = [&a, &b].map(|machine| machine.drawn_inputs());
    assert!((inputs[0] - same[0]).abs() < 1e-15, "{inputs:?} {same:?}");
    for step in -5..=5 {
        let inputs = [inputs[0] + 0.01 * f64::from(step)];
        let [pins, same] = [&a, &b].map(|machine| machine.pins::<f64>(&inputs));
        for (name, at) in &same {
            let of_name = |pin: &&(String, _)| pin.0 == *name;
            let (_, found) = pins.iter().find(of_name).expect("both have the pin");
            // Both solve one equation, whose root is known to a few units in the last place.
            let off = (found[0] - at[0]).hypot(found[1] - at[1]);
            assert!(off < 1e-13, "{name} at {step} is off by {off:e}");
        }
    }
    a.docs()
}

const TRIAD: &str = "input t: angle; ground A(-1, 0), D(4, 0), E(2, 5);
                     link AB(A, B), BP(B, P), DQ(D, Q), ER(E, R);";

/// The same if the search reaches the plate from another pin or from the point itself.
#[test]
fn a_search_reaches_a_plate_from_any_of_its_pins() {
    for (b, is_reached_from_it) in [("B(-0.5, 0.6)", false), ("B(-1.2, 0.7)", true)] {
        let pins = format!("pin {b}, P(0.8, 1.2), Q(3, 1.2)");
        let declared = format!("{TRIAD} {pins}; link plate(P, Q); drive AB.angle = t;");
        let drawn =
            format!("{TRIAD} {pins}, R(1.9, 3.1); link plate(P, Q, R); drive AB.angle = t;");
        let point = "point R on plate at (1.1, 1.9);";
        let docs = move_alike(&declared, point, &drawn);
        assert_eq!(docs.contains("-> R"), is_reached_from_it, "{docs}");
        if !is_reached_from_it {
            // 1.1² + 1.9², to each side.
            let point = "point R on plate at distances (sqrt(4.82)*1m, sqrt(4.82)*1m) left;";
            move_alike(&declared, point, &drawn);
        }
    }
}

/// The plate hangs on its point, which a crank makes.
#[test]
fn a_dyad_stands_on_a_point_of_its_own_link() {
    let machine = "input t: angle; ground D(4, 0), E(2, 5); pin P(0, 1), Q(2, 1)";
    let links = "link DQ(D, Q), ER(E, R); drive ER.angle = t;";
    for point in ["at (1.1, 1.9)", "at polar (hypot(1.1, 1.9), atan2(1.9, 1.1))"] {
        move_alike(
            &format!("{machine}; {links} link plate(P, Q);"),
            &format!("point R on plate {point};"),
            &format!("{machine}, R(1.1, 2.9); {links} link plate(P, Q, R);"),
        );
    }
}

/// The point is the inner joint of its link's dyad.
#[test]
fn a_dyad_makes_a_point_of_its_own_link() {
    let machine = "input t: angle; ground A(0, 0), D(4, 0); pin B(0, 1), X(2, 1)";
    let links = "link AB(A, B), DR(D, R); drive AB.angle = t;";
    move_alike(
        &format!("{machine}; {links} link BX(B, X);"),
        "point R on BX at (2.7, 0.8);",
        &format!("{machine}, R(2.7, 1.8); {links} link BX(B, X, R);"),
    );
}

/// The declared length is that of a tip which nothing stands on: the plate hangs on its first pin and on its point.
#[test]
fn a_length_reaches_a_tip_from_where_its_link_is_placed() {
    let machine = "input t: angle; ground D(4, 0), E(2, 5); pin P(0, 1), T(2, 1), S(0.4, -0.6)";
    let links = "link DP(D, P), ER(E, R); drive ER.angle = t;";
    move_alike(
        &format!(
            "{machine}; {links} link plate(P, T) {{ length: 2 }} point S on plate at (0.4, -1.6);"
        )
        .replace(", S(0.4, -0.6)", ""),
        "point R on plate at (1.1, 1.9);",
        &format!("{machine}, R(1.1, 2.9); {links} link plate(P, T, R, S);"),
    );
    // Longer than drawn, which moves the tip alone.
    move_alike(
        &format!("{machine}; {links} link plate(P, T) {{ length: 2.5 }}")
            .replace(", S(0.4, -0.6)", ""),
        "point R on plate at (1.1, 1.9);",
        &format!("{machine}, R(1.1, 2.9); {links} link plate(P, T, R);")
            .replace("T(2, 1), S(0.4, -0.6)", "T(2.5, 1)"),
    );
}

#[test]
fn a_place_that_needs_the_link_first_is_refused() {
    let statements = |link: &str, place: &str| {
        format!(
            "pub struct M {{ input t: angle; ground D(4, 0), E(2, 5); pin P(0, 1), Q(2, 1); {link}
             link DQ(D, Q), ER(E, R); drive ER.angle = t; point R on plate {place}; }}"
        )
    };
    for (link, place, instead) in [
        (
            "link plate(P, Q);",
            "at distances (2.2, 2.1) left",
            "write `point R on plate at (x, y);`",
        ),
        (
            "link plate(P, Q) { length: 2 }",
            "at (1.1, 1.9)",
            "draw it, `pin R(x, y);`, and name it in `link plate`",
        ),
    ] {
        let told = machine(&statements(link, place)).err().expect("nothing is placed");
        let wanted = format!("`plate` is placed from `R`; {instead}");
        assert!(told.len() == 1 && told[0].starts_with(&wanted), "{told:?}");
    }
}
