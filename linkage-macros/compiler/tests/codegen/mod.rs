//! The text of what small programs expand to.

pub(crate) mod apart;
pub(crate) mod c;
pub(crate) mod c_beyond;
pub(crate) mod c_builds;
pub(crate) mod c_constants;
pub(crate) mod c_export;
pub(crate) mod c_friction;
pub(crate) mod c_names;
pub(crate) mod c_only;
pub(crate) mod c_parallelograms;
pub(crate) mod c_printed;
pub(crate) mod c_program;
pub(crate) mod c_roots;
pub(crate) mod c_run_time;
pub(crate) mod docs;
pub(crate) mod fixture;
pub(crate) mod groups;
pub(crate) mod guards;
pub(crate) mod identifiers;
pub(crate) mod rubbing_page;
pub(crate) mod run_time;
pub(crate) mod several_inputs;
pub(crate) mod shared_constants;
#[path = "../../../../tests/skipped.rs"]
pub(crate) mod skipped;
pub(crate) mod spans;
pub(crate) mod st;
pub(crate) mod text;
pub(crate) mod turning;
pub(crate) mod unique_root;

use crate::function::Function;
use crate::ir::graph::{Graph, Id, Node};
use crate::ir::program::Program;
use crate::lower::lower;
use crate::model::mechanism::Mechanism;
use crate::pipeline::Options;
use fixture::{exact, four_bar, one_value, table};
pub(crate) use linkage_compiler::codegen::*;
use proc_macro2::{Group, TokenStream, TokenTree};

/// The items of all `impl` blocks in the unnamed constant.
pub(crate) fn associated_items(file: &syn::File) -> Vec<&syn::ImplItem> {
    let blocks = file.items.iter().filter_map(|item| match item {
        syn::Item::Const(item) => match &*item.expr {
            syn::Expr::Block(block) => Some(&block.block.stmts),
            _ => None,
        },
        _ => None,
    });
    let of = |statement| match statement {
        &syn::Stmt::Item(syn::Item::Impl(ref item)) => &item.items[..],
        _ => &[],
    };
    blocks.flatten().flat_map(of).collect()
}

/// Everything that the program expands to.
fn generate(mechanism: &Mechanism, program: &Program) -> TokenStream {
    linkage_compiler::codegen::generate(mechanism, &lower(mechanism, program), (None, None), false)
}

