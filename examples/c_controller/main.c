/* The controller of a flying shear, in C alone: every millisecond it computes the motion of the blade from the crank's
 * angle, and turns the crank so that the blade goes with the strip while it cuts, and catches up in between.
 *
 *     cmake -B build && cmake --build build && build/shear
 *
 * or
 *
 *     cc -std=c99 -O2 -Isolver main.c solver/flying_shear.c solver/linkage_run.c -lm -o shear && ./shear */
#include <stdio.h>

#include "flying_shear.h"

#define PERIOD 0.001f     /* s */
#define STRIP 1.2f        /* m/s */
#define CUT_FROM 4.3f     /* rad, of the crank */
#define CUT_TO 5.1f       /* rad */
#define TURN 6.2831855f   /* rad */
#define CATCH_UP 20.0f    /* rad/s */
#define STEPS 2000

/* The crank's rate at an angle; the status of the solver. */
static LinkageStatus rate_at(float theta, float *rate, LinkageError *error)
{
    FlyingShearMotionF32 at_unit_rate;
    const LinkageStatus status = flying_shear_motion_f32(theta, 1.0f, 0.0f, &at_unit_rate, error);
    if (status != LINKAGE_OK) {
        return status;
    }
    *rate = CATCH_UP;
    if (theta >= CUT_FROM && theta <= CUT_TO) {
        /* The blade's velocity is the crank's rate times the one at a rate of one. */
        *rate = STRIP / at_unit_rate.velocity.blade.x;
    }
    return LINKAGE_OK;
}

int main(void)
{
    float theta = 0.0f, worst = 0.0f;
    int step, cuts = 0, is_cutting = 0;
    for (step = 0; step < STEPS; step++) {
        FlyingShearMotionF32 motion;
        LinkageError error;
        float rate = 0.0f, slip;
        if (rate_at(theta, &rate, &error) != LINKAGE_OK
            || flying_shear_motion_f32(theta, rate, 0.0f, &motion, &error) != LINKAGE_OK) {
            printf("status %d, group %.*s\n", (int)error.status, (int)error.group_length, error.group);
            return 1;
        }
        if (theta >= CUT_FROM && theta <= CUT_TO) {
            slip = motion.velocity.blade.x - STRIP;
            slip = slip < 0.0f ? -slip : slip;
            worst = slip > worst ? slip : worst;
            cuts += !is_cutting;
            is_cutting = 1;
        } else {
            is_cutting = 0;
        }
        theta += rate * PERIOD;
        theta -= theta >= TURN ? TURN : 0.0f;
    }
    printf("%d cuts in %g s, the blade within %.1g m/s of the strip\n", cuts, (double)(STEPS * PERIOD), (double)worst);
    return worst > 1e-5f;
}
