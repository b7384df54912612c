//! A reader of the structured text that is printed: types, functions and function blocks, and every variable at its place
//! among the numbers of its unit. It knows no more of the language than that, and is as strict as it can be: a name has
//! to be declared, and none twice.

use std::collections::HashMap;

use super::lexer::tokens;
use super::units::is_part;

/// The type of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Basic {
    Lreal,
    Real,
    Int,
    Bool,
    Text,
}

/// A number of a type: where it stands in it, and what it is at first.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    pub path: String,
    pub basic: Basic,
    pub first: f64,
}

#[derive(Clone, Debug)]
pub(crate) enum Expr {
    Literal(f64),
    Int(i64),
    Bool(bool),
    Text(String),
    /// The numbers of a variable, from the first on, so many.
    Place(usize, usize),
    Negative(Box<Expr>),
    Not(Box<Expr>),
    Both(String, Box<[Expr; 2]>),
    Call(String, Vec<(Option<String>, Expr)>),
}

#[derive(Clone, Debug)]
pub(crate) enum Statement {
    Set(usize, Expr),
    If(Vec<(Expr, Vec<Statement>)>, Vec<Statement>),
    /// Once: its condition is TRUE.
    Once(Vec<Statement>),
    Exit,
    /// A block, by its place among the numbers.
    Block(String, usize, Vec<(String, Expr)>),
}

/// A function or a function block.
#[derive(Clone, Debug)]
pub(crate) struct Unit {
    pub name: String,
    pub is_block: bool,
    /// Names of the pins that are given, of those that are handed back, and of both, with place and count.
    pub inputs: Vec<(String, usize, usize)>,
    pub outputs: Vec<(String, usize, usize)>,
    pub in_outs: Vec<(String, usize, usize)>,
    pub fields: Vec<Field>,
    pub body: Vec<Statement>,
    /// By the name of a variable or a part of it.
    pub(crate) places: HashMap<String, (usize, usize)>,
    blocks: HashMap<String, String>,
}

/// Everything that some texts declare.
#[derive(Default)]
pub(crate) struct Project {
    types: HashMap<String, Vec<Field>>,
    pub units: HashMap<String, Unit>,
    /// The names of the units in their order.
    pub order: Vec<String>,
}

struct Reader<'a> {
    tokens: Vec<String>,
    at: usize,
    project: &'a mut Project,
}

impl Project {
    pub(crate) fn read(&mut self, text: &str) {
        let mut reader = Reader { tokens: tokens(text), at: 0, project: self };
        while reader.at < reader.tokens.len() {
            match &reader.next()[..] {
                "TYPE" => reader.structure(),
                "FUNCTION" => reader.unit(false),
                "FUNCTION_BLOCK" => reader.unit(true),
                other => panic!("`{other}` begins nothing"),
            }
        }
    }
}

