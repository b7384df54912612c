//! Addresses of PMKS+ since 2024, with more than joints, links and forces.

use crate::program::given;

const DIGITS: &[u8; 62] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

/// An address with the character that counts it.
fn counted(sections: &str) -> String {
    let last = DIGITS[sections.encode_utf16().count() % 62] as char;
    format!("{sections}{last}")
}

/// FNV-1a of 32 bits.
fn fnv(text: &str) -> u32 {
    let step = |hash: u32, byte: u8| (hash ^ u32::from(byte)).wrapping_mul(16_777_619);
    text.bytes().fold(2_166_136_261, step)
}

/// An address with its digest, in six digits to the base of 62.
fn stamped(sections: &str) -> String {
    let text = counted(sections);
    let mut digits = String::new();
    for place in (0..6).rev() {
        digits.push(DIGITS[fnv(&text) as usize / 62_usize.pow(place) % 62] as char);
    }
    format!("{text}*{digits}")
}

/// A crank of 10 mm on a ground pin: sections behind the settings, and what stands behind the forces.
fn crank(settings: &str, forces: &str, more: &str) -> String {
    format!(
        "2P.{settings}.6A,A,0,0,0.0B,B,Fe,0,0..YRAB,AB,Fe,Fe,7q,0,c5cae9,A,B,,..{forces}.N_{more}"
    )
}

const SETTINGS: &str = "Ay,1E8.K,0.1011";

fn printed(text: &str) -> String {
    given(&format!("app.pmksplus.com/?{text}"), &[]).unwrap_or_else(|told| panic!("{text}: {told}"))
}

fn told(text: &str) -> String {
    given(&format!("app.pmksplus.com/?{text}"), &[]).expect_err("it is no machine")
}

/// Vectors that the hash's authors publish, and one changed letter, which the count of letters does not find.
#[test]
fn a_digest_finds_what_was_changed_on_the_way() {
    for (text, hash) in [("", 0x811c_9dc5), ("a", 0xe40c_292c), ("foobar", 0xbf9c_f968)] {
        assert_eq!(fnv(text), hash, "{text}");
    }
    let sections = crank(SETTINGS, "", "");
    let (bare, whole) = (counted(&sections), stamped(&sections));
    assert_eq!(printed(&whole), printed(&bare));
    let changed = |text: &str| text.replace("B,B,Fe,0", "B,B,Fa,0");
    assert_ne!(printed(&changed(&bare)), printed(&bare), "nothing finds it without a digest");
    assert!(told(&changed(&whole)).contains("the address was changed on its way"));
    let mailed = format!("{whole}&utm_source=news");
    assert_eq!(printed(&mailed), printed(&bare));
}

/// Numbers that thousandths do not hold stand behind, by the object and the number's place in its record.
#[test]
fn precise_numbers_are_taken() {
    let more = ".PJB~0~1.00025,PJB~1~-1e-7,PD~0~0.25,PLAB~2~0.5001";
    let text = printed(&stamped(&crank(SETTINGS, "", more)));
    assert!(text.contains("pin B(1.00025cm, -0.0000001cm);"), "{text}");
    let force = ".PFF1~4~2.0005";
    let text = printed(&stamped(&crank(SETTINGS, "2F1,AB,F1,7q,0,7q,Fe,VG.", force)));
    assert!(text.contains("force (0N, 2.0005N) on F1;"), "{text}");
    for wrong in [".PJC~0~1", ".PJB~9~1", ".PJB~0~x", ".PJB~0", ".PX~0~1"] {
        let text = told(&stamped(&crank(SETTINGS, "", wrong)));
        assert!(text.contains("corrects no number of the address"), "{wrong}: {text}");
    }
}

