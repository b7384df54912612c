//! Machines that have no declaration: the mistake is named.

use crate::program::{fixture, given, run};

fn check(text: &str, arguments: &[&str], told: &str) {
    match given(text, arguments) {
        Ok(printed) => panic!("{text}\nprinted\n{printed}"),
        Err(mistake) => assert_eq!(mistake.trim_end(), format!("error: {told}"), "{text}"),
    }
}

/// An address with the character that counts it.
fn address(sections: &str) -> String {
    let digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
    let text = format!("2P.Fe.K,0.1011.{sections}...N_");
    let last = digits.as_bytes()[text.len() % 62] as char;
    format!("https://app.pmksplus.com/?{text}{last}")
}

#[test]
fn texts_of_no_format() {
    let none =
        "this is no address with `?`, no expression `M[…]`, no JSON object and no model of MuJoCo";
    check("a four-bar", &[], none);
    check("", &[], none);
    let told = "`--drive` belongs to pyslvs expressions; other formats say what drives";
    check("{}", &["--drive", "0,1"], told);
    let told = given("M[J[R, P[0, 0], L[ground, a]]]", &["--unit", "yd"]).expect_err("no unit");
    assert!(told.contains("possible values: m, mm, cm, in, ft"), "{told}");
}

#[test]
fn addresses() {
    let whole = std::fs::read_to_string(fixture("pmks/four_bar.txt")).expect("it is there");
    let cut = "the address is cut off or changed: its last character does not count its length";
    check(&whole.trim_end()[..whole.len() - 3], &[], cut);
    check("https://app.pmksplus.com/?", &[], "there is nothing behind `?`");
    let joints = "KA,A,0,0,0.GB,B,Fe,0,0";
    let cases = [
        (
            format!("{joints}..YRAB,AB,Fe,Fe,0,0,,A,Q,,."),
            "`AB` names a joint `Q`, and there is none",
        ),
        (
            format!("{joints}.HP,P,0,Fe,0..YRAB,AB,Fe,Fe,0,0,,A,B,,.YPBP,BP,Fe,0,0,0,,B,P,,."),
            "`P` slides neither on the ground nor in the slot of a link",
        ),
        (
            format!("{joints}..YRAB,AB,Fe,Fe,0,0,,A,B,,.YPBP,BP,Fe,0,0,0,,B,,."),
            "the piston `BP` has no prismatic joint",
        ),
        (
            format!("{joints}.HP,P,0,Fe,0..YRAP,AP,Fe,Fe,0,0,,A,P,,."),
            "`P` slides neither on the ground nor in the slot of a link",
        ),
        (
            format!("{joints}.HP,P,0,Fe,0,AB,A..YRAP,AP,Fe,Fe,0,0,,A,P,,."),
            "the slot of `P` is no link and two joints",
        ),
        (
            "IA,A,0,0,0..YRAB,AB,Fe,Fe,0,0,,A,,.".into(),
            "`A` is an input of one link that is not on the ground",
        ),
        (
            "KA,A,0,0,0..XRAB,AB,Fe,Fe,0,0,,A,,.".into(),
            "`XRAB,AB,Fe,Fe,0,0,,A,,` is no link: its first letter is not Y, N or their like",
        ),
        (
            "KA,A,0,0..YRAB,AB,Fe,Fe,0,0,,A,,.".into(),
            "`KA,A,0,0` is no joint: its fields are name, title, x, y, angle",
        ),
        (
            format!("{joints}..YRAB,AB,Fe,Fe,0,0"),
            "`YRAB,AB,Fe,Fe,0,0` is no link: it ends in front of its joints",
        ),
        (format!("{joints}..YRAB,AB,Fe,!,0,0,,A,B,,."), "`!` is no number"),
        (
            format!("{joints}..YRAB,AB,Fe,Fe,0,0,,A,B,,..2F1,AB,F1,0,0,Fe,0"),
            "`2F1,AB,F1,0,0,Fe,0` is no force: its fields are name, link, title, two places of two numbers, and the magnitude",
        ),
        (
            format!("{joints}..YRAB,AB,Fe,Fe,0,0,,A,B,,..2,AB,F1,0,0,Fe,0,Fe"),
            "`2,AB,F1,0,0,Fe,0,Fe` is a force without a name",
        ),
        (
            format!("{joints}..YRAB,AB,Fe,Fe,0,0,,A,B,,..2F1,BC,F1,0,0,Fe,0,Fe"),
            "the force `F1` acts on `BC`, which is no link",
        ),
        (
            format!("{joints}..YRAB,AB,Fe,Fe,0,0,,A,B,,..2F1,AB,F1,Fe,0,Fe,0,Fe"),
            "the force `F1` has no direction: its arrow ends where it begins",
        ),
        ("KA,A,0,!,0..YRAB,AB,Fe,Fe,0,0,,A,,.".into(), "`!` is no number"),
        ("MA,A,0,0,0..".into(), "`A` is an input, and no link goes through it"),
        ("GA,A,0,0,0..".into(), "the machine has no link"),
    ];
    for (sections, told) in cases {
        check(&address(&sections), &[], told);
    }
}

