#ifndef LINKAGE_TYPES
#define LINKAGE_TYPES

/* What every function returns. */
typedef int32_t LinkageStatus;
enum {
    LINKAGE_OK = 0,
    LINKAGE_OUT_OF_REACH = 1,   /* the group cannot be assembled; `by` metres are missing */
    LINKAGE_SINGULAR = 2,       /* what was asked for is undefined in this pose of the group */
    LINKAGE_INVALID_LENGTH = 3, /* the length `name` of the group is zero or negative */
    LINKAGE_NOT_FINITE = 4,     /* the input, parameter or result `name` is not finite */
    LINKAGE_NULL_POINTER = 5,   /* the argument `name` is null */
    LINKAGE_INVALID_MODE = 6,   /* the parameter `name` is none of the modes below */
    LINKAGE_OFF_CIRCLE = 7      /* cos and sin of the input `name` are those of no angle */
};

/* Assembly modes, the values of parameters that are modes. */
enum {
    LINKAGE_LEFT = 1,
    LINKAGE_RIGHT = -1,
    LINKAGE_AHEAD = 1,
    LINKAGE_BEHIND = -1
};

/* What a status means. The texts are not terminated: print them with
 * printf("%.*s", (int)error.group_length, error.group). They are null where nothing of the kind
 * is to blame, and live as long as the program. */
typedef struct LinkageError {
    LinkageStatus status;
    double by; /* m; 0 unless the group is out of reach */
    const char *group;
    size_t group_length;
    const char *name;
    size_t name_length;
} LinkageError;

/* A point, its velocity or its acceleration, in ground axes: m, m/s or m/s^2. */
typedef struct LinkagePoint {
    double x;
    double y;
} LinkagePoint;

/* The unit vector along a link's x axis; its angle is atan2(sin, cos). */
typedef struct LinkageDirection {
    double cos;
    double sin;
} LinkageDirection;

/* The direction of a link that slides, and its slide in m. */
typedef struct LinkageSlidingDirection {
    double cos;
    double sin;
    double slide;
} LinkageSlidingDirection;

/* The slide of a link that does not turn, or its velocity or acceleration: m, m/s or m/s^2. */
typedef struct LinkageSlide {
    double slide;
} LinkageSlide;

/* rad/s, counter-clockwise. */
typedef struct LinkageAngularVelocity {
    double omega;
} LinkageAngularVelocity;

/* rad/s, counter-clockwise, and m/s. */
typedef struct LinkageSlidingVelocity {
    double omega;
    double slide;
} LinkageSlidingVelocity;

/* rad/s^2, counter-clockwise. */
typedef struct LinkageAngularAcceleration {
    double alpha;
} LinkageAngularAcceleration;

/* rad/s^2, counter-clockwise, and m/s^2. */
typedef struct LinkageSlidingAcceleration {
    double alpha;
    double slide;
} LinkageSlidingAcceleration;

/* The same in single precision. */
typedef struct LinkagePointF32 {
    float x;
    float y;
} LinkagePointF32;

typedef struct LinkageDirectionF32 {
    float cos;
    float sin;
} LinkageDirectionF32;

typedef struct LinkageSlidingDirectionF32 {
    float cos;
    float sin;
    float slide;
} LinkageSlidingDirectionF32;

typedef struct LinkageSlideF32 {
    float slide;
} LinkageSlideF32;

typedef struct LinkageAngularVelocityF32 {
    float omega;
} LinkageAngularVelocityF32;

typedef struct LinkageSlidingVelocityF32 {
    float omega;
    float slide;
} LinkageSlidingVelocityF32;

typedef struct LinkageAngularAccelerationF32 {
    float alpha;
} LinkageAngularAccelerationF32;

typedef struct LinkageSlidingAccelerationF32 {
    float alpha;
    float slide;
} LinkageSlidingAccelerationF32;

#endif /* LINKAGE_TYPES */
