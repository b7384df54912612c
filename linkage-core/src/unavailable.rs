//! Why a call does not compile: what a solver does not offer, and what was given in another form.
//!
//! The traits of this module are conditions that nothing fulfils, or that only the right argument
//! does. All they are for is what the compiler says where they are not met.

/// The argument that holds several inputs or loads of a solver: an array in the order of their
/// declaration, or the record `R` with a field for each.
#[diagnostic::on_unimplemented(
    message = "the numbers of `{R}` are one argument, and `{Self}` is not all of them",
    label = "write an array, as in `[a, b]`, or the record",
    note = "the array has a number for every field of the record, in the order of the declaration"
)]
pub trait Inputs<R>: Into<R> {}

#[diagnostic::do_not_recommend]
impl<A: Into<R>, R> Inputs<R> for A {}

/// The argument of a film: a list of inputs `I`, a pose each.
#[cfg(feature = "sketch")]
#[diagnostic::on_unimplemented(
    message = "a film is given a list of inputs, and `{Self}` is none",
    label = "write a list, as in `(0..60).map(|k| f64::from(k) * 0.1)`",
    note = "the list has the inputs of every picture; `write_svg` of the film is given a path"
)]
pub trait ListOfInputs<I>: IntoIterator<Item: Into<I>> {}

#[cfg(feature = "sketch")]
#[diagnostic::do_not_recommend]
impl<A: IntoIterator<Item: Into<I>>, I> ListOfInputs<I> for A {}

/// Implemented for each type by the type itself alone.
#[diagnostic::on_unimplemented(
    message = "`new` makes a solver in `f64`; write `default` for one in `{T}`",
    label = "write `default()` in place of `new()`"
)]
pub trait SameAs<T> {}

impl<T> SameAs<T> for T {}

/// Conditions that no solver fulfils: one for each reason why something is not offered.
macro_rules! conditions {
    ($($(#[$attribute:meta])* $condition:ident)*) => {$(
        $(#[$attribute])*
        pub trait $condition {
            /// The type that the call would return.
            type Answer;
            /// Never called: no solver fulfils the condition.
            fn answer(&self) -> Self::Answer;
        }
    )*};
}

conditions! {
    /// An output asks for a margin or a transmission.
    #[diagnostic::on_unimplemented(
        message = "this mechanism has no `margins`: none of its outputs asks for one",
        label = "there are no margins",
        note = "ask for them in its declaration: `output BC.margin;` or `output BC.transmission;`"
    )]
    HasMargins

    /// A parameter is a number.
    #[diagnostic::on_unimplemented(
        message = "this mechanism has no `sensitivity`: none of its parameters is a number",
        label = "there is nothing to be sensitive to",
        note = "make a parameter of a dimension in its declaration: `param l = 632mm;`"
    )]
    HasParameters

    /// The only input is the bare angle of a crank.
    #[diagnostic::on_unimplemented(
        message = "this mechanism cannot be given a cosine and a sine",
        label = "give the inputs themselves",
        note = "a cosine and a sine can be given where the only input is the bare angle of a crank"
    )]
    IsDrivenByOneAngle

    /// An output asks for an effort or a reaction.
    #[diagnostic::on_unimplemented(
        message = "this mechanism has no forces: none of its outputs asks for one",
        label = "there are no forces",
        note = "declare what has mass or acts, and ask: `mass 2kg on BC uniform;`, `output AB.drive;`"
    )]
    HasForces

    /// Every input moves a mass, and no input is searched for.
    #[diagnostic::on_unimplemented(
        message = "this mechanism has no equations of motion: they need a mass that each input moves",
        label = "an input moves no mass, or there is an `unknown`",
        note = "declare what has mass: `mass 2kg on BC uniform;`; beside an `unknown` there are none"
    )]
    MovesMasses

    /// The outputs ask for the energy.
    #[diagnostic::on_unimplemented(
        message = "this mechanism has no `energy`: none of its outputs asks for it",
        label = "there is no energy",
        note = "declare what has mass, and ask: `mass 2kg on BC uniform;`, `output energy;`"
    )]
    HasEnergy

    /// One input moves joints with friction.
    #[diagnostic::on_unimplemented(
        message = "this mechanism has no `holding`: it gives the drives of one input between which friction holds",
        label = "there are several inputs, or no friction",
        note = "declare `friction 0.1 at C radius 8mm;`; of several inputs, `statics` takes the direction of impending motion of each"
    )]
    HoldsOneInput

    /// Accelerations by themselves.
    #[diagnostic::on_unimplemented(
        message = "there is no `acceleration`: `motion` gives it, with position and velocity",
        label = "write `motion` in place of `acceleration`",
        note = "as in `solver.motion(q, rate, acceleration)?.acceleration`"
    )]
    GivesAccelerationsAlone

    /// A tracker follows motions; the solver that it holds knows forces.
    #[diagnostic::on_unimplemented(
        message = "a tracker has no method of this name; ask its solver, on the branch that it follows",
        label = "give this to `follow`",
        note = "as in `tracker.follow(q, rate, |solver, q| solver.forces(q, rate, acceleration))`"
    )]
    IsFollowed
}

