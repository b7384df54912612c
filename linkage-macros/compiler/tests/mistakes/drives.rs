//! Mistakes in drives.

use super::{LEVERS, Slip, check, slip};

const DRIVE: &str = "drive AB.angle = theta;";

const SLIPS: [Slip; 13] = [
    slip(DRIVE, "/* no drive */", "before AB", DRIVE, DRIVE),
    slip(DRIVE, "drive AB = theta;", "AB", DRIVE, DRIVE),
    slip(DRIVE, "drive theta = AB.angle;", "theta", DRIVE, DRIVE),
    slip(DRIVE, "motor A = theta;", "motor", DRIVE, DRIVE),
    slip(DRIVE, "motor AB = theta;", "motor", DRIVE, DRIVE),
    slip(DRIVE, "drive B.angle = theta;", "B", "", DRIVE),
    slip(DRIVE, "drive A.angle = theta;", "A", "AB", DRIVE),
    slip(DRIVE, "drive AB.angle = 30;", "30", "", DRIVE),
    slip(DRIVE, "drive AB.angle = 30mm;", "30mm", "", DRIVE),
    slip(DRIVE, "drive AB.angle = theta; drive DC.angle = theta;", "theta#2", "", DRIVE),
    slip(
        "mass 4kg on E;",
        "mass 4kg on E; drive theta by push;",
        "push",
        "",
        "mass 4kg on E; drive theta by work;",
    )
    .means(&[("mass 4kg on E;", "mass 4kg on E; drive theta by work;")]),
    slip(
        "mass 4kg on E;",
        "mass 4kg on E; drive work by theta;",
        "work",
        "drive theta by work;",
        "mass 4kg on E; drive theta by work;",
    )
    .means(&[("mass 4kg on E;", "mass 4kg on E; drive theta by work;")]),
    slip(
        "mass 4kg on E;",
        "mass 4kg on E; drive theta by work; drive theta by work;",
        "theta#2",
        "",
        "mass 4kg on E; drive theta by work;",
    )
    .means(&[("mass 4kg on E;", "mass 4kg on E; drive theta by work;")]),
];

#[test]
fn mistakes_about_drives_are_mended_by_what_is_proposed() {
    check(LEVERS, &SLIPS);
}
