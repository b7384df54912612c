/* What the example asks of CMSIS-DSP, by its way: 512 values over a turn, and a straight line between two. */
#ifndef ARM_MATH_H
#define ARM_MATH_H

#include <math.h>

#define TABLE 512

static inline float looked_up(float turns)
{
    static float table[TABLE + 1];
    const float part = turns - floorf(turns), place = part * (float)TABLE;
    int at = (int)place;
    if (table[TABLE / 4] == 0.0f) {
        int k;
        for (k = 0; k <= TABLE; k++) {
            table[k] = (float)sin(6.283185307179586 * k / TABLE);
        }
    }
    if (at >= TABLE) {
        return table[0];
    }
    return table[at] + (place - (float)at) * (table[at + 1] - table[at]);
}

static inline float arm_sin_f32(float x) { return looked_up(x * 0.159154943092f); }

static inline float arm_cos_f32(float x) { return looked_up(x * 0.159154943092f + 0.25f); }

#endif /* ARM_MATH_H */
