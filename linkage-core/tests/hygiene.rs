//! A declaration compiles wherever a user may put it, and no lint of the user's fires in it: the
//! strictest of them are on here, and continuous integration refuses every warning.

#![warn(clippy::pedantic, clippy::nursery)]
#![warn(
    missing_docs,
    elided_lifetimes_in_paths,
    explicit_outlives_requirements,
    missing_copy_implementations,
    missing_debug_implementations,
    redundant_lifetimes,
    single_use_lifetimes,
    trivial_casts,
    trivial_numeric_casts,
    unsafe_code,
    unused
)]
#![allow(unreachable_pub, clippy::float_cmp, reason = "modules of a test, and the same bits")]

extern crate linkage_core as renamed;

/// Four bars and what else a crank can move, with every kind of parameter and output.
macro_rules! press {
    ($path:path) => {
        ::linkage_core::mechanism! {
            /// A press.
            pub struct Press {
                crate = $path;
                input theta: angle;
                input lift: length;
                param reach = 0.9m;
                param side: mode = right;
                let half = reach / 2;
                ground A(0, 0), D(0.9m, half);
                guide rail through D along 20deg;
                crank AB(A) -> B { length: half / 3, angle: theta }
                crank wheel(A) { angle: AB.angle, relative_to: AB }
                guide slot on wheel through A along theta;
                rrr BC(B), DC(D) -> C { lengths: (reach, 0.6m + lift), mode: side }
                rrp BE(B), block(rail) -> E { length: 3m, offset: half, mode: ahead }
                slider ram(rail) -> R { slide: lift + half }
                prp p(slot), q(rail) -> S { }
                rpr sleeve(C), bar(A) { offset: 3.14159mm }
                rpp pin(B), yoke(rail) { slot: 80deg }
                point P on BC at polar (half, theta);
                output C, P, S, DC.margin, ram.slide, fold = BC.angle - DC.angle, sum = lift + half,
                       E, bar, yoke.slide;
            }
        }
    };
}

/// A four-bar of constants under any name.
macro_rules! four_bar {
    ($name:ident $(, $($statement:tt)*)?) => {
        linkage_core::mechanism! {
            struct $name {
                $($($statement)*)?
                input theta: angle;
                ground A(0, 0), D(304.8mm, 0);
                crank AB(A) -> B { length: 101.6mm, angle: theta }
                rrr BC(B), DC(D) -> C { lengths: (254mm, 177.8mm), mode: left }
            }
        }
    };
}

/// Nothing but the declaration is known, and what usually is means something else.
#[no_implicit_prelude]
mod without_prelude {
    #![allow(dead_code, reason = "the items are there to be in the way")]

    mod core {}
    mod std {}
    mod alloc {}
    mod linkage_core {}
    mod private {}
    struct Option;
    struct Result;
    struct Point;
    trait Scalar {}
    trait Clone {}

    press!(::linkage_core);

    pub const PRESS: Press = Press::new();
}

/// The crate has another name in the user's manifest, or stands behind a module.
mod under_another_name {
    press!(::renamed);

    mod inner {
        press!(super::super::renamed);

        pub const PRESS: Press = Press::new();
    }

    pub const PRESSES: [Press; 2] = [Press::new(), inner_press()];

    const fn inner_press() -> Press {
        let inner::Press { reach, side } = inner::PRESS;
        Press { reach, side }
    }
}

/// Items of the user's that are called what the declaration calls its points and links.
mod beside_items_of_the_same_names {
    #![allow(dead_code, reason = "the items are there to be in the way")]

    const A: f64 = 1.0;
    const B: &str = "a constant";
    static D: [u8; 2] = [0; 2];
    struct C;
    struct T;
    enum AB {}
    const fn position() {}
    const fn sin() {}

    four_bar!(FourBar);

    pub fn angle() -> f64 {
        FourBar::new().position(1.0).map_or(f64::NAN, |position| position.DC.angle())
    }
}

/// Types that are called what the language calls its own, and what is generic in the expansion.
mod beside_types_named_like_the_languages {
    #![allow(dead_code, non_camel_case_types, reason = "the items are there to be in the way")]

    struct W;
    struct F;
    enum V {}
    struct usize;
    struct f64;
    struct f32(());
    enum str {}
    mod bool {}
    type u32 = ();
    trait i32 {}
    union u8 {
        nothing: (),
    }

    press!(::linkage_core);
    four_bar!(FourBar);
    four_bar!(AmongTypes, export c;);

    pub fn angle() -> ::core::primitive::f64 {
        let position = FourBar::new().position(1.0);
        position.map_or(::core::primitive::f64::NAN, |position| position.DC.angle())
    }
}

/// Constants and statics that are called what arguments are, in lower case.
mod beside_constants_named_like_arguments {
    #![allow(dead_code, non_upper_case_globals, reason = "the items are there to be in the way")]
    #![allow(non_camel_case_types, reason = "a unit struct is a pattern as well")]

    const theta: f64 = 1.0;
    static theta_rate: f64 = 1.0;
    struct theta_acceleration;
    struct cos(f64);
    const sin: &str = "";
    static out: f64 = 1.0;
    struct status;
    const progress: () = ();
    const inputs: [f64; 2] = [0.0; 2];
    const rates: f64 = 0.0;
    static accelerations: f64 = 0.0;
    const lift: f64 = 0.0;
    const private: f64 = 0.0;
    const from: () = ();
    const to: () = ();
    const why: () = ();
    const name: () = ();
    const value: () = ();
    const answer: () = ();
    const reason: () = ();

