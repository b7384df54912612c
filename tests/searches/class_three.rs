//! Machines of class III from links and joints over the whole of their motion.
//!
//! Nine eight-bars in random drawings. Their poses were found by Newton's method on all bodies at once,
//! which knows no groups, no modes and no interval. In the text a line of a machine holds the pins of its
//! ground, the names of the others, or a pose: the angle of the driven link, and where the pins are.

use std::collections::HashMap;

use linkage_core::{Mechanism, SolveError};

linkage_core::mechanism! {
    /// With masses, for the forces; its motion is that of the drawing.
    pub struct EightBar1 {
        input theta: angle;
        ground p01(0.789, 0.304), p17(0.603, 0.18);
        pin p05(0.326, 0.572), p25(0.655, 0.835), p27(0.324, 0.929), p36(0.81, 0.838), p37(0.554, 0.589), p46(0.015, 0.486), p47(0.999, 0.972), p56(0.052, 0.978);
        link l0(p01, p05), l2(p25, p27), l3(p36, p37), l4(p46, p47), l5(p05, p25, p56), l6(p36, p46, p56), l7(p17, p27, p37, p47);
        drive l7.angle = theta;
        gravity (0.7, -9.81);
        mass 1.0 on l0 at (0.05, -0.04) inertia 0.02; mass 1.6 on l2 at (0.15, -0.04) inertia 0.02;
        mass 1.9 on l3 at (0.2, -0.04) inertia 0.02; mass 2.2 on l4 at (0.25, -0.04) inertia 0.02;
        mass 2.5 on l5 at (0.3, -0.04) inertia 0.02; mass 2.8 on l6 at (0.35, -0.04) inertia 0.02;
        mass 3.1 on l7 at (0.4, -0.04) inertia 0.02;
        point T on l5 at (0.2, 0.1); force (20, -15) on T; torque 5 on l4;
    }
}

linkage_core::mechanism! {
    /// With masses, for the forces.
    pub struct EightBar2 {
        input theta: angle;
        ground p37(0.06, 0.401), p47(0.205, 0.007), p57(0.209, 0.442);
        pin p01(0.843, 0.998), p04(0.892, 0.017), p15(0.706, 0.48), p24(0.111, 0.157), p26(0.406, 0.53), p36(0.907, 0.456), p56(0.928, 0.185);
        link l0(p01, p04), l1(p01, p15), l2(p24, p26), l3(p36, p37), l4(p47, p04, p24), l5(p15, p56, p57), l6(p26, p36, p56);
        drive l4.angle = theta;
        gravity (0.7, -9.81);
        mass 1.0 on l0 at (0.05, -0.04) inertia 0.02; mass 1.3 on l1 at (0.1, -0.04) inertia 0.02;
        mass 1.6 on l2 at (0.15, -0.04) inertia 0.02; mass 1.9 on l3 at (0.2, -0.04) inertia 0.02;
        mass 2.2 on l4 at (0.25, -0.04) inertia 0.02; mass 2.5 on l5 at (0.3, -0.04) inertia 0.02;
        mass 2.8 on l6 at (0.35, -0.04) inertia 0.02;
        point T on l5 at (0.2, 0.1); force (20, -15) on T; torque 5 on l0;
    }
}

linkage_core::mechanism! {
    pub struct EightBar3 {
        input theta: angle;
        ground p01(0.98, 0.863), p05(0.416, 0.891);
        pin p17(0.188, 0.711), p23(0.051, 0.249), p26(0.834, 0.473), p37(0.865, 0.161), p45(0.946, 0.319), p47(0.704, 0.339), p56(0.014, 0.511), p67(0.421, 0.504);
        link l1(p01, p17), l2(p23, p26), l3(p23, p37), l4(p45, p47), l5(p05, p45, p56), l6(p26, p56, p67), l7(p17, p37, p47, p67);
        drive l5.angle = theta;
    }
}

linkage_core::mechanism! {
    pub struct EightBar4 {
        input theta: angle;
        ground p01(0.469, 0.567), p04(0.358, 0.3);
        pin p15(0.737, 0.451), p24(0.549, 0.853), p26(0.722, 0.258), p36(0.209, 0.752), p37(0.508, 0.409), p47(0.229, 0.066), p56(0.397, 0.125), p57(0.595, 0.698);
        link l1(p01, p15), l2(p24, p26), l3(p36, p37), l4(p04, p24, p47), l5(p15, p56, p57), l6(p26, p36, p56), l7(p37, p47, p57);
        drive l1.angle = theta;
    }
}

