
/* In TYPE. */

static inline int linkage_is_finite@(REAL x) { return fabs@(x) <= LEAST_MAX; }

/* x has to be `bound` at most without its sign; a NaN is not. */
static inline int linkage_is_within@(REAL x, REAL bound) { return fabs@(x) <= bound; }

/* As right as those of <math.h>. */
static inline REAL linkage_tan@(REAL x) { return tan@(x); }

static inline REAL linkage_exp@(REAL x) { return exp@(x); }

static inline REAL linkage_ln@(REAL x) { return log@(x); }

static inline REAL linkage_tanh@(REAL x) { return tanh@(x); }

static inline REAL linkage_pow@(REAL x, REAL y) { return pow@(x, y); }

/* The smallest square of full precision. */
static inline REAL linkage_smallest_square@(void) { return LEAST_MIN / (LEAST_EPSILON * LEAST_EPSILON); }

/* The rounding of a value that was made of numbers as large as this. */
static inline REAL linkage_rounding@(REAL spread) { return 16.0@ * LEAST_EPSILON * spread; }

/* a*b + c, with one rounding where the machine has an instruction for it. */
static inline REAL linkage_fused@(REAL a, REAL b, REAL c)
{
#ifdef LINKAGE_FUSES_
    return linkage_fma@(a, b, c);
#else
    return a * b + c;
#endif
}

/* The rounding error of `product`, which is a*b rounded: T. J. Dekker, Numerische Mathematik 18 (1971). */
static inline REAL linkage_product_error@(REAL a, REAL b, REAL product)
{
#ifdef LINKAGE_FUSES_
    return linkage_fma@(a, b, -product);
#else
    const REAL as = SPLITTER * a, ah = as - (as - a), al = a - ah;
    const REAL bs = SPLITTER * b, bh = bs - (bs - b), bl = b - bh;
    return ((ah * bh - product) + ah * bl + al * bh) + al * bl;
#endif
}

static inline REAL linkage_mul_err@(REAL a, REAL b) { return linkage_product_error@(a, b, a * b); }

static inline REAL linkage_add_err@(REAL a, REAL b)
{
    const REAL sum = a + b, bp = sum - a, ap = sum - bp;
    return (a - ap) + (b - bp);
}

/* a*b - c*d without cancellation (W. Kahan). */
static inline REAL linkage_det@(REAL a, REAL b, REAL c, REAL d)
{
    const REAL cd = c * d;
#ifdef LINKAGE_FUSES_
    return linkage_fma@(a, b, -cd) - linkage_fma@(c, d, -cd);
#else
    const REAL ab = a * b;
    return (ab - cd) + (linkage_product_error@(a, b, ab) - linkage_product_error@(c, d, cd));
#endif
}

/* a >= b ? x : y */
static inline REAL linkage_select@(REAL a, REAL b, REAL x, REAL y) { return a >= b ? x : y; }

/* The square root of x*x + y*y. It is right where their sum is at least `least` and a number; the answer
 * says whether. */
static inline int linkage_hypot_near@(REAL x, REAL y, REAL least, REAL *length)
{
    const REAL square = linkage_fused@(x, x, y * y);
    *length = linkage_sqrt@(square);
    return (square >= least) & (LEAST_MAX >= square);
}

/* x*P(x) for coefficients from the lowest on, by Horner's scheme. */
static inline REAL linkage_times_polynomial@(REAL x, const REAL *coefficients, int count)
{
    REAL sum = 0.0@;
    int i;
    for (i = count; i > 0; i--) { /* at most 23 times */
        sum = linkage_fused@(sum, x, coefficients[i - 1]);
    }
    return x * sum;
}

/* The number without the last bits, so that its square is exact. */
static inline REAL linkage_high_word@(REAL s)
{
    BITS bits;
    (void)memcpy(&bits, &s, sizeof bits);
    bits = (BITS)(bits >> HALF_OF_BITS) << HALF_OF_BITS;
    (void)memcpy(&s, &bits, sizeof s);
    return s;
}

