//! The way from a result to each of its numbers.

use super::Interface;
use super::records::Shape;

/// A step of the way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Component {
    /// A field, as its record declares it.
    Field(String),
    Index(usize),
}

impl Interface {
    /// The way to each number of a result of this shape, in the order of the sinks.
    pub(crate) fn components(&self, shape: Shape) -> Vec<Vec<Component>> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::entries::Analysis;
    use crate::oracle::mechanism;

    #[test]
    fn a_result_is_read_in_the_order_of_its_numbers() {
        let mechanism = mechanism(
            "struct M { input s: length; input u: length; ground A(0, 0), D(600mm, 0);
             rrr AC(A), DC(D) -> C { lengths: (s, u), mode: right }
             output C, AC, AC.margin; }",
        );
        let interface = Interface::of(&mechanism);
        let ways = |analysis: Analysis| -> Vec<String> {
            let entry = interface.find(analysis.by_value()).expect("it is offered");
            let shape = interface.entry(entry).result;
            let ways = interface.components(shape);
            assert_eq!(ways.len(), interface.numbers(shape));
            let written = |step: &Component| match step {
                Component::Field(name) => format!(".{name}"),
                Component::Index(at) => format!("[{at}]"),
            };
            ways.iter().map(|way| way.iter().map(written).collect()).collect()
        };
        assert_eq!(
            ways(Analysis::Position),
            [".C.x", ".C.y", ".AC.cos", ".AC.sin", ".AC_margin"].map(str::to_string)
        );
        assert_eq!(ways(Analysis::Motion)[5], ".velocity.C.x");
        // Column by column, while an element is addressed by its row.
        assert_eq!(ways(Analysis::Coefficients)[..2], ["[0][0]", "[1][0]"].map(str::to_string));
    }
}
