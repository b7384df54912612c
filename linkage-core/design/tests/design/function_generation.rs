//! Function generators: known optima, their prices, and the same bits by one thread and by two.

use std::f64::consts::{FRAC_PI_2, PI};

use linkage_core::mechanism;
use linkage_design::{Design, DesignError, Dual, free};

mechanism! {
    /// A crank-rocker with a crank of 1 and a ground of 5; turned from the rocker's limit.
    struct Generator {
        input turn: angle;
        param coupler = 4m;
        param rocker = 2.5m;
        /// The greatest transmission angle that is allowed.
        param most = 135deg;
        let reach = 1m + coupler;
        let squares = reach * reach - rocker * rocker;
        let crank_at_limit = acos((squares + 5m * 5m) / (10m * reach));
        let rocker_at_limit = acos((squares - 5m * 5m) / (10m * rocker));
        ground A(0, 0), D(5m, 0), N(1m, 0), F(-1m, 0);
        crank AB(A) -> B        { length: 1m, angle: crank_at_limit + turn }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
        crank pointer(D)        { angle: rocker_at_limit + 2 * turn * turn / (3 * pi) }
        // The same pins with the crank along the ground, where the transmission angle is extreme.
        rrr   nB(N), nD(D) -> nC { lengths: (coupler, rocker), mode: left }
        rrr   fB(F), fD(D) -> fC { lengths: (coupler, rocker), mode: left }
        crank limit(D)           { angle: most }
        output error = DC.angle - pointer.angle, least = nD.angle - nB.angle,
            greatest = fD.angle - fB.angle - limit.angle;
    }
}

mechanism! {
    /// The same with all lengths but the ground, the start and the rocker's zero free.
    struct Freer {
        input turn: angle;
        param crank = 1m;
        param coupler = 4m;
        param rocker = 2.5m;
        param start = 60deg;
        param zero = 120deg;
        ground A(0, 0), D(5m, 0);
        crank AB(A) -> B        { length: crank, angle: start + turn }
        rrr   BC(B), DC(D) -> C { lengths: (coupler, rocker), mode: left }
        crank pointer(D)        { angle: zero + 2 * turn * turn / (3 * pi) }
        output error = DC.angle - pointer.angle;
    }
}

fn steps(from: i32) -> impl Iterator<Item = f64> {
    (from..=30).map(|step| FRAC_PI_2 * f64::from(step) / 30.0)
}

/// The optimum to 50 digits, rounded (`examples/function_generator`).
const COUPLER: f64 = 4.128_654_158_009_783;
const ROCKER: f64 = 2.322_461_712_412_169_4;
const SQUARES: f64 = 0.007_592_373_605_334_677;

/// The design of the two lengths, with the greatest transmission angle in degrees.
macro_rules! two_lengths {
    ($most:expr) => {
        free!(Generator: coupler, rocker; of Generator { most: f64::to_radians($most), ..Generator::new() })
            .within([2.0..=8.0, 1.0..=6.0])
            .aim("parabola", steps(1), |machine, turn| {
                Ok([machine.position(turn.into())?.error.angle()])
            })
            .keep("transmission", [0.0], |machine, turn| {
                let at = machine.position(turn.into())?;
                Ok([at.least.angle() - FRAC_PI_2 / 2.0, -at.greatest.angle()])
            })
    };
}

#[test]
fn two_lengths_are_found_from_every_start() {
    for seed in [1, 2] {
        let found = two_lengths!(135.0).starts(50).seed(seed).run().unwrap();
        println!("{found}");
        assert!((found.values[0] / COUPLER - 1.0).abs() < 1e-9, "{found}");
        assert!((found.values[1] / ROCKER - 1.0).abs() < 1e-9, "{found}");
        assert!((found.cost / SQUARES - 1.0).abs() < 1e-9, "{found}");
        assert!(found.kuhn_tucker < 1e-6, "{}", found.kuhn_tucker);
        let ends = found.counts;
        assert_eq!((ends.starts, ends.here + ends.refused), (50, 50), "{ends:?}");
        assert_eq!((found.prices.len(), found.others.len()), (1, 0));
    }
}

/// The price is the derivative of the optimum by the limit. A central difference over ± 0.1° errs by a third
/// derivative times h²/6, some 10⁻⁶ of it.
#[test]
fn a_price_is_what_a_degree_more_is_worth() {
    let [least, at, most] =
        [134.9, 135.0, 135.1].map(|most| two_lengths!(most).starts(4).run().unwrap());
    let difference = (least.cost - most.cost) / f64::to_radians(0.2);
    let price = at.prices[0].price;
    assert!((price / difference - 1.0).abs() < 1e-4, "{price} {difference}");
    // 0.00015 a degree.
    assert!((price.to_radians() - 0.00015).abs() < 0.000_005, "{price}");
}

