//! The pages of the manual are read in two places: as `docs/*.md` where the repository is shown,
//! and as modules in the documentation. `docs/README.md`, their index, is the documentation of
//! `reference` itself. A link there is a name, `[text][name]`, which the page defines at its end as a
//! file, and `reference.rs` in front of the page as an item or a figure: the first definition counts.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

const HERE: &str = env!("CARGO_MANIFEST_DIR");

fn read(path: &str) -> String {
    fs::read_to_string(Path::new(HERE).join(path)).expect("the file is there")
}

/// The text without examples and words of code.
fn prose(page: &str) -> String {
    let mut is_code = false;
    let lines = page.lines().filter(|line| {
        let is_fence = line.starts_with("```");
        is_code ^= is_fence;
        !is_code && !is_fence
    });
    lines.map(|line| format!("{line}\n")).collect()
}

/// `[name]: target` at the beginning of lines.
fn definitions(text: &str) -> BTreeMap<&str, &str> {
    text.lines().filter_map(|line| line.trim_start().strip_prefix('[')?.split_once("]: ")).collect()
}

/// The references in brackets, behind text in brackets or alone.
fn references(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some((_, behind)) = rest.split_once('[') {
        let Some((label, behind)) = behind.split_once(']') else { break };
        rest = behind;
        match behind.strip_prefix('[').and_then(|name| name.split_once(']')) {
            Some((name, further)) => {
                found.push(name);
                rest = further;
            }
            None if behind.starts_with('(') || behind.starts_with(": ") => {}
            None => found.push(label),
        }
    }
    found
}

/// As it stands in a link: small letters, hyphens for spaces, no other signs.
fn anchor(heading: &str) -> String {
    let heading = heading.trim_start_matches('#').trim().to_lowercase();
    let letter = |c: char| match c {
        ' ' => Some('-'),
        c => (c.is_alphanumeric() || c == '-' || c == '_').then_some(c),
    };
    heading.chars().filter_map(letter).collect()
}

/// Those of a page's headings.
fn anchors(text: &str) -> Vec<String> {
    text.lines().filter(|line| line.starts_with('#')).map(anchor).collect()
}

#[test]
fn links_lead_somewhere_in_the_repository_and_in_the_documentation() {
    let modules = read("src/reference.rs");
    let mut links = 0;
    for entry in fs::read_dir(Path::new(HERE).join("docs")).expect("the folder is there") {
        let file = entry.expect("an entry").file_name().into_string().expect("names are text");
        let page = read(&format!("docs/{file}"));
        let text = prose(&page);
        let name = file.strip_suffix(".md").expect("pages are markdown");
        let module = if name == "README" {
            &modules
        } else {
            modules.split_once(&format!("pub mod {name} {{")).expect("a module").1
        };
        let module = module.split_once(&format!("docs/{file}")).expect("it includes the page").0;
        let own = module.lines().filter_map(|line| line.trim_start().strip_prefix("//! "));
        let own: String = own.map(|line| format!("{line}\n")).collect();
        let included = module.split("include_str!(\"").skip(1);
        let included = included.filter_map(|behind| behind.split_once("\")"));
        let included: String = included.map(|(file, _)| read(&format!("src/{file}"))).collect();
        let mut items = definitions(&own);
        items.extend(definitions(&included));
        let files = definitions(&text);
        assert_eq!(items.keys().collect::<Vec<_>>(), files.keys().collect::<Vec<_>>(), "{file}");
        for (name, target) in &files {
            let (path, heading) = target.split_once('#').unwrap_or((target, ""));
            assert!(Path::new(HERE).join("docs").join(path).exists(), "{file}: {name}: {target}");
            let has_it =
                || anchors(&prose(&read(&format!("docs/{path}")))).contains(&heading.into());
            assert!(heading.is_empty() || has_it(), "{file}: {name}: {target}");
            let item = &items[name];
            assert!(
                !target.contains(".md#") || item.ends_with(&format!("#{heading}")),
                "{file}: {name}: {item}"
            );
        }
        let anchors = anchors(&text);
        for target in text.split("](").skip(1).map(|behind| behind.split(')').next()) {
            let target = target.expect("a split gives something");
            let inside = target.strip_prefix('#').map(str::to_string);
            assert!(inside.is_some_and(|name| anchors.contains(&name)), "{file}: {target}");
            links += 1;
        }
        let plain: String = text.split('`').step_by(2).collect();
        for name in references(&text) {
            // Brackets in words of code are those of arrays.
            let is_prose = name.starts_with('`') || plain.contains(&format!("[{name}]"));
            assert!(files.contains_key(name) || !is_prose, "{file}: [{name}] is not defined");
            links += usize::from(files.contains_key(name));
        }
    }
    assert!(links > 30, "{links}");
}
