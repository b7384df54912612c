/* linkage_run.c: what solvers that linkage has printed do where an answer is near a limit or none: decisions
 * without rounding, and reasons. linkage_run.h says whose text this is. */
#include "linkage_run.h"

#if LINKAGE_RUN_TIME != 0x5eb9ddb6u
#error "linkage_run.h was printed by another version than this file: print both anew, or one supplier's with a prefix"
#endif

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

/* Answers. */

LinkageWhy linkage_why(int is_single)
{
    LinkageWhy why;
    why.status = LINKAGE_OK;
    why.is_single = is_single;
    why.by = 0;
    why.group = NULL;
    why.name = NULL;
    why.otherwise = NULL;
    why.goes_on = 0;
    why.stand_in = 0;
    why.is_open = 0;
    return why;
}

/* The letters of a name; no declaration has a longer one. */
#define LONGEST_NAME 4096

static size_t length_of(const char *text)
{
    size_t length = 0;
    while (text != NULL && length < LONGEST_NAME && text[length] != '\0') { /* at most LONGEST_NAME times */
        length++;
    }
    return length;
}

LinkageWhy linkage_why_behind(int is_single, LinkageWide stand_in)
{
    LinkageWhy why = linkage_why(is_single);
    why.goes_on = 1;
    why.stand_in = stand_in;
    return why;
}

/* What is missing, as the caller is told. No double is computed with where there is none: its bits are those of the
 * float, behind an exponent of another bias. */
static double reported(LinkageWide by)
{
#if defined(LINKAGE_NO_DOUBLE) && DBL_MANT_DIG == 53
    const int is_normal = by >= FLT_MIN;
    const float normal = is_normal ? by : by * 16777216.0f;
    const uint64_t bias = is_normal ? 1023u - 127u : 1023u - 127u - 24u;
    uint32_t bits;
    uint64_t wide;
    double same;
    (void)memcpy(&bits, &normal, sizeof bits);
    wide = bits == 0u ? 0u : ((uint64_t)bits << 29) + (bias << 52);
    (void)memcpy(&same, &wide, sizeof same);
    return same;
#else
    return (double)by;
#endif
}

LinkageStatus linkage_refused(const LinkageWhy *why, LinkageError *error)
{
    if (error != NULL) {
        error->status = why->status;
        error->by = reported(why->by);
        error->group = why->group;
        error->group_length = length_of(why->group);
        error->name = why->name;
        error->name_length = length_of(why->name);
    }
    return why->status;
}

LinkageStatus linkage_because(LinkageError *error, LinkageStatus status, const char *name)
{
    LinkageWhy why = linkage_why(0);
    why.status = status;
    why.name = name;
    return linkage_refused(&why, error);
}

/* Why a cosine and a sine are those of no angle. */
LinkageStatus linkage_not_on_circle(LinkageError *error, LinkageWide cosine, LinkageWide sine, const char *name)
{
    if (!is_finite(cosine)) {
        return linkage_because(error, LINKAGE_NOT_FINITE, "cos");
    }
    if (!is_finite(sine)) {
        return linkage_because(error, LINKAGE_NOT_FINITE, "sin");
    }
    return linkage_because(error, LINKAGE_OFF_CIRCLE, name);
}

static LinkageWide refuse(LinkageWhy *why, LinkageStatus status, const char *group, const char *name, LinkageWide by, LinkageWide value)
{
    if (why->goes_on) {
        return status == LINKAGE_OUT_OF_REACH ? why->stand_in : (LinkageWide)NAN;
    }
    why->status = status;
    why->group = group;
    why->name = name;
    why->by = by;
    return value;
}

void linkage_given_finite(LinkageWhy *why, const LinkageNamed *given, int count)
{
    int i;
    for (i = 0; i < count; i++) { /* at most count times */
        if (!is_finite(given[i].value)) {
            (void)refuse(why, LINKAGE_NOT_FINITE, NULL, given[i].name, 0, 0);
            return;
        }
    }
}

/* To blame for a result that is none is the largest given number whose fourth power leaves the number's range,
 * as a rate that is squared on the way does; where there is none, the result itself. */
static void blame(LinkageWhy *why, const char *result, const LinkageNamed *given, int count)
{
    LinkageWide largest = 0;
    int i;
    for (i = 0; i < count; i++) { /* at most count times */
        const LinkageWide size = size_of(given[i].value);
        const LinkageWide square = narrowed(why, given[i].value * given[i].value);
        const LinkageWide fourth = narrowed(why, square * square);
        if (!is_finite(fourth) && size > largest) {
            largest = size;
            result = given[i].name;
        }
    }
    (void)refuse(why, LINKAGE_NOT_FINITE, NULL, result, 0, 0);
}

void linkage_results_finite(LinkageWhy *why, const LinkageNamed *results, int count, const LinkageNamed *given, int given_count)
{
    int i;
    if (why->status == LINKAGE_OK && why->otherwise != NULL) {
        (void)refuse(why, LINKAGE_NOT_FINITE, NULL, why->otherwise, 0, 0);
    }
    for (i = 0; i < count && why->status == LINKAGE_OK; i++) { /* at most count times */
        if (!is_finite(results[i].value)) {
            blame(why, results[i].name, given, given_count);
        }
    }
}

int linkage_lacks_a_pose(const LinkageWhy *why)
{
    return why->status == LINKAGE_OUT_OF_REACH || why->status == LINKAGE_NO_SOLUTION;
}

int linkage_is_told(const LinkageWide *told, const LinkageWide *others, int count)
{
    int i, known = 0;
    for (i = 0; i < count; i++) { /* at most count times */
        if (is_finite(told[i])) {
            known++;
        } else if (told[i] == told[i] || !is_finite(others[i])) {
            return 0;
        }
    }
    return known > 0;
}

/* Sizes. */

LinkageWide linkage_nonzero(LinkageWhy *why, LinkageWide value, const char *group)
{
    if (why->status != LINKAGE_OK) {
        return value;
    }
    if (value != value) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0, value);
    }
    return value == 0 ? refuse(why, LINKAGE_SINGULAR, group, NULL, 0, value) : value;
}

static LinkageWide valid(LinkageWhy *why, LinkageWide value, int is_valid, const char *group, const char *name)
{
    if (why->status != LINKAGE_OK) {
        return value;
    }
    if (value != value) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, name, 0, value);
    }
    return is_valid ? value : refuse(why, LINKAGE_INVALID_LENGTH, group, name, 0, value);
}

LinkageWide linkage_positive(LinkageWhy *why, LinkageWide value, const char *group, const char *name)
{
    return valid(why, value, value > 0, group, name);
}

