
/* True if the first is less than rounding leaves of the second: what straight-line steps to amounts of friction end
 * with. */
static inline int linkage_is_settled@(REAL first, REAL second) { return 4.0@ * LEAST_EPSILON * second > first; }

/* Amounts of friction that depend on each other, in linkage_friction.c: so many, by steps from these values. A row is
 * a share, a reaction without friction, and its changes by a unit of each amount. The first answers whether steps
 * without a branch have found them; the second says why there are none. */
int linkage_amounts@(int count, unsigned guides, const REAL *rows, const REAL *start, REAL *amounts);
void linkage_friction@(LinkageWhy *why, const char *const *joints, int count, unsigned guides, const REAL *rows, const REAL *start, REAL *amounts);