impl Reader<'_> {
    fn next(&mut self) -> String {
        self.at += 1;
        self.tokens[self.at - 1].clone()
    }

    fn peek(&self) -> &str {
        self.tokens.get(self.at).map_or("", |token| token)
    }

    fn takes(&mut self, token: &str) -> bool {
        let is_it = self.peek() == token;
        self.at += usize::from(is_it);
        is_it
    }

    fn expect(&mut self, token: &str) {
        let found = self.next();
        let around = self.tokens[self.at.saturating_sub(8)..self.at].join(" ");
        assert_eq!(found, token, "behind `{around}`");
    }

    /// A name: no keyword, no underscore at an end or beside another one.
    fn name(&mut self) -> String {
        let name = self.next();
        let is_name = name.starts_with(|c: char| c.is_ascii_alphabetic())
            && !name.contains("__")
            && !name.ends_with('_');
        assert!(is_name, "`{name}` is no name");
        name
    }

    fn structure(&mut self) {
        let name = self.name();
        self.expect(":");
        self.expect("STRUCT");
        let mut fields: Vec<Field> = Vec::new();
        while !self.takes("END_STRUCT") {
            let field = self.name();
            let all = self.declared(&field);
            assert!(
                fields.iter().all(|known| !is_part(&known.path, &field)),
                "{name}.{field} twice"
            );
            fields.extend(all);
        }
        self.expect(";");
        self.expect("END_TYPE");
        let is_new = self.project.types.insert(name.clone(), fields).is_none();
        assert!(is_new && !self.project.units.contains_key(&name), "{name} is declared twice");
    }

    /// The numbers of a variable, behind its name.
    fn declared(&mut self, name: &str) -> Vec<Field> {
        self.expect(":");
        let mut fields = self.ty();
        for field in &mut fields {
            field.path = format!("{name}{}", field.path);
        }
        if self.takes(":=") {
            let sign = if self.takes("-") { -1.0 } else { 1.0 };
            fields[0].first = sign * self.next().parse::<f64>().expect("a number is first");
        }
        self.expect(";");
        fields
    }

    fn ty(&mut self) -> Vec<Field> {
        let one = |basic| vec![Field { path: String::new(), basic, first: 0.0 }];
        match &self.next()[..] {
            "LREAL" => one(Basic::Lreal),
            "REAL" => one(Basic::Real),
            "INT" => one(Basic::Int),
            "BOOL" => one(Basic::Bool),
            "STRING" => one(Basic::Text),
            "ARRAY" => {
                self.expect("[");
                let mut places = vec![String::new()];
                loop {
                    assert_eq!(self.next(), "0");
                    self.expect("..");
                    let last: usize = self.next().parse().expect("a list has an end");
                    let of = |place: &String| {
                        let comma = if place.is_empty() { "" } else { "," };
                        (0..=last).map(|at| format!("{place}{comma}{at}")).collect::<Vec<_>>()
                    };
                    places = places.iter().flat_map(of).collect();
                    if !self.takes(",") {
                        break;
                    }
                }
                self.expect("]");
                self.expect("OF");
                let [of] = &self.ty()[..] else { panic!("a list of numbers") };
                places.iter().map(|at| Field { path: format!("[{at}]"), ..of.clone() }).collect()
            }
            other => {
                let known = self.project.types.get(other);
                let fields = known.unwrap_or_else(|| panic!("no type `{other}`")).clone();
                fields.into_iter().map(|of| Field { path: format!(".{}", of.path), ..of }).collect()
            }
        }
    }

    fn unit(&mut self, is_block: bool) {
        let name = self.name();
        let mut unit = Unit {
            name: name.clone(),
            is_block,
            inputs: Vec::new(),
            outputs: Vec::new(),
            in_outs: Vec::new(),
            fields: Vec::new(),
            body: Vec::new(),
            places: HashMap::new(),
            blocks: HashMap::new(),
        };
        if self.takes(":") {
            let mut fields = self.ty();
            fields.iter_mut().for_each(|field| field.path = name.clone());
            unit.add(&name, fields);
        }
        while self.peek().starts_with("VAR") {
            let section = self.next();
            self.takes("CONSTANT");
            while !self.takes("END_VAR") {
                let variable = self.name();
                if let Some(block) =
                    self.tokens.get(self.at + 1).and_then(|ty| self.project.units.get(ty))
                {
                    let fields = block
                        .fields
                        .iter()
                        .map(|of| Field { path: format!("{variable}.{}", of.path), ..of.clone() });
                    let (fields, ty) = (fields.collect(), block.name.clone());
                    unit.add(&variable, fields);
                    unit.blocks.insert(variable, ty);
                    self.at += 3;
                    continue;
                }
                let fields = self.declared(&variable);
                let (at, count) = unit.add(&variable, fields);
                let pins = match &section[..] {
                    "VAR_INPUT" => &mut unit.inputs,
                    "VAR_OUTPUT" => &mut unit.outputs,
                    "VAR_IN_OUT" => &mut unit.in_outs,
                    _ => continue,
                };
                pins.push((variable, at, count));
            }
        }
        let end = if is_block { "END_FUNCTION_BLOCK" } else { "END_FUNCTION" };
        unit.body = self.statements(&unit, &[end]);
        self.expect(end);
        self.project.order.push(name.clone());
        let is_new = self.project.units.insert(name.clone(), unit).is_none();
        assert!(is_new && !self.project.types.contains_key(&name), "{name} is declared twice");
    }

    fn statements(&mut self, unit: &Unit, ends: &[&str]) -> Vec<Statement> {
        let mut statements = Vec::new();
        while !ends.contains(&self.peek()) {
            statements.push(self.statement(unit));
            self.expect(";");
        }
        statements
    }

    fn statement(&mut self, unit: &Unit) -> Statement {
        if self.takes("EXIT") {
            return Statement::Exit;
        }
        if self.takes("REPEAT") {
            let body = self.statements(unit, &["UNTIL"]);
            ["UNTIL", "TRUE", "END_REPEAT"].iter().for_each(|word| self.expect(word));
            return Statement::Once(body);
        }
        if self.takes("IF") {
            let (mut cases, mut rest) = (Vec::new(), Vec::new());
            loop {
                let condition = self.expression(unit, 0);
                self.expect("THEN");
                cases.push((condition, self.statements(unit, &["ELSIF", "ELSE", "END_IF"])));
                if !self.takes("ELSIF") {
                    break;
                }
            }
            if self.takes("ELSE") {
                rest = self.statements(unit, &["END_IF"]);
            }
            self.expect("END_IF");
            return Statement::If(cases, rest);
        }
        let path = self.path();
        if let Some(block) = unit.blocks.get(&path) {
            let (at, _) = unit.place(&path);
            self.expect("(");
            let given = self.arguments(unit).into_iter();
            let given =
                given.map(|(name, value)| (name.expect("a block is given by names"), value));
            return Statement::Block(block.clone(), at, given.collect());
        }
        let (at, count) = unit.place(&path);
        assert_eq!(count, 1, "{path} is more than a number");
        self.expect(":=");
        Statement::Set(at, self.expression(unit, 0))
    }

    /// A variable, or a part of it.
    fn path(&mut self) -> String {
        let mut path = self.name();
        loop {
            if self.takes(".") {
                path += &format!(".{}", self.name());
            } else if self.takes("[") {
                let mut indices = vec![self.next()];
                while self.takes(",") {
                    indices.push(self.next());
                }
                self.expect("]");
                path += &format!("[{}]", indices.join(","));
            } else {
                return path;
            }
        }
    }

    /// The arguments of a call, behind its bracket.
    fn arguments(&mut self, unit: &Unit) -> Vec<(Option<String>, Expr)> {
        let mut arguments = Vec::new();
        loop {
            let is_named = self.tokens.get(self.at + 1).is_some_and(|token| token == ":=");
            let name = is_named.then(|| self.name());
            if is_named {
                self.expect(":=");
            }
            arguments.push((name, self.expression(unit, 0)));
            if !self.takes(",") {
                break;
            }
        }
        self.expect(")");
        arguments
    }

    /// An expression whose signs bind at least as strongly as those of this level.
    fn expression(&mut self, unit: &Unit, level: usize) -> Expr {
        const LEVELS: [&[&str]; 6] =
            [&["OR"], &["AND"], &["=", "<>"], &["<", ">", "<=", ">="], &["+", "-"], &["*", "/"]];
        let Some(signs) = LEVELS.get(level) else { return self.operand(unit) };
        let mut left = self.expression(unit, level + 1);
        while signs.contains(&self.peek()) {
            let sign = self.next();
            assert!(self.peek() != "-", "two signs side by side");
            left = Expr::Both(sign, Box::new([left, self.expression(unit, level + 1)]));
        }
        left
    }

    fn operand(&mut self, unit: &Unit) -> Expr {
        if self.takes("-") {
            assert!(self.peek() != "-", "two signs side by side");
            return Expr::Negative(Box::new(self.operand(unit)));
        }
        if self.takes("NOT") {
            return Expr::Not(Box::new(self.operand(unit)));
        }
        if self.takes("(") {
            let inner = self.expression(unit, 0);
            self.expect(")");
            return inner;
        }
        let token = self.peek().to_string();
        match token.chars().next() {
            Some('\'') => {
                self.at += 1;
                Expr::Text(token.trim_matches('\'').to_string())
            }
            Some('0'..='9') => {
                self.at += 1;
                match token.contains('.') {
                    true => Expr::Literal(token.parse().expect("a number")),
                    false => Expr::Int(token.parse().expect("an integer")),
                }
            }
            _ if self.takes("TRUE") => Expr::Bool(true),
            _ if self.takes("FALSE") => Expr::Bool(false),
            _ if self.tokens.get(self.at + 1).is_some_and(|token| token == "(") => {
                self.at += 2;
                Expr::Call(token, self.arguments(unit))
            }
            _ => {
                let (at, count) = unit.place(&self.path());
                Expr::Place(at, count)
            }
        }
    }
}
