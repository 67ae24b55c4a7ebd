/* gamepad_imu_filter.c -- implements the tilt estimate: a complementary filter for the upward
 * direction. */
#include "drivers/gamepad/gamepad_imu_filter.h"

#define G_M_S2 9.81f
/* Time constant with which the accelerometer corrects the upward direction. The time constant is
 * ten times the period of shaking, and much shorter than the minutes in which a gyroscope
 * drifts. */
#define DOWN_TAU_S 0.5f
/* Time constant of the rest attitude, longer than the time for which a player aims at a fish. */
#define REST_TAU_S 4.0f
/* Angle around the rest attitude within which the tilt is 0, because a human hand trembles. */
#define REST_BAND_RAD (2.0f * F_DEG)
/* Limit of the rotation rate. Game pads measure at most 2,000 degrees/s (35 rad/s); larger values
 * are noise. */
#define RATE_MAX_RAD_S 40.0f
#define STEP_MAX_S 0.25f /* Longest time over which a measured rotation rate is extrapolated. */

static float seconds_between(uint64_t from_ns, uint64_t to_ns)
{
    return to_ns > from_ns ? (float)(to_ns - from_ns) * 1e-9f : 0.0f;
}

/* Rotates `up` to `time_ns`, opposite to the rotation of the pad, because the upward direction is
 * fixed in the world. */
static void turn_to(struct gamepad_imu_filter *tilt, uint64_t time_ns)
{
    const float dt_s = f_min(seconds_between(tilt->turn_ns, time_ns), STEP_MAX_S);
    if (tilt->turn_ns > 0 && tilt->knows_down) {
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
    const float dt_s = f_min(seconds_between(tilt->weigh_ns, time_ns), STEP_MAX_S);
    tilt->weigh_ns = time_ns > tilt->weigh_ns ? time_ns : tilt->weigh_ns;
    turn_to(tilt, time_ns);
    if (!(weight > 0.7f * G_M_S2 && weight < 1.3f * G_M_S2)) {
        return 0;
    }
    const vec3 up = v3_scale(up_m_s2, 1.0f / weight);
    const float share = tilt->knows_down ? dt_s / (dt_s + DOWN_TAU_S) : 1.0f;
    tilt->up = v3_normalize_or(v3_lerp(tilt->up, up, share), up);
    tilt->knows_down = 1;
    return 0;
}

static float pitch_of(vec3 up)
{
    return f_atan2(-up.z, f_sqrt(up.x * up.x + up.y * up.y));
}

static float roll_of(vec3 up)
{
    return f_atan2(-up.x, f_sqrt(up.y * up.y + up.z * up.z));
}

void gamepad_imu_filter_level(struct gamepad_imu_filter *tilt)
{
    tilt->knows_rest = tilt->knows_down;
    tilt->rest_pitch_rad = pitch_of(tilt->up);
    tilt->rest_roll_rad = roll_of(tilt->up);
}

static float beyond_band(float angle_rad)
{
    const float size = f_max(0.0f, f_abs(angle_rad) - REST_BAND_RAD);
    return f_clamp(angle_rad < 0.0f ? -size : size, -GAMEPAD_IMU_FILTER_MAX_RAD,
                   GAMEPAD_IMU_FILTER_MAX_RAD);
}

struct angles gamepad_imu_filter_at(struct gamepad_imu_filter *tilt, uint64_t time_ns, int hovers)
{
    turn_to(tilt, time_ns);
    if (!tilt->knows_down) {
        return (struct angles){ 0 };
    }
    if (!tilt->knows_rest) {
        gamepad_imu_filter_level(tilt);
        tilt->rest_ns = time_ns;
    }
    const float pitch_rad = pitch_of(tilt->up);
    const float roll_rad = roll_of(tilt->up);
    const float dt_s = f_min(seconds_between(tilt->rest_ns, time_ns), STEP_MAX_S);
    const float share = hovers ? dt_s / (dt_s + REST_TAU_S) : 0.0f;
    tilt->rest_pitch_rad = f_lerp(tilt->rest_pitch_rad, pitch_rad, share);
    tilt->rest_roll_rad = f_lerp(tilt->rest_roll_rad, roll_rad, share);
    tilt->rest_ns = time_ns > tilt->rest_ns ? time_ns : tilt->rest_ns;
    return (struct angles){
        .pitch_rad = beyond_band(pitch_rad - tilt->rest_pitch_rad),
        .roll_rad = beyond_band(roll_rad - tilt->rest_roll_rad),
    };
}
