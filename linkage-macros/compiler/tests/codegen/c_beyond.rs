//! Drawn machines beyond what they reach, in printed C and both widths: a limit by links that are drawn, never a number that
//! is none.

use super::c_parallelograms::printed;

/// A knee whose shank is driven: a dyad.
const KNEE: &str = "pub struct Beyond { input q: angle; ground A(0, 0), D(-35mm, 10mm);
    pin B(12mm, -70mm), C(-25mm, -62mm), ankle(0, -450mm);
    link front(A, B), rear(D, C), shank(B, C, ankle); drive shank.angle = 167.8deg - q; }";

/// The same with a foot that stands: a search, whose root the entry points by cosine and sine do not read.
const LEG: &str =
    "pub struct Beyond { input q: angle; load foot: force; ground A(0, 0), D(-35mm, 10mm);
    pin B(12mm, -70mm), C(-25mm, -62mm), ankle(0, -450mm);
    link front(A, B), rear(D, C), shank(B, C, ankle); drive shank.angle = 167.8deg - q;
    mass 1kg on ankle; force (0, foot) on ankle; }";

/// A pose, and what `ANSWER` stands for, at each degree.
const CALLER: &str = r#"
#include <stdio.h>
#include "beyond.h"
#define CALL(real, position, answer, function, answered) \
    for (k = -180; k < 180; k++) { \
        position at; \
        answer found; \
        LinkageError error = { LINKAGE_OK, 0, 0, 0, 0, 0 }, other = { LINKAGE_OK, 0, 0, 0, 0, 0 }; \
        const real q = (real)(((double)k + 0.3) * 3.14159265358979 / 180.0); \
        const LinkageStatus status = function(q, &at, &error), of_answer = answered(q, 1, 1, LOADS &found, &other); \
        printf("%d %d %.*s%.*s\n", (int)status, (int)of_answer, (int)error.group_length, error.group ? error.group : "", \
               (int)error.name_length, error.name ? error.name : ""); \
    }
int main(void)
{
    int k;
    CALL(double, BeyondPosition, Beyond@, beyond_position, beyond_#)
    CALL(float, BeyondPositionF32, Beyond@F32, beyond_position_f32, beyond_#_f32)
    return 0;
}
"#;

/// The counts of refusals of 360 poses in both widths, each of which is a limit by these links; none without a compiler.
fn refused(name: &str, source: &str, [record, entry, loads]: [&str; 3]) -> Option<[usize; 2]> {
    let caller = CALLER.replace('@', record).replace("_#", &format!("_{entry}"));
    let caller = caller.replace("LOADS ", loads);
    let text = printed(name, source, &caller)?;
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 720);
    let mut refused = [0; 2];
    for (nth, line) in lines.iter().enumerate() {
        let mut words = line.splitn(3, ' ');
        let mut status = || words.next().and_then(|word| word.parse::<i32>().ok());
        let statuses = [status(), status()];
        // A search has a name in its place.
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
    Some(refused)
}

#[test]
fn what_is_beyond_its_reach_in_c_is_at_a_limit() {
    // There is no pose next to 3.75 degrees alone, where the shank's vector is that of the grounds.
    let knee = refused("knee", KNEE, ["Motion", "motion", ""]);
    // The search was followed from -91.85 to 2.49 degrees. It refuses most of what is beyond.
    let leg = refused("leg", LEG, ["Forces", "forces", "700, "]);
    let (Some(knee), Some(leg)) = (knee, leg) else { return };
    assert_eq!(knee, [2, 2]);
    assert!(leg.iter().all(|refused| (155..170).contains(refused)), "{leg:?}");
}
