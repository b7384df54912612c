//! The four-bar of `four_bar.rs` with the code that `mechanism!` makes of its declaration in place
//! of the declaration: the same table, to the last bit.
//!
//! A test holds the code to what the macro makes, and
//! `LINKAGE_EXPAND=1 cargo test -p linkage-compiler expanded` writes it anew.

#![allow(unused_qualifications, reason = "generated code relies on no prelude")]

// Laid out by the test that writes it.
#[rustfmt::skip]
#[allow(dead_code, unreachable_pub, unused_imports, reason = "this program calls little of it")]
mod expanded {
// What `mechanism!` makes of the declaration.

#[allow(
    dead_code,
    non_snake_case,
    clippy::derive_partial_eq_without_eq,
    reason = "names are as declared, and results are there to choose from"
)]
mod FourBar_ {
    use ::linkage_core::private;
    #[allow(clippy::wildcard_imports, reason = "what is generated knows what it names")]
    use private::names::*;
    #[doc(hidden)]
    pub use private::Absent as _;
    /// A crank-rocker of 12, 4, 10 and 7 inches.
    ///
    /// Solver of position, velocity and acceleration in closed form.
    ///
    /// # Inputs
    /// - `theta` in rad
    ///
    /// # Outputs
    /// - Link `AB` (crank AB): unit direction, counter-clockwise from +x
    /// - Point `B` (crank AB): coordinates in m
    /// - Link `BC` (rrr BC, DC): unit direction, counter-clockwise from +x
    /// - Link `DC` (rrr BC, DC): unit direction, counter-clockwise from +x
    /// - Point `C` (rrr BC, DC): coordinates in m
    ///
    /// # Groups, in the order they are solved
    /// - crank AB: length 101.6 mm, angle `theta`
    /// - rrr BC, DC: lengths 254 mm and 177.8 mm, `C` on the left seen from `B` to `D`; assembles
    ///   while |BD| is from 76.2 mm to 431.8 mm
    ///
    /// # Range
    /// - rrr BC, DC: `AB` turns fully; |BD| runs from 0.2032 m to 0.4064 m, and the bars reach from
    ///   0.0762 m to 0.4318 m
    ///
    /// # Cost of one call
    /// - `position`: 10 additions, 15 multiplications, 1 division, 1 square root and 1 sine-cosine
    ///   pair
    /// - `velocity`: 10 additions, 22 multiplications, 2 divisions, 1 square root and 1 sine-cosine
    ///   pair
    /// - `motion`: 26 additions, 49 multiplications, 2 divisions, 1 square root and 1 sine-cosine
    ///   pair
    /// - `coefficients`: 10 additions, 19 multiplications, 2 divisions, 1 square root and 1
    ///   sine-cosine pair
    /// - `position_at`: 10 additions, 15 multiplications, 1 division and 1 square root
    /// - `velocity_at`: 10 additions, 22 multiplications, 2 divisions and 1 square root
    /// - `motion_at`: 26 additions, 49 multiplications, 2 divisions and 1 square root
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FourBar<T = f64> {
        #[doc(hidden)]
        pub use_new_: PhantomData<T>,
    }

