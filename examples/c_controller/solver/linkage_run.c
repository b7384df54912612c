/* linkage_run.c: what solvers that linkage has printed do where an answer is near a limit or none: decisions
 * without rounding, and reasons. linkage_run.h says whose text this is. */
#include "linkage_run.h"

#if LINKAGE_RUN_TIME != 0xfce33addu
#error "linkage_run.h was printed by another version than this file: print both anew, or one supplier's with a prefix"
#endif

/* The error of a value in units of its spread's last place: larger values are positive for certain. */
#define ROUNDINGS 16.0

/* The distance by which a pose may miss assembly, in last places of the longest length. */
#define ULPS 4.0

/* Above this a sum of two words has the sign of the exact one and, but for half a unit, its last place. */
#define TWO_WORDS (1.0 / 1099511627776.0)

/* Answers. */

LinkageWhy linkage_why(int is_single)
{
    LinkageWhy why = { LINKAGE_OK, 0, 0.0, NULL, NULL, NULL, 0, 0.0, 0 };
    why.is_single = is_single;
    return why;
}

LinkageWhy linkage_why_behind(int is_single, double stand_in)
{
    LinkageWhy why = linkage_why(is_single);
    why.goes_on = 1;
    why.stand_in = stand_in;
    return why;
}

LinkageStatus linkage_refused(const LinkageWhy *why, LinkageError *error)
{
    if (error != NULL) {
        error->status = why->status;
        error->by = why->by;
        error->group = why->group;
        error->group_length = (why->group == NULL) ? 0u : strlen(why->group);
        error->name = why->name;
        error->name_length = (why->name == NULL) ? 0u : strlen(why->name);
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
LinkageStatus linkage_not_on_circle(LinkageError *error, double cosine, double sine, const char *name)
{
    if (!linkage_is_finite(cosine)) {
        return linkage_because(error, LINKAGE_NOT_FINITE, "cos");
    }
    if (!linkage_is_finite(sine)) {
        return linkage_because(error, LINKAGE_NOT_FINITE, "sin");
    }
    return linkage_because(error, LINKAGE_OFF_CIRCLE, name);
}

static double refuse(LinkageWhy *why, LinkageStatus status, const char *group, const char *name, double by, double value)
{
    if (why->goes_on) {
        return status == LINKAGE_OUT_OF_REACH ? why->stand_in : (double)NAN;
    }
    why->status = status;
    why->group = group;
    why->name = name;
    why->by = by;
    return value;
}

/* A number of the caller's width. */
static double narrowed(const LinkageWhy *why, double value)
{
    return why->is_single ? (double)(float)value : value;
}

static double epsilon(const LinkageWhy *why) { return why->is_single ? (double)FLT_EPSILON : DBL_EPSILON; }

static double smallest_normal(const LinkageWhy *why) { return why->is_single ? (double)FLT_MIN : DBL_MIN; }

static double smallest_square(const LinkageWhy *why)
{
    return why->is_single ? (double)linkage_smallest_squaref() : linkage_smallest_square();
}

void linkage_given_finite(LinkageWhy *why, const LinkageNamed *given, int count)
{
    int i;
    for (i = 0; i < count; i++) {
        if (!linkage_is_finite(given[i].value)) {
            (void)refuse(why, LINKAGE_NOT_FINITE, NULL, given[i].name, 0.0, 0.0);
            return;
        }
    }
}

/* To blame for a result that is none is the largest given number whose fourth power leaves the number's range,
 * as a rate that is squared on the way does; where there is none, the result itself. */
static void blame(LinkageWhy *why, const char *result, const LinkageNamed *given, int count)
{
    double largest = 0.0;
    int i;
    for (i = 0; i < count; i++) {
        const double size = fabs(given[i].value);
        const double square = narrowed(why, given[i].value * given[i].value);
        const double fourth = narrowed(why, square * square);
        if (!linkage_is_finite(fourth) && size > largest) {
            largest = size;
            result = given[i].name;
        }
    }
    (void)refuse(why, LINKAGE_NOT_FINITE, NULL, result, 0.0, 0.0);
}

void linkage_results_finite(LinkageWhy *why, const LinkageNamed *results, int count, const LinkageNamed *given, int given_count)
{
    int i;
    if (why->status == LINKAGE_OK && why->otherwise != NULL) {
        (void)refuse(why, LINKAGE_NOT_FINITE, NULL, why->otherwise, 0.0, 0.0);
    }
    for (i = 0; i < count && why->status == LINKAGE_OK; i++) {
        if (!linkage_is_finite(results[i].value)) {
            blame(why, results[i].name, given, given_count);
        }
    }
}

int linkage_lacks_a_pose(const LinkageWhy *why)
{
    return why->status == LINKAGE_OUT_OF_REACH || why->status == LINKAGE_NO_SOLUTION;
}

int linkage_is_told(const double *told, const double *others, int count)
{
    int i, known = 0;
    for (i = 0; i < count; i++) {
        if (linkage_is_finite(told[i])) {
            known++;
        } else if (told[i] == told[i] || !linkage_is_finite(others[i])) {
            return 0;
        }
    }
    return known > 0;
}

/* Sizes. */

double linkage_nonzero(LinkageWhy *why, double value, const char *group)
{
    if (why->status != LINKAGE_OK) {
        return value;
    }
    if (value != value) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0.0, value);
    }
    return value == 0.0 ? refuse(why, LINKAGE_SINGULAR, group, NULL, 0.0, value) : value;
}

