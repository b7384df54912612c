//! The verb `page`: pages on which machines are dragged.

use linkage_compiler::{PageParts, page};
use linkage_core::sketch::{Declared, Machine, Wishes, html_of_sets};
use syn::ext::IdentExt;

use crate::arguments::Page;
use crate::output::{self, Failure};
use crate::program::Program;
use crate::values::{FlagValue, Known, known};

pub(crate) fn run(arguments: &Page) -> Result<(), Failure> {
    let program = Program::read(&arguments.file, &arguments.chosen)?;
    // The text is the declared one, and values are those that are set, as a solver's are.
    let mut declared = program.each(program.written()?, |declaration| {
        let parts = page(declaration.tokens.clone())?;
        let driven = declaration
            .driven
            .as_ref()
            .map(|names| names.each_ref().map(|name| name.unraw().to_string()));
        Ok(Driven { parts, text: program.call(declaration), driven })
    })?;
    if !arguments.chosen.set.is_empty() {
        let set = program.all(page)?.into_iter();
        declared.iter_mut().zip(set).for_each(|(own, set)| own.parts.values = set.values);
    }
    let mut pages = Vec::new();
    for machine in together(&declared) {
        let (name, page) = written(machine, arguments)?;
        pages.push((format!("{name}.html"), page));
    }
    output::texts(&arguments.target, &arguments.file, pages)
}

/// A mechanism, and the set of inputs that drives it, of a machine that has several.
struct Driven {
    parts: PageParts,
    text: String,
    driven: Option<[String; 2]>,
}

/// The mechanisms of each page: the sets of inputs of one machine together.
fn together(declared: &[Driven]) -> impl Iterator<Item = &[Driven]> {
    declared.chunk_by(|one, next| {
        let [one, next] = [one, next].map(|of| of.driven.as_ref().map(|[machine, _]| machine));
        one.is_some() && one == next
    })
}

/// The name of a machine, and its page.
fn written(sets: &[Driven], arguments: &Page) -> Result<(String, String), Failure> {
    let wishes = wishes(sets, arguments)?;
    let machines = sets.iter().map(|Driven { parts, text, driven }| {
        let declared = Declared::new([
            &parts.plan,
            &parts.script,
            text,
            &parts.inputs,
            &parts.params,
            &parts.loads,
            &parts.outputs,
        ]);
        let (name, docs, values) = (&parts.name[..], &parts.docs[..], &parts.values[..]);
        let set = driven.as_ref().map_or("", |[_, set]| set);
        (set, Machine { name, docs, declared, values })
    });
    let machines: Vec<_> = machines.collect();
    let name = match (sets, &sets[0].driven) {
        ([_, _, ..], Some([machine, _])) => machine,
        _ => &sets[0].parts.name,
    };
    let page = html_of_sets(name, &machines, &wishes);
    page.map(|page| (name.clone(), page)).map_err(|error| Failure::Unusable(error.to_string()))
}

fn wishes(sets: &[Driven], arguments: &Page) -> Result<Wishes, Failure> {
    let of_sets = sets.iter().flat_map(|of| known(&of.parts.inputs));
    let mut inputs: Vec<Known<'_>> = Vec::new();
    for input in of_sets {
        if inputs.iter().all(|other| other.name != input.name) {
            inputs.push(input);
        }
    }
    let [params, loads] = [&sets[0].parts.params, &sets[0].parts.loads].map(|text| known(text));
    let all = [&inputs[..], &params, &loads].concat();
    let between = arguments.between.iter().map(|text| {
        let setting = FlagValue::read("between", text)?;
        let nth = setting.of(&all, "input, parameter or load")?;
        Ok((setting.name.to_string(), setting.ends(all[nth])?))
    });
    let rates = arguments.rate.iter().map(|text| {
        let setting = FlagValue::read("rate", text)?;
        let nth = setting.of(&inputs, "input")?;
        Ok((setting.name.to_string(), setting.rate(inputs[nth])?))
    });
    let given = arguments.load.iter().map(|text| {
        let setting = FlagValue::read("load", text)?;
        let nth = setting.of(&loads, "load")?;
        Ok((setting.name.to_string(), setting.value(loads[nth])?))
    });
    Ok(Wishes {
        title: arguments.title.clone(),
        curves: arguments.curves.clone(),
        ranges: between.collect::<Result<_, Failure>>()?,
        rates: rates.collect::<Result<_, Failure>>()?,
        loads: given.collect::<Result<_, Failure>>()?,
        ..Wishes::default()
    })
}
