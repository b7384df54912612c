/* The largest errors of a machine in single precision beside double: filled in by proved_in_c.rs. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "@header@.h"

#define RESULTS @count@

/* By result, the largest error at a rate of 1, and at a second rate of 1. */
static double worst[2][RESULTS];
static long refused;

static void look(float at, int order)
{
    @Name@MotionF32 single;
    @Name@Motion wide;
    const float rate = order == 0 ? 1.0f : 0.0f;
    if (@header@_motion_f32(at, rate, 1.0f - rate, &single, NULL) != LINKAGE_OK
        || @header@_motion((double)at, (double)rate, 1.0 - (double)rate, &wide, NULL) != LINKAGE_OK) {
        refused += 1;
        return;
    }
    const double errors[RESULTS] = { @errors@ };
    for (int k = 0; k < RESULTS; k += 1) {
        /* What is not a number is kept. */
        if (!(errors[k] <= worst[order][k])) worst[order][k] = errors[k];
    }
}

/* The numbers in their order, as integers. */
static int64_t place(float value)
{
    int32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits < 0 ? -(int64_t)(bits & 0x7fffffff) : bits;
}

static float number(int64_t place)
{
    const int32_t bits = (int32_t)(place < 0 ? (-place | 0x80000000) : place);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static float inside(double at, double from, double to)
{
    float value = (float)at;
    if ((double)value < from) value = nextafterf(value, INFINITY);
    if ((double)value > to) value = nextafterf(value, -INFINITY);
    return value;
}

static void drawn(double from, double to, long count)
{
    for (long k = 0; k < count; k += 1) {
        /* Weyl's sequence; towards either end by powers of two. */
        const double share = fmod((double)(k + 1) * 0.618033988749895, 1.0);
        const double near = (to - from) * exp2(-20.0 * share);
        const double at = k % 4 == 0 ? from + near : k % 4 == 2 ? to - near : from + share * (to - from);
        look(inside(at, from, to), (int)(k / 4 % 2));
    }
}

static void every(double from, double to, long step)
{
    const int64_t last = place(inside(to, from, to));
    long count = 0;
    for (int64_t k = place(inside(from, from, to)); k <= last; k += step) look(number(k), (int)(count++ % 2));
}

int main(void)
{
    /* One of the two is asked. */
    (void)drawn;
    (void)every;
@stretches@
    printf("%ld\n", refused);
    for (int k = 0; k < RESULTS; k += 1) printf("%.17g %.17g\n", worst[0][k], worst[1][k]);
    return 0;
}
