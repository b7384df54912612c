/* The errors of a machine in single precision beside what `linkage report` proves: over every so many numbers of a turn, each
 * with both signs. Double precision stands for the truth. Printed are poses, refusals, and the largest share of a bound; the
 * status is 1 where a bound, or the error that a sine promises, is exceeded. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include LINKAGE_HOOKS
#include "machine.h"

#define COUNT (sizeof bounds / sizeof bounds[0])

/* A result is numbers alone. */
typedef char all_are_bounded[sizeof(Narrow) == COUNT * sizeof(float) && sizeof(Wide) == COUNT * sizeof(double) ? 1 : -1];

/* More than the error of double precision, whose numbers are some metres at most. */
#define OF_TRUTH 1e-13

/* Above the rounding of a coordinate that does not move, which is its bound. */
#define MOVES 2e-8

/* The largest number of single precision below half a turn. */
#define HALF_TURN 0x40490fdau

static unsigned long poses, refused;
static double largest_share;

static void look(float x)
{
    Narrow narrow;
    Wide wide;
    LinkageError error;
    float numbers[COUNT], sine, cosine;
    double truth[COUNT];
    size_t i;
    LINKAGE_SIN_COS_F32(x, &sine, &cosine);
    if (!(fmax(fabs((double)sine - sin((double)x)), fabs((double)cosine - cos((double)x))) <= ldexp(1.0, -LINKAGE_SIN_COS_WITHIN_F32))) {
        printf("the sine or the cosine of %.9g: %.9g, %.9g\n", (double)x, (double)sine, (double)cosine);
        exit(1);
    }
    poses++;
    if (NARROW(x, &narrow, &error) != LINKAGE_OK || WIDE((double)x, &wide, &error) != LINKAGE_OK) {
        refused++;
        return;
    }
    memcpy(numbers, &narrow, sizeof numbers);
    memcpy(truth, &wide, sizeof truth);
    for (i = 0; i < COUNT; i++) {
        const double off = fabs((double)numbers[i] - truth[i]);
        if (!(off <= bounds[i] + OF_TRUTH)) {
            printf("number %d at %.9g is wrong by %g, of %g\n", (int)i, (double)x, off, bounds[i]);
            exit(1);
        }
        if (bounds[i] > MOVES) {
            largest_share = fmax(largest_share, off / bounds[i]);
        }
    }
}

int main(int count, char **arguments)
{
    const uint32_t step = count > 1 ? (uint32_t)strtoul(arguments[1], NULL, 10) : 1u;
    uint32_t bits;
    for (bits = 0; bits <= HALF_TURN; bits += step) {
        float x;
        memcpy(&x, &bits, sizeof x);
        look(x);
        look(-x);
    }
    printf("%lu %lu %.4f\n", poses, refused, largest_share);
    return 0;
}
