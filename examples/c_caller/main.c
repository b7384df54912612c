/* Prints the pose of a flying shear at the crank angle given in degrees, its blade's velocity at
 * 12 rad/s, and what a mistake looks like. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "flying_shear.h"

#define DEGREE (3.14159265358979323846 / 180.0)

static int complain(const LinkageError *error)
{
    printf("status %d", (int)error->status);
    if (error->group)
        printf(", group %.*s", (int)error->group_length, error->group);
    if (error->name)
        printf(", `%.*s`", (int)error->name_length, error->name);
    if (error->status == LINKAGE_OUT_OF_REACH)
        printf(": %g m are missing", error->by);
    printf("\n");
    return EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    const double theta = (argc > 1 ? strtod(argv[1], NULL) : 292.5) * DEGREE;
    FlyingShear shear = flying_shear_default();
    FlyingShearMotion motion;
    FlyingShearPositionF32 narrow;
    LinkageError error;

    if (flying_shear_motion(&shear, theta, 12.0, 0.0, &motion, &error) != LINKAGE_OK)
        return complain(&error);
    printf("blade    at (%.6f, %.6f) m, moving at (%.6f, %.6f) m/s\n", motion.position.blade.x,
           motion.position.blade.y, motion.velocity.blade.x, motion.velocity.blade.y);
    printf("rocker   at %.6f deg\n",
           atan2(motion.position.DC.sin, motion.position.DC.cos) / DEGREE);

    FlyingShearF32 shear_f32 = flying_shear_default_f32();
    if (flying_shear_position_f32(&shear_f32, (float)theta, &narrow, &error) != LINKAGE_OK)
        return complain(&error);
    printf("in float at (%.6f, %.6f) m\n", narrow.blade.x, narrow.blade.y);

    /* Every mistake comes back as a status; the answer is left as it was. */
    shear.coupler = 0.2;
    if (flying_shear_motion(&shear, theta, 12.0, 0.0, &motion, &error) != LINKAGE_OK)
        complain(&error);
    if (flying_shear_motion(NULL, theta, 12.0, 0.0, &motion, &error) != LINKAGE_OK)
        complain(&error);
    return EXIT_SUCCESS;
}