static double valid(LinkageWhy *why, double value, int is_valid, const char *group, const char *name)
{
    if (why->status != LINKAGE_OK) {
        return value;
    }
    if (value != value) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, name, 0.0, value);
    }
    return is_valid ? value : refuse(why, LINKAGE_INVALID_LENGTH, group, name, 0.0, value);
}

double linkage_positive(LinkageWhy *why, double value, const char *group, const char *name)
{
    return valid(why, value, value > 0.0, group, name);
}

double linkage_not_negative(LinkageWhy *why, double value, const char *group, const char *name)
{
    return valid(why, value, value >= 0.0, group, name);
}

double linkage_square(LinkageWhy *why, double value, const char *group)
{
    if (why->status != LINKAGE_OK) {
        return value;
    }
    if (value == 0.0) {
        return refuse(why, LINKAGE_SINGULAR, group, NULL, 0.0, value);
    }
    if (linkage_is_finite(value) && value >= smallest_square(why)) {
        return value;
    }
    return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0.0, value);
}

double linkage_moving(LinkageWhy *why, double value, double spread, const char *name)
{
    if (why->status != LINKAGE_OK) {
        return value;
    }
    if (value != value) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, name, 0.0, value);
    }
    if (value > ROUNDINGS * epsilon(why) * spread) {
        return value;
    }
    return refuse(why, LINKAGE_SINGULAR, name, NULL, 0.0, value);
}

/* Numbers without rounding. */

/* The sum of at most 16 terms, rounded at the very end: J. R. Shewchuk, Discrete & Computational Geometry 18
 * (1997), grow-expansion. */
