
/* Numbers with their conjugates, which are numbers of their own where a dyad does not assemble. */
typedef struct Twin@ {
    NUMBER of[2];
} Twin@;

/* z -> shift + turn z. */
typedef struct Motion@ {
    Twin@ shift;
    Twin@ turn;
} Motion@;

/* A dyad on its outer pins, on neither side yet: with its base B from U to V, its bars a and b, and
 * h = B B' + a a' - b b', its inner pin is U + B (h + s)/(2 B B'), where s^2 = h^2 - 4 a a' B B'. */
typedef struct Triangle@ {
    Twin@ outer[2];
    Twin@ span;
    NUMBER base;
    NUMBER along;
    NUMBER root;
    NUMBER part;
} Triangle@;

/* The bodies that are placed so far. What stands still has the first place. */
typedef struct Closing@ {
    const Placed *placed;
    Motion@ of[10];
    int assembles;
} Closing@;

static Twin@ twin@(NUMBER number)
{
    Twin@ made;
    made.of[0] = number;
    made.of[1] = conjugate@(number);
    return made;
}

static Twin@ twin_plus@(Twin@ a, Twin@ b)
{
    a.of[0] = plus@(a.of[0], b.of[0]);
    a.of[1] = plus@(a.of[1], b.of[1]);
    return a;
}

static Twin@ twin_minus@(Twin@ a, Twin@ b)
{
    a.of[0] = minus@(a.of[0], b.of[0]);
    a.of[1] = minus@(a.of[1], b.of[1]);
    return a;
}

static Twin@ twin_times@(Twin@ a, Twin@ b)
{
    a.of[0] = times@(a.of[0], b.of[0]);
    a.of[1] = times@(a.of[1], b.of[1]);
    return a;
}

/* The square of a vector's length. */
static NUMBER twin_square@(Twin@ a) { return times@(a.of[0], a.of[1]); }

static Twin@ pin@(const Closing@ *closing, LinkageBodyPin at)
{
    const Twin@ local = twin@(number@(pin_of(closing->placed, at)));
    const Motion@ *body = &closing->of[at.body];
    return at.body == STANDING ? local : twin_plus@(body->shift, twin_times@(body->turn, local));
}

/* Places a body by its turning and a pin. */
static void take@(Closing@ *closing, LinkageBodyPin at, Twin@ to, Twin@ turn)
{
    const Twin@ local = twin@(number@(pin_of(closing->placed, at)));
    closing->of[at.body].shift = twin_minus@(to, twin_times@(turn, local));
    closing->of[at.body].turn = turn;
}

/* The driven body at its angle. */
static void begin@(Closing@ *closing, const Placed *placed, NUMBER turn)
{
    LinkageBodyPin standing, on_body;
    standing.body = STANDING;
    standing.place = placed->kind->pivot[0];
    on_body.body = TURNED;
    on_body.place = placed->kind->pivot[1];
    closing->placed = placed;
    closing->assembles = 1;
    take@(closing, on_body, pin@(closing, standing), twin@(turn));
}

static Triangle@ triangle@(Closing@ *closing, const LinkageHungBar *bars)
{
    Triangle@ of;
    NUMBER squares[2], twice, both;
    int i;
    for (i = 0; i < 2; i++) {
        const Twin@ bar = twin@(number@(bar_of(closing->placed, &bars[i])));
        of.outer[i] = pin@(closing, bars[i].outer);
        squares[i] = twin_square@(bar);
    }
    of.span = twin_minus@(of.outer[1], of.outer[0]);
    of.base = twin_square@(of.span);
    of.along = minus@(plus@(of.base, squares[0]), squares[1]);
    twice = plus@(of.base, of.base);
    both = times@(plus@(squares[0], squares[0]), twice);
    of.root = root@(minus@(times@(of.along, of.along), both), &closing->assembles);
    of.part = inverse@(twice);
    return of;
}

/* Places the bars of a dyad on a side. */
static void assemble@(Closing@ *closing, const LinkageHungBar *bars, const Triangle@ *of, int is_left)
{
    const NUMBER sum = times@(plus@(of->along, of->root), of->part);
    const NUMBER difference = times@(minus@(of->along, of->root), of->part);
    Twin@ sides, ways[2];
    int i;
    sides.of[0] = is_left ? sum : difference;
    sides.of[1] = is_left ? difference : sum;
    ways[0] = twin_times@(of->span, sides);
    ways[1] = twin_minus@(ways[0], of->span);
    for (i = 0; i < 2; i++) {
        const Twin@ bar = twin@(number@(bar_of(closing->placed, &bars[i])));
        LinkageBodyPin at;
        Twin@ inverse;
        inverse.of[0] = inverse@(bar.of[0]);
        inverse.of[1] = inverse@(bar.of[1]);
        at.body = bars[i].body;
        at.place = bars[i].ends[0];
        take@(closing, at, of->outer[i], twin_times@(ways[i], inverse));
    }
}

/* The square of the distance of the equation's pins less that of the link's length. */
static NUMBER missed@(const Closing@ *closing)
{
    const LinkagePinned *kind = closing->placed->kind;
    const Twin@ apart = twin_minus@(pin@(closing, kind->equation[0]), pin@(closing, kind->equation[1]));
    const Twin@ length = twin@(number@(complex_of(closing->placed->length * closing->placed->scale, 0.0)));
    return minus@(twin_square@(apart), twin_square@(length));
}
