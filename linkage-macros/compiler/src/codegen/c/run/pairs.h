
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
