/* linkage_run.h: the arithmetic of solvers that linkage has printed.
 *
 * Answers and refusals are those of the solver in Rust, bit for bit where both are compiled with a
 * fused multiplication and addition or both without. Nothing is allocated, nothing is kept between
 * calls, and nothing but <math.h> is called.
 *
 * This text is yours: use, change and pass it on under any terms, with or without this notice. It comes
 * without any warranty. */
#ifndef LINKAGE_RUN_H
#define LINKAGE_RUN_H

/* A hash of the whole run-time: sources that were printed with another one do not compile with it. */
#define LINKAGE_RUN_TIME 0x5eb9ddb6u

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* A header of yours that names functions of the target: sines, square roots, fused products. */
#if defined(LINKAGE_HOOKS)
#include LINKAGE_HOOKS
#endif

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || defined(__ASSOCIATIVE_MATH__) \
    || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "a refusal rests on NaN and on exact rounding: compile without -ffast-math"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "a refusal rests on exact rounding: compile without excess precision, as with -msse2 -mfpmath=sse"
#endif

/* Numbers by which the slow path decides. With LINKAGE_NO_DOUBLE these are float as well, and decisions are made in sums of
 * them: refusals are the same, and no double is computed with. */
#if defined(LINKAGE_NO_DOUBLE)
typedef float LinkageWide;
#elif defined(DBL_MANT_DIG) && DBL_MANT_DIG < 53
#error "double has fewer than 64 bits here: define LINKAGE_NO_DOUBLE for decisions in float, or as for avr-gcc 10 ask for -mdouble=64"
#else
typedef double LinkageWide;
#endif

/* No product is contracted into a sum but where a fused operation is written. gcc 12 contracts vectors of sums and
 * differences whatever it is told, so it makes none. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off", "no-tree-vectorize")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#else
#pragma STDC FP_CONTRACT OFF
#endif

#if defined(__GNUC__)
#define LINKAGE_COLD __attribute__((cold, noinline))
#else
#define LINKAGE_COLD
#endif

/* A fast path becomes part of the function that calls it, so that results stay in registers until they are known to be
 * answers. */
#if !defined(LINKAGE_INLINE)
#if defined(__GNUC__)
#define LINKAGE_INLINE inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define LINKAGE_INLINE __forceinline
#else
#define LINKAGE_INLINE inline
#endif
#endif

/* Defined where one instruction multiplies and adds with one rounding. */
#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__) || defined(LINKAGE_FMA_F64)
#define LINKAGE_FUSES 1
#endif
#if defined(FP_FAST_FMAF) || defined(__FMA__) || defined(__aarch64__) || defined(LINKAGE_FMA_F32)
#define LINKAGE_FUSESF 1
#endif

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

#define LINKAGE_NO_SOLUTION 8
#define LINKAGE_SEVERAL_DEAD_POINTS 9
#define LINKAGE_JAMS 10
#define LINKAGE_OTHER_ASSEMBLY 11
#define LINKAGE_NOT_CERTIFIED 12

#ifndef LINKAGE_WORDS
#define LINKAGE_WORDS

/* A status in words, also of a number that is none. */
const char *linkage_status_text(LinkageStatus status);

/* The angle of a direction nearest `previous` among all that are turns apart, in rad: fed back, it follows a link as
 * long as it turns less than half a turn between two calls. */
double linkage_angle_near(double cosine, double sine, double previous);
float linkage_angle_near_f32(float cosine, float sine, float previous);

#endif /* LINKAGE_WORDS */

#ifndef LINKAGE_NO_DOUBLE

/* A target's own functions in double precision, as the caller's header names them, each with its error. */
#if defined(LINKAGE_SIN_COS_F64)
#if !defined(LINKAGE_SIN_COS_WITHIN_F64) || LINKAGE_SIN_COS_WITHIN_F64 < 10
#error "LINKAGE_SIN_COS_F64 is wrong by 2^-n at most: define LINKAGE_SIN_COS_WITHIN_F64 as n, at least 10"
#endif
#endif
#if defined(LINKAGE_SQRT_F64)
#if !defined(LINKAGE_SQRT_PLACES_F64) || LINKAGE_SQRT_PLACES_F64 > 4
#error "LINKAGE_SQRT_F64 is wrong by n last places at most: define LINKAGE_SQRT_PLACES_F64 as n, at most 4"
#endif
#endif

static inline double linkage_sqrt(double x)
{
#if defined(LINKAGE_SQRT_F64)
    return LINKAGE_SQRT_F64(x);
#else
    return sqrt(x);
#endif
}

#ifdef LINKAGE_FUSES
/* Rounded once, whatever computes it: errors of roundings rest on it. */
static inline double linkage_fma(double a, double b, double c)
{
#if defined(LINKAGE_FMA_F64)
    return LINKAGE_FMA_F64(a, b, c);
#else
    return fma(a, b, c);
#endif
}
#endif

/* In double precision. */

static inline int linkage_is_finite(double x) { return fabs(x) <= DBL_MAX; }

/* x has to be `bound` at most without its sign; a NaN is not. */
static inline int linkage_is_within(double x, double bound) { return fabs(x) <= bound; }

