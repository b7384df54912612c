//! Charts on pages: they shrink with the page, and have dark colours where the reader prefers them.

/// Colours on white, and what takes their place on a dark page.
const COLOURS: [(&str, &str); 12] = [
    ("white", "#0d1117"),
    ("#ffffff", "#0d1117"),
    ("black", "#e6edf3"),
    ("#000000", "#e6edf3"),
    ("#222222", "#e6edf3"),
    ("#cccccc", "#30363d"),
    ("#0072b2", "#4ea1e0"),
    ("#d55e00", "#f08a3c"),
    ("#009e73", "#2fc99b"),
    ("#e69f00", "#f2b53b"),
    ("#cc79a7", "#e39cc4"),
    ("#56b4e9", "#7cc7f2"),
];

/// The chart with a `viewBox`, as wide as the page at most.
///
/// # Panics
/// Where the text is no chart.
pub(crate) fn fitted(chart: &str) -> String {
    let (head, rest) = chart.split_once('>').expect("a chart begins with its element");
    let number = |name: &str| {
        let (_, behind) = head.split_once(name).expect("it has a size");
        behind.split('"').next().expect("the number ends")
    };
    let (width, height) = (number(" width=\""), number(" height=\""));
    let mut rules = String::new();
    for (day, night) in COLOURS {
        for property in ["fill", "stroke"] {
            let attribute = format!("{property}=\"{day}\"");
            if chart.contains(&attribute) {
                rules += &format!("[{attribute}]{{{property}:{night}}}");
            }
        }
    }
    format!(
        "{head} viewBox=\"0 0 {width} {height}\"><style>svg{{max-width:100%;height:auto}}\
         @media (prefers-color-scheme:dark){{{rules}}}</style>{rest}"
    )
}
