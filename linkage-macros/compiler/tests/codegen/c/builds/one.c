/* The answers of one build: compiled with the names of its run-time and of its function, RUN and ANSWER. */
#include "one.h"

#include <stdio.h>

static const char *const joints[MOST] = { "0", "1", "2", "3", "4", "5", "6", "7" };

/* A wave, of which the last number makes steps. */
static void sides(const float *c, float x, float *to)
{
    const float square = x * x;
    to[0] = c[0] * x + c[1] * (2.0f * square - 1.0f) + c[2] * (4.0f * square - 3.0f) * x;
    to[1] = c[3];
    to[2] = c[0] + c[1] * 4.0f * x + c[2] * (12.0f * square - 3.0f);
}

static float condition(LinkageWhy *why, const Call *call)
{
    const float *const x = call->x;
    LinkageNamed given[3], result;
    int i;
    switch (call->kind) {
    case CIRCLES: return (float)RUN(reach_circles)(why, x[0], x[1], x[2], x[3], x[4], x[5], x[6], "group");
    case SHARE: return (float)RUN(share_of_centres)(why, x[0], x[5], x[1], x[2], x[3], x[4], x[6], "group");
    case DISTANCES: return (float)RUN(reach_distances)(why, x[0], x[1], x[3], x[4], x[6], "group");
    case SQUARE_OF_CENTRES: return (float)RUN(square_of_centres)(why, x[0], x[1], x[2], x[3], x[4], "group");
    case LINE: return (float)RUN(reach_line)(why, x[0], x[1], x[3], "group");
    case OFFSET: return (float)RUN(reach_offset)(why, x[0], x[1], x[2], x[3], "group");
    case MOVING: return (float)RUN(moving)(why, x[0], x[6], "group");
    case SQUARE: return (float)RUN(square)(why, x[0], "group");
    case CLOSED: return (float)RUN(closed)(why, x[0], x[6], "unknown");
    case BLAMED:
        for (i = 0; i < 3; i++) {
            given[i].value = x[i];
            given[i].name = joints[i];
        }
        result.value = x[3];
        result.name = joints[3];
        RUN(given_finite)(why, given, 3);
        if (why->status == LINKAGE_OK) {
            RUN(results_finite)(why, &result, 1, given, 3);
        }
        return 0.0f;
    default: return 0.0f;
    }
}

static void friction(LinkageWhy *why, const Call *call, Answer *to)
{
    to->count = call->count;
    RUN(frictionf)(why, joints, call->count, call->guides, call->x, call->x + PLACES, to->y);
}

static void root(LinkageWhy *why, const Call *call, Answer *to)
{
    LinkageBetweenf between;
    between.from = call->x[0];
    between.to = call->x[1];
    between.trend = call->x[2];
    between.seed = call->x[3];
    between.has_seed = (call->guides & 1u) != 0u;
    between.is_turn = (call->guides & 2u) != 0u;
    to->count = 2;
    to->y[1] = 0.0f;
    (void)RUN(rootf)(why, "x", &between, sides, call->x + 4, to->y);
}

void ANSWER(const Call *call, Answer *to)
{
    LinkageWhy why = RUN(why)(1);
    LinkageError error = { 0, 0.0, NULL, 0, NULL, 0 };
    memset(to, 0, sizeof *to);
    to->count = 1;
    switch (call->kind) {
    case ANGLE:
        to->count = 2;
        RUN(sin_cosf)(call->x[0], &to->y[0], &to->y[1]);
        break;
    case LENGTH: to->y[0] = RUN(hypotf)(call->x[0], call->x[1]); break;
    case NEAR: to->y[0] = RUN(angle_near_f32)(call->x[0], call->x[1], call->x[2]); break;
    case ROOT: root(&why, call, to); break;
    case FRICTION: friction(&why, call, to); break;
    default: to->y[0] = condition(&why, call); break;
    }
    (void)RUN(refused)(&why, &error);
    to->status = error.status;
    to->by = error.by;
    (void)snprintf(to->who[0], sizeof to->who[0], "%.*s", (int)error.group_length, error.group == NULL ? "" : error.group);
    (void)snprintf(to->who[1], sizeof to->who[1], "%.*s", (int)error.name_length, error.name == NULL ? "" : error.name);
    (void)snprintf(to->who[2], sizeof to->who[2], "%s", why.otherwise == NULL ? "" : why.otherwise);
    if (error.status != LINKAGE_OK && call->kind != ROOT) {
        to->count = 0; /* a refused value means nothing */
    }
}
