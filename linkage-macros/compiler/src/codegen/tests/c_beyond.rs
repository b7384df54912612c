//! Drawn machines beyond what they reach, in printed C and both widths: a limit by links that are drawn, never a number that
//! is none.

use super::c_parallelograms::printed;

/// A knee whose shank is driven: a dyad.
const KNEE: &str = "pub struct Beyond { input q: angle; ground A(0, 0), D(-35mm, 10mm);
    pin B(12mm, -70mm), C(-25mm, -62mm), ankle(0, -450mm);
    link front(A, B), rear(D, C), shank(B, C, ankle); drive shank.angle = 167.8deg - q; }";

const CALLER: &str = r#"
#include <stdio.h>
#include "beyond.h"
#define CALL(real, position, motion, function, moving) \
    for (k = -180; k < 180; k++) { \
        position at; \
        motion moved; \
        LinkageError error = { LINKAGE_OK, 0, 0, 0, 0, 0 }, other = { LINKAGE_OK, 0, 0, 0, 0, 0 }; \
        const real q = (real)(((double)k + 0.3) * 3.14159265358979 / 180.0); \
        const LinkageStatus status = function(q, &at, &error), of_motion = moving(q, 1, 1, &moved, &other); \
        printf("%d %d %.*s\n", (int)status, (int)of_motion, (int)error.group_length, error.group ? error.group : ""); \
    }
int main(void)
{
    int k;
    CALL(double, BeyondPosition, BeyondMotion, beyond_position, beyond_motion)
    CALL(float, BeyondPositionF32, BeyondMotionF32, beyond_position_f32, beyond_motion_f32)
    return 0;
}
"#;

#[test]
fn what_is_beyond_its_reach_in_c_is_at_a_limit() {
    // There is no pose next to 3.75 degrees alone, where the shank's vector is that of the grounds.
    let Some(text) = printed("knee", KNEE, CALLER) else { return };
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 720);
    let mut refused = [0; 2];
    for (nth, line) in lines.iter().enumerate() {
        let mut words = line.splitn(3, ' ');
        let mut status = || words.next().and_then(|word| word.parse::<i32>().ok());
        let statuses = [status(), status()];
        let group = words.next().unwrap_or_default();
        assert_eq!(statuses[0], statuses[1], "{nth}: {line}");
        // Solved, out of reach, without a root, and with too many dead points.
        let [Some(status @ (0 | 1 | 8 | 9)), _] = statuses else { panic!("{nth}: {line}") };
        if status != 0 {
            refused[nth / 360] += 1;
            let links = group.split(", ").all(|link| ["front", "rear", "shank"].contains(&link));
            assert!(links, "{nth}: {line}");
        }
    }
    assert_eq!(refused, [2, 2]);
}
