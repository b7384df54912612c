//! Scripts and styles without what only their authors read: comments, indents, spaces beside signs, and long names.
//!
//! Lines that a sign ends are joined with the next one, and so is a line that a sign begins; elsewhere the end of a line
//! may end a statement. Texts and regular expressions stay as they are, but for the expressions in a template; a slash
//! begins one of these behind a sign or at the start of a line, and divides elsewhere. Words that have a shorter equal
//! become that, as `const` the shorter `let`, and declarations that follow each other are one.

use std::collections::BTreeMap;
use std::format;
use std::iter::Peekable;
use std::str::Chars;
use std::string::String;
use std::vec::Vec;

use super::page_files::every_file;

/// Words of the language that others say in fewer letters.
const EQUALS: [(&str, &str); 4] =
    [("const", "let"), ("true", "!0"), ("false", "!1"), ("undefined", "void 0")];

/// The short names of words.
#[derive(Debug, Default)]
pub(super) struct Names(pub BTreeMap<String, String>);

impl Names {
    /// The short name of a word, or the word itself.
    pub(super) fn short<'a>(&'a self, word: &'a str) -> &'a str {
        self.0.get(word).map_or(word, |short| short)
    }
}

/// Files of JavaScript with these names. Every word of theirs is told.
pub(super) fn squeezed(files: &[&str], names: &Names, told: &mut dyn FnMut(&str)) -> String {
    let mut squeezed = Squeezed { text: String::new(), declares: [false].into(), names, told };
    for line in files.iter().flat_map(|file| file.lines().map(str::trim)) {
        if !line.is_empty() && !line.starts_with("//") {
            squeezed.line(line);
        }
    }
    squeezed.text
}

struct Squeezed<'a> {
    text: String,
    /// True where the present statement declares names: at the outermost level, and inside each open bracket.
    declares: Vec<bool>,
    names: &'a Names,
    told: &'a mut dyn FnMut(&str),
}

impl Squeezed<'_> {
    fn line(&mut self, line: &str) {
        if line.starts_with(['}', ']', ')', '.', '?', ':', '&', '|', '=']) {
            self.drop_last('\n');
        }
        if line.starts_with('}') {
            self.drop_last(';');
        }
        if line.starts_with(['}', ']', ')']) {
            self.drop_last(',');
        }
        let rest = self.declared(line);
        let start = self.text.len();
        self.squeeze(&mut rest.chars().peekable(), start, false);
        if !self.text.ends_with(['{', '(', '[', ',', ';']) && !self.text.ends_with("=>") {
            self.text.push('\n');
        }
    }

    fn drop_last(&mut self, letter: char) {
        if self.text.ends_with(letter) {
            self.text.pop();
        }
    }

    /// Writes how a declaration begins, and returns the rest of its line.
    fn declared<'a>(&mut self, line: &'a str) -> &'a str {
        let begins = self.text.is_empty() || self.text.ends_with([';', '{', '}', '\n']);
        let names = line.strip_prefix("const ").or_else(|| line.strip_prefix("let "));
        let Some(declares) = self.declares.last_mut().filter(|_| begins) else { return line };
        let follows = core::mem::replace(declares, names.is_some()) && self.text.ends_with(';');
        match names {
            Some(names) if follows => {
                self.text.pop();
                self.text.push(',');
                names
            }
            _ => line,
        }
    }

    /// Writes letters: of a line, or of an expression in a template up to its brace.
    fn squeeze(&mut self, letters: &mut Peekable<Chars<'_>>, start: usize, is_inner: bool) {
        let depth = self.declares.len();
        while let Some(letter) = letters.next() {
            let before = self.text[start..].chars().next_back();
            match letter {
                '"' | '\'' | '`' => self.quoted(letter, letters),
                '/' if letters.peek() == Some(&'/') => return,
                '/' if self.begins_text(before) => self.quoted('/', letters),
                ' ' => self.space(before, letters.peek().copied()),
                '}' if is_inner && self.declares.len() == depth => return self.text.push('}'),
                '#' => self.text.push('#'),
                letter if is_word(letter) => self.word(letter, letters),
                letter => {
                    self.sign(letter, letters.peek().is_some());
                    self.text.push(letter);
                }
            }
        }
    }

    /// True where a slash does not divide.
    fn begins_text(&self, before: Option<char>) -> bool {
        before.is_none_or(|before| "(,=:[!&|?{};>".contains(before))
            || self.text.ends_with("return")
    }

    /// Writes a word by its short name, or a number.
    fn word(&mut self, first: char, letters: &mut Peekable<Chars<'_>>) {
        let mut word = String::from(first);
        while let Some(letter) = letters.next_if(|&letter| is_word(letter)) {
            word.push(letter);
        }
        if first.is_ascii_digit() {
            // A fraction needs no zero before its point.
            let is_fraction = word == "0" && letters.peek() == Some(&'.');
            return self.text.push_str(if is_fraction { "" } else { &word });
        }
        (self.told)(&word);
        let is_member = self.text.ends_with('.') && !self.text.ends_with("...");
        let equal = EQUALS.iter().find(|(long, _)| *long == word && !is_member);
        self.text.push_str(equal.map_or_else(|| self.names.short(&word), |(_, equal)| equal));
    }

    fn space(&mut self, before: Option<char>, after: Option<char>) {
        // Two signs of one kind would be another operator.
        let is_needed = before
            .zip(after)
            .is_some_and(|(a, b)| (is_word(a) && is_word(b)) || (a == b && "+-".contains(a)));
        if is_needed {
            self.text.push(' ');
        }
    }

    /// Notes brackets, and the end of a statement within a line.
    fn sign(&mut self, letter: char, goes_on: bool) {
        match letter {
            '(' | '[' | '{' => self.declares.push(false),
            ')' | ']' | '}' if self.declares.len() > 1 => drop(self.declares.pop()),
            ';' if goes_on => drop(self.declares.last_mut().map(|declares| *declares = false)),
            '>' if self.text.ends_with(")=") => self.single_parameter(),
            _ => {}
        }
    }

    /// A function's only parameter needs no parentheses, unless a word stands before them.
    fn single_parameter(&mut self) {
        let parts = self.text.strip_suffix(")=").and_then(|text| text.rsplit_once('('));
        let Some((before, name)) = parts else { return };
        let is_name = !name.is_empty() && name.chars().all(is_word);
        if is_name && !before.ends_with(is_word) {
            let (at, name) = (before.len(), String::from(name));
            self.text.truncate(at);
            self.text.push_str(&name);
            self.text.push('=');
        }
    }

    /// Copies a text up to its end; a backslash takes the letter behind it along, and so does a class of letters
    /// of a regular expression.
    fn quoted(&mut self, quote: char, letters: &mut Peekable<Chars<'_>>) {
        self.text.push(quote);
        let mut is_in_class = false;
        while let Some(letter) = letters.next() {
            self.text.push(letter);
            match letter {
                '\\' => self.text.extend(letters.next()),
                '$' if quote == '`' && letters.next_if_eq(&'{').is_some() => {
                    self.text.push('{');
                    self.squeeze(letters, self.text.len(), true);
                }
                '[' if quote == '/' => is_in_class = true,
                ']' => is_in_class = false,
                letter if letter == quote && !is_in_class => break,
                _ => {}
            }
        }
        // Flags of a regular expression are no word.
        while quote == '/' && letters.peek().is_some_and(|&letter| is_word(letter)) {
            self.text.extend(letters.next());
        }
    }
}