#[test]
fn the_bits_do_not_depend_on_threads() {
    let [one, two, three] =
        [1, 2, 3].map(|threads| two_lengths!(135.0).starts(6).threads(threads).run().unwrap());
    for other in [two, three] {
        assert_eq!(one.values.map(f64::to_bits), other.values.map(f64::to_bits));
        assert_eq!(one.cost.to_bits(), other.cost.to_bits());
        assert_eq!((one.counts, &one.others), (other.counts, &other.others));
    }
}

/// Reserves of the transmission angle's cosine at both extremes, by the law of cosines.
fn within_45_degrees<const N: usize>(m: &Freer<Dual<N>>) -> [Dual<N>; 4] {
    let [near, far] = [-m.crank + 5.0, m.crank + 5.0].map(|diagonal| {
        (m.coupler * m.coupler + m.rocker * m.rocker - diagonal * diagonal)
            / (m.coupler * m.rocker * 2.0)
    });
    let limit = FRAC_PI_2 / 2.0;
    [-near + limit.cos(), near + limit.cos(), -far + limit.cos(), far + limit.cos()]
}

#[test]
fn five_free_numbers_are_worth_six_times_as_much() {
    let found = free!(Freer: crank, coupler, rocker, start, zero)
        .within([0.5..=2.0, 2.0..=10.0, 1.0..=10.0, -PI..=PI, -PI..=PI])
        .aim("parabola", steps(0), |machine, turn| {
            Ok([machine.position(turn.into())?.error.angle()])
        })
        .keep("transmission", [()], |machine, ()| Ok(within_45_degrees(machine)))
        .draws(if cfg!(debug_assertions) { 1000 } else { 20000 })
        .starts(20)
        .run()
        .unwrap();
    println!("{found}");
    assert!((found.cost - 0.001_171_61).abs() < 5e-9, "{}", found.cost);
    assert!(found.kuhn_tucker < 1e-6, "{}", found.kuhn_tucker);
    let lines = found.to_string();
    // The search stops in the ninth digit, elsewhere in each build.
    assert!(lines.starts_with("param crank = 0.54328247") && lines.contains("m; // ± "), "{lines}");
    assert!(lines.contains("param start = 0.0452218"), "{lines}");
    assert!(
        found.prices.iter().any(|price| price.at.starts_with("transmission") && price.price > 0.0)
    );
}

#[test]
fn each_fault_has_its_error() {
    let none = free!(Generator: coupler, rocker).run().unwrap_err();
    assert_eq!(none, DesignError::NoAim);
    let aim = || free!(Generator: coupler, rocker).within([2.0..=8.0, 1.0..=6.0]);
    let unknown = Design::of(Generator::new(), ["coupler", "lever"]).run().unwrap_err();
    let known = ["coupler", "rocker", "most"].map(String::from).to_vec();
    assert_eq!(unknown, DesignError::Unknown { name: "lever".to_string(), known });
    let empty = aim().within([3.0..=3.0, 1.0..=6.0]).run().unwrap_err();
    assert_eq!(empty, DesignError::Range { parameter: "coupler", from: 3.0, to: 3.0 });

    // Lengths of 1 and 2 do not close a ground of 5.
    let short = aim()
        .within([1.0..=2.0, 1.0..=1.5])
        .aim("parabola", steps(1), |m, turn| Ok([m.position(turn.into())?.error.angle()]))
        .starts(5)
        .run()
        .unwrap_err();
    println!("{short}");
    assert!(matches!(&short, DesignError::Unassembled { of, .. } if of == "parabola"), "{short:?}");

    let nan = aim()
        .aim("parabola", steps(1), |m, turn| {
            let error = m.position(turn.into())?.error.angle();
            Ok([if turn > 1.0 { error * f64::NAN } else { error }])
        })
        .starts(5)
        .run()
        .unwrap_err();
    println!("{nan}");
    // The first step beyond 1 rad is the twentieth.
    let at = format!("{:?}", FRAC_PI_2 * 20.0 / 30.0);
    assert_eq!(nan, DesignError::NotANumber { of: "parabola".into(), at });

    let infeasible = two_lengths!(135.0)
        .keep("no machine", [0.0], |m, _| Ok([-m.coupler + 1.0]))
        .starts(3)
        .run()
        .unwrap_err();
    println!("{infeasible}");
    let DesignError::Infeasible { violated } = infeasible else { panic!("{infeasible}") };
    assert!(violated.iter().any(|(name, by)| name.starts_with("no machine") && *by >= 1.0));
}

/// The aim looks at the ratio of two lengths alone.
#[test]
fn an_undetermined_pair_is_named() {
    let found = free!(Freer: coupler, rocker, zero)
        .within([1.0..=8.0, 1.0..=6.0, 0.5..=3.0])
        .aim("ratio", [0.0, 1.0], |m, _| Ok([m.coupler / m.rocker - 1.5, m.zero - 1.0]))
        .run()
        .unwrap();
    assert_eq!(found.undetermined, ["coupler", "rocker"]);
    let refused = found.deviations().unwrap_err();
    assert_eq!(refused, DesignError::Undetermined { parameters: vec!["coupler", "rocker"] });
}
