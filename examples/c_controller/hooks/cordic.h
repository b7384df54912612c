/* Sine and cosine by an integer CORDIC, as units of some microcontrollers have one: J. E. Volder, IRE Transactions on
 * Electronic Computers 8 (1959). Compile the printed sources with -DLINKAGE_HOOKS='"cordic.h"'.
 *
 * Over a turn it is wrong by 2^-21 at most: `linkage report shear.rs --sine-error 2^-21`. */
#ifndef CORDIC_H
#define CORDIC_H

#include <stdint.h>

#define CORDIC_STEPS 28

static inline void cordic_sin_cos(float x, float *to_sin, float *to_cos)
{
    /* Angles whose tangents are 1, 1/2, 1/4 and so on; a turn is 2^32. */
    static const int32_t angles[CORDIC_STEPS] = {
        536870912, 316933406, 167458907, 85004756, 42667331, 21354465, 10679838,
        5340245, 2670163, 1335087, 667544, 333772, 166886, 83443,
        41722, 20861, 10430, 5215, 2608, 1304, 652,
        326, 163, 81, 41, 20, 10, 5
    };
    const float turns = x * 0.15915494f, part = turns - (float)(int32_t)turns;
    const uint32_t phase = (uint32_t)(int64_t)(part * 4294967296.0f), quarter = (phase + 0x20000000u) >> 30;
    int32_t left = (int32_t)(phase - (quarter << 30));
    /* The product of all cosines, so that the last length is one; one is 2^30. */
    int32_t along = 652032874, across = 0;
    float sine, cosine;
    int k;
    for (k = 0; k < CORDIC_STEPS; k++) {
        const int32_t turned_along = along >> k, turned_across = across >> k;
        const int32_t sign = left < 0 ? -1 : 1;
        along -= sign * turned_across;
        across += sign * turned_along;
        left -= sign * angles[k];
    }
    cosine = (float)along * (1.0f / 1073741824.0f);
    sine = (float)across * (1.0f / 1073741824.0f);
    *to_cos = (quarter & 1u) == 0u ? cosine : -sine;
    *to_sin = (quarter & 1u) == 0u ? sine : cosine;
    if ((quarter & 2u) != 0u) {
        *to_cos = -*to_cos;
        *to_sin = -*to_sin;
    }
}

#define LINKAGE_SIN_COS_F32(x, to_sin, to_cos) cordic_sin_cos((x), (to_sin), (to_cos))
#define LINKAGE_SIN_COS_WITHIN_F32 21

#endif /* CORDIC_H */