/* As right as those of <math.h>. */
static inline double linkage_tan(double x) { return tan(x); }

static inline double linkage_exp(double x) { return exp(x); }

static inline double linkage_ln(double x) { return log(x); }

static inline double linkage_tanh(double x) { return tanh(x); }

static inline double linkage_pow(double x, double y) { return pow(x, y); }

/* The smallest square of full precision. */
static inline double linkage_smallest_square(void) { return DBL_MIN / (DBL_EPSILON * DBL_EPSILON); }

/* The rounding of a value that was made of numbers as large as this. */
static inline double linkage_rounding(double spread) { return 16.0 * DBL_EPSILON * spread; }

/* a*b + c, with one rounding where the machine has an instruction for it. */
static inline double linkage_fused(double a, double b, double c)
{
#ifdef LINKAGE_FUSES
    return linkage_fma(a, b, c);
#else
    return a * b + c;
#endif
}

/* The rounding error of `product`, which is a*b rounded: T. J. Dekker, Numerische Mathematik 18 (1971). */
static inline double linkage_product_error(double a, double b, double product)
{
#ifdef LINKAGE_FUSES
    return linkage_fma(a, b, -product);
#else
    const double as = 134217729.0 * a, ah = as - (as - a), al = a - ah;
    const double bs = 134217729.0 * b, bh = bs - (bs - b), bl = b - bh;
    return ((ah * bh - product) + ah * bl + al * bh) + al * bl;
#endif
}

static inline double linkage_mul_err(double a, double b) { return linkage_product_error(a, b, a * b); }

static inline double linkage_add_err(double a, double b)
{
    const double sum = a + b, bp = sum - a, ap = sum - bp;
    return (a - ap) + (b - bp);
}

/* a*b - c*d without cancellation (W. Kahan). */
static inline double linkage_det(double a, double b, double c, double d)
{
    const double cd = c * d;
#ifdef LINKAGE_FUSES
    return linkage_fma(a, b, -cd) - linkage_fma(c, d, -cd);
#else
    const double ab = a * b;
    return (ab - cd) + (linkage_product_error(a, b, ab) - linkage_product_error(c, d, cd));
#endif
}

/* a >= b ? x : y */
static inline double linkage_select(double a, double b, double x, double y) { return a >= b ? x : y; }

/* The square root of x*x + y*y. It is right where their sum is at least `least` and a number; the answer
 * says whether. */
static inline int linkage_hypot_near(double x, double y, double least, double *length)
{
    const double square = linkage_fused(x, x, y * y);
    *length = linkage_sqrt(square);
    return (square >= least) & (DBL_MAX >= square);
}

/* x*P(x) for coefficients from the lowest on, by Horner's scheme. */
static inline double linkage_times_polynomial(double x, const double *coefficients, int count)
{
    double sum = 0.0;
    int i;
    for (i = count; i > 0; i--) { /* at most 23 times */
        sum = linkage_fused(sum, x, coefficients[i - 1]);
    }
    return x * sum;
}

/* The number without the last bits, so that its square is exact. */
static inline double linkage_high_word(double s)
{
    uint64_t bits;
    (void)memcpy(&bits, &s, sizeof bits);
    bits = (uint64_t)(bits >> 32) << 32;
    (void)memcpy(&s, &bits, sizeof s);
    return s;
}

/* asin s = s + s*r of s = |x|, above a half of s = sqrt(z) with z = (1 - |x|)/2. */
static inline int linkage_halved(double x, double *z, double *s, double *r)
{
    static const double sine[] = { 0.16666666666666669, 0.07499999999998433, 0.04464285714635543, 0.030381944138531247,
        0.02237217294214989, 0.017352392720869973, 0.013971212973552933, 0.011479177415184906,
        0.01032281435018578, 0.005457506718640358, 0.01740087944269402, -0.014851887071247204,
        0.028757851367421566 };
    const double size = fabs(x);
    const int is_large = size > 0.5;
    *z = is_large ? 0.5 * (1.0 - size) : x * x;
    *s = is_large ? sqrt(*z) : size;
    *r = linkage_times_polynomial(*z, sine, (int)(sizeof sine / sizeof sine[0]));
    return is_large;
}

static inline double linkage_asin(double x)
{
    double z, s, r, high, rest, missing, low, below;
    const int is_large = linkage_halved(x, &z, &s, &r);
    high = linkage_high_word(s);
    rest = s - high;
#ifdef LINKAGE_FUSES
    missing = linkage_fma(-s, s, z);
#else
    missing = (z - high * high) - rest * (s + high);
#endif
    low = rest + missing * (1.5 - s);
    below = linkage_fused(s, r, low);
    below = 0.7853981633974483 + ((0.7853981633974483 - 2.0 * high) - (2.0 * below - 6.123233995736766e-17));
    return copysign(is_large ? below : fabs(x) + s * r, x);
}

