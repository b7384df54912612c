/* FlyingShear, generated from its declaration in Rust; do not edit.
 * A strip-mill flying shear: a crank-rocker whose coupler carries the upper blade.
 *
 * A function returns LINKAGE_OK, or why there is no answer; then what its answer would
 * have been written to is left as it was. error may be null; otherwise it is written
 * where there is no answer, and left as it was where there is one. Any other null pointer
 * is reported. Pointers that are not null have to be valid. Nothing is allocated or kept
 * between calls, so any number of threads may call. */

#ifndef FLYING_SHEAR_H
#define FLYING_SHEAR_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

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

#define FLYING_SHEAR_INPUTS 1
#define FLYING_SHEAR_OUTPUTS 2

/* Positions of the outputs. */
typedef struct FlyingShearPositionF32 {
    /* Point blade (point on BC): coordinates in m */
    LinkagePointF32 blade;
} FlyingShearPositionF32;

/* Velocities of the outputs. */
typedef struct FlyingShearVelocityF32 {
    /* Point blade (point on BC): velocity in m/s */
    LinkagePointF32 blade;
} FlyingShearVelocityF32;

/* Accelerations of the outputs. */
typedef struct FlyingShearAccelerationF32 {
    /* Point blade (point on BC): acceleration in m/s^2 */
    LinkagePointF32 blade;
} FlyingShearAccelerationF32;

/* Position, velocity and acceleration of the outputs. */
typedef struct FlyingShearMotionF32 {
    /* In m and rad */
    FlyingShearPositionF32 position;
    /* In m/s and rad/s */
    FlyingShearVelocityF32 velocity;
    /* In m/s^2 and rad/s^2 */
    FlyingShearAccelerationF32 acceleration;
} FlyingShearMotionF32;

/* Positions, velocities and accelerations of the outputs. */
LinkageStatus flying_shear_motion_f32(float theta, float theta_rate, float theta_acceleration, FlyingShearMotionF32 *motion, LinkageError *error);

/* Positions, velocities and accelerations of the outputs. */
LinkageStatus flying_shear_motion_at_f32(float cos, float sin, float theta_rate, float theta_acceleration, FlyingShearMotionF32 *motion, LinkageError *error);

#ifndef LINKAGE_VERSION
#define LINKAGE_VERSION "0.1.0"
#endif
/* A hash of the declaration's words: layout and comments change nothing. */
#define FLYING_SHEAR_DECLARATION "736bff468ce27e07"

/* The program, its version, the mechanism and the hash, for whoever looks into an object. */
extern const char flying_shear_origin[];

/* The names of the inputs and of the outputs' rows, in their order; the last text is null. */
extern const char *const flying_shear_input_labels[FLYING_SHEAR_INPUTS + 1];
extern const char *const flying_shear_output_labels[FLYING_SHEAR_OUTPUTS + 1];

#ifndef LINKAGE_WORDS
#define LINKAGE_WORDS

/* A status in words, also of a number that is none. */
const char *linkage_status_text(LinkageStatus status);

/* The angle of a direction nearest `previous` among all that are turns apart, in rad: fed back, it follows a link as
 * long as it turns less than half a turn between two calls. */
double linkage_angle_near(double cosine, double sine, double previous);
float linkage_angle_near_f32(float cosine, float sine, float previous);

#endif /* LINKAGE_WORDS */

#ifdef __cplusplus
}
#endif

#endif /* FLYING_SHEAR_H */
