
/* In TYPE. */

/* A place, and a function's value and slope there. */
typedef struct At@ {
    REAL x;
    REAL value;
    REAL slope;
} At@;

/* left - right, its sign turned where it is to fall. */
typedef struct Equation@ {
    LinkageSides@ sides;
    const REAL *given;
    REAL trend;
    int evaluations;
    /* The width of the interval, the largest sides met, and the change over the width at the last slope. */
    REAL width;
    REAL extent;
    REAL change;
    Failure failure;
    REAL at;
    REAL by;
} Equation@;

/* An interval that is searched, and how closely. */
typedef struct Approach@ {
    REAL from;
    REAL to;
    REAL tolerance;
} Approach@;

/* The function that a bracket closes in on: f times `turn`, or its slope. */
typedef struct Sampler@ {
    Equation@ *f;
    REAL turn;
    int seeks_slope;
    At@ last; /* of f, where the slope is sought */
} Sampler@;

/* Newton's steps on their way to a root. */
typedef struct Steps@ {
    REAL tolerance;
    REAL width;
    int is_secant;
    int has_last;
    REAL step;
    REAL slope;
} Steps@;

static REAL absolute@(REAL x) { return x >= 0.0@ ? x : -x; }

static REAL greater@(REAL a, REAL b) { return a > b ? a : b; }

static REAL less@(REAL a, REAL b) { return b > a ? a : b; }

static REAL middle@(REAL a, REAL b) { return a + (b - a) * 0.5@; }

static At@ turned@(At@ at, REAL turn)
{
    at.value = turn * at.value;
    at.slope = turn * at.slope;
    return at;
}

static int fail@(Equation@ *f, Failure failure, REAL at, REAL by)
{
    f->failure = failure;
    f->at = at;
    f->by = by;
    return 0;
}

static int evaluate@(Equation@ *f, REAL x, At@ *to)
{
    REAL sides[3], size, value;
    f->evaluations++;
    f->sides(f->given, x, sides);
    size = absolute@(sides[0]) + absolute@(sides[1]);
    if (linkage_is_finite@(size)) {
        f->extent = greater@(f->extent, size);
    }
    f->change = absolute@(sides[2]) * f->width;
    value = sides[0] - sides[1];
    to->x = x;
    to->value = f->trend * value;
    to->slope = f->trend * sides[2];
    return linkage_is_finite@(value) ? 1 : fail@(f, NOT_A_NUMBER, x, 0.0@);
}

static int sample@(const Sampler@ *s, REAL x, At@ *to)
{
    if (!evaluate@(s->f, x, to)) {
        return 0;
    }
    *to = turned@(*to, s->turn);
    return 1;
}

/* A trial. Where the slope is sought, its own slope is the secant of the last two, and a value below zero is
 * enough. */
static int try_at@(Sampler@ *s, REAL x, At@ *to, int *is_enough)
{
    At@ at;
    if (!sample@(s, x, &at)) {
        return 0;
    }
    *to = at;
    *is_enough = 0;
    if (s->seeks_slope) {
        to->value = at.slope;
        to->slope = (at.slope - s->last.slope) / (at.x - s->last.x);
        *is_enough = 0.0@ > at.value;
        s->last = at;
    }
    return 1;
}

/* If the ends are finite, in rising order, and so is their distance. */
static int approach_of@(Approach@ *approach, REAL from, REAL to)
{
    const REAL width = to - from;
    approach->from = from;
    approach->to = to;
    approach->tolerance = greater@(absolute@(from), absolute@(to)) * (0.5@ * LEAST_EPSILON);
    return linkage_is_finite@(width) && width > 0.0@;
}

/* The number of evaluations that bisection takes and as many to spare, and the tolerance times two to this
 * power. */
static int budget@(const Approach@ *approach, REAL width, REAL *reach)
{
    const int known = exponent_of(width) - exponent_of(approach->tolerance) - 2;
    int halvings = known < 0 ? 0 : known;
    REAL wide;
    halvings = halvings < LEAST_MANT_DIG ? halvings : LEAST_MANT_DIG;
    wide = approach->tolerance * (REAL)((uint64_t)1 << halvings);
    while (halvings < LEAST_MANT_DIG && width > wide + wide) { /* at most LEAST_MANT_DIG times */
        wide = wide + wide;
        halvings++;
    }
    *reach = wide * 64.0@;
    return halvings + SPARE;
}

