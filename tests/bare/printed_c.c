/* Compares two functions of one name, of the library and as printed: see printed_c.rs, which puts headers and
 * functions in their places. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* HEADERS */

/* A function: its name, a letter for each number that it is called with, of which `m` is a mode, and both calls. */
typedef struct Function {
    const char *name;
    const char *numbers;
    int is_single;
    void (*draw)(double *g);
    void (*call)(const double *g);
} Function;

#define MOST_NUMBERS 32
#define STATUSES 11

/* No solution; behind it several dead points, and a joint that jams. */
#define FIRST_OF_SEARCHES 8

static uint64_t state;

/* Next to a limit nothing is out of the ordinary but the limit. */
static int is_ordinary;

static uint64_t random_bits(void)
{
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return state;
}

static double unit(void) { return (double)(random_bits() >> 11) / 9007199254740992.0; }

static double odd(void)
{
    const double numbers[] = { INFINITY, -INFINITY, NAN, 1e300, -1e160, 0.0, -0.0, 5e-324, 1e-310, 1048576.0, 1e30, 1e-30 };
    return is_ordinary ? unit() : numbers[random_bits() % 12];
}

static double angle(void)
{
    switch (random_bits() % 24) {
    case 0: return odd();
    case 1: return (unit() - 0.5) * (is_ordinary ? 26.0 : random_bits() % 2 == 0 ? 4e6 : 1e30);
    case 2: return 1.5707963267948966 * (double)(random_bits() % 9) - 6.283185307179586;
    default: return (unit() - 0.5) * 13.0;
    }
}

/* With friction what is at rest is another case. */
static double rate(void)
{
#ifdef RUBS
    if (random_bits() % 4 == 0) {
        return 0.0;
    }
#endif
    switch (random_bits() % 24) {
    case 0: return odd();
    case 1: return (unit() - 0.5) * (is_ordinary ? 1e3 : 1e160);
    default: return (unit() - 0.5) * 200.0;
    }
}

static double effort(void)
{
    switch (random_bits() % 24) {
    case 0: return odd();
    case 1: return (unit() - 0.5) * (is_ordinary ? 1e6 : 1e160);
    default: return (unit() - 0.5) * 2000.0;
    }
}

static double length(void)
{
    switch (random_bits() % 24) {
    case 0: return odd();
    case 1: return (unit() - 0.5) * 8.0;
    default: return 1.7 + unit();
    }
}

/* The ram's slide of the searched press, which reaches from 0.17 m to 0.33 m, its ends among them. */
static double stroke(void)
{
    switch (random_bits() % 16) {
    case 0: return odd();
    case 1: return (random_bits() & 1u) != 0 ? 0.1702071748570875 : 0.3295983265517668;
    default: return 0.15 + 0.2 * unit();
    }
}

/* The distance that the leg behind it brings about. */
static double span(void) { return random_bits() % 16 == 0 ? odd() : 1.1 + 0.3 * unit(); }

/* A parameter near what was declared. With friction it may be far above that, so that joints jam. */
static double changed(double declared)
{
    switch (random_bits() % 16) {
    case 0: return odd();
    case 1: return -declared;
    case 2: case 3: case 4:
#ifdef RUBS
        return declared * exp2(6.0 * unit() - 1.0);
#else
        return declared * (0.5 + unit());
#endif
    default: return declared;
    }
}

static int32_t mode(void)
{
    const uint64_t which = random_bits() % 32;
    return which == 0 && !is_ordinary ? (int32_t)(random_bits() % 5) - 2 : (which & 1u) != 0 ? 1 : -1;
}

static double amplitude(void) { return is_ordinary ? 1.0 : random_bits() % 8 == 0 ? odd() : 0.88 + 0.24 * unit(); }

static long met[STATUSES], different, apart;
static int last_status;

/* Groups and joints that refused. */
static char blamed[4096];

static void begin(void)
{
    state = 88172645463325252u;
    memset(met, 0, sizeof met);
    different = apart = 0;
    blamed[0] = '\0';
}

static int same_text(const char *a, size_t a_length, const char *b, size_t b_length)
{
    return a_length == b_length && (a == NULL) == (b == NULL) && (a == NULL || memcmp(a, b, a_length) == 0);
}

static int same_error(const LinkageError *a, const LinkageError *b)
{
#ifdef WITHOUT_DOUBLE
    /* What is missing is told in single precision. */
    const int is_same = fabs(a->by - b->by) <= 1e-3 * fabs(a->by) + 0x1p-149 || (a->by >= FLT_MAX && b->by >= FLT_MAX);
#else
    const int is_same = memcmp(&a->by, &b->by, sizeof a->by) == 0;
#endif
    return a->status == b->status && is_same
        && same_text(a->group, a->group_length, b->group, b->group_length)
        && same_text(a->name, a->name_length, b->name, b->name_length);
}

/* Where both are fused, compilers move a sign into a fused operation, which turns that of a zero. */
static int same_numbers(const void *a, const void *b, size_t size, int is_single)
{
    if (memcmp(a, b, size) == 0) {
        return 1;
    }
#ifdef ZEROS_HAVE_NO_SIGN
    {
        const size_t each = is_single ? sizeof(float) : sizeof(double);
        size_t at;
        for (at = 0; at + each <= size; at += each) {
            double x[2];
            float y[2];
            if (is_single) {
                memcpy(&y[0], (const char *)a + at, each);
                memcpy(&y[1], (const char *)b + at, each);
                x[0] = y[0];
                x[1] = y[1];
            } else {
                memcpy(&x[0], (const char *)a + at, each);
                memcpy(&x[1], (const char *)b + at, each);
            }
            if (x[0] != x[1]) {
                return 0;
            }
        }
        return 1;
    }
#else
    (void)is_single;
    return 0;
#endif
}

