//! Names of declarations that the language or a vendor has for itself, and what is refused.

use linkage_compiler::st;

use super::reader::Project;

fn printed(source: &str, only: &[&str]) -> Result<String, String> {
    let files = st(source.parse().expect("these are tokens"), only, None, false);
    files.map(|files| files[0].text.clone()).map_err(|mistakes| {
        let [mistake] = &mistakes[..] else { panic!("one mistake") };
        format!("{}; {}", mistake.message, mistake.note.clone().unwrap_or_default())
    })
}

/// Whatever the names are, the text declares each once: the reader refuses anything else.
#[test]
fn names_of_the_language_and_names_that_differ_by_case_are_renamed() {
    let source =
        "pub struct End_If { input status: angle; param region = 80mm; param Region = 632mm;
        ground A(0, 0), D(665.7mm, 0);
        crank AB(A) -> B { length: region, angle: status }
        rrr BC(B), DC(D) -> C { lengths: (Region, 374mm), mode: right }
        point sin on BC at (500mm, -60mm); point Int on BC at (1mm, 0); point θ on BC at (2mm, 0);
        point c on BC at (3mm, 0); output sin, Int, θ, C, c, BC; }";
    let text = printed(source, &["motion"]).expect("it is printed");
    let mut project = Project::default();
    let run_time =
        st(source.parse().expect("these are tokens"), &[], None, false).expect("it is printed");
    project.read(&run_time[1].text);
    project.read(&text);
    for part in [
        "TYPE v_End_If :\nSTRUCT\n    v_region : LREAL := 0.08; (* In m *)\n    v_v_Region : LREAL := 0.632;",
        "FUNCTION_BLOCK end_if_motion\n",
        "    mechanism : v_End_If;",
        "    v_status : LREAL; (* In rad *)",
        "    sine : LinkagePoint;",
        "    v_Int : LinkagePoint;",
        "    u03b8 : LinkagePoint;",
        "    C : LinkagePoint;",
        "    v_c : LinkagePoint;",
        "motion.position.v_c.x := ",
    ] {
        assert!(text.contains(part), "no `{part}` in\n{text}");
    }
}

#[test]
fn what_structured_text_has_not_is_refused_by_name() {
    let rubs = "pub struct Rubs { input t: angle; ground A(0, 0); guide bed through A along 0deg;
        crank AB(A) -> B { length: 60mm, angle: t } rrp BC(B), ram(bed) -> C { length: 240mm, mode: ahead }
        mass 6kg on ram at (0, 0); friction 0.1 at A radius 40mm; output ram, t.drive; }";
    let told = printed(rubs, &[]).expect_err("it rubs");
    assert_eq!(
        told,
        "structured text prints no friction of `Rubs`; `--only motion` prints the motion, and `export c` all of it"
    );
    assert!(
        printed(rubs, &["motion"])
            .expect("motion is printed")
            .contains("FUNCTION_BLOCK rubs_motion")
    );
    let tanh =
        "pub struct Cam { input t: angle; ground A(0, 0); crank AB(A) -> B { length: 1m, angle: t }
        output lift = tanh(t / 1rad); }";
    assert_eq!(
        printed(tanh, &[]).expect_err("it is no function"),
        "`tanh` is no function of structured text; `export c` prints it"
    );
}