static inline double linkage_acos(double x)
{
    double z, s, r, high, rest, low, near_one, near_minus_one;
    const int is_large = linkage_halved(x, &z, &s, &r);
    high = linkage_high_word(s);
    rest = s * r;
    low = linkage_fused(s, r, (z - high * high) / (s + high + DBL_MIN));
    near_one = 2.0 * high + 2.0 * low;
    near_minus_one = 1.5707963267948966 + ((1.5707963267948966 - 2.0 * high) - (2.0 * low - 2.0 * 6.123233995736766e-17));
    if (is_large) {
        return x > 0.0 ? near_one : near_minus_one;
    }
    return 1.5707963267948966 - (x - (6.123233995736766e-17 - copysign(rest, x)));
}

/* Half a turn is positive whatever the sign of zero. */
static inline double linkage_atan2(double y, double x)
{
    static const double tangent[] = { -0.3333333333333333, 0.19999999999999984, -0.14285714285711718, 0.11111111110929807,
        -0.09090909084093506, 0.07692307534369985, -0.06666664203478607, 0.0588232553920069,
        -0.05262931380521779, 0.04760471049395462, -0.043407182638729704, 0.03971908106924452,
        -0.036139320776507194, 0.03213544133307827, -0.02718155333081564, 0.021121594179966983,
        -0.014503079564732733, 0.00844989240397037, -0.004000209679906822,
        0.0014617449054205385, -0.00038394037972999467, 6.417524965866564e-05,
        -5.1088410388226665e-06 };
    const double across = fabs(y), along = fabs(x);
    const double less = across < along ? across : along, more = across < along ? along : across;
    const double quotient = less == more ? 1.0 : less / more;
    const double t = more == 0.0 ? less : quotient;
    const double rest = t * linkage_times_polynomial(t * t, tangent, (int)(sizeof tangent / sizeof tangent[0]));
    const int is_steep = across > along, is_behind = signbit(x) != 0;
    const double turns = is_steep ? 1.0 : (is_behind ? 2.0 : 0.0);
    const double sign = is_steep != is_behind ? -1.0 : 1.0;
    const double low = turns * 6.123233995736766e-17 + sign * rest;
    return copysign(turns * 1.5707963267948966 + (sign * t + low), y + 0.0);
}

static inline double linkage_atan(double x) { return copysign(linkage_atan2(x, 1.0), x); }

/* Sine and cosine turned by quarter turns, of which the last two bits of `shifted` are the number. */
static inline void linkage_turn(double sine, double cosine, double shifted, double *to_sin, double *to_cos)
{
    /* Sines, each of which is the cosine of the quarter before. */
    static const double quarters[5] = { -0.0, 1.0, 0.0, -1.0, -0.0 };
    double by_sin, by_cos;
    uint64_t bits;
    (void)memcpy(&bits, &shifted, sizeof bits);
    by_sin = quarters[bits & 3u];
    by_cos = quarters[(bits & 3u) + 1u];
    *to_sin = linkage_fused(cosine, by_sin, sine * by_cos);
    *to_cos = linkage_fused(-sine, by_sin, cosine * by_cos);
}

/* True within the range of the kernels below. */
static inline int linkage_is_near(double x) { return x * x <= 1048576.0 * 1048576.0; }

/* Sine and cosine of r - excess and of quarter turns, the last bits of `shifted`: a polynomial each. */
static inline void linkage_sin_cos_of(double r, double excess, double shifted, double *to_sin, double *to_cos)
{
    const double z = r * r, z2 = z * z, half = 0.5 * z, head = 1.0 - half;
    const double head_error = (1.0 - head) - half;
    const double s3 = linkage_fused(z2, -1.5895433284842938e-10, linkage_fused(z, 2.5050734389219857e-8, -2.7557313538514158e-6));
    const double s1 = linkage_fused(z2, s3, linkage_fused(z, 0.00019841269829358528, -0.00833333333332184));
    const double s0 = linkage_fused(z, s1, 0.1666666666666663);
    const double sine = r - linkage_fused(z * r, s0, excess * head);
    const double c3 = linkage_fused(z2, -1.1358716362024778e-11, linkage_fused(z, 2.087570483459e-9, -2.7557314213561954e-7));
    const double c1 = linkage_fused(z2, c3, linkage_fused(z, 2.4801587288992887e-5, -0.0013888888888873333));
    const double c0 = linkage_fused(z, c1, 0.041666666666666595);
    const double cosine = head + linkage_fused(z2, c0, linkage_fused(r, excess, head_error));
    linkage_turn(sine, cosine, shifted, to_sin, to_cos);
}

/* Sine and cosine of a near angle: x = q*pi/2 + r by W. J. Cody and W. Waite. The remainder is
 * r - excess. */
static inline void linkage_sin_cos_exact(double x, double *to_sin, double *to_cos)
{
    const double shifted = linkage_fused(x, 0.6366197723675814, 6755399441055744.0);
    const double q = shifted - 6755399441055744.0;
    const double minuend = linkage_fused(-q, 1.5707963267341256, x);
    const double subtrahend = q * 6.077100506506192e-11;
    const double r = minuend - subtrahend;
    const double r_error = (minuend - r) - subtrahend;
    const double subtrahend_error = linkage_fused(q, 6.077100506303966e-11, -subtrahend) + q * 2.0222662487111665e-21;
    const double excess = linkage_fused(q, 8.4784276603689e-32, subtrahend_error - r_error);
    linkage_sin_cos_of(r, excess, shifted, to_sin, to_cos);
}