/// The tokens with a doc attribute for every line, as a source has them.
pub(super) fn line_by_line(stream: TokenStream) -> TokenStream {
    let mut lines = TokenStream::new();
    for tree in stream {
        let TokenTree::Group(group) = tree else {
            lines.extend([tree]);
            continue;
        };
        match syn::parse2::<syn::MetaNameValue>(group.stream()) {
            Ok(syn::MetaNameValue { path, value: syn::Expr::Lit(text), .. })
                if path.is_ident("doc") =>
            {
                let syn::Lit::Str(text) = &text.lit else { continue };
                let text = text.value();
                for (nth, line) in text.split('\n').enumerate() {
                    let hash = (nth > 0).then(|| quote::quote!(#));
                    lines.extend(quote::quote!(#hash [doc = #line]));
                }
            }
            _ => {
                let inner = line_by_line(group.stream());
                lines.extend([TokenTree::from(Group::new(group.delimiter(), inner))]);
            }
        }
    }
    lines
}

fn expand((mechanism, program): &(Mechanism, Program)) -> String {
    let tokens = line_by_line(generate(mechanism, program));
    prettyplease::unparse(&file(tokens))
}

/// The items of the expansion, out of their module.
pub(crate) fn file(tokens: TokenStream) -> syn::File {
    let mut file: syn::File = syn::parse2(tokens).expect("the expansion is a list of items");
    let content = file.items.iter_mut().find_map(|item| match item {
        syn::Item::Mod(module) => module.content.take(),
        _ => None,
    });
    file.items = content.map_or(file.items, |(_, items)| items);
    file
}

/// The text of one function, from its name to the closing brace at its own depth.
fn function<'a>(text: &'a str, name: &str) -> &'a str {
    let start = text.find(&format!("fn {name}(")).unwrap_or_else(|| panic!("no {name} in\n{text}"));
    let line = text[..start].rfind('\n').map_or(0, |end| end + 1);
    let indent = &text[line..line + text[line..].len() - text[line..].trim_start().len()];
    let end = text[start..].find(&format!("\n{indent}}}")).expect("a function ends");
    &text[start..start + end]
}

/// The text on one line, as if it were short.
fn squeezed(text: &str) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let layout = [
        (" .", "."),
        ("( ", "("),
        (", )", ")"),
        (" )", ")"),
        ("[ ", "["),
        (", ]", "]"),
        (", }", " }"),
    ];
    layout.iter().fold(text, |text, (long, short)| text.replace(long, short))
}

fn angle(graph: &mut Graph) -> Id {
    graph.push(Node::Input { input: 0, order: 0 })
}

#[test]
fn the_four_bar_expands_to_the_whole_interface() {
    let text = expand(&four_bar());
    for part in [
        "use ::linkage_core::private;",
        "#[derive(Clone, Copy, Debug, PartialEq)]",
        "pub struct FourBar<T = f64> {",
        "pub elbow: Side,",
        "pub struct FourBarPosition<T = f64> {",
        "pub BC: AngularVelocity<T>,",
        "pub struct FourBarMotion<T = f64> {",
        "pub struct FourBarMargins<T = f64> {",
        "pub const INPUTS: [&'static str; 1] = [\"theta\"];",
        "pub const PARAMS: [&'static str; 1] = [\"crank\"];",
        "crank: 0.08,",
        "crank: T::num(0.08),",
        "elbow: Side::Left,",
        "pub fn lift<U: Scalar>(&self) -> FourBar<U> {",
        "private::with_ad! {",
    ] {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
    let rows = "OUTPUTS: [&'static str; 5] = [\"C.x\", \"C.y\", \"BC.angle\", \"DC.angle\", \
                \"DC.margin\"];";
    assert!(squeezed(&text).contains(rows), "{text}");
}

#[test]
fn docs_pass_the_users_words_on_and_say_what_a_thing_is() {
    let text = expand(&four_bar());
    for part in [
        "/// A crank-rocker.\n///\n/// Solver of position, velocity and acceleration",
        "/// - `theta` in rad: The crank's angle.\n",
        "/// - crank AB\n/// - rrr BC, DC\n",
        "    /// The coupler's pin.\n    ///\n    /// Point `C` (rrr BC, DC): velocity in m/s.\n    pub C:",
        "    /// Link `BC` (rrr BC, DC): angular velocity in rad/s, counter-clockwise.\n    pub BC:",
        "    /// Parameter `crank` in m; as declared 0.08.\n    pub crank: T,",
        "    /// Assembly mode `elbow`, `Side::Left` or `Side::Right`; as declared left.\n    pub elbow:",
    ] {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
}

#[test]
fn sine_and_cosine_are_one_call() {
    let text = expand(&one_value(|g| {
        let angle = angle(g);
        let (sin, cos) =
            (g.push(Node::Apply(Function::Sin, angle)), g.push(Node::Apply(Function::Cos, angle)));
        g.push(Node::Mul(sin, cos))
    }));
    let formulas = squeezed(function(&text, "formulas_position_"));
    let call = "let (v1_, v2_) = checks_.sin_cos(theta);";
    assert!(formulas.contains(call), "{formulas}");
    assert_eq!(formulas.matches("sin_cos").count(), 1);
}

#[test]
fn an_unneeded_sine_is_dropped_and_a_constant_angle_is_not_guarded() {
    let text = expand(&one_value(|g| {
        let angle = g.constant(exact("1e9"));
        g.push(Node::Apply(Function::Cos, angle))
    }));
    let formulas = function(&text, "formulas_position_");
    let call = "let (_, v1_) = T::sin_cos(T::num(1000000000.0));";
    assert!(formulas.contains(call), "{formulas}");
    assert!(formulas.contains("let _ = checks_;"), "an unread argument is named\n{formulas}");
    assert!(formulas.contains("let _ = theta;"), "an unread argument is named\n{formulas}");
}

#[test]
fn constants_are_rounded_to_both_widths_and_beyond_a_width_are_infinite() {
    let text = expand(&one_value(|g| {
        let third = exact("1").div(&exact("3")).expect("three is not zero");
        let constant = g.intern(third.neg());
        let (high, low) = (g.push(Node::Constant(constant)), g.push(Node::Low(constant)));
        let large = g.constant(exact("1e300"));
        let sum = g.push(Node::Add(high, low));
        g.push(Node::Add(sum, large))
    }));
    let straight = function(&text, "formulas_position_");
    assert!(straight.contains("T::num(-0.3333333333333333)"), "{straight}");
    // 1/3 less its rounding is a third of 2^-54 in the one width, minus a third of 2^-25 in the other.
    assert!(straight.contains("T::lit(-1.850371707708594e-17, 9.934108e-9)"), "{straight}");
    assert!(straight.contains("T::num(1e300)"), "{straight}");
}

/// Just above the middle of two numbers of `f32`; rounded to `f64` first, the middle, and then the even one.
#[test]
fn a_constant_that_rounding_twice_would_change_is_two_literals() {
    let text = expand(&one_value(|g| {
        let power = |exponent: u32| {
            let power = exact(&2_u64.pow(exponent).to_string());
            exact("1").div(&power).expect("a power is not zero")
        };
        let above = exact("1").add(&power(24)).add(&power(60));
        g.constant(above)
    }));
    let straight = function(&text, "formulas_position_");
    assert!(straight.contains("T::lit(1.0000000596046448, 1.0000001)"), "{straight}");
}

#[test]
fn several_inputs_are_a_record_or_an_array() {
    let text = expand(&table());
    let all = squeezed(&text);
    assert!(all.contains("struct TableInput<T = f64> {"), "{text}");
    assert!(all.contains("From<[T; 2]> for TableInput<T> {"), "{text}");
    assert!(all.contains("fn from(list_: [T; 2]) -> Self { Record::from_array(list_) }"), "{text}");
    assert!(all.contains("rates: impl Inputs<TableInput<T>>"));
    assert!(all.contains("let rates: TableInput<T> = Into::into(rates);"));
    let formulas = squeezed(function(&text, "formulas_velocity_"));
    assert!(
        formulas.contains("let v14_ = (rates.s * inputs.X) + (inputs.s * rates.X);"),
        "{formulas}"
    );
    let inputs =
        "&[(inputs.s, \"s\"), (rates.s, \"s_rate\"), (inputs.X, \"X\"), (rates.X, \"X_rate\")],";
    assert!(all.contains(inputs), "{text}");
}

#[test]
fn coefficients_are_a_row_an_output_and_a_column_an_input() {
    let text = expand(&table());
    let coefficients = squeezed(function(&text, "formulas_coefficients_"));
    // The function binds a constant at its start if it reads the constant more than once.
    assert!(coefficients.contains("let k0_ = T::num(0.0); let k1_ = T::num(1.0);"));
    let coefficients = coefficients.replace("k0_", "0").replace("k1_", "1");
    let rows = "[[0, 0], [v4_, 0], [0, 1], [inputs.X, inputs.s], [1, 0]]";
    assert!(coefficients.ends_with(rows), "{coefficients}");
    let core = squeezed(function(&text, "core_coefficients_"));
    assert!(core.contains("([[T; 2]; 5], T::Mask)"), "{core}");
    // All but one row are constants, and need no test.
    assert!(core.contains("T::is_finite(result_[3][1] + result_[3][0])"), "{core}");
}

#[test]
fn without_numeric_parameters_a_hidden_field_keeps_the_type_parameter() {
    let text = expand(&table());
    let hidden = "#[doc(hidden)]\n    pub use_new_: PhantomData<T>,";
    assert!(text.contains(hidden), "{text}");
    assert!(!text.contains("fn sensitivity"), "{text}");
    assert!(text.contains("way: private::Sense::Behind,"), "{text}");
}

#[test]
fn a_dominated_result_is_not_tested_again() {
    let text = expand(&four_bar());
    let at = squeezed(function(&text, "core_position_at_"));
    // C, both directions; the margin is a numerator on the way to all of them.
    let test = at.split("T::is_finite(").nth(1).expect("results are tested");
    let test = test.split(';').next().unwrap_or_default();
    assert_eq!(test.matches("result_.").count(), 6, "{test}");
    assert!(!at.contains("is_near"), "{at}");
    assert!(at.starts_with("fn core_position_at_(&self, cos: T, sin: T)"), "{at}");
}

#[test]
fn orders_share_their_formulas_and_angles_those_of_their_cosines() {
    let text = squeezed(&expand(&four_bar()));
    assert_eq!(text.matches("fn formulas_").count(), 2, "{text}");
    assert_eq!(text.matches("T::sqrt(").count(), 1, "{text}");
    for part in [
        "fn formulas_at_<const ORDER: usize>(",
        "let velocity_: FourBarVelocity<T> = Record::from_array([zero_; 5]);",
        "let dc_cos_ = ",
        "DC: Direction { cos: dc_cos_, sin: dc_sin_ },",
        "if ORDER == 0 { return FourBarMotion { position: position_, velocity: velocity_,",
        "if ORDER == 1 { return FourBarMotion { position: position_, velocity: velocity_,",
        "self.formulas_at_::<0>(&mut all_met_, cos, sin, T::num(0.0), T::num(0.0)).position",
        "self.formulas_at_::<1>(checks_, cos, sin, theta_rate, T::num(0.0)).velocity",
        "let (sin_, cos_) = T::sin_cos_near(theta); \
         let (result_, ok_) = self.core_position_at_(cos_, sin_); \
         (result_, T::is_near(theta) & ok_)",
        "let (result_, ok_) = self.solve_velocity(theta, T::num(1.0)); \
         (private::column(result_.rows()), ok_)",
        "let result_ = if ok_ { result_ } else { private::apart(private::from_angle(theta, \"theta\", \
         move |cos_, sin_| { self.diagnose_velocity_at_(cos_, sin_, T::num(1.0)) }), 0)? };",
        "let (result_, ok_) = self.solve_motion_at(cos, sin, theta_rate, theta_acceleration);",
    ] {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
}

#[test]
fn the_crate_may_have_another_name() {
    let (mut mechanism, program) = four_bar();
    mechanism.crate_path = Some(syn::parse_quote!(::renamed));
    let text = expand(&(mechanism, program));
    assert!(!text.contains("linkage_core"), "{text}");
    assert!(text.contains("use ::renamed::private;"), "{text}");
}

#[test]
fn an_operation_inside_of_another_has_parentheses_beside_a_sign_alone() {
    let text = expand(&one_value(|g| {
        let angle = angle(g);
        let sine = g.push(Node::Apply(Function::Sin, angle));
        let negated = g.push(Node::Neg(angle));
        let sum = g.push(Node::Add(sine, negated));
        let difference = g.push(Node::Sub(sine, angle));
        let opposite = g.push(Node::Neg(difference));
        let quotient = g.push(Node::Div(sum, opposite));
        g.push(Node::Fused(sine, angle, quotient))
    }));
    let body = squeezed(function(&text, "formulas_position_"));
    assert!(body.contains("T::fused(v1_, theta, (v1_ + -theta) / -(v1_ - theta))"), "{body}");
}

/// The expansion without what its layout alone decides.
fn bare(text: &str) -> String {
    let text = text.replace("::linkage_core::private::", "").replace("private::", "");
    let text: String = text.split_whitespace().collect();
    text.replace(",)", ")").replace(",]", "]").replace(",}", "}").replace(",>", ">")
}

fn assert_has(mechanism: &(Mechanism, Program), parts: &[&str]) {
    let text = bare(&expand(mechanism));
    for part in parts {
        assert!(text.contains(&bare(part)), "no `{part}`");
    }
}

#[test]
fn a_sweep_takes_series_and_gives_components() {
    assert_has(
        &four_bar(),
        &[
            "fn sweep_position<'series>(&self, theta: impl Into<Series<'series, T>>, \
             out: FourBarPosition<&mut [T]>, status: &mut [Status], progress: impl Progress) \
             -> Result<(), LengthMismatch> {",
            "sweep::<OfVelocity, _, _, 2, 5>(self, [Into::into(theta), Into::into(theta_rate)],",
            "Record::into_array(out), status, progress",
            "impl<T: Real> Solver for FourBar<T> {",
            "put_solved(lifted_.solve_velocity(given_(0), given_(1)), put_)",
            "fn into_array(self) -> [T; 5] { [self.C.x, self.C.y, self.BC.omega, self.DC.omega,",
        ],
    );
    // Coefficients, margins and given cosines have no sweep.
    assert_eq!(expand(&four_bar()).matches("fn sweep_").count(), 3);
}

/// A result is not taken apart to be put together again: the user's lints would object to it.
#[test]
fn what_a_single_call_gives_as_a_list_is_handed_on() {
    let text = "pub struct Arm { input a, b: angle; ground O(0, 0);
        crank AB(O) -> B { length: 1m, angle: a } crank BC(B) -> C { length: 1m, angle: b }
        mass 1kg on B; mass 1kg on C; }";
    let tokens = text.parse().expect("these are tokens");
    let text = bare(&crate::pipeline::compile(tokens, &Options::NONE).tokens.to_string());
    let handed_on = "[x4_, x5_]).map(|result_| put_(&result_))";
    assert!(text.contains(&bare(handed_on)), "no `{handed_on}`");
    assert!(!text.contains(&bare("Ok(self.forward_dynamics(")));
}
