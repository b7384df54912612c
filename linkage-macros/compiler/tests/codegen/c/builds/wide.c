/* The build that decides in double precision. */
#include "linkage_run.h"
#define RUN(name) linkage_##name
#define ANSWER in_wide
#include "one.c"