linkage_core::mechanism! {
    pub struct EightBar8 {
        input theta: angle;
        ground p24(0.045, 0.196), p26(0.854, 0.078);
        pin p01(0.205, 0.868), p04(0.486, 0.267), p15(0.304, 0.171), p36(0.951, 0.263), p37(0.993, 0.813), p47(0.724, 0.162), p56(0.616, 0.378), p57(0.513, 0.996);
        link l0(p01, p04), l1(p01, p15), l3(p36, p37), l4(p24, p04, p47), l5(p15, p56, p57), l6(p26, p36, p56), l7(p37, p47, p57);
        drive l4.angle = theta;
    }
}

linkage_core::mechanism! {
    pub struct EightBar10 {
        input theta: angle;
        ground p24(0.364, 0.706), p27(0.283, 0.115);
        pin p04(0.031, 0.728), p05(0.845, 0.896), p14(0.841, 0.003), p16(0.626, 0.068), p35(0.527, 0.872), p36(0.774, 0.396), p57(0.168, 0.916), p67(0.888, 0.611);
        link l0(p04, p05), l1(p14, p16), l3(p35, p36), l4(p24, p04, p14), l5(p05, p35, p57), l6(p16, p36, p67), l7(p27, p57, p67);
        drive l4.angle = theta;
    }
}

linkage_core::mechanism! {
    pub struct EightBar11 {
        input theta: angle;
        ground p05(0.484, 0.332), p15(0.469, 0.086), p25(0.967, 0.044);
        pin p06(0.158, 0.181), p17(0.11, 0.998), p27(0.32, 0.945), p36(0.928, 0.517), p37(0.554, 0.976), p46(0.612, 0.155), p47(0.067, 0.031);
        link l0(p05, p06), l1(p15, p17), l2(p25, p27), l3(p36, p37), l4(p46, p47), l6(p06, p36, p46), l7(p17, p27, p37, p47);
        drive l1.angle = theta;
    }
}

linkage_core::mechanism! {
    pub struct EightBar14 {
        input theta: angle;
        ground p26(0.787, 0.419), p36(0.246, 0.821), p46(0.963, 0.453);
        pin p01(0.165, 0.408), p04(0.84, 0.617), p15(0.86, 0.021), p27(0.584, 0.891), p37(0.272, 0.152), p45(0.92, 0.888), p57(0.471, 0.727);
        link l0(p01, p04), l1(p01, p15), l2(p26, p27), l3(p36, p37), l4(p46, p04, p45), l5(p15, p45, p57), l7(p27, p37, p57);
        drive l4.angle = theta;
    }
}

linkage_core::mechanism! {
    pub struct EightBar17 {
        input theta: angle;
        ground p01(0.007, 0.673), p04(0.566, 0.898);
        pin p15(0.807, 0.102), p23(0.033, 0.366), p26(0.933, 0.964), p37(0.475, 0.286), p46(0.807, 0.504), p47(0.297, 0.587), p56(0.677, 0.685), p57(0.637, 0.148);
        link l1(p01, p15), l2(p23, p26), l3(p23, p37), l4(p04, p46, p47), l5(p15, p56, p57), l6(p26, p46, p56), l7(p37, p47, p57);
        drive l4.angle = theta;
    }
}

linkage_core::mechanism! {
    /// Its crank turns fully, and beside 75° from the drawing two ways to assemble it come close to each other.
    pub struct StephensonTwo {
        input theta: angle;
        ground J0(-45mm, -15.5mm), J5(85.25mm, -27.25mm);
        pin J1(-52mm, 25.5mm), J2(-36mm, 76.25mm), J3(-4mm, 3mm), J4(29mm, 27.5mm), J6(57.5mm, 77mm);
        link L1(J0, J1), L2(J1, J2, J3), L5(J2, J6), L4(J3, J4), L3(J4, J5, J6);
        drive L1.angle = theta;
    }
}

/// A width of floats.
trait Width: Copy + Into<f64> {
    fn narrowed(value: f64) -> Self;
}

