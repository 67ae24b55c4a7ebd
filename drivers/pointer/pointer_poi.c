/* pointer_poi.c -- turns the two axes and the buttons of a pointer into a pose of the poi, and
 * moves the fan over the water and back. A dip is a quintic polynomial between two heights. */
#include "drivers/pointer/pointer_poi.h"

#include "core/base/panic.h"

/* ---- Dips ------------------------------------------------------------------------------------ */

/* Initial acceleration of a downward stroke, so that the first frames after the click show motion.
 * The value is twice that of the smoothest stroke. The ring is still above the water during this
 * acceleration. An upward stroke starts under water and has no added acceleration. */
#define START_M_S2 (-16.0f)

void pointer_dip_init(struct dip *dip)
{
    *dip = (struct dip){ .from_m = DIP_HOVER_M, .to_m = DIP_HOVER_M };
}

/* Evaluates the quintic polynomial. The polynomial starts with the height, velocity and
 * acceleration in `dip`, and ends at rest at dip->to_m. */
struct dip_state pointer_dip_at(const struct dip *dip, uint64_t time_ns)
{
    CORE_ASSERT(dip->duration_s >= 0.0f);
    const float total = dip->duration_s;
    const float t = pointer_seconds_between(dip->start_ns, time_ns);
    if (t >= total) {
        return (struct dip_state){ .height_m = dip->to_m };
    }
    const float distance = dip->to_m - dip->from_m;
    const float v = dip->from_m_s * total;
    const float a = 0.5f * dip->from_m_s2 * total * total;
    const float c3 = 10.0f * distance - 6.0f * v - 3.0f * a;
    const float c4 = -15.0f * distance + 8.0f * v + 3.0f * a;
    const float c5 = 6.0f * distance - 3.0f * v - a;
    const float s = t / total;
    return (struct dip_state){
        .height_m = dip->from_m + s * (v + s * (a + s * (c3 + s * (c4 + s * c5)))),
        .speed_m_s =
            (v + s * (2.0f * a + s * (3.0f * c3 + s * (4.0f * c4 + s * 5.0f * c5)))) / total,
        .acceleration_m_s2 =
            (2.0f * a + s * (6.0f * c3 + s * (12.0f * c4 + s * 20.0f * c5))) / (total * total),
    };
}

void pointer_dip_begin(struct dip *dip, uint64_t time_ns, int down)
{
    const struct dip_state now = pointer_dip_at(dip, time_ns);
    dip->from_m = now.height_m;
    dip->from_m_s = now.speed_m_s;
    dip->from_m_s2 = down ? f_min(now.acceleration_m_s2, START_M_S2) : now.acceleration_m_s2;
    dip->to_m = down ? DIP_DEPTH_M : DIP_HOVER_M;
    dip->duration_s = down ? DIP_DOWN_S : DIP_UP_S;
    dip->start_ns = time_ns;
}

float pointer_dip_slant_rad(float speed_m_s)
{
    CORE_ASSERT(f_is_finite(speed_m_s));
    return DIP_SLANT_MAX_RAD * f_min(1.0f, f_abs(speed_m_s) / DIP_SLANT_AT_M_S);
}

/* ---- Poi ------------------------------------------------------------------------------------- */

/* Time constant that smooths the notches of the wheel. `tilt_rad` reaches `tilt_goal_rad` after
 * about three time constants. */
#define TILT_TAU_S 0.06f

/* Lean of the ring for each m/s of its speed, because an arm that moves fast cannot hold the ring
 * in its plane. The lean is below 3 degrees at 0.1 m/s. At 1 m/s the lean is LEAN_MAX_RAD, and the
 * water presses strongly against the leaning paper. */
#define LEAN_RAD_PER_M_S (28.0f * F_DEG)
#define LEAN_MAX_RAD (20.0f * F_DEG)
/* Time constant that smooths the velocity. Without smoothing, whole pixels at 60 Hz cause steps of
 * 0.04 m/s. */
#define LEAN_TAU_S 0.06f

/* Shortest duration of the poi's return to the pointer, slow enough not to damage the paper. */
#define BACK_S 0.30f
/* Additional duration of the poi's return to the pointer for each window width of distance. */
#define BACK_S_PER_WIDTH 0.9f
/* Height of the ring above which the poi's return to the pointer has its full speed. */
#define BACK_FREE_M 0.025f
/* Speed of the poi's return under water as a fraction of the full speed; faster motion would tear
 * the paper. */
#define BACK_UNDER_WATER 0.12f