static double exact_sum(const double *terms, int count)
{
    double parts[16], sum = 0.0;
    int i, k;
    for (i = 0; i < count; i++) {
        double carry = terms[i];
        for (k = 0; k < i; k++) {
            const double next = carry + parts[k];
            parts[k] = linkage_add_err(carry, parts[k]);
            carry = next;
        }
        parts[i] = carry;
    }
    for (i = 0; i < count; i++) {
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
    memcpy(&power, &bits, sizeof power);
    return power;
}

static int scale_of(Scale *scale, const double *numbers, int count)
{
    double largest = 0.0;
    uint64_t bits;
    int i, exponent;
    for (i = 0; i < count; i++) {
        if (!linkage_is_finite(numbers[i])) {
            return 0;
        }
        largest = fabs(numbers[i]) > largest ? fabs(numbers[i]) : largest;
    }
    memcpy(&bits, &largest, sizeof bits);
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
    memcpy(&bits, &x, sizeof bits);
    bits &= (uint64_t)0x7ff << 52;
    memcpy(&ulp, &bits, sizeof ulp);
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
    for (i = 0; i < 8; i++) {
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

typedef enum Reach { MEETS, AT_LIMIT, BEYOND, COINCIDENT, NO_NUMBER } Reach;

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
static Reach circles(const LinkageWhy *why, double dx, double dy, double l1, double l2, double *by)
{
    Circles c;
    double d, slack, span, missing;
    int is_clear;
    if (!circles_of(&c, dx, dy, l1, l2)) {
        return NO_NUMBER;
    }
    d = distance(c.dx, c.dy);
    slack = slack_of(why, &c.scale, larger(d, c.longer));
    span = c.longer + c.shorter;
    missing = excess(c.dx, c.dy, c.longer, c.shorter);
    if (missing <= 0.0) {
        return too_close(c.dx, c.dy, c.longer, c.shorter, slack, &c.scale, by);
    }
    is_clear = missing > 2.0 * (slack * (2.0 * span + slack));
    if (!is_clear && excess_with(c.dx, c.dy, c.longer, c.shorter, slack) <= 0.0) {
        return AT_LIMIT;
    }
    *by = scaled_up(&c.scale, missing / (d + span));
    return BEYOND;
}

/* The square of half the sine of the angle between the bars. */
static double height_product(double dx, double dy, double l1, double l2)
{
    Circles c;
    double outer, inner, four;
    if (!circles_of(&c, dx, dy, l1, l2)) {
        return dx - dx;
    }
    outer = -excess(c.dx, c.dy, c.longer, c.shorter);
    inner = excess(c.dx, c.dy, c.longer, -c.shorter);
    four = 4.0 * c.longer * c.shorter;
    return (outer / four) * (inner / four);
}

/* Where the joint's foot stands on the line of centres, as a share of it. */
static double foot(double dx, double dy, double l1, double l2)
{
    Circles c;
    double terms[8];
    int i;
    if (!circles_of(&c, dx, dy, l1, l2)) {
        return dx - dx;
    }
    {
        const double x[4] = { c.dx, c.dy, c.l1, -c.l2 }, y[4] = { c.dx, c.dy, c.l1, c.l2 };
        for (i = 0; i < 4; i++) {
            terms[2 * i] = x[i] * y[i];
            terms[2 * i + 1] = linkage_mul_err(x[i], y[i]);
        }
    }
    return exact_sum(terms, 8) / (2.0 * (c.dx * c.dx + c.dy * c.dy));
}

/* The same of a joint on the line. */
static double foot_on_line(double dx, double dy, double l1, double l2)
{
    Circles c;
    double share;
    if (!circles_of(&c, dx, dy, l1, l2)) {
        return dx - dx;
    }
    share = c.l1 / distance(c.dx, c.dy);
    return foot(dx, dy, l1, l2) < 0.0 ? -share : share;
}

/* Reach. */

static int is_certain(const LinkageWhy *why, double value, double spread)
{
    return linkage_is_finite(value) && value > ROUNDINGS * epsilon(why) * spread;
}

/* The value with the exact number in its place, in the caller's width; NaN and infinity stay. */
static double restored(const LinkageWhy *why, double value, double exact)
{
    return narrowed(why, value - value + exact);
}

static double reached(LinkageWhy *why, double value, Reach reach, double by, const char *group)
{
    switch (reach) {
    case BEYOND:
        return refuse(why, LINKAGE_OUT_OF_REACH, group, NULL, by, value);
    case COINCIDENT:
        return refuse(why, LINKAGE_SINGULAR, group, NULL, 0.0, value);
    case AT_LIMIT:
        return 0.0;
    case MEETS:
        if (linkage_is_finite(value)) {
            return value > 0.0 ? value : 0.0;
        }
        break;
    case NO_NUMBER:
        break;
    }
    return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0.0, value);
}

double linkage_reach_circles(LinkageWhy *why, double value, double dx, double dy, double l1, double l2, double unit, double spread, const char *group)
{
    double by = 0.0;
    Reach reach;
    if (why->status != LINKAGE_OK || is_certain(why, value, spread)) {
        return value;
    }
    reach = circles(why, dx, dy, l1, l2, &by);
    if ((reach == MEETS || reach == AT_LIMIT) && !(4.0 * l1 * l2 >= smallest_normal(why))) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0.0, value);
    }
    if (reach == MEETS) {
        value = restored(why, value, height_product(dx, dy, l1, l2) * unit * unit);
    }
    return reached(why, value, reach, by, group);
}

