//! The way from a result to each of its numbers.

use super::Interface;
use super::records::Shape;

/// A step of the way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Component {
    /// A field, as its record declares it.
    Field(String),
    Index(usize),
}

impl Interface {
    /// The way to each number of a result of this shape, in the order of the sinks.
    pub fn components(&self, shape: Shape) -> Vec<Vec<Component>> {
        let mut ways = Vec::new();
        self.each_component(shape, &mut Vec::new(), &mut |way| ways.push(way.to_vec()));
        ways
    }

    fn each_component(
        &self,
        shape: Shape,
        way: &mut Vec<Component>,
        found: &mut impl FnMut(&[Component]),
    ) {
        let mut end = |way: &mut Vec<Component>, steps: &[Component]| {
            let length = way.len();
            way.extend_from_slice(steps);
            found(way);
            way.truncate(length);
        };
        match shape {
            Shape::Number => end(way, &[]),
            Shape::List(count) => (0..count).for_each(|index| end(way, &[Component::Index(index)])),
            Shape::Quantity(quantity, order) => {
                for part in quantity.layout(order).parts {
                    match part.field {
                        "" => end(way, &[]),
                        field => end(way, &[Component::Field(field.to_string())]),
                    }
                }
            }
            Shape::Matrix { rows, columns } => {
                for column in 0..columns {
                    (0..rows).for_each(|row| end(way, &[row, column].map(Component::Index)));
                }
            }
            Shape::Record(id) => {
                for field in &self.record(id).fields {
                    way.push(Component::Field(field.name.to_string()));
                    self.each_component(field.shape, way, found);
                    way.pop();
                }
            }
        }
    }
}
