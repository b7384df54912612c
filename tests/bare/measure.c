/* The part of the measuring program that is not generated: `measure.py` puts headers before it
 * and calls after it. */
#include <stdio.h>
#include <string.h>
#include <ucontext.h>

enum { STACK = 1 << 16, PAINT = 0x5c };

static unsigned char stack[STACK];
static ucontext_t here, there;
static double q[3];

static void nothing(void)
{
}

/* How deep a call goes, on a stack that was painted before. Stacks grow downwards here. */
static size_t depth(void (*call)(void))
{
    size_t untouched = 0;
    memset(stack, PAINT, sizeof stack);
    getcontext(&there);
    there.uc_stack.ss_sp = stack;
    there.uc_stack.ss_size = sizeof stack;
    there.uc_link = &here;
    makecontext(&there, call, 0);
    swapcontext(&here, &there);
    while (untouched < sizeof stack && stack[untouched] == PAINT)
        untouched++;
    return sizeof stack - untouched;
}

/* Counting: many calls in the pose that is solved in a straight line. Else: the deeper of a call
 * in that pose and one that takes the careful path. */
static void measure(int counting, const char *name, void (*call)(void), const double straight[3],
                    const double careful[3])
{
    size_t most = 0;
    memcpy(q, straight, sizeof q);
    for (int i = 0; counting && i < CALLS; i++)
        call();
    for (int i = 0; !counting && i < 2; i++) {
        const size_t deep = depth(call) - depth(nothing);
        most = deep > most ? deep : most;
        memcpy(q, careful, sizeof q);
    }
    if (!counting)
        printf("%s %zu\n", name, most);
}

