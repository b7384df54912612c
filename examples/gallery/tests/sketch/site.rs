//! The gallery as a site: every machine under one heading, with a page of its own.

use gallery::declarations::{NAMES, TEXTS};
use gallery::{Kind, page, pieces};

use super::cases::cases;

#[test]
fn the_index_leads_to_every_machine_once_under_the_heading_of_its_kind() {
    let pieces = pieces();
    let index = page::index(&pieces).unwrap();
    let sections: Vec<&str> = index.split("<section ").skip(1).collect();
    assert_eq!(sections.len(), Kind::ALL.len());
    for (section, kind) in sections.iter().zip(Kind::ALL) {
        let heading = format!("<h2>{}</h2>", kind.heading());
        assert!(section.contains(&heading), "{heading}");
        assert!(index.contains(&format!("<a href=\"#{kind:?}\">{}</a>", kind.heading())));
        assert!(section.contains("<img "), "{heading} is empty");
    }
    for piece in &pieces {
        let link = format!("<a href=\"{}.html\"", piece.name.replace("::", "_"));
        let place = Kind::ALL.iter().position(|kind| *kind == piece.kind).unwrap();
        assert_eq!(index.matches(&link).count(), 1, "{link}");
        assert!(sections[place].contains(&link), "{link}");
        // Films in images cannot be stopped: stills stand here.
        assert!(!index.contains("<animate"));
    }
    assert!(!index.contains("http"));
    // The room beside a picture as high as two is not left empty.
    assert!(index.contains("<a href=\"slider_crank_OffsetSliderCrank.html\" class=\"tall\">"));
    assert!((1..6).contains(&index.matches("class=\"tall\"").count()));
}

#[test]
fn the_page_of_a_machine_has_its_film_its_declaration_and_the_way_back() {
    let (pieces, live) = (pieces(), gallery::live::pages().unwrap());
    for piece in pieces.iter().step_by(cases(3, 1)) {
        let is_live = live.iter().any(|(name, _)| *name == piece.name);
        let text = page::machine(piece, [pieces.first(), None], is_live).unwrap();
        let dragged = format!("<a href=\"live_{}.html\">", piece.name.replace("::", "_"));
        assert_eq!(text.contains(&dragged), is_live, "{}", piece.name);
        let back = format!("<a href=\"index.html#{:?}\">", piece.kind);
        assert!(text.contains(&back) && text.contains(piece.text), "{}", piece.name);
        assert!(text.contains("flying_shear_FlyingShear.html"));
        assert_eq!(text.matches("<svg ").count(), 2, "wide and narrow");
        assert!(text.contains("prefers-reduced-motion"));
        let nth = NAMES.iter().position(|name| *name == piece.name).unwrap();
        let (file, declaration) = TEXTS[nth];
        let name = piece.name.split("::").nth(1).unwrap();
        assert!(declaration.contains(&format!("struct {name} {{")), "{}", piece.name);
        assert!(text.contains(file), "{file}");
        let shown = declaration.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        assert!(text.contains(&shown), "{}", piece.name);
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        assert!(root.join(file).exists(), "{file}");
    }
}
