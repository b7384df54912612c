#else

/* Numbers without rounding, in single precision alone. */

#define TERMS 16

/* A sum in parts of rising size that do not overlap, of so many terms at most: J. R. Shewchuk, Discrete & Computational
 * Geometry 18 (1997), grow-expansion with elimination of zeros. */
typedef struct Sum {
    float parts[TERMS];
    int count;
} Sum;

static void add(Sum *sum, float term)
{
    int i, kept = 0;
    if (term == 0.0f) {
        return;
    }
    for (i = 0; i < sum->count; i++) { /* at most TERMS times */
        const float next = term + sum->parts[i], rest = linkage_add_errf(term, sum->parts[i]);
        term = next;
        if (rest != 0.0f) {
            sum->parts[kept++] = rest;
        }
    }
    if (term != 0.0f) {
        sum->parts[kept++] = term;
    }
    sum->count = kept;
}

static void add_product(Sum *sum, float x, float y)
{
    const LinkagePair product = linkage_pair_product(x, y);
    add(sum, product.low);
    add(sum, product.high);
}

/* A number of the sum's sign: the largest part. */
static float sign_of(const Sum *sum) { return sum->count > 0 ? sum->parts[sum->count - 1] : 0.0f; }

/* The sum in two words. */
static LinkagePair pair_of(const Sum *sum)
{
    LinkagePair pair = linkage_pair(sign_of(sum), 0.0f);
    int i;
    for (i = sum->count - 2; i >= 0; i--) { /* at most TERMS times */
        const LinkagePair next = linkage_pair_joined(pair.high, sum->parts[i]);
        pair = linkage_pair(next.high, pair.low + next.low);
    }
    return linkage_pair_joined(pair.high, pair.low);
}

/* The exponent of a number above zero. */
static int exponent_of(float x)
{
    const int is_subnormal = x < FLT_MIN;
    uint32_t bits;
    x = is_subnormal ? x * 16777216.0f : x;
    (void)memcpy(&bits, &x, sizeof bits);
    return (int)(bits >> 23 & 0xffu) - (is_subnormal ? 127 + 24 : 127);
}

/* The exponent of the largest number in the scale: the products of numbers down to 2^-111 of it are then sums of two
 * words. */
#define LARGEST 60

/* x*2^shift for shifts of 250 at most, by two factors within the range. */
static LINKAGE_COLD float scaled(float x, int shift)
{
    const int half = shift / 2;
    return x * power_of_twof(half) * power_of_twof(shift - half);
}

/* Without its sign, and never zero but where it was. */
static float scaled_size(float x, int shift)
{
    const float size = fabsf(scaled(x, shift));
    return size == 0.0f && x != 0.0f ? 0x1p-149f : size;
}

/* The shift that brings the largest of some numbers between 2^60 and 2^61. */
static int scale_of(int *shift, const float *numbers, int count)
{
    float largest = 0x1p-149f;
    int i;
    for (i = 0; i < count; i++) { /* at most 4 times */
        if (!linkage_is_finitef(numbers[i])) {
            return 0;
        }
        largest = fabsf(numbers[i]) > largest ? fabsf(numbers[i]) : largest;
    }
    *shift = LARGEST - exponent_of(largest);
    return 1;
}

/* dx^2 + dy^2 - (a + b + w)^2 for a power of two w, or none. */
static LINKAGE_COLD void excess_with(float dx, float dy, float a, float b, float w, Sum *sum)
{
    const LinkagePair span = linkage_pair_sum(a, b);
    const LinkagePair x = linkage_pair_product(dx, dx), y = linkage_pair_product(dy, dy);
    const LinkagePair square = linkage_pair_product(-span.high, span.high);
    sum->count = 0;
    /* What cancels comes first, so that few parts are left. */
    add(sum, square.high);
    add(sum, x.high);
    add(sum, y.high);
    add(sum, -2.0f * span.high * w);
    add_product(sum, -2.0f * span.high, span.low);
    add(sum, square.low);
    add(sum, x.low);
    add(sum, y.low);
    add(sum, -w * w);
    add(sum, -2.0f * span.low * w);
    add_product(sum, -span.low, span.low);
    /* A square that is zero by underflow still decides where nothing else is left. */
    if ((x.high == 0.0f && dx != 0.0f) || (y.high == 0.0f && dy != 0.0f)) {
        add(sum, 0x1p-149f);
    }
}

/* The same in two words, or without rounding where less than this part of what it is made of is left: pairs are right to
 * some 2^-46 of that. */
static LinkagePair excess(float dx, float dy, float a, float b, float w, float part)
{
    const LinkagePair square = linkage_pair_plus(linkage_pair_product(dx, dx), linkage_pair_product(dy, dy));
    const LinkagePair length = linkage_pair_plus(linkage_pair_sum(a, b), linkage_pair(w, 0.0f));
    const LinkagePair span = linkage_pair_times(length, length);
    const LinkagePair found = linkage_pair_plus(square, linkage_pair_minus(span));
    Sum sum;
    if (fabsf(found.high) > part * (square.high + span.high)) {
        return found;
    }
    excess_with(dx, dy, a, b, w, &sum);
    return pair_of(&sum);
}

/* A number of its sign. */
static float sign_of_excess(float dx, float dy, float a, float b, float w) { return excess(dx, dy, a, b, w, 0x1p-40f).high; }

/* Its value, to some 2^-34 of itself. */
static LinkagePair value_of_excess(float dx, float dy, float a, float b) { return excess(dx, dy, a, b, 0.0f, 0x1p-12f); }

/* True if a vector's length is 2^61 or more as double precision has it: it rounds what is less by 2^-54 of the square
 * to the same. */
static int is_long(float dx, float dy) { return !(0.0f > sign_of_excess(dx, dy, 0x1p61f, -0x1p6f, 0.0f)); }

/* Some last places of the largest of scaled numbers, of which one is the length of a vector. */
static float slack_of(int shift, float dx, float dy)
{
    const int places = LARGEST + is_long(dx, dy) - 23, least = shift - 149;
    return ULPS * power_of_twof(places > least ? places : least);
}

