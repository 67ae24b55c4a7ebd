/* stick_motion.c -- integrates the velocity that a stick or a 3D mouse sets, so that the poi
 * moves. */
#include "drivers/gamepad/stick_motion.h"

#include "core/base/panic.h"
#include "drivers/pointer/pointer_poi.h"

/* Time constant that smooths the velocity. The ring then moves as smoothly as an arm would move the
 * ring, even if the thumb flicks the stick. */
#define PUSH_TAU_S 0.07f
/* Time constant that smooths the tilt. The value equals the time constant of the mouse wheel in
 * pointer_poi.c. */
#define TWIST_TAU_S 0.06f
/* Largest integration step. The step is so small that its size does not affect the motion. */
#define STEP_MAX_S 0.008f
/* Longest time between two calls over which the motion is integrated. During a longer pause the poi
 * does not move. */
#define GAP_MAX_S 1.0f

/* Largest distance of the poi from the middle of the image. The unit is half of the image's width
 * horizontally, and half of the image's height vertically. */
#define SEEN 0.94f

/* The LEVEL button returns the ring to the hover height. Within this distance from the hover
 * height, the ring slows down. */
#define LEVEL_FROM_M 0.03f

#define FAN_REST_M 0.35f /* Distance beyond the tank's near edge at which the idle fan rests. */

static float stick_motion_share_of(float value)
{
    return f_is_finite(value) ? f_clamp(value, -1.0f, 1.0f) : 0.0f;
}

static vec3 shares_of(vec3 v)
{
    return v3(stick_motion_share_of(v.x), stick_motion_share_of(v.y), stick_motion_share_of(v.z));
}

/* Limits a position to the visible part of the plane at its height. A higher ring appears farther
 * up in the image, so the limits depend on the height. */
static vec3 seen_m(const struct stick_motion *fly, vec3 at_m)
{
    CORE_ASSERT(f_is_finite(at_m.y));
    const float height = f_clamp(
        (at_m.y - STICK_MOTION_LOW_M) / (STICK_MOTION_HIGH_M - STICK_MOTION_LOW_M), 0.0f, 1.0f);
    const vec3 low = v3_lerp(fly->low_m[0], fly->low_m[1], height);
    const vec3 high = v3_lerp(fly->high_m[0], fly->high_m[1], height);
    return v3(f_clamp(at_m.x, low.x, high.x), f_clamp(at_m.y, low.y, high.y),
              f_clamp(at_m.z, low.z, high.z));
}

void stick_motion_set_view(struct stick_motion *fly, const struct view *view)
{
    CORE_ASSERT(view);
    static const float heights_m[2] = { STICK_MOTION_LOW_M, STICK_MOTION_HIGH_M };
    fly->view = *view;
    for (uint32_t i = 0; i < 2; i++) {
        const float aspect = view->aspect_min;
        const vec3 right = view_point_on_plane(view, aspect, SEEN, 0.0f, heights_m[i]);
        const vec3 far = view_point_on_plane(view, aspect, 0.0f, SEEN, heights_m[i]);
        const vec3 near = view_point_on_plane(view, aspect, 0.0f, -SEEN, heights_m[i]);
        fly->low_m[i] = v3(-f_abs(right.x), STICK_MOTION_LOW_M, f_min(far.z, near.z));
        fly->high_m[i] = v3(f_abs(right.x), STICK_MOTION_HIGH_M, f_max(far.z, near.z));
    }
    fly->place_m = seen_m(fly, fly->place_m);
}

void stick_motion_init(struct stick_motion *fly, const struct view *view)
{
    *fly = (struct stick_motion){ .place_m = { 0.0f, DIP_HOVER_M, 0.0f } };
    pointer_dip_init(&fly->dip);
    stick_motion_set_view(fly, view);
}

/* Applies a response curve with a cubic part to the deflection `push` and returns the result. The
 * curve makes small deflections more precise. */
static float eased(float push)
{
    CORE_ASSERT(push >= -1.0f && push <= 1.0f);
    return push * (0.35f + 0.65f * push * push);
}

static vec3 wanted_m_s(const struct stick_motion *fly, uint64_t time_ns)
{
    const vec3 push = fly->report.push;
    /* The ring's height over the still water is the flight height minus the depth of the dip. */
    const float height_m =
        fly->place_m.y - DIP_HOVER_M + pointer_dip_at(&fly->dip, time_ns).height_m;
    const float pace =
        f_lerp(STICK_MOTION_WATER_M_S, STICK_MOTION_AIR_M_S, f_smoothstep(0.0f, 0.025f, height_m));
    if (fly->report.buttons & POINTER_FAN) {
        return v3(0.0f, 0.0f, 0.0f);
    }
    const float climb = fly->report.buttons & POINTER_LEVEL
                            ? stick_motion_share_of((DIP_HOVER_M - fly->place_m.y) / LEVEL_FROM_M)
                            : eased(push.y);
    return v3(pace * eased(push.x), STICK_MOTION_HEIGHT_M_S * climb, pace * eased(push.z));
}

