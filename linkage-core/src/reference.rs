//! The reference: the language, what it generates, and machines to copy from.
//!
//! | page | what is on it |
//! |---|---|
//! | [`start_in_a_browser`] | the first machine without Rust: drag it, change it, save C or an FMU; from PMKS+, SAM, pylinkage |
//! | [`start_in_c`] | the first machine in C99: `cc`, then a declaration of your own |
//! | [`start_in_rust`] | the first machine in a Rust program |
//! | [`questions`] | fifty questions of newcomers, each with the heading that answers it |
//! | [`language`] | machines as they are drawn or built; every statement; frames and signs; glossary |
//! | [`cut`] | how a machine is cut into Assur groups; modes, limits, dead and change points, class III, drawn |
//! | [`figures`] | the statements drawn: frames, signs, dimensions, modes |
//! | [`expressions`] | numbers, units, functions, what an expression can read |
//! | [`forces`] | masses and loads; efforts of drives and reactions of joints; motion from forces |
//! | [`friction`] | friction in joints: forces, motion, holding bands, self-locking |
//! | [`solver`] | what is generated and how it is called; errors, sweeps, derivatives |
//! | [`recipes`] | parallelograms, cylinders, gears, inversors, engines, suspensions |
//! | [`control`] | C99 and FMUs printed by the program `linkage`; without the standard library; from C |
//! | [`robots`] | closed loops between motors and joints, both ways |
//! | `linkage-design`, a crate of its own | dimensions for a function, a path or poses; tolerances and play |
//! | [`method`] | formulas of the five dyads, limits, searches, forces, how errors are measured, literature |
//! | [`measurements`] | accuracy, speed and size, with the commands that measure them |
//!
//! Begin with one of the three starts, and copy a machine from [`recipes`]. Look the rest up.
//!
//! These modules hold documentation alone; the files are `docs/*.md` of the crate, whose links lead to
//! each other there and, by the definitions that come first, to items here.

pub mod start_in_a_browser {
    //! [In C]: super::start_in_c
    //! [Recipes]: super::recipes
    //! [Statements]: super::language
    //! [forces]: super::forces
    //! [in Rust]: super::start_in_rust
    //!
    #![doc = include_str!("../docs/start_in_a_browser.md")]
}

pub mod start_in_c {
    //! [In C, without Rust]: super::control
    //! [Recipes]: super::recipes
    //! [Statements]: super::language
    //! [forces]: super::forces
    //!
    #![doc = include_str!("../docs/start_in_c.md")]
}

pub mod start_in_rust {
    //! [control code]: super::control#without-the-standard-library
    //! [forces]: super::forces
    //! [sweeps]: super::solver
    //! [the solver]: super::solver
    //!
    #![doc = include_str!("../docs/start_in_rust.md")]
}

pub mod questions {
    //! [How a machine is cut]: super::cut#from-a-machine-to-its-groups
    //! [Controllers and simulators: In a PLC]: super::control#in-a-plc
    //! [Controllers and simulators: In a simulator]: super::control#in-a-simulator
    //! [Controllers and simulators: Without the standard library]: super::control#without-the-standard-library
    //! [Forces]: super::forces#forces
    //! [Forces: Forces that depend on the motion]: super::forces#forces-that-depend-on-the-motion
    //! [Forces: From forces to motion]: super::forces#from-forces-to-motion
    //! [Forces: Stops]: super::forces#stops
    //! [Friction]: super::friction#friction
    //! [Friction: Motion]: super::friction#motion
    //! [Measurements: Proved errors]: super::measurements#proved-errors
    //! [Measurements: Size]: super::measurements#size
    //! [Measurements: Speed against error]: super::measurements#speed-against-error
    //! [Method]: super::method
    //! [Method: Limits]: super::method#limits
    //! [Numbers and expressions: Numbers]: super::expressions#numbers
    //! [Numbers and expressions: Operators and functions]: super::expressions#operators-and-functions
    //! [Numbers and expressions: What an expression can read]: super::expressions#what-an-expression-can-read
    //! [Recipes]: super::recipes
    //! [Recipes: A hydraulic cylinder]: super::recipes#a-hydraulic-cylinder
    //! [Recipes: A parallelogram]: super::recipes#a-parallelogram
    //! [Recipes: Gears, belts, racks]: super::recipes#gears-belts-racks
    //! [Robots: Loops in robots]: super::robots#loops-in-robots
    //! [Start in C: A controller that is already there]: super::start_in_c#a-controller-that-is-already-there
    //! [Start in C: Float or double?]: super::start_in_c#float-or-double
    //! [Start in C: Your own machine]: super::start_in_c#your-own-machine
    //! [Start in Rust: A four-bar]: super::start_in_rust#a-four-bar
    //! [Start in a browser]: super::start_in_a_browser
    //! [Start in a browser: From PMKS+, SAM, Linkage or pylinkage]: super::start_in_a_browser#from-pmks-sam-linkage-or-pylinkage
    //! [Statements: Frames and signs]: super::language#frames-and-signs
    //! [Statements: Glossary]: super::language#glossary
    //! [Statements: Set-points and groups of class III]: super::language#set-points-and-groups-of-class-iii
    //! [Statements: drive]: super::language#drive
    //! [Statements: guide]: super::language#guide
    //! [Statements: input]: super::language#input
    //! [Statements: link]: super::language#link
    //! [Statements: output]: super::language#output
    //! [Statements: param]: super::language#param
    //! [Statements: point]: super::language#point
    //! [Statements: rpr]: super::language#rpr
    //! [Statements: rrr]: super::language#rrr
    //! [Statements: unknown, solve]: super::language#unknown-solve
    //! [The solver: Derivatives]: super::solver#derivatives
    //! [The solver: Errors]: super::solver#errors
    //! [The solver: Many poses]: super::solver#many-poses
    //! [The solver: Searching]: super::solver#searching
    //! [The solver: What a declaration generates]: super::solver#what-a-declaration-generates
    //!
    #![doc = include_str!("../docs/questions.md")]
}

