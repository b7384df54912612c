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
