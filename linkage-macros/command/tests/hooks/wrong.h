/* Functions that are wrong by nearly what they promise, either way by the bits of the argument. */
#ifndef WRONG_H
#define WRONG_H

#include <math.h>
#include <stdint.h>
#include <string.h>

static inline uint32_t mixed_bits(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits *= 2654435761u;
    return bits ^ bits >> 15;
}

/* By 2^-20 at most with the last rounding, which takes half of 2^-23 above one. */
static inline void wrong_sin_cos(float x, float *to_sin, float *to_cos)
{
    const uint32_t bits = mixed_bits(x);
    const double off = 0x1p-20 - 0x1p-23;
    *to_sin = (float)(sin((double)x) + ((bits & 1u) != 0u ? off : -off));
    *to_cos = (float)(cos((double)x) + ((bits & 2u) != 0u ? off : -off));
}

#define LINKAGE_SIN_COS_F32(x, to_sin, to_cos) wrong_sin_cos((x), (to_sin), (to_cos))
#define LINKAGE_SIN_COS_WITHIN_F32 20

#ifdef ALL_WRONG
/* By one last place and a half. */
static inline float wrong_sqrt(float x)
{
    const float root = sqrtf(x);
    return x > 0.0f ? nextafterf(root, (mixed_bits(x) & 1u) != 0u ? 0.0f : 2.0f * root) : root;
}

#define LINKAGE_SQRT_F32(x) wrong_sqrt(x)
#define LINKAGE_SQRT_PLACES_F32 2
#define LINKAGE_FMA_F32(a, b, c) fmaf((a), (b), (c))
#endif

#endif /* WRONG_H */