LinkageWide linkage_not_negative(LinkageWhy *why, LinkageWide value, const char *group, const char *name)
{
    return valid(why, value, value >= 0, group, name);
}

LinkageWide linkage_square(LinkageWhy *why, LinkageWide value, const char *group)
{
    if (why->status != LINKAGE_OK) {
        return value;
    }
    if (value == 0) {
        return refuse(why, LINKAGE_SINGULAR, group, NULL, 0, value);
    }
    if (is_finite(value) && is_full_square(why, value)) {
        return value;
    }
    return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0, value);
}

LinkageWide linkage_moving(LinkageWhy *why, LinkageWide value, LinkageWide spread, const char *name)
{
    if (why->status != LINKAGE_OK) {
        return value;
    }
    if (value != value) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, name, 0, value);
    }
    if (is_above_rounding(why, value, spread)) {
        return value;
    }
    return refuse(why, LINKAGE_SINGULAR, name, NULL, 0, value);
}

LinkageWide linkage_certified(LinkageWhy *why, LinkageWide value, const char *group)
{
    if (why->status != LINKAGE_OK || value > 0) {
        return value;
    }
    if (value != value) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0, value);
    }
    return refuse(why, LINKAGE_NOT_CERTIFIED, group, NULL, 0, value);
}
#ifndef LINKAGE_NO_DOUBLE

/* Numbers without rounding. */

/* Above this a sum of two words has the sign of the exact one and, but for half a unit, its last place. */
#define TWO_WORDS (1.0 / 1099511627776.0)

/* The sum of at most 16 terms, rounded at the very end: J. R. Shewchuk, Discrete & Computational Geometry 18
 * (1997), grow-expansion. */
static double exact_sum(const double *terms, int count)
{
    double parts[16], sum = 0.0;
    int i, k;
    for (i = 0; i < count; i++) { /* at most 16 times */
        double carry = terms[i];
        for (k = 0; k < i; k++) { /* at most 16 times */
            const double next = carry + parts[k];
            parts[k] = linkage_add_err(carry, parts[k]);
            carry = next;
        }
        parts[i] = carry;
    }
    for (i = 0; i < count; i++) { /* at most 16 times */
        sum += parts[i];
    }
    return sum;
}

/* A power of two that brings the largest of some numbers between 1 and 2. */
typedef struct Scale {
    double down;
    double up;
    int exponent;
} Scale;

/* 2^k for -1023 <= k <= 1023, of which the first is subnormal. */
static double power_of_two(int k)
{
    const uint64_t bits = (uint64_t)(k + 1023) << 52;
    double power;
    if (k < -1022) {
        return DBL_MIN / 2.0;
    }
    (void)memcpy(&power, &bits, sizeof power);
    return power;
}

static int scale_of(Scale *scale, const double *numbers, int count)
{
    double largest = 0.0;
    uint64_t bits;
    int i, exponent;
    for (i = 0; i < count; i++) { /* at most 16 times */
        if (!linkage_is_finite(numbers[i])) {
            return 0;
        }
        largest = fabs(numbers[i]) > largest ? fabs(numbers[i]) : largest;
    }
    (void)memcpy(&bits, &largest, sizeof bits);
    exponent = (int)(bits >> 52);
    exponent = (exponent > 1 ? exponent : 1) - 1023;
    scale->down = power_of_two(-exponent);
    scale->up = power_of_two(exponent);
    scale->exponent = exponent;
    return 1;
}

/* The number out of the scale; the largest number where it is out of range. */
static double scaled_up(const Scale *scale, double x)
{
    const double up = x * scale->up;
    return up < DBL_MAX ? up : DBL_MAX;
}

/* Some last places of a scaled number of the caller's width. */
static double slack_of(const LinkageWhy *why, const Scale *scale, double x)
{
    uint64_t bits;
    double ulp, least;
    (void)memcpy(&bits, &x, sizeof bits);
    bits &= (uint64_t)0x7ff << 52;
    (void)memcpy(&ulp, &bits, sizeof ulp);
    ulp *= epsilon(why);
    if (scale->exponent <= -100) {
        least = smallest_normal(why) * epsilon(why) * scale->down;
        ulp = ulp > least ? ulp : least;
    }
    return ULPS * ulp;
}

static double distance(double dx, double dy) { return sqrt(dx * dx + dy * dy); }

static double larger(double a, double b) { return a > b ? a : b; }

/* dx^2 + dy^2 - (a + b + w)^2 within a last place and with the sign of the exact value. */
static LINKAGE_COLD double excess_with(double dx, double dy, double a, double b, double w)
{
    const double x[8] = { dx, dy, -a, -b, -w, -2.0 * a, -2.0 * a, -2.0 * b };
    const double y[8] = { dx, dy, a, b, w, b, w, w };
    double terms[16];
    int i;
    for (i = 0; i < 8; i++) { /* at most 8 times */
        terms[2 * i] = x[i] * y[i];
        terms[2 * i + 1] = linkage_mul_err(x[i], y[i]);
    }
    return exact_sum(terms, 16);
}

/* The same without w: in two words, and without rounding next to a limit. */
static double excess(double dx, double dy, double a, double b)
{
    const double span = a + b, rest = linkage_add_err(a, b);
    const double square = dx * dx + dy * dy, square_rest = linkage_add_err(dx * dx, dy * dy);
    const double high = square - span * span, high_rest = linkage_add_err(square, -(span * span));
    const double products = linkage_mul_err(dx, dx) + linkage_mul_err(dy, dy) - linkage_mul_err(span, span) - rest * (2.0 * span);
    const double value = high + (products + (square_rest + high_rest));
    return fabs(value) > TWO_WORDS ? value : excess_with(dx, dy, a, b, 0.0);
}

/* Decisions. */

/* Two circles, scaled and without signs. */
typedef struct Circles {
    Scale scale;
    double dx, dy, l1, l2, longer, shorter;
} Circles;

static int circles_of(Circles *c, double dx, double dy, double l1, double l2)
{
    const double given[4] = { dx, dy, l1, l2 };
    if (!scale_of(&c->scale, given, 4)) {
        return 0;
    }
    c->dx = fabs(dx * c->scale.down);
    c->dy = fabs(dy * c->scale.down);
    c->l1 = fabs(l1 * c->scale.down);
    c->l2 = fabs(l2 * c->scale.down);
    c->longer = larger(c->l1, c->l2);
    c->shorter = c->l1 > c->l2 ? c->l2 : c->l1;
    return 1;
}

