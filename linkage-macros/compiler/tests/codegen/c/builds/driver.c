/* Calls both builds as often as its argument says, by kinds in turn: numbers some last places beside a limit, at sizes from
 * 1e-18 to 1e18, some of them zero, infinite or none. Prints a line a kind: how often it answered and refused, and how
 * many answers have other bits. Ends with 1 where a status, a blame or more than a last place differs. */
#include "one.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const names[KINDS] = { "circles", "share", "distances", "centres", "line", "offset", "moving", "square",
    "blamed", "closed", "angle", "length", "near", "root", "friction" };

static uint64_t state = 88172645463325252u;

static uint64_t bits(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state >> 11;
}

static unsigned below(unsigned count) { return (unsigned)(bits() % count); }

static double unit(void) { return (double)(bits() & 0xfffffffffffu) * 0x1p-44; }

/* Of either sign, and of so many binades on both sides of one. */
static double number(double binades)
{
    const double size = exp2((2.0 * unit() - 1.0) * binades);
    return below(2) == 0 ? size : -size;
}

static float odd(void)
{
    static const float numbers[] = { 0.0f, -0.0f, NAN, INFINITY, -INFINITY, FLT_MAX, FLT_MIN, 0x1p-149f, -0x1.8p-140f, 1e30f, -1e-30f, 0x1p-63f };
    return numbers[below(sizeof numbers / sizeof numbers[0])];
}

/* Up to eight last places away. */
static double beside(double x)
{
    const double places = (double)below(17) - 8.0;
    return x == 0.0 ? 0.0 : x + places * ldexp(FLT_EPSILON, ilogb(x));
}

/* Two lengths, the distance of their ends beside a limit, and a value that may have lost its sign. */
static void circles(Call *call)
{
    const double size = number(60.0), spread = number(below(4) == 0 ? 60.0 : 2.0);
    const double l1 = (float)(size * number(2.0)), l2 = below(8) == 0 ? l1 : (float)(size * number(below(8) == 0 ? 40.0 : 2.0));
    const double limit = below(2) == 0 ? fabs(l1) + fabs(l2) : fabs(fabs(l1) - fabs(l2));
    const double d = below(6) == 0 ? 2.0 * unit() * limit : beside(limit), turn = 6.283185307179586 * unit();
    const int is_along = below(3) == 0, is_planted = below(4) == 0;
    call->x[0] = (float)(below(6) == 0 ? number(60.0) : number(3.0) * FLT_EPSILON * size * (below(2) == 0 ? 1.0 : size));
    call->x[1] = (float)(is_along ? d : d * cos(turn));
    call->x[2] = (float)(is_along ? (below(4) == 0 ? d * number(70.0) : 0.0) : d * sin(turn));
    if (is_planted) {
        /* A right triangle of integers, of which both limits are exact. */
        const double scale = exp2(floor(log2(fabs(size))) - 2.0);
        call->x[1] = (float)beside(3.0 * scale);
        call->x[2] = (float)beside(4.0 * scale);
        call->x[3] = (float)beside((below(2) == 0 ? 2.0 : 9.0) * scale);
        call->x[4] = (float)beside((below(2) == 0 ? 3.0 : 4.0) * scale);
        if (below(2) == 0) {
            /* At the end of what rounding allows, to the last bit. */
            const double slack = scale * 0x1p-19;
            call->x[1] = (float)(3.0 * scale);
            call->x[2] = (float)(4.0 * scale);
            call->x[3] = (float)((below(2) == 0 ? 2.0 : 8.0) * scale);
            call->x[4] = (float)(3.0 * scale + (below(2) == 0 ? slack : -slack) * (double)below(3));
        }
    } else {
        call->x[3] = (float)l1;
        call->x[4] = (float)l2;
    }
    call->x[5] = (float)(below(3) == 0 ? 1.0 : below(2) == 0 ? 2.0 * l1 * l2 : size);
    call->x[6] = (float)(spread * (below(3) == 0 ? 1.0 : size * size));
    if (call->kind == DISTANCES) {
        call->x[1] = (float)d;
    }
    if (call->kind == LINE) {
        call->x[1] = (float)beside(l1);
    }
    if (call->kind == OFFSET && !is_planted) {
        call->x[3] = (float)beside(hypot((double)call->x[1], (double)call->x[2]));
    }
}

