/* fmi3.c: FMI 3.0 around a printed solver, model exchange and co-simulation. What is the mechanism's own stands in
 * fmi3_model.h. This text is yours: use, change and pass it on under any terms, with or without this notice. It comes
 * without any warranty. */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "fmi3_model.h"

#if defined(_WIN32)
#define FMI3 __declspec(dllexport)
#else
#define FMI3
#endif

/* The types of the standard, by its own names. */
typedef void *fmi3Instance;
typedef void *fmi3InstanceEnvironment;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef bool fmi3Boolean;
typedef bool fmi3Clock;
typedef uint8_t fmi3Byte;
typedef const char *fmi3String;
typedef const fmi3Byte *fmi3Binary;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef int fmi3Kind;
typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String category, fmi3String message);
typedef void (*fmi3Callback)(void);

/* The longest step of the integrator of co-simulation, in s. */
#define LONGEST_STEP 1e-4

typedef struct Instance {
    double v[VARIABLES];
    int is_evaluated[GROUPS];
    fmi3LogMessageCallback log;
    fmi3InstanceEnvironment environment;
} Instance;

/* A kinematic model has no states; a compiler would warn of comparisons with a literal zero. */
static size_t state_count(void) { return STATES; }

/* Says which group or which number is to blame. */
static fmi3Status discard(const Instance *instance, const LinkageError *error)
{
    static const char *const reasons[] = {
        "", "cannot be assembled", "is singular", "has an invalid length", "is not finite", "is missing",
        "has an invalid mode", "is no angle", "has no solution", "has several dead points", "may be held by friction",
    };
    char message[256];
    const char *const who = error->group != NULL ? error->group : error->name;
    const size_t length = error->group != NULL ? error->group_length : error->name_length;
    const size_t kept = length < 200 ? length : 200;
    const char *const why = (size_t)error->status < sizeof reasons / sizeof *reasons ? reasons[error->status] : "is refused";
    if (who != NULL) {
        (void)memcpy(message, who, kept);
    }
    message[kept] = ' ';
    (void)memcpy(message + kept + 1, why, strlen(why) + 1);
    if (instance->log != NULL) {
        instance->log(instance->environment, fmi3Discard, "logStatusDiscard", message);
    }
    return fmi3Discard;
}

/* Computes a group of variables. All need the accelerations, which come with the first. */
static fmi3Status evaluated(Instance *instance, size_t group)
{
    const size_t needed[2] = { 0, group };
    LinkageError error;
    size_t k;
    for (k = 0; k < 2; k++) {
        if (!instance->is_evaluated[needed[k]]) {
            if (EVALUATE[needed[k]](instance->v, &error) != LINKAGE_OK) {
                return discard(instance, &error);
            }
            instance->is_evaluated[needed[k]] = 1;
        }
    }
    return fmi3OK;
}

static void forget(Instance *instance) { (void)memset(instance->is_evaluated, 0, sizeof instance->is_evaluated); }

static void reset(Instance *instance)
{
    (void)memcpy(instance->v, START, sizeof START);
    forget(instance);
}

static fmi3Instance instantiated(fmi3String token, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    Instance *instance;
    if (token == NULL || strcmp(token, TOKEN) != 0) {
        return NULL;
    }
    instance = (Instance *)malloc(sizeof *instance);
    if (instance != NULL) {
        instance->log = log;
        instance->environment = environment;
        reset(instance);
    }
    return instance;
}

FMI3 const char *fmi3GetVersion(void) { return "3.0"; }

FMI3 fmi3Status fmi3SetDebugLogging(fmi3Instance i, fmi3Boolean on, size_t n, const fmi3String categories[])
{
    (void)i; (void)on; (void)n; (void)categories;
    return fmi3OK;
}

FMI3 fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String path, fmi3Boolean visible, fmi3Boolean logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    (void)name; (void)path; (void)visible; (void)logging;
    return instantiated(token, environment, log);
}

FMI3 fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String path, fmi3Boolean visible, fmi3Boolean logging, fmi3Boolean events, fmi3Boolean early, const fmi3ValueReference required[], size_t n, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, fmi3Callback update)
{
    (void)name; (void)path; (void)visible; (void)logging; (void)events; (void)early; (void)required; (void)n; (void)update;
    return instantiated(token, environment, log);
}

