
/* A target's own functions in TYPE, as the caller's header names them, each with its error. */
#if defined(LINKAGE_SIN_COS_OF_WIDTH)
#if !defined(LINKAGE_SIN_COS_WITHIN_OF_WIDTH) || LINKAGE_SIN_COS_WITHIN_OF_WIDTH < 10
#error "LINKAGE_SIN_COS_OF_WIDTH is wrong by 2^-n at most: define LINKAGE_SIN_COS_WITHIN_OF_WIDTH as n, at least 10"
#endif
#endif
#if defined(LINKAGE_SQRT_OF_WIDTH)
#if !defined(LINKAGE_SQRT_PLACES_OF_WIDTH) || LINKAGE_SQRT_PLACES_OF_WIDTH > 4
#error "LINKAGE_SQRT_OF_WIDTH is wrong by n last places at most: define LINKAGE_SQRT_PLACES_OF_WIDTH as n, at most 4"
#endif
#endif

static inline REAL linkage_sqrt@(REAL x)
{
#if defined(LINKAGE_SQRT_OF_WIDTH)
    return LINKAGE_SQRT_OF_WIDTH(x);
#else
    return sqrt@(x);
#endif
}

#ifdef LINKAGE_FUSES_
/* Rounded once, whatever computes it: errors of roundings rest on it. */
static inline REAL linkage_fma@(REAL a, REAL b, REAL c)
{
#if defined(LINKAGE_FMA_OF_WIDTH)
    return LINKAGE_FMA_OF_WIDTH(a, b, c);
#else
    return fma@(a, b, c);
#endif
}
#endif
