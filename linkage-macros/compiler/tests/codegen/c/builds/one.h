/* Calls of the run-time in single precision, and their answers, which both builds give. */
#ifndef ONE_H
#define ONE_H

#include <stdint.h>

#define MOST 8
#define PLACES (MOST * (3 + 2 * MOST))

typedef enum Kind {
    CIRCLES, SHARE, DISTANCES, SQUARE_OF_CENTRES, LINE, OFFSET, MOVING, SQUARE, BLAMED, CLOSED, ANGLE, LENGTH, NEAR, ROOT, FRICTION, KINDS
} Kind;

/* The operands of a condition; of friction its rows, behind them where steps begin. */
typedef struct Call {
    Kind kind;
    int count;
    unsigned guides;
    float x[PLACES + MOST];
} Call;

/* A status, what is missing, who is to blame, and results. */
typedef struct Answer {
    int32_t status;
    double by;
    char who[3][24];
    int count;
    float y[MOST];
} Answer;

void in_wide(const Call *call, Answer *to);
void in_single(const Call *call, Answer *to);

#endif
