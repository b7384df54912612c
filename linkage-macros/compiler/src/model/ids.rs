//! Ids of what a mechanism is made of: indices into its lists, a type for each.

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub struct $name(pub u32);

        impl $name {
            pub fn index(self) -> usize {
                self.0 as usize
            }
        }
    )*};
}

ids! {
    /// An index into `Mechanism::inputs`.
    InputId
    /// An index into `Mechanism::params`.
    ParamId
    /// An index into `Mechanism::lets`.
    LetId
    /// An index into `Mechanism::points`.
    PointId
    /// An index into `Mechanism::links`.
    LinkId
    /// An index into `Mechanism::guides`.
    GuideId
    /// An index into `Mechanism::groups`.
    GroupId
    /// An index into `Mechanism::unknowns`.
    UnknownId
    /// An index into `Mechanism::tracked`.
    TrackedId
    /// An index into `Dynamics::loads`.
    LoadId
    /// An index into `Dynamics::laws`.
    LawId
    /// An index into `Dynamics::formulas`.
    FormulaId
    /// An index into `Dynamics::springs`.
    SpringId
    /// An index into `Dynamics::stops`.
    StopId
}
