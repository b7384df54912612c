//! The functions of a solver beside its C functions, each behind a symbol: the fast paths, the rows, angles,
//! conversion to another width, several numbers side by side, sweeps over slices, trackers, searches, ranges;
//! and two controllers that are made of them.

use linkage_core::find::{FindError, Search, Trend};
use linkage_core::range::{extrema, limits};
use linkage_core::{
    Direction, Float, Lanes, Mask, Point, Real, Record, Scalar, Series, Tracker, unwanted,
};

use cam::{Cam, Strip};
use robot_controller::{Controller, Robot, Wanted, rk4};
use crate::mechanisms::{
    Everything, Excavator, WattSixBar, FlyingShear, FlyingShearPosition, HeavyPress,
    HeavyPressForces, HeavyPressLoads, HeavyRobot, HeavyRobotEquations, SixBar, SliderCrank, TunedFourBar,
};

macro_rules! symbols {
    ($($name:ident = $function:ident::<$number:ident>;)+) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $name(x: $number) -> $number {
            $function::<$number>(x)
        }
    )+};
}

symbols! {
    methods_straight = straight::<f64>;
    methods_straight_f32 = straight::<f32>;
    methods_straight_records = straight_records::<f64>;
    methods_straight_records_f32 = straight_records::<f32>;
    methods_rows = rows::<f64>;
    methods_rows_f32 = rows::<f32>;
    methods_angles = angles::<f64>;
    methods_angles_f32 = angles::<f32>;
    methods_lift = lift::<f64>;
    methods_lift_f32 = lift::<f32>;
    methods_lanes = lanes::<f64>;
    methods_lanes_f32 = lanes::<f32>;
    methods_fast = fast::<f64>;
    methods_fast_f32 = fast::<f32>;
    methods_tracker = tracker::<f64>;
    methods_tracker_f32 = tracker::<f32>;
    methods_range = range::<f64>;
    methods_range_f32 = range::<f32>;
    methods_find = find::<f64>;
    methods_find_f32 = find::<f32>;
    methods_integrated = integrated::<f64>;
    methods_integrated_f32 = integrated::<f32>;
    methods_cam = cam::<f64>;
    methods_cam_f32 = cam::<f32>;
    methods_robot = robot::<f64>;
    methods_robot_f32 = robot::<f32>;
}

macro_rules! sweeps {
    ($($name:ident = $sweep:ident: $number:ident;)+) => {$(
        /// As many poses as the caller says.
        #[unsafe(no_mangle)]
        extern "C" fn $name(angles: *const $number, to: *mut $number, poses: usize) -> bool {
            // SAFETY: only linked, never called.
            let (angles, to) = unsafe {
                (
                    core::slice::from_raw_parts(angles, poses),
                    core::slice::from_raw_parts_mut(to, poses),
                )
            };
            $sweep(angles, to)
        }
    )+};
}

sweeps! {
    methods_sweep = sweep: f64;
    methods_sweep_f32 = sweep: f32;
    methods_sweep_heavy = sweep_forces: f64;
    methods_sweep_heavy_f32 = sweep_forces: f32;
    methods_sweep_moving = sweep_dynamics: f64;
    methods_sweep_moving_f32 = sweep_dynamics: f32;
}

fn sweep<T: Float>(angles: &[T], to: &mut [T]) -> bool {
    let wanted = FlyingShearPosition {
        blade: Point { x: to, y: &mut [] },
        BC: Direction { cos: &mut [], sin: &mut [] },
        DC: Direction { cos: &mut [], sin: &mut [] },
        DC_margin: &mut [],
        DC_transmission: &mut [],
    };
    FlyingShear::<T>::default().sweep_position(angles, wanted, &mut [], ()).is_ok()
}

