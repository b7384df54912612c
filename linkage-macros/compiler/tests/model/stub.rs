//! The interface that a declaration with mistakes still offers to the code that uses it.

use std::collections::HashSet;

use crate::codegen::{associated_items, file};
use crate::diagnostics::Diagnostics;
use crate::model::{self, Stub};
use crate::pipeline;
use crate::syntax::parse;
use quote::ToTokens;
use syn::{File, ImplItem, Item};

fn expand(source: &str) -> File {
    let mut diagnostics = Diagnostics::new();
    let tokens = source.parse().expect("the source is made of Rust's tokens");
    let tree = parse(tokens, &mut diagnostics).expect("the declaration has a name");
    let stub = match model::resolve(&tree, &mut diagnostics) {
        Ok(_) => model::stub(&tree),
        Err(Stub(mechanism)) => *mechanism,
    };
    drop(diagnostics.into_mistakes());
    file(pipeline::stub(&tree, &stub, &pipeline::Options::NONE))
}

/// The fields of a generated struct as `name: type`, without paths; `None` where there is no such
/// struct.
fn fields(file: &File, name: &str) -> Option<String> {
    file.items.iter().find_map(|item| match item {
        Item::Struct(item) if item.ident == name => {
            let fields = item.fields.iter().map(|field| {
                let name = field.ident.as_ref().expect("records have named fields");
                let ty = field.ty.to_token_stream().to_string().replace(' ', "");
                format!("{name}: {}", ty.replace("private::", ""))
            });
            Some(fields.collect::<Vec<_>>().join(", "))
        }
        _ => None,
    })
}

/// The signatures' names of all methods, also those that need a feature.
fn methods(file: &File) -> Vec<String> {
    associated_items(file)
        .into_iter()
        .filter_map(|item| match item {
            ImplItem::Fn(method) => Some(method.sig.ident.to_string()),
            _ => None,
        })
        .collect()
}

fn constant(file: &File, name: &str) -> String {
    let value = associated_items(file).into_iter().find_map(|item| match item {
        ImplItem::Const(item) if item.ident == name => {
            Some(item.expr.to_token_stream().to_string())
        }
        _ => None,
    });
    value.expect("the constant exists")
}

const SHEAR: &str = "
    input theta: angle;
    param l = 632 mm;
    param elbow: mode = left;
    param side: mode = ahead;
    ground A(0, 0), D(665.7mm 0);
    guide rail through A along;
    crank AB(A) => B { length 80mm }
    rrr BC(B), DC() -> C { lengths: (l, 0x10), mode: elbow }
    rrp CP(C), ram(rail) -> P;
    rpr block(B), bar(D) { }
    point blade on BC (500mm, -60mm);
";

#[test]
fn every_moving_point_and_link_that_was_named_is_a_field() {
    let file = expand(&format!("pub struct Shear {{ {SHEAR} }}"));
    assert_eq!(
        fields(&file, "ShearPosition").as_deref(),
        Some(
            "AB: Direction<T>, B: Point<T>, BC: Direction<T>, DC: Direction<T>, C: Point<T>, \
             CP: Direction<T>, ram: SlidingDirection<T>, P: Point<T>, \
             block: SlidingDirection<T>, bar: Direction<T>, blade: Point<T>"
        )
    );
    let velocity = fields(&file, "ShearVelocity").expect("there are velocities");
    assert!(velocity.ends_with("bar: AngularVelocity<T>, blade: Point<T>"), "{velocity}");
    assert_eq!(
        fields(&file, "ShearMotion").as_deref(),
        Some(
            "position: ShearPosition<T>, velocity: ShearVelocity<T>, \
             acceleration: ShearAcceleration<T>"
        )
    );
}

#[test]
fn parameters_are_fields_of_the_struct() {
    let file = expand(&format!("pub struct Shear {{ {SHEAR} }}"));
    assert_eq!(fields(&file, "Shear").as_deref(), Some("l: T, elbow: Side, side: Sense"));
    assert_eq!(constant(&file, "PARAMS"), "[\"l\"]");
    assert_eq!(constant(&file, "INPUTS"), "[\"theta\"]");
}