#[test]
fn expressions() {
    let bar =
        "M[J[R, P[0, 0], L[ground, a]], J[R, P[1, 0], L[a]], J[P, A[0], P[2, 0], L[ground, b]]]";
    let cases = [
        ("M[J[X, P[0, 0], L[ground, a]]]", "`X` is no type of joint; there are R, P and RP"),
        (
            "M[J[RP, P[0, 0], L[ground, a]]]",
            "line 1: the angle `A[…]` of a joint RP belongs in front of `P[0, 0], L[ground, a`",
        ),
        ("M[J[R, P[0 0], L[ground, a]]]", "line 1: `,` belongs in front of `0], L[ground, a]]]`"),
        ("M[J[R, P[0, 1e999], L[ground, a]]]", "`1e999` is no number"),
        ("M[J[R, P[0, 0], L[ground, a]]", "the expression ends where `]` belongs"),
        ("M[J[R, P[0, 0], L[ground, a]]] M[]", "line 1: nothing belongs in front of `M[]`"),
        ("M[J[RP, A[0], P[0, 0], L[]]]", "`J0` slides on no link: it names none"),
        (
            "M[J[P, A[0], P[0, 0], L[a, ground]]]",
            "`J0` lets `ground` slide on `a`: name `ground` first",
        ),
        ("M[]", "the machine has no link"),
    ];
    for (text, told) in cases {
        check(text, &[], told);
    }
    check(bar, &["--drive", "0,9"], "`--drive 0,9` is no pair of joints: there are J0 to J2");
    check(bar, &["--drive", "1,1"], "`J1` is driven by itself, and it is no `RP`: it has no block");
    check(bar, &["--drive", "1,2"], "no link goes through both `J1` and `J2`");
    check(bar, &["--drive", "1,0"], "`a` is turned against nothing: `J1` is its joint alone");
}