/* asin s = s + s*r of s = |x|, above a half of s = sqrt(z) with z = (1 - |x|)/2. */
static inline int linkage_halved@(REAL x, REAL *z, REAL *s, REAL *r)
{
    static const REAL sine[] = { ARC_SINE };
    const REAL size = fabs@(x);
    const int is_large = size > 0.5@;
    *z = is_large ? 0.5@ * (1.0@ - size) : x * x;
    *s = is_large ? sqrt@(*z) : size;
    *r = linkage_times_polynomial@(*z, sine, (int)(sizeof sine / sizeof sine[0]));
    return is_large;
}

static inline REAL linkage_asin@(REAL x)
{
    REAL z, s, r, high, rest, missing, low, below;
    const int is_large = linkage_halved@(x, &z, &s, &r);
    high = linkage_high_word@(s);
    rest = s - high;
#ifdef LINKAGE_FUSES_
    missing = linkage_fma@(-s, s, z);
#else
    missing = (z - high * high) - rest * (s + high);
#endif
    low = rest + missing * (1.5@ - s);
    below = linkage_fused@(s, r, low);
    below = EIGHTH_TURN + ((EIGHTH_TURN - 2.0@ * high) - (2.0@ * below - QUARTER_LOW));
    return copysign@(is_large ? below : fabs@(x) + s * r, x);
}

static inline REAL linkage_acos@(REAL x)
{
    REAL z, s, r, high, rest, low, near_one, near_minus_one;
    const int is_large = linkage_halved@(x, &z, &s, &r);
    high = linkage_high_word@(s);
    rest = s * r;
    low = linkage_fused@(s, r, (z - high * high) / (s + high + LEAST_MIN));
    near_one = 2.0@ * high + 2.0@ * low;
    near_minus_one = QUARTER_TURN + ((QUARTER_TURN - 2.0@ * high) - (2.0@ * low - 2.0@ * QUARTER_LOW));
    if (is_large) {
        return x > 0.0@ ? near_one : near_minus_one;
    }
    return QUARTER_TURN - (x - (QUARTER_LOW - copysign@(rest, x)));
}

/* Half a turn is positive whatever the sign of zero. */
static inline REAL linkage_atan2@(REAL y, REAL x)
{
    static const REAL tangent[] = { ARC_TANGENT };
    const REAL across = fabs@(y), along = fabs@(x);
    const REAL less = across < along ? across : along, more = across < along ? along : across;
    const REAL quotient = less == more ? 1.0@ : less / more;
    const REAL t = more == 0.0@ ? less : quotient;
    const REAL rest = t * linkage_times_polynomial@(t * t, tangent, (int)(sizeof tangent / sizeof tangent[0]));
    const int is_steep = across > along, is_behind = signbit(x) != 0;
    const REAL turns = is_steep ? 1.0@ : (is_behind ? 2.0@ : 0.0@);
    const REAL sign = is_steep != is_behind ? -1.0@ : 1.0@;
    const REAL low = turns * QUARTER_LOW + sign * rest;
    return copysign@(turns * QUARTER_TURN + (sign * t + low), y + 0.0@);
}

static inline REAL linkage_atan@(REAL x) { return copysign@(linkage_atan2@(x, 1.0@), x); }

/* Sine and cosine turned by quarter turns, of which the last two bits of `shifted` are the number. */
static inline void linkage_turn@(REAL sine, REAL cosine, REAL shifted, REAL *to_sin, REAL *to_cos)
{
    /* Sines, each of which is the cosine of the quarter before. */
    static const REAL quarters[5] = { -0.0@, 1.0@, 0.0@, -1.0@, -0.0@ };
    REAL by_sin, by_cos;
    BITS bits;
    (void)memcpy(&bits, &shifted, sizeof bits);
    by_sin = quarters[bits & 3u];
    by_cos = quarters[(bits & 3u) + 1u];
    *to_sin = linkage_fused@(cosine, by_sin, sine * by_cos);
    *to_cos = linkage_fused@(-sine, by_sin, cosine * by_cos);
}

/* True within the range of the kernels below. */
static inline int linkage_is_near@(REAL x) { return x * x <= NEAR * NEAR; }
