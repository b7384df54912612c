//! Debian's `chromium`, for tests of what a browser makes of a page.

use std::fs;
use std::path::Path;
use std::process::Command;

/// Chromium without a window, with a profile of its own.
pub(crate) fn chromium(folder: &Path) -> Command {
    let mut command = Command::new("chromium");
    command
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"])
        .args(["--disable-background-networking", "--disable-component-update", "--disable-sync"])
        .arg(format!("--user-data-dir={}", folder.join("profile").display()));
    command
}

/// Runs a page in a browser with these flags, and returns what it leaves in its first plain `pre`.
pub(crate) fn run(page: &str, name: &str, flags: &[&str]) -> String {
    let folder = std::env::temp_dir().join(format!("gallery_{name}_{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let file = folder.join("page.html");
    fs::write(&file, page).unwrap();
    // Without virtual time a browser may write the document before its scripts have run.
    let dom = (0..5).find_map(|_| {
        let mut command = chromium(&folder);
        command.arg("--dump-dom").args(flags).arg(format!("file://{}", file.display()));
        let output = command.output().expect("chromium can be started");
        let dom = String::from_utf8(output.stdout).unwrap();
        dom.contains("<pre>").then_some(dom)
    });
    let _ = fs::remove_dir_all(&folder);
    let dom = dom.expect("the page has a pre");
    let (_, behind) = dom.split_once("<pre>").expect("the page has a pre");
    behind.split_once("</pre>").expect("it ends").0.to_string()
}
