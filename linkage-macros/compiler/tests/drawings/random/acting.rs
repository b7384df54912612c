//! Masses of a machine, and all that acts on it.

use super::drawing::Read;

/// A constant, a part of a load and a part of a rate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Amount {
    pub constant: f64,
    pub of_load: Option<(f64, usize)>,
    pub of_rate: Option<(f64, Read)>,
    /// True if it is a law with a name of its own.
    pub is_named: bool,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Mass {
    OnLink { link: usize, mass: f64, at: [f64; 2], inertia: f64 },
    AtPin { link: usize, mass: f64, pin: usize, inertia: f64 },
    Uniform { link: usize, mass: f64 },
    Inertia { link: usize, inertia: f64 },
    OnPin { pin: usize, mass: f64 },
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Load {
    /// A force on a point, in the axes of a link or of the ground.
    Force {
        pin: usize,
        parts: [Amount; 2],
        axes: Option<usize>,
    },
    /// Pushes two points apart.
    Between {
        pins: [usize; 2],
        amount: Amount,
    },
    Torque {
        link: usize,
        amount: Amount,
    },
    /// On the second link forwards, on the first backwards.
    TorqueBetween {
        links: [usize; 2],
        amount: Amount,
    },
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Spring {
    pub ends: Ends,
    pub stiffness: f64,
    pub free: f64,
    pub damping: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Ends {
    Pins([usize; 2]),
    /// From the ground or a link to a link.
    Links([Option<usize>; 2]),
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Stopped {
    Angle(usize),
    Slide(usize),
    Distance([usize; 2]),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Stop {
    pub of: Stopped,
    pub between: [f64; 2],
    pub stiffness: f64,
    pub damping: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Friction {
    Pin { pin: usize, coefficient: f64, radius: f64 },
    Guide { link: usize, coefficient: f64, length: Option<f64> },
}

#[derive(Clone, Debug, Default)]
pub(super) struct Acting {
    pub gravity: [f64; 2],
    /// True if it is a force, else a torque.
    pub loads: Vec<bool>,
    pub masses: Vec<Mass>,
    pub forces: Vec<Load>,
    pub springs: Vec<Spring>,
    pub stops: Vec<Stop>,
    pub frictions: Vec<Friction>,
}
