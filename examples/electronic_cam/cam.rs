//! The electronic cam as it runs on the drive: in every period of the control it takes what the
//! strip did, and gives the crank's angle, speed and acceleration. Nothing here needs a heap or
//! the standard library, and nothing can panic.
//!
//! The strip's travel s is the master axis and the crank angle θ the slave, so the cam is a
//! function θ(s) with its first two derivatives, and for a strip of speed v and acceleration a
//!
//! > θ̇ = θ′ v,  θ̈ = θ″ v² + θ′ a.
//!
//! While the blade is in the strip, the linkage itself is the cam: with the kinematic coefficient
//! K = ∂x/∂θ of the blade, x′ = K θ′ = 1 gives θ′ = 1/K, and x″ = 0 gives θ″ = −(K′ θ′²)/K, where
//! K′ θ′² is the blade's acceleration at the crank speed θ′ and no crank acceleration. Over the
//! rest of the turn the crank runs at a constant θ′, chosen so that the next cut begins after the
//! wanted length, and cubic blends of θ′ lead there and back without a jump of θ″.
#![no_std]

use linkage_core::{Real, SolveError, mechanism};

mechanism! {
    /// The shear's crank-rocker, whose coupler carries the upper blade.
    pub struct FlyingShear {
        input theta: angle;

        ground A(0, 0), D(665.7mm, 0);

        crank AB(A) -> B        { length: 80mm, angle: theta }
        rrr   BC(B), DC(D) -> C { lengths: (632mm, 374mm), mode: right }

        /// Cutting edge of the upper blade.
        point blade on BC at (500mm, -60mm);

        output blade;
    }
}

/// The strip that passes while the crank's speed is blended, in m.
const BLEND: f64 = 0.06;

/// The motion of the strip since the step before.
#[derive(Clone, Copy, Debug)]
pub struct Strip<T> {
    /// In m.
    pub advance: T,
    /// In m/s.
    pub speed: T,
    /// In m/s².
    pub acceleration: T,
}

/// The set-point of the drive.
#[derive(Clone, Copy, Debug)]
pub struct Setpoint<T> {
    /// In rad.
    pub angle: T,
    /// In rad/s.
    pub speed: T,
    /// In rad/s².
    pub acceleration: T,
}

/// The crank angle and its derivatives by the strip's travel, in rad, rad/m and rad/m².
#[derive(Clone, Copy, Debug)]
struct Coupling<T> {
    angle: T,
    slope: T,
    curvature: T,
}

/// Once per cut, the crank passes from one to the other.
#[derive(Clone, Copy, Debug)]
enum Phase<T> {
    Cutting { lag: T },
    Returning { way: WayBack<T> },
}

/// The electronic cam with all of its state.
#[derive(Clone, Copy, Debug)]
pub struct Cam<T> {
    shear: FlyingShear<T>,
    /// Where the blade meets the strip and where it leaves it.
    ends: [Coupling<T>; 2],
    /// Where along the strip the blade meets it, and the strip that passes until it leaves, in m.
    meets: T,
    engaged: T,
    /// The cut length that was asked for, in m; more than two blends and the cut itself.
    pub length: T,
    phase: Phase<T>,
    /// The strip's travel in this phase, in m.
    travel: T,
    coupling: Coupling<T>,
}

/// The floating-point operations of the dearest step, one with the blade in the strip: what the
/// linkage costs, and 16 additions and multiplications and a division around it. The step that
/// plans the way back needs 131.
pub const WORST_CASE: u32 =
    FlyingShear::COST.coefficients.total() + FlyingShear::COST.motion.total() + 17;

impl<T: Real> Cam<T> {
    /// A cam that stands where the blade meets the strip. The blade is in the strip between the
    /// crank angles `enters` and `leaves`; `length` is the cut length.
    ///
    /// # Errors
    /// Those of the linkage.
    pub fn new(enters: T, leaves: T, length: T) -> Result<Self, SolveError> {
        let shear = FlyingShear::default();
        let (enter, meets) = synchronous(&shear, enters)?;
        let (leave, parts) = synchronous(&shear, leaves)?;
        Ok(Self {
            shear,
            ends: [enter, leave],
            meets,
            engaged: parts - meets,
            length,
            phase: Phase::Cutting { lag: zero() },
            travel: zero(),
            coupling: enter,
        })
    }

    /// One period of the control.
    ///
    /// # Errors
    /// Those of the linkage, and none for a shear whose crank turns fully.
    pub fn step(&mut self, strip: Strip<T>) -> Result<Setpoint<T>, SolveError> {
        self.travel = self.travel + strip.advance;
        let (coupling, phase) = match self.phase {
            Phase::Cutting { .. } if self.travel.ge(self.engaged) => {
                self.travel = self.travel - self.engaged;
                let way = self.way_back();
                (way.at(self.travel), Phase::Returning { way })
            }
            Phase::Cutting { lag } => self.cut(self.coupling, strip.advance, lag)?,
            Phase::Returning { way } if self.travel.ge(way.length) => {
                self.travel = self.travel - way.length;
                self.cut(self.ends[0], self.travel, zero())?
            }
            Phase::Returning { way } => (way.at(self.travel), self.phase),
        };
        (self.coupling, self.phase) = (coupling, phase);
        let Coupling { angle, slope, curvature } = coupling;
        Ok(Setpoint {
            angle,
            speed: slope * strip.speed,
            acceleration: curvature * strip.speed * strip.speed + slope * strip.acceleration,
        })
    }

