#ifndef LINKAGE_FORCE_TYPES
#define LINKAGE_FORCE_TYPES

/* A force in ground axes: N. */
typedef struct LinkageForce {
    double x;
    double y;
} LinkageForce;

/* What a guide exerts at the origin of the frame of the link that slides on it: N along the guide's
 * normal, and N*m. */
typedef struct LinkageGuideForce {
    double normal;
    double couple;
} LinkageGuideForce;

/* What inertia puts on the ground: N, and N*m about the origin. */
typedef struct LinkageShaking {
    double x;
    double y;
    double couple;
} LinkageShaking;

/* The same in single precision. */
typedef struct LinkageForceF32 {
    float x;
    float y;
} LinkageForceF32;

typedef struct LinkageGuideForceF32 {
    float normal;
    float couple;
} LinkageGuideForceF32;

typedef struct LinkageShakingF32 {
    float x;
    float y;
    float couple;
} LinkageShakingF32;

#endif /* LINKAGE_FORCE_TYPES */
