
/* A look at all of an interval, where its ends alone do not enclose a root. */

/* A sample, and the piece from it to the next: a bound on the error of the piece's cubic, NaN until it is known,
 * and whether f is known not to rise through zero there. */
typedef struct Piece@ {
    At@ from;
    REAL error;
    int is_clear;
} Piece@;

/* The pieces in order, the last of no width. */
typedef struct Survey@ {
    Piece@ pieces[SAMPLES];
    int count;
    REAL widest; /* the widest piece that is believed to be what its cubic is */
} Survey@;

/* What a survey finds: places between which f rises through zero, or falls; or where it is zero; or the dead
 * point at which it comes nearest. */
typedef struct Look@ {
    At@ ends[2];
    int has_nearest;
    At@ nearest;
    int falls;
} Look@;

static int all_above@(REAL least, const REAL *numbers, int count)
{
    int i, are = 1;
    for (i = 0; i < count; i++) { /* at most 4 times */
        are &= numbers[i] > least;
    }
    return are;
}

static int all_below@(REAL least, const REAL *numbers, int count)
{
    int i, are = 1;
    for (i = 0; i < count; i++) { /* at most 4 times */
        are &= -least > numbers[i];
    }
    return are;
}

/* A bound on the errors of the cubics of both halves, from the sample in the middle. */
static REAL error_of_halves@(At@ a, At@ b, At@ centre)
{
    const Cubic@ c = cubic_through@(a, b);
    const REAL off = absolute@(cubic_at@(&c, 0.5@) - centre.value);
    return off + absolute@(cubic_slope@(&c, 0.5@) - centre.slope * (b.x - a.x)) * 0.25@;
}

/* Which way a piece bends, if it is one way throughout: 1 for the dip, -1 for the hump, else 0. */
static REAL bends@(At@ a, At@ b, REAL error)
{
    const Cubic@ c = cubic_through@(a, b);
    const REAL least = error * 32.0@, first = 2.0@ * c.q, second = first + 6.0@ * c.p;
    if (first > least && second > least) {
        return 1.0@;
    }
    return -least > first && -least > second ? -1.0@ : 0.0@;
}

/* True if there is a dip (1) or a hump (-1). */
static int turns@(At@ a, At@ b, REAL sign) { return 0.0@ > sign * a.slope && sign * b.slope > 0.0@; }

/* True if f does not rise through zero here. */
static int is_clear@(At@ a, At@ b, REAL error_of_cubic)
{
    const Cubic@ c = cubic_through@(a, b);
    const REAL third = (REAL)(1.0 / 3.0);
    const REAL rounding = greater@(absolute@(a.value), absolute@(b.value)) * (4.0@ * LEAST_EPSILON);
    const REAL error = error_of_cubic + rounding, least = error * (REAL)3.1;
    REAL values[4], slopes[3], ends[2], sign;
    values[0] = c.y0;
    values[1] = c.y0 + c.d0 * third;
    values[2] = c.y1 - c.d1 * third;
    values[3] = c.y1;
    slopes[0] = c.d0;
    slopes[1] = c.d0 + c.q;
    slopes[2] = c.d1;
    ends[0] = a.value;
    ends[1] = b.value;
    if (all_above@(error, values, 4) || all_below@(error, values, 4) || all_below@(least, slopes, 3)) {
        return 1;
    }
    if (all_above@(least, slopes, 3) && (all_above@(0.0@, ends, 2) || all_below@(0.0@, ends, 2))) {
        return 1;
    }
    sign = bends@(a, b, error_of_cubic);
    if (sign == 0.0@) {
        return 0;
    }
    return 0.0@ > sign * a.value || 0.0@ > sign * b.value || !turns@(a, b, sign);
}

/* Divides the piece of this index: both parts are known as well as the new one. */
static void insert@(Survey@ *s, int index, At@ from, REAL error, int is_known)
{
    int i;
    for (i = s->count < SAMPLES ? s->count : SAMPLES - 1; i > index + 1; i--) { /* at most SAMPLES times */
        s->pieces[i] = s->pieces[i - 1];
    }
    s->count = s->count < SAMPLES ? s->count + 1 : SAMPLES;
    s->pieces[index].error = error;
    s->pieces[index].is_clear = is_known;
    if (index + 1 < SAMPLES) {
        s->pieces[index + 1].from = from;
        s->pieces[index + 1].error = error;
        s->pieces[index + 1].is_clear = is_known;
    }
    for (i = index; i < index + 2 && i + 1 < s->count; i++) { /* at most 2 times */
        Piece@ *piece = &s->pieces[i];
        const At@ next = s->pieces[i + 1].from;
        if (!piece->is_clear && s->widest >= next.x - piece->from.x) {
            piece->is_clear = is_clear@(piece->from, next, piece->error);
        }
    }
}