#[cfg(not(feature = "ad"))]
conditions! {
    /// The feature `ad` is on.
    #[diagnostic::on_unimplemented(
        message = "this needs the feature `ad` of `linkage-core`",
        label = "differentiates automatically",
        note = "without the feature, `coefficients` has the derivatives by the inputs"
    )]
    HasDualNumbers
}

#[cfg(not(feature = "sketch"))]
conditions! {
    /// The feature `sketch` is on.
    #[diagnostic::on_unimplemented(
        message = "this needs the feature `sketch` of `linkage-core`",
        label = "draws the mechanism",
        note = "enable it where Cargo.toml names `linkage-core`: `features = [\"sketch\"]`"
    )]
    HasDrawings
}

#[cfg(not(feature = "page"))]
conditions! {
    /// The feature `page` is on.
    #[diagnostic::on_unimplemented(
        message = "this needs the feature `page` of `linkage-core`",
        label = "writes a page on which the mechanism is dragged",
        note = "enable it where Cargo.toml names `linkage-core`: `features = [\"page\"]`"
    )]
    HasPages
}

/// Methods that no solver has, each under a condition. Editors offer none of them: what is hidden in
/// the documentation of another crate is hidden in completions.
macro_rules! absent {
    ($($(#[$attribute:meta])* $method:ident($($given:ident),*): $condition:ident;)*) => {$(
        $(#[$attribute])*
        #[doc(hidden)]
        fn $method<$($given),*>(&self, $(_: $given),*) -> <Self as $condition>::Answer
        where
            Self: $condition,
        {
            <Self as $condition>::answer(self)
        }
    )*};
}

/// A trait of all that a solver may not offer; its calls take what `Loads` stands for behind the rest.
macro_rules! of_what_may_be_absent {
    ($(#[$documented:meta])* $name:ident, $($loads:ident)?) => {
        $(#[$documented])*
        #[doc(hidden)]
        pub trait $name {
            absent! {
                margins(Q): HasMargins;
                position_at(C, S): IsDrivenByOneAngle;
                velocity_at(C, S, V): IsDrivenByOneAngle;
                motion_at(C, S, V, A): IsDrivenByOneAngle;
                forces(Q, V, A $(, $loads)?): HasForces;
                statics(Q $(, $loads)?): HasForces;
                forward_dynamics(Q, V, D $(, $loads)?): MovesMasses;
                equations_of_motion(Q, V $(, $loads)?): MovesMasses;
                state_rates(S, D $(, $loads)?): MovesMasses;
                energy(Q, V): HasEnergy;
                holding(Q $(, $loads)?): HoldsOneInput;
                acceleration(Q, V, A): GivesAccelerationsAlone;
                #[cfg(feature = "ad")]
                sensitivity(Q): HasParameters;
                #[cfg(not(feature = "ad"))]
                sensitivity(Q): HasDualNumbers;
                #[cfg(not(feature = "ad"))]
                jacobian(Q): HasDualNumbers;
                #[cfg(not(feature = "sketch"))]
                sketch(Q): HasDrawings;
                #[cfg(not(feature = "sketch"))]
                film(P): HasDrawings;
                #[cfg(not(feature = "page"))]
                page(): HasPages;
            }
        }

        impl<M: crate::Mechanism> $name for M {}
    };
}

of_what_may_be_absent! {
    /// Calls that a solver may not offer. An inherent method of the solver takes precedence over them.
    Absent,
}

of_what_may_be_absent! {
    /// The same of a solver with loads, whose calls about forces take one argument more.
    AbsentUnderLoads, L
}

/// Calls that a tracker leaves to its solver. The condition is one of the input: one of the tracker would hide the method.
macro_rules! left_to_the_solver {
    ($($method:ident($($given:ident),*))*) => {
        impl<M: crate::private::Solver> crate::Tracker<M> {$(
            #[doc(hidden)]
            pub fn $method<Q: IsFollowed, $($given),*>(&self, q: Q, $(_: $given),*) -> Q::Answer {
                q.answer()
            }
        )*}
    };
}

left_to_the_solver! {
    forces(V, A)
    statics()
    forward_dynamics(V, D)
    state_rates(D)
    energy(V)
}
