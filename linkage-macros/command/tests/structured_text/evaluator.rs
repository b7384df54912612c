//! An evaluator of what the reader reads, which stops where a controller may: at an infinity, at a number that is none,
//! at a division by zero, and at a root of less. It computes both sides of AND and OR, and rounds each operation to its
//! type. A literal has no type, so none but zero may stand beside a sign of arithmetic.

use super::reader::{Basic, Expr, Project, Statement, Unit};

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Lreal(f64),
    Real(f32),
    Literal(f64),
    Int(i64),
    Bool(bool),
    Text(String),
}

impl Value {
    pub(crate) fn of(basic: Basic, number: f64) -> Self {
        match basic {
            Basic::Lreal => Self::Lreal(number),
            Basic::Real => Self::Real(number as f32),
            Basic::Int => Self::Int(number as i64),
            Basic::Bool => Self::Bool(number != 0.0),
            Basic::Text => Self::Text(String::new()),
        }
    }

    pub(crate) fn number(&self) -> f64 {
        match *self {
            Self::Lreal(x) | Self::Literal(x) => x,
            Self::Real(x) => x.into(),
            Self::Int(n) => n as f64,
            Self::Bool(_) | Self::Text(_) => panic!("{self:?} is no number"),
        }
    }

    fn is(&self) -> bool {
        matches!(self, Self::Bool(true))
    }
}

/// The reason why a controller may have stopped.
pub(crate) type Stopped = String;

pub(crate) struct Machine<'a> {
    pub project: &'a Project,
}

enum Flow {
    On,
    Exit,
}

impl Machine<'_> {
    pub(crate) fn fresh(&self, unit: &Unit) -> Vec<Value> {
        unit.fields.iter().map(|field| Value::of(field.basic, field.first)).collect()
    }

    pub(crate) fn run(&self, unit: &Unit, numbers: &mut Vec<Value>) -> Result<(), Stopped> {
        self.statements(unit, &unit.body, numbers).map(|_| ())
    }

    fn statements(
        &self,
        unit: &Unit,
        statements: &[Statement],
        numbers: &mut Vec<Value>,
    ) -> Result<Flow, Stopped> {
        for statement in statements {
            match statement {
                Statement::Set(at, value) => {
                    let value = self.value(unit, value, numbers)?;
                    numbers[*at] = stored(unit.fields[*at].basic, value);
                }
                Statement::Exit => return Ok(Flow::Exit),
                Statement::Once(body) => _ = self.statements(unit, body, numbers)?,
                Statement::If(cases, rest) => {
                    let mut chosen = &rest[..];
                    for (condition, then) in cases {
                        if self.value(unit, condition, numbers)?.is() {
                            chosen = then;
                            break;
                        }
                    }
                    if let Flow::Exit = self.statements(unit, chosen, numbers)? {
                        return Ok(Flow::Exit);
                    }
                }
                Statement::Block(name, at, given) => {
                    let block = &self.project.units[name];
                    let mut own = numbers[*at..at + block.fields.len()].to_vec();
                    for (name, value) in given {
                        let pin = block.inputs.iter().find(|(pin, ..)| pin == name);
                        let &(_, to, count) = pin.expect("a pin of the block");
                        match value {
                            Expr::Place(from, of) if count > 1 => {
                                assert_eq!(count, *of, "{name}");
                                own[to..to + count].clone_from_slice(&numbers[*from..from + of]);
                            }
                            value => {
                                let value = self.value(unit, value, numbers)?;
                                own[to] = stored(block.fields[to].basic, value);
                            }
                        }
                    }
                    self.run(block, &mut own)?;
                    numbers.splice(*at..at + own.len(), own);
                }
            }
        }
        Ok(Flow::On)
    }

    fn value(&self, unit: &Unit, of: &Expr, numbers: &mut Vec<Value>) -> Result<Value, Stopped> {
        Ok(match of {
            Expr::Literal(number) => Value::Literal(*number),
            Expr::Int(number) => Value::Int(*number),
            Expr::Bool(is) => Value::Bool(*is),
            Expr::Text(text) => Value::Text(text.clone()),
            Expr::Place(at, 1) => numbers[*at].clone(),
            Expr::Place(..) => panic!("more than a number is read in {}", unit.name),
            Expr::Not(inner) => Value::Bool(!self.value(unit, inner, numbers)?.is()),
            Expr::Negative(inner) => match self.value(unit, inner, numbers)? {
                Value::Lreal(x) => Value::Lreal(-x),
                Value::Real(x) => Value::Real(-x),
                Value::Literal(x) => Value::Literal(-x),
                Value::Int(n) => Value::Int(-n),
                other => panic!("-{other:?}"),
            },
            Expr::Both(sign, sides) => {
                let [a, b] = &**sides;
                let (a, b) = (self.value(unit, a, numbers)?, self.value(unit, b, numbers)?);
                return both(sign, a, b).map_err(|why| format!("{why} in {}", unit.name));
            }
            Expr::Call(name, given) => return self.called(unit, name, given, numbers),
        })
    }

    fn called(
        &self,
        unit: &Unit,
        name: &str,
        given: &[(Option<String>, Expr)],
        numbers: &mut Vec<Value>,
    ) -> Result<Value, Stopped> {
        let Some(function) = self.project.units.get(name) else {
            let mut values = Vec::new();
            for (formal, value) in given {
                assert!(formal.is_none(), "{name} by a name");
                values.push(self.value(unit, value, numbers)?);
            }
            return standard(name, &values).map_err(|why| format!("{why} in {}", unit.name));
        };
        let mut own = self.fresh(function);
        let formal = function.inputs.iter().chain(&function.in_outs);
        assert_eq!(given.len(), formal.clone().count(), "{name}");
        for (pin, to, count) in formal {
            assert_eq!(*count, 1);
            let value = given.iter().find(|(name, _)| name.as_ref() == Some(pin));
            let (_, value) = value.unwrap_or_else(|| panic!("{name} is not given {pin}"));
            let value = self.value(unit, value, numbers)?;
            own[*to] = stored(function.fields[*to].basic, value);
        }
        self.run(function, &mut own)?;
        for (pin, from, _) in &function.in_outs {
            let place = given.iter().find(|(name, _)| name.as_ref() == Some(pin));
            let Some((_, Expr::Place(at, 1))) = place else { panic!("{pin} is no variable") };
            numbers[*at] = own[*from].clone();
        }
        // A function's value stands first.
        Ok(own.swap_remove(0))
    }
}

