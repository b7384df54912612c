
/* The steepest slope of an end that may be a dead point, of which neither the place nor the value is known better
 * than to rounding. */
static REAL steepest@(At@ a, At@ b, REAL slack)
{
    const REAL size = greater@(absolute@(a.value), absolute@(b.value));
    return greater@(slack, size * LEAST_EPSILON) / ((b.x - a.x) * sqrt@(LEAST_EPSILON));
}

/* True if f misses zero at an end by this much, or passes it there against the trend. */
static int misses@(At@ end, REAL by, REAL steep) { return by > 0.0@ || (by == 0.0@ && -end.slope > steep); }

static int is_met@(At@ at, REAL slack, REAL steep) { return slack >= absolute@(at.value) && !(-at.slope > steep); }

/* The root where the ends, moved in or not, do not enclose one. `missed` is the nearer of them. */
static int surveyed@(Equation@ *f, const Approach@ *approach, const At@ places[4], At@ missed, REAL slack, int most, REAL *found)
{
    const REAL steep = steepest@(places[0], places[3], slack);
    Course course;
    Look@ look;
    if (!survey@(f, places, most, &look, &course)) {
        return 0;
    }
    switch (course) {
    case RISES: return bracketed@(f, look.ends[0], look.ends[1], approach, found);
    case IS_ZERO: *found = look.ends[0].x; return 1;
    case UNKNOWN_COURSE: return fail@(f, SEVERAL_DEAD_POINTS, 0.0@, 0.0@);
    case NEVER_RISES: break;
    default: break;
    }
    if (look.has_nearest && absolute@(missed.value) > absolute@(look.nearest.value)) {
        missed = look.nearest;
    }
    if (is_met@(missed, slack, steep)) {
        *found = missed.x;
        return 1;
    }
    if (look.falls) {
        const int left = remaining(2 + LEAST_MANT_DIG + SPARE, f->evaluations);
        if (!falls_through_zero@(f, look.ends[0], look.ends[1], left)) {
            return 0;
        }
    }
    return fail@(f, NO_ROOT, missed.x, absolute@(missed.value));
}

/* True if a function whose slope keeps its sign rises between these ends on one side of zero. */
static int rises_without_a_root@(At@ a, At@ b)
{
    return b.value > a.value && ((a.value > 0.0@ && a.slope >= 0.0@) || (0.0@ > b.value && b.slope >= 0.0@));
}

/* The root from both ends. */
static int from_ends@(Equation@ *f, const Approach@ *approach, int is_steady, REAL *found)
{
    int most = LEAST_MANT_DIG + SPARE, misses_a, misses_b;
    At@ first, last, ends[2];
    REAL slack, steep;
    if (!evaluate@(f, approach->from, &first) || !evaluate@(f, approach->to, &last)) {
        return 0;
    }
    ends[0] = first;
    ends[1] = last;
    slack = greater@(greater@(absolute@(first.value), absolute@(last.value)), f->extent) * (4.0@ * LEAST_EPSILON);
    if (first.value >= 0.0@ && 0.0@ > first.slope && !move_in@(f, ends, 0, &most)) {
        return 0;
    }
    if (0.0@ >= last.value && 0.0@ > last.slope && !move_in@(f, ends, 1, &most)) {
        return 0;
    }
    steep = steepest@(first, last, slack);
    misses_a = misses@(ends[0], ends[0].value, steep);
    misses_b = misses@(ends[1], -ends[1].value, steep);
    if (!misses_a && !misses_b) {
        if (ends[0].value == 0.0@ || ends[1].value == 0.0@) {
            *found = ends[0].value == 0.0@ ? ends[0].x : ends[1].x;
            return 1;
        }
        return bracketed@(f, ends[0], ends[1], approach, found);
    }
    {
        const int is_upper = !misses_a || (misses_b && ends[0].value > -ends[1].value);
        const At@ missed = ends[is_upper];
        At@ places[4];
        if (is_met@(missed, slack, steep)) {
            *found = missed.x;
            return 1;
        }
        if (is_steady && rises_without_a_root@(first, last)) {
            return fail@(f, NO_ROOT, missed.x, absolute@(missed.value));
        }
        places[0] = first;
        places[1] = ends[0];
        places[2] = ends[1];
        places[3] = last;
        return surveyed@(f, approach, places, missed, slack, most, found);
    }
}

/* The root by a seed, where Newton's method converges from there. */
static int from_seed@(Equation@ *f, const Approach@ *approach, REAL seed, int *is_found, REAL *found)
{
    At@ end;
    REAL change;
    *is_found = newton@(f, seed, approach, found);
    change = f->change;
    /* A seed that is the root at once, on sides near zero, tells nothing of their size. */
    if (*is_found && change > f->extent && !evaluate@(f, approach->from, &end)) {
        return 0;
    }
    f->change = change;
    return 1;
}

int linkage_root@(LinkageWhy *why, const char *unknown, const LinkageBetween@ *between, LinkageSides@ sides, const REAL *given, REAL *found)
{
    Equation@ f = { NULL, NULL, 0.0@, 0, 0.0@, 0.0@, 0.0@, NO_INTERVAL, 0.0@, 0.0@ };
    Approach@ approach;
    int is_found = 0, goes_on = approach_of@(&approach, between->from, between->to);
    f.sides = sides;
    f.given = given;
    f.trend = between->trend;
    f.width = approach.to - approach.from;
    if (goes_on && between->is_turn && is_beyond_a_turn(between->from, between->to, LEAST_EPSILON)) {
        goes_on = 0;
    }
    if (goes_on && between->has_seed) {
        goes_on = from_seed@(&f, &approach, between->seed, &is_found, &found[0]);
    }
    if (goes_on && !is_found) {
        is_found = from_ends@(&f, &approach, between->is_steady, &found[0]);
        goes_on = is_found;
    }
    if (goes_on && !linkage_is_finite@(found[0])) {
        goes_on = fail@(&f, SINGULAR_ROOT, found[0], 0.0@);
    }
    if (goes_on) {
        found[1] = f.extent + f.change;
        return 1;
    }
    if (why != NULL && why->goes_on) {
        /* An equation is not a number where a group of its own has no pose, too. */
        found[0] = (REAL)(f.failure == NO_ROOT || f.failure == NOT_A_NUMBER ? why->stand_in : (LinkageWide)NAN);
        found[1] = 1.0@;
        return 0;
    }
    if (why != NULL) {
        refuse_root(why, f.failure, unknown, f.by, between->to > between->from);
    }
    /* The formulas go on with a trial at which the equation is no number, and find who is to blame. */
    found[0] = f.failure == NOT_A_NUMBER ? f.at : 0.0@;
    found[1] = 0.0@;
    return 0;
}
