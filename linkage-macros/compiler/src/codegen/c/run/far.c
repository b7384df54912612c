/* Angles beyond the kernels' range. */

#ifndef LINKAGE_NO_DOUBLE

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
    (void)memset(product, 0, 6 * sizeof *product);
    for (place = 0; place < 2; place++) { /* at most 2 times */
        const uint64_t factor = place == 0 ? mantissa & 0xffffffffu : mantissa >> 32;
        uint64_t carry = 0;
        for (i = 0; i + place < 6; i++) { /* at most 6 times */
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
    (void)memcpy(&bits, &x, sizeof bits);
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

LINKAGE_COLD void linkage_sin_cos_far(double x, double *to_sin, double *to_cos)
{
    double rest[2], product, error, r;
    int count;
    if (!linkage_is_finite(x)) {
        *to_sin = x - x;
        *to_cos = *to_sin;
        return;
    }
    count = quarters_of(x, rest);
    product = rest[0] * 1.5707963267948966;
    error = linkage_mul_err(rest[0], 1.5707963267948966) + (rest[0] * 6.123233995736766e-17 + rest[1] * 1.5707963267948966);
    r = product + error;
    linkage_sin_cos_of(r, (r - product) - error, 6755399441055744.0 + count, to_sin, to_cos);
}

#ifndef LINKAGE_NO_SINGLE
/* The remainder of an angle in single precision, in rad and in two words, and its count of quarter turns. */
static int remainder_of(float x, float *r, float *excess)
{
    double rest[2], wide;
    const int count = quarters_of((double)x, rest);
    wide = (rest[0] + rest[1]) * 1.5707963267948966;
    *r = (float)wide;
    *excess = (float)((double)*r - wide);
    return count;
}
#endif /* LINKAGE_NO_SINGLE */

#else

/* 2/pi in words of 32 bits, behind 32 zeros. */
static const uint32_t digits_of_quadrants[9] = {
    0x00000000u, 0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u, 0xfe5163abu, 0xdebbc561u
};

/* The same by three words of the product of 24 bits of the angle and 128 of 2/pi, without those that make whole
 * turns. */
static int remainder_of(float x, float *r, float *excess)
{
    uint32_t bits, mantissa, product[4], first, second, third, carry = 0u, flip;
    LinkagePair rest;
    Sum sum;
    int start, i, count, is_above_half;
    (void)memcpy(&bits, &x, sizeof bits);
    mantissa = (bits & 0x7fffffu) | 0x800000u;
    start = (int)(bits >> 23 & 0xffu) - (127 + 23 - 30);
    for (i = 3; i >= 0; i--) { /* at most 4 times */
        const uint32_t *pair = &digits_of_quadrants[start / 32 + i];
        const uint32_t digit = (uint32_t)(((uint64_t)pair[0] << 32 | pair[1]) >> (32 - start % 32));
        const uint64_t place = (uint64_t)mantissa * digit + carry;
        product[i] = (uint32_t)place;
        carry = (uint32_t)(place >> 32);
    }
    first = product[0] << 2 | product[1] >> 30;
    second = product[1] << 2 | product[2] >> 30;
    third = product[2] << 2 | product[3] >> 30;
    is_above_half = (int)(first >> 31);
    count = (int)(product[0] >> 30) + is_above_half;
    flip = is_above_half ? 0xffffffffu : 0u;
    first ^= flip;
    second ^= flip;
    third ^= flip;
    /* Words of 24 bits are exact. */
    sum.count = 0;
    add(&sum, (float)(third & 0xffffffu) * 0x1p-96f);
    add(&sum, (float)((second & 0xffffu) << 8 | third >> 24) * 0x1p-72f);
    add(&sum, (float)((first & 0xffu) << 16 | second >> 16) * 0x1p-48f);
    add(&sum, (float)(first >> 8) * 0x1p-24f);
    rest = pair_of(&sum);
    rest = linkage_pair_times(rest, linkage_pair(1.57079637f, -4.37113883e-08f));
    if (is_above_half != (x < 0.0f)) {
        rest = linkage_pair_minus(rest);
    }
    *r = rest.high;
    *excess = -rest.low;
    return x < 0.0f ? -count : count;
}

#endif /* LINKAGE_NO_DOUBLE */

#ifndef LINKAGE_NO_SINGLE
LINKAGE_COLD void linkage_reducef(float x, float *r, float *excess, float *shifted)
{
    *r = x - x;
    *excess = 0.0f;
    *shifted = 12582912.0f;
    if (linkage_is_finitef(x)) {
        *shifted += (float)remainder_of(x, r, excess);
    }
}
#endif /* LINKAGE_NO_SINGLE */
