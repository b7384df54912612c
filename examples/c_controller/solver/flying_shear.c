/* flying_shear.c: the solver of FlyingShear, printed by linkage 0.1.0 from its declaration; do not edit.
 *
 * This text is yours: use, change and pass it on under any terms, with or without this notice. It comes
 * without any warranty. */
#include "flying_shear.h"
#include "linkage_run.h"

#if LINKAGE_RUN_TIME != 0xd8d294a9u
#error "linkage_run.h was printed by another version than this file: print both anew, or one supplier's with a prefix"
#endif

const char flying_shear_origin[] = "linkage 0.1.0 FlyingShear 736bff468ce27e07";
const char *const flying_shear_input_labels[FLYING_SHEAR_INPUTS + 1] = { "theta", NULL };
const char *const flying_shear_output_labels[FLYING_SHEAR_OUTPUTS + 1] = { "blade.x", "blade.y", NULL };

#ifndef LINKAGE_NO_SINGLE

static LINKAGE_INLINE int flying_shear_compare_formulas_motion_atf(float cosine, float sine, float qd, float qdd, FlyingShearMotionF32 *to)
{
    int ok = 1;
    const float k0_ = 0.08f;
    const float k3_ = 1.0f;
    const float k4_ = 0.472736f;
    const float k6_ = 0.79113925f;
    const float k7_ = 0.094936706f;
    const float ab_r_x_ = k0_ * cosine;
    const float ab_r_y_ = k0_ * sine;
    const float v10_ = qd * ab_r_y_;
    const float v11_ = qd * ab_r_x_;
    const float v13_ = qdd * ab_r_x_;
    const float bc_dc_omega1_squared_ = qd * qd;
    const float v17_ = linkage_fusedf(-ab_r_y_, bc_dc_omega1_squared_, v13_);
    const float bc_dc_d_x_ = linkage_fusedf(-k0_, cosine, 0.6657f);
    const float bc_dc_d_d_ = linkage_fusedf(-0.106512f, cosine, 0.4495565f);
    const float bc_dc_d2_ = bc_dc_d_d_;
    const float bc_dc_inverse_d2_ = k3_ / bc_dc_d2_;
    const float bc_dc_i_half_ = linkage_fusedf(0.5f, bc_dc_d_d_, -0.033282f);
    const float bc_dc_j_j_ = bc_dc_i_half_ * (k4_ - bc_dc_i_half_);
    const float bc_dc_j2_ = bc_dc_j_j_;
    const float v42_ = linkage_sqrtf(bc_dc_j2_);
    const float v43_ = v42_;
    const float v44_ = k3_ / v43_;
    const float v45_ = bc_dc_inverse_d2_ * v42_;
    const float bc_dc_b_d2_ = bc_dc_i_half_ - 0.096492f;
    const float bc_dc_b_share_ = bc_dc_inverse_d2_ * bc_dc_b_d2_;
    const float bc_dc_b_ = bc_dc_b_share_;
    const float v50_ = ab_r_y_ * v45_;
    const float v51_ = bc_dc_d_x_ * v45_;
    const float v54_ = linkage_fusedf(bc_dc_d_x_, bc_dc_b_, v50_);
    const float bc_dc_r3_y_ = linkage_fusedf(ab_r_y_, bc_dc_b_, -v51_);
    const float bc_dc_r2_x_ = bc_dc_d_x_ - v54_;
    const float bc_dc_r2_y_ = bc_dc_r3_y_ - ab_r_y_;
    const float bc_dc_r3_dot_a_ = linkage_fusedf(ab_r_y_, bc_dc_r3_y_, -(ab_r_x_ * v54_));
    const float v65_ = linkage_fusedf(ab_r_x_, bc_dc_r3_y_, ab_r_y_ * v54_);
    const float bc_dc_r2_cross_a_ = linkage_fusedf(0.053256f, sine, -v65_);
    const float v68_ = qd * v44_;
    const float bc_dc_omega2_ = v65_ * v68_;
    const float v70_ = bc_dc_r2_cross_a_ * v68_;
    const float bc_dc_g_r3_ = linkage_fusedf(-qdd, v65_, bc_dc_omega1_squared_ * bc_dc_r3_dot_a_);
    const float bc_dc_r2_r3_ = 0.236368f - bc_dc_i_half_;
    const float bc_dc_omega2_squared_ = bc_dc_omega2_ * bc_dc_omega2_;
    const float bc_dc_omega3_squared_ = v70_ * v70_;
    const float v84_ = v44_ * linkage_fusedf(-0.139876f, bc_dc_omega3_squared_, linkage_fusedf(bc_dc_r2_r3_, bc_dc_omega2_squared_, bc_dc_g_r3_));
    const float v86_ = k6_ * bc_dc_r2_x_;
    const float v87_ = k6_ * bc_dc_r2_y_;
    const float v91_ = linkage_fusedf(k7_, bc_dc_r2_y_, v86_);
    const float v93_ = linkage_fusedf(-k7_, bc_dc_r2_x_, v87_);
    const float blade_vx_ = linkage_fusedf(-bc_dc_omega2_, v93_, -v10_);
    const float blade_vy_ = linkage_fusedf(bc_dc_omega2_, v91_, v11_);
    const float blade_ax_ = linkage_fusedf(-ab_r_x_, bc_dc_omega1_squared_, linkage_fusedf(-qdd, ab_r_y_, linkage_fusedf(-bc_dc_omega2_squared_, v91_, v84_ * v93_)));
    const float blade_ay_ = linkage_fusedf(-v84_, v91_, linkage_fusedf(-bc_dc_omega2_squared_, v93_, v17_));
    const float blade_x_ = ab_r_x_ + v91_;
    const float blade_y_ = ab_r_y_ + v93_;
    to->position.blade.x = blade_x_;
    to->position.blade.y = blade_y_;
    to->velocity.blade.x = blade_vx_;
    to->velocity.blade.y = blade_vy_;
    to->acceleration.blade.x = blade_ax_;
    to->acceleration.blade.y = blade_ay_;
    return ok;
}

