
/* Where a root is looked for, with the trend that f has there, 1 or -1, and from which seed. */
typedef struct LinkageBetween@ {
    REAL from;
    REAL to;
    REAL trend;
    REAL seed;
    int has_seed;
    int is_turn; /* true for an angle whose ends, a turn apart at most, are known here alone */
    int is_steady; /* true if the slope is proved to have one sign between the ends */
} LinkageBetween@;

/* The sides of an equation at a trial, and the slope of their difference. */
typedef void (*LinkageSides@)(const REAL *given, REAL trial, REAL *sides);

/* The root, in linkage_root.c, and the size that its rounding is measured by. The answer says whether there is
 * one. */
int linkage_root@(LinkageWhy *why, const char *unknown, const LinkageBetween@ *between, LinkageSides@ sides, const REAL *given, REAL *found);
