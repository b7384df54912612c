/* The build that decides in single precision alone. */
#include "single_linkage_run.h"
#define RUN(name) single_linkage_##name
#define ANSWER in_single
#include "one.c"
