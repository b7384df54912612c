/* Calls of the equations of friction, for the test beside: reads how many amounts, which of them are guides,
 * the width, whether something has failed before, rows and first values; writes what straight-line steps say and
 * find, and what the slow path does. */
#include "linkage_run.h"

#include <stdio.h>

#define MOST 8
#define PLACES (MOST * (3 + 2 * MOST))

typedef struct Call {
    int32_t count;
    int32_t guides;
    int32_t is_single;
    int32_t has_failed;
    double rows[PLACES];
    double start[MOST];
} Call;

typedef struct Answer {
    double met;
    double fast[MOST];
    double status;
    double joint;
    double found[MOST];
} Answer;

static const char *const joints[MOST] = { "0", "1", "2", "3", "4", "5", "6", "7" };

#define OF_WIDTH(width, number)                                                                                     \
    static void number##s(const Call *call, Answer *to)                                                             \
    {                                                                                                               \
        number rows[PLACES], start[MOST], amounts[MOST];                                                            \
        const unsigned guides = (unsigned)call->guides;                                                             \
        LinkageWhy why = linkage_why(call->is_single);                                                              \
        int i;                                                                                                      \
        why.status = call->has_failed ? LINKAGE_SINGULAR : LINKAGE_OK;                                              \
        for (i = 0; i < PLACES; i++) {                                                                              \
            rows[i] = (number)call->rows[i];                                                                        \
        }                                                                                                           \
        for (i = 0; i < MOST; i++) {                                                                                \
            start[i] = (number)call->start[i];                                                                      \
        }                                                                                                           \
        to->met = linkage_amounts##width(call->count, guides, rows, start, amounts);                                \
        for (i = 0; i < call->count; i++) {                                                                         \
            to->fast[i] = (double)amounts[i];                                                                       \
        }                                                                                                           \
        linkage_friction##width(&why, joints, call->count, guides, rows, start, amounts);                           \
        to->status = why.status;                                                                                    \
        to->joint = why.name == NULL ? -1.0 : (double)(why.name[0] - '0');                                          \
        for (i = 0; i < call->count; i++) {                                                                         \
            to->found[i] = (double)amounts[i];                                                                      \
        }                                                                                                           \
    }
OF_WIDTH(, double)
OF_WIDTH(f, float)

int main(void)
{
    Call call;
    while (fread(&call, sizeof call, 1, stdin) == 1) {
        Answer answer = { 0.0, { 0.0 }, 0.0, 0.0, { 0.0 } };
        if (call.is_single) {
            floats(&call, &answer);
        } else {
            doubles(&call, &answer);
        }
        if (fwrite(&answer, sizeof answer, 1, stdout) != 1) {
            return 1;
        }
    }
    return 0;
}
