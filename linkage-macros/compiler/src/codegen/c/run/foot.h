
/* Why there is no answer, while the slow path looks for it. */
typedef struct LinkageWhy {
    LinkageStatus status;
    int is_single;
    double by;
    const char *group;
    const char *name;
    const char *otherwise; /* the unknown to blame where nothing else is wrong */
    /* True if formulas go on behind what has no pose, this in its place, and NaN behind any other refusal. */
    int goes_on;
    double stand_in;
    int is_open; /* true if an equation was found open, behind which nothing becomes NaN */
} LinkageWhy;

/* A number and what an error calls it. */
typedef struct LinkageNamed {
    double value;
    const char *name;
} LinkageNamed;

LinkageWhy linkage_why(int is_single);
LinkageWhy linkage_why_behind(int is_single, double stand_in);
LinkageStatus linkage_refused(const LinkageWhy *why, LinkageError *error);
LinkageStatus linkage_because(LinkageError *error, LinkageStatus status, const char *name);
LinkageStatus linkage_not_on_circle(LinkageError *error, double cosine, double sine, const char *name);

/* What is given has to be finite, and what comes out. */
void linkage_given_finite(LinkageWhy *why, const LinkageNamed *given, int count);
void linkage_results_finite(LinkageWhy *why, const LinkageNamed *results, int count, const LinkageNamed *given, int given_count);

/* Margins where a group has no pose: true if some of them are known, and the others are NaN because they stand
 * behind it. These are numbers where `others` has another number in the place of what the group lacks. */
int linkage_lacks_a_pose(const LinkageWhy *why);
int linkage_is_told(const double *told, const double *others, int count);

/* The conditions of the formulas: each returns the value under it, or what stands for it at a limit. */
double linkage_nonzero(LinkageWhy *why, double value, const char *group);
double linkage_positive(LinkageWhy *why, double value, const char *group, const char *name);
double linkage_not_negative(LinkageWhy *why, double value, const char *group, const char *name);
double linkage_square(LinkageWhy *why, double value, const char *group);
double linkage_moving(LinkageWhy *why, double value, double spread, const char *name);
double linkage_closed(LinkageWhy *why, double difference, double size, const char *unknown);
double linkage_reach_circles(LinkageWhy *why, double value, double dx, double dy, double l1, double l2, double unit, double spread, const char *group);
double linkage_share_of_centres(LinkageWhy *why, double value, double height, double dx, double dy, double l1, double l2, double spread, const char *group);
double linkage_reach_distances(LinkageWhy *why, double value, double l, double r1, double r2, double spread, const char *group);
double linkage_square_of_centres(LinkageWhy *why, double value, double dx, double dy, double l1, double l2, const char *group);
double linkage_reach_line(LinkageWhy *why, double value, double t, double l, const char *group);
double linkage_reach_offset(LinkageWhy *why, double value, double bx, double by, double e, const char *group);

/* sqrt(x*x + y*y) without overflow on the way. */
double linkage_hypot(double x, double y);
float linkage_hypotf(float x, float y);
/* Roots. */

#ifdef __cplusplus
}
#endif

#endif /* LINKAGE_RUN_H */