impl Width for f64 {
    fn narrowed(value: f64) -> Self {
        value
    }
}

impl Width for f32 {
    fn narrowed(value: f64) -> Self {
        value as f32
    }
}

/// A value with its velocity and acceleration, along both axes.
type Point = [[f64; 2]; 3];

/// The poses of a machine with what its links are.
struct Reference {
    name: &'static str,
    ground: HashMap<&'static str, [f64; 2]>,
    pins: Vec<&'static str>,
    /// The angle of the driven link, and the places of the pins.
    poses: Vec<(f64, Vec<[f64; 2]>)>,
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

impl Reference {
    fn of(name: &'static str) -> Self {
        let (mut ground, mut pins, mut poses) = (HashMap::new(), Vec::new(), Vec::new());
        for line in include_str!("class_three.txt").lines() {
            let words: Vec<_> = line.split(' ').collect();
            match &words[..] {
                [own, ..] if *own != name => {}
                [_, "ground", rest @ ..] => {
                    let pin = |pin: &[&'static str]| (pin[0], [number(pin[1]), number(pin[2])]);
                    ground = rest.chunks_exact(3).map(pin).collect();
                }
                [_, "pins", rest @ ..] => pins = rest.to_vec(),
                [_, at, rest @ ..] => {
                    let places = rest.chunks_exact(2).map(|at| [number(at[0]), number(at[1])]);
                    poses.push((number(at), places.collect()));
                }
                [] | [_] => {}
            }
        }
        assert!(!poses.is_empty() && !ground.is_empty());
        Self { name, ground, pins, poses }
    }

    /// The pins with their rates at a unit rate of the input.
    fn moving<T, M>(&self, machine: &M, at: f64) -> Result<HashMap<&'static str, Point>, SolveError>
    where
        T: Width,
        M: Mechanism<Scalar = T, Inputs = [T; 1]>,
    {
        let [at, one, zero] = [at, 1.0, 0.0].map(T::narrowed);
        let orders = machine.motion([at], [one], [zero])?;
        let row = |pin: &str, axis: &str| {
            let name = format!("{pin}.{axis}");
            M::OUTPUTS.iter().position(|output| *output == name).expect("every pin is an output")
        };
        let point = |pin: &str| {
            let rows = [row(pin, "x"), row(pin, "y")];
            orders.each_ref().map(|order| rows.map(|row| order.as_ref()[row].into()))
        };
        let mut moving: HashMap<_, _> = self.pins.iter().map(|&pin| (pin, point(pin))).collect();
        let at_rest = self.ground.iter().map(|(&pin, &at)| (pin, [at, [0.0; 2], [0.0; 2]]));
        moving.extend(at_rest);
        Ok(moving)
    }

    /// The poses that were solved. Their places are off by `off` at most, and their rates keep the
    /// distances in each link.
    fn solved<T, M>(&self, machine: &M, off: f64) -> usize
    where
        T: Width,
        M: Mechanism<Scalar = T, Inputs = [T; 1]>,
    {
        let mut solved = 0;
        for (at, places) in &self.poses {
            let moving = match self.moving(machine, *at) {
                Ok(moving) => moving,
                Err(error) => {
                    println!("{} at {at}: {error}", self.name);
                    continue;
                }
            };
            for (pin, place) in self.pins.iter().zip(places) {
                for axis in 0..2 {
                    let off_by = (moving[pin][0][axis] - place[axis]).abs();
                    assert!(off_by <= off, "{} at {at}: {pin} is off by {off_by:e}", self.name);
                }
            }
            self.rates_are_rigid(&moving, off);
            solved += 1;
        }
        solved
    }

    /// Two pins with a digit in common are of one link d = p - q: d·ḋ = 0 and ḋ² + d·d̈ = 0. These
    /// equations of all links and the driven angle have one solution.
    fn rates_are_rigid(&self, moving: &HashMap<&str, Point>, off: f64) {
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let share = |a: &str, b: &str| a[1..].chars().any(|digit| b[1..].contains(digit));
        for (a, [pa, va, ca]) in moving {
            for (b, [pb, vb, cb]) in moving.iter().filter(|(b, _)| a != *b && share(a, b)) {
                let minus = |a: &[f64; 2], b: &[f64; 2]| [a[0] - b[0], a[1] - b[1]];
                let [d, rate, second] = [minus(pa, pb), minus(va, vb), minus(ca, cb)];
                let first = dot(d, rate).abs() / (1.0 + dot(*va, *va) + dot(*vb, *vb)).sqrt();
                let second = (dot(rate, rate) + dot(d, second)).abs()
                    / (1.0 + dot(*ca, *ca) + dot(*cb, *cb)).sqrt();
                assert!(first < off && second < off, "{} {a} {b}: {first:e} {second:e}", self.name);
            }
        }
    }
}

/// Solved poses of all machines, within this distance.
macro_rules! solved {
    ($width:ty, $off:expr; $($name:ident),*) => {
        [$(Reference::of(stringify!($name)).solved(&$name::<$width>::default(), $off)),*]
    };
}

#[test]
fn poses_over_the_whole_motion_are_those_of_newton_on_all_bodies() {
    let solved = solved!(f64, 1e-13; EightBar1, EightBar2, EightBar3, EightBar4, EightBar8, EightBar10, EightBar11, EightBar14, EightBar17);
    println!("{solved:?}");
    assert!(solved.iter().sum::<usize>() >= 115);
}

#[test]
fn single_precision_solves_the_same_poses() {
    // As many units in the last place as in double precision.
    let off = 1e-13 / f64::EPSILON * f64::from(f32::EPSILON);
    let solved = solved!(f32, off; EightBar1, EightBar2, EightBar3, EightBar4, EightBar8, EightBar10, EightBar11, EightBar14, EightBar17);
    println!("{solved:?}");
    assert!(solved.iter().sum::<usize>() >= 115);
}

/// Where J6 is by Newton's method on all bodies, in millimetres to eleven digits, and all of the turn in steps of a
/// tenth of a degree: from pose to pose J6 goes on by the length that its rate says, to half the square of a step times
/// its acceleration, of which a half is left for the change of that.
#[test]
fn a_turn_beside_another_assembly_is_solved_as_a_whole() {
    const RIGHT: [(f64, [f64; 2]); 8] = [
        (0.0, [57.5, 77.0]),
        (45.0, [20.96214999, 59.382542044]),
        (90.0, [1.05849389, 40.203059967]),
        (135.0, [4.379539221, 44.150935381]),
        (180.0, [14.061626205, 53.807636509]),
        (225.0, [35.582054683, 68.516487917]),
        (270.0, [71.529723177, 79.754107416]),
        (315.0, [82.917471231, 80.60492251]),
    ];
    let (machine, narrow) = (StephensonTwo::<f64>::default(), StephensonTwo::<f32>::default());
    let from = StephensonTwo::<f64>::DRAWN[0];
    for (degrees, [x, y]) in RIGHT {
        let pose = machine.position(from + f64::to_radians(degrees)).expect("it turns fully");
        let off = (1e3 * pose.J6.x - x).hypot(1e3 * pose.J6.y - y);
        assert!(off < 1e-8, "{degrees}: {off:e} mm");
    }
    let step = f64::to_radians(0.1);
    let mut last: Option<[[f64; 2]; 2]> = None;
    for index in 0..=3600 {
        let at = from + step * f64::from(index);
        let pose = machine.motion(at, 1.0, 0.0).unwrap_or_else(|error| panic!("{index}: {error}"));
        let orders = [pose.position.J6, pose.velocity.J6, pose.acceleration.J6];
        let [j6, rate, second] = orders.map(|at| [at.x, at.y]);
        if let Some([before, second_before]) = last {
            let gone = [0, 1].map(|axis| j6[axis] - before[axis] - step * rate[axis]);
            let most = second[0].hypot(second[1]).max(second_before[0].hypot(second_before[1]));
            let bound = 0.75 * step * step * most;
            assert!(gone[0].hypot(gone[1]) < bound + 1e-8, "{index}: {gone:?}, {bound}");
        }
        last = Some([j6, second]);
        let single = narrow.position(at as f32).unwrap_or_else(|error| panic!("{index}: {error}"));
        let off = (f64::from(single.J6.x) - j6[0]).hypot(f64::from(single.J6.y) - j6[1]);
        // The angle alone is rounded by 2e-7 at most, and J6 goes on by 0.3 m a radian; the group magnifies that
        // beside the other assembly.
        assert!(off < 2e-6, "{index}: {off:e}");
    }
}