FMI3 fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String path, fmi3Boolean visible, fmi3Boolean logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, fmi3Callback clock, fmi3Callback lock, fmi3Callback unlock)
{
    (void)name; (void)token; (void)path; (void)visible; (void)logging; (void)environment; (void)log; (void)clock; (void)lock; (void)unlock;
    return NULL;
}

FMI3 void fmi3FreeInstance(fmi3Instance i) { free(i); }

FMI3 fmi3Status fmi3EnterInitializationMode(fmi3Instance i, fmi3Boolean has_tolerance, double tolerance, double start, fmi3Boolean has_stop, double stop)
{
    (void)has_tolerance; (void)tolerance; (void)has_stop; (void)stop;
    ((Instance *)i)->v[0] = start;
    return fmi3OK;
}

#define CHANGES_MODE(function) FMI3 fmi3Status function(fmi3Instance i) { (void)i; return fmi3OK; }
CHANGES_MODE(fmi3ExitInitializationMode)
CHANGES_MODE(fmi3EnterEventMode)
CHANGES_MODE(fmi3EnterContinuousTimeMode)
CHANGES_MODE(fmi3EnterStepMode)
CHANGES_MODE(fmi3EnterConfigurationMode)
CHANGES_MODE(fmi3ExitConfigurationMode)
CHANGES_MODE(fmi3EvaluateDiscreteStates)
CHANGES_MODE(fmi3Terminate)

FMI3 fmi3Status fmi3Reset(fmi3Instance i)
{
    reset((Instance *)i);
    return fmi3OK;
}

FMI3 fmi3Status fmi3GetFloat64(fmi3Instance i, const fmi3ValueReference vr[], size_t n, double values[], size_t count)
{
    Instance *const instance = (Instance *)i;
    size_t k;
    if (n != count) {
        return fmi3Error;
    }
    for (k = 0; k < n; k++) {
        if (vr[k] >= VARIABLES) {
            return fmi3Error;
        }
        if (KIND[vr[k]] >= COMPUTED) {
            const fmi3Status status = evaluated(instance, (size_t)(KIND[vr[k]] - COMPUTED));
            if (status != fmi3OK) {
                return status;
            }
        }
        values[k] = instance->v[vr[k]];
    }
    return fmi3OK;
}

FMI3 fmi3Status fmi3SetFloat64(fmi3Instance i, const fmi3ValueReference vr[], size_t n, const double values[], size_t count)
{
    Instance *const instance = (Instance *)i;
    size_t k;
    if (n != count) {
        return fmi3Error;
    }
    for (k = 0; k < n; k++) {
        if (vr[k] >= VARIABLES || KIND[vr[k]] != GIVEN) {
            return fmi3Error;
        }
        instance->v[vr[k]] = values[k];
        forget(instance);
    }
    return fmi3OK;
}

FMI3 fmi3Status fmi3SetTime(fmi3Instance i, double time)
{
    ((Instance *)i)->v[0] = time;
    return fmi3OK;
}

FMI3 fmi3Status fmi3UpdateDiscreteStates(fmi3Instance i, fmi3Boolean *again, fmi3Boolean *terminate, fmi3Boolean *nominals, fmi3Boolean *states, fmi3Boolean *has_next, double *next)
{
    (void)i;
    *again = *terminate = *nominals = *states = *has_next = false;
    *next = 0.0;
    return fmi3OK;
}

FMI3 fmi3Status fmi3CompletedIntegratorStep(fmi3Instance i, fmi3Boolean no_set, fmi3Boolean *event, fmi3Boolean *terminate)
{
    (void)i; (void)no_set;
    *event = *terminate = false;
    return fmi3OK;
}

FMI3 fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance i, size_t *n) { (void)i; *n = STATES; return fmi3OK; }
FMI3 fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance i, size_t *n) { (void)i; *n = 0; return fmi3OK; }
FMI3 fmi3Status fmi3GetEventIndicators(fmi3Instance i, double z[], size_t n) { (void)i; (void)z; return n == 0 ? fmi3OK : fmi3Error; }

