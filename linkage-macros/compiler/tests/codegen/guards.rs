//! Conditions in the generated code, on the fast path and on the slow path.

use super::fixture::{exact, one_value};
use super::{angle, expand, function, squeezed};
use crate::function::Function;
use crate::ir::graph::{Check, Graph, Guard, Id, Node};

#[test]
fn a_checks_is_given_what_it_looks_at_and_its_value_goes_on() {
    let text = expand(&one_value(|g| {
        let (angle, l1) = (angle(g), g.constant(exact("0.25")));
        let looked_at = g.push(Node::Apply2(Function::Hypot, angle, angle));
        let operands = vec![looked_at, looked_at, l1, l1, l1];
        let guarded = g.guard(angle, Guard { check: Check::ReachCircles, group: 0, operands });
        g.push(Node::Apply(Function::Sqrt, guarded))
    }));
    let formulas = squeezed(function(&text, "formulas_position_"));
    assert!(formulas.contains("let v2_ = T::hypot(theta, theta);"), "{formulas}");
    assert!(formulas.contains("let k0_ = T::num(0.25);"), "{formulas}");
    let call = "let v3_ = checks_.guard(theta, private::ReachCircles([v2_, v2_, k0_, k0_, k0_], \"BC, DC\")); \
                let v4_ = T::sqrt(v3_);";
    assert!(formulas.contains(call), "{formulas}");
}

#[test]
fn formulas_are_read_by_those_who_compare_and_who_diagnose() {
    let text = expand(&one_value(|g| {
        let angle = angle(g);
        g.guard(angle, Guard { check: Check::Nonzero, group: 0, operands: Vec::new() })
    }));
    let fast = squeezed(function(&text, "solve_position"));
    let compared = "let mut all_met_ = AllMet::new(); \
                 let result_ = self.formulas_position_(&mut all_met_, theta); \
                 (result_, all_met_.all() & T::is_finite(result_.y))";
    assert!(fast.contains(compared), "{fast}");
    let slow = squeezed(function(&text, "diagnose_position_"));
    let diagnosed = "private::diagnose(&[(theta, \"theta\")], |checks_| self.formulas_position_(checks_, theta))";
    assert!(slow.contains(diagnosed), "{slow}");
}

/// The calls that a guard becomes, on the square of the angle's sine or tangent less two.
fn guard(check: &Check, bounded: bool) -> Vec<String> {
    let text = expand(&one_value(|g| {
        let angle = angle(g);
        // Nothing is known of how large a tangent is.
        let angle = g.push(if bounded {
            Node::Apply(Function::Sin, angle)
        } else {
            Node::Apply(Function::Tan, angle)
        });
        let value = g.push(Node::Mul(angle, angle));
        let operands = vec![angle; 4];
        let two = g.constant(exact("2"));
        let value = g.push(Node::Sub(value, two));
        g.guard(value, Guard { check: check.clone(), group: 0, operands })
    }));
    let formulas = squeezed(function(&text, "formulas_position_"));
    let calls = formulas.split(" checks_.").skip(1);
    calls.map(|call| call.split(';').next().unwrap_or_default().to_string()).collect()
}

