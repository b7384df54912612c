/* Sine and cosine of CMSIS-DSP, which look up 512 values and take a straight line between two. Compile the printed sources
 * with -DLINKAGE_HOOKS='"cmsis_dsp.h"'.
 *
 * Over a turn they are wrong by 2^-15 at most: `linkage report shear.rs --sine-error 2^-15`. */
#ifndef CMSIS_DSP_H
#define CMSIS_DSP_H

#include "arm_math.h"

static inline void cmsis_dsp_sin_cos(float x, float *to_sin, float *to_cos)
{
    *to_sin = arm_sin_f32(x);
    *to_cos = arm_cos_f32(x);
}

#define LINKAGE_SIN_COS_F32(x, to_sin, to_cos) cmsis_dsp_sin_cos((x), (to_sin), (to_cos))
#define LINKAGE_SIN_COS_WITHIN_F32 15

#endif /* CMSIS_DSP_H */