/// Each entry that means nothing here is a comment, once.
#[test]
fn what_stands_behind_and_is_left_out_is_told() {
    let more = ".JA,JB,FF1,HlAB,CGAB,S1,T1abc,G1~abc,KJA~d";
    let text = printed(&stamped(&crank(SETTINGS, "", more)));
    for what in ["locks", "held lengths and angles", "gears", "materials and cross-sections"] {
        let line = format!("// Left out: {what}.");
        assert_eq!(text.matches(&line).count(), 1, "{what}: {text}");
    }
    assert!(text.contains("// Left out: `KJA~d`."), "{text}");
    let rubbing = crank(SETTINGS, "", "").replace("6A,A,0,0,0.", "6A,A,0,0,0,,,,,,,0~3,0~2,1.");
    let text = printed(&stamped(&rubbing));
    assert!(text.contains("// Left out: the friction at `A`."), "{text}");
    assert!(told("pmks2:00000000.e30").contains("body document"));
}

/// Newtons, pounds beside inches, and units that are neither.
#[test]
fn a_force_has_its_unit_or_is_left_out() {
    let of = |words: &str| {
        let settings = format!("Ay,1E8.K,0.{words}");
        printed(&stamped(&crank(&settings, "2F1,AB,F1,7q,0,7q,Fe,VG.", "")))
    };
    assert!(of("1011").contains("force (0N, 2N) on F1;"));
    assert!(of("0000").contains("force (0N, 8.896443230521N) on F1;"));
    let text = of("1031");
    assert!(text.contains("// Left out: the force `F1`, whose unit is not known here."), "{text}");
    assert!(!text.contains("point F1"), "{text}");
}

/// A plate AB, BT that slides at B: two parts that are welded to one another, and the piston of their joint. Versions that
/// weld blocks write a second number into the settings.
#[test]
fn a_block_at_a_weld_of_parts_is_welded_in_newer_addresses() {
    let sections = |numbers: &str| {
        format!(
            "2P.{numbers}.K,0.1011.6O,O,0,0,0.0A,A,1Tm,1E8,0.8B,B,6MG,Fe,0.GT,T,7Km,1z0,0.5Z,Z,6MG,Fe,0.\
             .YROA,OA,Fe,Fe,0,0,c5cae9,O,A,,.YRABT,ABT,Fe,Fe,0,0,c5cae9,A,B,T,,AB,BT.\
             YPblock,block,Fe,0,0,0,,B,Z,,.NRAB,AB,Fe,Fe,0,0,c5cae9,A,B,,.NRBT,BT,Fe,Fe,0,0,c5cae9,B,T,,...N_"
        )
    };
    let text = printed(&counted(&sections("Ay")));
    assert!(text.contains("link block(B) on guide_Z;"), "{text}");
    assert!(
        text.contains("// `block` stays pinned to `ABT` at `B`, where parts of `ABT` are welded."),
        "{text}"
    );
    let text = printed(&stamped(&sections("Ay,1E8")));
    assert!(text.contains("link ABT(A, B, T) on guide_Z;"), "{text}");
    assert!(text.contains("// `block` is welded to `ABT` at `B`: both are `ABT`."), "{text}");
}

/// Two links of two parts each, all of which meet at one welded joint.
#[test]
fn links_at_a_welded_joint_are_one_though_their_parts_are_welded() {
    let sections = "2P.Ay,1E8.K,0.1011.6A,A,0,0,0.0B,B,Fe,0,0.8M,M,VG,0,0.0C,C,_W,Fe,0.0D,D,_W,0Fe,0.\
        .YRABM,ABM,Fe,Fe,0,0,c5cae9,A,B,M,,AB,BM.YRMCD,MCD,Fe,Fe,0,0,c5cae9,M,C,D,,MC,MD.\
        NRAB,AB,Fe,Fe,0,0,,A,B,M,,.NRBM,BM,Fe,Fe,0,0,,B,M,,.NRMC,MC,Fe,Fe,0,0,,M,C,,.NRMD,MD,Fe,Fe,0,0,,M,D,,...N_";
    let text = printed(&stamped(sections));
    assert!(text.contains("link ABM(A, B, M, C, D);"), "{text}");
    assert!(text.contains("// `MCD` is welded to `ABM` at `M`: both are `ABM`."), "{text}");
}
