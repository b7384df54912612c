//! A page of HTML that holds a film, wide and narrow, with a button and a slider.

use std::format;
use std::string::String;

use super::style::Theme;
use super::svg::{escaped, number};

/// The width of the film for a telephone, whose letters are as large as those of a wide one.
pub(super) const NARROW: f64 = 328.0;

const SCRIPT: &str = include_str!("player.js");

/// The page; the films come as text of SVG and last so long.
pub(super) fn page(title: &str, [wide, narrow]: [&str; 2], seconds: f64) -> String {
    let (title, seconds) = (escaped(title), number(seconds, 3));
    let [day, night] = [Theme::Light, Theme::Dark].map(Theme::palette);
    format!(
        r#"<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>{title}</title>
<style>
body {{ margin: 0; padding: 16px; background: {}; color: {}; font: 15px "Helvetica Neue", Arial, sans-serif; }}
main {{ max-width: 720px; margin: auto; }}
svg {{ display: block; max-width: 100%; height: auto; margin: auto; }}
.narrow {{ display: none; }}
p.player {{ display: flex; gap: 12px; align-items: center; }}
button {{ font: inherit; min-width: 5em; padding: 4px 12px; }}
input {{ flex: 1; }}
output {{ min-width: 4em; text-align: right; font-variant-numeric: tabular-nums; }}
@media (max-width: 560px) {{
  .wide {{ display: none; }}
  .narrow {{ display: block; }}
}}
@media (prefers-color-scheme: dark) {{
  body {{ background: {}; color: {}; }}
}}
</style>
<main>
<div class="wide">{wide}</div>
<div class="narrow">{narrow}</div>
<p class="player"><button type="button">Pause</button><input type="range" min="0" max="{seconds}" step="any" value="0" aria-label="time"><output>0.00 s</output></p>
</main>
<script>
const length = {seconds};
{SCRIPT}</script>
</html>
"#,
        day.paper, day.ink, night.paper, night.ink,
    )
}
