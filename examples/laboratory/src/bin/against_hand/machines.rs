//! The machines with sliding joints and several inputs, written by hand: composed of the dyads of
//! `laboratory::hand`, with every dimension a constant.

use laboratory::hand::cylinder::cylinder;
use laboratory::hand::guides::{Guide, Turning, block, crank_block, crossed};
use laboratory::hand::rails::{Rail, Rod, Slide, yoke};
use laboratory::hand::{Bar, CrankDyad, Joint, Moving, Vector, cos_sin, crank_dyad, dyad};

/// An input with its rate and acceleration.
type Input = [f64; 3];

/// The possible outputs of a machine, by the names in its declaration.
macro_rules! moved {
    ($($name:ident { $($field:ident: $kind:ident),* })*) => {
        $(
            #[allow(non_snake_case, reason = "points and links have their names of the declaration")]
            #[allow(dead_code, reason = "not everything is asked for")]
            pub(crate) struct $name { $(pub(crate) $field: $kind),* }
        )*
    };
}

moved! {
    SliderCrank { C: Moving, P: Moving, BC: Bar, ram: Slide }
    Shaper { E: Moving, C: Moving, rod: Turning, EC: Bar, block: Slide, ram: Slide }
    Press { P: Moving, E: Moving, BC: Bar, DC: Bar, PE: Bar, ram: Slide }
    Crossed { C: Moving, shoe: Slide, ram: Slide }
    Yoke { B: Moving, block: Slide, ram: Slide }
    RockerGuide { C: Moving, E: Moving, BC: Bar, DC: Bar, FE: Bar, shoe: Slide }
    FiveBar { C: Moving, P: Moving, BC: Bar, EC: Bar }
    Arm { C: Moving, P: Moving, rod: Turning, block: Slide }
    Excavator { H: Moving, P: Moving, boom: Bar, stick: Bar }
}

#[inline(always)]
fn crank_pin(crank: f64, [cos, sin]: [f64; 2], [omega, alpha]: [f64; 2]) -> Moving {
    Moving::about([0.0; 2], Vector { x: crank * cos, y: crank * sin }, omega, alpha)
}

#[inline(always)]
pub(crate) fn slider_crank(
    [[angle, omega, alpha], _]: [Input; 2],
    crank: f64,
    rail: Rail,
    rod: Rod,
    p: [f64; 2],
) -> Option<SliderCrank> {
    let (turned, rates) = (cos_sin(angle), [omega, alpha]);
    let b = crank_pin(crank, turned, rates);
    let (bar, ram) = rod.on_rail(rail, rail.sees_crank(crank, turned, rates))?;
    Some(SliderCrank { C: rail.pin(rod.offset, ram), P: bar.point(b, p), BC: bar, ram })
}

#[inline(always)]
pub(crate) fn shaper(
    [[angle, omega, alpha], _]: [Input; 2],
    crank: f64,
    pivot: [f64; 2],
    sense: f64,
    e: [f64; 2],
    rail: Rail,
    link: Rod,
) -> Option<Shaper> {
    let (rod, block) = crank_block(crank, pivot, cos_sin(angle), [omega, alpha], sense)?;
    let e = rod.point_about(pivot, e);
    let (bar, ram) = link.on_rail(rail, rail.sees(e))?;
    Some(Shaper { E: e, C: rail.pin(link.offset, ram), rod, EC: bar, block, ram })
}

#[inline(always)]
pub(crate) fn press(
    [[angle, omega, alpha], _]: [Input; 2],
    form: CrankDyad,
    p: [f64; 2],
    rail: Rail,
    rod: Rod,
) -> Option<Press> {
    let (b, [first, rocker]) = crank_dyad(form, cos_sin(angle), [omega, alpha])?;
    let p = first.point(b, p);
    let (bar, ram) = rod.on_rail(rail, rail.sees(p))?;
    Some(Press { P: p, E: rail.pin(rod.offset, ram), BC: first, DC: rocker, PE: bar, ram })
}

#[inline(always)]
pub(crate) fn crossed_guides(
    [[angle, omega, alpha], _]: [Input; 2],
    crank: f64,
    guide: [f64; 2],
    rail: Rail,
    offsets: [f64; 2],
) -> Option<Crossed> {
    let turned = cos_sin(angle);
    let ([shoe, ram], pin) = crossed(crank, turned, [omega, alpha], guide, rail, offsets)?;
    Some(Crossed { C: pin, shoe, ram })
}