static LINKAGE_COLD void flying_shear_diagnose_formulas_motion_atf(LinkageWhy *why, float cosine, float sine, float qd, float qdd, FlyingShearMotionF32 *to)
{
    const float k0_ = 0.08f;
    const float k1_ = 0.632f;
    const float k2_ = 0.374f;
    const float k3_ = 1.0f;
    const float k4_ = 0.472736f;
    const float k5_ = 0.23921293f;
    const float k6_ = 0.79113925f;
    const float k7_ = 0.094936706f;
    const float ab_r_x_ = k0_ * cosine;
    const float ab_r_y_ = k0_ * sine;
    const float v10_ = qd * ab_r_y_;
    const float v11_ = qd * ab_r_x_;
    const float v13_ = qdd * ab_r_x_;
    const float bc_dc_omega1_squared_ = qd * qd;
    const float v17_ = linkage_fusedf(-ab_r_y_, bc_dc_omega1_squared_, v13_);
    const float bc_dc_d_x_ = linkage_fusedf(-k0_, cosine, 0.6657f);
    const float bc_dc_d_d_ = linkage_fusedf(-0.106512f, cosine, 0.4495565f);
    const float bc_dc_d2_ = (float)linkage_square_of_centres(why, bc_dc_d_d_, bc_dc_d_x_, -ab_r_y_, k1_, k2_, "BC, DC");
    const float bc_dc_inverse_d2_ = k3_ / bc_dc_d2_;
    const float bc_dc_i_half_ = linkage_fusedf(0.5f, bc_dc_d_d_, -0.033282f);
    const float bc_dc_j_j_ = bc_dc_i_half_ * (k4_ - bc_dc_i_half_);
    const float bc_dc_j2_ = (float)linkage_reach_circles(why, bc_dc_j_j_, bc_dc_d_x_, -ab_r_y_, k1_, k2_, k4_, k5_, "BC, DC");
    const float v42_ = linkage_sqrtf(bc_dc_j2_);
    const float v43_ = (float)linkage_nonzero(why, v42_, "BC, DC");
    const float v44_ = k3_ / v43_;
    const float v45_ = bc_dc_inverse_d2_ * v42_;
    const float bc_dc_b_d2_ = bc_dc_i_half_ - 0.096492f;
    const float bc_dc_b_share_ = bc_dc_inverse_d2_ * bc_dc_b_d2_;
    const float bc_dc_b_ = (float)linkage_share_of_centres(why, bc_dc_b_share_, bc_dc_j_j_, bc_dc_d_x_, -ab_r_y_, k2_, k1_, k5_, "BC, DC");
    const float v50_ = ab_r_y_ * v45_;
    const float v51_ = bc_dc_d_x_ * v45_;
    const float v54_ = linkage_fusedf(bc_dc_d_x_, bc_dc_b_, v50_);
    const float bc_dc_r3_y_ = linkage_fusedf(ab_r_y_, bc_dc_b_, -v51_);
    const float bc_dc_r2_x_ = bc_dc_d_x_ - v54_;
    const float bc_dc_r2_y_ = bc_dc_r3_y_ - ab_r_y_;
    const float bc_dc_r3_dot_a_ = linkage_fusedf(ab_r_y_, bc_dc_r3_y_, -(ab_r_x_ * v54_));
    const float v65_ = linkage_fusedf(ab_r_x_, bc_dc_r3_y_, ab_r_y_ * v54_);
    const float bc_dc_r2_cross_a_ = linkage_fusedf(0.053256f, sine, -v65_);
    const float v68_ = qd * v44_;
    const float bc_dc_omega2_ = v65_ * v68_;
    const float v70_ = bc_dc_r2_cross_a_ * v68_;
    const float bc_dc_g_r3_ = linkage_fusedf(-qdd, v65_, bc_dc_omega1_squared_ * bc_dc_r3_dot_a_);
    const float bc_dc_r2_r3_ = 0.236368f - bc_dc_i_half_;
    const float bc_dc_omega2_squared_ = bc_dc_omega2_ * bc_dc_omega2_;
    const float bc_dc_omega3_squared_ = v70_ * v70_;
    const float v84_ = v44_ * linkage_fusedf(-0.139876f, bc_dc_omega3_squared_, linkage_fusedf(bc_dc_r2_r3_, bc_dc_omega2_squared_, bc_dc_g_r3_));
    const float v86_ = k6_ * bc_dc_r2_x_;
    const float v87_ = k6_ * bc_dc_r2_y_;
    const float v91_ = linkage_fusedf(k7_, bc_dc_r2_y_, v86_);
    const float v93_ = linkage_fusedf(-k7_, bc_dc_r2_x_, v87_);
    const float blade_vx_ = linkage_fusedf(-bc_dc_omega2_, v93_, -v10_);
    const float blade_vy_ = linkage_fusedf(bc_dc_omega2_, v91_, v11_);
    const float blade_ax_ = linkage_fusedf(-ab_r_x_, bc_dc_omega1_squared_, linkage_fusedf(-qdd, ab_r_y_, linkage_fusedf(-bc_dc_omega2_squared_, v91_, v84_ * v93_)));
    const float blade_ay_ = linkage_fusedf(-v84_, v91_, linkage_fusedf(-bc_dc_omega2_squared_, v93_, v17_));
    const float blade_x_ = ab_r_x_ + v91_;
    const float blade_y_ = ab_r_y_ + v93_;
    to->position.blade.x = blade_x_;
    to->position.blade.y = blade_y_;
    to->velocity.blade.x = blade_vx_;
    to->velocity.blade.y = blade_vy_;
    to->acceleration.blade.x = blade_ax_;
    to->acceleration.blade.y = blade_ay_;
}

