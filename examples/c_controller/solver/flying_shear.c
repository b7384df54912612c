/* flying_shear.c: the solver of FlyingShear, printed by linkage 0.1.0 from its declaration; do not edit.
 *
 * This text is yours: use, change and pass it on under any terms, with or without this notice. It comes
 * without any warranty. */
#include "flying_shear.h"
#include "linkage_run.h"

#if LINKAGE_RUN_TIME != 0x5eb9ddb6u
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
    const float k3_ = 0.5f;
    const float k4_ = 0.945472f;
    const float k6_ = 0.79113925f;
    const float k7_ = 0.094936706f;
    const float ab_r_x_ = k0_ * cosine;
    const float ab_r_y_ = k0_ * sine;
    const float v9_ = qd * ab_r_y_;
    const float v10_ = qd * ab_r_x_;
    const float v12_ = qdd * ab_r_x_;
    const float bc_dc_omega1_squared_ = qd * qd;
    const float v16_ = linkage_fusedf(-ab_r_y_, bc_dc_omega1_squared_, v12_);
    const float bc_dc_d_x_ = linkage_fusedf(-k0_, cosine, 0.6657f);
    const float bc_dc_d_cross_a_ = 0.053256f * sine;
    const float v24_ = ab_r_y_ * ab_r_y_;
    const float bc_dc_d_d_ = linkage_fusedf(-0.106512f, cosine, 0.4495565f);
    const float bc_dc_d2_ = bc_dc_d_d_;
    const float bc_dc_half_over_d2_ = k3_ / bc_dc_d2_;
    const float bc_dc_i_ = bc_dc_d_d_ - 0.066564f;
    const float bc_dc_root_squared_ = bc_dc_i_ * (k4_ - bc_dc_i_);
    const float v40_ = bc_dc_root_squared_;
    const float v41_ = linkage_sqrtf(v40_);
    const float v42_ = v41_;
    const float v43_ = 2.0f / v42_;
    const float v44_ = bc_dc_half_over_d2_ * v41_;
    const float bc_dc_2_b_d2_ = (-0.192984f) + bc_dc_i_;
    const float bc_dc_b_share_ = bc_dc_half_over_d2_ * bc_dc_2_b_d2_;
    const float bc_dc_b_ = bc_dc_b_share_;
    const float v50_ = ab_r_y_ * v44_;
    const float v51_ = bc_dc_d_x_ * v44_;
    const float v54_ = linkage_fusedf(bc_dc_d_x_, bc_dc_b_, v50_);
    const float bc_dc_r3_y_ = linkage_fusedf(ab_r_y_, bc_dc_b_, -v51_);
    const float bc_dc_r2_x_ = bc_dc_d_x_ - v54_;
    const float bc_dc_r2_y_ = bc_dc_r3_y_ - ab_r_y_;
    const float bc_dc_r3_dot_a_ = linkage_fusedf(ab_r_y_, bc_dc_r3_y_, -(ab_r_x_ * v54_));
    const float bc_dc_r3_cross_a_ = linkage_fusedf(-bc_dc_d_cross_a_, bc_dc_b_, v44_ * linkage_fusedf(ab_r_x_, bc_dc_d_x_, -v24_));
    const float bc_dc_r2_cross_a_ = bc_dc_d_cross_a_ + bc_dc_r3_cross_a_;
    const float v71_ = qd * v43_;
    const float v72_ = bc_dc_r3_cross_a_ * v71_;
    const float v73_ = bc_dc_r2_cross_a_ * v71_;
    const float bc_dc_g_r3_ = linkage_fusedf(qdd, bc_dc_r3_cross_a_, bc_dc_omega1_squared_ * bc_dc_r3_dot_a_);
    const float bc_dc_r2_r3_ = linkage_fusedf(-k3_, bc_dc_i_, 0.236368f);
    const float bc_dc_omega2_squared_ = v72_ * v72_;
    const float bc_dc_omega3_squared_ = v73_ * v73_;
    const float v87_ = v43_ * linkage_fusedf(-0.139876f, bc_dc_omega3_squared_, linkage_fusedf(bc_dc_r2_r3_, bc_dc_omega2_squared_, bc_dc_g_r3_));
    const float v89_ = k6_ * bc_dc_r2_x_;
    const float v90_ = k6_ * bc_dc_r2_y_;
    const float v94_ = linkage_fusedf(k7_, bc_dc_r2_y_, v89_);
    const float v96_ = linkage_fusedf(-k7_, bc_dc_r2_x_, v90_);
    const float blade_vx_ = linkage_fusedf(v72_, v96_, -v9_);
    const float blade_vy_ = linkage_fusedf(-v72_, v94_, v10_);
    const float blade_ax_ = linkage_fusedf(-ab_r_x_, bc_dc_omega1_squared_, linkage_fusedf(-qdd, ab_r_y_, linkage_fusedf(-bc_dc_omega2_squared_, v94_, v87_ * v96_)));
    const float blade_ay_ = linkage_fusedf(-v87_, v94_, linkage_fusedf(-bc_dc_omega2_squared_, v96_, v16_));
    const float blade_x_ = ab_r_x_ + v94_;
    const float blade_y_ = ab_r_y_ + v96_;
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
    const float k3_ = 0.5f;
    const float k4_ = 0.945472f;
    const float k5_ = 0.9568517f;
    const float k6_ = 0.79113925f;
    const float k7_ = 0.094936706f;
    const float ab_r_x_ = k0_ * cosine;
    const float ab_r_y_ = k0_ * sine;
    const float v9_ = qd * ab_r_y_;
    const float v10_ = qd * ab_r_x_;
    const float v12_ = qdd * ab_r_x_;
    const float bc_dc_omega1_squared_ = qd * qd;
    const float v16_ = linkage_fusedf(-ab_r_y_, bc_dc_omega1_squared_, v12_);
    const float bc_dc_d_x_ = linkage_fusedf(-k0_, cosine, 0.6657f);
    const float bc_dc_d_cross_a_ = 0.053256f * sine;
    const float v24_ = ab_r_y_ * ab_r_y_;
    const float bc_dc_d_d_ = linkage_fusedf(-0.106512f, cosine, 0.4495565f);
    const float bc_dc_d2_ = (float)linkage_square_of_centres(why, bc_dc_d_d_, bc_dc_d_x_, -ab_r_y_, k1_, k2_, "BC, DC");
    const float bc_dc_half_over_d2_ = k3_ / bc_dc_d2_;
    const float bc_dc_i_ = bc_dc_d_d_ - 0.066564f;
    const float bc_dc_root_squared_ = bc_dc_i_ * (k4_ - bc_dc_i_);
    const float v40_ = (float)linkage_reach_circles(why, bc_dc_root_squared_, bc_dc_d_x_, -ab_r_y_, k1_, k2_, k4_, k5_, "BC, DC");
    const float v41_ = linkage_sqrtf(v40_);
    const float v42_ = (float)linkage_nonzero(why, v41_, "BC, DC");
    const float v43_ = 2.0f / v42_;
    const float v44_ = bc_dc_half_over_d2_ * v41_;
    const float bc_dc_2_b_d2_ = (-0.192984f) + bc_dc_i_;
    const float bc_dc_b_share_ = bc_dc_half_over_d2_ * bc_dc_2_b_d2_;
    const float bc_dc_b_ = (float)linkage_share_of_centres(why, bc_dc_b_share_, bc_dc_root_squared_, bc_dc_d_x_, -ab_r_y_, k2_, k1_, k5_, "BC, DC");
    const float v50_ = ab_r_y_ * v44_;
    const float v51_ = bc_dc_d_x_ * v44_;
    const float v54_ = linkage_fusedf(bc_dc_d_x_, bc_dc_b_, v50_);
    const float bc_dc_r3_y_ = linkage_fusedf(ab_r_y_, bc_dc_b_, -v51_);
    const float bc_dc_r2_x_ = bc_dc_d_x_ - v54_;
    const float bc_dc_r2_y_ = bc_dc_r3_y_ - ab_r_y_;
    const float bc_dc_r3_dot_a_ = linkage_fusedf(ab_r_y_, bc_dc_r3_y_, -(ab_r_x_ * v54_));
    const float bc_dc_r3_cross_a_ = linkage_fusedf(-bc_dc_d_cross_a_, bc_dc_b_, v44_ * linkage_fusedf(ab_r_x_, bc_dc_d_x_, -v24_));
    const float bc_dc_r2_cross_a_ = bc_dc_d_cross_a_ + bc_dc_r3_cross_a_;
    const float v71_ = qd * v43_;
    const float v72_ = bc_dc_r3_cross_a_ * v71_;
    const float v73_ = bc_dc_r2_cross_a_ * v71_;
    const float bc_dc_g_r3_ = linkage_fusedf(qdd, bc_dc_r3_cross_a_, bc_dc_omega1_squared_ * bc_dc_r3_dot_a_);
    const float bc_dc_r2_r3_ = linkage_fusedf(-k3_, bc_dc_i_, 0.236368f);
    const float bc_dc_omega2_squared_ = v72_ * v72_;
    const float bc_dc_omega3_squared_ = v73_ * v73_;
    const float v87_ = v43_ * linkage_fusedf(-0.139876f, bc_dc_omega3_squared_, linkage_fusedf(bc_dc_r2_r3_, bc_dc_omega2_squared_, bc_dc_g_r3_));
    const float v89_ = k6_ * bc_dc_r2_x_;
    const float v90_ = k6_ * bc_dc_r2_y_;
    const float v94_ = linkage_fusedf(k7_, bc_dc_r2_y_, v89_);
    const float v96_ = linkage_fusedf(-k7_, bc_dc_r2_x_, v90_);
    const float blade_vx_ = linkage_fusedf(v72_, v96_, -v9_);
    const float blade_vy_ = linkage_fusedf(-v72_, v94_, v10_);
    const float blade_ax_ = linkage_fusedf(-ab_r_x_, bc_dc_omega1_squared_, linkage_fusedf(-qdd, ab_r_y_, linkage_fusedf(-bc_dc_omega2_squared_, v94_, v87_ * v96_)));
    const float blade_ay_ = linkage_fusedf(-v87_, v94_, linkage_fusedf(-bc_dc_omega2_squared_, v96_, v16_));
    const float blade_x_ = ab_r_x_ + v94_;
    const float blade_y_ = ab_r_y_ + v96_;
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