#[test]
fn every_method_exists() {
    let file = expand(&format!("pub struct Shear {{ {SHEAR} }}"));
    let methods = methods(&file);
    for name in [
        "new",
        "default",
        "lift",
        "position",
        "velocity",
        "motion",
        "coefficients",
        "position_at",
        "velocity_at",
        "motion_at",
        "solve_position",
        "solve_velocity",
        "solve_motion",
        "rows",
    ] {
        assert!(methods.iter().any(|method| method == name), "no `{name}` in {methods:?}");
    }
    let text = file.to_token_stream().to_string();
    assert!(text.contains("fn jacobian") && text.contains("fn sensitivity"), "{text}");
}

#[test]
fn outputs_that_are_understood_are_the_fields() {
    let file = expand(&format!(
        "struct Shear {{ {SHEAR} let turn = BC.angle - DC.angle; let half = l / 2;
         output blade, ram.slide, DC.angle, fold = 2 * turn, gap = half, D, ram.angle }}"
    ));
    assert_eq!(
        fields(&file, "ShearPosition").as_deref(),
        Some(
            "blade: Point<T>, ram: SlidingDirection<T>, DC: Direction<T>, fold: Direction<T>, \
             gap: T, D: Point<T>"
        )
    );
    assert_eq!(
        constant(&file, "OUTPUTS"),
        "[\"blade.x\" , \"blade.y\" , \"ram.angle\" , \"ram.slide\" , \"DC.angle\" , \"fold\" , \
         \"gap\" , \"D.x\" , \"D.y\"]"
    );
}

/// One that is asked for is there, and nothing else with it.
#[test]
fn a_part_of_a_joint_that_is_understood_is_the_only_force() {
    let file = expand(
        "struct M { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: t } mass 1kg on B;
         friction 0.1 on AB at A radius 8mm; output AB.A.friction; }",
    );
    assert_eq!(fields(&file, "MForces").as_deref(), Some("AB: MForcesOfAB<T>"));
    assert_eq!(fields(&file, "MForcesOfAB").as_deref(), Some("A_friction: T"));
}

#[test]
fn an_output_that_is_not_understood_may_be_any_name() {
    let file = expand(&format!("struct Shear {{ {SHEAR} output ram.slide, balde; }}"));
    let fields = fields(&file, "ShearPosition").expect("there are positions");
    for field in ["ram: Slide<T>", "A: Point<T>", "blade: Point<T>", "BC: Direction<T>"] {
        assert!(fields.contains(field), "no `{field}` in {fields}");
    }
}

#[test]
fn a_named_output_that_is_not_understood_is_an_angle_if_it_holds_one() {
    let file = expand(&format!(
        "struct Shear {{ {SHEAR} let turn = BC.angle + nothing;
         output fold = BC.angle - nobody.angle, swing = 2 * turn, gap = l + nothing; }}"
    ));
    let expected = Some("fold: Direction<T>, swing: Direction<T>, gap: T");
    assert_eq!(fields(&file, "ShearPosition").as_deref(), expected);
}

#[test]
fn margins_have_a_record_of_their_own() {
    let file = expand(&format!("struct Shear {{ {SHEAR} output BC.margin, DC.transmission; }}"));
    let margins = Some("BC_margin: T, DC_transmission: T");
    assert_eq!(fields(&file, "ShearPosition").as_deref(), margins);
    assert_eq!(fields(&file, "ShearMargins").as_deref(), margins);
    assert!(methods(&file).iter().any(|method| method == "margins"));
}

#[test]
fn several_inputs_are_a_record_and_no_input_is_one() {
    let file = expand("struct M { input s x: length; point P at (s, x); }");
    assert_eq!(fields(&file, "MInput").as_deref(), Some("s: T, x: T"));
    let file = expand("struct M { point P at (0, 0); }");
    assert_eq!(fields(&file, "MInput"), None);
    assert_eq!(constant(&file, "INPUTS"), "[\"input\"]");
}

