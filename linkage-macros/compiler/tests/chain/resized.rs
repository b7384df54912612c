//! Bars that are longer than they are drawn.

use super::*;

/// A plate on three bars one of which is to be a third longer than it is drawn: from the drawing on, the plate's other two
/// bars are a four-bar, which is walked until the plate's pin is as far as that, always on the side on which its dyad is
/// drawn. The pose with that length is this one: Newton's method alone goes to the other side of the dyad.
#[test]
fn a_longer_bar_leads_to_no_other_assembly() {
    let mut machine = triad();
    let places =
        [[-1.0, 0.0], [4.0, 0.0], [2.0, 5.0], [-0.8, 0.2], [3.2, 0.7], [3.0, 1.6], [3.9, 0.2]];
    machine.pins = places.map(|[x, y]| Complex::new(x, y)).into();
    let [_, d, e, b, p, q, r] = places.map(|[x, y]| Complex::new(x, y));
    let length = 1.3 * (p - b).length();
    let [first, coupler, last] = [(q - d), (r - q), (r - e)].map(Complex::length);
    let side = (r - q).cross(e - q).signum();
    // Q turns about D by the angle, R is the point of two circles on the side that is drawn, and P goes with both.
    let walked = |angle: f64| {
        let q_now = d + (q - d) * Complex::turned(angle);
        let base = e - q_now;
        let far = base.length();
        let x = (far * far + coupler * coupler - last * last) / (2.0 * far);
        let y = -side * (coupler * coupler - x * x).sqrt();
        let r_now = q_now + base.unit() * Complex::new(x, y);
        let turn = (r_now - q_now) * (r - q).conjugate();
        (q_now + turn.times(1.0 / (coupler * coupler)) * (p - q), q_now)
    };
    assert!(
        (walked(0.0).0 - p).length() < 1e-14
            && (first - (walked(0.3).1 - d).length()).abs() < 1e-14
    );
    // Steps of 1e-4, in which a pin three from D goes by less than 1e-2.
    let far = |step: i32| (walked(-1e-4 * f64::from(step)).0 - b).length();
    let steps = (0..10_000).find(|&step| far(step) >= length).expect("it is reached");
    assert!((1..steps).all(|step| far(step) > far(step - 1)), "the distance grows");
    let wanted = walked(-1e-4 * f64::from(steps)).0;
    let bar = Resized { body: 2, pins: [3, 4], length };
    let pose = redrawn(&machine, &[bar]).expect("it is reached");
    let off = (pose.machine.pins[4] - wanted).length();
    assert!(off < 1e-2, "off by {off}");
}