/* The same without what the remainder is rounded by, where operations are fused. */
static inline void linkage_sin_cos_near(double x, double *to_sin, double *to_cos)
{
#if defined(LINKAGE_SIN_COS_F64)
    LINKAGE_SIN_COS_F64(x, to_sin, to_cos);
#elif defined(LINKAGE_FUSES)
    const double shifted = linkage_fma(x, 0.6366197723675814, 6755399441055744.0);
    const double q = shifted - 6755399441055744.0;
    const double r = linkage_fma(-q, 6.123233995736766e-17, linkage_fma(-q, 1.5707963267948966, x));
    const double z = r * r, z2 = z * z;
    const double s4 = linkage_fma(z, 1.5895433284842938e-10, -2.5050734389219857e-8);
    const double s2 = linkage_fma(z, 2.7557313538514158e-6, -0.00019841269829358528);
    const double s0 = linkage_fma(z, 0.00833333333332184, -0.1666666666666663);
    const double c4 = linkage_fma(z, -1.1358716362024778e-11, 2.087570483459e-9);
    const double c2 = linkage_fma(z, -2.7557314213561954e-7, 2.4801587288992887e-5);
    const double c0 = linkage_fma(z, -0.0013888888888873333, 0.041666666666666595);
    const double sine = linkage_fma(z * r, linkage_fma(z2, linkage_fma(z2, s4, s2), s0), r);
    const double cosine = linkage_fma(z2, linkage_fma(z2, linkage_fma(z2, c4, c2), c0), linkage_fma(-0.5, z, 1.0));
    linkage_turn(sine, cosine, shifted, to_sin, to_cos);
#else
    linkage_sin_cos_exact(x, to_sin, to_cos);
#endif
}

/* The same of any other angle; not numbers where the angle is none. */
void linkage_sin_cos_far(double x, double *to_sin, double *to_cos);

/* Sine and cosine of any angle. */
static inline void linkage_sin_cos(double x, double *to_sin, double *to_cos)
{
    if (linkage_is_near(x)) {
#if defined(LINKAGE_SIN_COS_F64)
        LINKAGE_SIN_COS_F64(x, to_sin, to_cos);
#else
        linkage_sin_cos_exact(x, to_sin, to_cos);
#endif
    } else {
        linkage_sin_cos_far(x, to_sin, to_cos);
    }
}

/* The unit vector along a cosine and a sine whose amplitude may be off by a tenth. The answer says whether it
 * is off by no more. */
static inline int linkage_on_circle(double cosine, double sine, double *to_cos, double *to_sin)
{
    const double square = linkage_fused(cosine, cosine, sine * sine), inverse = 1.0 / linkage_sqrt(square);
    *to_cos = cosine * inverse;
    *to_sin = sine * inverse;
    return (square >= 0.81) & (1.21 >= square);
}

#endif /* LINKAGE_NO_DOUBLE */

/* A target's own functions in single precision, as the caller's header names them, each with its error. */
#if defined(LINKAGE_SIN_COS_F32)
#if !defined(LINKAGE_SIN_COS_WITHIN_F32) || LINKAGE_SIN_COS_WITHIN_F32 < 10
#error "LINKAGE_SIN_COS_F32 is wrong by 2^-n at most: define LINKAGE_SIN_COS_WITHIN_F32 as n, at least 10"
#endif
#endif
#if defined(LINKAGE_SQRT_F32)
#if !defined(LINKAGE_SQRT_PLACES_F32) || LINKAGE_SQRT_PLACES_F32 > 4
#error "LINKAGE_SQRT_F32 is wrong by n last places at most: define LINKAGE_SQRT_PLACES_F32 as n, at most 4"
#endif
#endif

static inline float linkage_sqrtf(float x)
{
#if defined(LINKAGE_SQRT_F32)
    return LINKAGE_SQRT_F32(x);
#else
    return sqrtf(x);
#endif
}

#ifdef LINKAGE_FUSESF
/* Rounded once, whatever computes it: errors of roundings rest on it. */
static inline float linkage_fmaf(float a, float b, float c)
{
#if defined(LINKAGE_FMA_F32)
    return LINKAGE_FMA_F32(a, b, c);
#else
    return fmaf(a, b, c);
#endif
}
#endif

/* In single precision. */

static inline int linkage_is_finitef(float x) { return fabsf(x) <= FLT_MAX; }

/* x has to be `bound` at most without its sign; a NaN is not. */
static inline int linkage_is_withinf(float x, float bound) { return fabsf(x) <= bound; }

/* As right as those of <math.h>. */
static inline float linkage_tanf(float x) { return tanf(x); }

static inline float linkage_expf(float x) { return expf(x); }

static inline float linkage_lnf(float x) { return logf(x); }

static inline float linkage_tanhf(float x) { return tanhf(x); }

static inline float linkage_powf(float x, float y) { return powf(x, y); }

/* The smallest square of full precision. */
static inline float linkage_smallest_squaref(void) { return FLT_MIN / (FLT_EPSILON * FLT_EPSILON); }

/* The rounding of a value that was made of numbers as large as this. */
static inline float linkage_roundingf(float spread) { return 16.0f * FLT_EPSILON * spread; }

