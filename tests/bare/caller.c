/* Calls the solvers from C and prints every answer bit by bit, for `c_caller.rs` to compare
 * with what Rust computes. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "flying_shear.h"
#include "watt_six_bar.h"
#include "tuned_four_bar.h"
#include "excavator.h"
#include "heavy_press.h"
#include "heavy_robot.h"
#include "searched_press.h"

/* What an answer holds before the call, and has to hold after a call that fails. */
#define UNTOUCHED 0xa5

/* An error before the call, which a call that answers leaves alone. */
#define UNTOLD { 0, 0.0, NULL, 0, NULL, 0 }

static void report(const char *name, LinkageStatus status, const LinkageError *error,
                   const void *answer, size_t size)
{
    const unsigned char *bytes = answer;
    unsigned char by[sizeof(double)];
    memcpy(by, &error->by, sizeof by);
    printf("%s %d %d ", name, (int)status, (int)error->status);
    for (size_t i = 0; i < sizeof by; i++)
        printf("%02x", by[i]);
    printf(" [%.*s] [%.*s] ", (int)error->group_length, error->group ? error->group : "",
           (int)error->name_length, error->name ? error->name : "");
    for (size_t i = 0; i < size; i++)
        printf("%02x", bytes[i]);
    printf("\n");
}