/* Decides whether points are at least longer - shorter apart. */
static Reach too_close(double dx, double dy, double longer, double shorter, double slack, const Scale *scale, double *by)
{
    const double gap = longer - shorter, missing = -excess(dx, dy, longer, -shorter);
    const double short_gap[3] = { longer, -shorter, -slack };
    const int is_clear = missing > 2.0 * (2.0 * gap * slack);
    if (missing > 0.0
        && (is_clear || !(exact_sum(short_gap, 3) <= 0.0 || excess_with(dx, dy, longer, -shorter, -slack) >= 0.0))) {
        *by = scaled_up(scale, missing / (distance(dx, dy) + gap));
        return BEYOND;
    }
    if (dx == 0.0 && dy == 0.0) {
        return COINCIDENT;
    }
    return missing > 0.0 ? AT_LIMIT : MEETS;
}

/* Decides whether circles meet; `by` is what is missing. */
static Reach circles(const LinkageWhy *why, double dx, double dy, double l1, double l2, Circles *c, double *by)
{
    double d, slack, span, missing;
    int is_clear;
    if (!circles_of(c, dx, dy, l1, l2)) {
        return NO_NUMBER;
    }
    d = distance(c->dx, c->dy);
    slack = slack_of(why, &c->scale, larger(d, c->longer));
    span = c->longer + c->shorter;
    missing = excess(c->dx, c->dy, c->longer, c->shorter);
    if (missing <= 0.0) {
        return too_close(c->dx, c->dy, c->longer, c->shorter, slack, &c->scale, by);
    }
    is_clear = missing > 2.0 * (slack * (2.0 * span + slack));
    if (!is_clear && excess_with(c->dx, c->dy, c->longer, c->shorter, slack) <= 0.0) {
        return AT_LIMIT;
    }
    *by = scaled_up(&c->scale, missing / (d + span));
    return BEYOND;
}

/* The square of half the sine of the angle between the bars. */
static double height_product(const Circles *c)
{
    const double outer = -excess(c->dx, c->dy, c->longer, c->shorter);
    const double inner = excess(c->dx, c->dy, c->longer, -c->shorter);
    const double four = 4.0 * c->longer * c->shorter;
    return (outer / four) * (inner / four);
}

/* Where the joint's foot stands on the line of centres, as a share of it; also of a joint on the line. */
static double foot(const Circles *c, int is_on_line)
{
    const double x[4] = { c->dx, c->dy, c->l1, -c->l2 }, y[4] = { c->dx, c->dy, c->l1, c->l2 };
    double terms[8], share;
    int i;
    for (i = 0; i < 4; i++) { /* at most 4 times */
        terms[2 * i] = x[i] * y[i];
        terms[2 * i + 1] = linkage_mul_err(x[i], y[i]);
    }
    share = exact_sum(terms, 8) / (2.0 * (c->dx * c->dx + c->dy * c->dy));
    if (is_on_line) {
        const double size = c->l1 / distance(c->dx, c->dy);
        return share < 0.0 ? -size : size;
    }
    return share;
}

/* Decides whether |t| <= |l|. */
static Reach line(const LinkageWhy *why, double t, double l, double *by)
{
    const double given[2] = { t, l };
    double a, b, terms[3];
    Scale scale;
    if (!scale_of(&scale, given, 2)) {
        return NO_NUMBER;
    }
    a = fabs(t * scale.down);
    b = fabs(l * scale.down);
    if (a <= b) {
        return MEETS;
    }
    terms[0] = a;
    terms[1] = -b;
    terms[2] = -slack_of(why, &scale, larger(a, b));
    if (exact_sum(terms, 3) <= 0.0) {
        return AT_LIMIT;
    }
    *by = scaled_up(&scale, a - b);
    return BEYOND;
}

/* Decides whether a point is as far away as an offset. */
static Reach offset(const LinkageWhy *why, double bx, double by, double e, double *missing)
{
    const double given[3] = { bx, by, e };
    double x, y, gap;
    Scale scale;
    if (!scale_of(&scale, given, 3)) {
        return NO_NUMBER;
    }
    x = fabs(bx * scale.down);
    y = fabs(by * scale.down);
    gap = fabs(e * scale.down);
    return too_close(x, y, gap, 0.0, slack_of(why, &scale, larger(distance(x, y), gap)), &scale, missing);
}

/* Values. */

/* The square of half the sine of the angle between the bars, in squares of a unit. */
static double height_in(const Circles *c, double unit)
{
    return height_product(c) * unit * unit;
}

/* The square of the height of a triangle over its side l. The answer says whether it can be told from zero where it is
 * none. */
static int square_of_height(const LinkageWhy *why, const Circles *c, double l, double r1, double r2, double *square)
{
    const double height = 2.0 * r1 * (r2 / l), product = height_product(c);
    *square = product * height * height;
    return !(product > 0.0 && *square < smallest_normal(why));
}

static int is_product_normal(const LinkageWhy *why, double l1, double l2)
{
    return 4.0 * l1 * l2 >= smallest_normal(why);
}

#else

/* Numbers without rounding, in single precision alone. */

#define TERMS 16

/* A sum in parts of rising size that do not overlap, of so many terms at most: J. R. Shewchuk, Discrete & Computational
 * Geometry 18 (1997), grow-expansion with elimination of zeros. */
typedef struct Sum {
    float parts[TERMS];
    int count;
} Sum;

static void add(Sum *sum, float term)
{
    int i, kept = 0;
    if (term == 0.0f) {
        return;
    }
    for (i = 0; i < sum->count; i++) { /* at most TERMS times */
        const float next = term + sum->parts[i], rest = linkage_add_errf(term, sum->parts[i]);
        term = next;
        if (rest != 0.0f) {
            sum->parts[kept++] = rest;
        }
    }
    if (term != 0.0f) {
        sum->parts[kept++] = term;
    }
    sum->count = kept;
}

static void add_product(Sum *sum, float x, float y)
{
    const LinkagePair product = linkage_pair_product(x, y);
    add(sum, product.low);
    add(sum, product.high);
}

/* A number of the sum's sign: the largest part. */
static float sign_of(const Sum *sum) { return sum->count > 0 ? sum->parts[sum->count - 1] : 0.0f; }

/* The sum in two words. */
static LinkagePair pair_of(const Sum *sum)
{
    LinkagePair pair = linkage_pair(sign_of(sum), 0.0f);
    int i;
    for (i = sum->count - 2; i >= 0; i--) { /* at most TERMS times */
        const LinkagePair next = linkage_pair_joined(pair.high, sum->parts[i]);
        pair = linkage_pair(next.high, pair.low + next.low);
    }
    return linkage_pair_joined(pair.high, pair.low);
}

