/* pointer_poi.c -- turns the two axes and the buttons of a pointer into a pose of the poi, and
 * moves the fan over the water and back. Each stroke of a dip is a quintic polynomial between two
 * heights. */
#include "drivers/pointer/pointer_poi.h"

#include "core/base/panic.h"

/* ---- Dips ------------------------------------------------------------------------------------ */

/* Initial acceleration of a downward stroke from the hover height, so that the first frames after
 * the click show motion. The value is about twice that of the stroke with the least jerk (2.8
 * m/s^2). A stroke that starts lower has a smaller initial acceleration. A stroke that starts under
 * water has none, because the acceleration would press the paper against the water. */
#define START_M_S2 (-6.0f)

void pointer_dip_init(struct dip *dip)
{
    *dip = (struct dip){ .from_m = DIP_HOVER_M, .to_m = DIP_HOVER_M, .scoops = true };
}

/* Returns a height as a fraction of the hover height, [0, 1]. The value is 0 under water. */
static float hover_share(float height_m)
{
    CORE_ASSERT(f_is_finite(height_m));
    return f_clamp(height_m / DIP_HOVER_M, 0.0f, 1.0f);
}

static bool goes_down(const struct dip *dip)
{
    return dip->to_m < DIP_HOVER_M;
}

static uint64_t stroke_end_ns(const struct dip *dip)
{
    return dip->start_ns + (uint64_t)(dip->duration_s * 1e9f);
}

/* Returns the stroke at `time_ns`: the current stroke, or the upward stroke that follows the
 * current stroke because the button was released. */
static struct dip stroke_at(const struct dip *dip, uint64_t time_ns)
{
    if (!dip->lifts || time_ns < stroke_end_ns(dip)) {
        return *dip;
    }
    return (struct dip){
        .start_ns = stroke_end_ns(dip),
        .duration_s = DIP_UP_S,
        .from_m = dip->to_m,
        .to_m = DIP_HOVER_M,
        .scoops = dip->scoops,
    };
}

/* Returns how much nearer to the player the ring is than the pointer, in metres, at the fraction
 * `s` of the stroke. The distance and its rate of change are 0 at both ends of the stroke. */
static float near_m(const struct dip *dip, float s)
{
    CORE_ASSERT(s >= 0.0f && s <= 1.0f);
    return dip->near_max_m * (s < DIP_NEAR_AT ? f_smoothstep(0.0f, DIP_NEAR_AT, s)
                                              : 1.0f - f_smoothstep(DIP_NEAR_AT, 1.0f, s));
}

/* Returns the ring's height and velocity at `time_ns` from a quintic polynomial. The polynomial
 * starts with the height, velocity and acceleration that `dip` stores, and ends at rest at the
 * height `to_m`. */
struct dip_state pointer_dip_at(const struct dip *dip, uint64_t time_ns)
{
    const struct dip stroke = stroke_at(dip, time_ns);
    CORE_ASSERT(stroke.duration_s >= 0.0f);
    const float total = stroke.duration_s;
    const float t = pointer_seconds_between(stroke.start_ns, time_ns);
    if (t >= total) {
        return (struct dip_state){ .height_m = stroke.to_m };
    }
    const float distance = stroke.to_m - stroke.from_m;
    const float v = stroke.from_m_s * total;
    const float a = 0.5f * stroke.from_m_s2 * total * total;
    const float c3 = 10.0f * distance - 6.0f * v - 3.0f * a;
    const float c4 = -15.0f * distance + 8.0f * v + 3.0f * a;
    const float c5 = 6.0f * distance - 3.0f * v - a;
    const float s = t / total;
    return (struct dip_state){
        .height_m = stroke.from_m + s * (v + s * (a + s * (c3 + s * (c4 + s * c5)))),
        .speed_m_s =
            (v + s * (2.0f * a + s * (3.0f * c3 + s * (4.0f * c4 + s * 5.0f * c5)))) / total,
        .acceleration_m_s2 =
            (2.0f * a + s * (6.0f * c3 + s * (12.0f * c4 + s * 20.0f * c5))) / (total * total),
        .near_m = near_m(&stroke, s),
    };
}

void pointer_dip_begin(struct dip *dip, uint64_t time_ns, bool down)
{
    *dip = stroke_at(dip, time_ns);
    if (goes_down(dip) && (down || time_ns < stroke_end_ns(dip))) {
        dip->lifts = !down;
        return;
    }
    const struct dip_state now = pointer_dip_at(dip, time_ns);
    const float start_m_s2 = START_M_S2 * hover_share(now.height_m);
    *dip = (struct dip){
        .start_ns = time_ns,
        .duration_s = down ? DIP_DOWN_S : DIP_UP_S,
        .from_m = now.height_m,
        .from_m_s = now.speed_m_s,
        .from_m_s2 = down ? f_min(now.acceleration_m_s2, start_m_s2) : now.acceleration_m_s2,
        .to_m = down ? DIP_DEPTH_M : DIP_HOVER_M,
        .scoops = dip->scoops,
        .near_max_m = down && dip->scoops ? DIP_NEAR_M * hover_share(now.height_m) : 0.0f,
    };
}

