/* Compares two functions of one name, of the library and as printed: see printed_c.rs. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state = 88172645463325252u;

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
    return numbers[random_bits() % 12];
}

static double angle(void)
{
    switch (random_bits() % 24) {
    case 0: return odd();
    case 1: return (unit() - 0.5) * (random_bits() % 2 == 0 ? 4e6 : 1e30);
    case 2: return 1.5707963267948966 * (double)(random_bits() % 9) - 6.283185307179586;
    default: return (unit() - 0.5) * 13.0;
    }
}

static double rate(void)
{
    switch (random_bits() % 24) {
    case 0: return odd();
    case 1: return (unit() - 0.5) * 1e160;
    default: return (unit() - 0.5) * 200.0;
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

/* A parameter near what was declared. */
static double changed(double declared)
{
    switch (random_bits() % 16) {
    case 0: return odd();
    case 1: return -declared;
    case 2: case 3: case 4: return declared * (0.5 + unit());
    default: return declared;
    }
}

static int32_t mode(void)
{
    const uint64_t which = random_bits() % 32;
    return which == 0 ? (int32_t)(random_bits() % 5) - 2 : (which & 1u) != 0 ? 1 : -1;
}

static double amplitude(void) { return random_bits() % 8 == 0 ? odd() : 0.88 + 0.24 * unit(); }

#include "flying_shear.h"

static long answered, refused, different;

static void begin(void) { answered = refused = different = 0; }

static int same_text(const char *a, size_t a_length, const char *b, size_t b_length)
{
    return a_length == b_length && (a == NULL) == (b == NULL) && (a == NULL || memcmp(a, b, a_length) == 0);
}

static int same_error(const LinkageError *a, const LinkageError *b)
{
    return a->status == b->status && memcmp(&a->by, &b->by, sizeof a->by) == 0
        && same_text(a->group, a->group_length, b->group, b->group_length)
        && same_text(a->name, a->name_length, b->name, b->name_length);
}

static void compare(int a, int b, const void *answer_a, const void *answer_b, size_t size, const LinkageError *why_a, const LinkageError *why_b)
{
    const int is_same = a == b && same_error(why_a, why_b) && memcmp(answer_a, answer_b, size) == 0;
    if (a == 0) {
        answered++;
    } else {
        refused++;
    }
    if (!is_same && different++ < 3) {
        printf("status %d and %d, by %.17g and %.17g, group %.*s and %.*s, name %.*s and %.*s\n", a, b, why_a->by, why_b->by,
            (int)why_a->group_length, why_a->group, (int)why_b->group_length, why_b->group,
            (int)why_a->name_length, why_a->name, (int)why_b->name_length, why_b->name);
    }
}

static int report(const char *name)
{
    printf("%s %ld answered %ld refused", name, answered, refused);
    if (different != 0) {
        printf(", %ld different", different);
    }
    printf("\n");
    return different == 0;
}

static int compare_all(long calls);

