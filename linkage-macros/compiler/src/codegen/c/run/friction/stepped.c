
int linkage_amounts@(int count, unsigned guides, const REAL *rows, const REAL *start, REAL *amounts)
{
    REAL bounds[MOST][MOST] = { { 0.0@ } }, slope[MOST][MOST] = { { 0.0@ } }, values[MOST];
    System@ s;
    int step, are_near = 1, met = 0;
    s.count = count;
    s.guides = guides;
    s.rows = rows;
    bounds_of@(&s, bounds);
    (void)memcpy(amounts, start, (size_t)count * sizeof *amounts);
    for (step = 0; step <= STEPS; step++) { /* at most STEPS + 1 times */
        linear@(&s, amounts, &are_near, values, slope);
        if (step == STEPS) {
            met = settled@(count, amounts, values, start, bounds) & (jammed@(count, bounds) == count);
        }
        newton@(count, amounts, values, slope, amounts);
    }
    return met & are_near;
}

void linkage_friction@(LinkageWhy *why, const char *const *joints, int count, unsigned guides, const REAL *rows, const REAL *start, REAL *amounts)
{
    LinkageWide plain[MOST * WIDTH(MOST)], found[MOST];
    const int places = WIDTH(count);
    int at, are_finite = 1;
    (void)memcpy(amounts, start, (size_t)count * sizeof *amounts);
    if (why->status != LINKAGE_OK) {
        return;
    }
    for (at = 0; at < count * places; at++) { /* at most MOST * WIDTH(MOST) times */
        plain[at] = (LinkageWide)rows[at];
        if (!linkage_is_finite@(rows[at])) {
            refuse_amount(why, LINKAGE_NOT_FINITE, joints[at / places]);
            return;
        }
    }
    if (linkage_amounts@(count, guides, rows, start, amounts)) {
        for (at = 0; at < count; at++) { /* at most MOST times */
            are_finite &= linkage_is_finite@(amounts[at]);
        }
        if (are_finite) {
            return;
        }
    }
    at = solved(count, guides, plain, found);
    if (at < count) {
        (void)memcpy(amounts, start, (size_t)count * sizeof *amounts);
        refuse_amount(why, LINKAGE_JAMS, joints[at]);
        return;
    }
    for (at = 0; at < count; at++) { /* at most MOST times */
        amounts[at] = (REAL)found[at];
    }
}