#[test]
fn the_first_of_two_equal_names_counts() {
    let file = expand(
        "struct M { input a, a: angle; input a: angle; param p = 1; param p: mode = left;
         ground B(0, 0); crank X(B) -> X { } rrr X(B), Y(B) -> B { } point Y at (0, 0);
         output X, X.angle, Y, X = 1; }",
    );
    assert_eq!(fields(&file, "M").as_deref(), Some("p: T"));
    assert_eq!(fields(&file, "MPosition").as_deref(), Some("X: Direction<T>, Y: Direction<T>"));
    assert_eq!(constant(&file, "INPUTS"), "[\"a\"]");
}

#[test]
fn a_group_that_is_not_known_may_have_slid() {
    let file = expand("struct M { prr piston(rail), BC(B) -> C { } }");
    assert_eq!(
        fields(&file, "MPosition").as_deref(),
        Some("piston: SlidingDirection<T>, BC: SlidingDirection<T>, C: Point<T>")
    );
}

/// The docs of every field and function, in one text.
fn docs(file: &File) -> String {
    fn collect(tokens: proc_macro2::TokenStream, text: &mut String) {
        let mut is_doc = false;
        for tree in tokens {
            match tree {
                proc_macro2::TokenTree::Group(group) => collect(group.stream(), text),
                proc_macro2::TokenTree::Literal(line) if is_doc => *text += &format!("{line}\n"),
                tree => is_doc = tree.to_string() == "doc" || is_doc && tree.to_string() == "=",
            }
        }
    }
    let mut text = String::new();
    collect(file.to_token_stream(), &mut text);
    text
}

/// The user's comments and the kinds stay; what would follow from the whole declaration is not known.
#[test]
fn docs_say_nothing_that_is_not_known() {
    const MACHINE: &str = "
        /// Angle of the crank.
        input theta: angle;
        input s: length;
        input broken: lenght;
        /// Coupler.
        param l = 632mm;
        param elbow: mode = left;
        /// Cutting force.
        load cut: force;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B { length: 80mm, angle: theta }
        /// The dyad.
        rrr BC(B), DC(D) -> C { lengths: (l, 374mm), mode: elbow }
        /// Edge of the knife.
        point blade on BC at (500mm, -60mm);
        mass 2kg on BC uniform;
        force (-cut, 0) on blade;";
    let docs = docs(&expand(&format!("/// A shear.\npub struct Shear {{ {MACHINE} }}")));
    for kept in [
        "A shear.",
        "Angle of the crank.",
        "Input `theta` in rad.",
        "Input `s` in m.",
        "Input `broken`.",
        "Coupler.",
        "Parameter `l`.",
        "Mode `elbow`.",
        "Edge of the knife.",
        "Point `blade`.",
        "Link `BC`.",
        "`BC.B`.",
        "has mistakes",
    ] {
        assert!(docs.contains(kept), "no `{kept}` in {docs}");
    }
    for derived in [
        "Cost",
        "cost",
        "as declared 0",
        "addition",
        "no operation",
        "closed form",
        "Range",
        "Groups",
        "exerted",
    ] {
        assert!(!docs.contains(derived), "`{derived}` in {docs}");
    }
}

#[test]
fn an_empty_declaration_has_types_too() {
    let file = expand("struct M { }");
    assert_eq!(fields(&file, "M").as_deref(), Some("use_new_: PhantomData<T>"));
    assert_eq!(fields(&file, "MPosition").as_deref(), Some("nothing_: T"));
}

#[test]
fn the_run_time_crate_is_where_the_declaration_says() {
    let file = expand("struct M { crate = a::b; ground 5; }");
    let text = file.to_token_stream().to_string();
    assert!(text.contains("a :: b :: private") && !text.contains("linkage_core"), "{text}");
}

/// Names in any order and number never make a field twice, nor a struct without one.
/// Thirty declarations; `.ci/nightly` takes three hundred.
#[test]
fn any_statements_have_stubs() {
    have_stubs(30);
}

#[test]
#[ignore = "minutes: `.ci/nightly` takes it"]
fn many_statements_have_stubs() {
    have_stubs(300);
}