/* The exponent of a number above zero. */
static int exponent_of(float x)
{
    const int is_subnormal = x < FLT_MIN;
    uint32_t bits;
    x = is_subnormal ? x * 16777216.0f : x;
    (void)memcpy(&bits, &x, sizeof bits);
    return (int)(bits >> 23 & 0xffu) - (is_subnormal ? 127 + 24 : 127);
}

/* The exponent of the largest number in the scale: the products of numbers down to 2^-111 of it are then sums of two
 * words. */
#define LARGEST 60

/* x*2^shift for shifts of 250 at most, by two factors within the range. */
static LINKAGE_COLD float scaled(float x, int shift)
{
    const int half = shift / 2;
    return x * power_of_twof(half) * power_of_twof(shift - half);
}

/* Without its sign, and never zero but where it was. */
static float scaled_size(float x, int shift)
{
    const float size = fabsf(scaled(x, shift));
    return size == 0.0f && x != 0.0f ? 0x1p-149f : size;
}

/* The shift that brings the largest of some numbers between 2^60 and 2^61. */
static int scale_of(int *shift, const float *numbers, int count)
{
    float largest = 0x1p-149f;
    int i;
    for (i = 0; i < count; i++) { /* at most 4 times */
        if (!linkage_is_finitef(numbers[i])) {
            return 0;
        }
        largest = fabsf(numbers[i]) > largest ? fabsf(numbers[i]) : largest;
    }
    *shift = LARGEST - exponent_of(largest);
    return 1;
}

/* dx^2 + dy^2 - (a + b + w)^2 for a power of two w, or none. */
static LINKAGE_COLD void excess_with(float dx, float dy, float a, float b, float w, Sum *sum)
{
    const LinkagePair span = linkage_pair_sum(a, b);
    const LinkagePair x = linkage_pair_product(dx, dx), y = linkage_pair_product(dy, dy);
    const LinkagePair square = linkage_pair_product(-span.high, span.high);
    sum->count = 0;
    /* What cancels comes first, so that few parts are left. */
    add(sum, square.high);
    add(sum, x.high);
    add(sum, y.high);
    add(sum, -2.0f * span.high * w);
    add_product(sum, -2.0f * span.high, span.low);
    add(sum, square.low);
    add(sum, x.low);
    add(sum, y.low);
    add(sum, -w * w);
    add(sum, -2.0f * span.low * w);
    add_product(sum, -span.low, span.low);
    /* A square that is zero by underflow still decides where nothing else is left. */
    if ((x.high == 0.0f && dx != 0.0f) || (y.high == 0.0f && dy != 0.0f)) {
        add(sum, 0x1p-149f);
    }
}

/* The same in two words, or without rounding where less than this part of what it is made of is left: pairs are right to
 * some 2^-46 of that. */
static LinkagePair excess(float dx, float dy, float a, float b, float w, float part)
{
    const LinkagePair square = linkage_pair_plus(linkage_pair_product(dx, dx), linkage_pair_product(dy, dy));
    const LinkagePair length = linkage_pair_plus(linkage_pair_sum(a, b), linkage_pair(w, 0.0f));
    const LinkagePair span = linkage_pair_times(length, length);
    const LinkagePair found = linkage_pair_plus(square, linkage_pair_minus(span));
    Sum sum;
    if (fabsf(found.high) > part * (square.high + span.high)) {
        return found;
    }
    excess_with(dx, dy, a, b, w, &sum);
    return pair_of(&sum);
}

/* A number of its sign. */
static float sign_of_excess(float dx, float dy, float a, float b, float w) { return excess(dx, dy, a, b, w, 0x1p-40f).high; }

/* Its value, to some 2^-34 of itself. */
static LinkagePair value_of_excess(float dx, float dy, float a, float b) { return excess(dx, dy, a, b, 0.0f, 0x1p-12f); }

/* True if a vector's length is 2^61 or more as double precision has it: it rounds what is less by 2^-54 of the square
 * to the same. */
static int is_long(float dx, float dy) { return !(0.0f > sign_of_excess(dx, dy, 0x1p61f, -0x1p6f, 0.0f)); }

/* Some last places of the largest of scaled numbers, of which one is the length of a vector. */
static float slack_of(int shift, float dx, float dy)
{
    const int places = LARGEST + is_long(dx, dy) - 23, least = shift - 149;
    return ULPS * power_of_twof(places > least ? places : least);
}

/* Decisions. */

/* Two circles, scaled and without signs. */
typedef struct Circles {
    int shift;
    float dx, dy, l1, l2, longer, shorter;
    int is_point; /* true if the centres are one */
    int are_close; /* true if the square of their distance is next to nothing */
} Circles;

static int circles_of(Circles *c, float dx, float dy, float l1, float l2)
{
    const float given[4] = { dx, dy, l1, l2 };
    if (!scale_of(&c->shift, given, 4)) {
        return 0;
    }
    c->dx = scaled_size(dx, c->shift);
    c->dy = scaled_size(dy, c->shift);
    c->l1 = scaled_size(l1, c->shift);
    c->l2 = scaled_size(l2, c->shift);
    c->longer = c->l1 > c->l2 ? c->l1 : c->l2;
    c->shorter = c->l1 > c->l2 ? c->l2 : c->l1;
    c->is_point = dx == 0.0f && dy == 0.0f;
    c->are_close = 0x1p-40f > c->dx && 0x1p-40f > c->dy;
    return 1;
}

/* What is missing where a distance is not that of lengths in one line, the shorter with its sign. */
static float missing_of(const Circles *c, float shorter)
{
    const float length = sqrtf(c->dx * c->dx + c->dy * c->dy) + (c->longer + shorter);
    const float missing = fabsf(value_of_excess(c->dx, c->dy, c->longer, shorter).high) / length;
    const float number = scaled(missing, -c->shift);
    /* The largest number where it is out of range. */
    return number < FLT_MAX ? number : FLT_MAX;
}

/* Decides whether points are at least longer - shorter apart. */
static Reach too_close(const Circles *c, float *by)
{
    const int is_missed = 0.0f > sign_of_excess(c->dx, c->dy, c->longer, -c->shorter, 0.0f);
    if (is_missed) {
        const float slack = slack_of(c->shift, c->dx, c->dy);
        Sum gap;
        gap.count = 0;
        add(&gap, c->longer);
        add(&gap, -c->shorter);
        add(&gap, -slack);
        if (sign_of(&gap) > 0.0f && 0.0f > sign_of_excess(c->dx, c->dy, c->longer, -c->shorter, -slack)) {
            *by = missing_of(c, -c->shorter);
            return BEYOND;
        }
    }
    if (c->is_point) {
        return COINCIDENT;
    }
    return is_missed ? AT_LIMIT : MEETS;
}