static LINKAGE_INLINE int flying_shear_try_motion_atf(float cosine, float sine, float qd, float qdd, float square, FlyingShearMotionF32 *to)
{
    int ok = flying_shear_compare_formulas_motion_atf(cosine, sine, qd, qdd, to);
    ok &= 7.018599e18f >= linkage_fusedf(linkage_fusedf(qd, qd, square), linkage_fusedf(qd, qd, square), qdd * qdd);
    return ok;
}

static LINKAGE_COLD LinkageStatus flying_shear_why_motion_atf(float cosine, float sine, float qd, float qdd, FlyingShearMotionF32 *to, LinkageError *error)
{
    LinkageWhy why = linkage_why(1);
    FlyingShearMotionF32 found;
    LinkageNamed given[4];
    given[0].value = cosine;
    given[0].name = "cos";
    given[1].value = sine;
    given[1].name = "sin";
    given[2].value = qd;
    given[2].name = "theta_rate";
    given[3].value = qdd;
    given[3].name = "theta_acceleration";
    linkage_given_finite(&why, given, 4);
    if (why.status != LINKAGE_OK) {
        return linkage_refused(&why, error);
    }
    flying_shear_diagnose_formulas_motion_atf(&why, cosine, sine, qd, qdd, &found);
    {
        LinkageNamed results[6];
        results[0].value = found.position.blade.x;
        results[0].name = "blade.x";
        results[1].value = found.position.blade.y;
        results[1].name = "blade.y";
        results[2].value = found.velocity.blade.x;
        results[2].name = "velocity of blade.x";
        results[3].value = found.velocity.blade.y;
        results[3].name = "velocity of blade.y";
        results[4].value = found.acceleration.blade.x;
        results[4].name = "acceleration of blade.x";
        results[5].value = found.acceleration.blade.y;
        results[5].name = "acceleration of blade.y";
        linkage_results_finite(&why, results, 6, given, 4);
    }
    if (why.status != LINKAGE_OK) {
        return linkage_refused(&why, error);
    }
    *to = found;
    return LINKAGE_OK;
}