#[inline(always)]
pub(crate) fn scotch_yoke(
    [[angle, omega, alpha], _]: [Input; 2],
    crank: f64,
    rail: Rail,
    slot: [f64; 2],
    offsets: [f64; 2],
) -> Option<Yoke> {
    let (turned, rates) = (cos_sin(angle), [omega, alpha]);
    let [ram, block] = yoke(rail.sees_crank(crank, turned, rates), slot, offsets);
    // All is linear: what is no angle gives no number.
    let is_number = ram.value.is_finite();
    is_number.then(|| Yoke { B: crank_pin(crank, turned, rates), block, ram })
}

#[inline(always)]
pub(crate) fn rocker_guide(
    [[angle, omega, alpha], _]: [Input; 2],
    form: CrankDyad,
    q: [f64; 2],
    guide: [f64; 2],
    f: [f64; 2],
    rod: Rod,
) -> Option<RockerGuide> {
    let (_, [first, rocker]) = crank_dyad(form, cos_sin(angle), [omega, alpha])?;
    let pivot = form.dyad.pivot;
    let guide = Guide::on_bar(rocker, rocker.point_about(pivot, q), guide);
    let (bar, shoe) = guide.rod(Joint::Ground(f), rod)?;
    let (pin, end) = (rocker.end_about(pivot), bar.end_about(f));
    Some(RockerGuide { C: pin, E: end, BC: first, DC: rocker, FE: bar, shoe })
}

#[inline(always)]
pub(crate) fn five_bar(
    [[angle, omega, alpha], [other, omega2, alpha2]]: [Input; 2],
    cranks: [f64; 2],
    pivot: [f64; 2],
    lengths: [f64; 2],
    side: f64,
    p: [f64; 2],
) -> Option<FiveBar> {
    let b = crank_pin(cranks[0], cos_sin(angle), [omega, alpha]);
    let [cos, sin] = cos_sin(other);
    let arm = Vector { x: cranks[1] * cos, y: cranks[1] * sin };
    let e = Moving::about(pivot, arm, omega2, alpha2);
    let [first, second] = dyad(b, Joint::Link(e), lengths, side)?;
    Some(FiveBar { C: first.end(b), P: first.point(b, p), BC: first, EC: second })
}

#[inline(always)]
pub(crate) fn arm(
    [[angle, omega, alpha], [bend, omega2, alpha2]]: [Input; 2],
    links: [f64; 2],
    pivot: [f64; 2],
    offset: f64,
    sense: f64,
    p: [f64; 2],
) -> Option<Arm> {
    let b = crank_pin(links[0], cos_sin(angle), [omega, alpha]);
    let [cos, sin] = cos_sin(angle + bend);
    let r = Vector { x: links[1] * cos, y: links[1] * sin };
    let c = b.carrying(r, omega + omega2, alpha + alpha2);
    let (rod, block) = block(c, pivot, offset, sense)?;
    Some(Arm { C: c, P: rod.point_about(pivot, p), rod, block })
}

/// The bar of a frame that turns, of which the bar and its rates are given.
#[inline(always)]
fn turned(frame: Bar, bar: Bar) -> Bar {
    let u = frame.direction();
    let r = Vector { x: u.x * bar.r.x - u.y * bar.r.y, y: u.y * bar.r.x + u.x * bar.r.y };
    Bar { r, omega: frame.omega + bar.omega, alpha: frame.alpha + bar.alpha, ..bar }
}

/// Two cylinders: the boom's about the origin, whose base is in the ground, and the stick's, whose base is
/// on the boom like the stick's pivot.
#[inline(always)]
pub(crate) fn excavator(
    [lift, reach]: [Input; 2],
    base: [f64; 2],
    (boom, side): (f64, f64),
    joints: [[f64; 2]; 2],
    (stick, other): (f64, f64),
    p: [f64; 2],
) -> Option<Excavator> {
    let boom = cylinder([base, [0.0; 2]], lift, boom, side)?;
    let stick = cylinder(joints, reach, stick, other)?;
    let (stick, joint) = (turned(boom, stick), boom.point_about([0.0; 2], joints[1]));
    Some(Excavator { H: stick.end(joint), P: stick.point(joint, p), boom, stick })
}
