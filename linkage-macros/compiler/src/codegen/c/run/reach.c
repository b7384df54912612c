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