/// A value in a variable of this type.
fn stored(basic: Basic, value: Value) -> Value {
    match (basic, value) {
        (_, Value::Literal(x)) if [0.0, 1.0, -1.0].contains(&x) => Value::of(basic, x),
        (Basic::Lreal, value @ Value::Lreal(_))
        | (Basic::Real, value @ Value::Real(_))
        | (Basic::Int, value @ Value::Int(_))
        | (Basic::Bool, value @ Value::Bool(_))
        | (Basic::Text, value @ Value::Text(_)) => value,
        (basic, value) => panic!("{value:?} in a variable of {basic:?}"),
    }
}

fn both(sign: &str, a: Value, b: Value) -> Result<Value, Stopped> {
    if let "AND" | "OR" = sign {
        let (Value::Bool(a), Value::Bool(b)) = (a, b) else { panic!("{sign} of no answers") };
        return Ok(Value::Bool(if sign == "AND" { a & b } else { a | b }));
    }
    if let "+" | "-" | "*" | "/" = sign {
        return arithmetic(sign, a, b);
    }
    let is_exact =
        |value: &Value| matches!(value, Value::Literal(x) if [0.0, 1.0, 2.0, -1.0].contains(x));
    let kind = std::mem::discriminant::<Value>;
    assert!(kind(&a) == kind(&b) || is_exact(&a) || is_exact(&b), "{a:?} {sign} {b:?}");
    let (a, b) = (a.number(), b.number());
    Ok(Value::Bool(match sign {
        "=" => a == b,
        "<>" => a != b,
        "<" => a < b,
        ">" => a > b,
        "<=" => a <= b,
        _ => a >= b,
    }))
}

fn arithmetic(sign: &str, a: Value, b: Value) -> Result<Value, Stopped> {
    let zero = |value: &Value| matches!(value, Value::Literal(0.0));
    // A text a product would take most of the time.
    let told = || format!("{a:?} {sign} {b:?}");
    let value = match (&a, &b) {
        (Value::Lreal(x), Value::Lreal(y)) => Value::Lreal(computed(sign, *x, *y)),
        (Value::Real(x), Value::Real(y)) => Value::Real(computed(sign, *x, *y)),
        (Value::Lreal(x), _) if zero(&b) => Value::Lreal(computed(sign, *x, 0.0)),
        (Value::Real(x), _) if zero(&b) => Value::Real(computed(sign, *x, 0.0)),
        (_, Value::Lreal(y)) if zero(&a) => Value::Lreal(computed(sign, 0.0, *y)),
        (_, Value::Real(y)) if zero(&a) => Value::Real(computed(sign, 0.0, *y)),
        // A leg without length, squared.
        _ if zero(&a) && zero(&b) && sign == "*" => Value::Literal(0.0),
        _ => panic!("{}: of two types", told()),
    };
    finite(value, told)
}

fn computed<T>(sign: &str, x: T, y: T) -> T
where
    T: std::ops::Add<Output = T>
        + std::ops::Sub<Output = T>
        + std::ops::Mul<Output = T>
        + std::ops::Div<Output = T>,
{
    match sign {
        "+" => x + y,
        "-" => x - y,
        "*" => x * y,
        _ => x / y,
    }
}

fn finite(value: Value, told: impl Fn() -> String) -> Result<Value, Stopped> {
    if value.number().is_finite() { Ok(value) } else { Err(told()) }
}

/// A function of the language. Those that no kernel computes are the system's, as in C.
fn standard(name: &str, given: &[Value]) -> Result<Value, Stopped> {
    let wide: fn(f64, f64) -> f64 = match name {
        "SQRT" => |x, _| x.sqrt(),
        "ABS" => |x, _| x.abs(),
        "TAN" => |x, _| x.tan(),
        "EXP" => |x, _| x.exp(),
        "LN" => |x, _| x.ln(),
        "EXPT" => f64::powf,
        "SIN" => |x, _| x.sin(),
        "COS" => |x, _| x.cos(),
        _ => panic!("no function {name}"),
    };
    let narrow: fn(f32, f32) -> f32 = match name {
        "SQRT" => |x, _| x.sqrt(),
        "ABS" => |x, _| x.abs(),
        "TAN" => |x, _| x.tan(),
        "EXP" => |x, _| x.exp(),
        "LN" => |x, _| x.ln(),
        "EXPT" => f32::powf,
        "SIN" => |x, _| x.sin(),
        _ => |x, _| x.cos(),
    };
    let told = || format!("{name} of {given:?}");
    let value = match given {
        [Value::Lreal(x)] => Value::Lreal(wide(*x, 0.0)),
        [Value::Real(x)] => Value::Real(narrow(*x, 0.0)),
        [Value::Lreal(x), Value::Lreal(y)] => Value::Lreal(wide(*x, *y)),
        [Value::Real(x), Value::Real(y)] => Value::Real(narrow(*x, *y)),
        _ => panic!("{}", told()),
    };
    finite(value, told)
}
