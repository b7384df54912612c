/* linkage_root.c: the root of an unknown's equation between two ends. linkage_run.h says whose text this is.
 *
 * Newton's steps, each projected onto an interval about the middle of the bracket that halves with every
 * evaluation, which bounds their number: I. F. D. Oliveira and R. H. C. Takahashi, ACM Trans. Math. Softw. 47
 * (2021). Where the ends enclose no root, an end beyond a dead point is moved to it, and then the interval is
 * surveyed. Roots and refusals are those of the solver in Rust to the last bit. One search holds 48 samples on
 * the stack, 2 kB in double precision. */
#include "linkage_run.h"

/* Evaluations beyond those of bisection: what Newton's steps may take where they are no better. */
#define SPARE 6

/* Newton's steps from a seed. */
#define SEEDED 3

/* Newton's steps on the first cubic, or halvings. */
#define CUBIC_STEPS 10

/* The most samples of a survey. */
#define SAMPLES 48

/* Larger than any budget. */
#define UNLIMITED 1000

/* Why a search ended without a root. */
typedef enum Failure { NO_INTERVAL, NO_ROOT, SEVERAL_DEAD_POINTS, NOT_A_NUMBER, SINGULAR_ROOT } Failure;

/* The course of a function between two ends. */
typedef enum Course { RISES, IS_ZERO, NEVER_RISES, UNKNOWN_COURSE } Course;

#ifdef LINKAGE_NO_DOUBLE

/* The exponent as a double would have it, in which no float is subnormal. */
static int exponent_of(float x)
{
    const int is_subnormal = x < FLT_MIN;
    uint32_t bits;
    x = is_subnormal ? x * 16777216.0f : x;
    (void)memcpy(&bits, &x, sizeof bits);
    return x == 0.0f ? 0 : (int)((bits >> 23) & 0xffu) + (is_subnormal ? 1023 - 127 - 24 : 1023 - 127);
}

/* True if angles are more than a turn apart, by more than rounding. */
static int is_beyond_a_turn(float from, float to, float epsilon)
{
    const LinkagePair apart = linkage_pair_plus(linkage_pair_sum(to, -from), linkage_pair(-6.28318548f, 1.74845553e-07f));
    const LinkagePair sizes = linkage_pair_plus(linkage_pair_sum(fabsf(from), fabsf(to)), linkage_pair(6.28318548f, -1.74845553e-07f));
    return linkage_pair_above(apart, linkage_pair(epsilon * sizes.high, epsilon * sizes.low));
}

#else

static int exponent_of(double x)
{
    uint64_t bits;
    (void)memcpy(&bits, &x, sizeof bits);
    return (int)((bits >> 52) & 0x7ffu);
}

/* True if angles are more than a turn apart, by more than rounding. */
static int is_beyond_a_turn(double from, double to, double epsilon)
{
    const double turn = 6.283185307179586;
    return to - from > turn + epsilon * (fabs(from) + fabs(to) + turn);
}

#endif /* LINKAGE_NO_DOUBLE */

static int remaining(int most, int taken) { return most > taken ? most - taken : 0; }

static void refuse_root(LinkageWhy *why, Failure failure, const char *unknown, LinkageWide by, int is_in_order)
{
    static const LinkageStatus statuses[] = { LINKAGE_INVALID_LENGTH, LINKAGE_NO_SOLUTION,
        LINKAGE_SEVERAL_DEAD_POINTS, LINKAGE_NOT_FINITE, LINKAGE_SINGULAR };
    if (failure == NOT_A_NUMBER) {
        why->otherwise = why->otherwise == NULL ? unknown : why->otherwise;
        return;
    }
    if (why->status != LINKAGE_OK) {
        return;
    }
    why->status = statuses[failure];
    why->by = failure == NO_ROOT ? by : 0;
    why->group = failure == NO_INTERVAL || failure == SINGULAR_ROOT ? unknown : NULL;
    why->name = failure == SINGULAR_ROOT ? NULL : unknown;
    if (failure == NO_INTERVAL) {
        why->name = is_in_order ? "ends of between" : "width of between";
    }
}