/* Numbers beside the thresholds of the smaller conditions. */
static void sizes(Call *call)
{
    const double spread = number(60.0);
    call->x[6] = (float)(call->kind == CLOSED ? fabs(spread) : spread);
    switch (call->kind) {
    case MOVING: call->x[0] = (float)beside(16.0 * FLT_EPSILON * fabs(spread)); break;
    case CLOSED: call->x[0] = (float)beside(0.022097087f * fabs(spread)); break;
    case SQUARE: call->x[0] = (float)(below(2) == 0 ? beside(0x1p-80) : number(120.0)); break;
    default:
        call->x[0] = (float)beside(below(2) == 0 ? 0x1p32 : number(40.0));
        call->x[1] = (float)beside(0x1p32);
        call->x[2] = (float)number(33.0);
        call->x[3] = below(2) == 0 ? NAN : below(2) == 0 ? INFINITY : 1.0f;
        break;
    }
}

static void angles(Call *call)
{
    const double turn = 6.283185307179586 * unit();
    const uint32_t any = (uint32_t)bits();
    switch (call->kind) {
    case ANGLE: memcpy(&call->x[0], &any, sizeof any); break;
    case LENGTH:
        call->x[0] = (float)number(140.0);
        call->x[1] = (float)(below(4) == 0 ? number(140.0) : (double)call->x[0] * number(26.0));
        break;
    default:
        call->x[0] = (float)cos(turn);
        call->x[1] = (float)sin(turn);
        call->x[2] = (float)(below(4) == 0 ? number(120.0) : below(2) == 0 ? (unit() - 0.5) * 1e4 : beside(turn + 3.141592653589793 * ((double)below(9) - 4.0)));
        break;
    }
}

/* A cubic between two ends that are about a turn apart, or any. */
static void root(Call *call)
{
    const double from = (double)(float)(below(2) == 0 ? (unit() - 0.5) * 12.0 : number(60.0));
    const int is_turn = below(2) == 0;
    int i;
    call->guides = below(2) | (is_turn ? 2u : 0u);
    call->x[0] = (float)from;
    call->x[1] = (float)(is_turn ? beside(from + 6.283185307179586 + (below(2) == 0 ? FLT_EPSILON * (2.0 * fabs(from) + 6.283185307179586) : 0.0)) : from + fabs(number(4.0) * from));
    call->x[2] = below(2) == 0 ? 1.0f : -1.0f;
    call->x[3] = (float)(from + ((double)call->x[1] - from) * unit());
    for (i = 4; i < 8; i++) {
        call->x[i] = (float)(number(3.0) / (i == 7 ? 1.0 : fabs(from) + 1.0));
    }
}

/* How much friction feeds on itself: an upper bound of the spectral radius, the largest growth of a component. */
static double growth(const Call *call)
{
    const int width = 3 + 2 * call->count;
    double vector[MOST], largest = 0.0;
    int j, k, step;
    for (j = 0; j < call->count; j++) {
        vector[j] = 1.0;
    }
    for (step = 0; step < 40; step++) {
        double grown[MOST];
        largest = 0.0;
        for (j = 0; j < call->count; j++) {
            const float *const row = call->x + j * width;
            grown[j] = 0.0;
            for (k = 0; k < call->count; k++) {
                const double x = fabs((double)row[3 + 2 * k]), y = fabs((double)row[4 + 2 * k]);
                grown[j] += (double)row[0] * vector[k] * ((call->guides >> j & 1u) != 0 ? fmax(x, y) : hypot(x, y));
            }
            largest = fmax(largest, grown[j] / vector[j]);
        }
        for (j = 0; j < call->count; j++) {
            vector[j] = fmax(grown[j] / largest, 1e-30);
        }
    }
    return largest;
}

/* A system whose growth is far below one, or one within some last places. */
static void friction(Call *call)
{
    const double size = number(60.0), radius = below(2) == 0 ? 0.1 * (double)(1u + below(9)) : 1.0;
    double largest;
    int j, k, width;
    call->count = 1 + (int)below(MOST);
    call->guides = below(1u << MOST);
    width = 3 + 2 * call->count;
    for (j = 0; j < call->count; j++) {
        float *const row = call->x + j * width;
        row[0] = (float)unit();
        row[1] = (float)(size * (2.0 * unit() - 1.0));
        row[2] = (float)(size * (2.0 * unit() - 1.0));
        for (k = 0; k < call->count; k++) {
            row[3 + 2 * k] = (float)(2.0 * unit() - 1.0);
            row[4 + 2 * k] = (float)(2.0 * unit() - 1.0);
        }
    }
    largest = growth(call);
    for (j = 0; j < call->count; j++) {
        float *const row = call->x + j * width;
        const double x = fabs((double)row[1]), y = fabs((double)row[2]);
        row[0] = (float)beside((double)row[0] * radius / largest);
        call->x[PLACES + j] = (float)((double)row[0] * ((call->guides >> j & 1u) != 0 ? fmax(x, y) : hypot(x, y)));
    }
}

