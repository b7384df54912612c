
#ifdef LINKAGE_NO_DOUBLE

/* The slow path in pairs of floats, where there is no double: the same steps to the same end. */

/* The least change of an amount that these show. */
#define SHOWN 0x1p-42f

static LinkagePair zero(void) { return linkage_pair(0.0f, 0.0f); }

static LinkagePair one(void) { return linkage_pair(1.0f, 0.0f); }

static LinkagePair plain(float x) { return linkage_pair(x, 0.0f); }

static LinkagePair magnitude(LinkagePair x) { return 0.0f > x.high ? linkage_pair_minus(x) : x; }

static LinkagePair difference(LinkagePair a, LinkagePair b) { return linkage_pair_plus(a, linkage_pair_minus(b)); }

static LinkagePair larger(LinkagePair a, LinkagePair b) { return linkage_pair_above(b, a) ? b : a; }

/* a*b + c */
static LinkagePair fused(LinkagePair a, LinkagePair b, LinkagePair c) { return linkage_pair_plus(linkage_pair_times(a, b), c); }

/* The length of a vector, also of one whose squares are small. */
static LinkagePair length(LinkagePair x, LinkagePair y)
{
    const int is_small = 0x1p-40f > larger(magnitude(x), magnitude(y)).high;
    const LinkagePair up = plain(is_small ? 0x1p80f : 1.0f), down = plain(is_small ? 0x1p-80f : 1.0f);
    const LinkagePair a = linkage_pair_times(x, up), b = linkage_pair_times(y, up);
    return linkage_pair_times(linkage_pair_root(fused(a, a, linkage_pair_times(b, b))), down);
}

/* The identity less the matrix. */
static void without(int count, LinkagePair matrix[MOST][MOST])
{
    int j, k;
    for (j = 0; j < count; j++) { /* at most MOST times */
        for (k = 0; k < count; k++) { /* at most MOST times */
            matrix[j][k] = difference(j == k ? one() : zero(), matrix[j][k]);
        }
    }
}

/* Clears a column below its pivot, in the right side as well, and puts the pivot's inverse in its place. */
static void eliminate(int count, LinkagePair matrix[MOST][MOST], LinkagePair *right, int k)
{
    const LinkagePair inverse = linkage_pair_over(one(), matrix[k][k]);
    int i, j;
    for (j = k + 1; j < count; j++) { /* at most MOST times */
        const LinkagePair factor = linkage_pair_minus(linkage_pair_times(matrix[j][k], inverse));
        for (i = k + 1; i < count; i++) { /* at most MOST times */
            matrix[j][i] = fused(factor, matrix[k][i], matrix[j][i]);
        }
        right[j] = fused(factor, right[k], right[j]);
    }
    matrix[k][k] = inverse;
}

static void solve(int count, LinkagePair matrix[MOST][MOST], LinkagePair *right)
{
    int j, k;
    for (k = 0; k < count; k++) { /* at most MOST times */
        eliminate(count, matrix, right, k);
    }
    for (k = count - 1; k >= 0; k--) { /* at most MOST times */
        for (j = k + 1; j < count; j++) { /* at most MOST times */
            right[k] = fused(linkage_pair_minus(matrix[k][j]), right[j], right[k]);
        }
        right[k] = linkage_pair_times(right[k], matrix[k][k]);
    }
}

/* The first contact at which friction may hold itself, by L; the count of contacts if there is none. */
static int jammed(int count, LinkagePair bounds[MOST][MOST])
{
    LinkagePair matrix[MOST][MOST], right[MOST] = { { 0.0f, 0.0f } };
    int k;
    (void)memcpy(matrix, bounds, sizeof matrix);
    without(count, matrix);
    for (k = 0; k < count; k++) { /* at most MOST times */
        if (!linkage_pair_above(matrix[k][k], zero())) {
            break;
        }
        eliminate(count, matrix, right, k);
    }
    return k;
}

/* L. */
static void bounds_of(const Systemf *s, LinkagePair bounds[MOST][MOST])
{
    int j, k;
    for (j = 0; j < s->count; j++) { /* at most MOST times */
        for (k = 0; k < s->count; k++) { /* at most MOST times */
            const float *pair = rowf(s, j) + CHANGES + 2 * k;
            const LinkagePair x = plain(magnitudef(pair[0])), y = plain(magnitudef(pair[1]));
            bounds[j][k] = linkage_pair_times(plain(rowf(s, j)[0]), is_guidef(s, j) ? larger(x, y) : length(x, y));
        }
    }
}

