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