static void draw(Call *call)
{
    memset(call->x, 0, sizeof call->x);
    call->count = 0;
    call->guides = 0;
    switch (call->kind) {
    case CIRCLES: case SHARE: case DISTANCES: case SQUARE_OF_CENTRES: case LINE: case OFFSET: circles(call); break;
    case ANGLE: case LENGTH: case NEAR: angles(call); break;
    case ROOT: root(call); break;
    case FRICTION: friction(call); break;
    default: sizes(call); break;
    }
    if (below(50) == 0) {
        call->x[below(7)] = odd();
    }
    if (call->kind < MOVING) {
        call->x[6] = fabsf(call->x[6]); /* a spread is a sum of sizes */
    }
    if (call->kind == FRICTION) {
        /* And so is a share, which is none or makes something of a reaction. */
        call->x[0] = fabsf(call->x[0]);
        call->x[0] = call->x[0] > 0.0f && 1e-30f > call->x[0] ? 0.0f : call->x[0];
    }
}

/* How many last places apart; many where one is no number. */
static double places(float a, float b)
{
    if (memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b) || (a == b)) {
        return 0.0;
    }
    if (!isfinite(a) || !isfinite(b)) {
        return 1e9;
    }
    return fabs((double)a - (double)b) / ldexp(FLT_EPSILON, ilogb(fmax(fabs((double)a), (double)FLT_MIN)));
}

static int same(const Call *call, const Answer *a, const Answer *b, long *others)
{
    double worst = 0.0;
    int i;
    if (a->status != b->status || memcmp(a->who, b->who, sizeof a->who) != 0 || a->count != b->count) {
        return 0;
    }
    for (i = 0; i < a->count; i++) {
        const double apart = places(a->y[i], b->y[i]);
        *others += apart > 0.0;
        worst = fmax(worst, apart);
    }
    if (fabs(a->by - b->by) > 1e-6 * fabs(a->by) + 0x1p-149 && !(a->by >= FLT_MAX && b->by >= FLT_MAX)) {
        return 0;
    }
    /* Pairs are right to some 2^-46 of amounts, which grows as they do next to a joint that jams. */
    return worst <= 1.0 + (call->kind == FRICTION ? 0x1p-17 / fabs(1.0 - growth(call)) : 0.0);
}

static void print(const Call *call, const Answer *a, const Answer *b)
{
    int i;
    printf("%s: status %d and %d, by %.9g and %.9g, %s/%s/%s and %s/%s/%s, %.9g %.9g and %.9g %.9g\n", names[call->kind], (int)a->status,
        (int)b->status, a->by, b->by, a->who[0], a->who[1], a->who[2], b->who[0], b->who[1], b->who[2], (double)a->y[0], (double)a->y[1], (double)b->y[0], (double)b->y[1]);
    for (i = 0; i < 12; i++) {
        printf(" %a", (double)call->x[i]);
    }
    printf(" count %d guides %u\n", call->count, call->guides);
}

int main(int count, char **arguments)
{
    const long calls = count > 1 ? atol(arguments[1]) / KINDS : 1000;
    long wrong = 0;
    int kind;
    for (kind = 0; kind < KINDS; kind++) {
        long answered = 0, refused = 0, others = 0, i;
        for (i = 0; i < calls; i++) {
            Answer wide, single;
            Call call;
            call.kind = (Kind)kind;
            draw(&call);
            in_wide(&call, &wide);
            in_single(&call, &single);
            answered += wide.status == 0;
            refused += wide.status != 0;
            if (!same(&call, &wide, &single, &others) && wrong++ < 20) {
                print(&call, &wide, &single);
            }
        }
        printf("%s %ld answered %ld refused %ld of other bits\n", names[kind], answered, refused, others);
    }
    return wrong != 0;
}
