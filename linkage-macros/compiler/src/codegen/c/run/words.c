
/* Words and angles for callers. */

const char *linkage_status_text(LinkageStatus status)
{
    switch (status) {
    case LINKAGE_OK: return "there is an answer";
    case LINKAGE_OUT_OF_REACH: return "out of reach: the group cannot be assembled";
    case LINKAGE_SINGULAR: return "singular: what was asked for is undefined in this pose of the group";
    case LINKAGE_INVALID_LENGTH: return "invalid length: it is zero or negative";
    case LINKAGE_NOT_FINITE: return "not finite: an input, a parameter or a result";
    case LINKAGE_NULL_POINTER: return "null pointer";
    case LINKAGE_INVALID_MODE: return "invalid mode: the parameter is none of its modes";
    case LINKAGE_OFF_CIRCLE: return "off the circle: cosine and sine of no angle";
    case LINKAGE_NO_SOLUTION: return "no solution of the mode between the ends of the unknown";
    case LINKAGE_SEVERAL_DEAD_POINTS: return "several dead points between the ends of the unknown: narrow the interval";
    case LINKAGE_JAMS: return "jams: friction may hold itself at the joint";
    case LINKAGE_NOT_CERTIFIED: return "not certified: the group was not followed so far from the drawing";
    case LINKAGE_OTHER_ASSEMBLY: return "other assembly: the group has another side than for the other set of inputs";
    default: return "no status of linkage";
    }
}

#ifndef LINKAGE_NO_DOUBLE

/* The turns between two angles: to the nearest integer, ties to even. From 2^51 on the fraction's bits are beyond what
 * an angle can tell. */
static double turns_between(double angle, double previous)
{
    const double turns = (previous - angle) / 6.283185307179586;
    return fabs(turns) < 2251799813685248.0 ? (turns + 6755399441055744.0) - 6755399441055744.0 : turns;
}

double linkage_angle_near(double cosine, double sine, double previous)
{
    const double angle = linkage_atan2(sine, cosine);
    return angle + turns_between(angle, previous) * 6.283185307179586;
}

#ifndef LINKAGE_NO_SINGLE
float linkage_angle_near_f32(float cosine, float sine, float previous)
{
    const float angle = linkage_atan2f(sine, cosine);
    return angle + (float)(turns_between((double)angle, (double)previous) * 6.283185307179586);
}
#endif /* LINKAGE_NO_SINGLE */

#else

/* A difference less the turns in it, which a sum with a large number rounds. */
static LinkagePair turned_back(LinkagePair difference, float large)
{
    const float turns = (difference.high * 0.159154937f + large) - large;
    const LinkagePair more = linkage_pair_plus(difference, linkage_pair_product(-turns, 6.28318548f));
    return linkage_pair_plus(more, linkage_pair_product(turns, 1.74845553e-07f));
}

float linkage_angle_near_f32(float cosine, float sine, float previous)
{
    const float angle = linkage_atan2f(sine, cosine);
    const LinkagePair turn = { 6.28318548f, -1.74845553e-07f }, half = { 3.14159274f, -8.74227766e-08f };
    const LinkagePair difference = linkage_pair_sum(previous, -angle);
    LinkagePair rest;
    /* Beyond this a turn is less than half a last place. */
    if (!(fabsf(previous) < 536870912.0f)) {
        return angle + previous;
    }
    /* By 16 turns, and then by one. */
    rest = turned_back(turned_back(difference, 201326592.0f), 12582912.0f);
    if (linkage_pair_above(rest, half)) {
        rest = linkage_pair_plus(rest, linkage_pair_minus(turn));
    } else if (linkage_pair_above(linkage_pair_minus(half), rest)) {
        rest = linkage_pair_plus(rest, turn);
    }
    return angle + linkage_pair_plus(difference, linkage_pair_minus(rest)).high;
}

#endif /* LINKAGE_NO_DOUBLE */