static void put_states(Instance *instance, const double x[])
{
    size_t k;
    for (k = 0; k < state_count(); k++) {
        instance->v[STATE[k]] = x[k];
    }
    forget(instance);
}

static void get(const Instance *instance, const uint32_t variables[], double x[])
{
    size_t k;
    for (k = 0; k < state_count(); k++) {
        x[k] = instance->v[variables[k]];
    }
}

FMI3 fmi3Status fmi3SetContinuousStates(fmi3Instance i, const double x[], size_t n)
{
    if (n != STATES) {
        return fmi3Error;
    }
    put_states((Instance *)i, x);
    return fmi3OK;
}

FMI3 fmi3Status fmi3GetContinuousStates(fmi3Instance i, double x[], size_t n)
{
    if (n != STATES) {
        return fmi3Error;
    }
    get((const Instance *)i, STATE, x);
    return fmi3OK;
}

FMI3 fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance i, double x[], size_t n)
{
    size_t k;
    (void)i;
    for (k = 0; k < n; k++) {
        x[k] = 1.0;
    }
    return n == STATES ? fmi3OK : fmi3Error;
}

FMI3 fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance i, double x[], size_t n)
{
    const fmi3Status status = n == STATES ? evaluated((Instance *)i, 0) : fmi3Error;
    if (status == fmi3OK) {
        get((const Instance *)i, DERIVATIVE, x);
    }
    return status;
}

/* One step of Runge and Kutta's method of fourth order. */
static fmi3Status step(Instance *instance, double h)
{
    static const double share[4] = { 0.0, 0.5, 0.5, 1.0 }, weight[4] = { 1.0, 2.0, 2.0, 1.0 };
    double from[STATES + 1], at[STATES + 1], rate[STATES + 1] = { 0.0 }, sum[STATES + 1] = { 0.0 };
    size_t k, stage;
    get(instance, STATE, from);
    for (stage = 0; stage < 4; stage++) {
        fmi3Status status;
        for (k = 0; k < state_count(); k++) {
            at[k] = from[k] + share[stage] * h * rate[k];
        }
        put_states(instance, at);
        status = evaluated(instance, 0);
        if (status != fmi3OK) {
            put_states(instance, from);
            return status;
        }
        get(instance, DERIVATIVE, rate);
        for (k = 0; k < state_count(); k++) {
            sum[k] += weight[stage] * rate[k];
        }
    }
    for (k = 0; k < state_count(); k++) {
        at[k] = from[k] + h / 6.0 * sum[k];
    }
    put_states(instance, at);
    return fmi3OK;
}

FMI3 fmi3Status fmi3DoStep(fmi3Instance i, double now, double by, fmi3Boolean no_set, fmi3Boolean *event, fmi3Boolean *terminate, fmi3Boolean *early, double *last)
{
    Instance *const instance = (Instance *)i;
    const long count = state_count() > 0 && by > LONGEST_STEP ? (long)(by / LONGEST_STEP + 0.999999) : 1;
    long k;
    (void)no_set;
    *event = *terminate = *early = false;
    for (k = 0; k < count; k++) {
        const fmi3Status status = state_count() > 0 ? step(instance, by / (double)count) : fmi3OK;
        instance->v[0] = *last = now + by * (double)k / (double)count;
        if (status != fmi3OK) {
            *early = true;
            return status;
        }
    }
    instance->v[0] = *last = now + by;
    return evaluated(instance, 0);
}

/* What the standard demands of every FMU and a mechanism has nothing for. */
#define NO_TYPE(name, type)                                                                                            \
    FMI3 fmi3Status fmi3Get##name(fmi3Instance i, const fmi3ValueReference vr[], size_t n, type values[], size_t count) \
    {                                                                                                                  \
        (void)i; (void)vr; (void)n; (void)values; (void)count;                                                         \
        return fmi3Error;                                                                                              \
    }                                                                                                                  \
    FMI3 fmi3Status fmi3Set##name(fmi3Instance i, const fmi3ValueReference vr[], size_t n, const type values[], size_t count) \
    {                                                                                                                  \
        (void)i; (void)vr; (void)n; (void)values; (void)count;                                                         \
        return fmi3Error;                                                                                              \
    }
