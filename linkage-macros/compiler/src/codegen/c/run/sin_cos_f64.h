
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
