/* FlyingShear, generated from its declaration in Rust; do not edit.
 * Strip-mill flying shear: a crank-rocker whose coupler carries the upper blade.
 *
 * A function returns LINKAGE_OK, or why there is no answer; then what its answer would
 * have been written to is left as it was. error may be null; otherwise it is filled in
 * every time. Any other null pointer is reported. Pointers that are not null have to be
 * valid. Nothing is allocated or kept between calls, so any number of threads may call. */

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

/* The slide of a link that does not turn, or its first or second rate: m, m/s or m/s^2. */
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
#define FLYING_SHEAR_OUTPUTS 3

/* The parameters of FlyingShear. */
typedef struct FlyingShear {
    /* In m; as declared 0.632 */
    double coupler;
    /* LINKAGE_LEFT or LINKAGE_RIGHT */
    int32_t elbow;
} FlyingShear;

/* Positions of the outputs. */
typedef struct FlyingShearPosition {
    /* Point blade (point on BC): coordinates in m */
    LinkagePoint blade;
    /* Link DC (rrr BC, DC): unit direction, counter-clockwise from +x */
    LinkageDirection DC;
} FlyingShearPosition;

/* Velocities of the outputs. */
typedef struct FlyingShearVelocity {
    /* Point blade (point on BC): velocity in m/s */
    LinkagePoint blade;
    /* Link DC (rrr BC, DC): angular velocity in rad/s, counter-clockwise */
    LinkageAngularVelocity DC;
} FlyingShearVelocity;

/* Accelerations of the outputs. */
typedef struct FlyingShearAcceleration {
    /* Point blade (point on BC): acceleration in m/s^2 */
    LinkagePoint blade;
    /* Link DC (rrr BC, DC): angular acceleration in rad/s^2, counter-clockwise */
    LinkageAngularAcceleration DC;
} FlyingShearAcceleration;

/* Position, velocity and acceleration of the outputs. */
typedef struct FlyingShearMotion {
    /* In m and rad */
    FlyingShearPosition position;
    /* In m/s and rad/s */
    FlyingShearVelocity velocity;
    /* In m/s^2 and rad/s^2 */
    FlyingShearAcceleration acceleration;
} FlyingShearMotion;

/* The parameters of FlyingShear. */
typedef struct FlyingShearF32 {
    /* In m; as declared 0.632 */
    float coupler;
    /* LINKAGE_LEFT or LINKAGE_RIGHT */
    int32_t elbow;
} FlyingShearF32;

/* Positions of the outputs. */
typedef struct FlyingShearPositionF32 {
    /* Point blade (point on BC): coordinates in m */
    LinkagePointF32 blade;
    /* Link DC (rrr BC, DC): unit direction, counter-clockwise from +x */
    LinkageDirectionF32 DC;
} FlyingShearPositionF32;

/* Velocities of the outputs. */
typedef struct FlyingShearVelocityF32 {
    /* Point blade (point on BC): velocity in m/s */
    LinkagePointF32 blade;
    /* Link DC (rrr BC, DC): angular velocity in rad/s, counter-clockwise */
    LinkageAngularVelocityF32 DC;
} FlyingShearVelocityF32;

/* Accelerations of the outputs. */
typedef struct FlyingShearAccelerationF32 {
    /* Point blade (point on BC): acceleration in m/s^2 */
    LinkagePointF32 blade;
    /* Link DC (rrr BC, DC): angular acceleration in rad/s^2, counter-clockwise */
    LinkageAngularAccelerationF32 DC;
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

/* The parameters as declared. */
FlyingShear flying_shear_default(void);

/* Positions of the outputs. */
LinkageStatus flying_shear_position(const FlyingShear *mechanism, double theta, FlyingShearPosition *position, LinkageError *error);

/* Velocities of the outputs. */
LinkageStatus flying_shear_velocity(const FlyingShear *mechanism, double theta, double theta_rate, FlyingShearVelocity *velocity, LinkageError *error);

/* Positions, velocities and accelerations of the outputs. */
LinkageStatus flying_shear_motion(const FlyingShear *mechanism, double theta, double theta_rate, double theta_acceleration, FlyingShearMotion *motion, LinkageError *error);

/* Kinematic coefficients doutputs/dinputs.
 * Row by row: blade.x, blade.y, DC.angle. */
LinkageStatus flying_shear_coefficients(const FlyingShear *mechanism, double theta, double coefficients[3][1], LinkageError *error);

/* Positions of the outputs. */
LinkageStatus flying_shear_position_at(const FlyingShear *mechanism, double cos, double sin, FlyingShearPosition *position, LinkageError *error);

/* Velocities of the outputs. */
LinkageStatus flying_shear_velocity_at(const FlyingShear *mechanism, double cos, double sin, double theta_rate, FlyingShearVelocity *velocity, LinkageError *error);

/* Positions, velocities and accelerations of the outputs. */
LinkageStatus flying_shear_motion_at(const FlyingShear *mechanism, double cos, double sin, double theta_rate, double theta_acceleration, FlyingShearMotion *motion, LinkageError *error);

/* The parameters as declared. */
FlyingShearF32 flying_shear_default_f32(void);

/* Positions of the outputs. */
LinkageStatus flying_shear_position_f32(const FlyingShearF32 *mechanism, float theta, FlyingShearPositionF32 *position, LinkageError *error);

/* Velocities of the outputs. */
LinkageStatus flying_shear_velocity_f32(const FlyingShearF32 *mechanism, float theta, float theta_rate, FlyingShearVelocityF32 *velocity, LinkageError *error);

/* Positions, velocities and accelerations of the outputs. */
LinkageStatus flying_shear_motion_f32(const FlyingShearF32 *mechanism, float theta, float theta_rate, float theta_acceleration, FlyingShearMotionF32 *motion, LinkageError *error);

/* Kinematic coefficients doutputs/dinputs.
 * Row by row: blade.x, blade.y, DC.angle. */
LinkageStatus flying_shear_coefficients_f32(const FlyingShearF32 *mechanism, float theta, float coefficients[3][1], LinkageError *error);

/* Positions of the outputs. */
LinkageStatus flying_shear_position_at_f32(const FlyingShearF32 *mechanism, float cos, float sin, FlyingShearPositionF32 *position, LinkageError *error);

/* Velocities of the outputs. */
LinkageStatus flying_shear_velocity_at_f32(const FlyingShearF32 *mechanism, float cos, float sin, float theta_rate, FlyingShearVelocityF32 *velocity, LinkageError *error);

/* Positions, velocities and accelerations of the outputs. */
LinkageStatus flying_shear_motion_at_f32(const FlyingShearF32 *mechanism, float cos, float sin, float theta_rate, float theta_acceleration, FlyingShearMotionF32 *motion, LinkageError *error);

#ifdef __cplusplus
}
#endif

#endif /* FLYING_SHEAR_H */