pub mod language {
    //! [control]: super::control
    //! [cut]: super::cut
    //! [expressions]: super::expressions
    //! [figures]: super::figures
    //! [forces]: super::forces
    //! [friction]: super::friction
    //! [measurements]: super::measurements
    //! [parallelogram]: super::recipes#a-parallelogram
    //! [`extrema`]: crate::range::extrema()
    //! [`limits`]: crate::range::limits()
    //! [`Tracker`]: crate::Tracker
    //!
    // The page's figures as they are, ahead of the files that the page names where it is read by itself:
    // of two definitions the first holds.
    #![doc = include_str!("figures/drawn.md")]
    #![doc = include_str!("../docs/language.md")]
}

pub mod cut {
    //! [dyads]: super::language#dyads
    //! [set-points]: super::language#set-points-and-groups-of-class-iii
    //! [sets]: super::language#several-sets-of-inputs
    //! [`limits`]: crate::range::limits()
    //! [`Tracker`]: crate::Tracker
    //!
    #![doc = include_str!("figures/drawn_limits.md")]
    #![doc = include_str!("../docs/cut.md")]
}

pub mod figures {
    //! A figure for each statement, every place in it computed by a solver: frames, dimensions,
    //! and the other mode, dotted. The letters are explained in [the
    //! language](super::language).
    //!
    //! # Drivers
    //! <div>
    #![doc = include_str!("figures/crank.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/slider.svg")]
    //! </div>
    //!
    //! # Groups
    //! <div>
    #![doc = include_str!("figures/rrr.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/rrp.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/rpr.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/prp.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/rpp.svg")]
    //! </div>
    //!
    //! # Guides and points of links
    //! <div>
    #![doc = include_str!("figures/guide.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/point.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/polar.svg")]
    //! </div>
    //!
    //! # Limits, dead and change points, class III
    //! <div>
    #![doc = include_str!("figures/limit.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/dead_point.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/change_point.svg")]
    //! </div>
    //!
    //! <div>
    #![doc = include_str!("figures/class_three.svg")]
    //! </div>
}

pub mod expressions {
    //! [`SolveError::Invalid`]: crate::SolveError::Invalid
    //!
    #![doc = include_str!("../docs/expressions.md")]
}

pub mod forces {
    //! [friction]: super::friction
    //! [language]: super::language
    //! [`Series`]: crate::Series
    //! [`Tracker`]: crate::Tracker
    //!
    #![doc = include_str!("../docs/forces.md")]
}

pub mod friction {
    //! [forces]: super::forces
    //! [`SolveError::Jams`]: crate::SolveError::Jams
    //!
    #![doc = include_str!("../docs/friction.md")]
}

pub mod solver {
    //! [`Direction`]: crate::Direction
    //! [`Mechanism`]: crate::Mechanism
    //! [`Point`]: crate::Point
    //! [`Record::LABELS`]: crate::Record::LABELS
    //! [`Record::links`]: crate::Record::links
    //! [`Record::points`]: crate::Record::points
    //! [`SlidingDirection`]: crate::SlidingDirection
    //! [`SolveError`]: crate::SolveError
    //! [`Status`]: crate::Status
    //! [`Tracker`]: crate::Tracker
    //! [`Search::find_output`]: crate::find::Search::find_output
    //! [`find`]: crate::find
    //! [`range::extrema`]: crate::range::extrema()
    //! [`range::extrema_of`]: crate::range::extrema_of
    //! [`range::limits`]: crate::range::limits()
    //! [`unwanted()`]: crate::unwanted
    //! [forces]: super::forces
    //! [measurements]: super::measurements
    //!
    #![doc = include_str!("../docs/solver.md")]
}

pub mod recipes {
    //! [`differentiate_twice`]: crate::differentiate_twice
    //! [`extrema`]: crate::range::extrema()
    //! [`find`]: crate::find
    //!
    #![doc = include_str!("../docs/recipes.md")]
}

pub mod control {
    //! [measurements]: super::measurements
    //!
    #![doc = include_str!("../docs/control.md")]
}

pub mod robots {
    //! [`limits`]: crate::range::limits()
    //! [sets of inputs]: super::language#several-sets-of-inputs
    //!
    #![doc = include_str!("../docs/robots.md")]
}

pub mod method {
    #![doc = include_str!("../docs/method.md")]
}

pub mod measurements {
    //! [control]: super::control
    //!
    #![doc = include_str!("../docs/measurements.md")]
}
