//! Enough of XML to read a picture: elements, attributes and text. It panics where a parser would
//! refuse.

/// An element.
#[derive(Debug)]
pub(super) struct Element {
    pub name: String,
    pub attributes: Vec<(String, String)>,
    pub children: Vec<Element>,
    pub text: String,
}

impl Element {
    pub(super) fn attribute(&self, name: &str) -> Option<&str> {
        let mut attributes = self.attributes.iter();
        attributes.find(|(own, _)| own == name).map(|(_, value)| &value[..])
    }

    /// This one and all below.
    pub(super) fn all(&self) -> Vec<&Self> {
        let below = self.children.iter().flat_map(Self::all);
        std::iter::once(self).chain(below).collect()
    }
}

/// The only element of a text.
pub(super) fn parse(text: &str) -> Element {
    let mut rest = text.trim_end();
    let root = element(&mut rest);
    assert_eq!(rest, "", "something follows the root");
    root
}

fn element(rest: &mut &str) -> Element {
    *rest = rest.strip_prefix('<').expect("an element begins");
    let name = word(rest);
    let mut element =
        Element { name, attributes: Vec::new(), children: Vec::new(), text: String::new() };
    loop {
        *rest = rest.trim_start();
        if let Some(behind) = rest.strip_prefix("/>") {
            *rest = behind;
            return element;
        }
        if let Some(behind) = rest.strip_prefix('>') {
            *rest = behind;
            break;
        }
        let name = word(rest);
        *rest = rest.strip_prefix("=\"").expect("a value in quotes follows a name");
        let (value, behind) = rest.split_once('"').expect("a value ends");
        assert!(!value.contains('<'), "{value}");
        check_entities(value);
        assert!(element.attribute(&name).is_none(), "{name} twice");
        element.attributes.push((name, value.to_string()));
        *rest = behind;
    }
    loop {
        let at = rest.find('<').expect("an element ends");
        let (text, behind) = rest.split_at(at);
        check_entities(text);
        element.text += text;
        *rest = behind;
        if let Some(behind) = rest.strip_prefix("</") {
            *rest = behind;
            assert_eq!(word(rest), element.name);
            *rest = rest.strip_prefix('>').expect("an end tag ends");
            return element;
        }
        element.children.push(self::element(rest));
    }
}

fn word(rest: &mut &str) -> String {
    let is_end = |letter: char| !(letter.is_alphanumeric() || "-_:".contains(letter));
    let at = rest.find(is_end).expect("a name ends");
    let (word, behind) = rest.split_at(at);
    assert!(!word.is_empty(), "a name is missing before {}", &behind[..behind.len().min(20)]);
    *rest = behind;
    word.to_string()
}

fn check_entities(text: &str) {
    for part in text.split('&').skip(1) {
        let known = ["amp;", "lt;", "gt;", "quot;"].iter().any(|entity| part.starts_with(entity));
        assert!(known, "{text}");
    }
}

/// Numbers between spaces, commas, semicolons and parentheses.
pub(super) fn numbers(text: &str) -> Vec<f64> {
    let parts = text.split(|c: char| " ,;()".contains(c)).filter(|part| !part.is_empty());
    parts.filter_map(|part| part.parse().ok()).collect()
}

#[test]
fn what_is_no_xml_is_refused() {
    for text in ["<a", "<a></b>", "<a b=\"1\" b=\"2\"/>", "<a>&</a>", "<a/><b/>", "<a b=1/>"] {
        assert!(std::panic::catch_unwind(|| parse(text)).is_err(), "{text}");
    }
    let found = parse("<a b=\"1 2\"><c/>d</a>");
    assert_eq!(
        (found.all().len(), &found.text[..], numbers("1 2;-3.5")),
        (2, "d", vec![1.0, 2.0, -3.5])
    );
}