#[test]
fn objects() {
    let ground = r#"{"id": "A", "type": "ground", "position": [0, 0]}"#;
    let machine = |joints: &str, links: &str| {
        format!(r#"{{"name": "x", "joints": [{ground}{joints}], "links": [{links}]}}"#)
    };
    let cases = [
        (
            machine(r#", {"id": "B", "position": [null, null]}"#, ""),
            "`B` has no position; let pylinkage compute one pose, then export it",
        ),
        (
            machine(r#", {"id": "B", "type": "cam", "position": [1, 0]}"#, ""),
            "`B` is a joint of type `cam`, which is not known here",
        ),
        (
            machine("", r#"{"id": "l", "joints": ["A", "B"]}"#),
            "`l` goes through `B`, which is no joint",
        ),
        (
            machine("", r#"{"id": "l", "type": "belt", "joints": ["A"]}"#),
            "`l` is a link of type `belt`, which is not known here",
        ),
        (
            machine(
                r#", {"id": "B", "position": [1, 0]}"#,
                r#"{"id": "l", "type": "driver", "joints": ["B"]}"#,
            ),
            "the driver `l` has no joint on the ground",
        ),
        (
            machine(
                r#", {"id": "T", "type": "tracker", "position": [1, 0], "ref_joint1_id": "A", "ref_joint2_id": "B"}"#,
                "",
            ),
            "no link has both references of the tracker `T`, `A` and `B`",
        ),
        (
            format!(r#"{{"name": "old", "joints": [{ground}]}}"#),
            "there are no `links`: an older linkage lists groups, not joints; convert it by pylinkage",
        ),
    ];
    for (text, told) in cases {
        check(&text, &[], told);
    }
    let told = given("{\n", &[]).expect_err("it is cut off");
    assert!(
        told.starts_with("error: this is no mechanism of pylinkage: EOF while parsing"),
        "{told}"
    );
}

#[test]
fn older_addresses() {
    let crank = "a,0,0,ab,R,t,Null,t%0Ab,1,0,ab,R,f,Null,f";
    let cases = [
        (
            "a,0,0,ab,R,t,Null",
            "ab,R,1,1,0,0,a,",
            "",
            "`a,0,0,ab,R,t,Null` is no joint: its fields are name, x, y, links, type, ground, angle and input",
        ),
        ("a,Null,0,ab,R,t,Null,t", "ab,R,1,1,0,0,a,", "", "`Null` is no number"),
        ("a,0,0,ab,R,yes,Null,t", "ab,R,1,1,0,0,a,", "", "`yes` is neither `t` nor `f`"),
        ("a,0,0,ab,???,t,Null,t", "ab,R,1,1,0,0,a,", "", "`a` is neither `R` nor `P`"),
        (crank, "ab,R,1,1", "", "`ab,R,1,1` is no link: it ends in front of its joints"),
        (crank, "ab,R,1,1,0,0,a%7Cc,", "", "`ab` names a joint `c`, and there is none"),
        (
            crank,
            "ab,R,1,1,0,0,a%7Cb,",
            "F1,ab,0,0",
            "`F1,ab,0,0` is no force: its fields are name, link, two places of two numbers, two marks and the magnitude",
        ),
        (
            crank,
            "ab,R,1,1,0,0,a%7Cb,",
            "F1,bc,0,0,1,0,t,t,1",
            "the force `F1` acts on `bc`, which is no link",
        ),
    ];
    for (joints, links, forces, told) in cases {
        let text = format!("app.pmksplus.com/?j={joints}&l={links}&f={forces}&s=10,false,false,cm");
        check(&text, &[], told);
    }
    let text = format!("?j={crank}&l=&s=10,false,false,yd");
    check(&text, &[], "the address has no unit of length that is known");
}

/// Names become identifiers, each for one thing, and the solver is named as the machine is.
#[test]
fn names() {
    let text = "M[J[R, P[0, 0], L[ground, fn]], J[R, P[1, 0], L[fn, J0, theta]], J[R, P[2, 0], L[ground, J0]]]";
    let printed = given(text, &["--drive", "0,1", "--name", "3 bars, in line", "--unit", "in"])
        .expect("a machine");
    assert_eq!(
        printed,
        "mechanism! {\n    pub struct Machine3BarsInLine {\n        input theta_2: angle;\n        \
         ground J0(0, 0), J2(2in, 0);\n        pin J1(1in, 0);\n        link fn_(J0, J1);\n        \
         link J0_2(J1, J2);\n        link theta(J1);\n        drive fn_.angle = theta_2;\n    }\n}\n"
    );
    let printed = run(&fixture("pylinkage/coupler_curve.json"), &[]).expect("a machine");
    assert!(printed.contains("pub struct CouplerCurve {"), "{printed}");
}
