//! A sheet on which many pictures can be looked at together.

use linkage_core::sketch::Theme;

/// Pictures side by side, stopped at the second that stands behind `#` in the address.
pub fn sheet(pictures: &[String], theme: Theme) -> String {
    let frame = theme.palette().quiet;
    format!(
        r#"<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<title>Pictures</title>
<style>body {{ margin: 0; background: {frame}; }} svg {{ margin: 2px; vertical-align: top; }}</style>
<body>{}</body>
<script>
addEventListener("load", () => setTimeout(() => {{
  for (const film of document.querySelectorAll("svg")) {{
    film.pauseAnimations();
    film.setCurrentTime(Number(location.hash.slice(1)));
  }}
}}, 300));
</script>
</html>
"#,
        pictures.concat()
    )
}