NO_TYPE(Float32, float)
NO_TYPE(Int8, int8_t)
NO_TYPE(UInt8, uint8_t)
NO_TYPE(Int16, int16_t)
NO_TYPE(UInt16, uint16_t)
NO_TYPE(Int32, int32_t)
NO_TYPE(UInt32, uint32_t)
NO_TYPE(Int64, int64_t)
NO_TYPE(UInt64, uint64_t)
NO_TYPE(Boolean, fmi3Boolean)
NO_TYPE(String, fmi3String)

#define NOTHING(function, arguments) FMI3 fmi3Status function arguments { (void)i; return fmi3Error; }
#define VR const fmi3ValueReference vr[], size_t n
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
NOTHING(fmi3GetBinary, (fmi3Instance i, VR, size_t sizes[], fmi3Binary values[], size_t count))
NOTHING(fmi3SetBinary, (fmi3Instance i, VR, const size_t sizes[], const fmi3Binary values[], size_t count))
NOTHING(fmi3GetClock, (fmi3Instance i, VR, fmi3Clock values[]))
NOTHING(fmi3SetClock, (fmi3Instance i, VR, const fmi3Clock values[]))
NOTHING(fmi3GetNumberOfVariableDependencies, (fmi3Instance i, fmi3ValueReference of, size_t *count))
NOTHING(fmi3GetVariableDependencies, (fmi3Instance i, fmi3ValueReference of, size_t at[], fmi3ValueReference by[], size_t by_at[], fmi3Kind kinds[], size_t count))
NOTHING(fmi3GetFMUState, (fmi3Instance i, fmi3FMUState *state))
NOTHING(fmi3SetFMUState, (fmi3Instance i, fmi3FMUState state))
NOTHING(fmi3FreeFMUState, (fmi3Instance i, fmi3FMUState *state))
NOTHING(fmi3SerializedFMUStateSize, (fmi3Instance i, fmi3FMUState state, size_t *size))
NOTHING(fmi3SerializeFMUState, (fmi3Instance i, fmi3FMUState state, fmi3Byte bytes[], size_t size))
NOTHING(fmi3DeserializeFMUState, (fmi3Instance i, const fmi3Byte bytes[], size_t size, fmi3FMUState *state))
NOTHING(fmi3GetDirectionalDerivative, (fmi3Instance i, VR, const fmi3ValueReference by[], size_t by_n, const double seed[], size_t seeds, double to[], size_t count))
NOTHING(fmi3GetAdjointDerivative, (fmi3Instance i, VR, const fmi3ValueReference by[], size_t by_n, const double seed[], size_t seeds, double to[], size_t count))
NOTHING(fmi3GetIntervalDecimal, (fmi3Instance i, VR, double intervals[], fmi3Kind kinds[]))
NOTHING(fmi3GetIntervalFraction, (fmi3Instance i, VR, uint64_t counters[], uint64_t resolutions[], fmi3Kind kinds[]))
NOTHING(fmi3GetShiftDecimal, (fmi3Instance i, VR, double shifts[]))
NOTHING(fmi3GetShiftFraction, (fmi3Instance i, VR, uint64_t counters[], uint64_t resolutions[]))
NOTHING(fmi3SetIntervalDecimal, (fmi3Instance i, VR, const double intervals[]))
NOTHING(fmi3SetIntervalFraction, (fmi3Instance i, VR, const uint64_t counters[], const uint64_t resolutions[]))
NOTHING(fmi3SetShiftDecimal, (fmi3Instance i, VR, const double shifts[]))
NOTHING(fmi3SetShiftFraction, (fmi3Instance i, VR, const uint64_t counters[], const uint64_t resolutions[]))
NOTHING(fmi3GetOutputDerivatives, (fmi3Instance i, VR, const int32_t orders[], double values[], size_t count))
NOTHING(fmi3ActivateModelPartition, (fmi3Instance i, fmi3ValueReference clock, double time))
