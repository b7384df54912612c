/* linkage_friction.c: amounts of friction that depend on each other. linkage_run.h says whose text this is.
 *
 * Amount x_j is the share c_j of the size of a contact's reaction, which is affine in all amounts:
 * x_j = c_j |G_j + sum of A_jk x_k|. With L_jk = c_j |A_jk| there is exactly one solution if the spectral radius of
 * L is below one, which elimination of I - L shows by positive pivots; where it is not, friction may hold itself.
 * Newton's steps begin where amounts are those of no friction. Solutions and refusals are those of the solver in
 * Rust to the last bit. */
#include "linkage_run.h"

/* The most amounts that depend on each other. */
#define MOST 8

/* Newton's steps before steps are guarded, and steps of the guarded search. */
#define NEWTON 8
#define GUARDED 64

/* Steps of Newton's method before the fast path asks whether they have ended. */
#define STEPS 3

/* Places in a row: c, both components of G, and both of A for each amount. */
#define FREE 1
#define CHANGES 3
#define WIDTH(count) (CHANGES + 2 * (count))

static void refuse_amount(LinkageWhy *why, LinkageStatus status, const char *joint)
{
    why->status = status;
    why->name = joint;
    why->group = NULL;
    why->by = 0;
}