/* A component of a reaction. */
static LinkagePair reaction(const Systemf *s, int j, int axis, const LinkagePair *amounts)
{
    const float *of = rowf(s, j);
    LinkagePair sum = plain(of[FREE + axis]);
    int k;
    for (k = 0; k < s->count; k++) { /* at most MOST times */
        sum = fused(plain(of[CHANGES + 2 * k + axis]), amounts[k], sum);
    }
    return sum;
}

/* The values of all equations and their slopes; at a corner those of one side. */
static void linear(const Systemf *s, const LinkagePair *amounts, LinkagePair *values, LinkagePair slope[MOST][MOST])
{
    int j, k;
    for (j = 0; j < s->count; j++) { /* at most MOST times */
        const float *of = rowf(s, j);
        const LinkagePair x = reaction(s, j, 0, amounts), y = reaction(s, j, 1, amounts);
        LinkagePair along[2] = { { 0.0f, 0.0f }, { 0.0f, 0.0f } }, size;
        if (is_guidef(s, j)) {
            const int at = linkage_pair_above(magnitude(y), magnitude(x));
            size = larger(magnitude(x), magnitude(y));
            along[at] = plain(signf(at ? y.high : x.high));
        } else {
            size = length(x, y);
            if (size.high > 0.0f) {
                along[0] = linkage_pair_over(x, size);
                along[1] = linkage_pair_over(y, size);
            }
        }
        values[j] = linkage_pair_times(plain(of[0]), size);
        for (k = 0; k < s->count; k++) { /* at most MOST times */
            const float *by = of + CHANGES + 2 * k;
            const LinkagePair sum = fused(plain(by[0]), along[0], linkage_pair_times(plain(by[1]), along[1]));
            slope[j][k] = linkage_pair_times(plain(of[0]), sum);
        }
    }
}

/* One step of Newton's method. */
static void newton(int count, const LinkagePair *amounts, const LinkagePair *values, LinkagePair slope[MOST][MOST], LinkagePair *next)
{
    LinkagePair matrix[MOST][MOST], step[MOST];
    int j;
    (void)memcpy(matrix, slope, sizeof matrix);
    without(count, matrix);
    for (j = 0; j < count; j++) { /* at most MOST times */
        step[j] = difference(values[j], amounts[j]);
    }
    solve(count, matrix, step);
    for (j = 0; j < count; j++) { /* at most MOST times */
        next[j] = linkage_pair_plus(amounts[j], step[j]);
    }
}

/* True where the amounts solve their equations as far as rounding can tell. */
static int settled(int count, const LinkagePair *amounts, const LinkagePair *values, const LinkagePair *start, LinkagePair bounds[MOST][MOST])
{
    int j, k, met = 1;
    for (j = 0; j < count; j++) { /* at most MOST times */
        float size = start[j].high;
        for (k = 0; k < count; k++) { /* at most MOST times */
            size = linkage_fusedf(bounds[j][k].high, amounts[k].high, size);
        }
        met &= linkage_is_withinf(difference(values[j], amounts[j]).high, SHOWN * size);
    }
    return met;
}

/* The largest distance of amounts from their equations, by weights. */
static LinkagePair off(int count, const LinkagePair *amounts, const LinkagePair *values, const LinkagePair *weights)
{
    LinkagePair largest = zero();
    int j;
    for (j = 0; j < count; j++) { /* at most MOST times */
        largest = larger(largest, linkage_pair_over(magnitude(difference(values[j], amounts[j])), weights[j]));
    }
    return largest;
}

/* Weights by which the equations contract, and the factor by which they do. */
static LinkagePair gain_of(int count, const LinkagePair *start, LinkagePair bounds[MOST][MOST], LinkagePair *weights)
{
    LinkagePair matrix[MOST][MOST], units[MOST], gain = zero();
    int j, k;
    for (j = 0; j < count; j++) { /* at most MOST times */
        LinkagePair sum = start[j];
        for (k = 0; k < count; k++) { /* at most MOST times */
            sum = fused(bounds[j][k], start[k], sum);
        }
        units[j] = sum.high > 0.0f ? sum : one();
        weights[j] = units[j];
    }
    (void)memcpy(matrix, bounds, sizeof matrix);
    without(count, matrix);
    solve(count, matrix, weights);
    for (j = 0; j < count; j++) { /* at most MOST times */
        gain = larger(gain, difference(one(), linkage_pair_over(units[j], weights[j])));
    }
    return gain;
}

