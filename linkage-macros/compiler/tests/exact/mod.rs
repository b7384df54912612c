//! Tests of the exact numbers.
//!
//! Expressions are written in postfix order: `20 deg sin 2 mul` is 2 sin 20°.

pub(crate) mod arithmetic;
pub(crate) mod enclosing;
pub(crate) mod forms;
pub(crate) mod reference;
pub(crate) mod rounding;
pub(crate) mod text;

use self::reference::Reference;
use crate::function::Function;
pub(crate) use linkage_compiler::exact::*;

fn number(text: &str) -> Exact {
    Exact::decimal(text).expect("a decimal literal")
}

/// The value of a postfix expression; `None` where it is undefined.
fn value(postfix: &str) -> Option<Exact> {
    let mut stack: Vec<Exact> = Vec::new();
    for word in postfix.split_whitespace() {
        if word == "pi" {
            stack.push(Exact::pi());
        } else if word.starts_with(|letter: char| letter.is_ascii_digit()) {
            stack.push(number(word));
        } else {
            let b = stack.pop().expect("an operand");
            let result = match unary(word, &b) {
                Some(result) => result,
                None => binary(word, &stack.pop().expect("two operands"), &b),
            };
            stack.push(result?);
        }
    }
    assert_eq!(stack.len(), 1, "an expression has one value");
    stack.pop()
}

/// The value of an expression that is defined.
fn defined(postfix: &str) -> Exact {
    value(postfix).unwrap_or_else(|| panic!("`{postfix}` is undefined"))
}

fn unary(word: &str, a: &Exact) -> Option<Option<Exact>> {
    Some(match word {
        "deg" => a.mul(&Exact::pi()).div(&Exact::integer(180)),
        "neg" => Some(a.neg()),
        _ => Exact::of(of_arity(word, 1)?, &[a]),
    })
}

fn binary(word: &str, a: &Exact, b: &Exact) -> Option<Exact> {
    match word {
        "add" => Some(a.add(b)),
        "sub" => Some(a.sub(b)),
        "mul" => Some(a.mul(b)),
        "div" => a.div(b),
        _ => Exact::of(of_arity(word, 2).expect("an operation"), &[a, b]),
    }
}

fn of_arity(word: &str, arity: usize) -> Option<Function> {
    Function::named(word).filter(|function| function.arity() == arity)
}

/// The enclosure of a postfix expression, operation by operation; `None` where one is undefined.
fn enclosed(postfix: &str, bits: u32) -> Option<Enclosure> {
    let mut stack: Vec<Enclosure> = Vec::new();
    for word in postfix.split_whitespace() {
        if word == "pi" {
            stack.push(Enclosure::pi(bits));
        } else if word.starts_with(|letter: char| letter.is_ascii_digit()) {
            stack.push(number(word).enclose(bits).expect("a rational has an enclosure"));
        } else {
            let b = stack.pop().expect("an operand");
            let result = match word {
                "deg" => b.mul(&Enclosure::pi(bits)).div(&Enclosure::integer(180, bits)),
                "neg" => Some(b.neg()),
                _ => match of_arity(word, 1) {
                    Some(function) => Enclosure::of(function, &[&b]),
                    None => enclosed_binary(word, &stack.pop().expect("two operands"), &b),
                },
            };
            stack.push(result?);
        }
    }
    stack.pop()
}

fn enclosed_binary(word: &str, a: &Enclosure, b: &Enclosure) -> Option<Enclosure> {
    match word {
        "add" => Some(a.add(b)),
        "sub" => Some(a.sub(b)),
        "mul" => Some(a.mul(b)),
        "div" => a.div(b),
        _ => Enclosure::of(of_arity(word, 2).expect("an operation"), &[a, b]),
    }
}

/// A generator of reproducible expressions (Lehmer, modulus 2^31 − 1).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0 * 48271 % 0x7fff_ffff;
        self.0 % bound
    }

    fn pick<'a>(&mut self, choices: &[&'a str]) -> &'a str {
        choices[self.below(choices.len() as u64) as usize]
    }

    /// A postfix expression of at most so many operations on top of each other.
    fn expression(&mut self, depth: u64) -> String {
        if depth == 0 {
            let angle = ["deg", "deg neg", "", "neg", "sqrt"];
            return match self.below(8) {
                0 => "pi".to_owned(),
                1 | 2 => format!("{} {}", 15 * self.below(30), self.pick(&["deg", "deg neg"])),
                3 | 4 => format!("{} {}", self.below(12), self.pick(&angle)),
                _ => format!("{}.{} {}", self.below(5), self.below(100), self.pick(&angle)),
            };
        }
        let first = self.expression(depth - 1);
        if self.below(2) == 0 {
            let functions = ["sin", "cos", "sin", "cos", "tan", "sqrt", "asin", "acos", "atan"];
            return format!("{first} {}", self.pick(&functions));
        }
        let second = depth - 1 - self.below(depth);
        let second = self.expression(second);
        let operations = ["add", "sub", "mul", "div", "mul", "add", "atan2", "hypot"];
        format!("{first} {second} {}", self.pick(&operations))
    }
}
