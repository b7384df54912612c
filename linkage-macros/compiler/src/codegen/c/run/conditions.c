
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