/* a*b + c, with one rounding where the machine has an instruction for it. */
static inline float linkage_fusedf(float a, float b, float c)
{
#ifdef LINKAGE_FUSESF
    return linkage_fmaf(a, b, c);
#else
    return a * b + c;
#endif
}

/* The rounding error of `product`, which is a*b rounded: T. J. Dekker, Numerische Mathematik 18 (1971). */
static inline float linkage_product_errorf(float a, float b, float product)
{
#ifdef LINKAGE_FUSESF
    return linkage_fmaf(a, b, -product);
#else
    const float as = 4097.0f * a, ah = as - (as - a), al = a - ah;
    const float bs = 4097.0f * b, bh = bs - (bs - b), bl = b - bh;
    return ((ah * bh - product) + ah * bl + al * bh) + al * bl;
#endif
}

static inline float linkage_mul_errf(float a, float b) { return linkage_product_errorf(a, b, a * b); }

static inline float linkage_add_errf(float a, float b)
{
    const float sum = a + b, bp = sum - a, ap = sum - bp;
    return (a - ap) + (b - bp);
}

/* a*b - c*d without cancellation (W. Kahan). */
static inline float linkage_detf(float a, float b, float c, float d)
{
    const float cd = c * d;
#ifdef LINKAGE_FUSESF
    return linkage_fmaf(a, b, -cd) - linkage_fmaf(c, d, -cd);
#else
    const float ab = a * b;
    return (ab - cd) + (linkage_product_errorf(a, b, ab) - linkage_product_errorf(c, d, cd));
#endif
}

/* a >= b ? x : y */
static inline float linkage_selectf(float a, float b, float x, float y) { return a >= b ? x : y; }

/* The square root of x*x + y*y. It is right where their sum is at least `least` and a number; the answer
 * says whether. */
static inline int linkage_hypot_nearf(float x, float y, float least, float *length)
{
    const float square = linkage_fusedf(x, x, y * y);
    *length = linkage_sqrtf(square);
    return (square >= least) & (FLT_MAX >= square);
}

/* x*P(x) for coefficients from the lowest on, by Horner's scheme. */
static inline float linkage_times_polynomialf(float x, const float *coefficients, int count)
{
    float sum = 0.0f;
    int i;
    for (i = count; i > 0; i--) { /* at most 23 times */
        sum = linkage_fusedf(sum, x, coefficients[i - 1]);
    }
    return x * sum;
}

/* The number without the last bits, so that its square is exact. */
static inline float linkage_high_wordf(float s)
{
    uint32_t bits;
    (void)memcpy(&bits, &s, sizeof bits);
    bits = (uint32_t)(bits >> 12) << 12;
    (void)memcpy(&s, &bits, sizeof s);
    return s;
}

/* asin s = s + s*r of s = |x|, above a half of s = sqrt(z) with z = (1 - |x|)/2. */
static inline int linkage_halvedf(float x, float *z, float *s, float *r)
{
    static const float sine[] = { 0.16666666f, 0.07500094f, 0.044599403f, 0.031100662f, 0.017149238f, 0.033690847f };
    const float size = fabsf(x);
    const int is_large = size > 0.5f;
    *z = is_large ? 0.5f * (1.0f - size) : x * x;
    *s = is_large ? sqrtf(*z) : size;
    *r = linkage_times_polynomialf(*z, sine, (int)(sizeof sine / sizeof sine[0]));
    return is_large;
}

static inline float linkage_asinf(float x)
{
    float z, s, r, high, rest, missing, low, below;
    const int is_large = linkage_halvedf(x, &z, &s, &r);
    high = linkage_high_wordf(s);
    rest = s - high;
#ifdef LINKAGE_FUSESF
    missing = linkage_fmaf(-s, s, z);
#else
    missing = (z - high * high) - rest * (s + high);
#endif
    low = rest + missing * (1.5f - s);
    below = linkage_fusedf(s, r, low);
    below = 0.7853982f + ((0.7853982f - 2.0f * high) - (2.0f * below - -4.371139e-08f));
    return copysignf(is_large ? below : fabsf(x) + s * r, x);
}

static inline float linkage_acosf(float x)
{
    float z, s, r, high, rest, low, near_one, near_minus_one;
    const int is_large = linkage_halvedf(x, &z, &s, &r);
    high = linkage_high_wordf(s);
    rest = s * r;
    low = linkage_fusedf(s, r, (z - high * high) / (s + high + FLT_MIN));
    near_one = 2.0f * high + 2.0f * low;
    near_minus_one = 1.5707964f + ((1.5707964f - 2.0f * high) - (2.0f * low - 2.0f * -4.371139e-08f));
    if (is_large) {
        return x > 0.0f ? near_one : near_minus_one;
    }
    return 1.5707964f - (x - (-4.371139e-08f - copysignf(rest, x)));
}