LinkageStatus flying_shear_motion_f32(float theta, float theta_rate, float theta_acceleration, FlyingShearMotionF32 *motion, LinkageError *error)
{
    FlyingShearMotionF32 result;
    int ok;
    float cosine, sine;
    if (motion == NULL) {
        return linkage_because(error, LINKAGE_NULL_POINTER, "motion");
    }
    linkage_sin_cos_nearf(theta, &sine, &cosine);
    ok = flying_shear_try_motion_atf(cosine, sine, theta_rate, theta_acceleration, theta * theta, &result);
    if (ok) {
        motion->position.blade.x = result.position.blade.x;
        motion->position.blade.y = result.position.blade.y;
        motion->velocity.blade.x = result.velocity.blade.x;
        motion->velocity.blade.y = result.velocity.blade.y;
        motion->acceleration.blade.x = result.acceleration.blade.x;
        motion->acceleration.blade.y = result.acceleration.blade.y;
        return LINKAGE_OK;
    }
    if (!linkage_is_finitef(theta)) {
        return linkage_because(error, LINKAGE_NOT_FINITE, "theta");
    }
    linkage_sin_cosf(theta, &sine, &cosine);
    return flying_shear_why_motion_atf(cosine, sine, theta_rate, theta_acceleration, motion, error);
}

LinkageStatus flying_shear_motion_at_f32(float cos, float sin, float theta_rate, float theta_acceleration, FlyingShearMotionF32 *motion, LinkageError *error)
{
    FlyingShearMotionF32 result;
    int ok;
    float cosine, sine;
    if (motion == NULL) {
        return linkage_because(error, LINKAGE_NULL_POINTER, "motion");
    }
    if (!linkage_on_circlef(cos, sin, &cosine, &sine)) {
        return linkage_not_on_circle(error, cos, sin, "theta");
    }
    ok = flying_shear_try_motion_atf(cosine, sine, theta_rate, theta_acceleration, (-0.0f), &result);
    if (ok) {
        motion->position.blade.x = result.position.blade.x;
        motion->position.blade.y = result.position.blade.y;
        motion->velocity.blade.x = result.velocity.blade.x;
        motion->velocity.blade.y = result.velocity.blade.y;
        motion->acceleration.blade.x = result.acceleration.blade.x;
        motion->acceleration.blade.y = result.acceleration.blade.y;
        return LINKAGE_OK;
    }
    return flying_shear_why_motion_atf(cosine, sine, theta_rate, theta_acceleration, motion, error);
}

#endif /* LINKAGE_NO_SINGLE */
