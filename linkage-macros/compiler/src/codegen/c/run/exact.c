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

