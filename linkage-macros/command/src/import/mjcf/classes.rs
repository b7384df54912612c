//! Attributes that stand in `default`, by their classes.

use std::collections::HashMap;

use super::xml::Element;

/// The attributes of elements by name, of one class.
type Attributes = HashMap<String, Vec<(String, String)>>;

#[derive(Default)]
pub(super) struct Classes(HashMap<String, Attributes>);

impl Classes {
    pub(super) fn of(root: &Element) -> Self {
        let mut classes = Self::default();
        root.all("default").for_each(|of| classes.add(of, &Attributes::new()));
        classes
    }

    fn add(&mut self, of: &Element, outer: &Attributes) {
        let name = of.attribute("class").unwrap_or("main").to_string();
        let mut own = self.0.get(&name).unwrap_or(outer).clone();
        for child in of.children.iter().filter(|child| child.name != "default") {
            let known = own.entry(child.name.clone()).or_default();
            for (name, value) in &child.attributes {
                known.retain(|(other, _)| other != name);
                known.push((name.clone(), value.clone()));
            }
        }
        self.0.insert(name, own.clone());
        of.all("default").for_each(|inner| self.add(inner, &own));
    }

    /// The element with what its class says, or that of the body around it.
    pub(super) fn complete(&self, element: &Element, around: Option<&str>) -> Element {
        let class = element.attribute("class").or(around).unwrap_or("main");
        let mut whole = element.clone();
        let known = self.0.get(class).and_then(|class| class.get(&element.name));
        for (name, value) in known.into_iter().flatten() {
            if element.attribute(name).is_none() {
                whole.attributes.push((name.clone(), value.clone()));
            }
        }
        whole
    }
}