/* Decides whether circles meet; `by` is what is missing. */
static Reach circles(const LinkageWhy *why, float dx, float dy, float l1, float l2, Circles *c, float *by)
{
    (void)why;
    if (!circles_of(c, dx, dy, l1, l2)) {
        return NO_NUMBER;
    }
    if (!(sign_of_excess(c->dx, c->dy, c->longer, c->shorter, 0.0f) > 0.0f)) {
        return too_close(c, by);
    }
    if (!(sign_of_excess(c->dx, c->dy, c->longer, c->shorter, slack_of(c->shift, c->dx, c->dy)) > 0.0f)) {
        return AT_LIMIT;
    }
    *by = missing_of(c, c->shorter);
    return BEYOND;
}

/* Decides whether |t| <= |l|. */
static Reach line(const LinkageWhy *why, float t, float l, float *by)
{
    const float given[2] = { t, l };
    Sum sum;
    int shift;
    (void)why;
    if (!scale_of(&shift, given, 2)) {
        return NO_NUMBER;
    }
    if (fabsf(t) <= fabsf(l)) {
        return MEETS;
    }
    sum.count = 0;
    add(&sum, -slack_of(shift, 0.0f, 0.0f));
    add(&sum, -scaled_size(l, shift));
    add(&sum, scaled_size(t, shift));
    if (!(sign_of(&sum) > 0.0f)) {
        return AT_LIMIT;
    }
    *by = fabsf(t) - fabsf(l);
    return BEYOND;
}

/* Decides whether a point is as far away as an offset. */
static Reach offset(const LinkageWhy *why, float bx, float by, float e, float *missing)
{
    Circles c;
    (void)why;
    if (!circles_of(&c, bx, by, e, 0.0f)) {
        return NO_NUMBER;
    }
    return too_close(&c, missing);
}

/* Values. */

/* A number as one between 1 and 2, or zero, and the exponent of two that it is of. */
static LinkagePair mantissa(LinkagePair x, int *exponent)
{
    *exponent = x.high == 0.0f ? 0 : exponent_of(fabsf(x.high));
    return linkage_pair(scaled(x.high, -*exponent), scaled(x.low, -*exponent));
}

/* The quotient of two numbers, which may be beyond the range, as a mantissa and an exponent. */
static LinkagePair share_of(LinkagePair a, LinkagePair b, int *exponent)
{
    int of_a, of_b;
    const LinkagePair above = mantissa(a, &of_a), below = mantissa(b, &of_b);
    *exponent = of_a - of_b;
    return linkage_pair_over(above, below);
}

/* x*2^k */
static float times_power(LinkagePair x, int k)
{
    const int least = k > -240 ? k : -240;
    return scaled(x.high, least < 240 ? least : 240);
}

/* The square of the distance of the centres: a number and an exponent. Where they are so close that their squares were
 * none, circles that meet have one radius. */
static LinkagePair square_of_distance(const Circles *c, int *exponent)
{
    const float up = c->are_close ? 0x1p100f : 1.0f, x = c->dx * up, y = c->dy * up;
    *exponent = c->are_close ? -200 : 0;
    return linkage_pair_plus(linkage_pair_product(x, x), linkage_pair_product(y, y));
}

/* The square of half the sine of the angle between the bars, a mantissa and an exponent. */
static LinkagePair height_product(const Circles *c, int *exponent)
{
    const LinkagePair four = linkage_pair_product(4.0f * c->longer, c->shorter);
    LinkagePair outer = linkage_pair_minus(value_of_excess(c->dx, c->dy, c->longer, c->shorter)), inner;
    int of_outer, of_inner, of_square = 0;
    inner = c->are_close ? square_of_distance(c, &of_square) : value_of_excess(c->dx, c->dy, c->longer, -c->shorter);
    outer = share_of(outer, four, &of_outer);
    inner = share_of(inner, four, &of_inner);
    *exponent = of_outer + of_inner + of_square;
    return linkage_pair_times(outer, inner);
}

/* The square of half the sine of the angle between the bars, in squares of a unit. */
static float height_in(const Circles *c, float unit)
{
    int of_product, of_unit;
    const LinkagePair product = height_product(c, &of_product);
    const LinkagePair size = mantissa(linkage_pair(unit, 0.0f), &of_unit);
    return times_power(linkage_pair_times(linkage_pair_times(product, size), size), of_product + 2 * of_unit);
}

/* The square of the height of a triangle over its side l. The answer says whether it can be told from zero where it is
 * none. */
static int square_of_height(const LinkageWhy *why, const Circles *c, float l, float r1, float r2, float *square)
{
    int of_product, of_share, of_first, exponent, limit, is_below;
    const LinkagePair product = height_product(c, &of_product);
    const LinkagePair share = share_of(linkage_pair(r2, 0.0f), linkage_pair(l, 0.0f), &of_share);
    const LinkagePair height = linkage_pair_times(mantissa(linkage_pair(r1, 0.0f), &of_first), share);
    const LinkagePair found = linkage_pair_times(linkage_pair_times(product, height), height);
    (void)why;
    exponent = of_product + 2 * (of_first + of_share + 1);
    *square = times_power(found, exponent);
    /* Below the smallest normal number, 2^-126, before it is rounded. */
    limit = -126 - exponent;
    is_below = limit > 30 || (limit >= -126 && linkage_pair_above(linkage_pair(power_of_twof(limit), 0.0f), found));
    return !(product.high > 0.0f && is_below);
}

/* True if 4*l1*l2 is a normal number, before it is rounded. */
static int is_product_normal(const LinkageWhy *why, float l1, float l2)
{
    const float x = l1 * 0x1p64f, y = l2 * 0x1p64f, product = x * y;
    (void)why;
    return product > 1.0f || (product == 1.0f && linkage_mul_errf(x, y) >= 0.0f);
}

