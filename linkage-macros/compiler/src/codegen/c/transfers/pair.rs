//! The structure and the functions by which one solver's poses are those of another.

use super::pose_numbers::{PoseNumbers, RETURNED, literal, null_checks};
use super::set_in_c::{RowInC, SetInC};
use super::sides::epsilon;
use crate::codegen::c::c_identifiers::{Width, snake_case};
use crate::codegen::c::c_names::{param, quoted};
use crate::codegen::c::header::comment;
use crate::codegen::c::two_paths::indented;
use crate::codegen::identifiers::text;
use crate::interface::carried_over::{Assembled, CarriedOver, PlaceInPose, SideLine};
use crate::interface::entries::Analysis;
use crate::syntax::words::in_capitals;

/// A solver, another, and the way from the first to it.
pub(super) struct TransferInC<'a> {
    from: &'a SetInC<'a>,
    to: &'a SetInC<'a>,
    pub carried: CarriedOver,
}

/// A function behind the one that carries a pose over.
#[derive(Clone, Copy)]
enum Behind {
    Rates,
    Motion,
    Ratios,
    Efforts,
    Inertia,
}

impl Behind {
    const ALL: [Self; 5] = [Self::Rates, Self::Motion, Self::Ratios, Self::Efforts, Self::Inertia];

    /// The analysis that it needs.
    fn needs(self) -> Analysis {
        match self {
            Self::Rates => Analysis::Velocity,
            Self::Motion => Analysis::Motion,
            Self::Ratios | Self::Efforts | Self::Inertia => Analysis::Coefficients,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Rates => "rates",
            Self::Motion => Analysis::Motion.by_value().name(),
            Self::Ratios => "ratios",
            Self::Efforts => "efforts",
            Self::Inertia => "inertia",
        }
    }
}

impl<'a> TransferInC<'a> {
    /// Nothing where the other has to be asked and is not printed.
    pub(super) fn between(from: &'a SetInC<'a>, to: &'a SetInC<'a>) -> Option<Self> {
        let carried = CarriedOver::between(from.mechanism, to.mechanism);
        let is_known = carried.compared.is_empty() || to.interface.has(Analysis::Position);
        is_known.then_some(Self { from, to, carried })
    }

    fn action(&self, behind: &str) -> String {
        format!("to_{}{behind}", snake_case(&text(self.to.set)))
    }

    fn function(&self, behind: &str, width: Width) -> String {
        self.from.function(&self.action(behind), width)
    }

    /// The type of the structure.
    fn transfer(&self, width: Width) -> String {
        let set = in_capitals(&text(self.to.set));
        width.type_name(&format!("{}To{set}", self.from.name()))
    }

    fn offered(&self) -> impl Iterator<Item = Behind> {
        Behind::ALL.into_iter().filter(|behind| self.from.interface.has(behind.needs()))
    }

    /// The function that carries a pose over, and those behind it.
    fn functions(&self) -> impl Iterator<Item = Option<Behind>> {
        [None].into_iter().chain(self.offered().map(Some))
    }

    /// The structure and the prototypes.
    pub(super) fn declared(&self, width: Width) -> String {
        let (from, to, ty) = (self.from.name(), self.to.name(), self.transfer(width));
        let about = format!("A pose of {from} as one of {to}.");
        let mut fields = comment(
            &["The inputs of the other, angles in the turn of the drawing.".to_string()],
            "    ",
        );
        fields += &format!("    {} coordinates;\n", self.to.input(width));
        fields += &format!("    {} from;\n", self.from.input(width));
        if self.from.has_parameters() {
            fields += &format!("    {} mechanism;\n", self.from.parameters(width));
        }
        let mut text =
            format!("\n{}typedef struct {ty} {{\n{fields}}} {ty};\n", comment(&[about], ""));
        for name in self.functions() {
            text += &format!(
                "\n{}{};\n",
                comment(&[self.about(name)], ""),
                self.prototype(name, width)
            );
        }
        text
    }

    fn about(&self, function: Option<Behind>) -> String {
        let (from, to) = (self.from.name(), self.to.name());
        match function {
            None => format!(
                "A pose as one of {to}: LINKAGE_OTHER_ASSEMBLY where that would find another."
            ),
            Some(Behind::Rates) => format!("The rates of {to}'s inputs at these of {from}."),
            Some(Behind::Motion) => format!("Inputs, rates and second rates of {to}."),
            Some(Behind::Ratios) => format!("d{to}/d{from}: a row for each input of {to}."),
            Some(Behind::Efforts) => format!(
                "The efforts at the inputs of {from} that have the power of these at those of {to}."
            ),
            Some(Behind::Inertia) => format!(
                "The inertia at the inputs of {from} of this one at those of {to}, row by row."
            ),
        }
    }

