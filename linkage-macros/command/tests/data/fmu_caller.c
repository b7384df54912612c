/* Calls an FMU as its standard allows and as it forbids. The sources of the FMU are included: fmi3.c, and the value
 * references of the variables as macros. Prints the line of each check that fails. */
#include <math.h>
#include <stdio.h>

#include "fmi3.c"

static int failures;
static char said[256];

#define CHECK(condition)                                       \
    do {                                                       \
        if (!(condition)) {                                    \
            printf("line %d: %s\n", __LINE__, #condition);     \
            failures++;                                        \
        }                                                      \
    } while (0)

static void logged(fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message)
{
    (void)environment; (void)status; (void)category;
    strncpy(said, message, sizeof said - 1);
}

static double value(fmi3Instance fmu, fmi3ValueReference of)
{
    double found = NAN;
    CHECK(fmi3GetFloat64(fmu, &of, 1, &found, 1) == fmi3OK);
    return found;
}

static fmi3Status set(fmi3Instance fmu, fmi3ValueReference of, double to) { return fmi3SetFloat64(fmu, &of, 1, &to, 1); }

static void numbers_follow_what_is_given(fmi3Instance fmu)
{
    const fmi3ValueReference beyond = VARIABLES, two[2] = { THETA, ROD };
    double before, number, pair[2];
    before = value(fmu, C_Y);
    CHECK(value(fmu, ROD) == 0.4);
    CHECK(set(fmu, THETA, 0.5) == fmi3OK);
    CHECK(value(fmu, C_Y) != before);
    CHECK(set(fmu, C_Y, 1.0) == fmi3Error);
    CHECK(set(fmu, THETA_ACCELERATION, 1.0) == fmi3Error);
    CHECK(set(fmu, beyond, 1.0) == fmi3Error);
    CHECK(fmi3GetFloat64(fmu, &beyond, 1, &number, 1) == fmi3Error);
    CHECK(fmi3GetFloat64(fmu, two, 2, pair, 1) == fmi3Error);
    CHECK(fmi3SetFloat64(fmu, two, 2, pair, 1) == fmi3Error);
    CHECK(fmi3Reset(fmu) == fmi3OK);
    CHECK(value(fmu, THETA) == 0.0 && value(fmu, C_Y) != before + 1.0);
}

static void time_is_what_the_simulator_says(fmi3Instance fmu)
{
    CHECK(fmi3EnterInitializationMode(fmu, false, 0.0, 2.0, false, 0.0) == fmi3OK);
    CHECK(value(fmu, 0) == 2.0);
    CHECK(fmi3ExitInitializationMode(fmu) == fmi3OK);
    CHECK(fmi3SetTime(fmu, 3.0) == fmi3OK);
    CHECK(value(fmu, 0) == 3.0);
}

static void states_are_counted(fmi3Instance fmu)
{
    double x[3] = { 0.25, 3.0, 0.0 }, rates[3];
    size_t count = 0, events = 9;
    CHECK(fmi3GetNumberOfContinuousStates(fmu, &count) == fmi3OK && count == 2);
    CHECK(fmi3GetNumberOfEventIndicators(fmu, &events) == fmi3OK && events == 0);
    CHECK(fmi3SetContinuousStates(fmu, x, 2) == fmi3OK && fmi3SetContinuousStates(fmu, x, 3) == fmi3Error);
    CHECK(fmi3GetContinuousStates(fmu, rates, 2) == fmi3OK && rates[0] == 0.25 && rates[1] == 3.0);
    CHECK(fmi3GetContinuousStates(fmu, rates, 1) == fmi3Error);
    CHECK(fmi3GetContinuousStateDerivatives(fmu, rates, 2) == fmi3OK);
    CHECK(rates[0] == 3.0 && rates[1] == value(fmu, THETA_ACCELERATION));
    CHECK(fmi3GetContinuousStateDerivatives(fmu, rates, 3) == fmi3Error);
    CHECK(fmi3GetNominalsOfContinuousStates(fmu, rates, 2) == fmi3OK && rates[0] > 0.0 && rates[1] > 0.0);
    CHECK(fmi3GetNominalsOfContinuousStates(fmu, rates, 1) == fmi3Error);
}

/* A rod shorter than the crank: the ram stops the crank before a quarter turn. At a hundred radians a second it is there
 * within a few milliseconds. */
static void a_step_that_leads_out_of_reach_ends_early(fmi3Instance fmu)
{
    bool event = true, terminate = true, early = false;
    double last = -1.0, reached, refused;
    CHECK(fmi3Reset(fmu) == fmi3OK);
    CHECK(set(fmu, ROD, 0.09) == fmi3OK && set(fmu, THETA, -1.5) == fmi3OK && set(fmu, THETA_RATE, 100.0) == fmi3OK);
    CHECK(fmi3DoStep(fmu, 0.0, 0.001, true, &event, &terminate, &early, &last) == fmi3OK);
    CHECK(!event && !terminate && !early && last == 0.001 && value(fmu, 0) == 0.001);
    CHECK(fabs(value(fmu, THETA) + 1.4) < 0.05);
    CHECK(fmi3DoStep(fmu, 0.001, 1.0, true, &event, &terminate, &early, &last) == fmi3Discard);
    CHECK(early && last > 0.001 && last < 0.1 && value(fmu, 0) == last);
    CHECK(strcmp(said, "BC, ram cannot be assembled") == 0);
    /* It stands where the last step has ended, where it has a pose and the next step has none. */
    reached = value(fmu, THETA);
    CHECK(isfinite(value(fmu, C_Y)));
    CHECK(fmi3DoStep(fmu, last, 1e-4, true, &event, &terminate, &early, &refused) == fmi3Discard);
    CHECK(early && refused == last && value(fmu, THETA) == reached);
}

/* A kinematic model has no states: a step only says whether there is a pose at its end. */
static void a_pose_out_of_reach_is_no_step(fmi3Instance fmu)
{
    bool event, terminate, early;
    double last = -1.0;
    CHECK(set(fmu, ROD, 0.05) == fmi3OK && set(fmu, THETA, 0.0) == fmi3OK);
    CHECK(fmi3DoStep(fmu, 0.0, 0.1, true, &event, &terminate, &early, &last) == fmi3Discard);
    CHECK(set(fmu, ROD, 0.4) == fmi3OK);
    CHECK(fmi3DoStep(fmu, 0.0, 0.1, true, &event, &terminate, &early, &last) == fmi3OK && last == 0.1);
}

int main(void)
{
    fmi3Instance fmu = fmi3InstantiateCoSimulation("press", TOKEN, "", false, false, false, false, NULL, 0, NULL, logged, NULL);
    CHECK(fmi3InstantiateModelExchange("press", "{another}", "", false, false, NULL, NULL) == NULL);
    CHECK(fmi3InstantiateModelExchange("press", NULL, "", false, false, NULL, NULL) == NULL);
    if (fmu == NULL) {
        printf("no instance\n");
        return 1;
    }
    if (STATES == 0) {
        a_pose_out_of_reach_is_no_step(fmu);
        return failures != 0;
    }
    numbers_follow_what_is_given(fmu);
    time_is_what_the_simulator_says(fmu);
    states_are_counted(fmu);
    a_step_that_leads_out_of_reach_ends_early(fmu);
    fmi3FreeInstance(fmu);
    return failures != 0;
}
