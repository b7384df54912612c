//! The bodies and pins that are placed while groups are found, and pins at which such bodies meet.

use super::machine::Machine;

/// The bodies and pins that are placed.
#[derive(Clone)]
pub struct Placed {
    bodies: Vec<bool>,
    pins: Vec<bool>,
}

impl Placed {
    /// The ground and what is given, as if all of it were there: the groups come in an order in which it
    /// is.
    pub fn at_first(machine: &Machine) -> Self {
        let mut known = Self {
            bodies: vec![false; machine.bodies.len()],
            pins: vec![false; machine.pins.len()],
        };
        // The ground is one of them.
        for body in (0..machine.bodies.len()).filter(|&body| machine.is_given(body)) {
            known.bodies[body] = true;
            machine.bodies[body].made().for_each(|pin| known.pins[pin] = true);
        }
        known
    }

    pub fn add(&mut self, machine: &Machine, bodies: &[usize]) {
        for &body in bodies {
            self.bodies[body] = true;
            machine.bodies[body].pins.iter().for_each(|&pin| self.pins[pin] = true);
        }
    }

    pub(crate) fn body(&self, body: usize) -> bool {
        self.bodies[body]
    }

    pub(crate) fn pin(&self, pin: usize) -> bool {
        self.pins[pin]
    }
}

/// A pin at which two bodies that are placed meet.
#[derive(Clone, Debug)]
pub struct Closing {
    pub pin: usize,
    /// The body whose pin it is not yet.
    pub body: usize,
    /// A bound on the sum of the second derivatives of the vector between both pins, with slides in units of the size.
    pub bend: f64,
}
