/* A program of nothing but the solvers: no C library, no start files. What is missing here is
 * missing on a bare machine, and the linker says so.
 *
 * The compiler may copy and fill memory by these three names; every C library has them, bare or
 * not.
 */
#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t count)
{
    char *t = to;
    const char *f = from;
    while (count--)
        *t++ = *f++;
    return to;
}

void *memmove(void *to, const void *from, size_t count)
{
    char *t = to;
    const char *f = from;
    if (t < f)
        for (size_t i = 0; i < count; i++)
            t[i] = f[i];
    else
        while (count--)
            t[count] = f[count];
    return to;
}

void *memset(void *to, int value, size_t count)
{
    char *t = to;
    while (count--)
        *t++ = (char)value;
    return to;
}

/* Every function of the library, and their number. */
extern void (*const volatile solvers[])(void);
extern const size_t solver_count;

void _start(void)
{
    for (size_t i = 0; i < solver_count; i++)
        solvers[i]();
}
