//! Why a call does not compile: what a solver does not offer, and what was given in another form.
//!
//! The traits of this module are conditions that nothing fulfils, or that only the right argument
//! does. All they are for is what the compiler says where they are not met.

/// What a solver takes for several inputs, or for several loads, as one argument: an array in the
/// order of their declaration, or the record `R` with a field for each.
#[diagnostic::on_unimplemented(
    message = "the numbers of `{R}` are one argument, and `{Self}` is not all of them",
    label = "write an array, as in `[a, b]`, or the record",
    note = "the array has a number for every field of the record, in the order of the declaration"
)]
pub trait Inputs<R>: Into<R> {}

#[diagnostic::do_not_recommend]
impl<A: Into<R>, R> Inputs<R> for A {}

/// Of every type the type itself alone.
#[diagnostic::on_unimplemented(
    message = "`new` makes a solver in `f64`; write `default` for one in `{T}`",
    label = "write `default()` in place of `new()`"
)]
pub trait Is<T> {}

impl<T> Is<T> for T {}

/// Conditions that no solver fulfils: one for each reason why something is not offered.
macro_rules! conditions {
    ($($(#[$attribute:meta])* $condition:ident)*) => {$(
        $(#[$attribute])*
        pub trait $condition {
            /// What the call would give.
            type Answer;
            /// What there is none of.
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

/// What a solver may not offer. Where it does, it has a method of its own, which comes first.
#[doc(hidden)]
pub trait Absent {
    /// See [`HasMargins`].
    fn margins<Q>(&self, _: Q) -> Self::Answer
    where
        Self: HasMargins,
    {
        self.answer()
    }

    /// See [`HasParameters`].
    #[cfg(feature = "ad")]
    fn sensitivity<Q>(&self, _: Q) -> Self::Answer
    where
        Self: HasParameters,
    {
        self.answer()
    }

    /// See [`HasDualNumbers`].
    #[cfg(not(feature = "ad"))]
    fn sensitivity<Q>(&self, _: Q) -> Self::Answer
    where
        Self: HasDualNumbers,
    {
        self.answer()
    }

    /// See [`HasDualNumbers`].
    #[cfg(not(feature = "ad"))]
    fn jacobian<Q>(&self, _: Q) -> Self::Answer
    where
        Self: HasDualNumbers,
    {
        self.answer()
    }

    /// See [`IsDrivenByOneAngle`].
    fn position_at<Q>(&self, _: Q, _: Q) -> Self::Answer
    where
        Self: IsDrivenByOneAngle,
    {
        self.answer()
    }

    /// See [`IsDrivenByOneAngle`].
    fn velocity_at<Q, V>(&self, _: Q, _: Q, _: V) -> Self::Answer
    where
        Self: IsDrivenByOneAngle,
    {
        self.answer()
    }

    /// See [`IsDrivenByOneAngle`].
    fn motion_at<Q, V, A>(&self, _: Q, _: Q, _: V, _: A) -> Self::Answer
    where
        Self: IsDrivenByOneAngle,
    {
        self.answer()
    }

    /// See [`HasForces`].
    fn forces<Q, V, A>(&self, _: Q, _: V, _: A) -> Self::Answer
    where
        Self: HasForces,
    {
        self.answer()
    }

    /// See [`HasForces`].
    fn statics<Q>(&self, _: Q) -> Self::Answer
    where
        Self: HasForces,
    {
        self.answer()
    }

    /// See [`MovesMasses`].
    fn forward_dynamics<Q, V, D>(&self, _: Q, _: V, _: D) -> Self::Answer
    where
        Self: MovesMasses,
    {
        self.answer()
    }

    /// See [`MovesMasses`].
    fn equations_of_motion<Q, V>(&self, _: Q, _: V) -> Self::Answer
    where
        Self: MovesMasses,
    {
        self.answer()
    }

    /// See [`MovesMasses`].
    fn state_rates<S, D>(&self, _: S, _: D) -> Self::Answer
    where
        Self: MovesMasses,
    {
        self.answer()
    }

    /// See [`HasEnergy`].
    fn energy<Q, V>(&self, _: Q, _: V) -> Self::Answer
    where
        Self: HasEnergy,
    {
        self.answer()
    }
}

impl<M: crate::Mechanism> Absent for M {}
