/* linkage_assemblies.h: all ways to assemble a group of pins, proved. linkage_run.h says whose text this is. */
#ifndef LINKAGE_ASSEMBLY_TYPES
#define LINKAGE_ASSEMBLY_TYPES

#include <stdint.h>

/* The part of a list that is proved: all of it; or some assemblies may be missing, the first between `from` and `to`; or
 * the budget was spent before all of the circle was looked at. */
#define LINKAGE_PROVED 0
#define LINKAGE_OPEN 1
#define LINKAGE_OUT_OF_BUDGET 2

/* The most that is spent on a list: values of the product over all modes, and pieces of the circle. */
typedef struct LinkageBudget {
    uint32_t samples;
    uint32_t pieces;
} LinkageBudget;

/* More than a group of random lengths needs: a triad takes 200 samples as a rule and 2,000 at most. */
#define LINKAGE_SAMPLES 40000u
#define LINKAGE_PIECES 4000u

/* A way to assemble a group. Angles are in radians. */
typedef struct LinkageAssembly {
    double unknown;    /* from -pi to pi */
    double between[2]; /* two values between which the unknown lies, proved */
    double room;       /* half the angle to the nearest other assembly; pi where there is none */
    double within;     /* the width on each side within which the unknown is searched */
    uint32_t sides;    /* a bit a dyad: set where its inner pin is on the left of the way between the outer ones */
    int32_t rises;     /* 1 if the equation's left side grows with the unknown */
} LinkageAssembly;

/* What is known of a list. */
typedef struct LinkageAssemblies {
    int32_t outcome;
    uint32_t count;
    double from;
    double to;
    uint32_t samples;
    uint32_t pieces;
} LinkageAssemblies;

/* A pin as a point of a body, by the number of its place in the body's coordinates. */
typedef struct LinkageBodyPin {
    uint8_t body;
    uint8_t place;
} LinkageBodyPin;

/* A bar of a dyad, the pin that it hangs on, and the places of that pin and of the inner one on the bar. */
typedef struct LinkageHungBar {
    uint8_t body;
    LinkageBodyPin outer;
    uint8_t ends[2];
} LinkageHungBar;

/* The kind of a group. */
typedef struct LinkagePinned {
    uint8_t pivot[2];
    uint8_t count;
    LinkageHungBar dyads[4][2];
    LinkageBodyPin equation[2];
    uint8_t powers[4];
    uint8_t half;
} LinkagePinned;

#endif /* LINKAGE_ASSEMBLY_TYPES */

#ifndef LINKAGE_ASSEMBLIES_H
#define LINKAGE_ASSEMBLIES_H

/* Sources that were printed with another text of this run-time do not compile with it. */
#define LINKAGE_LISTS_HASH OWN_HASH

#ifdef __cplusplus
extern "C" {
#endif

/* The index of the angle that is nearest to a measured one, or -1 where there is none; whole turns make no difference, and
 * an angle that is NaN is left out. `off` is its distance, `runner_up` that of the next one or NaN; both may be null. */
int32_t linkage_nearest_angle(const double *angles, uint32_t count, double measured, double *off, double *runner_up);

/* The list of a group from its numbers: the length of the link that was left out, then x and y of place after place. There
 * is room for twice the half of its kind. */
void linkage_list_assemblies(const LinkagePinned *kind, const double *numbers, LinkageBudget budget, LinkageAssembly *assemblies, LinkageAssemblies *list);

#ifdef __cplusplus
}
#endif

#endif /* LINKAGE_ASSEMBLIES_H */
