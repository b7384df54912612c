//! The four-bar of `four_bar.rs` with the code that `mechanism!` makes of its declaration in place
//! of the declaration: the same table, to the last bit.
//!
//! A test holds the code to what the macro makes, and
//! `LINKAGE_EXPAND=1 cargo test -p linkage-macros expanded && cargo fmt` writes it anew.

#![allow(unused_qualifications, reason = "generated code relies on no prelude")]

// What `mechanism!` makes of the declaration.

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
/// - crank AB
/// - rrr BC, DC
///
/// # Range
/// - rrr BC, DC: `AB` turns fully; |BD| runs from 0.2032 m to 0.4064 m, and the bars reach from
///   0.0762 m to 0.4318 m
///
/// # Cost of one call
/// - `position`: 11 additions, 21 multiplications, 1 division, 1 square root and 1 sine-cosine
///   pair
/// - `velocity`: 12 additions, 29 multiplications, 2 divisions, 1 square root and 1 sine-cosine
///   pair
/// - `motion`: 24 additions, 54 multiplications, 2 divisions, 1 square root and 1 sine-cosine
///   pair
/// - `coefficients`: 12 additions, 27 multiplications, 2 divisions, 1 square root and 1
///   sine-cosine pair
/// - `position_at`: 11 additions, 21 multiplications, 1 division and 1 square root
/// - `velocity_at`: 12 additions, 29 multiplications, 2 divisions and 1 square root
/// - `motion_at`: 24 additions, 54 multiplications, 2 divisions and 1 square root
#[::linkage_core::private::derive(
    ::linkage_core::private::Clone,
    ::linkage_core::private::Copy,
    ::linkage_core::private::Debug,
    ::linkage_core::private::PartialEq
)]
#[allow(
    dead_code,
    non_snake_case,
    clippy::derive_partial_eq_without_eq,
    reason = "names are as declared, and results are there to choose from"
)]
pub struct FourBar<T = ::linkage_core::private::f64> {
    #[doc(hidden)]
    pub scalar_: ::linkage_core::private::PhantomData<T>,
}

/// Positions of the outputs of [`FourBar`], in metres and radians.
#[::linkage_core::private::derive(
    ::linkage_core::private::Clone,
    ::linkage_core::private::Copy,
    ::linkage_core::private::Debug,
    ::linkage_core::private::PartialEq
)]
#[allow(
    dead_code,
    non_snake_case,
    clippy::derive_partial_eq_without_eq,
    reason = "names are as declared, and results are there to choose from"
)]
pub struct FourBarPosition<T> {
    /// Link `AB` (crank AB): unit direction, counter-clockwise from +x.
    pub AB: ::linkage_core::private::Direction<T>,
    /// Point `B` (crank AB): coordinates in m.
    pub B: ::linkage_core::private::Point<T>,
    /// Link `BC` (rrr BC, DC): unit direction, counter-clockwise from +x.
    pub BC: ::linkage_core::private::Direction<T>,
    /// Link `DC` (rrr BC, DC): unit direction, counter-clockwise from +x.
    pub DC: ::linkage_core::private::Direction<T>,
    /// Point `C` (rrr BC, DC): coordinates in m.
    pub C: ::linkage_core::private::Point<T>,
}

/// Velocities of the outputs of [`FourBar`], in m/s and rad/s.
#[::linkage_core::private::derive(
    ::linkage_core::private::Clone,
    ::linkage_core::private::Copy,
    ::linkage_core::private::Debug,
    ::linkage_core::private::PartialEq
)]
#[allow(
    dead_code,
    non_snake_case,
    clippy::derive_partial_eq_without_eq,
    reason = "names are as declared, and results are there to choose from"
)]
pub struct FourBarVelocity<T> {
    /// Link `AB` (crank AB): angular velocity in rad/s, counter-clockwise.
    pub AB: ::linkage_core::private::AngularVelocity<T>,
    /// Point `B` (crank AB): velocity in m/s.
    pub B: ::linkage_core::private::Point<T>,
    /// Link `BC` (rrr BC, DC): angular velocity in rad/s, counter-clockwise.
    pub BC: ::linkage_core::private::AngularVelocity<T>,
    /// Link `DC` (rrr BC, DC): angular velocity in rad/s, counter-clockwise.
    pub DC: ::linkage_core::private::AngularVelocity<T>,
    /// Point `C` (rrr BC, DC): velocity in m/s.
    pub C: ::linkage_core::private::Point<T>,
}

/// Accelerations of the outputs of [`FourBar`], in m/s² and rad/s².
#[::linkage_core::private::derive(
    ::linkage_core::private::Clone,
    ::linkage_core::private::Copy,
    ::linkage_core::private::Debug,
    ::linkage_core::private::PartialEq
)]
#[allow(
    dead_code,
    non_snake_case,
    clippy::derive_partial_eq_without_eq,
    reason = "names are as declared, and results are there to choose from"
)]
pub struct FourBarAcceleration<T> {
    /// Link `AB` (crank AB): angular acceleration in rad/s², counter-clockwise.
    pub AB: ::linkage_core::private::AngularAcceleration<T>,
    /// Point `B` (crank AB): acceleration in m/s².
    pub B: ::linkage_core::private::Point<T>,
    /// Link `BC` (rrr BC, DC): angular acceleration in rad/s², counter-clockwise.
    pub BC: ::linkage_core::private::AngularAcceleration<T>,
    /// Link `DC` (rrr BC, DC): angular acceleration in rad/s², counter-clockwise.
    pub DC: ::linkage_core::private::AngularAcceleration<T>,
    /// Point `C` (rrr BC, DC): acceleration in m/s².
    pub C: ::linkage_core::private::Point<T>,
}

/// Position, velocity and acceleration of the outputs of [`FourBar`].
#[::linkage_core::private::derive(
    ::linkage_core::private::Clone,
    ::linkage_core::private::Copy,
    ::linkage_core::private::Debug,
    ::linkage_core::private::PartialEq
)]
#[allow(
    dead_code,
    non_snake_case,
    clippy::derive_partial_eq_without_eq,
    reason = "names are as declared, and results are there to choose from"
)]
pub struct FourBarMotion<T> {
    /// In metres and radians.
    pub position: FourBarPosition<T>,
    /// In m/s and rad/s.
    pub velocity: FourBarVelocity<T>,
    /// In m/s² and rad/s².
    pub acceleration: FourBarAcceleration<T>,
}

