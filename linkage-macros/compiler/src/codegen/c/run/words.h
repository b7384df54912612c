#ifndef LINKAGE_WORDS
#define LINKAGE_WORDS

/* A status in words, also of a number that is none. */
const char *linkage_status_text(LinkageStatus status);

/* The angle of a direction nearest `previous` among all that are turns apart, in rad: fed back, it follows a link as
 * long as it turns less than half a turn between two calls. */
double linkage_angle_near(double cosine, double sine, double previous);
float linkage_angle_near_f32(float cosine, float sine, float previous);

#endif /* LINKAGE_WORDS */
