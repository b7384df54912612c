//! The reference: the language, what it generates, and machines to copy from.
//!
//! | page | what is on it |
//! |---|---|
//! | [`language`] | how a machine is cut into Assur groups; every statement; frames and signs |
//! | [`expressions`] | numbers, units, functions, what an expression can read |
//! | [`forces`] | masses and loads; efforts of drives and reactions of joints |
//! | [`solver`] | what is generated and how it is called; errors, sweeps, derivatives |
//! | [`recipes`] | parallelograms, cylinders, gears, inversors, engines, suspensions |
//! | [`control`] | without the standard library; from C |
//! | [`measurements`] | accuracy, speed and size, with the commands that measure them |
//!
//! Whoever is new here reads [`language`] down to the table of statements, copies something from
//! [`recipes`], and looks the rest up.
//!
//! These modules hold documentation alone; the files are `docs/*.md` of the crate.

pub mod language {
    #![doc = include_str!("../docs/language.md")]
}

pub mod expressions {
    #![doc = include_str!("../docs/expressions.md")]
}

pub mod forces {
    #![doc = include_str!("../docs/forces.md")]
}

pub mod solver {
    #![doc = include_str!("../docs/solver.md")]
}

pub mod recipes {
    #![doc = include_str!("../docs/recipes.md")]
}

pub mod control {
    #![doc = include_str!("../docs/control.md")]
}

pub mod measurements {
    #![doc = include_str!("../docs/measurements.md")]
}
