/* obstacle.c -- contact of fish with the ring and paper of a poi (paper scoop) and with the hull of
 * a bowl. The file also computes how a blocked obstacle moves back, and how fish beside a poi step
 * aside. */
#include "core/tank/collision/obstacle.h"

#include "core/base/panic.h"
#include "core/input.h"

#define SIDESTEP_RANGE_M 0.05f
#define SIDESTEP_M_S 0.012f
/* Speed of a poi below which the poi counts as still, so that fish beside it do not step aside. */
#define STILL_M_S 0.01f

struct touch obstacle_touch(const struct obstacle *obstacle, const struct box *box)
{
    CORE_ASSERT(obstacle->kind <= OBSTACLE_BOWL);
    CORE_ASSERT(obstacle->radius_m > 0.0f);
    if (obstacle->kind == OBSTACLE_BOWL) {
        const struct hull hull = { obstacle->centre_m, obstacle->radius_m, obstacle->depth_m };
        return shape_touch_hull(&hull, box);
    }
    const float tube_m = RING_TUBE_PER_RADIUS * obstacle->radius_m;
    const struct ring ring = { obstacle->centre_m, obstacle->normal, obstacle->radius_m - tube_m,
                               tube_m };
    return shape_touch_ring(&ring, box);
}

vec3 obstacle_clear(const struct obstacle *obstacle, const struct box *box)
{
    const struct touch touch = obstacle_touch(obstacle, box);
    return v3_scale(touch.out, f_max(0.0f, -touch.gap_m));
}

bool obstacle_in_reach(const struct obstacle *obstacle, const struct box *box)
{
    CORE_ASSERT(obstacle->radius_m > 0.0f);
    const vec3 d = v3_sub(box->centre_m, obstacle->centre_m);
    const float reach_m = obstacle->radius_m + v3_length(box->half_m) + OBSTACLE_REACH_M;
    return v3_dot(d, d) < reach_m * reach_m;
}

vec3 obstacle_sidestep_m_s(const struct obstacle *disc, vec3 position_m)
{
    const vec3 none = { 0.0f, 0.0f, 0.0f };
    const vec3 d = v3_flat(v3_sub(position_m, disc->centre_m));
    const float out_m = v3_length(d) - disc->radius_m;
    const float below_m = f_abs(position_m.y - disc->centre_m.y);
    if (disc->kind != OBSTACLE_DISC || out_m < 0.0f || out_m > SIDESTEP_RANGE_M ||
        below_m > SIDESTEP_RANGE_M || v3_length(disc->velocity_m_s) < STILL_M_S) {
        return none;
    }
    const float near = 1.0f - out_m / SIDESTEP_RANGE_M;
    return v3_scale(v3_normalize_or(d, none), SIDESTEP_M_S * near);
}

/* ---- Constants of the contact with ring, paper and hull -------------------------------------- */

/* Largest number of times in one substep that the contact solver undoes a part of an obstacle's
 * motion, because a fish blocks the obstacle. The next time, the solver undoes the whole motion. */
#define GIVE_MAX 8u
/* Extra distance by which a blocked obstacle moves back from a fish, so that rounding does not
 * leave a penetration. */
#define GIVE_MIN_M 0.00002f
/* Smallest distance that the contact solver allows between the centre of a fish and the paper of a
 * poi. */
#define SIDE_GAP_M 0.0005f
/* Distance per tick by which the paper of a poi pushes out a fish that got into the paper from the
 * side, over the ring. */
#define PAPER_PUSH_M 0.0025f
/* Speed of a poi's paper along its normal at which friction gives a fish in front of the paper half
 * of the paper's sideways speed. At a higher speed, the flow presses the fish more strongly onto
 * the paper, so the fraction is larger. */
#define PIN_M_S 0.12f
/* Largest push along the normal of a poi's ring, as a multiple of the fish's penetration into the
 * ring. This push makes a fish glide over the ring. */
#define GLIDE 1.5f
/* Largest distance from the plane of a poi's paper at which a fish can touch the paper in one
 * tick. */
#define NEAR_PLANE_M 0.06f

struct obstacle obstacle_before(const struct obstacle *obstacle)
{
    struct obstacle before = *obstacle;
    before.centre_m = v3_sub(obstacle->centre_m, obstacle->step_m);
    if (obstacle->turned) {
        before.normal = obstacle->axes_before.up;
        before.axes = obstacle->axes_before;
    }
    return before;
}

/* ---- Contact with the paper ------------------------------------------------------------------ */

