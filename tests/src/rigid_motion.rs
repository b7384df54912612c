//! Points carried by moving frames: what a plan of a motion is made of.
//!
//! Textbook kinematics in ground axes; no mechanism and no solver in here.

/// A point's position, velocity and acceleration.
#[derive(Clone, Copy, Debug)]
pub struct Moving {
    pub position: [f64; 2],
    pub velocity: [f64; 2],
    pub acceleration: [f64; 2],
}

/// A value with its two rates: a slide, an angle, ….
#[derive(Clone, Copy, Debug)]
pub struct Jet {
    pub value: f64,
    pub rate: f64,
    pub second: f64,
}

impl Jet {
    pub fn constant(value: f64) -> Self {
        Self { value, rate: 0.0, second: 0.0 }
    }

    /// The same motion, measured from where it is now.
    pub fn relative(self) -> Self {
        Self { value: 0.0, ..self }
    }
}

impl Moving {
    /// The point at (x, y) of a frame with this origin and the given rotation:
    /// r = O + x u + y n, r' = O' + ω k×(r−O) + x' u + y' n, and
    /// r'' = O'' + α k×(r−O) − ω² (r−O) + 2 ω k×(x' u + y' n) + x'' u + y'' n.
    pub fn carry(&self, turn: Jet, x: Jet, y: Jet) -> Self {
        let (sin, cos) = turn.value.sin_cos();
        let rotate = |a: f64, b: f64| [a * cos - b * sin, a * sin + b * cos];
        let arm = rotate(x.value, y.value);
        let slip = rotate(x.rate, y.rate);
        let slip_rate = rotate(x.second, y.second);
        let (w, a) = (turn.rate, turn.second);
        Self {
            position: [self.position[0] + arm[0], self.position[1] + arm[1]],
            velocity: [
                self.velocity[0] - w * arm[1] + slip[0],
                self.velocity[1] + w * arm[0] + slip[1],
            ],
            acceleration: [
                self.acceleration[0] - a * arm[1] - w * w * arm[0] - 2.0 * w * slip[1]
                    + slip_rate[0],
                self.acceleration[1] + a * arm[0] - w * w * arm[1]
                    + 2.0 * w * slip[0]
                    + slip_rate[1],
            ],
        }
    }

    /// The three orders, each as a list.
    pub fn orders(&self) -> [[f64; 2]; 3] {
        [self.position, self.velocity, self.acceleration]
    }
}
