//! The description of a model in XML.

use std::iter::once;

use super::{Model, Role, Variable};
use crate::codegen::identifiers::text;

impl Model<'_> {
    /// The description of the model.
    pub(super) fn description(&self) -> String {
        let stem = self.to.stem;
        let mut xml = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\" \
             instantiationToken=\"{}\" generationTool=\"linkage\" variableNamingConvention=\"flat\">\n  \
             <ModelExchange modelIdentifier=\"{stem}\"/>\n  \
             <CoSimulation modelIdentifier=\"{stem}\" canHandleVariableCommunicationStepSize=\"true\"/>\n",
            escaped(&text(&self.to.cx.names.solver)),
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

    fn units(&self) -> String {
        let mut units: Vec<&str> = self.variables.iter().map(|v| &v.unit[..]).collect();
        units.sort_unstable();
        units.dedup();
        let named = units.into_iter().filter(|unit| !unit.is_empty());
        let listed = named.map(|unit| format!("    <Unit name=\"{unit}\"/>\n"));
        format!("  <UnitDefinitions>\n{}  </UnitDefinitions>\n", listed.collect::<String>())
    }
}

impl Variable {
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
        let unit = match &self.unit[..] {
            "" => String::new(),
            unit => format!(" unit=\"{unit}\""),
        };
        format!(
            "    <Float64 name=\"{}\" valueReference=\"{at}\" {rest}{unit}/>\n",
            escaped(&self.name)
        )
    }
}

/// Text inside of an attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