static void move_to_time(struct pointer_poi *pointer, uint64_t time_ns)
{
    CORE_ASSERT(pointer->aspect > 0.0f);
    const float dt = pointer_seconds_between(pointer->time_ns, time_ns);
    const float left = f_exp(-f_min(dt / TILT_TAU_S, 50.0f));
    pointer->tilt_rad = f_lerp(pointer->tilt_goal_rad, pointer->tilt_rad, left);
    const float dry =
        f_smoothstep(0.0f, BACK_FREE_M, pointer_dip_at(&pointer->dip, time_ns).height_m);
    pointer->back_done_s += dt * f_lerp(BACK_UNDER_WATER, 1.0f, dry);
    if (time_ns > pointer->time_ns) {
        pointer->time_ns = time_ns;
    }
}

/* Estimates the velocity of the pointer's position on the still water. A dip does not change this
 * velocity. After more than one second without a call the velocity is 0. */
static void pointer_poi_update_speed(struct pointer_poi *pointer, vec3 hand_m)
{
    const float dt = pointer_seconds_between(pointer->hand_ns, pointer->time_ns);
    if (pointer->hand_ns == 0 || dt > 1.0f) {
        pointer->hand_m_s = v3(0.0f, 0.0f, 0.0f);
    } else if (dt > 0.0f) {
        const vec3 speed = v3_scale(v3_sub(hand_m, pointer->hand_m), 1.0f / dt);
        const vec3 along = v3(speed.x, 0.0f, speed.z);
        pointer->hand_m_s = v3_lerp(pointer->hand_m_s, along, dt / (dt + LEAN_TAU_S));
    } else {
        return; /* No time has passed after the previous call. Therefore no velocity can be
                   computed. */
    }
    pointer->hand_m = hand_m;
    pointer->hand_ns = pointer->time_ns;
}

void pointer_poi_init(struct pointer_poi *pointer, const struct view *view)
{
    CORE_ASSERT(view);
    *pointer = (struct pointer_poi){
        .view = *view,
        .aspect = 16.0f / 9.0f,
    };
    pointer_dip_init(&pointer->dip);
}

int pointer_report_is_usable(const struct pointer_report *report)
{
    return f_is_finite(report->x_px) && f_is_finite(report->y_px) &&
           f_is_finite(report->wheel_notches) && report->width_px > 0 && report->height_px > 0;
}

struct pointer_report pointer_report_on(const struct pointer_report *report,
                                        const struct display_settings *display_settings)
{
    struct pointer_report on = *report;
    if (pointer_report_is_usable(report)) {
        const struct display_transform transform = display_transform_of(
            display_settings, (float)report->width_px, (float)report->height_px);
        display_to_picture(&transform, &on.x_px, &on.y_px);
        on.width_px = (uint32_t)transform.width;
        on.height_px = (uint32_t)transform.height;
    }
    return on;
}

/* Returns the fraction of the poi's return to the pointer that is not completed yet: 1 at the start
 * and 0 at the end. The fraction decreases smoothly. */
static float lag_left(const struct pointer_poi *pointer)
{
    CORE_ASSERT(pointer->back_s >= 0.0f);
    CORE_ASSERT(pointer->back_done_s >= 0.0f);
    return pointer->back_s > 0.0f ? 1.0f - f_smoothstep(0.0f, pointer->back_s, pointer->back_done_s)
                                  : 0.0f;
}

int pointer_poi_report(struct pointer_poi *pointer, const struct pointer_report *report)
{
    if (!pointer_report_is_usable(report)) {
        return 0;
    }
    move_to_time(pointer, report->time_ns);
    const float width = (float)report->width_px;
    const float height = (float)report->height_px;
    pointer->aspect = width / height;
    const float x = f_clamp(2.0f * report->x_px / width - 1.0f, -1.0f, 1.0f);
    const float y = f_clamp(1.0f - 2.0f * report->y_px / height, -1.0f, 1.0f);
    const uint32_t changed = pointer->buttons ^ report->buttons;
    const float left = lag_left(pointer);
    const float at_x = pointer->ndc_x + left * pointer->lag_x;
    const float at_y = pointer->ndc_y + left * pointer->lag_y;
    if (changed & report->buttons & POINTER_FAN) {
        pointer->ndc_x = at_x; /* The poi stops at its current position. */
        pointer->ndc_y = at_y;
        pointer->back_s = 0.0f;
    } else if (changed & POINTER_FAN) {
        pointer->lag_x = at_x - x; /* The poi starts its return to the pointer at (x, y). */
        pointer->lag_y = at_y - y;
        pointer->back_done_s = 0.0f;
        const float lag = f_sqrt(pointer->lag_x * pointer->lag_x + pointer->lag_y * pointer->lag_y);
        pointer->back_s = BACK_S + BACK_S_PER_WIDTH * 0.5f * lag;
    }
    if (!(report->buttons & POINTER_FAN)) {
        pointer->ndc_x = x;
        pointer->ndc_y = y;
    }
    pointer->buttons = report->buttons;
    if (changed & POINTER_DIP) {
        pointer_dip_begin(&pointer->dip, pointer->time_ns, (report->buttons & POINTER_DIP) != 0);
    }
    const float turn = report->wheel_notches * POINTER_TILT_STEP_RAD;
    pointer->tilt_goal_rad =
        f_clamp(pointer->tilt_goal_rad + turn, -POINTER_TILT_MAX_RAD, POINTER_TILT_MAX_RAD);
    if (changed & report->buttons & POINTER_LEVEL) {
        pointer->tilt_goal_rad = 0.0f;
    }
    return 1;
}