fn is_word(letter: char) -> bool {
    letter.is_alphanumeric() || "_$".contains(letter)
}

/// Styles, one behind the other. Properties of their own are single letters in them, in the order in which they stand.
pub(super) fn style(files: &[&str]) -> String {
    let mut squeezed: String = files.iter().flat_map(|file| file.lines().map(str::trim)).collect();
    for (spaced, tight) in
        [(": ", ":"), (", ", ","), (" {", "{"), ("{ ", "{"), ("; ", ";"), (";}", "}")]
    {
        squeezed = squeezed.replace(spaced, tight);
    }
    for (name, letter) in properties(files).into_iter().zip('d'..) {
        squeezed = squeezed.replace(&format!("--{name}"), &format!("--{letter}"));
    }
    squeezed
}

/// Properties of the styles' own with names of more than two letters that no script has.
fn properties<'a>(files: &[&'a str]) -> Vec<&'a str> {
    let (scripts, mut found) = (every_file(), Vec::new());
    for part in files.iter().flat_map(|file| file.split("--").skip(1)) {
        let end = part.find(|letter| !is_word(letter) && letter != '-').unwrap_or(part.len());
        let (name, is_named) =
            (&part[..end], |file: &&str| file.contains(&format!("--{}", &part[..end])));
        if end > 2 && !found.contains(&name) && !scripts.iter().any(is_named) {
            found.push(name);
        }
    }
    found
}

