//! Drawings against the solvers: what a picture's text says is where the solver puts it.

mod bad_input;
mod bodies;
mod browser;
#[path = "../chromium/mod.rs"]
mod chromium;
mod gaps;
mod layout;
mod loads;
mod look;
mod motion;
mod names;
mod placed;
mod placing;
mod searched;
mod site;
mod snapshots;
mod springs;
mod text;
mod xml;
