/* Poses of the robot there and back through the kinematics of LinuxCNC, and ratios beside differences. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include <kins_module.h>

extern const kins_ops five_bar_ops;

static double unit(void) { return (double)rand() / RAND_MAX * 2.0 - 1.0; }

int main(void)
{
    double back = 0.0, ratio = 0.0, joint[2], before[2] = { 0.0, 0.0 }, jump = 0.0;
    int found = 0, refused = 0, turn;
    srand(5);
    for (turn = 0; turn < 20000; ++turn) {
        EmcPose pose = { { 120.0 * unit(), 150.0 + 120.0 * unit(), 0.0 }, 0, 0, 0, 0, 0, 0 }, again = pose;
        double ratios[EMCMOT_MAX_JOINTS][EMCMOT_MAX_AXIS], moved[2][2];
        int side;
        if (five_bar_ops.inverse(NULL, NULL, &pose, joint, NULL, NULL) != 0
            || five_bar_ops.forward(NULL, NULL, joint, &again, NULL, NULL) != 0) {
            ++refused;
            continue;
        }
        ++found;
        back = fmax(back, hypot(again.tran.x - pose.tran.x, again.tran.y - pose.tran.y));
        if (five_bar_ops.jacobian(NULL, joint, &pose, ratios, NULL) != 0) {
            return 1;
        }
        for (side = 0; side < 2; ++side) {
            EmcPose near = pose;
            near.tran.x += side == 0 ? 1e-4 : -1e-4;
            if (five_bar_ops.inverse(NULL, NULL, &near, moved[side], NULL, NULL) != 0) {
                break;
            }
        }
        if (side == 2 && fabs(ratios[0][0]) < 10.0) {
            ratio = fmax(ratio, fabs((moved[0][0] - moved[1][0]) / 2e-4 - ratios[0][0]) / (1.0 + fabs(ratios[0][0])));
        }
    }
    /* Along a line through the work space no angle jumps. */
    for (turn = 0; turn < 1000; ++turn) {
        EmcPose pose = { { -60.0 + 0.12 * turn, 150.0, 0.0 }, 0, 0, 0, 0, 0, 0 };
        if (five_bar_ops.inverse(NULL, NULL, &pose, joint, NULL, NULL) != 0) {
            return 2;
        }
        if (turn > 0) {
            jump = fmax(jump, fmax(fabs(joint[0] - before[0]), fabs(joint[1] - before[1])));
        }
        before[0] = joint[0], before[1] = joint[1];
    }
    printf("%d %d %.3e %.3e %.3e\n", found, refused, back, ratio, jump);
    return 0;
}
