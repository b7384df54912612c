
/* Sine and cosine of any angle. */
static inline void linkage_sin_cos@(REAL x, REAL *to_sin, REAL *to_cos)
{
    if (linkage_is_near@(x)) {
#if defined(LINKAGE_SIN_COS_OF_WIDTH)
        LINKAGE_SIN_COS_OF_WIDTH(x, to_sin, to_cos);
#else
        linkage_sin_cos_exact@(x, to_sin, to_cos);
#endif
    } else {
        linkage_sin_cos_far@(x, to_sin, to_cos);
    }
}

/* The unit vector along a cosine and a sine whose amplitude may be off by a tenth. The answer says whether it
 * is off by no more. */
static inline int linkage_on_circle@(REAL cosine, REAL sine, REAL *to_cos, REAL *to_sin)
{
    const REAL square = linkage_fused@(cosine, cosine, sine * sine), inverse = 1.0@ / linkage_sqrt@(square);
    *to_cos = cosine * inverse;
    *to_sin = sine * inverse;
    return (square >= 0.81@) & (1.21@ >= square);
}