/* Where the joint's foot stands on the line of centres, as a share of it; also of a joint on the line. */
static float foot(const Circles *c, int is_on_line)
{
    LinkagePair above, below;
    int exponent, of_square;
    float share;
    Sum sum;
    sum.count = 0;
    add_product(&sum, c->dx, c->dx);
    add_product(&sum, c->dy, c->dy);
    add_product(&sum, c->l1, c->l1);
    add_product(&sum, -c->l2, c->l2);
    below = square_of_distance(c, &of_square);
    above = is_on_line ? linkage_pair(c->l1, 0.0f) : pair_of(&sum);
    below = is_on_line ? linkage_pair_root(below) : below;
    above = share_of(above, below, &exponent);
    share = times_power(above, is_on_line ? exponent - of_square / 2 : exponent - 1);
    if (is_on_line) {
        return 0.0f > sign_of(&sum) ? -share : share;
    }
    return c->are_close ? 0.5f : share;
}

#endif /* LINKAGE_NO_DOUBLE */
/* Reach. */

static int is_certain(const LinkageWhy *why, LinkageWide value, LinkageWide spread)
{
    return is_finite(value) && is_above_rounding(why, value, spread);
}

/* The value with the exact number in its place, in the caller's width; NaN and infinity stay. */
static LinkageWide restored(const LinkageWhy *why, LinkageWide value, LinkageWide exact)
{
    return narrowed(why, value - value + exact);
}

static LinkageWide reached(LinkageWhy *why, LinkageWide value, Reach reach, LinkageWide by, const char *group)
{
    switch (reach) {
    case BEYOND:
        return refuse(why, LINKAGE_OUT_OF_REACH, group, NULL, by, value);
    case COINCIDENT:
        return refuse(why, LINKAGE_SINGULAR, group, NULL, 0, value);
    case AT_LIMIT:
        return 0;
    case MEETS:
        if (is_finite(value)) {
            return value > 0 ? value : 0;
        }
        break;
    case NO_NUMBER:
    default:
        break;
    }
    return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0, value);
}

LinkageWide linkage_reach_circles(LinkageWhy *why, LinkageWide value, LinkageWide dx, LinkageWide dy, LinkageWide l1, LinkageWide l2, LinkageWide unit, LinkageWide spread, const char *group)
{
    LinkageWide by = 0;
    Circles c;
    Reach reach;
    if (why->status != LINKAGE_OK || is_certain(why, value, spread)) {
        return value;
    }
    reach = circles(why, dx, dy, l1, l2, &c, &by);
    if ((reach == MEETS || reach == AT_LIMIT) && !is_product_normal(why, l1, l2)) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0, value);
    }
    if (reach == MEETS) {
        value = restored(why, value, height_in(&c, unit));
    }
    return reached(why, value, reach, by, group);
}

LinkageWide linkage_share_of_centres(LinkageWhy *why, LinkageWide value, LinkageWide height, LinkageWide dx, LinkageWide dy, LinkageWide l1, LinkageWide l2, LinkageWide spread, const char *group)
{
    LinkageWide by = 0;
    Circles c;
    (void)group;
    if (why->status != LINKAGE_OK || is_certain(why, height, spread)) {
        return value;
    }
    switch (circles(why, dx, dy, l1, l2, &c, &by)) {
    case MEETS:
        return restored(why, value, foot(&c, 0));
    case AT_LIMIT:
        return restored(why, value, foot(&c, 1));
    case BEYOND:
    case COINCIDENT:
    case NO_NUMBER:
    default:
        break;
    }
    return value;
}

LinkageWide linkage_reach_distances(LinkageWhy *why, LinkageWide value, LinkageWide l, LinkageWide r1, LinkageWide r2, LinkageWide spread, const char *group)
{
    LinkageWide by = 0;
    Circles c;
    Reach reach;
    if (why->status != LINKAGE_OK || is_certain(why, value, spread)) {
        return value;
    }
    reach = circles(why, l, 0, r1, r2, &c, &by);
    if (reach == MEETS) {
        LinkageWide square;
        if (!square_of_height(why, &c, l, r1, r2, &square)) {
            return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0, value);
        }
        value = restored(why, value, square);
    }
    return reached(why, value, reach, by, group);
}

LinkageWide linkage_square_of_centres(LinkageWhy *why, LinkageWide value, LinkageWide dx, LinkageWide dy, LinkageWide l1, LinkageWide l2, const char *group)
{
    LinkageWide by = 0;
    Circles c;
    Reach reach;
    /* Whether circles about centres that far apart meet is told by linkage_reach_circles. */
    if (why->status != LINKAGE_OK || (is_finite(value) && is_full_square(why, value))) {
        return value;
    }
    reach = circles(why, dx, dy, l1, l2, &c, &by);
    if (reach == BEYOND || reach == COINCIDENT) {
        return reached(why, value, reach, by, group);
    }
    return linkage_square(why, value, group);
}

LinkageWide linkage_reach_line(LinkageWhy *why, LinkageWide value, LinkageWide t, LinkageWide l, const char *group)
{
    LinkageWide by = 0;
    Reach reach;
    int is_lost;
    if (why->status != LINKAGE_OK) {
        return value;
    }
    reach = line(why, t, l, &by);
    is_lost = !is_full_square(why, l * l) && is_subnormal(why, value);
    if (reach == MEETS && size_of(t) < size_of(l) && is_lost) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0, value);
    }
    return reached(why, value, reach, by, group);
}

LinkageWide linkage_reach_offset(LinkageWhy *why, LinkageWide value, LinkageWide bx, LinkageWide by, LinkageWide e, const char *group)
{
    LinkageWide missing = 0;
    Reach reach;
    if (why->status != LINKAGE_OK) {
        return value;
    }
    reach = offset(why, bx, by, e, &missing);
    return reached(why, value, reach, missing, group);
}

/* An equation is closed to 64 roots of rounding of what its sides are made of. */
LinkageWide linkage_closed(LinkageWhy *why, LinkageWide difference, LinkageWide size, const char *unknown)
{
    const LinkageWide open_by = permitted(why, size);
    if (why->status != LINKAGE_OK || why->otherwise != NULL) {
        return difference;
    }
    if (why->goes_on) {
        /* Where no root was found, neither is the difference, but by a stand-in. */
        why->is_open |= why->stand_in != why->stand_in && difference == difference && !(size_of(difference) <= open_by);
        return difference;
    }
    if (!is_finite(difference)) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, unknown, 0, difference);
    }
    if (size_of(difference) <= open_by) {
        return difference;
    }
    return refuse(why, LINKAGE_NO_SOLUTION, NULL, unknown, size_of(difference), difference);
}

/* Lengths. */

