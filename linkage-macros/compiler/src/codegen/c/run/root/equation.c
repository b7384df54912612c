
/* The cubic through values and slopes of two places, by the part u of the way: p u^3 + q u^2 + d0 u + y0. */
typedef struct Cubic@ {
    REAL p;
    REAL q;
    REAL d0;
    REAL d1;
    REAL y0;
    REAL y1;
} Cubic@;

static Cubic@ cubic_through@(At@ a, At@ b)
{
    const REAL width = b.x - a.x, rise = b.value - a.value;
    Cubic@ c;
    c.d0 = a.slope * width;
    c.d1 = b.slope * width;
    c.p = c.d0 + c.d1 - 2.0@ * rise;
    c.q = 3.0@ * rise - 2.0@ * c.d0 - c.d1;
    c.y0 = a.value;
    c.y1 = b.value;
    return c;
}

static REAL cubic_at@(const Cubic@ *c, REAL u) { return ((c->p * u + c->q) * u + c->d0) * u + c->y0; }

static REAL cubic_slope@(const Cubic@ *c, REAL u) { return (3.0@ * c->p * u + 2.0@ * c->q) * u + c->d0; }

/* Where, between 0 and 1, it is lowest, if it falls at the first place and rises at the second. */
static REAL turning_part@(const Cubic@ *c) { return -c->d0 / (c->q + sqrt@(c->q * c->q - 3.0@ * c->p * c->d0)); }

/* The root, between 0 and 1, of the cubic with these values at 0 and 1, below zero and above, and slopes. */
static REAL part@(REAL y0, REAL y1, REAL d0, REAL d1)
{
    REAL p, q, parabola, u, low = 0.0@, high = 1.0@;
    int i;
    if (!(linkage_is_finite@(d0) && linkage_is_finite@(d1))) {
        return y0 / (y0 - y1);
    }
    p = 2.0@ * (y0 - y1) + (d0 + d1);
    q = 3.0@ * (y1 - y0) - (2.0@ * d0 + d1);
    parabola = -2.0@ * y0 / (d0 + sqrt@(d0 * d0 - 4.0@ * q * y0));
    u = parabola > 0.0@ && 1.0@ > parabola ? parabola : 0.5@;
    for (i = 0; i < CUBIC_STEPS; i++) { /* at most CUBIC_STEPS times */
        const REAL value = ((p * u + q) * u + d0) * u + y0;
        const REAL slope = (3.0@ * p * u + 2.0@ * q) * u + d0;
        REAL next;
        int is_close;
        if (value > 0.0@) {
            high = u;
        } else {
            low = u;
        }
        next = u - value / slope;
        is_close = (REAL)1e-3 * u >= absolute@(next - u);
        u = next > low && high > next ? next : (low + high) * 0.5@;
        if (is_close) {
            break;
        }
    }
    return u;
}

/* The first trial between an end below zero and one above. It is right relative to the distance from the end
 * that is nearer to zero. */
static REAL first_trial@(At@ a, At@ b)
{
    const REAL width = b.x - a.x;
    if (b.value > -a.value) {
        return a.x + width * part@(a.value, b.value, a.slope * width, b.slope * width);
    }
    return b.x - width * part@(-b.value, -a.value, b.slope * width, a.slope * width);
}

/* The root that Newton's method converges to from a seed, if it does at once and inside. */
static int newton@(Equation@ *f, REAL seed, const Approach@ *approach, REAL *found)
{
    Steps@ steps = { 0.0@, 0.0@, 0, 0, 0.0@, 0.0@ };
    REAL x = seed;
    int i;
    steps.tolerance = approach->tolerance;
    steps.width = approach->to - approach->from;
    for (i = 0; i < SEEDED; i++) { /* at most SEEDED times */
        At@ at;
        REAL step;
        if (!(x >= approach->from && approach->to >= x) || !evaluate@(f, x, &at)) {
            return 0;
        }
        if (!newton_step@(at, &step) || !(steps.width >= absolute@(step))) {
            return 0;
        }
        x = x + step;
        if (is_last@(&steps, step, at.slope)) {
            *found = x;
            return x >= approach->from && approach->to >= x;
        }
        go@(&steps, step, at.slope);
    }
    return 0;
}

/* The root in a bracket. */
static int bracketed@(Equation@ *f, At@ a, At@ b, const Approach@ *approach, REAL *found)
{
    Sampler@ sampler = { f, 1.0@, 0, { 0.0@, 0.0@, 0.0@ } };
    return close_in@(approach, a, b, first_trial@(a, b), UNLIMITED, &sampler, found);
}

/* Looks for the root between a place above zero and one below it. */
static int falls_through_zero@(Equation@ *f, At@ a, At@ b, int most)
{
    Sampler@ sampler = { f, -1.0@, 0, { 0.0@, 0.0@, 0.0@ } };
    Approach@ approach;
    REAL found;
    a = turned@(a, -1.0@);
    b = turned@(b, -1.0@);
    if (!approach_of@(&approach, a.x, b.x)) {
        return 1;
    }
    return close_in@(&approach, a, b, first_trial@(a, b), most, &sampler, &found);
}

/* The lowest point of f times `turn` between an end where that falls and one where it rises, or the first
 * place found below zero. */
static int lowest@(Equation@ *f, REAL turn, At@ a, At@ b, int most, At@ *found)
{
    Sampler@ sampler = { f, turn, 1, { 0.0@, 0.0@, 0.0@ } };
    Approach@ approach;
    Cubic@ cubic;
    REAL start, x;
    a = turned@(a, turn);
    b = turned@(b, turn);
    *found = turned@(a, turn);
    if (!approach_of@(&approach, a.x, b.x)) {
        return 1;
    }
    cubic = cubic_through@(a, b);
    start = a.x + (b.x - a.x) * turning_part@(&cubic);
    sampler.last = a;
    a.value = a.slope;
    b.value = b.slope;
    a.slope = 0.0@;
    b.slope = 0.0@;
    if (!close_in@(&approach, a, b, start, most, &sampler, &x)) {
        return 0;
    }
    if (x != sampler.last.x && !sample@(&sampler, x, &sampler.last)) {
        return 0;
    }
    *found = turned@(sampler.last, turn);
    return 1;
}

/* Evaluations that find the value of a dead point to rounding. */
static int dead_point_most@(int most)
{
    const int enough = (LEAST_MANT_DIG + SPARE) / 2 + SPARE;
    return enough < most ? enough : most;
}

/* One of the ends, at which f has the wrong sign and a slope against the trend, moved towards the dead point
 * that it lies beyond until the sign is right. Takes from `most` what it evaluates. */
static int move_in@(Equation@ *f, At@ ends[2], int end, int *most)
{
    const At@ moves = ends[end];
    const int before = f->evaluations, allowed = dead_point_most@(*most);
    At@ inner = ends[1 - end];
    if (!(inner.slope > 0.0@) && !evaluate@(f, middle@(ends[0].x, ends[1].x), &inner)) {
        return 0;
    }
    if (inner.slope > 0.0@) {
        const At@ low = end == 0 ? moves : inner, high = end == 0 ? inner : moves;
        if (!lowest@(f, end == 0 ? 1.0@ : -1.0@, low, high, remaining(allowed, 2), &ends[end])) {
            return 0;
        }
    }
    *most = remaining(*most, f->evaluations - before);
    return 1;
}
