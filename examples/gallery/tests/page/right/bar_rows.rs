//! Inputs of four-bars, and the right numbers there: both circles' common points in forty digits, that on the drawing's side.

use super::rows::Right;

pub(super) const BAR: &[Right] = &[
    (&[0.4], &[("C.x", 0.5690673540838303), ("C.y", -0.3613006113241994)]),
    (&[3.3], &[("C.x", 0.4729388860037922), ("C.y", -0.3204982884992383)]),
];

pub(super) const LONGER_CRANK: &[Right] = &[
    (
        &[0.4],
        &[
            ("C.x", 0.6126533962693505),
            ("C.y", 0.3620808581417187),
            ("blade.x", 0.5678847491513754),
            ("blade.y", 0.09413353452152241),
        ],
    ),
    (
        &[3.3],
        &[
            ("C.x", 0.466691585229766),
            ("C.y", 0.3071028180441178),
            ("blade.x", 0.4163970960243151),
            ("blade.y", 0.04013753124532292),
        ],
    ),
];
