//! What axe knows of pages that not everybody can use: of every machine's page, on a screen and on a phone, light and dark.
//!
//! Needs Debian's `chromium`, and `axe-core` of npm: `npm install --prefix target/node playwright-core axe-core`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use linkage_core::sketch::shortened;

use super::browser::{Visit, scripted};
use super::numbers::skipped;

/// Asks axe, and tells its violations as failures.
const ASK: &str = r#"
addEventListener("load", () => setTimeout(async () => {
  play(false);
  pick({ point: tracedPoints[0] });
  const { violations, passes } = await axe["run"](document, { resultTypes: ["violations"] });
  const failures = violations.map(({ id, "nodes": found }) => `${id}: ${found.length}, ${found[0]["html"].slice(0, 90)}`);
  parent.postMessage({ failures, "told": [`${passes.length} rules`] }, "*");
}, 300));
"#;

#[test]
#[ignore = "needs chromium and axe-core"]
fn axe_finds_no_violation() {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target/node/node_modules");
    // The variable names a folder, or says that node is required.
    let named = std::env::var_os("LINKAGE_NODE").map(PathBuf::from);
    let modules = named.filter(|folder| folder.is_dir()).unwrap_or(own);
    let axe = fs::read_to_string(modules.join("axe-core/axe.min.js"));
    let has_chromium = Command::new("chromium").arg("--version").output().is_ok();
    let Some(axe) = axe.ok().filter(|_| has_chromium) else {
        return skipped::skipped("axe over pages: no chromium or axe-core");
    };
    let axe = axe.replace("</", "<\\/");
    let pages = gallery::live::pages().unwrap();
    let mut asked = 0;
    for (flags, width) in [(&[][..], 1280), (&["--blink-settings=preferredColorScheme=0"][..], 360)]
    {
        for pages in pages.chunks(6) {
            let visit = |(name, html): &(&'static str, String)| Visit {
                name,
                html: html.clone(),
                width,
                steps: "",
            };
            let visits: Vec<Visit> = pages.iter().map(visit).collect();
            let flags = [flags, &["--force-prefers-reduced-motion"]].concat();
            let found = scripted(&visits, "axe", &flags, |_| format!("{axe}\n{}", shortened(ASK)));
            let told = found.lines().filter(|line| line.ends_with(" rules")).count();
            assert_eq!(told, visits.len(), "{found}");
            assert!(!found.contains("FAILED"), "{found}");
            asked += told;
        }
    }
    println!("{asked} pages");
}
