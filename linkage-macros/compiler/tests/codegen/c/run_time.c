/* Calls of the run-time, for the test beside: reads a number that says which, whether in single precision, and
 * nine operands; writes a status, what is missing, and two results. */
#include "linkage_run.h"

#include <stdio.h>

typedef struct Call {
    int32_t which;
    int32_t is_single;
    double x[9];
} Call;

typedef struct Answer {
    double status;
    double by;
    double y[2];
} Answer;

#define NEAR_ linkage_angle_near
#define NEAR_f linkage_angle_near_f32

#define OF_WIDTH(width, number)                                                                                     \
    static void number##s(const Call *call, Answer *to)                                                             \
    {                                                                                                               \
        number x[4], y[2] = { 0, 0 };                                                                               \
        int i;                                                                                                      \
        for (i = 0; i < 4; i++) {                                                                                   \
            x[i] = (number)call->x[i];                                                                              \
        }                                                                                                           \
        switch (call->which) {                                                                                      \
        case 0: linkage_sin_cos_near##width(x[0], &y[0], &y[1]); break;                                             \
        case 1: linkage_sin_cos##width(x[0], &y[0], &y[1]); break;                                                  \
        case 2: y[0] = linkage_asin##width(x[0]); break;                                                            \
        case 3: y[0] = linkage_acos##width(x[0]); break;                                                            \
        case 4: y[0] = linkage_atan##width(x[0]); break;                                                            \
        case 5: y[0] = linkage_atan2##width(x[0], x[1]); break;                                                     \
        case 6: y[0] = linkage_hypot##width(x[0], x[1]); break;                                                     \
        case 7: y[0] = linkage_det##width(x[0], x[1], x[2], x[3]); break;                                           \
        case 8: y[0] = linkage_mul_err##width(x[0], x[1]); break;                                                   \
        case 9: y[0] = linkage_add_err##width(x[0], x[1]); break;                                                   \
        case 10: y[0] = linkage_fused##width(x[0], x[1], x[2]); break;                                              \
        case 11: to->status = linkage_is_near##width(x[0]); break;                                                  \
        case 12: to->status = linkage_on_circle##width(x[0], x[1], &y[0], &y[1]); break;                            \
        case 13: to->status = linkage_hypot_near##width(x[0], x[1], x[2], &y[0]); break;                            \
        case 14: y[0] = linkage_select##width(x[0], x[1], x[2], x[3]); break;                                       \
        case 15: y[0] = linkage_exp##width(x[0]); break;                                                            \
        case 16: y[0] = linkage_ln##width(x[0]); break;                                                             \
        case 17: y[0] = linkage_tanh##width(x[0]); break;                                                           \
        case 19: y[0] = NEAR_##width(x[0], x[1], x[2]); break;                                                       \
        case 18: y[0] = linkage_pow##width(x[0], x[1]); break;                                                      \
        default: break;                                                                                             \
        }                                                                                                           \
        to->y[0] = (double)y[0];                                                                                    \
        to->y[1] = (double)y[1];                                                                                    \
    }
OF_WIDTH(, double)
OF_WIDTH(f, float)

static void conditions(const Call *call, Answer *to)
{
    LinkageWhy why = linkage_why(call->is_single);
    const double *x = call->x;
    switch (call->which) {
    case 20: to->y[0] = linkage_reach_circles(&why, x[0], x[1], x[2], x[3], x[4], x[5], x[6], "group"); break;
    case 21: to->y[0] = linkage_share_of_centres(&why, x[0], x[1], x[2], x[3], x[4], x[5], x[6], "group"); break;
    case 22: to->y[0] = linkage_reach_distances(&why, x[0], x[1], x[2], x[3], x[4], "group"); break;
    case 23: to->y[0] = linkage_square_of_centres(&why, x[0], x[1], x[2], x[3], x[4], "group"); break;
    case 24: to->y[0] = linkage_reach_line(&why, x[0], x[1], x[2], "group"); break;
    case 25: to->y[0] = linkage_reach_offset(&why, x[0], x[1], x[2], x[3], "group"); break;
    case 26: to->y[0] = linkage_nonzero(&why, x[0], "group"); break;
    case 27: to->y[0] = linkage_positive(&why, x[0], "group", "name"); break;
    case 28: to->y[0] = linkage_not_negative(&why, x[0], "group", "name"); break;
    case 29: to->y[0] = linkage_square(&why, x[0], "group"); break;
    case 30: to->y[0] = linkage_moving(&why, x[0], x[1], "group"); break;
    case 32: to->y[0] = linkage_certified(&why, x[0], "group"); break;
    case 31: {
        const LinkageNamed given[3] = { { x[0], "0" }, { x[1], "1" }, { x[2], "2" } }, result = { x[3], "3" };
        linkage_given_finite(&why, given, 3);
        linkage_results_finite(&why, &result, 1, given, 3);
        to->y[1] = why.name == NULL ? -1.0 : (double)(why.name[0] - '0');
        break;
    }
    default: break;
    }
    to->status = why.status;
    if (why.status != LINKAGE_OK) {
        to->y[0] = 0.0; /* a refused value means nothing */
    }
    to->by = why.by;
}

/* Who is to blame, as a number: a group, a name, or the unknown where nothing else is wrong. */
static double blamed(const LinkageWhy *why)
{
    if (why->status == LINKAGE_OK) {
        return strcmp(why->otherwise, "x") == 0 ? -3.0 : -30.0;
    }
    if (why->name == NULL) {
        return strcmp(why->group, "x") == 0 ? -1.0 : -20.0;
    }
    if (why->group == NULL) {
        return strcmp(why->name, "x") == 0 ? -2.0 : 0.0;
    }
    return strcmp(why->name, "ends of between") == 0 ? -4.0 : strcmp(why->name, "width of between") == 0 ? -5.0 : 0.0;
}

