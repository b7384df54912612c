//! Computed-torque control of a five-bar robot, as it runs on its drive: in every period of 1 ms it
//! takes where the motors stand and how fast they turn, and gives their torques. Nothing here needs a
//! heap or the standard library, and nothing can panic.
//!
//! With the equations of motion M q̈ = f + τ of the robot as its maker knows it, the torques
//!
//! > τ = M (q̈_d + 2ω(q̇_d − q̇) + ω²(q_d − q)) − f
//!
//! make what is left of the error obey ë + 2ωė + ω²e = 0, whatever the pose: every error dies out
//! critically damped. The wanted motion of the motors follows from that of the tool in closed form.
//!
//! [`rk4`] is the integrator that a drive can have, for a model that runs along, or for a simulation.
#![no_std]

use linkage_core::{Real, SolveError, mechanism};

mechanism! {
    /// The robot: two cranks driven by motors, and two rods that meet in the tool. It lies flat, and
    /// gravity acts on none of it.
    pub struct Robot {
        input q1, q2: angle;
        /// What the tool carries, in kg.
        param payload = 0.5kg;
        /// In the bearings of the motors.
        param friction = 0.02(N*m*s);

        ground A(-60mm, 0), D(60mm, 0);
        crank AB(A) -> B        { length: 180mm, angle: q1 }
        crank DE(D) -> E        { length: 180mm, angle: q2 }
        rrr   BP(B), EP(E) -> P { lengths: (240mm, 240mm), mode: left }

        mass 0.35kg on AB uniform;
        mass 0.35kg on DE uniform;
        mass 0.22kg on BP uniform;
        mass 0.22kg on EP uniform;
        mass payload on P;
        inertia 0.0004(kg*m^2) on AB;
        inertia 0.0004(kg*m^2) on DE;
        torque -friction * rate(q1) on AB;
        torque -friction * rate(q2) on DE;

        output P, energy, q1.drive, q2.drive;
    }
}

mechanism! {
    /// How the motors stand when the tool is at (x, y).
    pub struct Arms {
        input x, y: length;

        ground A(-60mm, 0), D(60mm, 0);
        point P at (x, y);

        rrr   AB(A), PB(P) -> B { lengths: (180mm, 240mm), mode: left }
        rrr   DE(D), PE(P) -> E { lengths: (180mm, 240mm), mode: right }

        output AB, DE;
    }
}

/// Two numbers: x and y of the tool, or one of each motor.
pub type Pair<T> = [T; 2];

/// A motion at one moment: where, its rate and its acceleration.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<T> {
    /// In m or rad.
    pub place: Pair<T>,
    /// In m/s or rad/s.
    pub rate: Pair<T>,
    /// In m/s² or rad/s².
    pub second: Pair<T>,
}

/// The controller.
#[derive(Clone, Copy, Debug)]
pub struct Controller<T = f64> {
    /// The robot as the controller believes it to be.
    pub model: Robot<T>,
    /// The rate at which errors decay, in 1/s; its reciprocal is several periods.
    pub bandwidth: T,
}

impl<T: Real> Controller<T> {
    /// The motors' torques in N·m, from where they stand in rad and turn in rad/s, and from the tool's
    /// wanted motion.
    ///
    /// # Errors
    /// Where the tool cannot be, or the robot has no way out of a pose: at the edge of its reach.
    pub fn torques(&self, [q, rate]: [Pair<T>; 2], tool: Wanted<T>) -> Result<Pair<T>, SolveError> {
        let wanted = motors(tool)?;
        let equations = self.model.equations_of_motion(q, rate)?;
        let (two, w) = (number::<T>(2.0), self.bandwidth);
        let [place, speed] = [minus(wanted.place, q), minus(wanted.rate, rate)];
        let corrected = |second: T, (place, speed): (T, T)| second + w * (two * speed + w * place);
        let ([x, y], [u, v], [a, b]) = (place, speed, wanted.second);
        let [a, b] = [corrected(a, (x, u)), corrected(b, (y, v))];
        let ([[aa, ab], [ba, bb]], [fa, fb]) = (equations.mass, equations.force);
        Ok([aa * a + ab * b - fa, ba * a + bb * b - fb])
    }
}

/// The motors' motion for a motion of the tool.
///
/// # Errors
/// Where the tool cannot be.
pub fn motors<T: Real>(tool: Wanted<T>) -> Result<Wanted<T>, SolveError> {
    let arms = Arms::<T>::default().motion(tool.place, tool.rate, tool.second)?;
    Ok(Wanted {
        place: [arms.position.AB.angle(), arms.position.DE.angle()],
        rate: [arms.velocity.AB.omega, arms.velocity.DE.omega],
        second: [arms.acceleration.AB.alpha, arms.acceleration.DE.alpha],
    })
}

/// One step of the classical Runge–Kutta method of order 4.
///
/// # Errors
/// Those of the right side.
pub fn rk4<T: Real, const N: usize>(
    rates: impl Fn([T; N]) -> Result<[T; N], SolveError>,
    from: [T; N],
    step: T,
) -> Result<[T; N], SolveError> {
    let along = |rates: [T; N], share: f64| {
        let mut to = from;
        to.iter_mut().zip(rates).for_each(|(x, rate)| *x = *x + number::<T>(share) * step * rate);
        to
    };
    let first = rates(from)?;
    let second = rates(along(first, 0.5))?;
    let third = rates(along(second, 0.5))?;
    let fourth = rates(along(third, 1.0))?;
    let mut mean = first;
    let all = mean.iter_mut().zip(second).zip(third).zip(fourth);
    all.for_each(|(((k1, k2), k3), k4)| {
        *k1 = (*k1 + number::<T>(2.0) * (k2 + k3) + k4) * number(1.0 / 6.0);
    });
    Ok(along(mean, 1.0))
}

fn minus<T: Real>([a, b]: Pair<T>, [c, d]: Pair<T>) -> Pair<T> {
    [a - c, b - d]
}

fn number<T: Real>(value: f64) -> T {
    T::lit(value, value as f32)
}