fn have_stubs(declarations: usize) {
    const STATEMENTS: &[&str] = &[
        "input A: angle;",
        "input B, X: length;",
        "param A = 1;",
        "param X: mode = ahead;",
        "param C = 1kgg;",
        "unknown U: angle between (1, 0);",
        "guide G through Q along C;",
        "load F: newton;",
        "spring S between A and X { stiffness: C }",
        "mass C on A uniform;",
        "let A = X.angle;",
        "let B = -A + f(B, 1);",
        "ground A(0, 0), X(1, 1);",
        "guide B through A along 0;",
        "point X on A at (0, 0);",
        "crank A(B) -> X { }",
        "rpp X(A), B(A) { }",
        "rrr A(B), B(X), C(X) -> A { }",
        "zzz B(B) -> B { }",
        "output A, B.slide, X.angle;",
        "output X = A, X.margin, A.margin, B.transmission;",
        "output B, nothing, 2 * A;",
        "output E = C + A.angle, U, S.force, A.drive, A.G, energy;",
        "rrp E(A), H(G) -> K { length: C }",
        "numerics compensated;",
        "export c;",
    ];
    // Knuth's MMIX generator; the high bits are good.
    let mut state = 7_u64;
    let mut draw = |below: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % below
    };
    for _ in 0..declarations {
        let count = draw(8);
        let statements: Vec<&str> =
            (0..count).map(|_| STATEMENTS[draw(STATEMENTS.len())]).collect();
        let file = expand(&format!("struct M {{ {} }}", statements.join(" ")));
        for item in &file.items {
            let Item::Struct(item) = item else { continue };
            let mut seen = HashSet::new();
            let names = item.fields.iter().filter_map(|field| field.ident.as_ref());
            assert!(names.clone().all(|name| seen.insert(name.to_string())), "{statements:?}");
            assert!(!seen.is_empty(), "{statements:?}");
        }
        proc_macro2::extra::invalidate_current_thread_spans();
    }
}

#[test]
fn forces_are_offered_where_something_has_mass_or_acts() {
    const MACHINE: &str = "input t: angle; load cut: force; ground A(0, 0), D(1m, 0);
        guide rail through A along 0; crank AB(A) -> B { length: 1m, angle: t }
        rrr BC(B), DC(D) -> C { lengths: (1m), mode: left } slider ram(rail) -> P { slide: 1m }";
    let source = |more: &str| format!("pub struct M {{ {MACHINE} {more} }}");
    let names = ["forces", "statics", "energy", "sweep_forces", "solve_statics", "state_rates"];
    for acting in ["mass 1kg on BC uniform;", "mass 1kgg on;", "spring s between A and C { }"] {
        let file = expand(&source(acting));
        let methods = methods(&file);
        assert!(names.iter().all(|name| methods.iter().any(|known| known == name)), "{acting}");
        let of =
            |link: &str| fields(&file, &format!("MForcesOf{link}")).expect("there is a record");
        // No length of the crank is driven.
        assert_eq!(of("AB"), "drive: T, A: Force<T>, B: Force<T>");
        assert_eq!(of("DC"), "push: T, D: Force<T>, C: Force<T>");
        assert_eq!(of("ram"), "drive: T, rail: GuideForce<T>, P: Force<T>");
        assert_eq!(of("t"), "drive: T");
        let all = fields(&file, "MForces").expect("there is a record");
        assert!(all.ends_with("shaking: Shaking<T>"), "{all}");
    }
    // A guide that nothing declares is one where the link slides.
    let file = expand(&source("rrp CE(C), block(bed) -> E { length: 1m } mass 1kg on E;"));
    let block = fields(&file, "MForcesOfblock").expect("there is a record");
    assert_eq!(block, "push: T, bed: GuideForce<T>, E: Force<T>");
    let file = expand(&source("spring s between A and C { }"));
    assert_eq!(fields(&file, "MForcesOfs").expect("a record"), "force: T");
    assert!(!methods(&expand(&source(""))).iter().any(|name| name == "forces"));
}
