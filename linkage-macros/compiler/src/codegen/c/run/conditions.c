/* linkage_run.c: what solvers that linkage has printed do where an answer is near a limit or none: decisions
 * without rounding, and reasons. linkage_run.h says whose text this is. */
#include "linkage_run.h"

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

