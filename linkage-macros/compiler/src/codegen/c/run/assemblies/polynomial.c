
/* The equation of one mode at an angle of the unknown, whose dyads are on the left where their bits are set; NaN where a dyad
 * does not assemble. */
static double missed(const Placed *placed, double angle, uint32_t sides)
{
    Closing_complex closing;
    double off;
    int at;
    begin_complex(&closing, placed, turned(angle));
    for (at = 0; at < placed->kind->count; at++) {
        const Triangle_complex triangle = triangle_complex(&closing, placed->kind->dyads[at]);
        assemble_complex(&closing, placed->kind->dyads[at], &triangle, (int)((sides >> at) & 1u));
    }
    off = missed_complex(&closing).x;
    return closing.assembles && linkage_is_finite(off) ? off : (double)NAN;
}

/* The product of the closures of all modes, with the powers of the dyads' bases. A dyad is placed once for all sides of
 * those behind it: the last one changes its side first. */
static Disc product(const Placed *placed, Disc turn)
{
    const LinkagePinned *kind = placed->kind;
    Closing_disc closing;
    Triangle_disc triangles[4];
    Disc all = disc_of(1.0, 0.0, 0.0);
    uint32_t mode;
    begin_disc(&closing, placed, turn);
    for (mode = 0; mode < 1u << kind->count; mode++) {
        int at;
        for (at = 0; at < kind->count; at++) {
            const uint32_t bit = 1u << (kind->count - 1 - at);
            if ((mode & (bit - 1u)) != 0u) {
                continue;
            }
            if ((mode & bit) == 0u) {
                int power;
                triangles[at] = triangle_disc(&closing, kind->dyads[at]);
                for (power = 0; power < kind->powers[at]; power++) {
                    all = times_disc(all, triangles[at].base);
                }
            }
            assemble_disc(&closing, kind->dyads[at], &triangles[at], (mode & bit) != 0u);
        }
        all = times_disc(all, missed_disc(&closing));
    }
    return all;
}

/* The most coefficients of a polynomial. */
#define COEFFICIENTS 61

/* Chebyshev's nodes for so many coefficients: the cosines of the multiples of pi/2 by the count. */
typedef struct Nodes {
    int count;
    double cosines[4 * COEFFICIENTS];
} Nodes;

/* A polynomial over -1 to 1 as a sum of Chebyshev's: a bound on what the sum of these terms is off by, and the sum of the
 * coefficients' magnitudes. */
typedef struct Polynomial {
    int count;
    double terms[COEFFICIENTS];
    double off;
    double size;
} Polynomial;

/* The zeros of a polynomial as far as its coefficients tell. */
typedef enum Told { NO_ZERO, ONE_ZERO, UNTOLD } Told;

static void make_nodes(int count, Nodes *nodes)
{
    int at;
    nodes->count = count;
    for (at = 0; at < 4 * count; at++) {
        nodes->cosines[at] = cos(PI * (double)at / (double)(2 * count));
    }
}

/* The polynomial with these values in the nodes, each off by a radius at most. Errors in the nodes grow by Lebesgue's
 * constant at most, 1 + (2/pi) ln n: under 4 for 61 nodes. A cosine is off by ten units, and a sum of n products by n half
 * units. */
static void interpolate(const Nodes *nodes, const double *values, double radius, Polynomial *to)
{
    const int count = nodes->count;
    double all = 0.0;
    int row, node;
    to->count = count;
    to->size = 0.0;
    for (row = 0; row < count; row++) {
        double sum = 0.0;
        for (node = 0; node < count; node++) {
            sum += values[node] * nodes->cosines[row * (2 * node + 1) % (4 * count)];
        }
        to->terms[row] = sum * (row == 0 ? 1.0 : 2.0) / (double)count;
        to->size += fabs(to->terms[row]);
        all += fabs(values[row]);
    }
    to->off = 4.0 * radius + (double)(count + 24) * DBL_EPSILON * all;
}

/* Clenshaw's sum. It is off by `rounding_of_values` at most. */
static double value_at(const Polynomial *of, double x)
{
    double first = 0.0, second = 0.0;
    int at;
    for (at = of->count - 1; at > 0; at--) {
        const double next = of->terms[at] + 2.0 * x * first - second;
        second = first;
        first = next;
    }
    return of->terms[0] + x * first - second;
}

static double rounding_of_values(const Polynomial *of)
{
    return (double)(2 * of->count * of->count) * DBL_EPSILON * of->size;
}

/* A lower bound of the slope's magnitude; zero or less where it may change its sign. By Markov's inequality the slope of what
 * is left out is n^2 times that at most, of degree n. */
static double least_slope_of(const Polynomial *of)
{
    double slope[COEFFICIENTS + 1] = { 0.0 }, terms = 0.0, others = 0.0;
    int at;
    for (at = of->count - 1; at > 0; at--) {
        const double term = 2.0 * (double)at * of->terms[at];
        terms += fabs(term);
        slope[at - 1] = slope[at + 1] + term;
    }
    slope[0] /= 2.0;
    for (at = 1; at < of->count; at++) {
        others += fabs(slope[at]);
    }
    return fabs(slope[0]) - others - (double)(of->count * of->count) * (of->off + DBL_EPSILON * terms);
}

/* The single zero by halving, as far as the polynomial is known. */
static void bracket(const Polynomial *of, int rises, double least_slope, double ends[2])
{
    const double around = (of->off + rounding_of_values(of)) / least_slope + DBL_EPSILON;
    int step;
    ends[0] = -1.0;
    ends[1] = 1.0;
    for (step = 0; step < 60; step++) {
        const double middle = (ends[0] + ends[1]) / 2.0;
        const int is_above = (value_at(of, middle) > 0.0) == rises;
        ends[is_above ? 1 : 0] = middle;
    }
    ends[0] = fmax(ends[0] - around, -1.0);
    ends[1] = fmin(ends[1] + around, 1.0);
}

/* The zeros by two rules: a constant term that is greater than all others leaves none, and one of the slope leaves one at
 * most, which the signs at the ends tell. */
static Told zeros_of(const Polynomial *of, double ends[2])
{
    const double constant = fabs(of->terms[0]), rounding = (double)of->count * DBL_EPSILON * of->size;
    const double least = of->off + rounding_of_values(of);
    double least_slope, low, high;
    if (!linkage_is_finite(of->size + of->off)) {
        return UNTOLD;
    }
    if (constant > of->size - constant + of->off + rounding) {
        return NO_ZERO;
    }
    least_slope = least_slope_of(of);
    low = value_at(of, -1.0);
    high = value_at(of, 1.0);
    if (!(least_slope > 0.0) || fabs(low) <= least || fabs(high) <= least) {
        return UNTOLD;
    }
    if ((low > 0.0) == (high > 0.0)) {
        return NO_ZERO;
    }
    bracket(of, high > 0.0, least_slope, ends);
    return ONE_ZERO;
}
