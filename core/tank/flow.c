/* flow.c -- the potential flow around a disc that moves along its normal (Lamb, Hydrodynamics), and
 * an estimate of the flow around a disc that moves along its plane. */
#include "core/tank/flow.h"

/* Speed of the water at the disc's ring as a fraction of the disc's speed along its plane. */
#define EDGE_SHARE 0.16f
/* Smallest distance from the disc's sharp edge, in disc radii, that the formulas of the flow use.
 * At the edge the computed speed would be infinite. */
#define BODY_SHARE 0.3f
/* A level disc counts as dry at this height above the surface and as submerged at this depth below
 * the surface. */
#define ENTRY_HALF_M 0.005f
#define STILL_M_S 1e-4f
/* Distance from the disc's centre, in disc radii, beyond which the flow counts as zero. At this
 * distance the water has a five-hundredth of the disc's speed. */
#define FAR 6.0f

/* Returns the fraction [0, 1] of the disc that is under water, computed from the heights of its
 * lowest and highest points. */
static float immersed(const struct obstacle *disc)
{
    const float slope = f_sqrt(f_max(0.0f, 1.0f - disc->normal.y * disc->normal.y));
    const float half_m = f_max(disc->radius_m * slope, ENTRY_HALF_M);
    return f_clamp(0.5f - 0.5f * disc->centre_m.y / half_m, 0.0f, 1.0f);
}

/* Position or velocity relative to a disc of radius 1. `along` is the component along the disc's
 * normal, and `off` is the component perpendicular to the normal. */
struct place {
    float along, off;
};

/* Oblate spheroidal coordinates zeta and mu of a point in struct place. The point has along = zeta
 * * mu and off = sqrt((1 + zeta^2) * (1 - mu^2)). */
struct spheroidal {
    float zeta, mu;
};

static struct spheroidal spheroidal(struct place at)
{
    const float square = at.along * at.along + at.off * at.off - 1.0f;
    const float root = f_sqrt(square * square + 4.0f * at.along * at.along);
    const float zeta = f_sqrt(f_max(0.0f, 0.5f * (square + root)));
    const float mu = f_sqrt(f_clamp(0.5f * (root - square), 0.0f, 1.0f));
    return (struct spheroidal){ zeta, at.along < 0.0f ? -mu : mu };
}

/* Returns the velocity of the water around a disc of radius 1 that moves with speed 1 along its
 * normal. zeta and mu are the spheroidal coordinates of the point. The member `along` of the result
 * is (2 / pi) * (acot(zeta) - zeta / (zeta^2 + mu^2)). The member `off` is (2 / pi) * mu * sqrt(1 -
 * mu^2) / ((zeta^2 + mu^2) * sqrt(1 + zeta^2)). A lower limit for zeta^2 + mu^2 keeps the velocity
 * at the disc's sharp edge finite. */
static struct place broadside(struct place at)
{
    const struct spheroidal s = spheroidal(at);
    const float zeta2 = s.zeta * s.zeta, mu2 = s.mu * s.mu;
    const float near = f_max(zeta2 + mu2, BODY_SHARE * BODY_SHARE);
    const float share = 2.0f / F_PI;
    return (struct place){
        .along = share * (0.5f * F_PI - f_atan2(s.zeta, 1.0f) - s.zeta / near),
        .off = share * s.mu * f_sqrt(f_max(0.0f, 1.0f - mu2)) / (near * f_sqrt(1.0f + zeta2)),
    };
}

/* Returns the speed of the water around a disc of radius 1 that moves with speed 1 along its plane.
 * The water moves in the direction of the disc. The speed decays with the cube of the distance from
 * the disc. */
static float edgewise(struct place at)
{
    const float beyond = f_max(0.0f, at.off - 1.0f);
    const float gap = f_sqrt(at.along * at.along + beyond * beyond);
    const float near = 1.0f / (1.0f + f_max(BODY_SHARE, gap));
    return EDGE_SHARE * near * near * near;
}

/* Cheap test whether the disc can move the water at a point. Returns 0 only if the flow there is
 * zero. */
static int stirs(const struct obstacle *disc, vec3 point_m)
{
    const vec3 off_m = v3_sub(point_m, disc->centre_m), goes_m_s = obstacle_goes_m_s(disc);
    const float reach_m = FAR * disc->radius_m;
    return disc->kind == OBSTACLE_DISC && point_m.y <= 0.0f &&
           v3_dot(off_m, off_m) < reach_m * reach_m &&
           v3_dot(goes_m_s, goes_m_s) > STILL_M_S * STILL_M_S;
}

vec3 flow_at(const struct obstacle *disc, vec3 point_m)
{
    if (!stirs(disc, point_m)) {
        return v3(0.0f, 0.0f, 0.0f);
    }
    const vec3 to = v3_scale(v3_sub(point_m, disc->centre_m), 1.0f / disc->radius_m);
    const float along = v3_dot(to, disc->normal);
    const vec3 flat = v3_muladd(to, disc->normal, -along);
    const struct place at = { along, v3_length(flat) };
    const vec3 out = v3_normalize_or(flat, v3(0.0f, 0.0f, 0.0f));
    const vec3 goes_m_s = obstacle_goes_m_s(disc);
    const float normal_m_s = v3_dot(goes_m_s, disc->normal);
    const vec3 plane_m_s = v3_muladd(goes_m_s, disc->normal, -normal_m_s);
    const float pushing_m_s = (1.0f - disc->open) * normal_m_s;
    const struct place push = broadside(at);
    const vec3 pushed = v3_add(v3_scale(disc->normal, push.along), v3_scale(out, push.off));
    const vec3 flow = v3_muladd(v3_scale(pushed, pushing_m_s), plane_m_s, edgewise(at));
    return v3_limit(v3_scale(flow, immersed(disc)), v3_length(goes_m_s));
}

float flow_push_m2_s2(const struct obstacle *disc, vec3 point_m)
{
    return v3_length(obstacle_goes_m_s(disc)) * v3_length(flow_at(disc, point_m));
}