struct poi_target pointer_poi_target(struct pointer_poi *pointer, uint64_t time_ns)
{
    CORE_ASSERT(f_abs(pointer->tilt_goal_rad) <= POINTER_TILT_MAX_RAD);
    move_to_time(pointer, time_ns);
    const struct dip_state stroke = pointer_dip_at(&pointer->dip, pointer->time_ns);
    const float slant = pointer_dip_slant_rad(stroke.speed_m_s);
    const float left = lag_left(pointer);
    const float x = pointer->ndc_x + left * pointer->lag_x;
    const float y = pointer->ndc_y + left * pointer->lag_y;
    const vec3 hand_m = view_point_on_plane(&pointer->view, pointer->aspect, x, y, stroke.height_m);
    pointer_poi_update_speed(pointer,
                             view_point_on_plane(&pointer->view, pointer->aspect, x, y, 0.0f));
    const vec3 lean = v3_limit(v3_scale(pointer->hand_m_s, LEAN_RAD_PER_M_S), LEAN_MAX_RAD);
    const float pitch_max_rad = POINTER_TILT_MAX_RAD + DIP_SLANT_MAX_RAD;
    return (struct poi_target){
        .position_m = hand_m,
        .angles.pitch_rad =
            f_clamp(pointer->tilt_rad - slant - lean.z, -pitch_max_rad, pitch_max_rad),
        .angles.roll_rad = -lean.x,
    };
}

/* ---- Fan ------------------------------------------------------------------------------------- */

/* Vertical position of the idle fan in normalized device coordinates: below the window's lower
 * edge, in front of the player. */
#define REST_NDC_Y (-2.2f)

void pointer_fan_init(struct pointer_fan *fan, const struct view *view)
{
    *fan = (struct pointer_fan){ .view = *view, .aspect = 16.0f / 9.0f };
}

static void swing_to_time(struct pointer_fan *fan, uint64_t time_ns)
{
    CORE_ASSERT(fan->swing >= 0.0f && fan->swing <= 1.0f);
    if (time_ns <= fan->time_ns) {
        return;
    }
    const float dt_s = fan->time_ns > 0 ? (float)(time_ns - fan->time_ns) * 1e-9f : 0.0f;
    const float step = dt_s / POINTER_FAN_SWING_S;
    fan->swing = f_clamp(fan->swing + (fan->held ? step : -step), 0.0f, 1.0f);
    fan->time_ns = time_ns;
}

int pointer_fan_report(struct pointer_fan *fan, const struct pointer_report *report)
{
    CORE_ASSERT(fan->swing >= 0.0f && fan->swing <= 1.0f);
    if (!pointer_report_is_usable(report)) {
        return 0;
    }
    swing_to_time(fan, report->time_ns);
    fan->held = (report->buttons & POINTER_FAN) != 0;
    if (fan->held) {
        const float width = (float)report->width_px;
        const float height = (float)report->height_px;
        fan->aspect = width / height;
        fan->ndc_x = f_clamp(2.0f * report->x_px / width - 1.0f, -1.0f, 1.0f);
        fan->ndc_y = f_clamp(1.0f - 2.0f * report->y_px / height, -1.0f, 1.0f);
    }
    return 1;
}

struct shade_input pointer_fan_shade(struct pointer_fan *fan, uint64_t time_ns)
{
    CORE_ASSERT(fan->aspect > 0.0f);
    swing_to_time(fan, time_ns);
    const float share = f_smoothstep(0.0f, 1.0f, fan->swing);
    const vec3 there_m = view_point_on_plane(&fan->view, fan->aspect, fan->ndc_x, fan->ndc_y, 0.0f);
    const vec3 rest_m =
        view_point_on_plane(&fan->view, fan->aspect, 0.6f * fan->ndc_x, REST_NDC_Y, 0.0f);
    const vec3 at_m = v3_lerp(rest_m, there_m, share);
    return (struct shade_input){
        .present = fan->swing > 0.0f,
        .x_m = at_m.x,
        .z_m = at_m.z,
        .radius_m = POINTER_FAN_RADIUS_M,
    };
}