#ifndef LINKAGE_NO_DOUBLE
double linkage_hypot(double x, double y)
{
    const double a = fabs(x), b = fabs(y);
    double longer = larger(a, b), shorter = a > b ? b : a, factor = 1.0;
    if (a > DBL_MAX || b > DBL_MAX) {
        return HUGE_VAL;
    }
    if (a != a || b != b || shorter == 0.0) {
        return a + b;
    }
    /* The shorter one, 2^65 times as short, does not show. */
    if (ilogb(longer) - ilogb(shorter) > 65) {
        return longer + shorter;
    }
    if (longer >= 0x1p511) {
        factor = 0x1p700;
    } else if (shorter < 0x1p-450) {
        factor = 0x1p-700;
    }
    longer /= factor;
    shorter /= factor;
    return factor * sqrt(linkage_mul_err(shorter, shorter) + linkage_mul_err(longer, longer) + shorter * shorter + longer * longer);
}
#endif /* LINKAGE_NO_DOUBLE */

#ifndef LINKAGE_NO_SINGLE
float linkage_hypotf(float x, float y)
{
    const float a = fabsf(x), b = fabsf(y);
    float longer = a > b ? a : b, shorter = a > b ? b : a, factor;
    if (a > FLT_MAX || b > FLT_MAX) {
        return HUGE_VALF;
    }
    if (a != a || b != b || shorter == 0.0f || ilogbf(longer) - ilogbf(shorter) > 25) {
        return a + b;
    }
    factor = power_of_twof(ilogbf(longer) > -126 ? ilogbf(longer) : -126);
    longer /= factor;
    shorter /= factor;
    return factor * sqrtf(sum_of_squares(longer, shorter));
}
#endif /* LINKAGE_NO_SINGLE */

/* Words and angles for callers. */

const char *linkage_status_text(LinkageStatus status)
{
    switch (status) {
    case LINKAGE_OK: return "there is an answer";
    case LINKAGE_OUT_OF_REACH: return "out of reach: the group cannot be assembled";
    case LINKAGE_SINGULAR: return "singular: what was asked for is undefined in this pose of the group";
    case LINKAGE_INVALID_LENGTH: return "invalid length: it is zero or negative";
    case LINKAGE_NOT_FINITE: return "not finite: an input, a parameter or a result";
    case LINKAGE_NULL_POINTER: return "null pointer";
    case LINKAGE_INVALID_MODE: return "invalid mode: the parameter is none of its modes";
    case LINKAGE_OFF_CIRCLE: return "off the circle: cosine and sine of no angle";
    case LINKAGE_NO_SOLUTION: return "no solution of the mode between the ends of the unknown";
    case LINKAGE_SEVERAL_DEAD_POINTS: return "several dead points between the ends of the unknown: narrow the interval";
    case LINKAGE_JAMS: return "jams: friction may hold itself at the joint";
    case LINKAGE_NOT_CERTIFIED: return "not certified: the group was not followed so far from the drawing";
    case LINKAGE_OTHER_ASSEMBLY: return "other assembly: the group has another side than for the other set of inputs";
    default: return "no status of linkage";
    }
}

#ifndef LINKAGE_NO_DOUBLE

/* The turns between two angles: to the nearest integer, ties to even. From 2^51 on the fraction's bits are beyond what
 * an angle can tell. */
static double turns_between(double angle, double previous)
{
    const double turns = (previous - angle) / 6.283185307179586;
    return fabs(turns) < 2251799813685248.0 ? (turns + 6755399441055744.0) - 6755399441055744.0 : turns;
}

double linkage_angle_near(double cosine, double sine, double previous)
{
    const double angle = linkage_atan2(sine, cosine);
    return angle + turns_between(angle, previous) * 6.283185307179586;
}

#ifndef LINKAGE_NO_SINGLE
float linkage_angle_near_f32(float cosine, float sine, float previous)
{
    const float angle = linkage_atan2f(sine, cosine);
    return angle + (float)(turns_between((double)angle, (double)previous) * 6.283185307179586);
}
#endif /* LINKAGE_NO_SINGLE */

#else

/* A difference less the turns in it, which a sum with a large number rounds. */
static LinkagePair turned_back(LinkagePair difference, float large)
{
    const float turns = (difference.high * 0.159154937f + large) - large;
    const LinkagePair more = linkage_pair_plus(difference, linkage_pair_product(-turns, 6.28318548f));
    return linkage_pair_plus(more, linkage_pair_product(turns, 1.74845553e-07f));
}

float linkage_angle_near_f32(float cosine, float sine, float previous)
{
    const float angle = linkage_atan2f(sine, cosine);
    const LinkagePair turn = { 6.28318548f, -1.74845553e-07f }, half = { 3.14159274f, -8.74227766e-08f };
    const LinkagePair difference = linkage_pair_sum(previous, -angle);
    LinkagePair rest;
    /* Beyond this a turn is less than half a last place. */
    if (!(fabsf(previous) < 536870912.0f)) {
        return angle + previous;
    }
    /* By 16 turns, and then by one. */
    rest = turned_back(turned_back(difference, 201326592.0f), 12582912.0f);
    if (linkage_pair_above(rest, half)) {
        rest = linkage_pair_plus(rest, linkage_pair_minus(turn));
    } else if (linkage_pair_above(linkage_pair_minus(half), rest)) {
        rest = linkage_pair_plus(rest, turn);
    }
    return angle + linkage_pair_plus(difference, linkage_pair_minus(rest)).high;
}

#endif /* LINKAGE_NO_DOUBLE */
/* Angles beyond the kernels' range. */

#ifndef LINKAGE_NO_DOUBLE

/* 2/pi in words of 32 bits, behind 64 zeros. */
static const uint32_t digits_of_quadrants[39] = {
    0x00000000u, 0x00000000u, 0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u,
    0xfe5163abu, 0xdebbc561u, 0xb7246e3au, 0x424dd2e0u, 0x06492eeau, 0x09d1921cu, 0xfe1deb1cu, 0xb129a73eu,
    0xe88235f5u, 0x2ebb4484u, 0xe99c7026u, 0xb45f7e41u, 0x3991d639u, 0x835339f4u, 0x9c845f8bu, 0xbdf9283bu,
    0x1ff897ffu, 0xde05980fu, 0xef2f118bu, 0x5a0a6d1fu, 0x6d367ecfu, 0x27cb09b7u, 0x4f463f66u, 0x9e5fea2du,
    0x7527bac7u, 0xebe5f17bu, 0x3d0739f7u, 0x8a5292eau, 0x6bfb5fb1u, 0x1f8d5d08u, 0x56033046u
};

