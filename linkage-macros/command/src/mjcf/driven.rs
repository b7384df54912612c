//! The joints and tendons by which MuJoCo has a quantity of the drawing.

use std::collections::BTreeMap;

use linkage_compiler::PlanarQuantity;

use super::tree::{Joint, Machine, Node};

/// A quantity in the model.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum InModel {
    /// A joint's number.
    Joint(String),
    /// A sum of joints' numbers, each with its factor.
    Sum(Vec<(String, f64)>),
    /// The distance of two sites.
    Distance([String; 2]),
    /// A coordinate of a site: 0 is x.
    Place(String, usize),
}

impl Machine {
    /// # Errors
    /// A quantity of what the model does not have.
    pub(super) fn in_model(&self, quantity: &PlanarQuantity) -> Result<InModel, String> {
        let body =
            |name: &String| self.named(name).ok_or_else(|| format!("there is no body `{name}`"));
        let site = |pin: &String| self.site(pin).ok_or_else(|| format!("no body holds `{pin}`"));
        Ok(match quantity {
            PlanarQuantity::Angle(own, other) => {
                let other = other.as_ref().map(body).transpose()?;
                self.angle_between(body(own)?, other)
            }
            PlanarQuantity::Slide(own) => {
                let node =
                    self.node(body(own)?).filter(|node| matches!(node.joint, Joint::Slide(_)));
                InModel::Joint(
                    self.joint_name(node.ok_or_else(|| format!("`{own}` does not slide"))?),
                )
            }
            PlanarQuantity::Place(pin, axis) => InModel::Place(site(pin)?, *axis),
            PlanarQuantity::Distance([p, q]) => InModel::Distance([site(p)?, site(q)?]),
        })
    }

    fn angle_between(&self, own: usize, other: Option<usize>) -> InModel {
        let mut sum: BTreeMap<usize, f64> = BTreeMap::new();
        for (start, sign) in [(Some(own), 1.0), (other, -1.0)] {
            let mut at = start.and_then(|body| self.node(body));
            while let Some(node) = at {
                if matches!(node.joint, Joint::Hinge(_)) {
                    *sum.entry(node.body).or_default() += sign;
                }
                at = node.parent.and_then(|parent| self.node(parent));
            }
        }
        let named = |node: &Node| self.joint_name(node);
        let sum: Vec<_> = sum
            .into_iter()
            .filter(|(_, factor)| *factor != 0.0)
            .filter_map(|(body, factor)| Some((named(self.node(body)?), factor)))
            .collect();
        match &sum[..] {
            [(joint, 1.0)] => InModel::Joint(joint.clone()),
            _ => InModel::Sum(sum),
        }
    }
}
