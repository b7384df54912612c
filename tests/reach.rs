//! At the limits of assembly, through change points, and at the roots that a search finds.

mod limits;
mod searches;
mod tracking;
