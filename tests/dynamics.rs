//! Forces, friction and accelerations of whole machines, robots among them.

mod forces;
mod friction;
mod robots;
