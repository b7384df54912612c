/* Kinematics of a five-bar robot for LinuxCNC: joints in degrees, axes in millimetres.
 *
 * A pose out of reach, or on the other assembly of the arms, is -1, so that no move begins there. */
#include <kins_module.h>

#include "five_bar.h"

#define DEGREES 57.295779513082320877
#define MILLIMETRES 1e3

static int forward(const kins_params *params, kins_scratch *scratch, const double *joint, EmcPose *pose,
    const KINEMATICS_FORWARD_FLAGS *forward_flags, KINEMATICS_INVERSE_FLAGS *inverse_flags)
{
    const FiveBarMotorsInput motors = { joint[0] / DEGREES, joint[1] / DEGREES };
    FiveBarMotorsToHand hand;
    (void)params, (void)scratch, (void)forward_flags, (void)inverse_flags;
    if (five_bar_motors_to_hand(&motors, &hand, NULL) != LINKAGE_OK) {
        return -1;
    }
    pose->tran.x = hand.coordinates.x * MILLIMETRES;
    pose->tran.y = hand.coordinates.y * MILLIMETRES;
    return 0;
}

static LinkageStatus motors_at(const EmcPose *pose, FiveBarHandToMotors *motors)
{
    const FiveBarHandInput hand = { pose->tran.x / MILLIMETRES, pose->tran.y / MILLIMETRES };
    return five_bar_hand_to_motors(&hand, motors, NULL);
}

static int inverse(const kins_params *params, kins_scratch *scratch, const EmcPose *pose, double *joint,
    const KINEMATICS_INVERSE_FLAGS *inverse_flags, KINEMATICS_FORWARD_FLAGS *forward_flags)
{
    FiveBarHandToMotors motors;
    (void)params, (void)scratch, (void)forward_flags, (void)inverse_flags;
    if (motors_at(pose, &motors) != LINKAGE_OK) {
        return -1;
    }
    joint[0] = motors.coordinates.a * DEGREES;
    joint[1] = motors.coordinates.b * DEGREES;
    return 0;
}

static int jacobian(const kins_params *params, const double *joint, const EmcPose *pose,
    double ratios[EMCMOT_MAX_JOINTS][EMCMOT_MAX_AXIS], const KINEMATICS_INVERSE_FLAGS *inverse_flags)
{
    FiveBarHandToMotors motors;
    double turns[2][2];
    int row, column;
    (void)params, (void)joint, (void)inverse_flags;
    if (motors_at(pose, &motors) != LINKAGE_OK || five_bar_hand_to_motors_ratios(&motors, turns, NULL) != LINKAGE_OK) {
        return -1;
    }
    for (row = 0; row < 2; ++row) {
        for (column = 0; column < 2; ++column) {
            ratios[row][column] = turns[row][column] * DEGREES / MILLIMETRES;
        }
    }
    return 0;
}

const kins_ops five_bar_ops = { .forward = forward, .inverse = inverse, .jacobian = jacobian };