    /// Positions of the outputs of [`FourBar`], in metres and radians.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FourBarPosition<T = f64> {
        /// Link `AB` (crank AB): unit direction, counter-clockwise from +x.
        pub AB: Direction<T>,
        /// Point `B` (crank AB): coordinates in m.
        pub B: Point<T>,
        /// Link `BC` (rrr BC, DC): unit direction, counter-clockwise from +x.
        pub BC: Direction<T>,
        /// Link `DC` (rrr BC, DC): unit direction, counter-clockwise from +x.
        pub DC: Direction<T>,
        /// Point `C` (rrr BC, DC): coordinates in m.
        pub C: Point<T>,
    }

    /// Velocities of the outputs of [`FourBar`], in m/s and rad/s.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FourBarVelocity<T = f64> {
        /// Link `AB` (crank AB): angular velocity in rad/s, counter-clockwise.
        pub AB: AngularVelocity<T>,
        /// Point `B` (crank AB): velocity in m/s.
        pub B: Point<T>,
        /// Link `BC` (rrr BC, DC): angular velocity in rad/s, counter-clockwise.
        pub BC: AngularVelocity<T>,
        /// Link `DC` (rrr BC, DC): angular velocity in rad/s, counter-clockwise.
        pub DC: AngularVelocity<T>,
        /// Point `C` (rrr BC, DC): velocity in m/s.
        pub C: Point<T>,
    }

    /// Accelerations of the outputs of [`FourBar`], in m/s² and rad/s².
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FourBarAcceleration<T = f64> {
        /// Link `AB` (crank AB): angular acceleration in rad/s², counter-clockwise.
        pub AB: AngularAcceleration<T>,
        /// Point `B` (crank AB): acceleration in m/s².
        pub B: Point<T>,
        /// Link `BC` (rrr BC, DC): angular acceleration in rad/s², counter-clockwise.
        pub BC: AngularAcceleration<T>,
        /// Link `DC` (rrr BC, DC): angular acceleration in rad/s², counter-clockwise.
        pub DC: AngularAcceleration<T>,
        /// Point `C` (rrr BC, DC): acceleration in m/s².
        pub C: Point<T>,
    }

    /// Position, velocity and acceleration of the outputs of [`FourBar`].
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct FourBarMotion<T = f64> {
        /// In metres and radians.
        pub position: FourBarPosition<T>,
        /// In m/s and rad/s.
        pub velocity: FourBarVelocity<T>,
        /// In m/s² and rad/s².
        pub acceleration: FourBarAcceleration<T>,
    }

    #[allow(
        clippy::approx_constant,
        reason = "a dimension may be near a constant by chance"
    )]
    const _: () = {
        #[allow(
            unused_imports,
            reason = "a function hides a constant of its name, and no argument"
        )]
        use ::linkage_core::private::{
            argument as cos, argument as out, argument as progress, argument as sin,
            argument as status, argument as theta, argument as theta_acceleration,
            argument as theta_rate,
        };

        impl FourBar<f64> {
            /// The scalar rows of the results, in the order of every list of rows.
            pub const OUTPUTS: [&'static str; 7] = [
                "AB.angle",
                "B.x",
                "B.y",
                "BC.angle",
                "DC.angle",
                "C.x",
                "C.y",
            ];

            /// The inputs, in the order of the columns of Jacobians.
            pub const INPUTS: [&'static str; 1] = ["theta"];

            /// The numeric parameters, in the order of the columns of sensitivities.
            pub const PARAMS: [&'static str; 0] = [];

            /// The floating-point operations of one call.
            pub const COST: Cost = Cost {
                position: Operations {
                    additions: 10,
                    multiplications: 15,
                    divisions: 1,
                    roots: 1,
                    sines: 1,
                },
                motion: Operations {
                    additions: 26,
                    multiplications: 49,
                    divisions: 2,
                    roots: 1,
                    sines: 1,
                },
                coefficients: Operations {
                    additions: 10,
                    multiplications: 19,
                    divisions: 2,
                    roots: 1,
                    sines: 1,
                },
            };
        }

        impl<T> FourBar<T> {
            /// The solver with all parameters at their declared values, in `f64`.
            #[inline]
            #[must_use]
            pub const fn new() -> FourBar<f64>
            where
                f64: private::SameAs<T>,
            {
                FourBar { use_new_: PhantomData }
            }
        }

        impl<T: Scalar> Default for FourBar<T> {
            /// The solver with all parameters at their declared values, rounded once.
            #[inline]
            fn default() -> Self {
                Self { use_new_: PhantomData }
            }
        }

        impl<T: Real> FourBar<T> {
            /// The same solver on other numbers, the parameters without derivatives.
            #[inline]
            #[must_use]
            pub fn lift<U: Scalar>(&self) -> FourBar<U> {
                FourBar { use_new_: PhantomData }
            }
        }

        impl<T> Record for FourBarPosition<T> {
            type Number = T;
            type Array = [T; 10];

            const LABELS: &'static [&'static str] = &[
                "AB.angle",
                "AB.angle",
                "B.x",
                "B.y",
                "BC.angle",
                "BC.angle",
                "DC.angle",
                "DC.angle",
                "C.x",
                "C.y",
            ];

            #[inline(always)]
            fn into_array(self) -> [T; 10] {
                [
                    self.AB.cos,
                    self.AB.sin,
                    self.B.x,
                    self.B.y,
                    self.BC.cos,
                    self.BC.sin,
                    self.DC.cos,
                    self.DC.sin,
                    self.C.x,
                    self.C.y,
                ]
            }

            #[inline]
            fn from_array(
                [n0_,
                n1_,
                n2_,
                n3_,
                n4_,
                n5_,
                n6_,
                n7_,
                n8_,
                n9_,
                ]: [T; 10],
            ) -> Self {
                FourBarPosition {
                    AB: Direction { cos: n0_, sin: n1_ },
                    B: Point { x: n2_, y: n3_ },
                    BC: Direction { cos: n4_, sin: n5_ },
                    DC: Direction { cos: n6_, sin: n7_ },
                    C: Point { x: n8_, y: n9_ },
                }
            }
        }

        impl<T> Record for FourBarVelocity<T> {
            type Number = T;
            type Array = [T; 7];

            const LABELS: &'static [&'static str] = &[
                "AB.omega",
                "velocity of B.x",
                "velocity of B.y",
                "BC.omega",
                "DC.omega",
                "velocity of C.x",
                "velocity of C.y",
            ];

            #[inline(always)]
            fn into_array(self) -> [T; 7] {
                [
                    self.AB.omega,
                    self.B.x,
                    self.B.y,
                    self.BC.omega,
                    self.DC.omega,
                    self.C.x,
                    self.C.y,
                ]
            }

            #[inline]
            fn from_array([n0_, n1_, n2_, n3_, n4_, n5_, n6_]: [T; 7]) -> Self {
                FourBarVelocity {
                    AB: AngularVelocity { omega: n0_ },
                    B: Point { x: n1_, y: n2_ },
                    BC: AngularVelocity { omega: n3_ },
                    DC: AngularVelocity { omega: n4_ },
                    C: Point { x: n5_, y: n6_ },
                }
            }
        }

        impl<T> Record for FourBarAcceleration<T> {
            type Number = T;
            type Array = [T; 7];

            const LABELS: &'static [&'static str] = &[
                "AB.alpha",
                "acceleration of B.x",
                "acceleration of B.y",
                "BC.alpha",
                "DC.alpha",
                "acceleration of C.x",
                "acceleration of C.y",
            ];

            #[inline(always)]
            fn into_array(self) -> [T; 7] {
                [
                    self.AB.alpha,
                    self.B.x,
                    self.B.y,
                    self.BC.alpha,
                    self.DC.alpha,
                    self.C.x,
                    self.C.y,
                ]
            }

            #[inline]
            fn from_array([n0_, n1_, n2_, n3_, n4_, n5_, n6_]: [T; 7]) -> Self {
                FourBarAcceleration {
                    AB: AngularAcceleration { alpha: n0_ },
                    B: Point { x: n1_, y: n2_ },
                    BC: AngularAcceleration { alpha: n3_ },
                    DC: AngularAcceleration { alpha: n4_ },
                    C: Point { x: n5_, y: n6_ },
                }
            }
        }

        impl<T> Record for FourBarMotion<T> {
            type Number = T;
            type Array = [T; 24];

            const LABELS: &'static [&'static str] = &[
                "AB.angle",
                "AB.angle",
                "B.x",
                "B.y",
                "BC.angle",
                "BC.angle",
                "DC.angle",
                "DC.angle",
                "C.x",
                "C.y",
                "AB.omega",
                "velocity of B.x",
                "velocity of B.y",
                "BC.omega",
                "DC.omega",
                "velocity of C.x",
                "velocity of C.y",
                "AB.alpha",
                "acceleration of B.x",
                "acceleration of B.y",
                "BC.alpha",
                "DC.alpha",
                "acceleration of C.x",
                "acceleration of C.y",
            ];

            #[inline(always)]
            fn into_array(self) -> [T; 24] {
                private::joined(
                    Record::into_array(self.position),
                    Record::into_array(self.velocity),
                    Record::into_array(self.acceleration),
                )
            }

            #[inline]
            fn from_array(list_: [T; 24]) -> Self {
                let [position_ @ .., _, _, _, _, _, _, _, _, _, _, _, _, _, _] = list_;
                let [_, _, _, _, _, _, _, _, _, _, velocity_ @ .., _, _, _, _, _, _, _,
                ] = list_;
                let [_, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _, _,
                acceleration_ @ ..] = list_;
                Self {
                    position: Record::from_array(position_),
                    velocity: Record::from_array(velocity_),
                    acceleration: Record::from_array(acceleration_),
                }
            }
        }

        impl<T: Scalar> FourBarPosition<T> {
            /// The rows in the order of `OUTPUTS`; a direction's row is its angle in (−π, π].
            #[inline]
            #[must_use]
            pub fn rows(&self) -> [T; 7] {
                [
                    self.AB.angle(),
                    self.B.x,
                    self.B.y,
                    self.BC.angle(),
                    self.DC.angle(),
                    self.C.x,
                    self.C.y,
                ]
            }
        }

        impl<T: Scalar> FourBarVelocity<T> {
            /// The rows in the order of `OUTPUTS`; a direction's row is ω.
            #[inline]
            #[must_use]
            pub fn rows(&self) -> [T; 7] {
                Record::into_array(*self)
            }
        }

        impl<T: Scalar> FourBarAcceleration<T> {
            /// The rows in the order of `OUTPUTS`; a direction's row is α.
            #[inline]
            #[must_use]
            pub fn rows(&self) -> [T; 7] {
                Record::into_array(*self)
            }
        }

        impl<T: Scalar> FourBar<T> {
            /// Positions of the outputs, without a branch, and whether they may be used.
            ///
            /// Given `theta` in rad.
            ///
            /// Where the mask says no, the numbers mean nothing. Costs 10 additions, 15 multiplications, 1
            /// division, 1 square root and 1 sine-cosine pair.
            #[inline(always)]
            #[must_use]
            pub fn solve_position(&self, theta: T) -> (FourBarPosition<T>, T::Mask) {
                let (sin_, cos_) = T::sin_cos_near(theta);
                let (result_, ok_) = self.core_position_at_(cos_, sin_);
                (result_, T::is_near(theta) & ok_)
            }

            /// Velocities of the outputs, without a branch, and whether they may be used.
            ///
            /// Given `theta` in rad, its rate in rad/s.
            ///
            /// Where the mask says no, the numbers mean nothing. Costs 10 additions, 22 multiplications, 2
            /// divisions, 1 square root and 1 sine-cosine pair.
            #[inline(always)]
            #[must_use]
            pub fn solve_velocity(
                &self,
                theta: T,
                theta_rate: T,
            ) -> (FourBarVelocity<T>, T::Mask) {
                let (sin_, cos_) = T::sin_cos_near(theta);
                self.core_velocity_at_(cos_, sin_, theta_rate, theta * theta)
            }

            /// Positions, velocities and accelerations of the outputs, without a branch, and whether they
            /// may be used.
            ///
            /// Given `theta` in rad, its rate in rad/s, its second rate in rad/s².
            ///
            /// Where the mask says no, the numbers mean nothing. Costs 26 additions, 49 multiplications, 2
            /// divisions, 1 square root and 1 sine-cosine pair.
            #[inline(always)]
            #[must_use]
            pub fn solve_motion(
                &self,
                theta: T,
                theta_rate: T,
                theta_acceleration: T,
            ) -> (FourBarMotion<T>, T::Mask) {
                let (sin_, cos_) = T::sin_cos_near(theta);
                self.core_motion_at_(
                    cos_,
                    sin_,
                    theta_rate,
                    theta_acceleration,
                    theta * theta,
                )
            }

            /// Kinematic coefficients ∂outputs/∂inputs, without a branch, and whether they may be used.
            ///
            /// Given `theta` in rad.
            /// A row an output in the order of `OUTPUTS`, a column an input in the order of `INPUTS`; from
            /// the velocity equations.
            ///
            /// Where the mask says no, the numbers mean nothing. Costs 10 additions, 19 multiplications, 2
            /// divisions, 1 square root and 1 sine-cosine pair.
            #[inline(always)]
            #[must_use]
            pub fn solve_coefficients(&self, theta: T) -> ([[T; 1]; 7], T::Mask) {
                let (result_, ok_) = self.solve_velocity(theta, T::num(1.0));
                (private::column(result_.rows()), ok_)
            }

            /// Positions of the outputs, without a branch, and whether they may be used.
            ///
            /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1).
            ///
            /// Where the mask says no, the numbers mean nothing. Costs 10 additions, 15 multiplications, 1
            /// division and 1 square root.
            #[inline(always)]
            #[must_use]
            pub fn solve_position_at(
                &self,
                cos: T,
                sin: T,
            ) -> (FourBarPosition<T>, T::Mask) {
                let (cos_, sin_, near_) = private::on_circle(cos, sin);
                let (result_, ok_) = self.core_position_at_(cos_, sin_);
                (result_, ok_ & near_)
            }

            #[inline(always)]
            fn core_position_at_(
                &self,
                cos: T,
                sin: T,
            ) -> (FourBarPosition<T>, T::Mask) {
                let mut all_met_ = AllMet::new();
                let result_ = self
                    .formulas_at_::<0>(&mut all_met_, cos, sin, T::num(0.0), T::num(0.0))
                    .position;
                (
                    result_,
                    all_met_.all()
                        & private::is_finite_unless(
                            T::plain(true, true),
                            ((result_.B.x + result_.DC.cos) + result_.DC.sin)
                                + ((result_.BC.cos + result_.BC.sin) + result_.C.x),
                        ),
                )
            }

            /// Velocities of the outputs, without a branch, and whether they may be used.
            ///
            /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1), its rate in rad/s.
            ///
            /// Where the mask says no, the numbers mean nothing. Costs 10 additions, 22 multiplications, 2
            /// divisions and 1 square root.
            #[inline(always)]
            #[must_use]
            pub fn solve_velocity_at(
                &self,
                cos: T,
                sin: T,
                theta_rate: T,
            ) -> (FourBarVelocity<T>, T::Mask) {
                let (cos_, sin_, near_) = private::on_circle(cos, sin);
                let (result_, ok_) = self
                    .core_velocity_at_(cos_, sin_, theta_rate, T::num(-0.0));
                (result_, ok_ & near_)
            }

            #[inline(always)]
            fn core_velocity_at_(
                &self,
                cos: T,
                sin: T,
                theta_rate: T,
                square_: T,
            ) -> (FourBarVelocity<T>, T::Mask) {
                let mut all_met_ = AllMet::new();
                let result_ = self
                    .formulas_at_::<1>(&mut all_met_, cos, sin, theta_rate, T::num(0.0))
                    .velocity;
                (
                    result_,
                    all_met_.all()
                        & T::ge(
                            T::lit(1099511627776.0, 2649263900.0),
                            T::fused(theta_rate, theta_rate, square_),
                        )
                        & private::is_finite_unless(
                            T::plain(true, true),
                            ((result_.B.x + result_.B.y) + result_.BC.omega)
                                + (result_.C.x + result_.C.y),
                        ),
                )
            }

            /// Positions, velocities and accelerations of the outputs, without a branch, and whether they
            /// may be used.
            ///
            /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1), its rate in rad/s, its
            /// second rate in rad/s².
            ///
            /// Where the mask says no, the numbers mean nothing. Costs 26 additions, 49 multiplications, 2
            /// divisions and 1 square root.
            #[inline(always)]
            #[must_use]
            pub fn solve_motion_at(
                &self,
                cos: T,
                sin: T,
                theta_rate: T,
                theta_acceleration: T,
            ) -> (FourBarMotion<T>, T::Mask) {
                let (cos_, sin_, near_) = private::on_circle(cos, sin);
                let (result_, ok_) = self
                    .core_motion_at_(
                        cos_,
                        sin_,
                        theta_rate,
                        theta_acceleration,
                        T::num(-0.0),
                    );
                (result_, ok_ & near_)
            }

            #[inline(always)]
            fn core_motion_at_(
                &self,
                cos: T,
                sin: T,
                theta_rate: T,
                theta_acceleration: T,
                square_: T,
            ) -> (FourBarMotion<T>, T::Mask) {
                let mut all_met_ = AllMet::new();
                let result_ = self
                    .formulas_at_::<
                        2,
                    >(&mut all_met_, cos, sin, theta_rate, theta_acceleration);
                (
                    result_,
                    all_met_.all()
                        & T::ge(
                            T::lit(1.2089258196146292e24, 7.018599e18),
                            T::fused(
                                T::fused(theta_rate, theta_rate, square_),
                                T::fused(theta_rate, theta_rate, square_),
                                theta_acceleration * theta_acceleration,
                            ),
                        )
                        & private::is_finite_unless(
                            T::plain(true, true),
                            (((result_.velocity.B.x + result_.velocity.B.y)
                                + (result_.acceleration.B.x + result_.acceleration.B.y))
                                + ((result_.velocity.BC.omega
                                    + result_.acceleration.BC.alpha)
                                    + (result_.position.DC.cos + result_.position.DC.sin)))
                                + (((result_.velocity.C.x + result_.velocity.C.y)
                                    + (result_.acceleration.C.x + result_.acceleration.C.y))
                                    + ((result_.position.BC.cos + result_.position.BC.sin)
                                        + result_.position.C.x)),
                        ),
                )
            }

            #[inline(always)]
            fn formulas_at_<const ORDER: usize>(
                &self,
                checks_: &mut impl Checks<T>,
                cos: T,
                sin: T,
                theta_rate: T,
                theta_acceleration: T,
            ) -> FourBarMotion<T> {
                let k0_ = T::num(0.06193536);
                let k1_ = T::num(5.535725357165);
                let k2_ = T::num(0.1016);
                let k3_ = T::num(0.3048);
                let k4_ = T::num(0.254);
                let k5_ = T::num(0.1778);
                let k6_ = T::num(1.0);
                let k7_ = T::num(0.03096768);
                let k8_ = T::num(0.008420361739888);
                let k9_ = T::num(5.62429696287964);
                let k10_ = T::num(3.937007874015748);
                let zero_ = T::num(0.0);
                let velocity_: FourBarVelocity<T> = Record::from_array([zero_; 7]);
                let acceleration_: FourBarAcceleration<T> = Record::from_array(
                    [zero_; 7],
                );
                if ORDER == 3 {
                    let v131_ = T::fused(-k0_, cos, T::num(0.09741916));
                    let v133_ = T::num(0.1806448) - v131_;
                    let v136_ = (k1_ * v131_) * (k1_ * v133_);
                    checks_.clearances(&[[v136_, T::num(0.5517857142857143)]]);
                    return Record::from_array([zero_; 24]);
                }
                let b_x_ = k2_ * cos;
                let b_y_ = k2_ * sin;
                let bc_dc_d_x_ = T::fused(-k2_, cos, k3_);
                let v34_ = T::fused(-k0_, cos, T::num(0.1032256));
                let bc_dc_d2_ = checks_
                    .guard(
                        v34_,
                        private::SquareOfCentres([bc_dc_d_x_, -b_y_, k4_, k5_], "BC, DC"),
                    );
                let bc_dc_inverse_d2_ = k6_ / bc_dc_d2_;
                let bc_dc_i_half_ = T::fused(-k7_, cos, T::num(0.04870958));
                let v44_ = bc_dc_i_half_ * T::fused(k7_, cos, T::num(0.04161282));
                let bc_dc_j2_ = checks_
                    .guard(
                        v44_,
                        private::ReachCircles(
                            [bc_dc_d_x_, -b_y_, k4_, k5_, T::num(0.0903224), k8_],
                            "BC, DC",
                        ),
                    );
                let bc_dc_j_ = T::sqrt(bc_dc_j2_);
                let bc_dc_h_ = bc_dc_inverse_d2_ * bc_dc_j_;
                let bc_dc_b_d2_ = bc_dc_i_half_ - T::num(0.01354836);
                let v54_ = bc_dc_inverse_d2_ * bc_dc_b_d2_;
                let bc_dc_b_ = checks_
                    .guard(
                        v54_,
                        private::ShareOfCentres(
                            [v44_, bc_dc_d_x_, -b_y_, k5_, k4_, k8_],
                            "BC, DC",
                        ),
                    );
                let v56_ = b_y_ * bc_dc_h_;
                let v57_ = bc_dc_d_x_ * bc_dc_h_;
                let bc_dc_r3_x_ = T::fused(-bc_dc_d_x_, bc_dc_b_, v56_);
                let c_y_ = T::fused(b_y_, bc_dc_b_, v57_);
                let bc_dc_r2_x_ = bc_dc_d_x_ + bc_dc_r3_x_;
                let bc_dc_r2_y_ = c_y_ - b_y_;
                let dc_cos_ = k9_ * bc_dc_r3_x_;
                let dc_sin_ = k9_ * c_y_;
                let bc_cos_ = k10_ * bc_dc_r2_x_;
                let bc_sin_ = k10_ * bc_dc_r2_y_;
                let c_x_ = k3_ + bc_dc_r3_x_;
                let position_ = FourBarPosition {
                    AB: Direction { cos, sin },
                    B: Point { x: b_x_, y: b_y_ },
                    BC: Direction {
                        cos: bc_cos_,
                        sin: bc_sin_,
                    },
                    DC: Direction {
                        cos: dc_cos_,
                        sin: dc_sin_,
                    },
                    C: Point { x: c_x_, y: c_y_ },
                };
                if ORDER == 0 {
                    return FourBarMotion {
                        position: position_,
                        velocity: velocity_,
                        acceleration: acceleration_,
                    };
                }
                let b_vx_ = -(theta_rate * b_y_);
                let b_vy_ = theta_rate * b_x_;
                let v29_ = k7_ * sin;
                let v48_ = checks_.guard(bc_dc_j2_, private::Nonzero("BC, DC"));
                let bc_dc_inverse_j_ = bc_dc_j_ * (k6_ / v48_);
                let v68_ = T::fused(k7_, cos, -T::num(0.01032256));
                let v76_ = T::fused(v29_, bc_dc_b_, bc_dc_h_ * v68_);
                let v77_ = v29_ - v76_;
                let v78_ = theta_rate * bc_dc_inverse_j_;
                let v79_ = v76_ * v78_;
                let bc_omega_ = -v79_;
                let dc_omega_ = v77_ * v78_;
                let c_vx_ = -(c_y_ * dc_omega_);
                let c_vy_ = bc_dc_r3_x_ * dc_omega_;
                let velocity_ = FourBarVelocity {
                    AB: AngularVelocity {
                        omega: theta_rate,
                    },
                    B: Point { x: b_vx_, y: b_vy_ },
                    BC: AngularVelocity {
                        omega: bc_omega_,
                    },
                    DC: AngularVelocity {
                        omega: dc_omega_,
                    },
                    C: Point { x: c_vx_, y: c_vy_ },
                };
                if ORDER == 1 {
                    return FourBarMotion {
                        position: position_,
                        velocity: velocity_,
                        acceleration: acceleration_,
                    };
                }
                let v13_ = theta_acceleration * b_y_;
                let v14_ = theta_acceleration * b_x_;
                let v15_ = theta_rate * theta_rate;
                let b_ax_ = T::fused(-b_x_, v15_, -v13_);
                let b_ay_ = T::fused(-b_y_, v15_, v14_);
                let v72_ = T::fused(-bc_dc_b_, v68_, v29_ * bc_dc_h_);
                let v73_ = v68_ + v72_;
                let v85_ = T::fused(-theta_acceleration, v76_, v15_ * v72_);
                let v88_ = T::fused(theta_acceleration, v77_, v15_ * v73_);
                let bc_dc_r2_r3_ = T::num(0.0451612) - bc_dc_i_half_;
                let bc_dc_omega2_squared_ = v79_ * v79_;
                let bc_dc_omega3_squared_ = dc_omega_ * dc_omega_;
                let bc_alpha_ = bc_dc_inverse_j_
                    * T::fused(
                        -T::num(0.03161284),
                        bc_dc_omega3_squared_,
                        T::fused(bc_dc_r2_r3_, bc_dc_omega2_squared_, v85_),
                    );
                let dc_alpha_ = bc_dc_inverse_j_
                    * T::fused(
                        -bc_dc_r2_r3_,
                        bc_dc_omega3_squared_,
                        T::fused(T::num(0.064516), bc_dc_omega2_squared_, v88_),
                    );
                let v111_ = bc_dc_r3_x_ * bc_dc_omega3_squared_;
                let v112_ = c_y_ * bc_dc_omega3_squared_;
                let c_ax_ = T::fused(-c_y_, dc_alpha_, -v111_);
                let c_ay_ = T::fused(bc_dc_r3_x_, dc_alpha_, -v112_);
                let acceleration_ = FourBarAcceleration {
                    AB: AngularAcceleration {
                        alpha: theta_acceleration,
                    },
                    B: Point { x: b_ax_, y: b_ay_ },
                    BC: AngularAcceleration {
                        alpha: bc_alpha_,
                    },
                    DC: AngularAcceleration {
                        alpha: dc_alpha_,
                    },
                    C: Point { x: c_ax_, y: c_ay_ },
                };
                FourBarMotion {
                    position: position_,
                    velocity: velocity_,
                    acceleration: acceleration_,
                }
            }
        }

        impl<T: Real> FourBar<T> {
            /// Positions of the outputs.
            ///
            /// Given `theta` in rad.
            ///
            /// Costs 10 additions, 15 multiplications, 1 division, 1 square root and 1 sine-cosine pair.
            ///
            /// # Errors
            /// The group that cannot be assembled, is singular or was given an invalid length, or the input
            /// or result that is not finite.
            #[inline]
            pub fn position(&self, theta: T) -> Result<FourBarPosition<T>, SolveError> {
                let (result_, ok_) = self.solve_position(theta);
                if ok_ {
                    Ok(result_)
                } else {
                    private::apart(
                        private::from_angle(
                            theta,
                            "theta",
                            move |cos_, sin_| self.diagnose_position_at_(cos_, sin_),
                        ),
                        0,
                    )
                }
            }

            /// Velocities of the outputs.
            ///
            /// Given `theta` in rad, its rate in rad/s.
            ///
            /// Costs 10 additions, 22 multiplications, 2 divisions, 1 square root and 1 sine-cosine pair.
            ///
            /// # Errors
            /// The group that cannot be assembled, is singular or was given an invalid length, or the input
            /// or result that is not finite.
            #[inline]
            pub fn velocity(
                &self,
                theta: T,
                theta_rate: T,
            ) -> Result<FourBarVelocity<T>, SolveError> {
                let (result_, ok_) = self.solve_velocity(theta, theta_rate);
                if ok_ {
                    Ok(result_)
                } else {
                    private::apart(
                        private::from_angle(
                            theta,
                            "theta",
                            move |cos_, sin_| {
                                self.diagnose_velocity_at_(cos_, sin_, theta_rate)
                            },
                        ),
                        0,
                    )
                }
            }

            /// Positions, velocities and accelerations of the outputs.
            ///
            /// Given `theta` in rad, its rate in rad/s, its second rate in rad/s².
            ///
            /// Costs 26 additions, 49 multiplications, 2 divisions, 1 square root and 1 sine-cosine pair.
            ///
            /// # Errors
            /// The group that cannot be assembled, is singular or was given an invalid length, or the input
            /// or result that is not finite.
            #[inline]
            pub fn motion(
                &self,
                theta: T,
                theta_rate: T,
                theta_acceleration: T,
            ) -> Result<FourBarMotion<T>, SolveError> {
                let (result_, ok_) = self
                    .solve_motion(theta, theta_rate, theta_acceleration);
                if ok_ {
                    Ok(result_)
                } else {
                    private::apart(
                        private::from_angle(
                            theta,
                            "theta",
                            move |cos_, sin_| {
                                self
                                    .diagnose_motion_at_(
                                        cos_,
                                        sin_,
                                        theta_rate,
                                        theta_acceleration,
                                    )
                            },
                        ),
                        10,
                    )
                }
            }

            /// Kinematic coefficients ∂outputs/∂inputs.
            ///
            /// Given `theta` in rad.
            /// A row an output in the order of `OUTPUTS`, a column an input in the order of `INPUTS`; from
            /// the velocity equations.
            ///
            /// Costs 10 additions, 19 multiplications, 2 divisions, 1 square root and 1 sine-cosine pair.
            ///
            /// # Errors
            /// The group that cannot be assembled, is singular or was given an invalid length, or the input
            /// or result that is not finite. An input that no coefficient depends on is not looked at.
            #[inline]
            pub fn coefficients(&self, theta: T) -> Result<[[T; 1]; 7], SolveError> {
                let (result_, ok_) = self.solve_velocity(theta, T::num(1.0));
                let result_ = if ok_ {
                    result_
                } else {
                    private::apart(
                        private::from_angle(
                            theta,
                            "theta",
                            move |cos_, sin_| {
                                self.diagnose_velocity_at_(cos_, sin_, T::num(1.0))
                            },
                        ),
                        0,
                    )?
                };
                Ok(private::column(result_.rows()))
            }

            /// Positions of the outputs.
            ///
            /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1).
            ///
            /// Costs 10 additions, 15 multiplications, 1 division and 1 square root.
            ///
            /// # Errors
            /// The group that cannot be assembled, is singular or was given an invalid length, or the input
            /// or result that is not finite. `OffCircle` where the amplitude is no resolver's.
            #[inline]
            pub fn position_at(
                &self,
                cos: T,
                sin: T,
            ) -> Result<FourBarPosition<T>, SolveError> {
                let (result_, ok_) = self.solve_position_at(cos, sin);
                if ok_ {
                    Ok(result_)
                } else {
                    private::apart(
                        private::from_circle(
                            cos,
                            sin,
                            "theta",
                            move |cos_, sin_| self.diagnose_position_at_(cos_, sin_),
                        ),
                        0,
                    )
                }
            }

            /// Velocities of the outputs.
            ///
            /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1), its rate in rad/s.
            ///
            /// Costs 10 additions, 22 multiplications, 2 divisions and 1 square root.
            ///
            /// # Errors
            /// The group that cannot be assembled, is singular or was given an invalid length, or the input
            /// or result that is not finite. `OffCircle` where the amplitude is no resolver's.
            #[inline]
            pub fn velocity_at(
                &self,
                cos: T,
                sin: T,
                theta_rate: T,
            ) -> Result<FourBarVelocity<T>, SolveError> {
                let (result_, ok_) = self.solve_velocity_at(cos, sin, theta_rate);
                if ok_ {
                    Ok(result_)
                } else {
                    private::apart(
                        private::from_circle(
                            cos,
                            sin,
                            "theta",
                            move |cos_, sin_| {
                                self.diagnose_velocity_at_(cos_, sin_, theta_rate)
                            },
                        ),
                        0,
                    )
                }
            }

            /// Positions, velocities and accelerations of the outputs.
            ///
            /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1), its rate in rad/s, its
            /// second rate in rad/s².
            ///
            /// Costs 26 additions, 49 multiplications, 2 divisions and 1 square root.
            ///
            /// # Errors
            /// The group that cannot be assembled, is singular or was given an invalid length, or the input
            /// or result that is not finite. `OffCircle` where the amplitude is no resolver's.
            #[inline]
            pub fn motion_at(
                &self,
                cos: T,
                sin: T,
                theta_rate: T,
                theta_acceleration: T,
            ) -> Result<FourBarMotion<T>, SolveError> {
                let (result_, ok_) = self
                    .solve_motion_at(cos, sin, theta_rate, theta_acceleration);
                if ok_ {
                    Ok(result_)
                } else {
                    private::apart(
                        private::from_circle(
                            cos,
                            sin,
                            "theta",
                            move |cos_, sin_| {
                                self
                                    .diagnose_motion_at_(
                                        cos_,
                                        sin_,
                                        theta_rate,
                                        theta_acceleration,
                                    )
                            },
                        ),
                        10,
                    )
                }
            }

            /// Why `solve_position_at` gave no answer, or the answer at a limit.
            #[cold]
            #[inline(never)]
            fn diagnose_position_at_(
                &self,
                cos: T,
                sin: T,
            ) -> Result<FourBarPosition<T>, SolveError> {
                private::diagnose(
                    &[(cos, "cos"), (sin, "sin")],
                    |checks_| {
                        self
                            .formulas_at_::<
                                0,
                            >(checks_, cos, sin, T::num(0.0), T::num(0.0))
                            .position
                    },
                )
            }

            /// Why `solve_velocity_at` gave no answer, or the answer at a limit.
            #[cold]
            #[inline(never)]
            fn diagnose_velocity_at_(
                &self,
                cos: T,
                sin: T,
                theta_rate: T,
            ) -> Result<FourBarVelocity<T>, SolveError> {
                private::diagnose(
                    &[(cos, "cos"), (sin, "sin"), (theta_rate, "theta_rate")],
                    |checks_| {
                        self
                            .formulas_at_::<
                                1,
                            >(checks_, cos, sin, theta_rate, T::num(0.0))
                            .velocity
                    },
                )
            }

            /// Why `solve_motion_at` gave no answer, or the answer at a limit.
            #[cold]
            #[inline(never)]
            fn diagnose_motion_at_(
                &self,
                cos: T,
                sin: T,
                theta_rate: T,
                theta_acceleration: T,
            ) -> Result<FourBarMotion<T>, SolveError> {
                private::diagnose(
                    &[
                        (cos, "cos"),
                        (sin, "sin"),
                        (theta_rate, "theta_rate"),
                        (theta_acceleration, "theta_acceleration"),
                    ],
                    |checks_| {
                        self
                            .formulas_at_::<
                                2,
                            >(checks_, cos, sin, theta_rate, theta_acceleration)
                    },
                )
            }
        }

        impl<T: Float> FourBar<T> {
            /// Positions of the outputs, at many poses.
            ///
            /// Given `theta` in rad. Each is a slice with a number for every pose, or one number for all.
            ///
            /// Every component of the results goes to a slice of its own in `out`, as many long as there
            /// are poses, or empty where it is not wanted; `status` is such a slice too. Where `position`
            /// would be an error, the numbers are NaN and `status` has the error's kind. `progress` is told
            /// how many poses are done, and how many there are, every few thousand poses; `()` tells
            /// nobody.
            ///
            /// # Errors
            /// Two slices are not of one length; nothing was computed.
            pub fn sweep_position<'series>(
                &self,
                theta: impl Into<Series<'series, T>>,
                out: FourBarPosition<&mut [T]>,
                status: &mut [Status],
                progress: impl Progress,
            ) -> Result<(), LengthMismatch> {
                private::sweep::<
                    OfPosition,
                    _,
                    _,
                    1,
                    10,
                >(self, [Into::into(theta)], Record::into_array(out), status, progress)
            }

            /// Velocities of the outputs, at many poses.
            ///
            /// Given `theta` in rad, its rate in rad/s. Each is a slice with a number for every pose, or
            /// one number for all.
            ///
            /// Every component of the results goes to a slice of its own in `out`, as many long as there
            /// are poses, or empty where it is not wanted; `status` is such a slice too. Where `velocity`
            /// would be an error, the numbers are NaN and `status` has the error's kind. `progress` is told
            /// how many poses are done, and how many there are, every few thousand poses; `()` tells
            /// nobody.
            ///
            /// # Errors
            /// Two slices are not of one length; nothing was computed.
            pub fn sweep_velocity<'series>(
                &self,
                theta: impl Into<Series<'series, T>>,
                theta_rate: impl Into<Series<'series, T>>,
                out: FourBarVelocity<&mut [T]>,
                status: &mut [Status],
                progress: impl Progress,
            ) -> Result<(), LengthMismatch> {
                private::sweep::<
                    OfVelocity,
                    _,
                    _,
                    2,
                    7,
                >(
                    self,
                    [Into::into(theta), Into::into(theta_rate)],
                    Record::into_array(out),
                    status,
                    progress,
                )
            }

            /// Positions, velocities and accelerations of the outputs, at many poses.
            ///
            /// Given `theta` in rad, its rate in rad/s, its second rate in rad/s². Each is a slice with a
            /// number for every pose, or one number for all.
            ///
            /// Every component of the results goes to a slice of its own in `out`, as many long as there
            /// are poses, or empty where it is not wanted; `status` is such a slice too. Where `motion`
            /// would be an error, the numbers are NaN and `status` has the error's kind. `progress` is told
            /// how many poses are done, and how many there are, every few thousand poses; `()` tells
            /// nobody.
            ///
            /// # Errors
            /// Two slices are not of one length; nothing was computed.
            pub fn sweep_motion<'series>(
                &self,
                theta: impl Into<Series<'series, T>>,
                theta_rate: impl Into<Series<'series, T>>,
                theta_acceleration: impl Into<Series<'series, T>>,
                out: FourBarMotion<&mut [T]>,
                status: &mut [Status],
                progress: impl Progress,
            ) -> Result<(), LengthMismatch> {
                private::sweep::<
                    OfMotion,
                    _,
                    _,
                    3,
                    24,
                >(
                    self,
                    [
                        Into::into(theta),
                        Into::into(theta_rate),
                        Into::into(theta_acceleration),
                    ],
                    Record::into_array(out),
                    status,
                    progress,
                )
            }
        }
        private::with_ad! {
            impl<T: private::Differentiable> FourBar<T> {
                /// ∂outputs/∂inputs: the `coefficients` as a matrix.
                ///
                /// Rows: `AB.angle`, `B.x`, `B.y`, `BC.angle`, `DC.angle`, `C.x`, `C.y`; columns: `theta`.
                ///
                /// # Errors
                /// Those of `position`; `Singular` where a derivative does not exist. A group that no
                /// coefficient depends on is not looked at.
                pub fn jacobian(&self, theta: T) -> Result<private::SMatrix<T, 7, 1>, SolveError> {
                    private::jacobian(self.coefficients(theta), [theta], || self.lift())
                }
            }
        }

        impl<T: Real> Solver for FourBar<T> {
            type Scalar = T;
            type Input = T;
            type Position = FourBarPosition<T>;
            type Velocity = FourBarVelocity<T>;
            type Motion = FourBarMotion<T>;
            type Rows = [T; 7];
            type Coefficients = [[T; 1]; 7];
            type Groups<X_: Copy> = [X_; 1];

            const TITLES: Titles = Titles {
                name: "FourBar",
                inputs: &FourBar::<f64>::INPUTS,
                outputs: &FourBar::<f64>::OUTPUTS,
                groups: &[("BC, DC", private::None)],
            };

            #[inline]
            fn input(mut number_: impl FnMut(usize) -> T) -> T {
                number_(0)
            }

            #[inline]
            fn position(&self, q_: T) -> Result<FourBarPosition<T>, SolveError> {
                Self::position(self, q_)
            }

            #[inline]
            fn velocity(
                &self,
                q_: T,
                rate_: T,
            ) -> Result<FourBarVelocity<T>, SolveError> {
                Self::velocity(self, q_, rate_)
            }

            #[inline]
            fn motion(
                &self,
                q_: T,
                rate_: T,
                acceleration_: T,
            ) -> Result<FourBarMotion<T>, SolveError> {
                Self::motion(self, q_, rate_, acceleration_)
            }

            #[inline]
            fn coefficients(&self, q_: T) -> Result<[[T; 1]; 7], SolveError> {
                Self::coefficients(self, q_)
            }

            #[inline]
            fn position_rows(record_: Self::Position) -> Self::Rows {
                record_.rows()
            }

            #[inline]
            fn motion_rows(record_: Self::Motion) -> [Self::Rows; 3] {
                [
                    record_.position.rows(),
                    record_.velocity.rows(),
                    record_.acceleration.rows(),
                ]
            }

            #[inline(always)]
            fn solve<const ORDER: usize, U: Scalar>(
                &self,
                given_: impl Fn(usize) -> U,
                put_: impl FnOnce(&[U]),
            ) -> U::Mask {
                let lifted_ = self.lift::<U>();
                match ORDER {
                    0 => private::put_solved(lifted_.solve_position(given_(0)), put_),
                    1 => {
                        private::put_solved(
                            lifted_.solve_velocity(given_(0), given_(1)),
                            put_,
                        )
                    }
                    _ => {
                        private::put_solved(
                            lifted_.solve_motion(given_(0), given_(1), given_(2)),
                            put_,
                        )
                    }
                }
            }

            fn told<U: Real, X_: Copy>(
                &self,
                standing_: impl Fn(T) -> U,
                input_: impl Fn(usize) -> U,
                of_: impl Fn([U; 2]) -> X_,
            ) -> [X_; 1] {
                let _ = standing_;
                let lifted_ = FourBar::<U> {
                    use_new_: PhantomData,
                };
                let (sin_, cos_) = U::sin_cos(input_(0));
                let rest_ = U::num(0.0);
                private::told(|checks_| {
                        lifted_.formulas_at_::<3>(checks_, cos_, sin_, rest_, rest_)
                    })
                    .map(of_)
            }
        }

        #[allow(
            dead_code,
            non_snake_case,
            reason = "names are as declared, and for editors alone"
        )]
        struct Names_ {
            /// `theta`, made by `input theta`.
            theta: (),
            /// `A`, made by `ground A`.
            A: (),
            /// `D`, made by `ground D`.
            D: (),
        }

        #[allow(dead_code, reason = "for editors alone")]
        impl Names_ {
            fn uses_<T>(&self, position_: &FourBarPosition<T>) {
                let _ = (&self.A, &self.theta, &position_.B, &self.D);
            }
        }
    };
}

