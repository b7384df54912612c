/* Angles beyond the kernels' range. */

/* 2/pi in words of 32 bits, behind 64 zeros. */
static const uint32_t digits_of_quadrants[39] = {
    0x00000000u, 0x00000000u, 0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u,
    0xfe5163abu, 0xdebbc561u, 0xb7246e3au, 0x424dd2e0u, 0x06492eeau, 0x09d1921cu, 0xfe1deb1cu, 0xb129a73eu,
    0xe88235f5u, 0x2ebb4484u, 0xe99c7026u, 0xb45f7e41u, 0x3991d639u, 0x835339f4u, 0x9c845f8bu, 0xbdf9283bu,
    0x1ff897ffu, 0xde05980fu, 0xef2f118bu, 0x5a0a6d1fu, 0x6d367ecfu, 0x27cb09b7u, 0x4f463f66u, 0x9e5fea2du,
    0x7527bac7u, 0xebe5f17bu, 0x3d0739f7u, 0x8a5292eau, 0x6bfb5fb1u, 0x1f8d5d08u, 0x56033046u
};

/* The last 192 bits of the product of an integer and of six words of the digits, the last ones first. */
static void multiplied(uint64_t mantissa, int start, uint32_t *product)
{
    const int word = start / 32, shift = start % 32;
    int place, i;
    memset(product, 0, 6 * sizeof *product);
    for (place = 0; place < 2; place++) {
        const uint64_t factor = place == 0 ? mantissa & 0xffffffffu : mantissa >> 32;
        uint64_t carry = 0;
        for (i = 0; i + place < 6; i++) {
            const uint32_t *pair = &digits_of_quadrants[word + 5 - i];
            const uint32_t digit = (uint32_t)(((uint64_t)pair[0] << 32 | pair[1]) >> (32 - shift));
            const uint64_t sum = factor * digit + product[i + place] + carry;
            product[i + place] = (uint32_t)sum;
            carry = sum >> 32;
        }
    }
}

/* The number of quarter turns of a finite angle of 2^15 or more, its last bits, and the rest in quarter turns in two
 * words: M. H. Payne and R. N. Hanek, SIGNUM Newsletter 18 (1983). Digits of 2/pi that make whole turns are left
 * out, and 190 binary places behind them are computed, of which 128 are kept. */
static int quarters_of(double x, double rest[2])
{
    uint64_t bits, mantissa, first, second, flip;
    uint32_t p[6];
    double high, middle, sum;
    int count, is_above_half;
    memcpy(&bits, &x, sizeof bits);
    mantissa = (bits & (((uint64_t)1 << 52) - 1u)) | (uint64_t)1 << 52;
    multiplied(mantissa, (int)(bits >> 52 & 0x7ffu) - 1013, p);
    first = (uint64_t)p[5] << 34 | (uint64_t)p[4] << 2 | p[3] >> 30;
    second = (uint64_t)p[3] << 34 | (uint64_t)p[2] << 2 | p[1] >> 30;
    is_above_half = (int)(first >> 63);
    count = (int)(p[5] >> 30) + is_above_half;
    flip = is_above_half ? ~(uint64_t)0 : 0;
    first ^= flip;
    second ^= flip;
    high = (double)(first >> 32) * 0x1p-32;
    middle = (double)((first & 0xffffffffu) << 20 | second >> 44) * 0x1p-84;
    sum = high + middle;
    rest[0] = sum;
    rest[1] = ((high - sum) + middle) + (double)(second & (((uint64_t)1 << 44) - 1u)) * 0x1p-128;
    if (is_above_half != (x < 0.0)) {
        rest[0] = -rest[0];
        rest[1] = -rest[1];
    }
    return x < 0.0 ? -count : count;
}

#ifndef LINKAGE_NO_DOUBLE
LINKAGE_COLD void linkage_sin_cos_far(double x, double *to_sin, double *to_cos)
{
    double rest[2], product, error, r;
    int count;
    if (!linkage_is_finite(x)) {
        *to_sin = *to_cos = x - x;
        return;
    }
    count = quarters_of(x, rest);
    product = rest[0] * 1.5707963267948966;
    error = linkage_mul_err(rest[0], 1.5707963267948966) + (rest[0] * 6.123233995736766e-17 + rest[1] * 1.5707963267948966);
    r = product + error;
    linkage_sin_cos_of(r, (r - product) - error, 6755399441055744.0 + count, to_sin, to_cos);
}
#endif /* LINKAGE_NO_DOUBLE */

#ifndef LINKAGE_NO_SINGLE
LINKAGE_COLD void linkage_sin_cos_farf(float x, float *to_sin, float *to_cos)
{
    double rest[2], wide;
    float r;
    int count;
    if (!linkage_is_finitef(x)) {
        *to_sin = *to_cos = x - x;
        return;
    }
    count = quarters_of((double)x, rest);
    wide = (rest[0] + rest[1]) * 1.5707963267948966;
    r = (float)wide;
    linkage_sin_cos_off(r, (float)((double)r - wide), 12582912.0f + (float)count, to_sin, to_cos);
}
#endif /* LINKAGE_NO_SINGLE */
