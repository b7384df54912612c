
/* Why there is no answer, while the slow path looks for it. */
typedef struct LinkageWhy {
    LinkageStatus status;
    int is_single;
    LinkageWide by;
    const char *group;
    const char *name;
    const char *otherwise; /* the unknown to blame where nothing else is wrong */
    /* True if formulas go on behind what has no pose, this in its place, and NaN behind any other refusal. */
    int goes_on;
    LinkageWide stand_in;
    int is_open; /* true if an equation was found open, behind which nothing becomes NaN */
} LinkageWhy;

/* A number and what an error calls it. */
typedef struct LinkageNamed {
    LinkageWide value;
    const char *name;
} LinkageNamed;

LinkageWhy linkage_why(int is_single);
LinkageWhy linkage_why_behind(int is_single, LinkageWide stand_in);
LinkageStatus linkage_refused(const LinkageWhy *why, LinkageError *error);
LinkageStatus linkage_because(LinkageError *error, LinkageStatus status, const char *name);
LinkageStatus linkage_not_on_circle(LinkageError *error, LinkageWide cosine, LinkageWide sine, const char *name);

/* What is given has to be finite, and what comes out. */
void linkage_given_finite(LinkageWhy *why, const LinkageNamed *given, int count);
void linkage_results_finite(LinkageWhy *why, const LinkageNamed *results, int count, const LinkageNamed *given, int given_count);

/* Margins where a group has no pose: true if some of them are known, and the others are NaN because they stand
 * behind it. These are numbers where `others` has another number in the place of what the group lacks. */
int linkage_lacks_a_pose(const LinkageWhy *why);
int linkage_is_told(const LinkageWide *told, const LinkageWide *others, int count);

/* The conditions of the formulas: each returns the value under it, or what stands for it at a limit. */
LinkageWide linkage_nonzero(LinkageWhy *why, LinkageWide value, const char *group);
LinkageWide linkage_positive(LinkageWhy *why, LinkageWide value, const char *group, const char *name);
LinkageWide linkage_not_negative(LinkageWhy *why, LinkageWide value, const char *group, const char *name);
LinkageWide linkage_square(LinkageWhy *why, LinkageWide value, const char *group);
LinkageWide linkage_moving(LinkageWhy *why, LinkageWide value, LinkageWide spread, const char *name);
LinkageWide linkage_certified(LinkageWhy *why, LinkageWide value, const char *group);
LinkageWide linkage_closed(LinkageWhy *why, LinkageWide difference, LinkageWide size, const char *unknown);
LinkageWide linkage_reach_circles(LinkageWhy *why, LinkageWide value, LinkageWide dx, LinkageWide dy, LinkageWide l1, LinkageWide l2, LinkageWide unit, LinkageWide spread, const char *group);
LinkageWide linkage_share_of_centres(LinkageWhy *why, LinkageWide value, LinkageWide height, LinkageWide dx, LinkageWide dy, LinkageWide l1, LinkageWide l2, LinkageWide spread, const char *group);
LinkageWide linkage_reach_distances(LinkageWhy *why, LinkageWide value, LinkageWide l, LinkageWide r1, LinkageWide r2, LinkageWide spread, const char *group);
LinkageWide linkage_square_of_centres(LinkageWhy *why, LinkageWide value, LinkageWide dx, LinkageWide dy, LinkageWide l1, LinkageWide l2, const char *group);
LinkageWide linkage_reach_line(LinkageWhy *why, LinkageWide value, LinkageWide t, LinkageWide l, const char *group);
LinkageWide linkage_reach_offset(LinkageWhy *why, LinkageWide value, LinkageWide bx, LinkageWide by, LinkageWide e, const char *group);

/* sqrt(x*x + y*y) without overflow on the way. */
#ifndef LINKAGE_NO_DOUBLE
double linkage_hypot(double x, double y);
#endif
#ifndef LINKAGE_NO_SINGLE
float linkage_hypotf(float x, float y);
#endif
/* Roots. */

#ifdef __cplusplus
}
#endif

#endif /* LINKAGE_RUN_H */