static bool paper_holds(const struct obstacle *disc, float x_m, float z_m)
{
    CORE_ASSERT(disc->paper);
    CORE_ASSERT(disc->paper_radius_m > 0.0f);
    const float radius_m = disc->paper_radius_m;
    if (x_m * x_m + z_m * z_m >= radius_m * radius_m) {
        return false;
    }
    const float cells_per_m = 0.5f * (float)OBSTACLE_PAPER_SIDE / radius_m;
    const float last = (float)(OBSTACLE_PAPER_SIDE - 1u);
    const uint32_t column = (uint32_t)f_clamp((x_m + radius_m) * cells_per_m, 0.0f, last);
    const uint32_t row = (uint32_t)f_clamp((z_m + radius_m) * cells_per_m, 0.0f, last);
    return disc->paper[row * OBSTACLE_PAPER_SIDE + column] == OBSTACLE_PAPER_HOLDS;
}

/* Returns half the thickness of the fish along a world unit vector. The shape of the fish is
 * modelled as the ellipsoid that fits into its box. */
static float half_thick_m(const struct body *body, vec3 direction)
{
    const float x = body->half_x_m * v3_dot(body->right, direction);
    const float y = body->half_y_m * v3_dot(body->up, direction);
    const float z = body->half_z_m * v3_dot(body->back, direction);
    return f_sqrt(x * x + y * y + z * z);
}

/* Position of a fish relative to the paper of a poi. */
struct side {
    float side;     /* Side of the paper: +1 means above, -1 means below, 0 means that no paper is
                       near. */
    float height_m; /* Distance of the fish's centre from the paper. A value > 0 is on the side
                       `side`, and a value < 0 means that the fish passed through the paper. */
    float clear_m;  /* Distance of the fish's centre from the paper at which the body just does not
                       touch the paper. */
    float was_m;    /* Distance of the fish's centre from the paper at the start of the substep, as
                       in `height_m`. */
};

static struct side disc_side_of(const struct obstacle *disc, const struct body *now, vec3 before_m)
{
    struct side none = { 0 };
    const vec3 away = v3_sub(now->centre_m, disc->centre_m);
    const float reach_m = NEAR_PLANE_M + disc->paper_radius_m;
    if (!disc->paper || v3_dot(away, away) > reach_m * reach_m) {
        return none;
    }
    const struct obstacle old = obstacle_before(disc);
    const vec3 q1 = vec_basis_to_body(&disc->axes, away);
    const vec3 q0 = vec_basis_to_body(&old.axes, v3_sub(before_m, old.centre_m));
    const float side = q0.y < 0.0f ? -1.0f : 1.0f;
    /* A fish that crossed the plane of the paper may have passed outside the paper or through a
     * hole. Therefore the place of the crossing is tested. `t` is the fraction of the fish's path
     * in this substep up to that place. If the fish did not cross the plane, `t` is 1, and the
     * present place is tested. */
    const float t = side * q1.y < 0.0f ? q0.y / (q0.y - q1.y) : 1.0f;
    if (!paper_holds(disc, f_lerp(q0.x, q1.x, t), f_lerp(q0.z, q1.z, t)) ||
        f_abs(q1.y) > NEAR_PLANE_M) {
        return none;
    }
    return (struct side){ side, side * q1.y, half_thick_m(now, disc->axes.up), side * q0.y };
}

vec3 obstacle_paper_push(const struct obstacle *disc, const struct body *now, vec3 before_m)
{
    const struct side at = disc_side_of(disc, now, before_m);
    if (at.side == 0.0f || at.height_m >= at.clear_m) {
        return v3(0.0f, 0.0f, 0.0f);
    }
    const float freed_m = f_max(at.height_m, SIDE_GAP_M) + PAPER_PUSH_M;
    const float goal_m = f_min(at.clear_m, f_max(freed_m, at.clear_m - 0.8f * RING_SAG_M));
    const vec3 off = v3_scale(disc->axes.up, at.side * (goal_m - at.height_m));
    /* The flow around the moving paper presses the fish flat onto the paper. Friction then moves
     * the fish along with the paper, also sideways. */
    const vec3 v = disc->velocity_m_s, up = disc->axes.up;
    const float closing_m_s = at.side * v3_dot(v, up);
    if (closing_m_s <= 0.0f) {
        return off;
    }
    const vec3 along = v3_muladd(v, up, -v3_dot(v, up));
    const float square = closing_m_s * closing_m_s;
    const vec3 carry_m_s = v3_scale(along, square / (square + PIN_M_S * PIN_M_S));
    return v3_muladd(off, carry_m_s, CORE_TICK_S);
}

