//! A text of PMKS+, pyslvs, pylinkage or MuJoCo as a declaration. The playground reads such texts as well.

mod drawing;
mod mjcf;
mod names;
mod parallelograms;
mod pmks;
mod printed;
mod pylinkage;
mod pyslvs;
mod triangles;

use drawing::Drawing;

/// The reason why a machine cannot be read or has no declaration.
type Mistake = String;

/// The declaration, under another name or in another unit where these are given.
pub(crate) fn declaration(
    text: &str,
    drives: &[String],
    [name, unit]: [Option<&str>; 2],
) -> Result<String, Mistake> {
    let mut drawing = read(text, drives)?;
    parallelograms::make_exact(&mut drawing);
    if let Some(name) = name {
        drawing.name = name.to_string();
    }
    if let Some(unit) = unit {
        drawing.unit = unit.to_string();
    }
    printed::declaration(&drawing)
}

/// The machine in whichever format the text is.
fn read(text: &str, drives: &[String]) -> Result<Drawing, Mistake> {
    let is_expression = pyslvs::is_expression(text);
    if !drives.is_empty() && !is_expression {
        return Err("`--drive` belongs to pyslvs expressions; other formats say what drives".into());
    }
    match () {
        () if is_expression => pyslvs::read(text, drives),
        () if mjcf::is_model(text) => mjcf::read(text),
        () if text.starts_with('{') => pylinkage::read(text),
        () if text.contains('?') => pmks::read(text),
        () => Err("this is no address with `?`, no expression `M[…]`, no JSON object and no model of MuJoCo".into()),
    }
}
