/* The names that a kinematics module of LinuxCNC has from <kins_module.h>, for a test alone. */
#ifndef KINS_MODULE_H
#define KINS_MODULE_H

#define EMCMOT_MAX_JOINTS 16
#define EMCMOT_MAX_AXIS 9

typedef struct { double x, y, z; } PmCartesian;
typedef struct { PmCartesian tran; double a, b, c, u, v, w; } EmcPose;
typedef unsigned long KINEMATICS_FORWARD_FLAGS;
typedef unsigned long KINEMATICS_INVERSE_FLAGS;
typedef struct { double value[16]; } kins_params;
typedef struct { double value[16]; } kins_scratch;

typedef struct {
    int (*forward)(const kins_params *, kins_scratch *, const double *, EmcPose *, const KINEMATICS_FORWARD_FLAGS *,
        KINEMATICS_INVERSE_FLAGS *);
    int (*inverse)(const kins_params *, kins_scratch *, const EmcPose *, double *, const KINEMATICS_INVERSE_FLAGS *,
        KINEMATICS_FORWARD_FLAGS *);
    int (*jacobian)(const kins_params *, const double *, const EmcPose *, double[EMCMOT_MAX_JOINTS][EMCMOT_MAX_AXIS],
        const KINEMATICS_INVERSE_FLAGS *);
} kins_ops;

#endif /* KINS_MODULE_H */