fn sweep_forces<T: Float>(angles: &[T], to: &mut [T]) -> bool {
    let mut wanted = HeavyPressForces::from_array([(); 11].map(|()| &mut [][..]));
    wanted.theta.drive = to;
    let [speed, still] = [T::lit(3.0, 3.0), T::lit(0.0, 0.0)];
    let loads = HeavyPressLoads { work: speed.into(), friction: still.into() };
    let press = HeavyPress::<T>::default();
    press.sweep_forces(angles, speed, still, loads, wanted, &mut [], ()).is_ok()
}

fn sweep_dynamics<T: Float>(angles: &[T], to: &mut [T]) -> bool {
    let robot = HeavyRobot::<T>::default();
    let [speed, still] = [T::lit(3.0, 3.0), T::lit(0.0, 0.0)];
    let inputs = || [Series::Each(angles), Series::Constant(speed)];
    let rates = || [still, speed].map(Series::Constant);
    let moved = robot
        .sweep_forward_dynamics(inputs(), rates(), rates(), [&mut *to, &mut []], &mut [], ())
        .is_ok();
    let wanted = HeavyRobotEquations { force: [&mut [], to], ..unwanted() };
    moved && robot.sweep_equations_of_motion(inputs(), rates(), wanted, &mut [], ()).is_ok()
}

/// A thousand steps of an integrator, and the straight lines behind them.
fn integrated<T: Real>(x: T) -> T {
    let (robot, h) = (HeavyRobot::<T>::default(), T::lit(1e-3, 1e-3));
    let mut state = [x, x + x, x - x, x - x];
    for _ in 0..1000 {
        let Ok(rates) = robot.state_rates(state, [x, -x]) else { return x };
        for (value, rate) in state.iter_mut().zip(rates) {
            *value = *value + h * rate;
        }
    }
    let [first, second, ..] = state;
    let ([a, b], moved) = robot.solve_forward_dynamics([first, second], [x, x], [x, x]);
    let (equations, known) = robot.solve_equations_of_motion([first, second], [x, x]);
    let [[mass, _], _] = equations.mass;
    used((a + b, moved)) + used((mass, known))
}

/// The value where the mask allows it.
fn used<T: Scalar>((value, usable): (T, T::Mask)) -> T {
    T::select(usable, value, T::lit(0.0, 0.0))
}

fn straight<T: Real>(x: T) -> T {
    let shear = FlyingShear::<T>::default();
    let (position, position_ok) = shear.solve_position(x);
    let (velocity, velocity_ok) = shear.solve_velocity(x, x);
    let (motion, motion_ok) = shear.solve_motion_at(x, x, x, x);
    let (coefficients, coefficients_ok) = shear.solve_coefficients(x);
    let (margins, margins_ok) = shear.solve_margins(x);
    let [[coefficient], ..] = coefficients;
    used((position.blade.x, position_ok))
        + used((velocity.blade.x, velocity_ok))
        + used((motion.acceleration.blade.x, motion_ok))
        + used((coefficient, coefficients_ok))
        + used((margins.DC_margin, margins_ok))
}

fn straight_records<T: Real>(x: T) -> T {
    let machine = Excavator::<T>::default();
    let (motion, motion_ok) = machine.solve_motion([x, x, x], [x, x, x], [x, x, x]);
    let (everything, everything_ok) = Everything::<T>::default().solve_position([x, x, x]);
    used((motion.acceleration.tooth.x, motion_ok)) + used((everything.Q.x, everything_ok))
}

fn rows<T: Real>(x: T) -> T {
    let Ok(motion) = SixBar::<T>::default().motion(x, x, x) else { return x };
    let rows = [motion.position.rows(), motion.velocity.rows(), motion.acceleration.rows()];
    rows.iter().flatten().fold(x, |sum, &row| sum + row)
}

fn angles<T: Real>(x: T) -> T {
    let Ok(position) = TunedFourBar::<T>::default().position(x) else { return x };
    let bar: Direction<T> = position.BC;
    bar.angle() + bar.angle_near(x) + bar.angle_from(position.DC)
}