double linkage_share_of_centres(LinkageWhy *why, double value, double height, double dx, double dy, double l1, double l2, double spread, const char *group)
{
    double by = 0.0;
    (void)group;
    if (why->status != LINKAGE_OK || is_certain(why, height, spread)) {
        return value;
    }
    switch (circles(why, dx, dy, l1, l2, &by)) {
    case MEETS:
        return restored(why, value, foot(dx, dy, l1, l2));
    case AT_LIMIT:
        return restored(why, value, foot_on_line(dx, dy, l1, l2));
    case BEYOND:
    case COINCIDENT:
    case NO_NUMBER:
        break;
    }
    return value;
}

double linkage_reach_distances(LinkageWhy *why, double value, double l, double r1, double r2, double spread, const char *group)
{
    double by = 0.0;
    Reach reach;
    if (why->status != LINKAGE_OK || is_certain(why, value, spread)) {
        return value;
    }
    reach = circles(why, l, 0.0, r1, r2, &by);
    if (reach == MEETS) {
        const double height = 2.0 * r1 * (r2 / l), product = height_product(l, 0.0, r1, r2);
        const double square = product * height * height;
        if (product > 0.0 && square < smallest_normal(why)) {
            return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0.0, value);
        }
        value = restored(why, value, square);
    }
    return reached(why, value, reach, by, group);
}

double linkage_square_of_centres(LinkageWhy *why, double value, double dx, double dy, double l1, double l2, const char *group)
{
    double by = 0.0;
    Reach reach;
    if (why->status != LINKAGE_OK) {
        return value;
    }
    reach = circles(why, dx, dy, l1, l2, &by);
    if (reach == BEYOND || reach == COINCIDENT) {
        return reached(why, value, reach, by, group);
    }
    return linkage_square(why, value, group);
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

double linkage_reach_line(LinkageWhy *why, double value, double t, double l, const char *group)
{
    double by = 0.0;
    Reach reach;
    int is_lost;
    if (why->status != LINKAGE_OK) {
        return value;
    }
    reach = line(why, t, l, &by);
    is_lost = !(l * l >= smallest_square(why)) && value < smallest_normal(why);
    if (reach == MEETS && fabs(t) < fabs(l) && is_lost) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, group, 0.0, value);
    }
    return reached(why, value, reach, by, group);
}

double linkage_reach_offset(LinkageWhy *why, double value, double bx, double by, double e, const char *group)
{
    const double given[3] = { bx, by, e };
    double missing = 0.0;
    Scale scale;
    Reach reach = NO_NUMBER;
    if (why->status != LINKAGE_OK) {
        return value;
    }
    if (scale_of(&scale, given, 3)) {
        const double x = fabs(bx * scale.down), y = fabs(by * scale.down), gap = fabs(e * scale.down);
        const double slack = slack_of(why, &scale, larger(distance(x, y), gap));
        reach = too_close(x, y, gap, 0.0, slack, &scale, &missing);
    }
    return reached(why, value, reach, missing, group);
}

/* An equation is closed to 64 roots of rounding of what its sides are made of. */
double linkage_closed(LinkageWhy *why, double difference, double size, const char *unknown)
{
    const double open_by = why->is_single ? (double)(0.022097087f * (float)size) : 9.5367431640625e-7 * size;
    if (why->status != LINKAGE_OK || why->otherwise != NULL) {
        return difference;
    }
    if (why->goes_on) {
        /* Where no root was found, neither is the difference, but by a stand-in. */
        why->is_open |= why->stand_in != why->stand_in && difference == difference && !(fabs(difference) <= open_by);
        return difference;
    }
    if (!linkage_is_finite(difference)) {
        return refuse(why, LINKAGE_NOT_FINITE, NULL, unknown, 0.0, difference);
    }
    if (fabs(difference) <= open_by) {
        return difference;
    }
    return refuse(why, LINKAGE_NO_SOLUTION, NULL, unknown, fabs(difference), difference);
}