#[test]
fn every_check_is_marked_and_looked_at() {
    for (check, mark, look) in [
        (Check::Nonzero, "away", "Nonzero(\"BC, DC\")"),
        (Check::Positive("a".to_string()), "above", "Positive(\"BC, DC\", \"a\")"),
        (Check::ReachOffset, "at_least", "ReachOffset([v1_, v1_, v1_, v1_], \"BC, DC\")"),
    ] {
        let mark = format!("{mark}(v4_, T::num(0.0))");
        assert_eq!(guard(&check, false), [mark, format!("guard(v4_, private::{look})")]);
    }
    let (mark, look) = ("above_rounding(v4_, v1_)", "[v1_, v1_, v1_, v1_], \"BC, DC\")");
    for (check, name) in
        [(Check::ReachCircles, "ReachCircles"), (Check::ReachDistances, "ReachDistances")]
    {
        let look = format!("guard(v4_, private::{name}({look})");
        assert_eq!(guard(&check, false), [mark.to_string(), look.clone()]);
        // A spread that is not known before run time is compared with in any case.
        assert_eq!(guard(&check, true), ["sin_cos(theta)", mark, &look]);
    }
    let share = "guard(v4_, private::ShareOfCentres([v1_, v1_, v1_, v1_], \"BC, DC\"))";
    assert_eq!(guard(&Check::ShareOfCentres, false), [share]);
    let look = "guard(v4_, private::ReachLine([v1_, v1_, v1_, v1_], \"BC, DC\"))";
    let mark = "at_least(v4_, T::lit(2.2250738585072014e-308, 1.1754944e-38))";
    assert_eq!(guard(&Check::ReachLine, false), [mark, look]);
    assert_eq!(guard(&Check::ReachLine, true), ["sin_cos(theta)", mark, look]);
    let look = "guard(v4_, private::SquareOfCentres([v1_, v1_, v1_, v1_], \"BC, DC\"))";
    let check = Check::SquareOfCentres;
    assert_eq!(guard(&check, false), ["at_least(v4_, T::smallest_square())", look]);
    let mark = "at_least(v4_, T::lit(4.6e-277, 8.4e-25))";
    assert_eq!(guard(&check, true), ["sin_cos(theta)", mark, look]);
}

#[test]
fn what_is_above_zero_is_not_asked_whether_it_is_zero() {
    let text = expand(&one_value(|g| {
        let angle = angle(g);
        [Check::ReachCircles, Check::Nonzero].into_iter().fold(angle, |value, check| {
            g.guard(value, Guard { check, group: 0, operands: vec![angle; 4] })
        })
    }));
    let formulas = function(&text, "formulas_position_");
    assert_eq!(formulas.matches(".above").count(), 1, "{formulas}");
    assert_eq!(formulas.matches(".away").count(), 0, "{formulas}");
    assert_eq!(formulas.matches("Nonzero(").count(), 1, "{formulas}");
}

/// The mask of the fast path on a quotient of two numbers made from the angle's sine.
fn mask(divisor: impl FnOnce(&mut Graph, Id) -> Id) -> String {
    let text = expand(&one_value(|g| {
        let angle = angle(g);
        let sine = g.push(Node::Apply(Function::Sin, angle));
        let divisor = divisor(g, sine);
        let group = Guard { check: Check::Nonzero, group: 0, operands: Vec::new() };
        let divisor = g.guard(divisor, group);
        g.push(Node::Div(sine, divisor))
    }));
    squeezed(function(&text, "solve_position"))
}

#[test]
fn bounds_are_asked_in_place_of_results() {
    let known = mask(|g, sine| {
        let two = g.constant(exact("2"));
        g.push(Node::Add(two, sine))
    });
    let unless = "private::is_finite_unless(T::plain(true, true), result_.y)";
    assert!(known.contains(unless), "{known}");
    let unknown = mask(|g, sine| g.push(Node::Apply(Function::Tan, sine)));
    assert!(unknown.contains("all_met_.all() & T::is_finite(result_.y)"), "{unknown}");
}

#[test]
fn bounds_of_one_width_leave_the_other_its_own_questions() {
    let text = expand(&one_value(|g| {
        let angle = angle(g);
        let sine = g.push(Node::Apply(Function::Sin, angle));
        // Its square leaves the range of f32.
        let large = g.constant(exact("1e20"));
        let value = g.push(Node::Mul(large, sine));
        let square = g.push(Node::Mul(value, value));
        let square = g.guard(square, Guard { check: Check::Square, group: 0, operands: vec![] });
        g.push(Node::Apply(Function::Sqrt, square))
    }));
    let formulas = squeezed(function(&text, "formulas_position_"));
    assert!(formulas.contains("T::lit(4.6e-277, 8.4e-25)"), "{formulas}");
    assert!(squeezed(&text).contains("T::plain(true, false)"), "{text}");
}
