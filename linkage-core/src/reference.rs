//! The manual: the first hour, statements, what they generate, and machines to copy from.
//!
//! [Both directions]: self::both_directions
//! [Both directions: Groups of class III]: self::both_directions#groups-of-class-iii
//! [Both directions: Searching]: self::both_directions#searching
//! [Both directions: Set-points and groups of class III]: self::both_directions#set-points-and-groups-of-class-iii
//! [Both directions: Several sets of inputs]: self::both_directions#several-sets-of-inputs
//! [Controllers]: self::controllers
//! [Controllers: In a PLC]: self::controllers#in-a-plc
//! [Controllers: In a simulator]: self::controllers#in-a-simulator
//! [Controllers: Proved errors]: self::controllers#proved-errors
//! [Controllers: Without the standard library]: self::controllers#without-the-standard-library
//! [Controllers: Worst case]: self::controllers#worst-case
//! [How a machine is cut]: self::cut
//! [How a machine is cut: Change points]: self::cut#change-points
//! [How a machine is cut: From a machine to its groups]: self::cut#from-a-machine-to-its-groups
//! [How a machine is cut: Two modes]: self::cut#two-modes
//! [Forces]: self::forces
//! [Forces: Forces]: self::forces#forces
//! [Forces: Forces that depend on the motion]: self::forces#forces-that-depend-on-the-motion
//! [Forces: Friction]: self::forces#friction
//! [Forces: From forces to motion]: self::forces#from-forces-to-motion
//! [Forces: Stops]: self::forces#stops
//! [Forces: Where it jams]: self::forces#where-it-jams
//! [Method]: self::method_and_measurements
//! [Method: Speed against error]: self::method_and_measurements#speed-against-error
//! [Recipes]: self::recipes
//! [Recipes: A hydraulic cylinder]: self::recipes#a-hydraulic-cylinder
//! [Recipes: A parallelogram]: self::recipes#a-parallelogram
//! [Recipes: Gears, belts, racks]: self::recipes#gears-belts-racks
//! [Start in a browser]: self::start_in_a_browser
//! [Start in a browser: From PMKS+, SAM, Linkage or pylinkage]: self::start_in_a_browser#from-pmks-sam-linkage-or-pylinkage
//! [Start in C]: self::start_in_c
//! [Start in C: A controller that is already there]: self::start_in_c#a-controller-that-is-already-there
//! [Start in C: Float or double?]: self::start_in_c#float-or-double
//! [Start in C: Your own machine]: self::start_in_c#your-own-machine
//! [Start in Rust]: self::start_in_rust
//! [Start in Rust: A four-bar]: self::start_in_rust#a-four-bar
//! [Start in Rust: Derivatives]: self::start_in_rust#derivatives
//! [Start in Rust: Errors]: self::start_in_rust#errors
//! [Start in Rust: Many poses]: self::start_in_rust#many-poses
//! [Start in Rust: What a declaration generates]: self::start_in_rust#what-a-declaration-generates
//! [Statements]: self::statements
//! [Statements: Frames and signs]: self::statements#frames-and-signs
//! [Statements: Glossary]: self::statements#glossary
//! [Statements: Operators and functions]: self::statements#operators-and-functions
//! [Statements: Units]: self::statements#units
//! [Statements: What an expression can read]: self::statements#what-an-expression-can-read
//! [Statements: drive]: self::statements#drive
//! [Statements: guide]: self::statements#guide
//! [Statements: input]: self::statements#input
//! [Statements: link]: self::statements#link
//! [Statements: output]: self::statements#output
//! [Statements: param]: self::statements#param
//! [Statements: point]: self::statements#point
//! [Statements: rpr]: self::statements#rpr
//! [Designing]: https://docs.rs/linkage-design
//!
#![doc = include_str!("../docs/README.md")]
//! These modules hold documentation alone; the files are `docs/*.md` of the crate, whose links lead to
//! each other there and, by the definitions that come first, to items here.

pub mod start_in_a_browser {
    //! [In C]: super::start_in_c
    //! [Recipes]: super::recipes
    //! [Statements]: super::statements
    //! [forces]: super::forces
    //! [in Rust]: super::start_in_rust
    //!
    #![doc = include_str!("../docs/start_in_a_browser.md")]
}

pub mod start_in_c {
    //! [In C, without Rust]: super::controllers
    //! [In a PLC]: super::controllers#in-a-plc
    //! [Recipes]: super::recipes
    //! [Statements]: super::statements
    //! [forces]: super::forces
    //!
    #![doc = include_str!("../docs/start_in_c.md")]
}