/* The trial moved to where a bracket that is halved with every evaluation from now on ends in time. */
static REAL projected@(REAL x, REAL a, REAL b, REAL reach)
{
    const REAL half = (b - a) * 0.5@, centre = a + half, aside = greater@(reach - half, 0.0@);
    const REAL low = greater@(centre - aside, a), high = less@(centre + aside, b);
    if (x >= low && high >= x) {
        return x;
    }
    if (low > x) {
        return low;
    }
    return x > high ? high : centre;
}

/* Newton's step where the slope is one that rises. */
static int newton_step@(At@ at, REAL *step)
{
    *step = -at.value / at.slope;
    return at.slope > 0.0@ && linkage_is_finite@(at.slope);
}

/* True if this step leads to within the tolerance of the root, as far as the last two steps show. */
static int is_last@(const Steps@ *s, REAL step_before_sign, REAL slope)
{
    const REAL step = absolute@(step_before_sign), last = absolute@(s->step);
    REAL ratio, next;
    if (s->tolerance >= step) {
        return 1;
    }
    if (!s->has_last) {
        return 0;
    }
    /* Steps this short that do not become shorter are the function's rounding. */
    if (step >= last * (REAL)0.7) {
        return s->width * (1.0@ / 4194304.0@) >= last;
    }
    /* Where the slope has become so much steeper, the function is none that steps converge on. */
    if (!s->is_secant && absolute@(slope) > absolute@(s->slope) * 4.0@) {
        return 0;
    }
    ratio = step / last;
    if (s->is_secant) {
        next = ratio * step;
    } else {
        const REAL bend = absolute@((slope - s->slope) / (slope + slope));
        next = greater@(ratio * ratio, bend * ratio) * step;
    }
    return s->tolerance * 0.5@ >= next;
}

static void go@(Steps@ *steps, REAL step, REAL slope)
{
    steps->has_last = 1;
    steps->step = step;
    steps->slope = slope;
}

/* Where the function comes through zero, from below at `a` to above at `b`, by at most so many trials. */
static int close_in@(const Approach@ *approach, At@ a, At@ b, REAL start, int most, Sampler@ *f, REAL *found)
{
    const REAL width = b.x - a.x;
    /* Slopes so steep that the root would be next to any value are no guide. */
    const REAL believed = (b.value - a.value) / (width * sqrt@(LEAST_EPSILON));
    Steps@ steps = { 0.0@, 0.0@, 0, 0, 0.0@, 0.0@ };
    REAL reach, x = start;
    int left = budget@(approach, width, &reach);
    steps.tolerance = approach->tolerance;
    steps.width = width;
    steps.is_secant = f->seeks_slope;
    for (left = left < most ? left : most; left > 0; left--) { /* at most LEAST_MANT_DIG + SPARE times */
        const REAL wanted = x;
        At@ at;
        REAL step;
        int is_enough;
        x = projected@(x, a.x, b.x, reach);
        reach = reach * 0.5@;
        if (x != wanted) {
            steps.has_last = 0;
        }
        if (!try_at@(f, x, &at, &is_enough)) {
            return 0;
        }
        if (is_enough || at.value == 0.0@) {
            *found = x;
            return 1;
        }
        if (at.value > 0.0@) {
            b = at;
        } else {
            a = at;
        }
        if (approach->tolerance + approach->tolerance >= b.x - a.x) {
            break;
        }
        if (newton_step@(at, &step) && believed >= at.slope && x + step >= a.x && b.x >= x + step) {
            if (is_last@(&steps, step, at.slope)) {
                *found = x + step;
                return 1;
            }
            go@(&steps, step, at.slope);
            x = x + step;
        } else {
            steps.has_last = 0;
            x = middle@(a.x, b.x);
        }
    }
    *found = absolute@(b.value) > absolute@(a.value) ? a.x : b.x;
    return 1;
}