#[allow(
    unused_imports,
    clippy::wildcard_imports,
    reason = "all that stands in the module"
)]
pub use FourBar_::*;

// The program.
}
use expanded::*;

const OMEGA: f64 = 250.0;

fn main() -> Result<(), linkage_core::SolveError> {
    let bars = FourBar::new();
    println!("Four-bar 304.8 / 101.6 / 254.0 / 177.8 mm at {OMEGA} rad/s\n");
    println!("crank  coupler   rocker  coupler ω  rocker ω  coupler α   rocker α");
    println!("  deg      deg      deg      rad/s     rad/s     rad/s²     rad/s²");
    for step in 0..=72 {
        let degrees = f64::from(step) * 5.0;
        let m = bars.motion(degrees.to_radians(), OMEGA, 0.0)?;
        let [coupler, rocker] =
            [m.position.BC, m.position.DC].map(|link| link.angle().to_degrees());
        let (w3, w4) = (m.velocity.BC.omega, m.velocity.DC.omega);
        let (a3, a4) = (m.acceleration.BC.alpha, m.acceleration.DC.alpha);
        println!("{degrees:5.0} {coupler:8.3} {rocker:8.3} {w3:10.3} {w4:9.3} {a3:10.1} {a4:10.1}");
    }
    Ok(())
}

#[cfg(test)]
#[allow(dead_code, unreachable_pub, reason = "only the declaration is used")]
mod four_bar;

/// This program's solver computes what that of `four_bar.rs` does, to the last bit.
#[test]
fn both_four_bars_agree_to_the_last_bit() {
    let (ours, theirs) = (four_bar::FourBar::new(), FourBar::new());
    let (ours_f32, theirs_f32) = (ours.lift::<f32>(), theirs.lift::<f32>());
    for step in 0..1000 {
        let theta = f64::from(step) * 0.0123;
        let (a, b) = (ours.motion(theta, 7.0, -3.0), theirs.motion(theta, 7.0, -3.0));
        // The text of a number is that of no other.
        assert_eq!(format!("{a:?}"), format!("{b:?}"));
        assert!(a.is_ok(), "{a:?}");
        let theta = theta as f32;
        let (a, b) = (ours_f32.motion(theta, 7.0, -3.0), theirs_f32.motion(theta, 7.0, -3.0));
        assert_eq!(format!("{a:?}"), format!("{b:?}"));
    }
}