vec3 obstacle_paper_hold(const struct obstacle *disc, const struct body *now, vec3 before_m)
{
    const struct side at = disc_side_of(disc, now, before_m);
    if (at.side == 0.0f || at.height_m >= SIDE_GAP_M) {
        return v3(0.0f, 0.0f, 0.0f);
    }
    return v3_scale(disc->axes.up, at.side * (SIDE_GAP_M - at.height_m));
}

/* ---- Contact with the ring or hull ----------------------------------------------------------- */

vec3 obstacle_hard_push(const struct obstacle *obstacle, const struct body *now)
{
    const struct box box = body_box(now);
    const vec3 off = obstacle_clear(obstacle, &box);
    const float depth_m = v3_length(off);
    if (obstacle->kind != OBSTACLE_DISC || depth_m <= 0.0f) {
        return off;
    }
    const vec3 normal = obstacle->normal;
    const float height_m = v3_dot(v3_sub(now->centre_m, obstacle->centre_m), normal);
    const float round = f_clamp(height_m / half_thick_m(now, normal), -1.0f, 1.0f);
    return v3_muladd(off, normal, GLIDE * depth_m * round);
}

/* ---- Penetration of a fish, and undoing the motion of an obstacle ---------------------------- */

static float hard_excess_m(const struct obstacle *obstacle, const struct body *now,
                           const struct body *before, float free_m, vec3 *out)
{
    const struct box box = body_box(now);
    const struct touch touch = obstacle_touch(obstacle, &box);
    *out = touch.out;
    if (touch.gap_m >= -free_m) {
        return 0.0f;
    }
    const struct obstacle old = obstacle_before(obstacle);
    const struct box box_before = body_box(before);
    const float was_m = -obstacle_touch(&old, &box_before).gap_m;
    return -touch.gap_m - f_max(free_m, was_m);
}

float obstacle_excess_m(const struct obstacle *obstacle, const struct body *now,
                        const struct body *before, float free_m, vec3 *out)
{
    CORE_ASSERT(free_m >= 0.0f);
    const float hard_m = hard_excess_m(obstacle, now, before, free_m, out);
    if (hard_m > 0.0f || !obstacle->paper) {
        return hard_m;
    }
    const struct side at = disc_side_of(obstacle, now, before->centre_m);
    *out = v3_scale(obstacle->axes.up, at.side);
    if (at.side == 0.0f) {
        return 0.0f;
    }
    const struct basis axes = obstacle->turned ? obstacle->axes_before : obstacle->axes;
    const float was_in_m = half_thick_m(before, axes.up) - at.was_m;
    return at.clear_m - at.height_m - f_max(RING_SAG_M, was_in_m);
}

vec3 obstacle_carry_m(const struct obstacle *obstacle, vec3 before_m)
{
    if (!obstacle->turned) {
        return v3_add(before_m, obstacle->step_m);
    }
    const struct obstacle old = obstacle_before(obstacle);
    const vec3 place = vec_basis_to_body(&old.axes, v3_sub(before_m, old.centre_m));
    return v3_add(obstacle->centre_m, vec_basis_to_world(&obstacle->axes, place));
}

static void turn_back(struct obstacle *obstacle)
{
    obstacle->normal = obstacle->axes_before.up;
    obstacle->axes = obstacle->axes_before;
    obstacle->turned = false;
    obstacle->reaction |= REACTION_ROTATION;
}

bool obstacle_apply_reaction(struct obstacle *obstacle, vec3 out, float excess_m)
{
    CORE_ASSERT(excess_m > 0.0f);
    const float closing_m = v3_dot(obstacle->step_m, out);
    const bool moved = v3_dot(obstacle->step_m, obstacle->step_m) > 0.0f;
    if (!moved && !obstacle->turned) {
        return false;
    }
    if (obstacle->reaction_count++ < GIVE_MAX && closing_m > GIVE_MIN_M) {
        const float back_m = f_min(closing_m, excess_m + GIVE_MIN_M);
        obstacle->step_m = v3_muladd(obstacle->step_m, out, -back_m);
        obstacle->centre_m = v3_muladd(obstacle->centre_m, out, -back_m);
        obstacle->reaction |= REACTION_POSITION;
    } else if (obstacle->reaction_count <= GIVE_MAX && obstacle->turned) {
        turn_back(obstacle);
    } else {
        obstacle->centre_m = v3_sub(obstacle->centre_m, obstacle->step_m);
        obstacle->step_m = v3(0.0f, 0.0f, 0.0f);
        obstacle->reaction |= REACTION_POSITION;
        if (obstacle->turned) {
            turn_back(obstacle);
        }
    }
    return true;
}
