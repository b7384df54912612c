//! The verb `page`: pages on which machines are dragged.

use linkage_compiler::{PageParts, page};
use linkage_core::sketch::{Declared, Machine, Wishes, html};

use crate::arguments::Page;
use crate::output::{self, Failure};
use crate::program::Program;
use crate::values::{FlagValue, known};

pub(crate) fn run(arguments: &Page) -> Result<(), Failure> {
    let program = Program::read(&arguments.file, &arguments.chosen)?;
    // The text is the declared one, and values are those that are set, as a solver's are.
    let mut declared = program.each(program.written()?, |declaration| {
        Ok((page(declaration.tokens.clone())?, program.call(declaration)))
    })?;
    if !arguments.chosen.set.is_empty() {
        let set = program.all(page)?.into_iter();
        declared.iter_mut().zip(set).for_each(|((parts, _), set)| parts.values = set.values);
    }
    let mut pages = Vec::new();
    for (parts, text) in &declared {
        pages.push((format!("{}.html", parts.name), written(parts, text, arguments)?));
    }
    output::texts(&arguments.target, &arguments.file, pages)
}

/// The page of a mechanism.
fn written(parts: &PageParts, text: &str, arguments: &Page) -> Result<String, Failure> {
    let declared = Declared::new([
        &parts.plan,
        &parts.script,
        text,
        &parts.inputs,
        &parts.params,
        &parts.loads,
        &parts.outputs,
    ]);
    let wishes = wishes(parts, arguments)?;
    let machine = Machine { name: &parts.name, docs: &parts.docs, declared, values: &parts.values };
    html(&machine, &wishes).map_err(|error| Failure::Unusable(error.to_string()))
}

fn wishes(parts: &PageParts, arguments: &Page) -> Result<Wishes, Failure> {
    let [inputs, params, loads] =
        [&parts.inputs, &parts.params, &parts.loads].map(|text| known(text));
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