/* Half a turn is positive whatever the sign of zero. */
static inline float linkage_atan2f(float y, float x)
{
    static const float tangent[] = { -0.33333334f, 0.1999995f, -0.14284004f, 0.11088262f, -0.08931827f, 0.070319146f,
        -0.048960514f, 0.026305001f, -0.009144629f, 0.0014886919f };
    const float across = fabsf(y), along = fabsf(x);
    const float less = across < along ? across : along, more = across < along ? along : across;
    const float quotient = less == more ? 1.0f : less / more;
    const float t = more == 0.0f ? less : quotient;
    const float rest = t * linkage_times_polynomialf(t * t, tangent, (int)(sizeof tangent / sizeof tangent[0]));
    const int is_steep = across > along, is_behind = signbit(x) != 0;
    const float turns = is_steep ? 1.0f : (is_behind ? 2.0f : 0.0f);
    const float sign = is_steep != is_behind ? -1.0f : 1.0f;
    const float low = turns * -4.371139e-08f + sign * rest;
    return copysignf(turns * 1.5707964f + (sign * t + low), y + 0.0f);
}

static inline float linkage_atanf(float x) { return copysignf(linkage_atan2f(x, 1.0f), x); }

/* Sine and cosine turned by quarter turns, of which the last two bits of `shifted` are the number. */
static inline void linkage_turnf(float sine, float cosine, float shifted, float *to_sin, float *to_cos)
{
    /* Sines, each of which is the cosine of the quarter before. */
    static const float quarters[5] = { -0.0f, 1.0f, 0.0f, -1.0f, -0.0f };
    float by_sin, by_cos;
    uint32_t bits;
    (void)memcpy(&bits, &shifted, sizeof bits);
    by_sin = quarters[bits & 3u];
    by_cos = quarters[(bits & 3u) + 1u];
    *to_sin = linkage_fusedf(cosine, by_sin, sine * by_cos);
    *to_cos = linkage_fusedf(-sine, by_sin, cosine * by_cos);
}

/* True within the range of the kernels below. */
static inline int linkage_is_nearf(float x) { return x * x <= 51471.0f * 51471.0f; }

/* Sine and cosine of r - excess and of quarter turns, the last bits of `shifted`. */
static inline void linkage_sin_cos_off(float r, float excess, float shifted, float *to_sin, float *to_cos)
{
    const float z = r * r, z2 = z * z, half = 0.5f * z, head = 1.0f - half;
    const float head_error = (1.0f - head) - half;
    const float s0 = linkage_fusedf(z2, 0.00019518277258612216f, linkage_fusedf(z, -0.008332189172506332f, 0.16666655242443085f));
    const float sine = r - linkage_fusedf(z * r, s0, excess * head);
    const float c0 = linkage_fusedf(z2, 2.4432327336398885e-5f, linkage_fusedf(z, -0.0013887309469282627f, 0.04166664555668831f));
    const float cosine = head + linkage_fusedf(z2, c0, linkage_fusedf(r, excess, head_error));
    linkage_turnf(sine, cosine, shifted, to_sin, to_cos);
}

/* Sine and cosine of a near angle in single precision throughout. */
static inline void linkage_sin_cos_exactf(float x, float *to_sin, float *to_cos)
{
    const float shifted = linkage_fusedf(x, 0.63661975f, 12582912.0f);
    const float q = shifted - 12582912.0f;
    const float minuend = linkage_fusedf(-q, 0.00048351287841796875f, linkage_fusedf(-q, 1.5703125f, x));
    const float subtrahend = q * 3.1391647326017846e-07f;
    const float r = minuend - subtrahend;
    const float r_error = (minuend - r) - subtrahend;
    const float subtrahend_error = linkage_fusedf(q, 3.1385570764541626e-7f, -subtrahend) + q * 6.070877134334296e-11f;
    const float excess = linkage_fusedf(q, 6.223371969669989e-14f, subtrahend_error - r_error);
    linkage_sin_cos_off(r, excess, shifted, to_sin, to_cos);
}

static inline void linkage_sin_cos_nearf(float x, float *to_sin, float *to_cos)
{
#if defined(LINKAGE_SIN_COS_F32)
    LINKAGE_SIN_COS_F32(x, to_sin, to_cos);
#else
    linkage_sin_cos_exactf(x, to_sin, to_cos);
#endif
}

/* The remainder of any other angle, r - excess, and its quarter turns; not numbers where the angle is none. */
void linkage_reducef(float x, float *r, float *excess, float *shifted);

static inline void linkage_sin_cos_farf(float x, float *to_sin, float *to_cos)
{
    float r, excess, shifted;
    linkage_reducef(x, &r, &excess, &shifted);
    linkage_sin_cos_off(r, excess, shifted, to_sin, to_cos);
}

/* Sine and cosine of any angle. */
static inline void linkage_sin_cosf(float x, float *to_sin, float *to_cos)
{
    if (linkage_is_nearf(x)) {
#if defined(LINKAGE_SIN_COS_F32)
        LINKAGE_SIN_COS_F32(x, to_sin, to_cos);
#else
        linkage_sin_cos_exactf(x, to_sin, to_cos);
#endif
    } else {
        linkage_sin_cos_farf(x, to_sin, to_cos);
    }
}

/* The unit vector along a cosine and a sine whose amplitude may be off by a tenth. The answer says whether it
 * is off by no more. */