/// A document: values of attributes need no quotes where they are words.
pub(super) fn markup(text: &str) -> String {
    let mut squeezed = String::new();
    for (nth, part) in text.split('"').enumerate() {
        let is_value = nth % 2 == 1;
        let is_plain = !part.is_empty() && part.chars().all(|c| is_word(c) || c == '-');
        match (is_value, is_plain) {
            (true, false) => squeezed.extend(["\"", part, "\""]),
            _ => squeezed.push_str(part),
        }
    }
    squeezed
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;

    /// A file whose words stay.
    fn unnamed(file: &str) -> String {
        squeezed(&[file], &Names::default(), &mut |_| ())
    }

    #[test]
    fn spaces_go_where_they_say_nothing() {
        for (written, expected) in [
            ("const a = b + c;", "let a=b+c;"),
            ("  x - -y + +z", "x- -y+ +z\n"),
            ("return [a, \"b,  c\"];", "return[a,\"b,  c\"];"),
            ("`a ${b + c} d` + 'x \\' y' ", "`a ${b+c} d`+'x \\' y'\n"),
            (
                "`{ a } ${{ b: \" } \" }.b + \"c  d\"} }` + e",
                "`{ a } ${{b:\" } \"}.b+\"c  d\"} }`+e\n",
            ),
            ("`$ { a } \\${ b } ${ /[ }] / }`", "`$ { a } \\${ b } ${/[ }] /}`\n"),
            ("a / b / c", "a/b/c\n"),
            ("s.replace(/a b[/ ]\" c/g, x)", "s.replace(/a b[/ ]\" c/g,x)\n"),
            ("// all of it", ""),
            ("a(b); // (c\nd = e // f;\ng", "a(b);d=e\ng\n"),
            ("a = \"b//c\", d = /e\\//g; // `", "a=\"b//c\",d=/e\\//g;"),
            ("return /a b/.test(c) / d", "return/a b/.test(c)/d\n"),
            ("a = {\n  b: [\n    1,\n  ],\n};\nc", "a={b:[1]};c\n"),
            (
                "const f = () => {\n  g();\n};\nclass A {\n  b = 1;\n}\nf(\n  a\n    + b)",
                "let f=()=>{g()};class A{b=1}\nf(a\n+b)\n",
            ),
            ("case \"x\" in y", "case\"x\"in y\n"),
            ("a\n  ? b\n  : c;\nd()\n  .e()\n[f]", "a?b:c;d().e()\n[f]\n"),
            ("f((a) => (b, c) =>\n  async (d) => g(d) => 0)", "f(a=>(b,c)=>async(d)=>g(d)=>0)\n"),
            (
                "for (const [a, b] of c) d(constant, x.const );",
                "for(let[a,b]of c)d(constant,x.const);",
            ),
            ("a = true && x.true, b = [undefined, ...false]", "a=!0&&x.true,b=[void 0,...!1]\n"),
            ("return 0.5 - a[0] * 10.05 + 0x0f + b0.c", "return .5-a[0]*10.05+0x0f+b0.c\n"),
            ("this.#a = /a[/]b/gu.test(c)", "this.#a=/a[/]b/gu.test(c)\n"),
            // Declarations behind each other are one, unless something stands between.
            (
                "const a = 1;\nlet b = (c) => {\n  const d = c;\n  const e = d;\n};\nconst f = 2;",
                "let a=1,b=c=>{let d=c,e=d},f=2;",
            ),
            ("const a = 1;\nb();\nconst c = 2;", "let a=1;b();let c=2;"),
            ("const a = 1; b();\nconst c = 2;", "let a=1;b();let c=2;"),
            ("const a = 1\nconst b = 2;", "let a=1\nlet b=2;"),
            ("if (a) {\n  const b = 1;\n}\nconst c = 2;", "if(a){let b=1}\nlet c=2;"),
            ("const a = [\n  1,\n  ...b,\n];\nconst c = 2;", "let a=[1,...b],c=2;"),
            ("for (const a of b) c(a);\nconst d = 2;", "for(let a of b)c(a);let d=2;"),
        ] {
            assert_eq!(unnamed(written), expected, "{written}");
        }
        assert_eq!(style(&["a b { c: d, e;\n  f: g; }\n", "h { i: j; }"]), "a b{c:d,e;f:g}h{i:j}");
        assert_eq!(
            style(&["a { --paper: #fff; --ink: #000; --x: 1; }", "b { c: var(--paper); }"]),
            "a{--d:#fff;--ink:#000;--x:1}b{c:var(--d)}"
        );
        let (written, expected) =
            ("<a b=\"c-d\" e=\"f g\" h=\"\">i</a>", "<a b=c-d e=\"f g\" h=\"\">i</a>");
        assert_eq!(markup(written), expected);
    }

    /// The lines on which a template begins within another one's expression: its end would be taken for the outer one's.
    fn nested_templates(text: &str) -> Vec<usize> {
        let (mut found, mut open, mut line) = (Vec::new(), Vec::new(), 1);
        let mut letters = text.chars().peekable();
        while let Some(letter) = letters.next() {
            line += usize::from(letter == '\n');
            match (open.last(), letter) {
                (Some('`' | '"' | '\''), '\\') => drop(letters.next()),
                (Some(&quote @ ('`' | '"' | '\'')), letter) if letter == quote => drop(open.pop()),
                (Some('`'), '$') if letters.next_if_eq(&'{').is_some() => open.push('{'),
                (Some('`' | '"' | '\''), _) => {}
                (_, '/') if letters.peek() == Some(&'/') => {
                    while letters.next_if(|&letter| letter != '\n').is_some() {}
                }
                (_, '`') => {
                    if open.contains(&'`') {
                        found.push(line);
                    }
                    open.push('`');
                }
                (_, '{' | '"' | '\'') => open.push(letter),
                (Some('{'), '}') => drop(open.pop()),
                _ => {}
            }
        }
        found
    }

    #[test]
    fn no_template_stands_within_a_template() {
        assert_eq!(nested_templates("`a ${b.map((c) => `${c}`)}`"), [1]);
        assert_eq!(nested_templates("`a ${\"`\"}` + `b` // `${`\n"), [0; 0]);
        for file in every_file() {
            let head = file.lines().next().unwrap_or_default();
            assert_eq!(nested_templates(file), [0; 0], "{head}");
        }
    }
}