/* Lengths. */

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

#ifndef LINKAGE_NO_SINGLE
float linkage_hypotf(float x, float y)
{
    const float a = fabsf(x), b = fabsf(y);
    float longer = a > b ? a : b, shorter = a > b ? b : a, factor = 1.0f;
    if (a > FLT_MAX || b > FLT_MAX) {
        return HUGE_VALF;
    }
    if (a != a || b != b || shorter == 0.0f || ilogbf(longer) - ilogbf(shorter) > 25) {
        return a + b;
    }
    if (longer >= 0x1p60f) {
        factor = 0x1p90f;
    } else if (shorter < 0x1p-60f) {
        factor = 0x1p-90f;
    }
    longer /= factor;
    shorter /= factor;
    return factor * sqrtf((float)((double)longer * (double)longer + (double)shorter * (double)shorter));
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
    case LINKAGE_OTHER_ASSEMBLY: return "other assembly: the group has another side than for the other set of inputs";
    default: return "no status of linkage";
    }
}

/* The turns between two angles: to the nearest integer, ties to even. From 2^51 on the fraction's bits are beyond what
 * an angle can tell. */
static double turns_between(double angle, double previous)
{
    const double turns = (previous - angle) / 6.283185307179586;
    return fabs(turns) < 2251799813685248.0 ? (turns + 6755399441055744.0) - 6755399441055744.0 : turns;
}

#ifndef LINKAGE_NO_DOUBLE
double linkage_angle_near(double cosine, double sine, double previous)
{
    const double angle = linkage_atan2(sine, cosine);
    return angle + turns_between(angle, previous) * 6.283185307179586;
}
#endif /* LINKAGE_NO_DOUBLE */

#ifndef LINKAGE_NO_SINGLE
float linkage_angle_near_f32(float cosine, float sine, float previous)
{
    const float angle = linkage_atan2f(sine, cosine);
    return angle + (float)(turns_between((double)angle, (double)previous) * 6.283185307179586);
}
#endif /* LINKAGE_NO_SINGLE */
/* Angles beyond the kernels' range. */

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
    memset(product, 0, 6 * sizeof *product);
    for (place = 0; place < 2; place++) {
        const uint64_t factor = place == 0 ? mantissa & 0xffffffffu : mantissa >> 32;
        uint64_t carry = 0;
        for (i = 0; i + place < 6; i++) {
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
    memcpy(&bits, &x, sizeof bits);
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

#ifndef LINKAGE_NO_DOUBLE
LINKAGE_COLD void linkage_sin_cos_far(double x, double *to_sin, double *to_cos)
{
    double rest[2], product, error, r;
    int count;
    if (!linkage_is_finite(x)) {
        *to_sin = *to_cos = x - x;
        return;
    }
    count = quarters_of(x, rest);
    product = rest[0] * 1.5707963267948966;
    error = linkage_mul_err(rest[0], 1.5707963267948966) + (rest[0] * 6.123233995736766e-17 + rest[1] * 1.5707963267948966);
    r = product + error;
    linkage_sin_cos_of(r, (r - product) - error, 6755399441055744.0 + count, to_sin, to_cos);
}
#endif /* LINKAGE_NO_DOUBLE */

#ifndef LINKAGE_NO_SINGLE
LINKAGE_COLD void linkage_sin_cos_farf(float x, float *to_sin, float *to_cos)
{
    double rest[2], wide;
    float r;
    int count;
    if (!linkage_is_finitef(x)) {
        *to_sin = *to_cos = x - x;
        return;
    }
    count = quarters_of((double)x, rest);
    wide = (rest[0] + rest[1]) * 1.5707963267948966;
    r = (float)wide;
    linkage_sin_cos_off(r, (float)((double)r - wide), 12582912.0f + (float)count, to_sin, to_cos);
}
#endif /* LINKAGE_NO_SINGLE */
