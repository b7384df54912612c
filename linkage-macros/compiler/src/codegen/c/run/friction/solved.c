
/* The slow path, in double precision whatever the caller's width. */

/* The largest distance of amounts from their equations, by weights. */
static double off(int count, const double *amounts, const double *values, const double *weights)
{
    double largest = 0.0;
    int j;
    for (j = 0; j < count; j++) { /* at most MOST times */
        const double by = magnitude(values[j] - amounts[j]) / weights[j];
        if (by > largest) {
            largest = by;
        }
    }
    return largest;
}

/* Weights by which the equations contract, and the factor by which they do. */
static double gain_of(int count, const double *start, double bounds[MOST][MOST], double *weights)
{
    double matrix[MOST][MOST], units[MOST], gain = 0.0;
    int j, k;
    for (j = 0; j < count; j++) { /* at most MOST times */
        double sum = 0.0;
        for (k = 0; k < count; k++) { /* at most MOST times */
            sum = sum + bounds[j][k] * start[k];
        }
        units[j] = start[j] + sum > 0.0 ? start[j] + sum : 1.0;
        weights[j] = units[j];
    }
    (void)memcpy(matrix, bounds, sizeof matrix);
    without(count, matrix);
    solve(count, matrix, weights);
    for (j = 0; j < count; j++) { /* at most MOST times */
        const double by = 1.0 - units[j] / weights[j];
        if (by > gain) {
            gain = by;
        }
    }
    return gain;
}

/* Newton's steps, each replaced by the equations' values where it gains less than those. */
static int guarded(const System *s, const double *start, double bounds[MOST][MOST], double *amounts)
{
    double slope[MOST][MOST] = { { 0.0 } }, unused[MOST][MOST] = { { 0.0 } };
    double weights[MOST], values[MOST], next[MOST], next_values[MOST];
    const size_t size = (size_t)s->count * sizeof *amounts;
    const double gain = gain_of(s->count, start, bounds, weights);
    int step;
    (void)memcpy(amounts, start, size);
    linear(s, amounts, NULL, values, slope);
    for (step = 0; step <= GUARDED; step++) { /* at most GUARDED + 1 times */
        if (settled(s->count, amounts, values, start, bounds)) {
            return 1;
        }
        newton(s->count, amounts, values, slope, next);
        linear(s, next, NULL, next_values, unused);
        if (off(s->count, next, next_values, weights) <= gain * off(s->count, amounts, values, weights)) {
            (void)memcpy(amounts, next, size);
        } else {
            (void)memcpy(amounts, values, size);
        }
        linear(s, amounts, NULL, values, slope);
    }
    return 0;
}

/* Finds the only solution. Returns the contact at which friction may hold itself, the count of contacts if there
 * is none. */
static int solved(int count, unsigned guides, const double *rows, double *amounts)
{
    double bounds[MOST][MOST] = { { 0.0 } }, slope[MOST][MOST] = { { 0.0 } };
    double start[MOST], values[MOST];
    const double none[MOST] = { 0.0 };
    System s;
    int step, jams;
    s.count = count;
    s.guides = guides;
    s.rows = rows;
    bounds_of(&s, bounds);
    jams = jammed(count, bounds);
    if (jams < count) {
        return jams;
    }
    linear(&s, none, NULL, start, slope);
    (void)memcpy(amounts, start, (size_t)count * sizeof *amounts);
    for (step = 0; step <= NEWTON; step++) { /* at most NEWTON + 1 times */
        linear(&s, amounts, NULL, values, slope);
        if (settled(count, amounts, values, start, bounds)) {
            return count;
        }
        newton(count, amounts, values, slope, amounts);
    }
    return guarded(&s, start, bounds, amounts) ? count : 0;
}
