
/* In TYPE. */

/* The equations of so many amounts. Bit j is set if contact j is a guide. */
typedef struct System@ {
    int count;
    unsigned guides;
    const REAL *rows;
} System@;

static REAL magnitude@(REAL x) { return x >= 0.0@ ? x : -x; }

static REAL sign@(REAL x) { return x >= 0.0@ ? 1.0@ : -1.0@; }

static int is_guide@(const System@ *s, int j) { return (int)(s->guides >> j & 1u); }

static const REAL *row@(const System@ *s, int j) { return s->rows + j * WIDTH(s->count); }

/* The identity less the matrix. */
static void without@(int count, REAL matrix[MOST][MOST])
{
    int j, k;
    for (j = 0; j < count; j++) { /* at most MOST times */
        for (k = 0; k < count; k++) { /* at most MOST times */
            matrix[j][k] = j == k ? 1.0@ - matrix[j][k] : -matrix[j][k];
        }
    }
}

/* Clears a column below its pivot, in the right side as well, and puts the pivot's inverse in its place. */
static void eliminate@(int count, REAL matrix[MOST][MOST], REAL *right, int k)
{
    const REAL inverse = 1.0@ / matrix[k][k];
    int i, j;
    for (j = k + 1; j < count; j++) { /* at most MOST times */
        const REAL factor = -(matrix[j][k] * inverse);
        for (i = k + 1; i < count; i++) { /* at most MOST times */
            matrix[j][i] = linkage_fused@(factor, matrix[k][i], matrix[j][i]);
        }
        right[j] = linkage_fused@(factor, right[k], right[j]);
    }
    matrix[k][k] = inverse;
}

/* The solution of a system whose elimination needs no exchanges, in the place of the right side. */
static void solve@(int count, REAL matrix[MOST][MOST], REAL *right)
{
    int j, k;
    for (k = 0; k < count; k++) { /* at most MOST times */
        eliminate@(count, matrix, right, k);
    }
    for (k = count - 1; k >= 0; k--) { /* at most MOST times */
        for (j = k + 1; j < count; j++) { /* at most MOST times */
            right[k] = linkage_fused@(-matrix[k][j], right[j], right[k]);
        }
        right[k] = right[k] * matrix[k][k];
    }
}

/* The first contact at which friction may hold itself, by L; the count of contacts if there is none. */
static int jammed@(int count, REAL bounds[MOST][MOST])
{
    REAL matrix[MOST][MOST], right[MOST] = { 0.0@ };
    int k;
    (void)memcpy(matrix, bounds, sizeof matrix);
    without@(count, matrix);
    for (k = 0; k < count; k++) { /* at most MOST times */
        /* NaN is no positive pivot. */
        if (!(matrix[k][k] > 0.0@)) {
            break;
        }
        eliminate@(count, matrix, right, k);
    }
    return k;
}

/* L. A pin's size may underflow. */
static void bounds_of@(const System@ *s, REAL bounds[MOST][MOST])
{
    int j, k;
    for (j = 0; j < s->count; j++) { /* at most MOST times */
        for (k = 0; k < s->count; k++) { /* at most MOST times */
            const REAL *pair = row@(s, j) + CHANGES + 2 * k;
            const REAL x = magnitude@(pair[0]), y = magnitude@(pair[1]);
            const REAL length = sqrt@(linkage_fused@(pair[0], pair[0], pair[1] * pair[1]));
            bounds[j][k] = row@(s, j)[0] * (is_guide@(s, j) ? (x >= y ? x : y) : length);
        }
    }
}

/* A reaction. Changes come first: contacts that a couple loads alike share their sum. */
static void reaction@(const System@ *s, int j, const REAL *amounts, REAL *to)
{
    const REAL *of = row@(s, j);
    int k, axis;
    for (axis = 0; axis < 2; axis++) { /* at most 2 times */
        REAL sum = of[CHANGES + axis] * amounts[0];
        for (k = 1; k < s->count; k++) { /* at most MOST times */
            sum = linkage_fused@(of[CHANGES + 2 * k + axis], amounts[k], sum);
        }
        to[axis] = of[FREE + axis] + sum;
    }
}

/* The length of a reaction, by the root of its square where only a square in range is told from others. */
static REAL length@(REAL x, REAL y, int *are_near)
{
    REAL length;
    if (are_near == NULL) {
        return linkage_hypot@(x, y);
    }
    *are_near &= linkage_hypot_near@(x, y, linkage_smallest_square@(), &length);
    return length;
}

/* The values of all equations and their slopes; at a corner those of one side. */
static void linear@(const System@ *s, const REAL *amounts, int *are_near, REAL *values, REAL slope[MOST][MOST])
{
    int j, k;
    for (j = 0; j < s->count; j++) { /* at most MOST times */
        const REAL *of = row@(s, j);
        REAL of_reaction[2], direction[2], size;
        reaction@(s, j, amounts, of_reaction);
        if (is_guide@(s, j)) {
            const REAL x = magnitude@(of_reaction[0]), y = magnitude@(of_reaction[1]);
            const int is_first = x >= y;
            size = is_first ? x : y;
            direction[0] = is_first ? sign@(of_reaction[0]) : 0.0@;
            direction[1] = is_first ? 0.0@ : sign@(of_reaction[1]);
        } else {
            REAL inverse;
            size = length@(of_reaction[0], of_reaction[1], are_near);
            inverse = 0.0@ >= size ? 0.0@ : 1.0@ / size;
            direction[0] = of_reaction[0] * inverse;
            direction[1] = of_reaction[1] * inverse;
        }
        values[j] = of[0] * size;
        direction[0] = of[0] * direction[0];
        direction[1] = of[0] * direction[1];
        for (k = 0; k < s->count; k++) { /* at most MOST times */
            const REAL *by = of + CHANGES + 2 * k;
            slope[j][k] = linkage_fused@(by[0], direction[0], by[1] * direction[1]);
        }
    }
}

/* One step of Newton's method. */
static void newton@(int count, const REAL *amounts, const REAL *values, REAL slope[MOST][MOST], REAL *next)
{
    REAL matrix[MOST][MOST], step[MOST];
    int j;
    (void)memcpy(matrix, slope, sizeof matrix);
    without@(count, matrix);
    for (j = 0; j < count; j++) { /* at most MOST times */
        step[j] = values[j] - amounts[j];
    }
    solve@(count, matrix, step);
    for (j = 0; j < count; j++) { /* at most MOST times */
        next[j] = amounts[j] + step[j];
    }
}

/* True where the amounts solve their equations as far as rounding can tell. */
static int settled@(int count, const REAL *amounts, const REAL *values, const REAL *start, REAL bounds[MOST][MOST])
{
    int j, k, met = 1;
    for (j = 0; j < count; j++) { /* at most MOST times */
        REAL size = start[j];
        for (k = 0; k < count; k++) { /* at most MOST times */
            size = linkage_fused@(bounds[j][k], amounts[k], size);
        }
        met &= linkage_is_within@(values[j] - amounts[j], 4.0@ * LEAST_EPSILON * size);
    }
    return met;
}