fn lift<T: Real>(x: T) -> T {
    let narrow = TunedFourBar::<T>::default().lift::<f32>();
    let Ok(position) = narrow.position(x.value() as f32) else { return x };
    T::lit(f64::from(position.reach), position.reach)
}

fn lanes<T: Float>(x: T) -> T {
    let angles = Lanes::<T, 4>::new([x, x + x, x - x, -x]);
    let (motion, usable) = SixBar::default().solve_motion(angles, angles, angles);
    if usable.all() { motion.acceleration.E.x.to_array()[0] } else { x }
}

/// Single numbers, and several side by side, whose sines are turned in another way.
fn fast<T: Float>(x: T) -> T {
    let single = WattSixBar::<T>::default();
    let (motion, usable) = single.solve_motion(x, x, x);
    let angles = Lanes::<T, 4>::new([x, x + x, x - x, -x]);
    let (motions, all_usable) = WattSixBar::default().solve_motion(angles, angles, angles);
    let sum = used((motion.acceleration.E.x, usable));
    if all_usable.all() { sum + motions.acceleration.E.x.to_array()[0] } else { sum }
}

fn tracker<T: Float>(x: T) -> T {
    let mut bar = Tracker::new(TunedFourBar::<T>::default());
    let mut slider = Tracker::new(SliderCrank::<T>::default());
    let mut ram = Tracker::new(SixBar::<T>::default());
    let mut sum = x;
    for _ in 0..100 {
        let (Ok(position), Ok(motion)) = (bar.position(sum), slider.motion(sum, x, x)) else {
            return sum;
        };
        let Ok(position_of_ram) = ram.position(sum) else { return sum };
        sum = sum + position.C.x + motion.acceleration.C.x + position_of_ram.E.x;
    }
    sum
}

fn find<T: Real>(x: T) -> T {
    let ram = SliderCrank::<T>::default();
    let search = Search::new([x, x + x], Trend::Falling).near(x * x).slack(x);
    let one = T::lit(1.0, 1.0);
    let root = search.find(|theta| {
        let (position, velocity) = (ram.solve_position(theta).0, ram.solve_velocity(theta, one).0);
        [position.C.x - x, velocity.C.x]
    });
    match root {
        Ok(root) => root.at,
        Err(FindError::NoSolution { at, by, .. }) => T::lit(at + by, x.value() as f32),
        Err(_) => x,
    }
}

fn range<T: Real>(x: T) -> T {
    let six_bar = SixBar::<T>::default();
    let Ok(stretches) = limits(&six_bar, [x, x + x]) else { return x };
    let turns = extrema([x, x * x], |theta| {
        let at = six_bar.motion(theta, x, x)?;
        Ok([at.position.E.x, at.velocity.E.x, at.acceleration.E.x])
    });
    let Ok(turns) = turns else { return x };
    stretches.iter().fold(turns.stroke(), |sum, stretch| sum + stretch.width())
}

/// The electronic cam of the examples, over enough strip for every phase of it.
fn cam<T: Real>(x: T) -> T {
    let Ok(mut cam) = Cam::new(x, x + x, x) else { return x };
    let strip = Strip { advance: x, speed: x, acceleration: x };
    let mut sum = x;
    for _ in 0..100 {
        match cam.step(strip) {
            Ok(point) if cam.is_cutting() => sum = sum + point.acceleration,
            Ok(point) => sum = sum + point.angle + point.speed,
            Err(_) => return sum,
        }
    }
    sum
}

/// The robot's controller of the examples, and a step of the robot under what it gives.
fn robot<T: Real>(x: T) -> T {
    let controller = Controller { model: Robot::<T>::default(), bandwidth: x };
    let tool = Wanted { place: [x, x], rate: [x, x], second: [x, x] };
    let Ok([one, other]) = controller.torques([[x, x], [x, x]], tool) else { return x };
    let rates = |state| controller.model.state_rates(state, [one, other]);
    rk4(rates, [x, x, one, other], x).map_or(x, |[a, b, u, v]| a + b + u + v)
}
