//! What a user's own struct may do with what is generated.

use linkage_core::mechanism;

mechanism! {
    struct Press {
        input theta: angle;
        param rod = 3m;
        ground A(0, 0);
        guide rail through A along 0deg;
        crank AB(A) -> B          { length: 1m, angle: theta }
        rrp BC(B), ram(rail) -> C { length: rod, mode: ahead }
        output ram.slide, C;
    }
}

/// Solvers and records have what is derived, on the same terms: a generic struct that holds them needs no
/// bound of its own.
#[test]
fn generic_structs_hold_solvers_and_records_and_derive_the_same() {
    #[derive(Clone, Copy, Debug, PartialEq)]
    struct State<T> {
        press: Press<T>,
        last: PressMotion<T>,
    }
    let press = Press::new();
    let state = State { press, last: press.motion(0.0, 1.0, 0.0).unwrap() };
    let copies = [state; 2];
    assert_eq!(copies.to_vec()[1], state);
    assert_eq!(
        format!("{:?}", state.last.position),
        "PressPosition { ram: Slide { slide: 4.0 }, C: Point { x: 4.0, y: 0.0 } }"
    );
}
