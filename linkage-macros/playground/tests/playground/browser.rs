//! A stranger in a browser: what is typed, mended, set and saved. Needs Debian's `chromium`.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};
use std::{fs, thread};

use super::chromium::chromium;
use super::{skipped, wasm};

/// More than the way takes on a machine that does other work beside.
const PATIENCE: Duration = Duration::from_secs(120);

/// The way, step by step; a failure is told.
const WAY: &str = include_str!("stranger.js");

#[test]
#[ignore = "needs chromium, and builds the compiler for a browser"]
fn a_stranger_types_mends_and_takes_along() {
    if Command::new("chromium").arg("--version").output().is_err() {
        return skipped::skipped("the playground in a browser: no chromium");
    }
    let Some(page) = wasm::built() else { return };
    let page = fs::read_to_string(page).expect("it was written");
    let way = WAY.replace("</", "<\\/");
    let page = page.replacen("</html>", &format!("<script>{way}</script></html>"), 1);
    for width in ["1280", "360"] {
        assert_eq!(told(&page, width), "all is well", "{width}");
    }
}

/// The last words of the way. Streams and the compiler take real time, so that the page is looked at while it lives.
fn told(page: &str, width: &str) -> String {
    let folder = std::env::temp_dir().join(format!("playground_{width}_{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder can be made");
    let file = folder.join("play.html");
    fs::write(&file, page).expect("a file can be written");
    let mut browser = chromium(&folder)
        .args(["--enable-logging=stderr", "--remote-debugging-port=0"])
        .arg(format!("--window-size={width},900"))
        .arg(format!("file://{}", file.display()))
        .stderr(Stdio::piped())
        .spawn()
        .expect("chromium can be started");
    let (sender, receiver) = mpsc::channel();
    let lines = BufReader::new(browser.stderr.take().expect("it is piped")).lines();
    let reader = thread::spawn(move || {
        lines.map_while(Result::ok).for_each(|line| drop(sender.send(line)));
    });
    let (mut said, begun) = (String::new(), Instant::now());
    let found = loop {
        let left = PATIENCE.saturating_sub(begun.elapsed());
        let Ok(line) = receiver.recv_timeout(left) else { break format!("nothing: {said}") };
        if let Some((_, told)) = line.split_once("the way: ") {
            break told.split(".\"").next().unwrap_or_default().to_string();
        }
        said += &line;
    };
    drop(browser.kill());
    drop(browser.wait());
    drop(reader.join());
    let _ = fs::remove_dir_all(&folder);
    found
}