static inline int linkage_on_circlef(float cosine, float sine, float *to_cos, float *to_sin)
{
    const float square = linkage_fusedf(cosine, cosine, sine * sine), inverse = 1.0f / linkage_sqrtf(square);
    *to_cos = cosine * inverse;
    *to_sin = sine * inverse;
    return (square >= 0.81f) & (1.21f >= square);
}

#ifdef LINKAGE_NO_DOUBLE

/* A number in two words, the second less than a last place of the first: 48 bits where a double would have 53. Operations
 * are right to some units of 2^-47: M. Joldes, J.-M. Muller and V. Popescu, ACM Trans. Math. Softw. 44 (2017). */
typedef struct LinkagePair {
    float high;
    float low;
} LinkagePair;

static inline LinkagePair linkage_pair(float high, float low)
{
    LinkagePair pair;
    pair.high = high;
    pair.low = low;
    return pair;
}

/* a + b without rounding, where a is the larger. */
static inline LinkagePair linkage_pair_joined(float a, float b)
{
    const float sum = a + b;
    return linkage_pair(sum, b - (sum - a));
}

static inline LinkagePair linkage_pair_sum(float a, float b) { return linkage_pair(a + b, linkage_add_errf(a, b)); }

/* What is lost of a product is exact by a fused operation and without one: it is used wherever it is there. */
static inline LinkagePair linkage_pair_product(float a, float b)
{
    const float product = a * b;
#if defined(__FP_FAST_FMAF)
    return linkage_pair(product, fmaf(a, b, -product));
#else
    return linkage_pair(product, linkage_product_errorf(a, b, product));
#endif
}

static inline LinkagePair linkage_pair_minus(LinkagePair a) { return linkage_pair(-a.high, -a.low); }

static inline LinkagePair linkage_pair_plus(LinkagePair a, LinkagePair b)
{
    const LinkagePair high = linkage_pair_sum(a.high, b.high), low = linkage_pair_sum(a.low, b.low);
    const LinkagePair sum = linkage_pair_joined(high.high, high.low + low.high);
    return linkage_pair_joined(sum.high, sum.low + low.low);
}

static inline LinkagePair linkage_pair_times(LinkagePair a, LinkagePair b)
{
    const LinkagePair product = linkage_pair_product(a.high, b.high);
    return linkage_pair_joined(product.high, product.low + linkage_fusedf(a.high, b.low, a.low * b.high));
}

static inline LinkagePair linkage_pair_over(LinkagePair a, LinkagePair b)
{
    const float quotient = a.high / b.high;
    const LinkagePair taken = linkage_pair_times(b, linkage_pair(quotient, 0.0f));
    const float rest = (a.high - taken.high) + (a.low - taken.low);
    return linkage_pair_joined(quotient, rest / b.high);
}

/* Nought of nought. */
static inline LinkagePair linkage_pair_root(LinkagePair a)
{
    const float root = sqrtf(a.high);
    const LinkagePair square = linkage_pair_product(root, root);
    const float rest = (a.high - square.high) + (a.low - square.low);
    return root > 0.0f ? linkage_pair_joined(root, rest / (root + root)) : linkage_pair(root, 0.0f);
}

/* True if the first is the larger. */
static inline int linkage_pair_above(LinkagePair a, LinkagePair b)
{
    return a.high > b.high || (a.high == b.high && a.low > b.low);
}

#endif /* LINKAGE_NO_DOUBLE */

/* Why there is no answer, while the slow path looks for it. */
typedef struct LinkageWhy {
    LinkageStatus status;
    int is_single;
    LinkageWide by;
    const char *group;
    const char *name;
    const char *otherwise; /* the unknown to blame where nothing else is wrong */
    /* True if formulas go on behind what has no pose, this in its place, and NaN behind any other refusal. */
    int goes_on;
    LinkageWide stand_in;
    int is_open; /* true if an equation was found open, behind which nothing becomes NaN */
} LinkageWhy;

/* A number and what an error calls it. */
typedef struct LinkageNamed {
    LinkageWide value;
    const char *name;
} LinkageNamed;

LinkageWhy linkage_why(int is_single);
LinkageWhy linkage_why_behind(int is_single, LinkageWide stand_in);
LinkageStatus linkage_refused(const LinkageWhy *why, LinkageError *error);
LinkageStatus linkage_because(LinkageError *error, LinkageStatus status, const char *name);
LinkageStatus linkage_not_on_circle(LinkageError *error, LinkageWide cosine, LinkageWide sine, const char *name);

/* What is given has to be finite, and what comes out. */
void linkage_given_finite(LinkageWhy *why, const LinkageNamed *given, int count);
void linkage_results_finite(LinkageWhy *why, const LinkageNamed *results, int count, const LinkageNamed *given, int given_count);

/* Margins where a group has no pose: true if some of them are known, and the others are NaN because they stand
 * behind it. These are numbers where `others` has another number in the place of what the group lacks. */
int linkage_lacks_a_pose(const LinkageWhy *why);
int linkage_is_told(const LinkageWide *told, const LinkageWide *others, int count);

