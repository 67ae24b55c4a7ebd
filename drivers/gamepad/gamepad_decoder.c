/* gamepad_decoder.c -- implements the game pad decoder, its filter of the motion sensors (a
 * complementary filter for the upward direction), and the queue of reports. */
#include "drivers/gamepad/gamepad_decoder.h"

#include <string.h>

#include "core/base/panic.h"

/* ---- Filter of the motion sensors ------------------------------------------------------------ */

#define G_M_S2 9.81f
/* Time constant with which the accelerometer corrects the upward direction. The time constant is
 * ten times the period of a shaking hand, and much shorter than the minutes in which a gyroscope
 * drifts. */
#define DOWN_TAU_S 0.5f
/* Time constant with which the rest attitude (the pad's attitude for which the ring is level)
 * follows the pad's current attitude. The time constant is longer than the time for which a player
 * aims at a fish. */
#define REST_TAU_S 4.0f
/* Maximum difference between the pad's attitude and its rest attitude for which the ring stays
 * level. The difference is not 0, because a human hand trembles. */
#define REST_BAND_RAD (2.0f * F_DEG)
/* Limit of the rotation rate. Game pads measure at most 2,000 degrees/s (35 rad/s). Larger values
 * are noise. */
#define RATE_MAX_RAD_S 40.0f
#define STEP_MAX_S 0.25f /* Longest time for which the newest rotation rate is integrated. */

/* Rotates `up` by the rotation of the pad from the last update until `time_ns`. In the axes of the
 * pad, the upward direction rotates opposite to the pad. */
static void turn_to(struct gamepad_imu_filter *tilt, uint64_t time_ns)
{
    CORE_ASSERT(v3_is_finite(tilt->rate_rad_s));
    const float dt_s = f_min(pointer_seconds_between(tilt->turn_ns, time_ns), STEP_MAX_S);
    if (tilt->turn_ns > 0 && tilt->has_up) {
        const vec3 turned = v3_muladd(tilt->up, v3_cross(tilt->up, tilt->rate_rad_s), dt_s);
        tilt->up = v3_normalize_or(turned, tilt->up);
    }
    tilt->turn_ns = time_ns > tilt->turn_ns ? time_ns : tilt->turn_ns;
}

int gamepad_imu_filter_add_rotation(struct gamepad_imu_filter *tilt, uint64_t time_ns,
                                    vec3 rate_rad_s)
{
    if (!v3_is_finite(rate_rad_s)) {
        return -1;
    }
    turn_to(tilt, time_ns);
    tilt->rate_rad_s = v3_limit(rate_rad_s, RATE_MAX_RAD_S);
    return 0;
}

/* Corrects `up` by the measured acceleration. The acceleration is ignored if its magnitude differs
 * from 1 g by more than 30 %, because of shaking or free fall. */
int gamepad_imu_filter_add_gravity(struct gamepad_imu_filter *tilt, uint64_t time_ns, vec3 up_m_s2)
{
    if (!v3_is_finite(up_m_s2)) {
        return -1;
    }
    const float weight = v3_length(up_m_s2);
    const float dt_s = f_min(pointer_seconds_between(tilt->weigh_ns, time_ns), STEP_MAX_S);
    tilt->weigh_ns = time_ns > tilt->weigh_ns ? time_ns : tilt->weigh_ns;
    turn_to(tilt, time_ns);
    if (!(weight > 0.7f * G_M_S2 && weight < 1.3f * G_M_S2)) {
        return 0;
    }
    const vec3 up = v3_scale(up_m_s2, 1.0f / weight);
    const float share = tilt->has_up ? dt_s / (dt_s + DOWN_TAU_S) : 1.0f;
    tilt->up = v3_normalize_or(v3_lerp(tilt->up, up, share), up);
    tilt->has_up = true;
    return 0;
}

/* Returns pitch and roll of a pad whose upward direction is `up`. */
static struct angles attitude_of(vec3 up)
{
    return (struct angles){
        .pitch_rad = f_atan2(-up.z, f_sqrt(up.x * up.x + up.y * up.y)),
        .roll_rad = f_atan2(-up.x, f_sqrt(up.y * up.y + up.z * up.z)),
    };
}

