
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