    /// True if the blade is in the strip.
    pub fn is_cutting(&self) -> bool {
        matches!(self.phase, Phase::Cutting { .. })
    }

    /// In the strip: goes on from a coupling, and takes back by how much the blade lagged behind
    /// the strip there.
    fn cut(
        &self,
        from: Coupling<T>,
        advance: T,
        lag: T,
    ) -> Result<(Coupling<T>, Phase<T>), SolveError> {
        let half = number::<T>(0.5);
        let turned = (from.slope + half * from.curvature * advance) * advance;
        let (coupling, x) = synchronous(&self.shear, from.angle + turned + from.slope * lag)?;
        Ok((coupling, Phase::Cutting { lag: self.meets + self.travel - x }))
    }

    /// From where the blade leaves the strip to where it meets it in the next turn.
    fn way_back(&self) -> WayBack<T> {
        let [mut enter, leave] = self.ends;
        enter.angle = enter.angle + number(core::f64::consts::TAU);
        WayBack::new(leave, enter, self.length - self.engaged)
    }
}

/// The coupling at which the blade keeps pace with the strip, and where it is along the strip.
fn synchronous<T: Real>(shear: &FlyingShear<T>, angle: T) -> Result<(Coupling<T>, T), SolveError> {
    let [[x_by_angle], _] = shear.coefficients(angle)?;
    let slope = number::<T>(1.0) / x_by_angle;
    let at_this_slope = shear.motion(angle, slope, zero())?;
    let curvature = -at_this_slope.acceleration.blade.x * slope;
    Ok((Coupling { angle, slope, curvature }, at_this_slope.position.blade.x))
}

/// From one coupling to another, over a length of strip.
#[derive(Clone, Copy, Debug)]
struct WayBack<T> {
    /// Out of the cut, at a constant slope, and into the next cut.
    legs: [Blend<T>; 3],
    length: T,
}

impl<T: Real> WayBack<T> {
    /// The length has to be more than that of two blends.
    fn new(from: Coupling<T>, to: Coupling<T>, length: T) -> Self {
        let (half, twelfth) = (number::<T>(0.5), number::<T>(1.0 / 12.0));
        let blend = number(BLEND);
        // The turn is the sum of the legs' integrals, in which the constant slope is linear.
        let by_slopes = half * blend * (from.slope + to.slope);
        let by_curvatures = twelfth * blend * blend * (from.curvature - to.curvature);
        let rest = to.angle - from.angle - by_slopes - by_curvatures;
        let slope = rest / (length - blend);
        let run = |angle| Coupling { angle, slope, curvature: zero() };
        let out = Blend::new(from, run(zero()), blend);
        let constant = Blend::new(run(out.end()), run(zero()), length - blend - blend);
        let back = Blend::new(run(constant.end()), to, blend);
        Self { legs: [out, constant, back], length }
    }

    fn at(&self, travel: T) -> Coupling<T> {
        let [out, constant, back] = &self.legs;
        let (beyond, rest) = (travel - out.length, self.length - travel);
        if out.length.ge(travel) {
            out.at(travel)
        } else if rest.ge(back.length) {
            constant.at(beyond)
        } else {
            back.at(back.length - rest)
        }
    }
}

/// A cubic slope between two slopes and curvatures.
#[derive(Clone, Copy, Debug)]
struct Blend<T> {
    angle: T,
    /// Coefficients of the slope, in powers of the travel over the length.
    coefficients: [T; 4],
    length: T,
}

impl<T: Real> Blend<T> {
    fn new(from: Coupling<T>, to: Coupling<T>, length: T) -> Self {
        let (two, three) = (number::<T>(2.0), number::<T>(3.0));
        let (rise, c0, c1) =
            (to.slope - from.slope, from.curvature * length, to.curvature * length);
        let coefficients = [from.slope, c0, three * rise - two * c0 - c1, c0 + c1 - two * rise];
        Self { angle: from.angle, coefficients, length }
    }

    fn at(&self, travel: T) -> Coupling<T> {
        let [half, third, quarter, two, three] = [0.5, 1.0 / 3.0, 0.25, 2.0, 3.0].map(number::<T>);
        let [c0, c1, c2, c3] = self.coefficients;
        let u = travel / self.length;
        let mean = c0 + u * (half * c1 + u * (third * c2 + u * (quarter * c3)));
        Coupling {
            angle: self.angle + travel * mean,
            slope: c0 + u * (c1 + u * (c2 + u * c3)),
            curvature: (c1 + u * (two * c2 + u * (three * c3))) / self.length,
        }
    }

    /// The angle at the end.
    fn end(&self) -> T {
        self.at(self.length).angle
    }
}

fn number<T: Real>(value: f64) -> T {
    T::lit(value, value as f32)
}

fn zero<T: Real>() -> T {
    T::lit(0.0, 0.0)
}