void gamepad_imu_filter_level(struct gamepad_imu_filter *tilt)
{
    CORE_ASSERT(v3_is_finite(tilt->up));
    tilt->has_rest = tilt->has_up;
    tilt->rest = attitude_of(tilt->up);
}

static float beyond_band(float angle_rad)
{
    CORE_ASSERT(f_is_finite(angle_rad));
    const float size = f_max(0.0f, f_abs(angle_rad) - REST_BAND_RAD);
    return f_clamp(angle_rad < 0.0f ? -size : size, -GAMEPAD_IMU_FILTER_MAX_RAD,
                   GAMEPAD_IMU_FILTER_MAX_RAD);
}

struct angles gamepad_imu_filter_at(struct gamepad_imu_filter *tilt, uint64_t time_ns, bool hovers)
{
    CORE_ASSERT(v3_is_finite(tilt->up));
    turn_to(tilt, time_ns);
    if (!tilt->has_up) {
        return (struct angles){ 0 };
    }
    if (!tilt->has_rest) {
        gamepad_imu_filter_level(tilt);
        tilt->rest_ns = time_ns;
    }
    const struct angles now = attitude_of(tilt->up);
    const float dt_s = f_min(pointer_seconds_between(tilt->rest_ns, time_ns), STEP_MAX_S);
    const float share = hovers ? dt_s / (dt_s + REST_TAU_S) : 0.0f;
    tilt->rest.pitch_rad = f_lerp(tilt->rest.pitch_rad, now.pitch_rad, share);
    tilt->rest.roll_rad = f_lerp(tilt->rest.roll_rad, now.roll_rad, share);
    tilt->rest_ns = time_ns > tilt->rest_ns ? time_ns : tilt->rest_ns;
    return (struct angles){
        .pitch_rad = beyond_band(now.pitch_rad - tilt->rest.pitch_rad),
        .roll_rad = beyond_band(now.roll_rad - tilt->rest.roll_rad),
    };
}

/* ---- Decoder --------------------------------------------------------------------------------- */

#define AXIS_FULL 32767.0f
#define STICK_TWIST (GAMEPAD_TILT_RAD / STICK_MOTION_TILT_MAX_RAD)

void gamepad_decoder_init(struct gamepad_decoder *decoder, const struct view *view)
{
    CORE_ASSERT(view);
    *decoder = (struct gamepad_decoder){ 0 };
    stick_motion_init(&decoder->fly, view);
}

/* ---- Sticks and motion sensors --------------------------------------------------------------- */

/* Returns the deflection of a stick beyond its dead zone as a vector. The vector has the direction
 * of the stick and a length of 0 to 1. */
static vec3 read_stick(int16_t x_raw, int16_t y_raw)
{
    const float dead = (float)GAMEPAD_DEAD / AXIS_FULL;
    const vec3 stick = v3((float)x_raw / AXIS_FULL, (float)y_raw / AXIS_FULL, 0.0f);
    const float length = v3_length(stick);
    const float way = f_clamp((length - dead) / (1.0f - dead), 0.0f, 1.0f);
    return v3_scale(stick, length > dead ? way / length : 0.0f);
}

/* ---- Pose ------------------------------------------------------------------------------------ */

/* Passes the deflection, the buttons, and the sum of the two tilts (from the right stick and from
 * the motion sensors) to stick_motion. */