static void fly_step(struct stick_motion *fly, uint64_t time_ns, float dt_s)
{
    CORE_ASSERT(dt_s > 0.0f);
    CORE_ASSERT(dt_s <= STEP_MAX_S);
    const vec3 goal = wanted_m_s(fly, time_ns);
    fly->speed_m_s = v3_lerp(fly->speed_m_s, goal, 1.0f - f_exp(-dt_s / PUSH_TAU_S));
    const vec3 next = v3_muladd(fly->place_m, fly->speed_m_s, dt_s);
    fly->place_m = seen_m(fly, next);
    const vec3 twist = v3_scale(fly->report.twist, STICK_MOTION_TILT_MAX_RAD);
    fly->twist_rad = v3_lerp(fly->twist_rad, twist, 1.0f - f_exp(-dt_s / TWIST_TAU_S));
    const bool is_fan_held = (fly->report.buttons & POINTER_FAN) != 0;
    const float swing = dt_s / POINTER_FAN_SWING_S;
    if (is_fan_held) {
        const vec3 way = v3(eased(fly->report.push.x), 0.0f, eased(fly->report.push.z));
        fly->shade_m = seen_m(fly, v3_muladd(fly->shade_m, way, STICK_MOTION_AIR_M_S * dt_s));
    }
    fly->swing = f_clamp(fly->swing + (is_fan_held ? swing : -swing), 0.0f, 1.0f);
}

static void fly_to_time(struct stick_motion *fly, uint64_t time_ns)
{
    if (time_ns <= fly->time_ns) {
        return;
    }
    float left_s = (float)(time_ns - fly->time_ns) * 1e-9f;
    if (fly->time_ns == 0 || left_s > GAP_MAX_S) {
        left_s = 0.0f;
    }
    while (left_s > 0.0f) {
        const float dt_s = f_min(left_s, STEP_MAX_S);
        left_s -= dt_s;
        fly_step(fly, time_ns - (uint64_t)(left_s * 1e9f), dt_s);
    }
    fly->time_ns = time_ns;
}

void stick_motion_report(struct stick_motion *fly, const struct stick_report *report)
{
    CORE_ASSERT(fly->swing >= 0.0f && fly->swing <= 1.0f);
    fly_to_time(fly, report->time_ns);
    const uint32_t changed = fly->report.buttons ^ report->buttons;
    fly->report = *report;
    fly->report.push = shares_of(report->push);
    fly->report.twist = shares_of(report->twist);
    if (changed & POINTER_DIP) {
        pointer_dip_begin(&fly->dip, fly->time_ns, (report->buttons & POINTER_DIP) != 0);
    }
    if ((changed & report->buttons & POINTER_FAN) && fly->swing <= 0.0f) {
        fly->shade_m = fly->place_m;
    }
}

struct poi_target stick_motion_target(struct stick_motion *fly, uint64_t time_ns)
{
    CORE_ASSERT(v3_is_finite(fly->place_m));
    fly_to_time(fly, time_ns);
    const struct dip_state stroke = pointer_dip_at(&fly->dip, fly->time_ns);
    const vec3 along = v3(fly->speed_m_s.x, 0.0f, fly->speed_m_s.z);
    const vec3 lean = v3_limit(v3_scale(along, POINTER_LEAN_RAD_PER_M_S), POINTER_LEAN_MAX_RAD);
    const float slant = pointer_dip_slant_rad(stroke.speed_m_s);
    /* The ring moves away from the player along the line of sight as it sinks by `down_m`, as it
     * does below a pointer. The slanted ring then moves more edge-on through the water. */
    const vec3 sight = v3_sub(fly->view.target_m, fly->view.eye_m);
    const float slope = sight.y < -0.1f ? f_clamp(sight.z / sight.y, 0.0f, 1.5f) : 0.0f;
    const float down_m = DIP_HOVER_M - stroke.height_m;
    return (struct poi_target){
        .position_m = v3_add(fly->place_m, v3(0.0f, -down_m, stroke.near_m - slope * down_m)),
        .angles = { .yaw_rad = fly->twist_rad.y,
                    .pitch_rad = fly->twist_rad.x - slant - lean.z,
                    .roll_rad = fly->twist_rad.z - lean.x },
    };
}

struct shade_input stick_motion_fan(struct stick_motion *fly, uint64_t time_ns)
{
    fly_to_time(fly, time_ns);
    const vec3 rest_m = v3(fly->shade_m.x, 0.0f, fly->high_m[0].z + FAN_REST_M);
    return pointer_fan_between(fly->swing, rest_m, fly->shade_m);
}