/* Keeps who has no pose or an undefined one, no solution or jams, once each. */
static void blame(const LinkageError *why)
{
    const char *const who = why->group != NULL ? why->group : why->name;
    const size_t length = why->group != NULL ? why->group_length : why->name_length;
    const size_t taken = strlen(blamed);
    char entry[256];
    if ((why->status > LINKAGE_SINGULAR && why->status < FIRST_OF_SEARCHES) || who == NULL || length > 200) {
        return;
    }
    memcpy(entry, " [", 2);
    memcpy(entry + 2, who, length);
    memcpy(entry + 2 + length, "]", 2);
    if (strstr(blamed, entry) == NULL && taken + length + 4 < sizeof blamed) {
        memcpy(blamed + taken, entry, length + 4);
    }
}

/* An error before the calls, which those that answer leave alone. */
static const LinkageError untold = { -1, 0.0, NULL, 0, NULL, 0 };

static void compare(int a, int b, const void *answer_a, const void *answer_b, size_t size, int is_single, const LinkageError *why_a, const LinkageError *why_b)
{
    const int is_left = why_a->status == (a == LINKAGE_OK ? untold.status : a);
    const int are_same = same_numbers(answer_a, answer_b, size, is_single);
#ifdef WITHOUT_DOUBLE
    const int is_same = a == b && is_left && same_error(why_a, why_b);
    apart += is_same && !are_same;
#else
    const int is_same = a == b && is_left && same_error(why_a, why_b) && are_same;
#endif
    met[a]++;
    last_status = a;
    blame(why_a);
    if (!is_same && different++ < 3) {
        printf("status %d and %d, by %.17g and %.17g, group %.*s and %.*s, name %.*s and %.*s\n", a, b, why_a->by, why_b->by,
            (int)why_a->group_length, why_a->group, (int)why_b->group_length, why_b->group,
            (int)why_a->name_length, why_a->name, (int)why_b->name_length, why_b->name);
    }
}

static int report(const char *kind, const char *name)
{
    long refused = 0;
    int status;
    for (status = 1; status < STATUSES; status++) {
        refused += met[status];
    }
    printf("%s %s %ld answered %ld refused%s", kind, name, met[0], refused, blamed);
    if (different != 0) {
        printf(", %ld different", different);
    }
    if (apart != 0) {
        printf(", %ld apart", apart);
    }
    printf("\n");
    return different == 0;
}

/* FUNCTIONS */

/* Numbers between two draws, modes as in the first. */
static void mix(const Function *f, const double *here, const double *there, double share, double *to)
{
    size_t at;
    for (at = 0; f->numbers[at] != '\0'; at++) {
        to[at] = f->numbers[at] == 'm' ? here[at] : here[at] + share * (there[at] - here[at]);
    }
}

/* A number some last places away. */
static double moved(const Function *f, double x)
{
    const double places = (double)(random_bits() % 17) - 8.0;
    return (f->is_single ? (double)(float)x : x) + places * ldexp(f->is_single ? FLT_EPSILON : DBL_EPSILON, ilogb(x));
}

/* Places beside a limit, which halving finds between a pose that is answered and one that is refused: one number of
 * it, or all, up to eight last places away. */
static void beside_a_limit(const Function *f)
{
    double here[MOST_NUMBERS], there[MOST_NUMBERS], at_limit[MOST_NUMBERS], given[MOST_NUMBERS];
    const size_t count = strlen(f->numbers);
    double low = 0.0, high = 1.0;
    size_t at;
    int tries, nth;
    for (tries = 0, last_status = 1; tries < 30 && last_status != 0; tries++) {
        f->draw(here);
        f->call(here);
    }
    for (tries = 0; tries < 30 && last_status == 0; tries++) {
        f->draw(there);
        mix(f, here, there, 1.0, at_limit);
        f->call(at_limit);
    }
    for (;;) {
        const double middle = low + (high - low) * 0.5;
        if (middle == low || middle == high || tries == 30) {
            break;
        }
        mix(f, here, there, middle, at_limit);
        f->call(at_limit);
        if (last_status == 0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    for (nth = 0; nth < 40; nth++) {
        const size_t only = random_bits() % count;
        for (at = 0; at < count; at++) {
            const int stays = f->numbers[at] == 'm' || (nth % 2 == 0 && at != only);
            given[at] = stays || at_limit[at] == 0.0 ? at_limit[at] : moved(f, at_limit[at]);
        }
        f->call(given);
    }
}

/* Calls every function so often with random numbers, and as often beside limits: of so many parts of the table, every
 * function of this one. */
int main(int count, char **arguments)
{
    const long calls = count > 1 ? atol(arguments[1]) : 1;
    const size_t part = count > 3 ? (size_t)atol(arguments[2]) : 0, parts = count > 3 ? (size_t)atol(arguments[3]) : 1;
    int is_equal = 1;
    size_t at;
    long i;
    for (at = part; at < sizeof ALL / sizeof ALL[0]; at += parts) {
        const Function *const f = &ALL[at];
        double given[MOST_NUMBERS];
        begin();
        for (i = 0; i < calls; i++) {
            f->draw(given);
            f->call(given);
        }
        is_equal &= report("random", f->name);
        begin();
        is_ordinary = 1;
        for (i = 0; i < calls; i += 100) {
            beside_a_limit(f);
        }
        is_ordinary = 0;
        is_equal &= report("limit", f->name);
    }
    return is_equal ? 0 : 1;
}
