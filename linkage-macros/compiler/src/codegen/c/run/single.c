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
