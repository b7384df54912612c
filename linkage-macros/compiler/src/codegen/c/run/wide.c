/* linkage_run.c: what solvers that linkage has printed do where an answer is near a limit or none: decisions
 * without rounding, and reasons. linkage_run.h says whose text this is. */
#include "linkage_run.h"

/* The error of a value in units of its spread's last place: larger values are positive for certain. */
#define ROUNDINGS 16

/* The distance by which a pose may miss assembly, in last places of the longest length. */
#define ULPS 4

/* Numbers by which it is decided, of which those of a caller in single precision are exact. */

#ifdef LINKAGE_NO_DOUBLE

static int is_finite(float x) { return linkage_is_finitef(x); }

static float size_of(float x) { return fabsf(x); }

static float narrowed(const LinkageWhy *why, float value)
{
    (void)why;
    return value;
}

/* Not by a product that may underflow. */
static int is_above_rounding(const LinkageWhy *why, float value, float spread)
{
    (void)why;
    return value * (1.0f / (ROUNDINGS * FLT_EPSILON)) > spread;
}

static int is_full_square(const LinkageWhy *why, float square)
{
    (void)why;
    return square >= linkage_smallest_squaref();
}

static int is_subnormal(const LinkageWhy *why, float value)
{
    (void)why;
    return value < FLT_MIN;
}

static float permitted(const LinkageWhy *why, float size)
{
    (void)why;
    return 0.022097087f * size;
}

#else

static int is_finite(double x) { return linkage_is_finite(x); }

static double size_of(double x) { return fabs(x); }

/* A number of the caller's width. */
static double narrowed(const LinkageWhy *why, double value) { return why->is_single ? (double)(float)value : value; }

static double epsilon(const LinkageWhy *why) { return why->is_single ? (double)FLT_EPSILON : DBL_EPSILON; }

static double smallest_normal(const LinkageWhy *why) { return why->is_single ? (double)FLT_MIN : DBL_MIN; }

static int is_above_rounding(const LinkageWhy *why, double value, double spread)
{
    return value > ROUNDINGS * epsilon(why) * spread;
}

static int is_full_square(const LinkageWhy *why, double square)
{
    return square >= (why->is_single ? (double)linkage_smallest_squaref() : linkage_smallest_square());
}

static int is_subnormal(const LinkageWhy *why, double value) { return value < smallest_normal(why); }

/* The difference of an equation's sides that is rounding, by what they are made of. */
static double permitted(const LinkageWhy *why, double size)
{
    return why->is_single ? (double)(0.022097087f * (float)size) : 9.5367431640625e-7 * size;
}

#endif /* LINKAGE_NO_DOUBLE */

typedef enum Reach { MEETS, AT_LIMIT, BEYOND, COINCIDENT, NO_NUMBER } Reach;

#ifndef LINKAGE_NO_SINGLE

/* 2^k for -126 <= k <= 127. */
static float power_of_twof(int k)
{
    const uint32_t bits = (uint32_t)(k + 127) << 23;
    float power;
    (void)memcpy(&power, &bits, sizeof power);
    return power;
}

/* x*x + y*y, for numbers of which the larger is about 1. */
static float sum_of_squares(float x, float y)
{
#ifdef LINKAGE_NO_DOUBLE
    return linkage_pair_plus(linkage_pair_product(x, x), linkage_pair_product(y, y)).high;
#else
    return (float)((double)x * (double)x + (double)y * (double)y);
#endif
}

#endif /* LINKAGE_NO_SINGLE */
