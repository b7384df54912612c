//! The figures of the manual, one a statement: frames, signs, dimensions, modes; and limits, dead and change points.
//! Every place in them is a solver's.

mod annotations;
mod dyads;
mod limits;
mod placing;

pub use annotations::Figure;

use linkage_core::sketch::{SketchError, Theme};

/// The figures of the page about statements as addresses that hold them whole, by the names that the documentation's
/// text gives them: a page of documentation has no files beside it.
///
/// # Errors
/// A drawing that fails, by a mistake in a figure.
pub fn addresses() -> Result<String, SketchError> {
    statements(Theme::Auto).map(as_addresses)
}

/// The film of the page about searches, in the same way.
///
/// # Errors
/// A drawing that fails, by a mistake in a figure.
pub fn addresses_of_searches() -> Result<String, SketchError> {
    Ok(as_addresses(vec![("suspension", crate::motions::of_unknowns().to_svg()?)]))
}

/// The same of the page about limits.
///
/// # Errors
/// A drawing that fails, by a mistake in a figure.
pub fn addresses_of_limits() -> Result<String, SketchError> {
    limits(Theme::Auto).map(as_addresses)
}

fn as_addresses(figures: Vec<(&str, String)>) -> String {
    let escaped = |letter: char| match letter {
        '<' => "%3C".into(),
        '>' => "%3E".into(),
        '#' => "%23".into(),
        '%' => "%25".into(),
        '"' => "%22".into(),
        ' ' => "%20".into(),
        '{' => "%7B".into(),
        '}' => "%7D".into(),
        '[' => "%5B".into(),
        ']' => "%5D".into(),
        '\n' => String::new(),
        letter => letter.to_string(),
    };
    let line = |(name, figure): (&str, String)| {
        let figure: String = figure.chars().map(escaped).collect();
        format!("[{name} drawn]: <data:image/svg+xml,{figure}>\n")
    };
    figures.into_iter().map(line).collect::<String>() + "\n"
}

/// Every figure by the name of its file.
///
/// # Errors
/// A drawing that fails, by a mistake in a figure.
pub fn figures(theme: Theme) -> Result<Vec<(&'static str, String)>, SketchError> {
    Ok([statements(theme)?, limits(theme)?].concat())
}

fn statements(theme: Theme) -> Result<Vec<(&'static str, String)>, SketchError> {
    Ok(vec![
        ("crank", placing::crank(theme)?),
        ("slider", placing::slider(theme)?),
        ("rrr", dyads::rrr(theme)?),
        ("rrp", dyads::rrp(theme)?),
        ("rpr", dyads::rpr(theme)?),
        ("prp", dyads::prp(theme)?),
        ("rpp", dyads::rpp(theme)?),
        ("guide", placing::guide(theme)?),
        ("point", placing::point(theme)?),
        ("polar", placing::polar(theme)?),
    ])
}

fn limits(theme: Theme) -> Result<Vec<(&'static str, String)>, SketchError> {
    Ok(vec![
        ("limit", limits::limit(theme)?),
        ("dead_point", limits::dead_point(theme)?),
        ("change_point", limits::change_point(theme)?),
        ("class_three", limits::class_three(theme)?),
    ])
}