static void begin@(Survey@ *s, const At@ places[4])
{
    const At@ first = places[0];
    REAL last = first.x;
    int i;
    s->pieces[0].from = first;
    s->pieces[0].error = (REAL)NAN;
    s->pieces[0].is_clear = 0;
    s->count = 1;
    s->widest = (places[3].x - first.x) * (0.125@ * (1.0@ + 4.0@ * LEAST_EPSILON));
    for (i = 0; i < 4; i++) { /* at most 4 times */
        if (places[i].x > last) {
            insert@(s, s->count - 1, places[i], (REAL)NAN, 0);
            last = places[i].x;
        }
    }
}

/* The widest of the pieces that are not clear; -1 where all are. */
static int widest@(const Survey@ *s)
{
    REAL width = 0.0@;
    int i, index = -1;
    for (i = 0; i + 1 < s->count; i++) { /* at most SAMPLES times */
        const REAL own = s->pieces[i + 1].from.x - s->pieces[i].from.x;
        if (!s->pieces[i].is_clear && (index < 0 || own > width)) {
            index = i;
            width = own;
        }
    }
    return index;
}

/* Two samples that enclose a root of f times `turn`, or twice the sample that is one. */
static int passage@(const Survey@ *s, REAL turn, At@ ends[2])
{
    int i, has_low = 0;
    for (i = 0; i < s->count; i++) { /* at most SAMPLES times */
        const At@ at = s->pieces[i].from;
        if (at.value == 0.0@ && turn * at.slope > 0.0@) {
            ends[0] = at;
            ends[1] = at;
            return 1;
        }
        if (has_low && turn * at.value > 0.0@) {
            ends[1] = at;
            return 1;
        }
        if (0.0@ > turn * at.value) {
            ends[0] = at;
            has_low = 1;
        }
    }
    return 0;
}

/* The dip or the hump that comes nearest to zero by its cubic, and which it is; 0 where there is none. */
static REAL nearest@(const Survey@ *s, At@ ends[2])
{
    REAL found = 0.0@, best = 0.0@;
    int i;
    for (i = 0; i + 1 < s->count; i++) { /* at most SAMPLES times */
        const REAL sign = s->pieces[i].from.value > 0.0@ ? 1.0@ : -1.0@;
        const At@ a = turned@(s->pieces[i].from, sign), b = turned@(s->pieces[i + 1].from, sign);
        const Cubic@ c = cubic_through@(a, b);
        const REAL least = cubic_at@(&c, turning_part@(&c));
        if (turns@(a, b, 1.0@) && b.value > 0.0@ && (found == 0.0@ || best > least)) {
            ends[0] = s->pieces[i].from;
            ends[1] = s->pieces[i + 1].from;
            found = sign;
            best = least;
        }
    }
    return found;
}

/* Looks at all pieces until two samples enclose a root or every piece is clear, by at most so many samples. */
static int survey@(Equation@ *f, const At@ places[4], int most, Look@ *look, Course *course)
{
    const int end = f->evaluations + most;
    Survey@ s;
    At@ at, ends[2];
    REAL sign;
    look->has_nearest = 0;
    look->falls = 0;
    begin@(&s, places);
    for (;;) { /* at most 3 * SAMPLES times */
        int index;
        REAL x, error;
        if (passage@(&s, 1.0@, look->ends)) {
            *course = look->ends[0].x == look->ends[1].x ? IS_ZERO : RISES;
            return 1;
        }
        index = widest@(&s);
        if (index < 0) {
            break;
        }
        if (f->evaluations >= end || s.count == SAMPLES) {
            *course = UNKNOWN_COURSE;
            return 1;
        }
        ends[0] = s.pieces[index].from;
        ends[1] = s.pieces[index + 1].from;
        sign = bends@(ends[0], ends[1], s.pieces[index].error);
        if (sign != 0.0@ && turns@(ends[0], ends[1], sign) && s.widest >= ends[1].x - ends[0].x) {
            const int allowed = remaining(end, f->evaluations);
            if (!lowest@(f, sign, ends[0], ends[1], dead_point_most@(remaining(allowed, 1)), &at)) {
                return 0;
            }
            if (at.value == 0.0@) {
                look->ends[0] = at;
                look->ends[1] = at;
                *course = IS_ZERO;
                return 1;
            }
            insert@(&s, index, at, 0.0@, 1);
            continue;
        }
        x = middle@(ends[0].x, ends[1].x);
        if (!(x > ends[0].x && ends[1].x > x)) {
            /* The ends are neighbouring numbers, so their signs say everything. */
            s.pieces[index].is_clear = 1;
            continue;
        }
        if (!evaluate@(f, x, &at)) {
            return 0;
        }
        error = error_of_halves@(ends[0], ends[1], at);
        insert@(&s, index, at, error, 0);
    }
    *course = NEVER_RISES;
    sign = nearest@(&s, ends);
    look->has_nearest = sign != 0.0@ && end > f->evaluations + 1;
    if (look->has_nearest) {
        const int allowed = remaining(end, f->evaluations);
        if (!lowest@(f, sign, ends[0], ends[1], dead_point_most@(remaining(allowed, 1)), &look->nearest)) {
            return 0;
        }
        if (0.0@ > sign * look->nearest.value) {
            *course = UNKNOWN_COURSE;
        }
    }
    look->falls = passage@(&s, -1.0@, look->ends);
    return 1;
}