static void move_sticks(struct gamepad_decoder *decoder)
{
    CORE_ASSERT(v3_is_finite(decoder->stick_twist));
    const uint32_t pad = decoder->now.buttons;
    const uint32_t buttons =
        (pad & GAMEPAD_SOUTH || decoder->trigger_down ? (uint32_t)POINTER_DIP : 0u) |
        (pad & (GAMEPAD_WEST | GAMEPAD_STICK_RIGHT) ? (uint32_t)POINTER_LEVEL : 0u) |
        (pad & GAMEPAD_SHOULDER_LEFT ? (uint32_t)POINTER_FAN : 0u);
    const struct angles wrist =
        gamepad_imu_filter_at(&decoder->tilt, decoder->time_ns, !(buttons & POINTER_DIP));
    const vec3 turned = v3(wrist.pitch_rad, 0.0f, wrist.roll_rad);
    const vec3 push =
        read_stick(decoder->now.axis[GAMEPAD_LEAD_X], decoder->now.axis[GAMEPAD_LEAD_Y]);
    const struct stick_report report = {
        .time_ns = decoder->time_ns,
        .push = v3(push.x, 0.0f, push.y),
        .twist = v3_muladd(decoder->stick_twist, turned, 1.0f / STICK_MOTION_TILT_MAX_RAD),
        .buttons = buttons,
    };
    stick_motion_report(&decoder->fly, &report);
}

void gamepad_decoder_report(struct gamepad_decoder *decoder, const struct gamepad_report *report)
{
    /* Cabinet button (enum input_button) of each button of a game pad. Most buttons of a game pad
     * act as OK in the menus. */
    static const uint32_t cabinet[][2] = {
        { GAMEPAD_START, INPUT_START },
        { GAMEPAD_LEFT, INPUT_LEFT },
        { GAMEPAD_RIGHT, INPUT_RIGHT },
        { GAMEPAD_BACK, INPUT_LANGUAGE },
        { GAMEPAD_UP, INPUT_UP },
        { GAMEPAD_DOWN, INPUT_DOWN },
        { GAMEPAD_UP | GAMEPAD_DOWN | GAMEPAD_EAST | GAMEPAD_NORTH | GAMEPAD_SHOULDER_RIGHT,
          INPUT_OK },
    };
    const uint32_t before = decoder->now.buttons;
    uint32_t held = 0;
    for (uint32_t i = 0; i < sizeof cabinet / sizeof cabinet[0]; i++) {
        held |= report->buttons & cabinet[i][0] ? cabinet[i][1] : 0u;
    }
    decoder->time_ns = report->time_ns > decoder->time_ns ? report->time_ns : decoder->time_ns;
    decoder->now = *report;
    const int16_t *axis = decoder->now.axis;
    const int16_t left = axis[GAMEPAD_TRIGGER_LEFT], right = axis[GAMEPAD_TRIGGER_RIGHT];
    const int16_t most = left > right ? left : right;
    decoder->trigger_down =
        most >= GAMEPAD_TRIGGER_ON || (decoder->trigger_down && most > GAMEPAD_TRIGGER_OFF);
    if (decoder->now.has_turn) {
        gamepad_imu_filter_add_rotation(&decoder->tilt, decoder->time_ns, decoder->now.turn_rad_s);
    }
    if (decoder->now.has_weight) {
        gamepad_imu_filter_add_gravity(&decoder->tilt, decoder->time_ns, decoder->now.weight_m_s2);
    }
    /* Pushing the right stick away from the player lifts the far edge of the ring, as the mouse
     * wheel does. Pushing the stick to the right lowers the right edge of the ring. */
    const vec3 twist = read_stick(axis[GAMEPAD_TILT_X], axis[GAMEPAD_TILT_Y]);
    decoder->stick_twist = v3(-twist.y * STICK_TWIST, 0.0f, twist.x * STICK_TWIST);
    if (report->buttons & ~before & (GAMEPAD_WEST | GAMEPAD_STICK_RIGHT)) {
        gamepad_imu_filter_level(&decoder->tilt);
    }
    decoder->pressed |= held & ~decoder->held;
    decoder->held = held;
    move_sticks(decoder);
}

struct poi_sample gamepad_decoder_sample(struct gamepad_decoder *decoder, uint64_t time_ns)
{
    decoder->time_ns = time_ns > decoder->time_ns ? time_ns : decoder->time_ns;
    move_sticks(decoder);
    return (struct poi_sample){
        .time_ns = decoder->time_ns,
        .target = stick_motion_target(&decoder->fly, decoder->time_ns),
    };
}

void gamepad_decoder_buttons(struct gamepad_decoder *decoder, struct button_sample *out)
{
    *out = (struct button_sample){ .held = decoder->held, .pressed = decoder->pressed };
    decoder->pressed = 0;
}

