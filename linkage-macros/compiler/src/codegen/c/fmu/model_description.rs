//! The description of a model in XML.

use std::collections::BTreeMap;
use std::iter::once;

use super::{Model, Role, Variable, VariableUnit};
use crate::codegen::identifiers::text;
use crate::interface::quantity::Order;
use crate::interface::units_in_words::unit;
use crate::model::mechanism::Dimension;

impl Model<'_> {
    /// The description of the model.
    pub(super) fn description(&self) -> String {
        let stem = self.to.stem;
        let mut xml = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\" \
             instantiationToken=\"{}\" generationTool=\"linkage\" variableNamingConvention=\"flat\">\n  \
             <ModelExchange modelIdentifier=\"{stem}\"/>\n  \
             <CoSimulation modelIdentifier=\"{stem}\" canHandleVariableCommunicationStepSize=\"true\"/>\n",
            escaped(&text(&self.to.mechanism.name)),
            self.token()
        );
        xml += &self.units();
        xml += "  <ModelVariables>\n";
        let variables = self.variables.iter().enumerate();
        variables.clone().for_each(|(at, variable)| xml += &variable.in_xml(at));
        xml += "  </ModelVariables>\n  <ModelStructure>\n";
        let list = |tag: &str, is_it: &dyn Fn(Role) -> bool| {
            let these = self.variables.iter().enumerate().filter(|(_, v)| is_it(v.role));
            these
                .map(|(at, _)| format!("    <{tag} valueReference=\"{at}\"/>\n"))
                .collect::<String>()
        };
        xml += &list("Output", &|role| matches!(role, Role::Output(_) | Role::State(_)));
        let is_rate = |role| matches!(role, Role::State(Some(_)) | Role::Rate(_));
        xml += &list("ContinuousStateDerivative", &is_rate);
        xml += &list("InitialUnknown", &|role| matches!(role, Role::Output(_) | Role::Rate(_)));
        xml + "  </ModelStructure>\n</fmiModelDescription>\n"
    }

    /// The name that a simulator tells this model's binary from another's by.
    pub(super) fn token(&self) -> String {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        let names = self.variables.iter().map(|variable| &variable.name[..]);
        for byte in once(self.to.stem).chain(names).flat_map(str::bytes) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        format!("{{linkage-{hash:016x}}}")
    }

    /// The units of all variables, each as powers of the SI's base units.
    fn units(&self) -> String {
        let units: BTreeMap<String, String> =
            self.variables.iter().map(|v| (v.unit(), base_unit(v.measure))).collect();
        let listed = units.iter().map(|(unit, base)| {
            format!("    <Unit name=\"{unit}\">\n      <BaseUnit{base}/>\n    </Unit>\n")
        });
        format!("  <UnitDefinitions>\n{}  </UnitDefinitions>\n", listed.collect::<String>())
    }
}

/// The attributes of a unit's powers. A newton is kg m/s², and a radian a unit of its own.
fn base_unit((dimension, order): VariableUnit) -> String {
    let Dimension { length, mass, time, angle } = dimension;
    let rates = match order {
        Order::Position => 0,
        Order::Velocity => 1,
        Order::Acceleration => 2,
    };
    let powers = [("kg", mass), ("m", length), ("s", time - rates), ("rad", i32::from(angle))];
    let powers = powers.into_iter().filter(|(_, power)| *power != 0);
    powers.map(|(unit, power)| format!(" {unit}=\"{power}\"")).collect()
}

impl Variable {
    fn unit(&self) -> String {
        let (dimension, order) = self.measure;
        unit(dimension, order)
    }

    fn in_xml(&self, at: usize) -> String {
        let start = format!(" start=\"{:?}\"", self.start);
        let rest = match self.role {
            Role::Time => "causality=\"independent\" variability=\"continuous\"".to_string(),
            Role::Input => format!("causality=\"input\" variability=\"continuous\"{start}"),
            Role::Parameter => format!("causality=\"parameter\" variability=\"tunable\"{start}"),
            Role::State(of) => {
                let derivative = of.map_or(String::new(), |of| format!(" derivative=\"{of}\""));
                format!(
                    "causality=\"output\" variability=\"continuous\" initial=\"exact\"{start}{derivative}"
                )
            }
            Role::Rate(of) => {
                format!(
                    "causality=\"local\" variability=\"continuous\" initial=\"calculated\" derivative=\"{of}\""
                )
            }
            Role::Output(_) => {
                "causality=\"output\" variability=\"continuous\" initial=\"calculated\"".to_string()
            }
        };
        format!(
            "    <Float64 name=\"{}\" valueReference=\"{at}\" {rest} unit=\"{}\"/>\n",
            escaped(&self.name),
            self.unit()
        )
    }
}

/// Text inside of an attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