/* How often an equation was evaluated. */
static int trials = 0;

/* A sum of Chebyshev's polynomials, or what the kind makes of it: level, five coefficients, and the kind. */
#define SIDES_OF_WIDTH(width, number)                                                                               \
    static void number##_sides(const number *c, number x, number *sides)                                            \
    {                                                                                                               \
        const number square = x * x, one = 1;                                                                       \
        const number sum = c[1] * x + c[2] * (2 * square - one) + c[3] * (4 * square - 3) * x                       \
            + c[4] * (8 * square * (square - one) + one) + c[5] * ((16 * square - 20) * square + 5) * x;            \
        const number slope = c[1] + c[2] * 4 * x + c[3] * (12 * square - 3) + c[4] * (32 * square - 16) * x         \
            + c[5] * ((80 * square - 60) * square + 5);                                                             \
        trials++;                                                                                                   \
        sides[0] = sum;                                                                                             \
        sides[1] = c[0];                                                                                            \
        sides[2] = slope;                                                                                           \
        switch ((int)c[6]) {                                                                                        \
        case 1: sides[0] = sum * sum; sides[2] = (sum + sum) * slope; break;                                        \
        case 2: sides[0] = sum > (number)0.8 ? (number)NAN : sum; break;                                            \
        case 3: sides[0] = sum > 0 ? one : -one; sides[2] = 0; break;                                               \
        case 4: sides[2] = sum > c[0] ? (number)HUGE_VAL : slope; break;                                            \
        case 5: {                                                                                                   \
            const number bound = (number)0.05 + (sum >= 0 ? sum : -sum);                                            \
            sides[0] = sum / bound;                                                                                 \
            sides[2] = (number)0.05 * slope / (bound * bound);                                                      \
            break;                                                                                                  \
        }                                                                                                           \
        case 6: {                                                                                                   \
            const number off = sum - c[0], size = c[0] >= 0 ? c[0] : -c[0];                                         \
            sides[0] = (number)0.01 * size > (off >= 0 ? off : -off) ? (number)NAN : sum;                           \
            break;                                                                                                  \
        }                                                                                                           \
        case 9: sides[0] = x * x > (number)1e-4 && (number)1.5e-2 > x * x ? (number)NAN : sum; break;               \
        case 7: case 8: {                                                                                           \
            number wave = x, rate = one;                                                                            \
            int i;                                                                                                  \
            for (i = 0; i < (c[6] < (number)7.5 ? 4 : 6); i++) {                                                    \
                rate = 4 * wave * rate;                                                                             \
                wave = 2 * wave * wave - one;                                                                       \
            }                                                                                                       \
            sides[0] = c[1] * wave + c[2] * x;                                                                      \
            sides[2] = c[1] * rate + c[2];                                                                          \
            break;                                                                                                  \
        }                                                                                                           \
        default: break;                                                                                             \
        }                                                                                                           \
    }                                                                                                               \
    static void number##_root(const Call *call, Answer *to)                                                         \
    {                                                                                                               \
        const int which = call->which - 40;                                                                         \
        const number from = (number)call->x[0], end = (number)call->x[1];                                           \
        LinkageWhy why = linkage_why(call->is_single);                                                              \
        LinkageBetween##width between = { 0, 0, 0, 0, 0, 0, 0 };                                                    \
        number given[7], found[2];                                                                                  \
        int i, is_found;                                                                                            \
        for (i = 0; i < 7; i++) {                                                                                   \
            given[i] = (number)call->x[i + 2];                                                                      \
        }                                                                                                           \
        between.from = from;                                                                                        \
        between.to = end;                                                                                           \
        between.trend = (number)((which & 1) != 0 ? -1 : 1);                                                        \
        between.has_seed = (which & 2) != 0;                                                                        \
        between.seed = from + (end - from) * (number)0.25;                                                          \
        between.is_turn = (which & 4) != 0;                                                                         \
        between.is_steady = (which & 32) != 0;                                                                      \
        if ((which & 8) != 0) {                                                                                     \
            why.status = LINKAGE_SINGULAR;                                                                          \
            why.group = "earlier";                                                                                  \
        }                                                                                                           \
        if ((which & 16) != 0) {                                                                                    \
            why.otherwise = "earlier";                                                                              \
        }                                                                                                           \
        trials = 0;                                                                                                 \
        is_found = linkage_root##width(&why, "x", &between, number##_sides, given, found);                          \
        to->status = why.status == LINKAGE_OK && why.otherwise != NULL ? LINKAGE_NOT_FINITE : why.status;           \
        to->by = why.by;                                                                                            \
        to->y[0] = (double)found[0];                                                                                \
        to->y[1] = (which & 64) != 0 ? (double)trials : is_found ? (double)found[1] : blamed(&why);                 \
    }
SIDES_OF_WIDTH(, double)
SIDES_OF_WIDTH(f, float)

static void root(const Call *call, Answer *to)
{
    if (call->is_single) {
        float_root(call, to);
    } else {
        double_root(call, to);
    }
}

int main(void)
{
    Call call;
    while (fread(&call, sizeof call, 1, stdin) == 1) {
        Answer answer = { 0.0, 0.0, { 0.0, 0.0 } };
        if (call.which >= 40) {
            root(&call, &answer);
        } else if (call.which >= 20) {
            conditions(&call, &answer);
        } else if (call.is_single) {
            floats(&call, &answer);
        } else {
            doubles(&call, &answer);
        }
        if (fwrite(&answer, sizeof answer, 1, stdout) != 1) {
            return 1;
        }
    }
    return 0;
}