    fn prototype(&self, function: Option<Behind>, width: Width) -> String {
        let (real, from, to) = (width.in_c(), self.from.input(width), self.to.input(width));
        let square = format!("[{0}][{0}]", self.from.count());
        let behind = function.map_or(String::new(), |behind| format!("_{}", behind.name()));
        let (given, result) = match function {
            None => {
                let parameters = match self.from.has_parameters() {
                    true => format!("const {} *mechanism, ", self.from.parameters(width)),
                    false => String::new(),
                };
                let given = self.from.given("from", width);
                let transfer = self.transfer(width);
                return format!(
                    "LinkageStatus {}({parameters}{given}, {transfer} *transfer, LinkageError *error)",
                    self.function("", width)
                );
            }
            Some(Behind::Rates) => (vec![self.from.given("rates", width)], format!("{to} *to")),
            Some(Behind::Motion) => {
                let given = ["rates", "accelerations"].map(|name| self.from.given(name, width));
                (given.to_vec(), format!("{to} to[3]"))
            }
            Some(Behind::Ratios) => (Vec::new(), format!("{real} ratios{square}")),
            Some(Behind::Efforts) => (vec![self.to.given("efforts", width)], format!("{from} *to")),
            // A pointer to constant lists would not take lists that may change.
            Some(Behind::Inertia) => {
                (vec![format!("{real} inertia{square}")], format!("{real} to{square}"))
            }
        };
        let mut list = vec![format!("const {} *transfer", self.transfer(width))];
        list.extend(given);
        list.extend([result, "LinkageError *error".to_string()]);
        format!("LinkageStatus {}({})", self.function(&behind, width), list.join(", "))
    }

    /// The functions.
    pub(super) fn defined(&self, stem: &str, width: Width) -> String {
        let mut text = String::new();
        for name in self.functions() {
            let body = match name {
                None => self.carries(stem, width),
                Some(Behind::Rates) => self.rates(width),
                Some(Behind::Motion) => self.motion(width),
                Some(Behind::Ratios) => self.ratios(width),
                Some(Behind::Efforts) => self.efforts(width),
                Some(Behind::Inertia) => self.inertia(width),
            };
            text += &format!("\n{}\n{{\n{}}}\n", self.prototype(name, width), indented(&body));
        }
        text
    }

    /// The arguments in front of those of an analysis of the first solver.
    fn own(&self, transfer: &str) -> String {
        let by = if self.from.interface.input_record().is_some() { "&" } else { "" };
        let parameters = match self.from.has_parameters() {
            true => format!("&{transfer}mechanism, "),
            false => String::new(),
        };
        format!("{parameters}{by}{transfer}from")
    }

    fn carries(&self, stem: &str, width: Width) -> String {
        let (pose, position) = (
            self.from.record(Analysis::Position, width),
            self.from.answers(Analysis::Position, width),
        );
        let is_record = self.from.interface.input_record().is_some();
        let mut pointers = vec!["transfer"];
        pointers.extend(is_record.then_some("from"));
        pointers.extend(self.from.has_parameters().then_some("mechanism"));
        let mut body =
            format!("{} own;\n{pose} pose;\nLinkageStatus status;\n", self.transfer(width));
        body += &null_checks(&pointers);
        let star = if is_record { "*" } else { "" };
        body += &format!("own.from = {star}from;\n");
        if self.from.has_parameters() {
            body += "own.mechanism = *mechanism;\n";
        }
        body += &format!("status = {position}({}, &pose, error);\n{RETURNED}", self.own("own."));
        let rows = self.from.rows(Analysis::Position, "pose").remove(0);
        let places = PoseNumbers { inputs: self.from.inputs_in("own.from"), rows, width };
        for side in &self.carried.sides {
            body += &self.side(stem, side, &places);
        }
        let coordinates = self.to.inputs_in("own.coordinates");
        for (to, place) in coordinates.iter().zip(&self.carried.coordinates) {
            body += &format!("{to} = {};\n", places.value(place));
        }
        if !self.carried.compared.is_empty() {
            body += &self.compared(stem, &places);
        }
        body + "*transfer = own;\nreturn LINKAGE_OK;\n"
    }