    press!(::linkage_core);
    four_bar!(FourBar);
    four_bar!(AmongConstants, export c;);

    pub fn angle() -> f64 {
        FourBar::new().position(theta).map_or(f64::NAN, |position| position.DC.angle())
    }
}

/// Traits whose methods every type has are called what generated code calls.
mod beside_methods_of_every_type {
    #![allow(dead_code, reason = "the methods are there to be in the way")]

    trait Everywhere: Sized {
        fn angle(&self) {}
        fn rows(&self) {}
        fn lift(&self) {}
        fn position(&self) {}
        fn core_position_at_(&self) {}
        fn lit(self) {}
        fn sqrt(self) {}
        fn sin_cos(self) {}
        fn sin_cos_near(self) {}
        fn is_near(&self) {}
        fn is_finite(&self) {}
        fn above(&self) {}
        fn flipped(self) {}
    }

    impl<A> Everywhere for A {}

    press!(::linkage_core);
    four_bar!(FourBar);
    four_bar!(AmongMethods, export c;);

    pub fn angle() -> f64 {
        FourBar::new().position(1.0).map_or(f64::NAN, |position| position.DC.angle())
    }
}

/// Macros that are called what the prelude's are, and functions.
mod beside_macros_and_functions {
    #![allow(dead_code, unused_macros, reason = "the items are there to be in the way")]

    macro_rules! nothing_called {
        ($($name:ident)*) => {$(
            macro_rules! $name { () => { compile_error!("a macro of the user's") }; }
        )*};
    }
    nothing_called!(vec matches assert debug_assert format with_ad Clone);

    const fn theta() {}
    const fn out() {}
    const fn argument() {}
    #[allow(non_snake_case, reason = "it is in the way")]
    const fn Ok() {}
    #[allow(non_snake_case, reason = "it is in the way")]
    const fn Some() {}

    press!(::linkage_core);
    four_bar!(FourBar);
    four_bar!(AmongMacros, export c;);

    pub fn angle() -> f64 {
        FourBar::new().position(1.0).map_or(f64::NAN, |position| position.DC.angle())
    }
}

mod twice_in_one_module {
    four_bar!(First);
    four_bar!(Second);
    // Names that the generated code would like to have for itself.
    four_bar!(T);
    four_bar!(U);
    four_bar!(Names);

    pub fn angles() -> [f64; 5] {
        [
            First::new().position(1.0).map(|p| p.DC.angle()),
            Second::new().position(1.0).map(|p| p.DC.angle()),
            T::new().position(1.0).map(|p| p.DC.angle()),
            U::new().position(1.0).map(|p| p.DC.angle()),
            Names::new().position(1.0).map(|p| p.DC.angle()),
        ]
        .map(|angle| angle.unwrap_or(f64::NAN))
    }
}

/// Names that are no keyword, but those of arguments, fields and methods of generated code.
mod under_names_of_generated_code {
    #![allow(non_camel_case_types, reason = "the name is in the way of the hidden module")]

    linkage_core::mechanism! {
        pub struct Named {
            input out: angle;
            param use_new_: mode = left;
            ground status(0, 0), progress(304.8mm, 0);
            crank rows(status) -> x { length: 101.6mm, angle: out }
            rrr cos(x), omega(progress) -> position { lengths: (254mm, 177.8mm), mode: use_new_ }
        }
    }

    linkage_core::mechanism! {
        pub struct private {
            input sin: angle;
            ground guard_(0, 0);
            crank self_(guard_) -> result_ { length: 101.6mm, angle: sin }
        }
    }
}

#[test]
fn every_declaration_solves() {
    let expected = beside_items_of_the_same_names::angle();
    assert!(expected.is_finite());
    assert_eq!(twice_in_one_module::angles(), [expected; 5]);
    let beside = [
        beside_types_named_like_the_languages::angle(),
        beside_constants_named_like_arguments::angle(),
        beside_methods_of_every_type::angle(),
        beside_macros_and_functions::angle(),
    ];
    assert_eq!(beside, [expected; 4]);
    let [press, _] = under_another_name::PRESSES;
    let pin = press.position([1.0, 0.1]).expect("the press assembles").P;
    let bare = without_prelude::PRESS.position([1.0, 0.1]).expect("the press assembles").P;
    assert_eq!((pin.x, pin.y), (bare.x, bare.y));
}

#[test]
fn a_declaration_stands_inside_a_function() {
    four_bar!(FourBar);
    let bars = FourBar::new();
    let inner = || {
        four_bar!(FourBar);
        FourBar::new().position(1.0).expect("the bars assemble").C
    };
    assert_eq!(bars.position(1.0).expect("the bars assemble").C, inner());
}

#[test]
fn names_of_generated_code_can_be_given() {
    use under_names_of_generated_code::{Named, private};
    let named = Named::new();
    let position = named.position(1.0).expect("the bars assemble");
    assert_eq!(position.omega.angle(), beside_items_of_the_same_names::angle());
    let crank = private::new().position(0.0).expect("a crank assembles");
    assert_eq!(crank.result_.x, 0.1016);
}