float pointer_dip_slant_rad(float speed_m_s)
{
    CORE_ASSERT(f_is_finite(speed_m_s));
    return speed_m_s < 0.0f ? DIP_SLANT_DOWN_RAD * f_min(1.0f, -speed_m_s / DIP_SLANT_DOWN_M_S)
                            : DIP_SLANT_UP_RAD * f_min(1.0f, speed_m_s / DIP_SLANT_UP_M_S);
}

/* ---- Aid ------------------------------------------------------------------------------------- */

void pointer_aid_apply(struct pointer_aid *aid, bool scoops, struct pointer_report *report)
{
    CORE_ASSERT(aid->reach_percent == 0 ||
                (aid->reach_percent >= POINTER_REACH_MIN_PERCENT && aid->reach_percent <= 100u));
    const bool is_pressed = (report->buttons & POINTER_DIP) != 0;
    const bool begins = is_pressed && !aid->is_pressed;
    aid->is_down = aid->clicks && scoops ? aid->is_down != begins : is_pressed;
    aid->is_pressed = is_pressed;
    report->buttons &= ~(uint32_t)POINTER_DIP;
    report->buttons |= aid->is_down ? (uint32_t)POINTER_DIP : 0u;
    if (aid->reach_percent != 0) {
        const float height = (float)report->height_px;
        const float up = height - report->y_px;
        report->y_px = height - up * 100.0f / (float)aid->reach_percent;
    }
}

void pointer_aid_raise(struct pointer_aid *aid)
{
    aid->is_down = false;
}

/* ---- Poi ------------------------------------------------------------------------------------- */

/* Time constant that smooths the notches of the wheel. `tilt_rad` reaches `tilt_goal_rad` after
 * about three time constants. */
#define TILT_TAU_S 0.06f

/* Time constant that smooths the velocity. Without smoothing, whole pixels at 60 Hz cause steps of
 * 0.04 m/s. */
#define LEAN_TAU_S 0.06f

/* Shortest duration of the poi's return to the pointer, slow enough not to damage the paper. */
#define BACK_S 0.30f
/* Additional duration of the poi's return to the pointer for each window width of distance. */
#define BACK_S_PER_WIDTH 0.9f
/* Height of the ring above which the poi's return to the pointer has its full speed. */
#define BACK_FREE_M 0.025f
/* Speed of the poi's return under water as a fraction of the full speed. Faster motion would tear
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

/* Estimates the velocity of the pointer's position `water_m` on the still water. A dip does not
 * change this velocity. After more than one second without a call the velocity is 0. */
static void update_speed(struct pointer_poi *pointer, vec3 water_m)
{
    const float dt = pointer_seconds_between(pointer->water_ns, pointer->time_ns);
    if (pointer->water_ns == 0 || dt > 1.0f) {
        pointer->water_m_s = v3(0.0f, 0.0f, 0.0f);
    } else if (dt > 0.0f) {
        const vec3 speed = v3_scale(v3_sub(water_m, pointer->water_m), 1.0f / dt);
        const vec3 along = v3(speed.x, 0.0f, speed.z);
        pointer->water_m_s = v3_lerp(pointer->water_m_s, along, dt / (dt + LEAN_TAU_S));
    } else {
        return; /* No time has passed after the previous call. Therefore no velocity can be
                   computed. */
    }
    pointer->water_m = water_m;
    pointer->water_ns = pointer->time_ns;
}

void pointer_poi_init(struct pointer_poi *pointer, const struct view *view)
{
    CORE_ASSERT(view);
    *pointer = (struct pointer_poi){
        .view = *view,
        .aspect = 16.0f / 9.0f,
        .fan_aspect = 16.0f / 9.0f,
    };
    pointer_dip_init(&pointer->dip);
}

/* Returns true if all numbers of the report are finite and the window has a size. */
static bool is_usable(const struct pointer_report *report)
{
    return f_is_finite(report->x_px) && f_is_finite(report->y_px) &&
           f_is_finite(report->wheel_notches) && report->width_px > 0 && report->height_px > 0;
}

struct pointer_report pointer_report_on(const struct pointer_report *report,
                                        const struct display_settings *display_settings)
{
    struct pointer_report on = *report;
    if (is_usable(report)) {
        const struct display_transform transform = display_transform_of(
            display_settings, (float)report->width_px, (float)report->height_px);
        display_to_picture(&transform, &on.x_px, &on.y_px);
        on.width_px = (uint32_t)transform.width;
        on.height_px = (uint32_t)transform.height;
    }
    return on;
}

/* Converts the pointer's position to normalized coordinates: `x` is -1 at the left edge of the
 * window and 1 at the right edge, `y` is -1 at the bottom and 1 at the top. */
