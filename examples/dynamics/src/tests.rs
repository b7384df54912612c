//! Runs beside what is known exactly.

use super::*;

/// sin t and cos t.
fn swinging(span: [f64; 2]) -> Motion<impl Fn(f64, [f64; 2]) -> Result<[f64; 2], SolveError>, 2> {
    Motion::new(span, [0.0, 1.0], |_, [x, v]: [f64; 2]| Ok([v, -x])).tolerance(1e-13)
}

#[test]
fn samples_are_as_exact_as_steps() {
    let run = swinging([0.0, 20.0]).sampled(777).unwrap();
    assert_eq!((run.times.len(), run.last().0), (778, 20.0));
    for (t, [x, v]) in run.iter() {
        assert!((x - t.sin()).abs() < 1e-12 && (v - t.cos()).abs() < 1e-12, "{t}: {x} {v}");
    }
    // They take no evaluations of the motion's own.
    assert_eq!(run.evaluations, swinging([0.0, 20.0]).ended().unwrap().evaluations);
}

#[test]
fn an_event_is_where_its_function_rises_through_zero() {
    // The sine, begun at 0.5 s, falls through zero after half a turn, and rises after a whole one.
    let run = swinging([0.5, 20.0]).until(0.1, |_, [x, _]| x).unwrap();
    let (time, [x, _]) = run.last();
    assert!(run.is_interrupted && x.abs() < 1e-14, "{x}");
    assert!((time - 0.5 - std::f64::consts::TAU).abs() < 1e-12, "{time}");
    assert!(run.times.windows(2).all(|pair| pair[0] < pair[1]), "{:?}", run.times);
    assert_eq!(run.times.len(), 64);
    // One that never comes leaves the whole span.
    let run = swinging([0.0, 2.0]).until(0.3, |_, [x, _]| x - 2.0).unwrap();
    assert!(!run.is_interrupted && run.last().0 == 2.0, "{:?}", run.times);
}

#[test]
fn the_first_refusal_ends_a_motion() {
    let error = SolveError::Singular { group: "here" };
    let rates = |_: f64, [x]: [f64; 1]| if x < 1.0 { Ok([1.0]) } else { Err(error) };
    let stopped = Motion::new([0.0, 3.0], [0.0], rates).ended();
    let Err(Stopped::Refused(time, SolveError::Singular { group: "here" })) = stopped else {
        panic!("{stopped:?}");
    };
    // In the step that goes there, which no step of this motion keeps from being long.
    assert!((1.0..=3.0).contains(&time), "{time}");
}

/// Order 4: half the step, a sixteenth of the error.
#[test]
fn symplectic_steps_are_of_order_four() {
    let error = |step: f64| {
        let (t, [x, v]) = swinging([0.0, 10.0]).symplectic(step).unwrap().last();
        (x - t.sin()).hypot(v - t.cos())
    };
    let ratio = error(0.02) / error(0.01);
    assert!((15.0..17.0).contains(&ratio), "{ratio}");
}