pub mod start_in_rust {
    //! [control code]: super::controllers#without-the-standard-library
    //! [crate]: crate#features
    //! [forces]: super::forces
    //! [searching]: super::both_directions#searching
    //! [several]: super::both_directions#groups-of-class-iii
    //! [`Direction`]: crate::Direction
    //! [`Mechanism`]: crate::Mechanism
    //! [`Parameters`]: crate::Parameters
    //! [`Point`]: crate::Point
    //! [`Record::LABELS`]: crate::Record::LABELS
    //! [`Record::links`]: crate::Record::links
    //! [`Record::points`]: crate::Record::points
    //! [`SlidingDirection`]: crate::SlidingDirection
    //! [`SolveError`]: crate::SolveError
    //! [`Status`]: crate::Status
    //! [`Tracker`]: crate::Tracker
    //! [`unwanted()`]: crate::unwanted
    //!
    #![doc = include_str!("../docs/start_in_rust.md")]
}

pub mod statements {
    //! [control]: super::controllers
    //! [cut]: super::cut
    //! [figures]: super::figures
    //! [forces]: super::forces
    //! [friction]: super::forces#friction
    //! [measurements]: super::method_and_measurements#against-other-methods
    //! [other assemblies]: super::both_directions#the-other-assemblies
    //! [parallelogram]: super::recipes#a-parallelogram
    //! [sets]: super::both_directions#several-sets-of-inputs
    //! [unknown]: super::both_directions#unknown-and-solve
    //! [`SolveError::Invalid`]: crate::SolveError::Invalid
    //!
    // The page's figures as they are, ahead of the files that the page names where it is read by itself:
    // of two definitions the first holds.
    #![doc = include_str!("figures/drawn.md")]
    #![doc = include_str!("../docs/statements.md")]
}

pub mod cut {
    //! [dyads]: super::statements#dyads
    //! [set-points]: super::both_directions#groups-of-class-iii
    //! [sets]: super::both_directions#several-sets-of-inputs
    //! [`limits`]: crate::range::limits()
    //! [all assemblies]: super::method_and_measurements#all-assemblies
    //! [other assemblies]: super::both_directions#the-other-assemblies
    //! [`Tracker`]: crate::Tracker
    //!
    #![doc = include_str!("figures/drawn_limits.md")]
    #![doc = include_str!("../docs/cut.md")]
}

pub mod figures {
    //! A figure for each statement, every place in it computed by a solver: frames, dimensions,
    //! and the other mode, dotted. The letters are explained with the [statements](super::statements).
    //!
    //! <style>svg.auto { max-width: 100%; height: auto; }</style>
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

pub mod forces {
    //! [change points]: super::cut#change-points
    //! [unknown]: super::both_directions#unknown-and-solve
    //! [`Series`]: crate::Series
    //! [`SolveError::Jams`]: crate::SolveError::Jams
    //! [`Tracker`]: crate::Tracker
    //!
    #![doc = include_str!("../docs/forces.md")]
}

pub mod both_directions {
    //! [class III]: super::cut#class-iii
    //! [all assemblies]: super::method_and_measurements#all-assemblies
    //! [forces]: super::forces#beside-an-unknown
    //! [measurements]: super::method_and_measurements#size
    //! [`NotCertified`]: crate::SolveError::NotCertified
    //! [`Search::find_output`]: crate::find::Search::find_output
    //! [`Tracker`]: crate::Tracker
    //! [`find`]: crate::find
    //! [`limits`]: crate::range::limits()
    //! [`range::extrema_of`]: crate::range::extrema_of
    //! [`range::extrema`]: crate::range::extrema()
    //! [`range::limits`]: crate::range::limits()
    //!
    #![doc = include_str!("figures/drawn_searches.md")]
    #![doc = include_str!("../docs/both_directions.md")]
}

pub mod controllers {
    //! [measurements]: super::method_and_measurements#bounds-and-errors
    //! [output]: super::statements#output
    //! [start]: super::start_in_c#your-own-machine
    //!
    #![doc = include_str!("../docs/controllers.md")]
}

pub mod recipes {
    //! [`differentiate_twice`]: crate::differentiate_twice
    //! [`extrema`]: crate::range::extrema()
    //! [`find`]: crate::find
    //!
    #![doc = include_str!("../docs/recipes.md")]
}

pub mod method_and_measurements {
    //! [control]: super::controllers
    //!
    #![doc = include_str!("../docs/method_and_measurements.md")]
}