static void window_position(const struct pointer_report *report, float *x, float *y)
{
    CORE_ASSERT(report->width_px > 0 && report->height_px > 0);
    *x = f_clamp(2.0f * report->x_px / (float)report->width_px - 1.0f, -1.0f, 1.0f);
    *y = f_clamp(1.0f - 2.0f * report->y_px / (float)report->height_px, -1.0f, 1.0f);
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

/* Gives the pointer's position (`x`, `y`) to the fan if the FAN key is pressed, otherwise to the
 * poi. */
static void lead(struct pointer_poi *pointer, const struct pointer_report *report, float x, float y)
{
    pointer_fan_swing(&pointer->fan_swing, report->time_ns);
    pointer->fan_swing.held = (report->buttons & POINTER_FAN) != 0;
    if (pointer->fan_swing.held) {
        pointer->fan_ndc_x = x;
        pointer->fan_ndc_y = y;
        pointer->fan_aspect = pointer->aspect;
    } else {
        pointer->ndc_x = x;
        pointer->ndc_y = y;
    }
}

bool pointer_poi_report(struct pointer_poi *pointer, const struct pointer_report *report)
{
    if (!is_usable(report)) {
        return false;
    }
    move_to_time(pointer, report->time_ns);
    pointer->aspect = (float)report->width_px / (float)report->height_px;
    float x, y;
    window_position(report, &x, &y);
    const uint32_t changed = pointer->buttons ^ report->buttons;
    const float left = lag_left(pointer);
    const float at_x = pointer->ndc_x + left * pointer->lag_x;
    const float at_y = pointer->ndc_y + left * pointer->lag_y;
    if (changed & report->buttons & POINTER_FAN) {
        /* The player has just pressed FAN. The poi stops at its current position. */
        pointer->ndc_x = at_x;
        pointer->ndc_y = at_y;
        pointer->back_s = 0.0f;
    } else if (changed & POINTER_FAN) {
        /* The player has just released FAN. The poi starts to return from its position to the
         * pointer. */
        pointer->lag_x = at_x - x;
        pointer->lag_y = at_y - y;
        pointer->back_done_s = 0.0f;
        const float lag = f_sqrt(pointer->lag_x * pointer->lag_x + pointer->lag_y * pointer->lag_y);
        pointer->back_s = BACK_S + BACK_S_PER_WIDTH * 0.5f * lag;
    }
    lead(pointer, report, x, y);
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
    return true;
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
    update_speed(pointer, view_point_on_plane(&pointer->view, pointer->aspect, x, y, 0.0f));
    vec3 position_m = view_point_on_plane(&pointer->view, pointer->aspect, x, y, stroke.height_m);
    position_m.z += stroke.near_m;
    const vec3 lean =
        v3_limit(v3_scale(pointer->water_m_s, POINTER_LEAN_RAD_PER_M_S), POINTER_LEAN_MAX_RAD);
    const float pitch_max_rad = POINTER_TILT_MAX_RAD + DIP_SLANT_DOWN_RAD;
    return (struct poi_target){
        .position_m = position_m,
        .angles.pitch_rad =
            f_clamp(pointer->tilt_rad - slant - lean.z, -pitch_max_rad, pitch_max_rad),
        .angles.roll_rad = -lean.x,
    };
}

/* ---- Fan ------------------------------------------------------------------------------------- */

/* Vertical position of the idle fan in normalized device coordinates: below the window's lower
 * edge, in front of the player. */
#define REST_NDC_Y (-2.2f)

float pointer_fan_swing(struct fan_swing *swing, uint64_t time_ns)
{
    CORE_ASSERT(swing->share >= 0.0f && swing->share <= 1.0f);
    const float dt_s = swing->time_ns > 0 ? pointer_seconds_between(swing->time_ns, time_ns) : 0.0f;
    const float step = dt_s / POINTER_FAN_SWING_S;
    swing->share = f_clamp(swing->share + (swing->held ? step : -step), 0.0f, 1.0f);
    swing->time_ns = time_ns > swing->time_ns ? time_ns : swing->time_ns;
    return dt_s;
}

struct shade_input pointer_fan_between(float share, vec3 rest_m, vec3 there_m)
{
    CORE_ASSERT(share >= 0.0f && share <= 1.0f);
    const vec3 at_m = v3_lerp(rest_m, there_m, f_smoothstep(0.0f, 1.0f, share));
    return (struct shade_input){
        .present = share > 0.0f,
        .x_m = at_m.x,
        .z_m = at_m.z,
        .radius_m = POINTER_FAN_RADIUS_M,
    };
}

struct shade_input pointer_fan_shade(struct pointer_poi *pointer, uint64_t time_ns)
{
    const float x = pointer->fan_ndc_x, y = pointer->fan_ndc_y, aspect = pointer->fan_aspect;
    CORE_ASSERT(aspect > 0.0f);
    pointer_fan_swing(&pointer->fan_swing, time_ns);
    return pointer_fan_between(
        pointer->fan_swing.share,
        view_point_on_plane(&pointer->view, aspect, 0.6f * x, REST_NDC_Y, 0.0f),
        view_point_on_plane(&pointer->view, aspect, x, y, 0.0f));
}