/* ---- Force feedback -------------------------------------------------------------------------- */

static uint16_t motor_magnitude(float level)
{
    return (uint16_t)(f_clamp(level, 0.0f, 1.0f) * 65535.0f + 0.5f);
}

/* Returns the levels of the two motors for the forces on the poi (the paper scoop). The slow motor
 * gets the square of the drag. Squaring weakens a small drag most, so that the player barely feels
 * the poi while the poi moves edge-on through the water. */
struct gamepad_rumble gamepad_decoder_rumble(const struct poi_force *force)
{
    return (struct gamepad_rumble){
        .slow = motor_magnitude(force->drag * force->drag),
        .fast = motor_magnitude(f_max(force->slap, force->tear)),
    };
}

/* ---- Queue of reports ------------------------------------------------------------------------ */

#define SAMPLE_NS 8333333ull /* Interval of the samples: one tick of the game, 1/120 s. */

void gamepad_queue_init(struct gamepad_queue *track, const struct view *view, uint64_t time_ns)
{
    *track = (struct gamepad_queue){ .sampled_ns = time_ns };
    gamepad_decoder_init(&track->decoder, view);
}

void gamepad_queue_push(struct gamepad_queue *track, const struct gamepad_report *report)
{
    CORE_ASSERT(track->report_count <= GAMEPAD_REPORTS_MAX);
    if (track->report_count == GAMEPAD_REPORTS_MAX) {
        gamepad_decoder_report(&track->decoder, &track->report[0]);
        memmove(&track->report[0], &track->report[1],
                sizeof track->report - sizeof track->report[0]);
        track->report_count--;
    }
    track->report[track->report_count++] = *report;
}

/* Writes at most `max` samples at intervals of `step_ns`, all before the time `until_ns`. Returns
 * the number of samples. */
static uint32_t sample_until(struct gamepad_queue *track, uint64_t until_ns, uint64_t step_ns,
                             struct poi_sample *out, uint32_t max)
{
    CORE_ASSERT(step_ns > 0);
    uint32_t count = 0;
    while (count < max && track->sampled_ns + step_ns < until_ns) {
        track->sampled_ns += step_ns;
        out[count++] = gamepad_decoder_sample(&track->decoder, track->sampled_ns);
    }
    return count;
}

uint32_t gamepad_queue_pop(struct gamepad_queue *track, uint64_t now_ns, struct poi_sample *out,
                           uint32_t max)
{
    CORE_ASSERT(track->report_count <= GAMEPAD_REPORTS_MAX);
    CORE_ASSERT(out || max == 0);
    if (max == 0) {
        return 0;
    }
    const uint64_t span_ns = now_ns > track->sampled_ns ? now_ns - track->sampled_ns : 0;
    /* If the caller was delayed, the interval between samples is larger, so that `max` samples
     * cover the whole time. */
    const uint64_t even_ns = span_ns / max + 1u;
    const uint64_t step_ns = even_ns > SAMPLE_NS ? even_ns : SAMPLE_NS;
    uint32_t count = 0;
    for (uint32_t i = 0; i < track->report_count; i++) {
        const struct gamepad_report *report = &track->report[i];
        count += sample_until(track, report->time_ns, step_ns, out + count, max - 1u - count);
        gamepad_decoder_report(&track->decoder, report);
    }
    track->report_count = 0;
    count += sample_until(track, now_ns, step_ns, out + count, max - 1u - count);
    track->sampled_ns = now_ns;
    out[count++] = gamepad_decoder_sample(&track->decoder, now_ns);
    return count;
}

void gamepad_queue_buttons(struct gamepad_queue *track, struct button_sample *out)
{
    CORE_ASSERT(track->report_count <= GAMEPAD_REPORTS_MAX);
    for (uint32_t i = 0; i < track->report_count; i++) {
        gamepad_decoder_report(&track->decoder, &track->report[i]);
    }
    track->report_count = 0;
    gamepad_decoder_buttons(&track->decoder, out);
}