#define CALL(function, type, ...)                                                 \
    do {                                                                          \
        type answer;                                                              \
        LinkageError error = UNTOLD;                                              \
        memset(&answer, UNTOUCHED, sizeof answer);                                \
        LinkageStatus status = function(__VA_ARGS__, &answer, &error);            \
        report(#function, status, &error, &answer, sizeof answer);                \
    } while (0)

#define COEFFICIENTS(function, number, rows, columns, ...)                        \
    do {                                                                          \
        number answer[rows][columns];                                             \
        LinkageError error = UNTOLD;                                              \
        memset(answer, UNTOUCHED, sizeof answer);                                 \
        LinkageStatus status = function(__VA_ARGS__, answer, &error);             \
        report(#function, status, &error, answer, sizeof answer);                 \
    } while (0)

#define LIST(function, number, count, ...)                                        \
    do {                                                                          \
        number answer[count];                                                     \
        LinkageError error = UNTOLD;                                              \
        memset(answer, UNTOUCHED, sizeof answer);                                 \
        LinkageStatus status = function(__VA_ARGS__, answer, &error);             \
        report(#function, status, &error, answer, sizeof answer);                 \
    } while (0)

static void press(double theta, double work, double friction)
{
    const HeavyPress parameters = heavy_press_default();
    const HeavyPressF32 narrow_parameters = heavy_press_default_f32();
    const HeavyPressLoads loads = { work, friction };
    const HeavyPressLoadsF32 narrow = { (float)work, (float)friction };
    CALL(heavy_press_forces, HeavyPressForces, &parameters, theta, 3.0, -2.0, &loads);
    CALL(heavy_press_statics, HeavyPressForces, &parameters, theta, &loads);
    CALL(heavy_press_energy, HeavyPressEnergy, &parameters, theta, 3.0);
    CALL(heavy_press_forces_f32, HeavyPressForcesF32, &narrow_parameters, (float)theta, 3.0f, -2.0f,
         &narrow);
    CALL(heavy_press_forward_dynamics, double, &parameters, theta, 3.0, 1.5, &loads);
    CALL(heavy_press_equations_of_motion, HeavyPressEquations, &parameters, theta, 3.0, &loads);
}

static void robot(double first, double second)
{
    const HeavyRobotInput inputs = { first, second }, rates = { 0.5, -0.25 };
    const HeavyRobotInputF32 narrow = { (float)first, (float)second }, speeds = { 0.5f, -0.25f };
    const double drive[HEAVY_ROBOT_INPUTS] = { 2.0, -1.0 };
    const float push[HEAVY_ROBOT_INPUTS] = { 2.0f, -1.0f };
    LIST(heavy_robot_forward_dynamics, double, HEAVY_ROBOT_INPUTS, &inputs, &rates, drive);
    CALL(heavy_robot_equations_of_motion, HeavyRobotEquations, &inputs, &rates);
    LIST(heavy_robot_forward_dynamics_f32, float, HEAVY_ROBOT_INPUTS, &narrow, &speeds, push);
    CALL(heavy_robot_equations_of_motion_f32, HeavyRobotEquationsF32, &narrow, &speeds);
}

/* Within the stroke and beyond it, the seed near the root and far from it. */
static void search(double x, double h, double seed)
{
    SearchedPress wide = searched_press_default();
    SearchedPressF32 narrow = searched_press_default_f32();
    const SearchedPressInput inputs = {x, h}, rates = {0.5, -0.25}, accelerations = {2.0, 1.0};
    const SearchedPressInputF32 inputs_f32 = {(float)x, (float)h}, rates_f32 = {0.5f, -0.25f};
    wide.seed = seed;
    narrow.seed = (float)seed;
    CALL(searched_press_position, SearchedPressPosition, &wide, &inputs);
    CALL(searched_press_motion, SearchedPressMotion, &wide, &inputs, &rates, &accelerations);
    CALL(searched_press_forces, SearchedPressForces, &wide, &inputs, &rates, &accelerations);
    CALL(searched_press_velocity_f32, SearchedPressVelocityF32, &narrow, &inputs_f32, &rates_f32);
    COEFFICIENTS(searched_press_coefficients, double, SEARCHED_PRESS_OUTPUTS, SEARCHED_PRESS_INPUTS,
                 &wide, &inputs);
}

static void shear(double theta, double rate, double acceleration)
{
    const double c = 0.28, s = 0.96; /* 0.28^2 + 0.96^2 = 1 */
    CALL(flying_shear_position, FlyingShearPosition, theta);
    CALL(flying_shear_velocity, FlyingShearVelocity, theta, rate);
    CALL(flying_shear_motion, FlyingShearMotion, theta, rate, acceleration);
    CALL(flying_shear_position_at, FlyingShearPosition, c, s);
    CALL(flying_shear_velocity_at, FlyingShearVelocity, c, s, rate);
    CALL(flying_shear_motion_at, FlyingShearMotion, c, s, rate, acceleration);
    CALL(flying_shear_margins, FlyingShearMargins, theta);
    COEFFICIENTS(flying_shear_coefficients, double, FLYING_SHEAR_OUTPUTS, FLYING_SHEAR_INPUTS,
                 theta);
}

static void shear_f32(float theta, float rate, float acceleration)
{
    const float c = 0.28f, s = 0.96f;
    CALL(flying_shear_position_f32, FlyingShearPositionF32, theta);
    CALL(flying_shear_velocity_f32, FlyingShearVelocityF32, theta, rate);
    CALL(flying_shear_motion_f32, FlyingShearMotionF32, theta, rate, acceleration);
    CALL(flying_shear_position_at_f32, FlyingShearPositionF32, c, s);
    CALL(flying_shear_velocity_at_f32, FlyingShearVelocityF32, c, s, rate);
    CALL(flying_shear_motion_at_f32, FlyingShearMotionF32, c, s, rate, acceleration);
    CALL(flying_shear_margins_f32, FlyingShearMarginsF32, theta);
    COEFFICIENTS(flying_shear_coefficients_f32, float, FLYING_SHEAR_OUTPUTS, FLYING_SHEAR_INPUTS,
                 theta);
}

static void six_bar(double theta)
{
    CALL(watt_six_bar_motion, WattSixBarMotion, theta, 12.0, -3.0);
    CALL(watt_six_bar_motion, WattSixBarMotion, theta + 3e6, 12.0, -3.0);
    CALL(watt_six_bar_motion_f32, WattSixBarMotionF32, (float)theta, 12.0f, -3.0f);
    CALL(watt_six_bar_margins, WattSixBarMargins, theta);
}

/* Each length fits for some angles and is too short for others; each mode is set once. */
static void four_bar(double theta, double coupler, int32_t elbow)
{
    TunedFourBar wide = tuned_four_bar_default();
    TunedFourBarF32 narrow = tuned_four_bar_default_f32();
    wide.coupler = coupler;
    wide.elbow = elbow;
    narrow.coupler = (float)coupler;
    narrow.elbow = elbow;
    CALL(tuned_four_bar_motion, TunedFourBarMotion, &wide, theta, 2.0, 0.5);
    CALL(tuned_four_bar_motion_f32, TunedFourBarMotionF32, &narrow, (float)theta, 2.0f, 0.5f);
}

static void excavator(double lift, double crowd, double curl)
{
    const ExcavatorInput inputs = {lift, crowd, curl}, rates = {0.1, -0.2, 0.3};
    const ExcavatorInput accelerations = {0.01, 0.02, -0.03};
    const ExcavatorInputF32 inputs_f32 = {(float)lift, (float)crowd, (float)curl};
    const ExcavatorInputF32 rates_f32 = {0.1f, -0.2f, 0.3f};
    CALL(excavator_motion, ExcavatorMotion, &inputs, &rates, &accelerations);
    CALL(excavator_velocity_f32, ExcavatorVelocityF32, &inputs_f32, &rates_f32);
    COEFFICIENTS(excavator_coefficients, double, EXCAVATOR_OUTPUTS, EXCAVATOR_INPUTS, &inputs);
}

/* Mistakes of the caller's. */
static void mistakes(void)
{
    TunedFourBar bar = tuned_four_bar_default();
    const ExcavatorInput inputs = {3.0, 2.4, 1.9};
    const ExcavatorInput *const nowhere = NULL;
    const TunedFourBar *const nothing = NULL;
    LinkageError error;
    CALL(tuned_four_bar_position, TunedFourBarPosition, nothing, 1.0);
    CALL(excavator_velocity, ExcavatorVelocity, nowhere, &inputs);
    CALL(excavator_velocity, ExcavatorVelocity, &inputs, nowhere);
    report("no_answer", tuned_four_bar_position(&bar, 1.0, NULL, &error), &error, "", 0);
    bar.elbow = 0;
    CALL(tuned_four_bar_position, TunedFourBarPosition, &bar, 1.0);
    bar.elbow = LINKAGE_RIGHT;
    bar.coupler = -0.25;
    CALL(tuned_four_bar_position, TunedFourBarPosition, &bar, 1.0);
    bar.coupler = NAN;
    CALL(tuned_four_bar_position, TunedFourBarPosition, &bar, 1.0);
    bar.coupler = 0.05;
    CALL(tuned_four_bar_position, TunedFourBarPosition, &bar, 3.0);
    /* Stretched out, and short by a rounding: a pose, but no velocity. */
    bar.coupler = 0.2285999999999999;
    CALL(tuned_four_bar_velocity, TunedFourBarVelocity, &bar, 3.141592653589793, 1.0);
    CALL(flying_shear_position, FlyingShearPosition, NAN);
    CALL(flying_shear_motion_f32, FlyingShearMotionF32, 1.0f, INFINITY, 0.0f);
    /* A resolver without excitation, and one that was never converted to numbers near one. */
    CALL(flying_shear_position_at, FlyingShearPosition, 0.0, 0.0);
    CALL(flying_shear_motion_at_f32, FlyingShearMotionF32, -2.0f, -2.0f, 1.0f, 0.0f);
    /* Nobody asks why: the status alone says that, and nothing is written. */
    printf("silent %d\n", (int)flying_shear_position(NAN, NULL, NULL));
}

int main(void)
{
    for (int i = -12; i <= 12; i++) {
        shear(0.25 * i, 12.0, -3.0);
        shear_f32(0.25f * (float)i, 12.0f, -3.0f);
        six_bar(0.25 * i);
        four_bar(0.25 * i, 0.254, LINKAGE_LEFT);
        four_bar(0.25 * i, 0.125, LINKAGE_RIGHT);
        excavator(2.3125 + 0.0625 * i, 2.25 + 0.03125 * i, 1.90625 + 0.03125 * i);
        press(0.25 * i, 100.0 * i, 2.5);
        robot(2.0 + 0.125 * i, 1.0 - 0.0625 * i);
        search(0.25 + 0.0078125 * i, 1.125 + 0.015625 * i, 1.5 + 0.25 * i);
    }
    search(0.25, NAN, 1.0);
    search(0.25, 1.0, NAN);
    press(0.5, NAN, 1.0);
    mistakes();
    return 0;
}
