//! As much of XML as models are written in: elements, attributes, comments, and a declaration in front.

use super::super::Mistake;

/// An element: its attributes in their order, and what stands in it.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Element {
    pub name: String,
    pub attributes: Vec<(String, String)>,
    pub children: Vec<Element>,
}

impl Element {
    pub(super) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(own, _)| own == name).map(|(_, value)| &value[..])
    }

    pub(super) fn all<'e>(&'e self, name: &'e str) -> impl Iterator<Item = &'e Self> {
        self.children.iter().filter(move |child| child.name == name)
    }

    /// The numbers of an attribute.
    pub(super) fn numbers(&self, name: &str) -> Result<Option<Vec<f64>>, Mistake> {
        let Some(text) = self.attribute(name) else { return Ok(None) };
        let numbers = text.split_whitespace().map(str::parse::<f64>);
        let numbers: Option<Vec<f64>> = numbers.map(Result::ok).collect();
        let numbers = numbers.filter(|numbers| numbers.iter().all(|number| number.is_finite()));
        let why = || format!("`{name}=\"{text}\"` of `{}` is no list of numbers", self.name);
        numbers.map(Some).ok_or_else(why)
    }

    /// So many numbers of an attribute, or these.
    pub(super) fn list<const N: usize>(
        &self,
        name: &str,
        otherwise: [f64; N],
    ) -> Result<[f64; N], Mistake> {
        let Some(numbers) = self.numbers(name)? else { return Ok(otherwise) };
        let why = |_| format!("`{name}` of `{}` holds other than {N} numbers", self.name);
        numbers.try_into().map_err(why)
    }
}

/// The only element at the top.
pub(super) fn read(text: &str) -> Result<Element, Mistake> {
    let mut reader = Reader { rest: text };
    let mut open: Vec<Element> = vec![Element::default()];
    while let Some(tag) = reader.next()? {
        match tag {
            Tag::Open(element) => open.push(element),
            Tag::Whole(element) => last(&mut open).children.push(element),
            Tag::Close(name) => {
                let element = open.pop().unwrap_or_default();
                if element.name != name || open.is_empty() {
                    return Err(format!("`</{name}>` closes nothing"));
                }
                last(&mut open).children.push(element);
            }
        }
    }
    match (open.len(), open.pop()) {
        (1, Some(top)) if top.children.len() == 1 => {
            Ok(top.children.into_iter().next().unwrap_or_default())
        }
        (_, Some(element)) if !element.name.is_empty() => {
            Err(format!("`<{}>` is not closed", element.name))
        }
        _ => Err("this is no XML with one element around all others".to_string()),
    }
}

fn last(open: &mut [Element]) -> &mut Element {
    open.last_mut().expect("the top is never closed")
}

enum Tag {
    Open(Element),
    Whole(Element),
    Close(String),
}

struct Reader<'t> {
    rest: &'t str,
}

impl<'t> Reader<'t> {
    fn next(&mut self) -> Result<Option<Tag>, Mistake> {
        loop {
            let Some(start) = self.rest.find('<') else { return Ok(None) };
            self.rest = &self.rest[start..];
            let skipped = [("<!--", "-->"), ("<?", "?>"), ("<![CDATA[", "]]>"), ("<!", ">")];
            match skipped.into_iter().find(|(begin, _)| self.rest.starts_with(begin)) {
                Some((begin, end)) => {
                    let place = self.rest.find(end);
                    let place = place.ok_or_else(|| format!("`{begin}` is not closed"))?;
                    self.rest = &self.rest[place + end.len()..];
                }
                None => break,
            }
        }
        self.rest = &self.rest[1..];
        if let Some(rest) = self.rest.strip_prefix('/') {
            let end = rest.find('>').ok_or("a closing tag is not closed")?;
            self.rest = &rest[end + 1..];
            return Ok(Some(Tag::Close(rest[..end].trim().to_string())));
        }
        let name = self.word();
        if name.is_empty() {
            return Err("a `<` stands before no name".to_string());
        }
        let mut element = Element { name, ..Element::default() };
        loop {
            self.rest = self.rest.trim_start();
            if let Some(rest) = self.rest.strip_prefix("/>") {
                self.rest = rest;
                return Ok(Some(Tag::Whole(element)));
            }
            if let Some(rest) = self.rest.strip_prefix('>') {
                self.rest = rest;
                return Ok(Some(Tag::Open(element)));
            }
            let attribute = self.attribute(&element.name)?;
            element.attributes.push(attribute);
        }
    }

    fn word(&mut self) -> String {
        let ends = |letter: char| letter.is_whitespace() || "/>=<\"'".contains(letter);
        let end = self.rest.find(ends).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word.to_string()
    }

    fn attribute(&mut self, of: &str) -> Result<(String, String), Mistake> {
        let name = self.word();
        let why = || format!("an attribute of `<{of}>` is not `name=\"value\"`");
        let rest = self.rest.trim_start().strip_prefix('=').map(str::trim_start).ok_or_else(why)?;
        let quote = rest.chars().next().filter(|sign| "\"'".contains(*sign)).ok_or_else(why)?;
        let end = rest[1..].find(quote).ok_or_else(why)?;
        self.rest = &rest[end + 2..];
        if name.is_empty() {
            return Err(why());
        }
        Ok((name, plain(&rest[1..=end])))
    }
}

/// A value without what stands for signs of XML.
fn plain(text: &str) -> String {
    let signs = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&apos;", "'"), ("&amp;", "&")];
    signs.iter().fold(text.to_string(), |text, (name, sign)| text.replace(name, sign))
}