/* The last 192 bits of the product of an integer and of six words of the digits, the last ones first. */
static void multiplied(uint64_t mantissa, int start, uint32_t *product)
{
    const int word = start / 32, shift = start % 32;
    int place, i;
    (void)memset(product, 0, 6 * sizeof *product);
    for (place = 0; place < 2; place++) { /* at most 2 times */
        const uint64_t factor = place == 0 ? mantissa & 0xffffffffu : mantissa >> 32;
        uint64_t carry = 0;
        for (i = 0; i + place < 6; i++) { /* at most 6 times */
            const uint32_t *pair = &digits_of_quadrants[word + 5 - i];
            const uint32_t digit = (uint32_t)(((uint64_t)pair[0] << 32 | pair[1]) >> (32 - shift));
            const uint64_t sum = factor * digit + product[i + place] + carry;
            product[i + place] = (uint32_t)sum;
            carry = sum >> 32;
        }
    }
}

/* The number of quarter turns of a finite angle of 2^15 or more, its last bits, and the rest in quarter turns in two
 * words: M. H. Payne and R. N. Hanek, SIGNUM Newsletter 18 (1983). Digits of 2/pi that make whole turns are left
 * out, and 190 binary places behind them are computed, of which 128 are kept. */
static int quarters_of(double x, double rest[2])
{
    uint64_t bits, mantissa, first, second, flip;
    uint32_t p[6];
    double high, middle, sum;
    int count, is_above_half;
    (void)memcpy(&bits, &x, sizeof bits);
    mantissa = (bits & (((uint64_t)1 << 52) - 1u)) | (uint64_t)1 << 52;
    multiplied(mantissa, (int)(bits >> 52 & 0x7ffu) - 1013, p);
    first = (uint64_t)p[5] << 34 | (uint64_t)p[4] << 2 | p[3] >> 30;
    second = (uint64_t)p[3] << 34 | (uint64_t)p[2] << 2 | p[1] >> 30;
    is_above_half = (int)(first >> 63);
    count = (int)(p[5] >> 30) + is_above_half;
    flip = is_above_half ? ~(uint64_t)0 : 0;
    first ^= flip;
    second ^= flip;
    high = (double)(first >> 32) * 0x1p-32;
    middle = (double)((first & 0xffffffffu) << 20 | second >> 44) * 0x1p-84;
    sum = high + middle;
    rest[0] = sum;
    rest[1] = ((high - sum) + middle) + (double)(second & (((uint64_t)1 << 44) - 1u)) * 0x1p-128;
    if (is_above_half != (x < 0.0)) {
        rest[0] = -rest[0];
        rest[1] = -rest[1];
    }
    return x < 0.0 ? -count : count;
}

LINKAGE_COLD void linkage_sin_cos_far(double x, double *to_sin, double *to_cos)
{
    double rest[2], product, error, r;
    int count;
    if (!linkage_is_finite(x)) {
        *to_sin = x - x;
        *to_cos = *to_sin;
        return;
    }
    count = quarters_of(x, rest);
    product = rest[0] * 1.5707963267948966;
    error = linkage_mul_err(rest[0], 1.5707963267948966) + (rest[0] * 6.123233995736766e-17 + rest[1] * 1.5707963267948966);
    r = product + error;
    linkage_sin_cos_of(r, (r - product) - error, 6755399441055744.0 + count, to_sin, to_cos);
}

#ifndef LINKAGE_NO_SINGLE
/* The remainder of an angle in single precision, in rad and in two words, and its count of quarter turns. */
static int remainder_of(float x, float *r, float *excess)
{
    double rest[2], wide;
    const int count = quarters_of((double)x, rest);
    wide = (rest[0] + rest[1]) * 1.5707963267948966;
    *r = (float)wide;
    *excess = (float)((double)*r - wide);
    return count;
}
#endif /* LINKAGE_NO_SINGLE */

#else

/* 2/pi in words of 32 bits, behind 32 zeros. */
static const uint32_t digits_of_quadrants[9] = {
    0x00000000u, 0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u, 0xfe5163abu, 0xdebbc561u
};

/* The same by three words of the product of 24 bits of the angle and 128 of 2/pi, without those that make whole
 * turns. */
static int remainder_of(float x, float *r, float *excess)
{
    uint32_t bits, mantissa, product[4], first, second, third, carry = 0u, flip;
    LinkagePair rest;
    Sum sum;
    int start, i, count, is_above_half;
    (void)memcpy(&bits, &x, sizeof bits);
    mantissa = (bits & 0x7fffffu) | 0x800000u;
    start = (int)(bits >> 23 & 0xffu) - (127 + 23 - 30);
    for (i = 3; i >= 0; i--) { /* at most 4 times */
        const uint32_t *pair = &digits_of_quadrants[start / 32 + i];
        const uint32_t digit = (uint32_t)(((uint64_t)pair[0] << 32 | pair[1]) >> (32 - start % 32));
        const uint64_t place = (uint64_t)mantissa * digit + carry;
        product[i] = (uint32_t)place;
        carry = (uint32_t)(place >> 32);
    }
    first = product[0] << 2 | product[1] >> 30;
    second = product[1] << 2 | product[2] >> 30;
    third = product[2] << 2 | product[3] >> 30;
    is_above_half = (int)(first >> 31);
    count = (int)(product[0] >> 30) + is_above_half;
    flip = is_above_half ? 0xffffffffu : 0u;
    first ^= flip;
    second ^= flip;
    third ^= flip;
    /* Words of 24 bits are exact. */
    sum.count = 0;
    add(&sum, (float)(third & 0xffffffu) * 0x1p-96f);
    add(&sum, (float)((second & 0xffffu) << 8 | third >> 24) * 0x1p-72f);
    add(&sum, (float)((first & 0xffu) << 16 | second >> 16) * 0x1p-48f);
    add(&sum, (float)(first >> 8) * 0x1p-24f);
    rest = pair_of(&sum);
    rest = linkage_pair_times(rest, linkage_pair(1.57079637f, -4.37113883e-08f));
    if (is_above_half != (x < 0.0f)) {
        rest = linkage_pair_minus(rest);
    }
    *r = rest.high;
    *excess = -rest.low;
    return x < 0.0f ? -count : count;
}

#endif /* LINKAGE_NO_DOUBLE */

#ifndef LINKAGE_NO_SINGLE
LINKAGE_COLD void linkage_reducef(float x, float *r, float *excess, float *shifted)
{
    *r = x - x;
    *excess = 0.0f;
    *shifted = 12582912.0f;
    if (linkage_is_finitef(x)) {
        *shifted += (float)remainder_of(x, r, excess);
    }
}
#endif /* LINKAGE_NO_SINGLE */