    fn side(&self, stem: &str, side: &Assembled, places: &PoseNumbers) -> String {
        let point = |[x, y]: &[PlaceInPose; 2]| format!("{}, {}", places.wide(x), places.wide(y));
        let (function, line) = match &side.line {
            SideLine::Towards(to) => ("across", point(to)),
            SideLine::Along(direction) => {
                let [x, y] = direction.map(|part| literal(part, Width::Double));
                ("along", format!("(LinkageWide){x}, (LinkageWide){y}"))
            }
        };
        format!(
            "status = {stem}_{function}({}, {line}, {}, 128 * {}, {}, error, {}, {});\n{RETURNED}",
            point(&side.from),
            point(&side.pin),
            epsilon(places.width),
            if side.is_positive { "1" } else { "-1" },
            quoted(&side.group),
            quoted(&self.to.name()),
        )
    }

    /// The other solver's points beside these: next to a limit of it, poses that rounding parts are one.
    fn compared(&self, stem: &str, places: &PoseNumbers) -> String {
        let width = places.width;
        let (pose, position) =
            (self.to.record(Analysis::Position, width), self.to.answers(Analysis::Position, width));
        let mut body = format!("{{\n{pose} found;\nLinkageWide size = 0;\n");
        let mut list = Vec::new();
        if self.to.has_parameters() {
            body += &format!("{} other;\n", self.to.parameters(width));
            let fields = |set: &SetInC<'_>| -> Vec<String> {
                let all = set.mechanism.params.iter();
                all.map(|of| param(set.mechanism, &text(&of.name))).collect()
            };
            for (to, from) in fields(self.to).iter().zip(fields(self.from)) {
                body += &format!("other.{to} = own.mechanism.{from};\n");
            }
            list.push("&other");
        }
        let is_record = self.to.interface.input_record().is_some();
        list.extend([
            if is_record { "&own.coordinates" } else { "own.coordinates" },
            "&found",
            "error",
        ]);
        body += &format!("status = {position}({});\n{RETURNED}", list.join(", "));
        let found = self.to.rows(Analysis::Position, "found").remove(0);
        let wide = |rows: &[RowInC], row: usize| match &rows[row] {
            RowInC::Number(value) => format!("(LinkageWide){value}"),
            RowInC::Angle(_) => "0".to_string(),
        };
        for (here, ..) in &self.carried.compared {
            let here = wide(&places.rows, *here);
            body += &format!("size = {stem}_larger(size, {stem}_size({here}));\n");
        }
        body += &format!("size = 256 * {} * size * size;\n", epsilon(width));
        for (here, there, group) in &self.carried.compared {
            let off = format!("({} - {})", wide(&places.rows, *here), wide(&found, *there));
            body += &format!(
                "if (!({off} * {off} <= size)) {{\nreturn {stem}_refused(error, LINKAGE_OTHER_ASSEMBLY, {}, {});\n}}\n",
                quoted(group),
                quoted(&self.to.name())
            );
        }
        body + "}\n"
    }

    fn rates(&self, width: Width) -> String {
        let (record, velocity) = (
            self.from.record(Analysis::Velocity, width),
            self.from.answers(Analysis::Velocity, width),
        );
        let is_record = self.from.interface.input_record().is_some();
        let mut pointers = vec!["transfer", "to"];
        pointers.extend(is_record.then_some("rates"));
        let mut body = format!("{record} found;\nLinkageStatus status;\n");
        body += &null_checks(&pointers);
        body += &format!(
            "status = {velocity}({}, rates, &found, error);\n{RETURNED}",
            self.own("transfer->")
        );
        let rows = self.from.rows(Analysis::Velocity, "found").remove(0);
        body + &self.picked("rates", rows, "(*to)", width) + "return LINKAGE_OK;\n"
    }

    fn motion(&self, width: Width) -> String {
        let (record, motion) =
            (self.from.record(Analysis::Motion, width), self.from.answers(Analysis::Motion, width));
        let is_record = self.from.interface.input_record().is_some();
        let mut pointers = vec!["transfer", "to"];
        pointers.extend(is_record.then_some(["rates", "accelerations"]).into_iter().flatten());
        let mut body = format!("{record} found;\nLinkageStatus status;\n");
        body += &null_checks(&pointers);
        body += &format!(
            "status = {motion}({}, rates, accelerations, &found, error);\n{RETURNED}",
            self.own("transfer->")
        );
        body += "to[0] = transfer->coordinates;\n";
        let orders = self.from.rows(Analysis::Motion, "found").into_iter().skip(1);
        for ((order, rows), given) in (1..).zip(orders).zip(["rates", "accelerations"]) {
            body += &self.picked(given, rows, &format!("to[{order}]"), width);
        }
        body + "return LINKAGE_OK;\n"
    }

    /// The rates of the other's inputs among those of this one's inputs and outputs.
    fn picked(&self, given: &str, rows: Vec<RowInC>, to: &str, width: Width) -> String {
        let is_record = self.from.interface.input_record().is_some();
        let given = if is_record { format!("(*{given})") } else { given.to_string() };
        let places = PoseNumbers { inputs: self.from.inputs_in(&given), rows, width };
        let to = self.to.inputs_in(to).into_iter().zip(&self.carried.coordinates);
        to.map(|(to, place)| format!("{to} = {};\n", places.value(place))).collect()
    }

    fn ratios(&self, width: Width) -> String {
        let (count, real) = (self.from.count(), width.in_c());
        let function = self.from.answers(Analysis::Coefficients, width);
        let mut body =
            format!("{real} rows[{}][{count}];\nLinkageStatus status;\n", self.from.interface.rows);
        body += &null_checks(&["transfer", "ratios"]);
        body +=
            &format!("status = {function}({}, rows, error);\n{RETURNED}", self.own("transfer->"));
        for (at, place) in self.carried.coordinates.iter().enumerate() {
            for input in 0..count {
                let value = match place {
                    PlaceInPose::Row(row, _) => format!("rows[{row}][{input}]"),
                    PlaceInPose::Input(own) => {
                        literal(if *own == input { 1.0 } else { 0.0 }, width)
                    }
                    PlaceInPose::Fixed(_) => literal(0.0, width),
                };
                body += &format!("ratios[{at}][{input}] = {value};\n");
            }
        }
        body + "return LINKAGE_OK;\n"
    }

    /// The ratios in a local, and what a function tells without them.
    fn by_ratios(&self, pointers: &[&str], width: Width) -> String {
        let (count, real) = (self.from.count(), width.in_c());
        let ratios = self.function(&format!("_{}", Behind::Ratios.name()), width);
        format!(
            "{real} ratios[{count}][{count}];\nLinkageStatus status;\n{}status = {ratios}(transfer, ratios, error);\n{RETURNED}",
            null_checks(pointers)
        )
    }

    fn efforts(&self, width: Width) -> String {
        let is_record = self.to.interface.input_record().is_some();
        let mut pointers = vec!["transfer", "to"];
        pointers.extend(is_record.then_some("efforts"));
        let mut body = self.by_ratios(&pointers, width);
        let efforts = self.to.inputs_in(if is_record { "(*efforts)" } else { "efforts" });
        let zero = literal(0.0, width);
        for (own, to) in self.from.inputs_in("(*to)").iter().enumerate() {
            let terms = efforts.iter().enumerate();
            let terms = terms.map(|(at, effort)| format!(" + ratios[{at}][{own}] * {effort}"));
            body += &format!("{to} = {zero}{};\n", terms.collect::<String>());
        }
        body + "return LINKAGE_OK;\n"
    }

    fn inertia(&self, width: Width) -> String {
        let (count, real) = (self.from.count(), width.in_c());
        // The result may be written where the inertia stands.
        let mut body =
            format!("{real} weighted[{count}], result[{count}][{count}];\nint own, at, other;\n");
        body += &self.by_ratios(&["transfer", "inertia", "to"], width);
        let zero = literal(0.0, width);
        let each = |name: &str| format!("for ({name} = 0; {name} < {count}; ++{name}) {{\n");
        let (own, at, other) = (each("own"), each("at"), each("other"));
        body + &format!(
            "{own}{at}weighted[at] = {zero};\n{other}weighted[at] += inertia[at][other] * ratios[other][own];\n}}\n}}\n\
             {at}result[at][own] = {zero};\n{other}result[at][own] += ratios[other][at] * weighted[other];\n}}\n}}\n}}\n\
             {own}{at}to[own][at] = result[own][at];\n}}\n}}\nreturn LINKAGE_OK;\n"
        )
    }
}