#[allow(clippy::approx_constant, reason = "a dimension may be near a constant by chance")]
const _: () = {
    use ::linkage_core::private;
    #[allow(
        unused_imports,
        reason = "a function hides a constant of its name, and no argument"
    )]
    use ::linkage_core::private::{
        argument as cos, argument as out, argument as progress, argument as sin,
        argument as status, argument as theta, argument as theta_acceleration,
        argument as theta_rate,
    };

    impl FourBar<private::f64> {
        /// The scalar rows of the results, in the order of every list of rows.
        pub const OUTPUTS: [&'static private::str; 7] =
            ["AB.angle", "B.x", "B.y", "BC.angle", "DC.angle", "C.x", "C.y"];

        /// The inputs, in the order of the columns of Jacobians.
        pub const INPUTS: [&'static private::str; 1] = ["theta"];

        /// The numeric parameters, in the order of the columns of sensitivities.
        pub const PARAMS: [&'static private::str; 0] = [];

        /// The floating-point operations of one call.
        pub const COST: private::Cost = private::Cost {
            position: private::Operations {
                additions: 11,
                multiplications: 21,
                divisions: 1,
                roots: 1,
                sines: 1,
            },
            motion: private::Operations {
                additions: 24,
                multiplications: 54,
                divisions: 2,
                roots: 1,
                sines: 1,
            },
            coefficients: private::Operations {
                additions: 12,
                multiplications: 27,
                divisions: 2,
                roots: 1,
                sines: 1,
            },
        };

        /// The solver with all parameters at their declared values.
        #[inline]
        #[must_use]
        pub const fn new() -> Self {
            Self { scalar_: private::PhantomData }
        }
    }

    impl<T: private::Scalar> private::Default for FourBar<T> {
        /// The solver with all parameters at their declared values, rounded once.
        #[inline]
        fn default() -> Self {
            Self { scalar_: private::PhantomData }
        }
    }

    impl<T: private::Real> FourBar<T> {
        /// The same solver on other numbers, the parameters without derivatives.
        #[inline]
        #[must_use]
        pub fn lift<U: private::Scalar>(&self) -> FourBar<U> {
            FourBar { scalar_: private::PhantomData }
        }
    }

    impl<T: private::Scalar> FourBarPosition<T> {
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

    impl<T: private::Scalar> FourBarVelocity<T> {
        /// The rows in the order of `OUTPUTS`; a direction's row is ω.
        #[inline]
        #[must_use]
        pub fn rows(&self) -> [T; 7] {
            [self.AB.omega, self.B.x, self.B.y, self.BC.omega, self.DC.omega, self.C.x, self.C.y]
        }
    }

    impl<T: private::Scalar> FourBarAcceleration<T> {
        /// The rows in the order of `OUTPUTS`; a direction's row is α.
        #[inline]
        #[must_use]
        pub fn rows(&self) -> [T; 7] {
            [self.AB.alpha, self.B.x, self.B.y, self.BC.alpha, self.DC.alpha, self.C.x, self.C.y]
        }
    }

    impl<T: private::Scalar> FourBar<T> {
        /// Positions of the outputs, without a branch, and whether they may be used.
        ///
        /// Given `theta` in rad.
        ///
        /// Where the mask says no, the numbers mean nothing. Costs 11 additions, 21 multiplications, 1
        /// division, 1 square root and 1 sine-cosine pair.
        #[inline]
        #[must_use]
        pub fn solve_position(&self, theta: T) -> (FourBarPosition<T>, T::Mask) {
            self.core_position_(theta)
        }

        #[inline(always)]
        fn core_position_(&self, theta: T) -> (FourBarPosition<T>, T::Mask) {
            let (sin_, cos_) = T::sin_cos_near(theta);
            let (result_, ok_) = self.core_position_at_(cos_, sin_);
            (result_, T::is_near(theta) & ok_)
        }

        /// Velocities of the outputs, without a branch, and whether they may be used.
        ///
        /// Given `theta` in rad, its rate in rad/s.
        ///
        /// Where the mask says no, the numbers mean nothing. Costs 12 additions, 29 multiplications, 2
        /// divisions, 1 square root and 1 sine-cosine pair.
        #[inline]
        #[must_use]
        pub fn solve_velocity(&self, theta: T, theta_rate: T) -> (FourBarVelocity<T>, T::Mask) {
            self.core_velocity_(theta, theta_rate)
        }

        #[inline(always)]
        fn core_velocity_(&self, theta: T, theta_rate: T) -> (FourBarVelocity<T>, T::Mask) {
            let (sin_, cos_) = T::sin_cos_near(theta);
            let (result_, ok_) = self.core_velocity_at_(cos_, sin_, theta_rate);
            (result_, T::is_near(theta) & ok_)
        }

        /// Positions, velocities and accelerations of the outputs, without a branch, and whether they
        /// may be used.
        ///
        /// Given `theta` in rad, its rate in rad/s, its second rate in rad/s².
        ///
        /// Where the mask says no, the numbers mean nothing. Costs 24 additions, 54 multiplications, 2
        /// divisions, 1 square root and 1 sine-cosine pair.
        #[inline]
        #[must_use]
        pub fn solve_motion(
            &self,
            theta: T,
            theta_rate: T,
            theta_acceleration: T,
        ) -> (FourBarMotion<T>, T::Mask) {
            self.core_motion_(theta, theta_rate, theta_acceleration)
        }

        #[inline(always)]
        fn core_motion_(
            &self,
            theta: T,
            theta_rate: T,
            theta_acceleration: T,
        ) -> (FourBarMotion<T>, T::Mask) {
            let (sin_, cos_) = T::sin_cos_near(theta);
            let (result_, ok_) = self.core_motion_at_(cos_, sin_, theta_rate, theta_acceleration);
            (result_, T::is_near(theta) & ok_)
        }

        /// Kinematic coefficients ∂outputs/∂inputs, without a branch, and whether they may be used.
        ///
        /// Given `theta` in rad.
        /// A row an output in the order of `OUTPUTS`, a column an input in the order of `INPUTS`; from
        /// the velocity equations.
        ///
        /// Where the mask says no, the numbers mean nothing. Costs 12 additions, 27 multiplications, 2
        /// divisions, 1 square root and 1 sine-cosine pair.
        #[inline]
        #[must_use]
        pub fn solve_coefficients(&self, theta: T) -> ([[T; 1]; 7], T::Mask) {
            self.core_coefficients_(theta)
        }

        #[inline(always)]
        fn core_coefficients_(&self, theta: T) -> ([[T; 1]; 7], T::Mask) {
            let (result_, ok_) = self.core_velocity_(theta, T::lit(1.0, 1.0));
            (
                [
                    [result_.AB.omega],
                    [result_.B.x],
                    [result_.B.y],
                    [result_.BC.omega],
                    [result_.DC.omega],
                    [result_.C.x],
                    [result_.C.y],
                ],
                ok_,
            )
        }

        /// Positions of the outputs, without a branch, and whether they may be used.
        ///
        /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1).
        ///
        /// Where the mask says no, the numbers mean nothing. Costs 11 additions, 21 multiplications, 1
        /// division and 1 square root.
        #[inline]
        #[must_use]
        pub fn solve_position_at(&self, cos: T, sin: T) -> (FourBarPosition<T>, T::Mask) {
            let (cos_, sin_, near_) = private::on_circle(cos, sin);
            let (result_, ok_) = self.core_position_at_(cos_, sin_);
            (result_, ok_ & near_)
        }

        #[inline(always)]
        fn core_position_at_(&self, cos: T, sin: T) -> (FourBarPosition<T>, T::Mask) {
            let mut marks_ = private::Marks::new();
            let result_ = {
                let rest_ = T::lit(0.0, 0.0);
                self.formulas_at_::<0>(&mut marks_, cos, sin, rest_, rest_).position
            };
            (
                result_,
                marks_.all()
                    & (if T::plain(true, true) {
                        <T::Mask as private::Mask>::ALL
                    } else {
                        T::is_finite(
                            ((result_.B.x + result_.DC.cos) + result_.DC.sin)
                                + ((result_.BC.cos + result_.BC.sin) + result_.C.x),
                        )
                    }),
            )
        }

        /// Velocities of the outputs, without a branch, and whether they may be used.
        ///
        /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1), its rate in rad/s.
        ///
        /// Where the mask says no, the numbers mean nothing. Costs 12 additions, 29 multiplications, 2
        /// divisions and 1 square root.
        #[inline]
        #[must_use]
        pub fn solve_velocity_at(
            &self,
            cos: T,
            sin: T,
            theta_rate: T,
        ) -> (FourBarVelocity<T>, T::Mask) {
            let (cos_, sin_, near_) = private::on_circle(cos, sin);
            let (result_, ok_) = self.core_velocity_at_(cos_, sin_, theta_rate);
            (result_, ok_ & near_)
        }

        #[inline(always)]
        fn core_velocity_at_(
            &self,
            cos: T,
            sin: T,
            theta_rate: T,
        ) -> (FourBarVelocity<T>, T::Mask) {
            let mut marks_ = private::Marks::new();
            let result_ = {
                let rest_ = T::lit(0.0, 0.0);
                self.formulas_at_::<1>(&mut marks_, cos, sin, theta_rate, rest_).velocity
            };
            (
                result_,
                marks_.all()
                    & T::is_within(theta_rate, T::lit(1e60, 1000000.0))
                    & (if T::plain(true, true) {
                        <T::Mask as private::Mask>::ALL
                    } else {
                        T::is_finite((result_.B.x + result_.BC.omega) + (result_.C.x + result_.C.y))
                    }),
            )
        }

        /// Positions, velocities and accelerations of the outputs, without a branch, and whether they
        /// may be used.
        ///
        /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1), its rate in rad/s, its
        /// second rate in rad/s².
        ///
        /// Where the mask says no, the numbers mean nothing. Costs 24 additions, 54 multiplications, 2
        /// divisions and 1 square root.
        #[inline]
        #[must_use]
        pub fn solve_motion_at(
            &self,
            cos: T,
            sin: T,
            theta_rate: T,
            theta_acceleration: T,
        ) -> (FourBarMotion<T>, T::Mask) {
            let (cos_, sin_, near_) = private::on_circle(cos, sin);
            let (result_, ok_) = self.core_motion_at_(cos_, sin_, theta_rate, theta_acceleration);
            (result_, ok_ & near_)
        }

        #[inline(always)]
        fn core_motion_at_(
            &self,
            cos: T,
            sin: T,
            theta_rate: T,
            theta_acceleration: T,
        ) -> (FourBarMotion<T>, T::Mask) {
            let mut marks_ = private::Marks::new();
            let result_ =
                self.formulas_at_::<2>(&mut marks_, cos, sin, theta_rate, theta_acceleration);
            (
                result_,
                marks_.all()
                    & T::is_within(theta_rate, T::lit(1e60, 1000000.0))
                    & T::is_within(
                        theta_acceleration,
                        T::lit(9.999999999999998e119, 1000000000000.0),
                    )
                    & (if T::plain(true, true) {
                        <T::Mask as private::Mask>::ALL
                    } else {
                        T::is_finite(
                            (((result_.velocity.B.x + result_.acceleration.B.x)
                                + result_.position.DC.cos)
                                + ((result_.position.DC.sin + result_.position.BC.cos)
                                    + result_.position.BC.sin))
                                + (((result_.acceleration.BC.alpha + result_.velocity.C.x)
                                    + result_.velocity.C.y)
                                    + ((result_.acceleration.C.x + result_.acceleration.C.y)
                                        + result_.position.C.x)),
                        )
                    }),
            )
        }

        #[inline(always)]
        fn formulas_at_<const ORDER: private::usize>(
            &self,
            guard_: &mut impl private::Guard<T>,
            cos: T,
            sin: T,
            theta_rate: T,
            theta_acceleration: T,
        ) -> FourBarMotion<T> {
            let zero_ = T::lit(0.0, 0.0);
            let velocity_ = FourBarVelocity {
                AB: private::AngularVelocity { omega: zero_ },
                B: private::Point { x: zero_, y: zero_ },
                BC: private::AngularVelocity { omega: zero_ },
                DC: private::AngularVelocity { omega: zero_ },
                C: private::Point { x: zero_, y: zero_ },
            };
            let acceleration_ = FourBarAcceleration {
                AB: private::AngularAcceleration { alpha: zero_ },
                B: private::Point { x: zero_, y: zero_ },
                BC: private::AngularAcceleration { alpha: zero_ },
                DC: private::AngularAcceleration { alpha: zero_ },
                C: private::Point { x: zero_, y: zero_ },
            };
            let b_x_ = T::lit(0.1016, 0.1016) * cos;
            let b_y_ = T::lit(0.1016, 0.1016) * sin;
            let bc_dc_d_x_ = T::fused(-T::lit(0.1016, 0.1016), cos, T::lit(0.3048, 0.3048));
            let v174_ =
                T::fused(-T::lit(0.06193536, 0.06193536), cos, T::lit(0.1032256, 0.1032256));
            let bc_dc_d2_ = guard_.square_of_centres(
                v174_,
                bc_dc_d_x_,
                -b_y_,
                T::lit(0.254, 0.254),
                T::lit(0.1778, 0.1778),
                "BC, DC",
            );
            let bc_dc_inverse_d2_ = T::lit(1.0, 1.0) / bc_dc_d2_;
            let bc_dc_i_ =
                T::fused(-T::lit(0.06193536, 0.06193536), cos, T::lit(0.09741916, 0.09741916));
            let v178_ = T::lit(0.1806448, 0.1806448) - bc_dc_i_;
            let v179_ = T::lit(5.535725357165, 5.5357256) * bc_dc_i_;
            let v180_ = T::lit(5.535725357165, 5.5357256) * v178_;
            let v181_ = v179_ * v180_;
            let bc_dc_s_ = guard_.reach_circles(
                v181_,
                [
                    bc_dc_d_x_,
                    -b_y_,
                    T::lit(0.254, 0.254),
                    T::lit(0.1778, 0.1778),
                    T::lit(1.0321428571428573, 1.0321429),
                ],
                "BC, DC",
            );
            let bc_dc_root_s_ = T::sqrt(bc_dc_s_);
            let v184_ = T::lit(0.0903224, 0.0903224) * bc_dc_inverse_d2_;
            let bc_dc_h_ = bc_dc_root_s_ * v184_;
            let bc_dc_a_d2_ = T::fused(T::lit(0.5, 0.5), bc_dc_i_, T::lit(0.0193548, 0.0193548));
            let bc_dc_b_d2_ = T::fused(T::lit(0.5, 0.5), bc_dc_i_, -T::lit(0.01354836, 0.01354836));
            let v189_ = bc_dc_inverse_d2_ * bc_dc_a_d2_;
            let bc_dc_a_ = guard_.share_of_centres(
                v189_,
                [
                    v181_,
                    bc_dc_d_x_,
                    -b_y_,
                    T::lit(0.254, 0.254),
                    T::lit(0.1778, 0.1778),
                    T::lit(1.0321428571428573, 1.0321429),
                ],
                "BC, DC",
            );
            let v191_ = bc_dc_inverse_d2_ * bc_dc_b_d2_;
            let bc_dc_b_ = guard_.share_of_centres(
                v191_,
                [
                    v181_,
                    bc_dc_d_x_,
                    -b_y_,
                    T::lit(0.1778, 0.1778),
                    T::lit(0.254, 0.254),
                    T::lit(1.0321428571428573, 1.0321429),
                ],
                "BC, DC",
            );
            let bc_dc_h_d_x_ = b_y_ * bc_dc_h_;
            let bc_dc_h_d_y_ = bc_dc_d_x_ * bc_dc_h_;
            let bc_dc_r2_x_ = T::fused(bc_dc_d_x_, bc_dc_a_, bc_dc_h_d_x_);
            let bc_dc_r2_y_ = T::fused(-b_y_, bc_dc_a_, bc_dc_h_d_y_);
            let bc_dc_r3_x_ = T::fused(-bc_dc_d_x_, bc_dc_b_, bc_dc_h_d_x_);
            let c_y_ = T::fused(b_y_, bc_dc_b_, bc_dc_h_d_y_);
            let dc_cos_ = T::lit(5.62429696287964, 5.624297) * bc_dc_r3_x_;
            let dc_sin_ = T::lit(5.62429696287964, 5.624297) * c_y_;
            let bc_cos_ = T::lit(3.937007874015748, 3.937008) * bc_dc_r2_x_;
            let bc_sin_ = T::lit(3.937007874015748, 3.937008) * bc_dc_r2_y_;
            let c_x_ = T::lit(0.3048, 0.3048) + bc_dc_r3_x_;
            let position_ = FourBarPosition {
                AB: private::Direction { cos, sin },
                B: private::Point { x: b_x_, y: b_y_ },
                BC: private::Direction { cos: bc_cos_, sin: bc_sin_ },
                DC: private::Direction { cos: dc_cos_, sin: dc_sin_ },
                C: private::Point { x: c_x_, y: c_y_ },
            };
            if ORDER == 0 {
                return FourBarMotion {
                    position: position_,
                    velocity: velocity_,
                    acceleration: acceleration_,
                };
            }
            let bc_dc_w_x_ = theta_rate * b_y_;
            let b_vx_ = -bc_dc_w_x_;
            let b_vy_ = theta_rate * b_x_;
            let v204_ = guard_.nonzero(bc_dc_s_, "BC, DC");
            let v205_ = T::lit(11.07145071433, 11.071451) * bc_dc_root_s_;
            let v206_ = T::lit(1.0, 1.0) / v204_;
            let bc_dc_inverse_j_ = v205_ * v206_;
            let v212_ = bc_dc_w_x_ * bc_dc_r3_x_;
            let bc_dc_w_r3_ = T::fused(-b_vy_, c_y_, v212_);
            let bc_omega_ = bc_dc_inverse_j_ * bc_dc_w_r3_;
            let v217_ = bc_dc_w_x_ * bc_dc_r2_x_;
            let bc_dc_w_r2_ = T::fused(-b_vy_, bc_dc_r2_y_, v217_);
            let dc_omega_ = bc_dc_inverse_j_ * bc_dc_w_r2_;
            let v242_ = c_y_ * dc_omega_;
            let c_vx_ = -v242_;
            let c_vy_ = bc_dc_r3_x_ * dc_omega_;
            let velocity_ = FourBarVelocity {
                AB: private::AngularVelocity { omega: theta_rate },
                B: private::Point { x: b_vx_, y: b_vy_ },
                BC: private::AngularVelocity { omega: bc_omega_ },
                DC: private::AngularVelocity { omega: dc_omega_ },
                C: private::Point { x: c_vx_, y: c_vy_ },
            };
            if ORDER == 1 {
                return FourBarMotion {
                    position: position_,
                    velocity: velocity_,
                    acceleration: acceleration_,
                };
            }
            let v16_ = theta_rate * theta_rate;
            let v164_ = theta_acceleration * b_y_;
            let v165_ = theta_acceleration * b_x_;
            let bc_dc_g_x_ = T::fused(v16_, b_x_, v164_);
            let b_ax_ = -bc_dc_g_x_;
            let b_ay_ = T::fused(-v16_, b_y_, v165_);
            let bc_dc_omega2_squared_ = bc_omega_ * bc_omega_;
            let bc_dc_omega3_squared_ = dc_omega_ * dc_omega_;
            let bc_dc_r2_r3_ = T::fused(-T::lit(0.5, 0.5), bc_dc_i_, T::lit(0.0451612, 0.0451612));
            let v224_ = bc_dc_omega2_squared_ * bc_dc_r2_r3_;
            let v226_ = T::fused(-T::lit(0.03161284, 0.03161284), bc_dc_omega3_squared_, v224_);
            let v227_ = T::lit(0.064516, 0.064516) * bc_dc_omega2_squared_;
            let v230_ = T::fused(-bc_dc_omega3_squared_, bc_dc_r2_r3_, v227_);
            let v231_ = bc_dc_g_x_ * bc_dc_r3_x_;
            let v234_ = T::fused(-b_ay_, c_y_, v231_);
            let v235_ = v226_ + v234_;
            let bc_alpha_ = bc_dc_inverse_j_ * v235_;
            let v237_ = bc_dc_g_x_ * bc_dc_r2_x_;
            let v239_ = T::fused(-b_ay_, bc_dc_r2_y_, v237_);
            let v240_ = v230_ + v239_;
            let dc_alpha_ = bc_dc_inverse_j_ * v240_;
            let v245_ = bc_dc_r3_x_ * bc_dc_omega3_squared_;
            let v246_ = c_y_ * bc_dc_omega3_squared_;
            let v249_ = T::fused(c_y_, dc_alpha_, v245_);
            let c_ax_ = -v249_;
            let c_ay_ = T::fused(bc_dc_r3_x_, dc_alpha_, -v246_);
            let acceleration_ = FourBarAcceleration {
                AB: private::AngularAcceleration { alpha: theta_acceleration },
                B: private::Point { x: b_ax_, y: b_ay_ },
                BC: private::AngularAcceleration { alpha: bc_alpha_ },
                DC: private::AngularAcceleration { alpha: dc_alpha_ },
                C: private::Point { x: c_ax_, y: c_ay_ },
            };
            FourBarMotion { position: position_, velocity: velocity_, acceleration: acceleration_ }
        }
    }

    impl<T: private::Real> FourBar<T> {
        /// Positions of the outputs.
        ///
        /// Given `theta` in rad.
        ///
        /// Costs 11 additions, 21 multiplications, 1 division, 1 square root and 1 sine-cosine pair.
        ///
        /// # Errors
        /// The group that cannot be assembled, is singular or was given an invalid length, or the input
        /// or result that is not finite.
        #[inline]
        pub fn position(
            &self,
            theta: T,
        ) -> private::Result<FourBarPosition<T>, private::SolveError> {
            let (result_, ok_) = { self.core_position_(theta) };
            if ok_ { private::Ok(result_) } else { self.explain_position_(theta) }
        }

        /// Velocities of the outputs.
        ///
        /// Given `theta` in rad, its rate in rad/s.
        ///
        /// Costs 12 additions, 29 multiplications, 2 divisions, 1 square root and 1 sine-cosine pair.
        ///
        /// # Errors
        /// The group that cannot be assembled, is singular or was given an invalid length, or the input
        /// or result that is not finite.
        #[inline]
        pub fn velocity(
            &self,
            theta: T,
            theta_rate: T,
        ) -> private::Result<FourBarVelocity<T>, private::SolveError> {
            let (result_, ok_) = { self.core_velocity_(theta, theta_rate) };
            if ok_ { private::Ok(result_) } else { self.explain_velocity_(theta, theta_rate) }
        }

        /// Positions, velocities and accelerations of the outputs.
        ///
        /// Given `theta` in rad, its rate in rad/s, its second rate in rad/s².
        ///
        /// Costs 24 additions, 54 multiplications, 2 divisions, 1 square root and 1 sine-cosine pair.
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
        ) -> private::Result<FourBarMotion<T>, private::SolveError> {
            let (result_, ok_) = { self.core_motion_(theta, theta_rate, theta_acceleration) };
            if ok_ {
                private::Ok(result_)
            } else {
                self.explain_motion_(theta, theta_rate, theta_acceleration)
            }
        }

        /// Kinematic coefficients ∂outputs/∂inputs.
        ///
        /// Given `theta` in rad.
        /// A row an output in the order of `OUTPUTS`, a column an input in the order of `INPUTS`; from
        /// the velocity equations.
        ///
        /// Costs 12 additions, 27 multiplications, 2 divisions, 1 square root and 1 sine-cosine pair.
        ///
        /// # Errors
        /// The group that cannot be assembled, is singular or was given an invalid length, or the input
        /// or result that is not finite. An input that no coefficient depends on is not looked at.
        #[inline]
        pub fn coefficients(&self, theta: T) -> private::Result<[[T; 1]; 7], private::SolveError> {
            let (result_, ok_) = { self.core_coefficients_(theta) };
            if ok_ { private::Ok(result_) } else { self.explain_coefficients_(theta) }
        }

        /// Positions of the outputs.
        ///
        /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1).
        ///
        /// Costs 11 additions, 21 multiplications, 1 division and 1 square root.
        ///
        /// # Errors
        /// The group that cannot be assembled, is singular or was given an invalid length, or the input
        /// or result that is not finite. `OffCircle` where the amplitude is no resolver's.
        #[inline]
        pub fn position_at(
            &self,
            cos: T,
            sin: T,
        ) -> private::Result<FourBarPosition<T>, private::SolveError> {
            let (result_, ok_) = {
                let (cos_, sin_, near_) = private::on_circle(cos, sin);
                let (result_, ok_) = self.core_position_at_(cos_, sin_);
                (result_, ok_ & near_)
            };
            if ok_ {
                private::Ok(result_)
            } else {
                let (cos_, sin_) = private::found_on_circle(cos, sin, "theta")?;
                self.explain_position_at_(cos_, sin_)
            }
        }

        /// Velocities of the outputs.
        ///
        /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1), its rate in rad/s.
        ///
        /// Costs 12 additions, 29 multiplications, 2 divisions and 1 square root.
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
        ) -> private::Result<FourBarVelocity<T>, private::SolveError> {
            let (result_, ok_) = {
                let (cos_, sin_, near_) = private::on_circle(cos, sin);
                let (result_, ok_) = self.core_velocity_at_(cos_, sin_, theta_rate);
                (result_, ok_ & near_)
            };
            if ok_ {
                private::Ok(result_)
            } else {
                let (cos_, sin_) = private::found_on_circle(cos, sin, "theta")?;
                self.explain_velocity_at_(cos_, sin_, theta_rate)
            }
        }

        /// Positions, velocities and accelerations of the outputs.
        ///
        /// Given `theta` by its cosine and sine (any amplitude from 0.9 to 1.1), its rate in rad/s, its
        /// second rate in rad/s².
        ///
        /// Costs 24 additions, 54 multiplications, 2 divisions and 1 square root.
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
        ) -> private::Result<FourBarMotion<T>, private::SolveError> {
            let (result_, ok_) = {
                let (cos_, sin_, near_) = private::on_circle(cos, sin);
                let (result_, ok_) =
                    self.core_motion_at_(cos_, sin_, theta_rate, theta_acceleration);
                (result_, ok_ & near_)
            };
            if ok_ {
                private::Ok(result_)
            } else {
                let (cos_, sin_) = private::found_on_circle(cos, sin, "theta")?;
                self.explain_motion_at_(cos_, sin_, theta_rate, theta_acceleration)
            }
        }

        /// Why `solve_position` gave no answer, or the answer at a limit.
        #[cold]
        #[inline(never)]
        fn explain_position_(
            &self,
            theta: T,
        ) -> private::Result<FourBarPosition<T>, private::SolveError> {
            private::finite_input(theta, "theta")?;
            let (sin_, cos_) = T::sin_cos(theta);
            self.explain_position_at_(cos_, sin_)
        }

        /// Why `solve_velocity` gave no answer, or the answer at a limit.
        #[cold]
        #[inline(never)]
        fn explain_velocity_(
            &self,
            theta: T,
            theta_rate: T,
        ) -> private::Result<FourBarVelocity<T>, private::SolveError> {
            private::finite_input(theta, "theta")?;
            let (sin_, cos_) = T::sin_cos(theta);
            self.explain_velocity_at_(cos_, sin_, theta_rate)
        }

        /// Why `solve_motion` gave no answer, or the answer at a limit.
        #[cold]
        #[inline(never)]
        fn explain_motion_(
            &self,
            theta: T,
            theta_rate: T,
            theta_acceleration: T,
        ) -> private::Result<FourBarMotion<T>, private::SolveError> {
            private::finite_input(theta, "theta")?;
            let (sin_, cos_) = T::sin_cos(theta);
            self.explain_motion_at_(cos_, sin_, theta_rate, theta_acceleration)
        }

        /// Why `solve_coefficients` gave no answer, or the answer at a limit.
        #[cold]
        #[inline(never)]
        fn explain_coefficients_(
            &self,
            theta: T,
        ) -> private::Result<[[T; 1]; 7], private::SolveError> {
            let result_ = self.explain_velocity_(theta, T::lit(1.0, 1.0))?;
            private::Ok([
                [result_.AB.omega],
                [result_.B.x],
                [result_.B.y],
                [result_.BC.omega],
                [result_.DC.omega],
                [result_.C.x],
                [result_.C.y],
            ])
        }

        /// Why `solve_position_at` gave no answer, or the answer at a limit.
        #[cold]
        #[inline(never)]
        fn explain_position_at_(
            &self,
            cos: T,
            sin: T,
        ) -> private::Result<FourBarPosition<T>, private::SolveError> {
            let given_: [(T, &'static private::str); 2] = [(cos, "cos"), (sin, "sin")];
            for &(value_, name_) in &given_ {
                private::finite_input(value_, name_)?;
            }
            let mut findings_ = private::Findings::new();
            let result_ = {
                let rest_ = T::lit(0.0, 0.0);
                self.formulas_at_::<0>(&mut findings_, cos, sin, rest_, rest_).position
            };
            findings_.first()?;
            for &(value_, name_) in &[
                (result_.AB.cos, "AB.angle"),
                (result_.AB.sin, "AB.angle"),
                (result_.B.x, "B.x"),
                (result_.B.y, "B.y"),
                (result_.BC.cos, "BC.angle"),
                (result_.BC.sin, "BC.angle"),
                (result_.DC.cos, "DC.angle"),
                (result_.DC.sin, "DC.angle"),
                (result_.C.x, "C.x"),
                (result_.C.y, "C.y"),
            ] {
                private::finite_result(value_, name_, &given_)?;
            }
            private::Ok(result_)
        }

        /// Why `solve_velocity_at` gave no answer, or the answer at a limit.
        #[cold]
        #[inline(never)]
        fn explain_velocity_at_(
            &self,
            cos: T,
            sin: T,
            theta_rate: T,
        ) -> private::Result<FourBarVelocity<T>, private::SolveError> {
            let given_: [(T, &'static private::str); 3] =
                [(theta_rate, "theta_rate"), (cos, "cos"), (sin, "sin")];
            for &(value_, name_) in &given_ {
                private::finite_input(value_, name_)?;
            }
            let mut findings_ = private::Findings::new();
            let result_ = {
                let rest_ = T::lit(0.0, 0.0);
                self.formulas_at_::<1>(&mut findings_, cos, sin, theta_rate, rest_).velocity
            };
            findings_.first()?;
            for &(value_, name_) in &[
                (result_.AB.omega, "velocity of AB.angle"),
                (result_.B.x, "velocity of B.x"),
                (result_.B.y, "velocity of B.y"),
                (result_.BC.omega, "velocity of BC.angle"),
                (result_.DC.omega, "velocity of DC.angle"),
                (result_.C.x, "velocity of C.x"),
                (result_.C.y, "velocity of C.y"),
            ] {
                private::finite_result(value_, name_, &given_)?;
            }
            private::Ok(result_)
        }

        /// Why `solve_motion_at` gave no answer, or the answer at a limit.
        #[cold]
        #[inline(never)]
        fn explain_motion_at_(
            &self,
            cos: T,
            sin: T,
            theta_rate: T,
            theta_acceleration: T,
        ) -> private::Result<FourBarMotion<T>, private::SolveError> {
            let given_: [(T, &'static private::str); 4] = [
                (theta_rate, "theta_rate"),
                (theta_acceleration, "theta_acceleration"),
                (cos, "cos"),
                (sin, "sin"),
            ];
            for &(value_, name_) in &given_ {
                private::finite_input(value_, name_)?;
            }
            let mut findings_ = private::Findings::new();
            let result_ =
                self.formulas_at_::<2>(&mut findings_, cos, sin, theta_rate, theta_acceleration);
            findings_.first()?;
            for &(value_, name_) in &[
                (result_.position.AB.cos, "AB.angle"),
                (result_.position.AB.sin, "AB.angle"),
                (result_.position.B.x, "B.x"),
                (result_.position.B.y, "B.y"),
                (result_.position.BC.cos, "BC.angle"),
                (result_.position.BC.sin, "BC.angle"),
                (result_.position.DC.cos, "DC.angle"),
                (result_.position.DC.sin, "DC.angle"),
                (result_.position.C.x, "C.x"),
                (result_.position.C.y, "C.y"),
                (result_.velocity.AB.omega, "velocity of AB.angle"),
                (result_.velocity.B.x, "velocity of B.x"),
                (result_.velocity.B.y, "velocity of B.y"),
                (result_.velocity.BC.omega, "velocity of BC.angle"),
                (result_.velocity.DC.omega, "velocity of DC.angle"),
                (result_.velocity.C.x, "velocity of C.x"),
                (result_.velocity.C.y, "velocity of C.y"),
                (result_.acceleration.AB.alpha, "acceleration of AB.angle"),
                (result_.acceleration.B.x, "acceleration of B.x"),
                (result_.acceleration.B.y, "acceleration of B.y"),
                (result_.acceleration.BC.alpha, "acceleration of BC.angle"),
                (result_.acceleration.DC.alpha, "acceleration of DC.angle"),
                (result_.acceleration.C.x, "acceleration of C.x"),
                (result_.acceleration.C.y, "acceleration of C.y"),
            ] {
                private::finite_result(value_, name_, &given_)?;
            }
            private::Ok(result_)
        }
    }

    impl<T: private::Float> FourBar<T> {
        /// Positions of the outputs, at many poses.
        ///
        /// Given `theta` in rad. Each is a slice with a number for every pose, or one number for all.
        ///
        /// Every component of the results goes to a slice of its own in `out`, as many long as there
        /// are poses, or empty where it is not wanted; `status` is such a slice too. A pose that
        /// `position` refuses has numbers that are none, and its error's kind in `status`. `progress`
        /// is told the poses done and their total every few thousand poses; `()` tells nobody.
        ///
        /// # Errors
        /// Two slices are not of one length; nothing was computed.
        pub fn sweep_position<'series>(
            &self,
            theta: impl private::Into<private::Series<'series, T>>,
            out: FourBarPosition<&mut [T]>,
            status: &mut [private::Status],
            progress: impl private::Progress,
        ) -> private::Result<(), private::LengthMismatch> {
            let theta: private::Series<'series, T> = private::Into::into(theta);
            private::sweep::<private::OfPosition, _, _, 1, 10>(
                self,
                [theta],
                [
                    out.AB.cos, out.AB.sin, out.B.x, out.B.y, out.BC.cos, out.BC.sin, out.DC.cos,
                    out.DC.sin, out.C.x, out.C.y,
                ],
                status,
                progress,
            )
        }
    }

    impl<T: private::Float> private::Entry<private::OfPosition, T, 1, 10> for FourBar<T> {
        #[inline(always)]
        fn solve_lanes<const W_: private::usize, F: private::Fusion>(
            &self,
            [x0_]: [private::Lanes<T, W_, F>; 1],
        ) -> ([private::Lanes<T, W_, F>; 10], private::LaneMask<W_>) {
            let (result_, ok_) = self.lift::<private::Lanes<T, W_, F>>().core_position_(x0_);
            (
                [
                    result_.AB.cos,
                    result_.AB.sin,
                    result_.B.x,
                    result_.B.y,
                    result_.BC.cos,
                    result_.BC.sin,
                    result_.DC.cos,
                    result_.DC.sin,
                    result_.C.x,
                    result_.C.y,
                ],
                ok_,
            )
        }

        fn solve_one(&self, [x0_]: [T; 1]) -> private::Result<[T; 10], private::SolveError> {
            let result_ = self.position(x0_)?;
            private::Ok([
                result_.AB.cos,
                result_.AB.sin,
                result_.B.x,
                result_.B.y,
                result_.BC.cos,
                result_.BC.sin,
                result_.DC.cos,
                result_.DC.sin,
                result_.C.x,
                result_.C.y,
            ])
        }
    }

    impl<T: private::Float> FourBar<T> {
        /// Velocities of the outputs, at many poses.
        ///
        /// Given `theta` in rad, its rate in rad/s. Each is a slice with a number for every pose, or
        /// one number for all.
        ///
        /// Every component of the results goes to a slice of its own in `out`, as many long as there
        /// are poses, or empty where it is not wanted; `status` is such a slice too. A pose that
        /// `velocity` refuses has numbers that are none, and its error's kind in `status`. `progress`
        /// is told the poses done and their total every few thousand poses; `()` tells nobody.
        ///
        /// # Errors
        /// Two slices are not of one length; nothing was computed.
        pub fn sweep_velocity<'series>(
            &self,
            theta: impl private::Into<private::Series<'series, T>>,
            theta_rate: impl private::Into<private::Series<'series, T>>,
            out: FourBarVelocity<&mut [T]>,
            status: &mut [private::Status],
            progress: impl private::Progress,
        ) -> private::Result<(), private::LengthMismatch> {
            let theta: private::Series<'series, T> = private::Into::into(theta);
            let theta_rate: private::Series<'series, T> = private::Into::into(theta_rate);
            private::sweep::<private::OfVelocity, _, _, 2, 7>(
                self,
                [theta, theta_rate],
                [out.AB.omega, out.B.x, out.B.y, out.BC.omega, out.DC.omega, out.C.x, out.C.y],
                status,
                progress,
            )
        }
    }

    impl<T: private::Float> private::Entry<private::OfVelocity, T, 2, 7> for FourBar<T> {
        #[inline(always)]
        fn solve_lanes<const W_: private::usize, F: private::Fusion>(
            &self,
            [x0_, x1_]: [private::Lanes<T, W_, F>; 2],
        ) -> ([private::Lanes<T, W_, F>; 7], private::LaneMask<W_>) {
            let (result_, ok_) = self.lift::<private::Lanes<T, W_, F>>().core_velocity_(x0_, x1_);
            (
                [
                    result_.AB.omega,
                    result_.B.x,
                    result_.B.y,
                    result_.BC.omega,
                    result_.DC.omega,
                    result_.C.x,
                    result_.C.y,
                ],
                ok_,
            )
        }

        fn solve_one(&self, [x0_, x1_]: [T; 2]) -> private::Result<[T; 7], private::SolveError> {
            let result_ = self.velocity(x0_, x1_)?;
            private::Ok([
                result_.AB.omega,
                result_.B.x,
                result_.B.y,
                result_.BC.omega,
                result_.DC.omega,
                result_.C.x,
                result_.C.y,
            ])
        }
    }

    impl<T: private::Float> FourBar<T> {
        /// Positions, velocities and accelerations of the outputs, at many poses.
        ///
        /// Given `theta` in rad, its rate in rad/s, its second rate in rad/s². Each is a slice with a
        /// number for every pose, or one number for all.
        ///
        /// Every component of the results goes to a slice of its own in `out`, as many long as there
        /// are poses, or empty where it is not wanted; `status` is such a slice too. A pose that
        /// `motion` refuses has numbers that are none, and its error's kind in `status`. `progress` is
        /// told the poses done and their total every few thousand poses; `()` tells nobody.
        ///
        /// # Errors
        /// Two slices are not of one length; nothing was computed.
        pub fn sweep_motion<'series>(
            &self,
            theta: impl private::Into<private::Series<'series, T>>,
            theta_rate: impl private::Into<private::Series<'series, T>>,
            theta_acceleration: impl private::Into<private::Series<'series, T>>,
            out: FourBarMotion<&mut [T]>,
            status: &mut [private::Status],
            progress: impl private::Progress,
        ) -> private::Result<(), private::LengthMismatch> {
            let theta: private::Series<'series, T> = private::Into::into(theta);
            let theta_rate: private::Series<'series, T> = private::Into::into(theta_rate);
            let theta_acceleration: private::Series<'series, T> =
                private::Into::into(theta_acceleration);
            private::sweep::<private::OfMotion, _, _, 3, 24>(
                self,
                [theta, theta_rate, theta_acceleration],
                [
                    out.position.AB.cos,
                    out.position.AB.sin,
                    out.position.B.x,
                    out.position.B.y,
                    out.position.BC.cos,
                    out.position.BC.sin,
                    out.position.DC.cos,
                    out.position.DC.sin,
                    out.position.C.x,
                    out.position.C.y,
                    out.velocity.AB.omega,
                    out.velocity.B.x,
                    out.velocity.B.y,
                    out.velocity.BC.omega,
                    out.velocity.DC.omega,
                    out.velocity.C.x,
                    out.velocity.C.y,
                    out.acceleration.AB.alpha,
                    out.acceleration.B.x,
                    out.acceleration.B.y,
                    out.acceleration.BC.alpha,
                    out.acceleration.DC.alpha,
                    out.acceleration.C.x,
                    out.acceleration.C.y,
                ],
                status,
                progress,
            )
        }
    }

    impl<T: private::Float> private::Entry<private::OfMotion, T, 3, 24> for FourBar<T> {
        #[inline(always)]
        fn solve_lanes<const W_: private::usize, F: private::Fusion>(
            &self,
            [x0_, x1_, x2_]: [private::Lanes<T, W_, F>; 3],
        ) -> ([private::Lanes<T, W_, F>; 24], private::LaneMask<W_>) {
            let (result_, ok_) =
                self.lift::<private::Lanes<T, W_, F>>().core_motion_(x0_, x1_, x2_);
            (
                [
                    result_.position.AB.cos,
                    result_.position.AB.sin,
                    result_.position.B.x,
                    result_.position.B.y,
                    result_.position.BC.cos,
                    result_.position.BC.sin,
                    result_.position.DC.cos,
                    result_.position.DC.sin,
                    result_.position.C.x,
                    result_.position.C.y,
                    result_.velocity.AB.omega,
                    result_.velocity.B.x,
                    result_.velocity.B.y,
                    result_.velocity.BC.omega,
                    result_.velocity.DC.omega,
                    result_.velocity.C.x,
                    result_.velocity.C.y,
                    result_.acceleration.AB.alpha,
                    result_.acceleration.B.x,
                    result_.acceleration.B.y,
                    result_.acceleration.BC.alpha,
                    result_.acceleration.DC.alpha,
                    result_.acceleration.C.x,
                    result_.acceleration.C.y,
                ],
                ok_,
            )
        }

        fn solve_one(
            &self,
            [x0_, x1_, x2_]: [T; 3],
        ) -> private::Result<[T; 24], private::SolveError> {
            let result_ = self.motion(x0_, x1_, x2_)?;
            private::Ok([
                result_.position.AB.cos,
                result_.position.AB.sin,
                result_.position.B.x,
                result_.position.B.y,
                result_.position.BC.cos,
                result_.position.BC.sin,
                result_.position.DC.cos,
                result_.position.DC.sin,
                result_.position.C.x,
                result_.position.C.y,
                result_.velocity.AB.omega,
                result_.velocity.B.x,
                result_.velocity.B.y,
                result_.velocity.BC.omega,
                result_.velocity.DC.omega,
                result_.velocity.C.x,
                result_.velocity.C.y,
                result_.acceleration.AB.alpha,
                result_.acceleration.B.x,
                result_.acceleration.B.y,
                result_.acceleration.BC.alpha,
                result_.acceleration.DC.alpha,
                result_.acceleration.C.x,
                result_.acceleration.C.y,
            ])
        }
    }
    private::with_ad! {
        impl<T: private::Differentiable> FourBar<T> {
            /// ∂outputs/∂inputs by automatic differentiation of the position.
            ///
            /// Rows: `AB.angle`, `B.x`, `B.y`, `BC.angle`, `DC.angle`, `C.x`, `C.y`; columns: `theta`.
            ///
            /// # Errors
            /// Those of `position`; `Singular` where a derivative does not exist.
            pub fn jacobian(
                &self,
                theta: T,
            ) -> private::Result<private::SMatrix<T, 7, 1>, private::SolveError> {
                private::differentiate(
                    [theta],
                    |[dual_]| private::Ok(self.lift().position(dual_)?.rows()),
                )
            }
        }
    }

    impl<T: private::Real> private::Modes for FourBar<T> {
        type Scalar = T;
        type Input = T;
        type Position = FourBarPosition<T>;
        type Motion = FourBarMotion<T>;
        type Clearances = [private::Clearance<T>; 1];
        type Enclosures = [private::Clearance<<T as private::Real>::Enclosing>; 1];

        const GROUPS: &'static [(&'static private::str, private::Option<private::usize>)] =
            &[("BC, DC", private::None)];

        #[inline]
        fn flip(&mut self, param_: private::usize) {
            let _ = param_;
        }

        #[inline]
        fn position(&self, q_: T) -> private::Result<FourBarPosition<T>, private::SolveError> {
            Self::position(self, q_)
        }

        #[inline]
        fn motion(
            &self,
            q_: T,
            rate_: T,
            acceleration_: T,
        ) -> private::Result<FourBarMotion<T>, private::SolveError> {
            Self::motion(self, q_, rate_, acceleration_)
        }

        fn clearances(&self, theta: T, theta_rate: T) -> Self::Clearances {
            let (ab_sin_, ab_cos_) = T::sin_cos(theta);
            let b_x_ = T::lit(0.1016, 0.1016) * ab_cos_;
            let b_y_ = T::lit(0.1016, 0.1016) * ab_sin_;
            let bc_dc_w_x_ = theta_rate * b_y_;
            let b_vy_ = theta_rate * b_x_;
            let v16_ = theta_rate * theta_rate;
            let bc_dc_g_x_ = b_x_ * v16_;
            let bc_dc_g_y_ = b_y_ * v16_;
            let bc_dc_d_x_ = T::fused(-T::lit(0.1016, 0.1016), ab_cos_, T::lit(0.3048, 0.3048));
            let v37_ = bc_dc_w_x_ * bc_dc_d_x_;
            let v38_ = v37_ + v37_;
            let v39_ = bc_dc_w_x_ * bc_dc_w_x_;
            let v40_ = T::lit(2.0, 2.0) * v39_;
            let v41_ = b_y_ * b_vy_;
            let v42_ = v41_ + v41_;
            let v43_ = b_vy_ * b_vy_;
            let v44_ = T::lit(2.0, 2.0) * v43_;
            let v45_ = v38_ + v42_;
            let bc_dc_i_ =
                T::fused(-T::lit(0.06193536, 0.06193536), ab_cos_, T::lit(0.09741916, 0.09741916));
            let v49_ = T::lit(0.1806448, 0.1806448) - bc_dc_i_;
            let v50_ = T::lit(5.535725357165, 5.5357256) * bc_dc_i_;
            let v51_ = T::lit(5.535725357165, 5.5357256) * v45_;
            let v52_ = T::lit(5.535725357165, 5.5357256) * v49_;
            let v53_ = v50_ * v52_;
            let v54_ = v51_ * v52_;
            let v57_ = T::fused(-v50_, v51_, v54_);
            let v58_ = v51_ * v51_;
            let v59_ = T::lit(2.0, 2.0) * v58_;
            let v254_ = bc_dc_g_x_ * bc_dc_d_x_;
            let v255_ = T::fused(bc_dc_g_x_, bc_dc_d_x_, v40_);
            let v256_ = v254_ + v255_;
            let v257_ = b_y_ * bc_dc_g_y_;
            let v258_ = T::fused(-b_y_, bc_dc_g_y_, v44_);
            let v259_ = v258_ - v257_;
            let v260_ = v256_ + v259_;
            let v261_ = T::lit(5.535725357165, 5.5357256) * v260_;
            let v264_ = T::fused(v52_, v261_, -v59_);
            let v266_ = T::fused(-v50_, v261_, v264_);
            [private::Clearance {
                value: v53_,
                rate: v57_,
                second_rate: v266_,
                scale: T::lit(0.5517857142857143, 0.5517857),
            }]
        }

        fn enclosures(&self, middle_: T, radius_: T, rate_: T) -> Self::Enclosures {
            let none_ = T::lit(0.0, 0.0);
            let solver_ = self.lift::<<T as private::Real>::Enclosing>();
            private::Modes::clearances(
                &solver_,
                private::Real::enclosing(middle_, radius_),
                private::Real::enclosing(rate_, none_),
            )
        }
    }

    impl<T: private::Scalar> private::Linear<T> for FourBarPosition<T> {
        #[inline]
        fn plus(self, factor_: T, other_: Self) -> Self {
            Self {
                AB: private::Linear::<T>::plus(self.AB, factor_, other_.AB),
                B: private::Linear::<T>::plus(self.B, factor_, other_.B),
                BC: private::Linear::<T>::plus(self.BC, factor_, other_.BC),
                DC: private::Linear::<T>::plus(self.DC, factor_, other_.DC),
                C: private::Linear::<T>::plus(self.C, factor_, other_.C),
            }
        }

        #[inline]
        fn minus(self, other_: Self) -> Self {
            Self {
                AB: private::Linear::<T>::minus(self.AB, other_.AB),
                B: private::Linear::<T>::minus(self.B, other_.B),
                BC: private::Linear::<T>::minus(self.BC, other_.BC),
                DC: private::Linear::<T>::minus(self.DC, other_.DC),
                C: private::Linear::<T>::minus(self.C, other_.C),
            }
        }

        #[inline]
        fn all(self, test_: impl private::Fn(T) -> private::bool + private::Copy) -> private::bool {
            private::Linear::<T>::all(self.AB, test_)
                && private::Linear::<T>::all(self.B, test_)
                && private::Linear::<T>::all(self.BC, test_)
                && private::Linear::<T>::all(self.DC, test_)
                && private::Linear::<T>::all(self.C, test_)
        }
    }

    impl<T: private::Scalar> private::Linear<T> for FourBarVelocity<T> {
        #[inline]
        fn plus(self, factor_: T, other_: Self) -> Self {
            Self {
                AB: private::Linear::<T>::plus(self.AB, factor_, other_.AB),
                B: private::Linear::<T>::plus(self.B, factor_, other_.B),
                BC: private::Linear::<T>::plus(self.BC, factor_, other_.BC),
                DC: private::Linear::<T>::plus(self.DC, factor_, other_.DC),
                C: private::Linear::<T>::plus(self.C, factor_, other_.C),
            }
        }

        #[inline]
        fn minus(self, other_: Self) -> Self {
            Self {
                AB: private::Linear::<T>::minus(self.AB, other_.AB),
                B: private::Linear::<T>::minus(self.B, other_.B),
                BC: private::Linear::<T>::minus(self.BC, other_.BC),
                DC: private::Linear::<T>::minus(self.DC, other_.DC),
                C: private::Linear::<T>::minus(self.C, other_.C),
            }
        }

        #[inline]
        fn all(self, test_: impl private::Fn(T) -> private::bool + private::Copy) -> private::bool {
            private::Linear::<T>::all(self.AB, test_)
                && private::Linear::<T>::all(self.B, test_)
                && private::Linear::<T>::all(self.BC, test_)
                && private::Linear::<T>::all(self.DC, test_)
                && private::Linear::<T>::all(self.C, test_)
        }
    }

    impl<T: private::Scalar> private::Linear<T> for FourBarAcceleration<T> {
        #[inline]
        fn plus(self, factor_: T, other_: Self) -> Self {
            Self {
                AB: private::Linear::<T>::plus(self.AB, factor_, other_.AB),
                B: private::Linear::<T>::plus(self.B, factor_, other_.B),
                BC: private::Linear::<T>::plus(self.BC, factor_, other_.BC),
                DC: private::Linear::<T>::plus(self.DC, factor_, other_.DC),
                C: private::Linear::<T>::plus(self.C, factor_, other_.C),
            }
        }

        #[inline]
        fn minus(self, other_: Self) -> Self {
            Self {
                AB: private::Linear::<T>::minus(self.AB, other_.AB),
                B: private::Linear::<T>::minus(self.B, other_.B),
                BC: private::Linear::<T>::minus(self.BC, other_.BC),
                DC: private::Linear::<T>::minus(self.DC, other_.DC),
                C: private::Linear::<T>::minus(self.C, other_.C),
            }
        }

        #[inline]
        fn all(self, test_: impl private::Fn(T) -> private::bool + private::Copy) -> private::bool {
            private::Linear::<T>::all(self.AB, test_)
                && private::Linear::<T>::all(self.B, test_)
                && private::Linear::<T>::all(self.BC, test_)
                && private::Linear::<T>::all(self.DC, test_)
                && private::Linear::<T>::all(self.C, test_)
        }
    }

    impl<T: private::Scalar> private::Linear<T> for FourBarMotion<T> {
        #[inline]
        fn plus(self, factor_: T, other_: Self) -> Self {
            Self {
                position: private::Linear::<T>::plus(self.position, factor_, other_.position),
                velocity: private::Linear::<T>::plus(self.velocity, factor_, other_.velocity),
                acceleration: private::Linear::<T>::plus(
                    self.acceleration,
                    factor_,
                    other_.acceleration,
                ),
            }
        }

        #[inline]
        fn minus(self, other_: Self) -> Self {
            Self {
                position: private::Linear::<T>::minus(self.position, other_.position),
                velocity: private::Linear::<T>::minus(self.velocity, other_.velocity),
                acceleration: private::Linear::<T>::minus(self.acceleration, other_.acceleration),
            }
        }

        #[inline]
        fn all(self, test_: impl private::Fn(T) -> private::bool + private::Copy) -> private::bool {
            private::Linear::<T>::all(self.position, test_)
                && private::Linear::<T>::all(self.velocity, test_)
                && private::Linear::<T>::all(self.acceleration, test_)
        }
    }

    #[allow(dead_code, non_snake_case, reason = "names are as declared, and for editors alone")]
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

// The program.

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