/* Newton's steps, each replaced by the equations' values where it gains less than those. */
static int guarded(const Systemf *s, const LinkagePair *start, LinkagePair bounds[MOST][MOST], LinkagePair *amounts)
{
    LinkagePair slope[MOST][MOST] = { { { 0.0f, 0.0f } } }, unused[MOST][MOST] = { { { 0.0f, 0.0f } } };
    LinkagePair weights[MOST], values[MOST], next[MOST], next_values[MOST];
    const size_t size = (size_t)s->count * sizeof *amounts;
    const LinkagePair gain = gain_of(s->count, start, bounds, weights);
    int step;
    (void)memcpy(amounts, start, size);
    linear(s, amounts, values, slope);
    for (step = 0; step <= GUARDED; step++) { /* at most GUARDED + 1 times */
        if (settled(s->count, amounts, values, start, bounds)) {
            return 1;
        }
        newton(s->count, amounts, values, slope, next);
        linear(s, next, next_values, unused);
        if (linkage_pair_above(off(s->count, next, next_values, weights), linkage_pair_times(gain, off(s->count, amounts, values, weights)))) {
            (void)memcpy(amounts, values, size);
        } else {
            (void)memcpy(amounts, next, size);
        }
        linear(s, amounts, values, slope);
    }
    return 0;
}

/* Divides reactions without friction by the power of two of the largest, to which all amounts are proportional. Returns
 * that power. */
static float divided(int count, float *rows)
{
    float largest = 0.0f, power = 1.0f;
    int j;
    for (j = 0; j < count; j++) { /* at most MOST times */
        const float *of = rows + j * WIDTH(count);
        const float x = magnitudef(of[FREE]), y = magnitudef(of[FREE + 1]);
        largest = x > largest ? x : largest;
        largest = y > largest ? y : largest;
    }
    if (largest > 0.0f) {
        power = ldexpf(1.0f, ilogbf(largest) > -126 ? ilogbf(largest) : -126);
    }
    for (j = 0; j < count; j++) { /* at most MOST times */
        rows[j * WIDTH(count) + FREE] /= power;
        rows[j * WIDTH(count) + FREE + 1] /= power;
    }
    return power;
}

/* True where no amount is beyond what pairs hold. */
static int are_held(int count, const LinkagePair *amounts)
{
    int j, held = 1;
    for (j = 0; j < count; j++) { /* at most MOST times */
        held &= linkage_is_finitef(amounts[j].high);
    }
    return held;
}

/* Finds the only solution, infinite where amounts are beyond what pairs hold: then results are. Returns the contact at
 * which friction may hold itself, the count of contacts if there is none. */
static int solved(int count, unsigned guides, float *rows, float *found)
{
    LinkagePair bounds[MOST][MOST] = { { { 0.0f, 0.0f } } }, slope[MOST][MOST] = { { { 0.0f, 0.0f } } };
    LinkagePair start[MOST], values[MOST], amounts[MOST];
    const LinkagePair none[MOST] = { { 0.0f, 0.0f } };
    const float power = divided(count, rows);
    Systemf s;
    int step, jams, j, met = 0;
    s.count = count;
    s.guides = guides;
    s.rows = rows;
    bounds_of(&s, bounds);
    jams = jammed(count, bounds);
    if (jams < count) {
        return jams;
    }
    linear(&s, none, start, slope);
    (void)memcpy(amounts, start, (size_t)count * sizeof *amounts);
    /* Amounts that are settled take one step more: next to a joint that jams they would not be as right as they show. */
    for (step = 0; step <= NEWTON && !met; step++) { /* at most NEWTON + 1 times */
        linear(&s, amounts, values, slope);
        met = settled(count, amounts, values, start, bounds);
        newton(count, amounts, values, slope, amounts);
    }
    if (!met && !guarded(&s, start, bounds, amounts)) {
        linear(&s, amounts, values, slope);
        if (are_held(count, amounts) && are_held(count, values)) {
            return 0;
        }
        amounts[0] = plain(HUGE_VALF);
    }
    for (j = 0; j < count; j++) { /* at most MOST times */
        found[j] = amounts[j].high * power;
    }
    return count;
}

#endif /* LINKAGE_NO_DOUBLE */