/* The conditions of the formulas: each returns the value under it, or what stands for it at a limit. */
LinkageWide linkage_nonzero(LinkageWhy *why, LinkageWide value, const char *group);
LinkageWide linkage_positive(LinkageWhy *why, LinkageWide value, const char *group, const char *name);
LinkageWide linkage_not_negative(LinkageWhy *why, LinkageWide value, const char *group, const char *name);
LinkageWide linkage_square(LinkageWhy *why, LinkageWide value, const char *group);
LinkageWide linkage_moving(LinkageWhy *why, LinkageWide value, LinkageWide spread, const char *name);
LinkageWide linkage_certified(LinkageWhy *why, LinkageWide value, const char *group);
LinkageWide linkage_closed(LinkageWhy *why, LinkageWide difference, LinkageWide size, const char *unknown);
LinkageWide linkage_reach_circles(LinkageWhy *why, LinkageWide value, LinkageWide dx, LinkageWide dy, LinkageWide l1, LinkageWide l2, LinkageWide unit, LinkageWide spread, const char *group);
LinkageWide linkage_share_of_centres(LinkageWhy *why, LinkageWide value, LinkageWide height, LinkageWide dx, LinkageWide dy, LinkageWide l1, LinkageWide l2, LinkageWide spread, const char *group);
LinkageWide linkage_reach_distances(LinkageWhy *why, LinkageWide value, LinkageWide l, LinkageWide r1, LinkageWide r2, LinkageWide spread, const char *group);
LinkageWide linkage_square_of_centres(LinkageWhy *why, LinkageWide value, LinkageWide dx, LinkageWide dy, LinkageWide l1, LinkageWide l2, const char *group);
LinkageWide linkage_reach_line(LinkageWhy *why, LinkageWide value, LinkageWide t, LinkageWide l, const char *group);
LinkageWide linkage_reach_offset(LinkageWhy *why, LinkageWide value, LinkageWide bx, LinkageWide by, LinkageWide e, const char *group);

/* sqrt(x*x + y*y) without overflow on the way. */
#ifndef LINKAGE_NO_DOUBLE
double linkage_hypot(double x, double y);
#endif
#ifndef LINKAGE_NO_SINGLE
float linkage_hypotf(float x, float y);
#endif

#ifndef LINKAGE_NO_DOUBLE

/* Where a root is looked for, with the trend that f has there, 1 or -1, and from which seed. */
typedef struct LinkageBetween {
    double from;
    double to;
    double trend;
    double seed;
    int has_seed;
    int is_turn; /* true for an angle whose ends, a turn apart at most, are known here alone */
    int is_steady; /* true if the slope is proved to have one sign between the ends */
} LinkageBetween;

/* The sides of an equation at a trial, and the slope of their difference. */
typedef void (*LinkageSides)(const double *given, double trial, double *sides);

/* The root, in linkage_root.c, and the size that its rounding is measured by. The answer says whether there is
 * one. */
int linkage_root(LinkageWhy *why, const char *unknown, const LinkageBetween *between, LinkageSides sides, const double *given, double *found);

#endif /* LINKAGE_NO_DOUBLE */

/* Where a root is looked for, with the trend that f has there, 1 or -1, and from which seed. */
typedef struct LinkageBetweenf {
    float from;
    float to;
    float trend;
    float seed;
    int has_seed;
    int is_turn; /* true for an angle whose ends, a turn apart at most, are known here alone */
    int is_steady; /* true if the slope is proved to have one sign between the ends */
} LinkageBetweenf;

/* The sides of an equation at a trial, and the slope of their difference. */
typedef void (*LinkageSidesf)(const float *given, float trial, float *sides);

/* The root, in linkage_root.c, and the size that its rounding is measured by. The answer says whether there is
 * one. */
int linkage_rootf(LinkageWhy *why, const char *unknown, const LinkageBetweenf *between, LinkageSidesf sides, const float *given, float *found);

#ifndef LINKAGE_NO_DOUBLE

/* True if the first is less than rounding leaves of the second: what straight-line steps to amounts of friction end
 * with. */
static inline int linkage_is_settled(double first, double second) { return 4.0 * DBL_EPSILON * second > first; }

/* Amounts of friction that depend on each other, in linkage_friction.c: so many, by steps from these values. A row is
 * a share, a reaction without friction, and its changes by a unit of each amount. The first answers whether steps
 * without a branch have found them; the second says why there are none. */
int linkage_amounts(int count, unsigned guides, const double *rows, const double *start, double *amounts);
void linkage_friction(LinkageWhy *why, const char *const *joints, int count, unsigned guides, const double *rows, const double *start, double *amounts);

#endif /* LINKAGE_NO_DOUBLE */

/* True if the first is less than rounding leaves of the second: what straight-line steps to amounts of friction end
 * with. */
static inline int linkage_is_settledf(float first, float second) { return 4.0f * FLT_EPSILON * second > first; }

/* Amounts of friction that depend on each other, in linkage_friction.c: so many, by steps from these values. A row is
 * a share, a reaction without friction, and its changes by a unit of each amount. The first answers whether steps
 * without a branch have found them; the second says why there are none. */
int linkage_amountsf(int count, unsigned guides, const float *rows, const float *start, float *amounts);
void linkage_frictionf(LinkageWhy *why, const char *const *joints, int count, unsigned guides, const float *rows, const float *start, float *amounts);

#ifdef __cplusplus
}
#endif

#endif /* LINKAGE_RUN_H */
