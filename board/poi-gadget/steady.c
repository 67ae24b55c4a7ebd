/* steady.c -- the One Euro filter, which consists of two low-pass filters. The filtered speed
 * controls the corner frequency of the position filter. */
#include "board/poi-gadget/steady.h"

/* Returns the weight of the new value in one step of a first-order low-pass filter. */
static float steady_share_of(float corner_hz, float seconds)
{
    const float t = F_TAU * corner_hz * seconds;
    return t / (1.0f + t);
}

vec3 steady_step(struct steady *steady, vec3 raw_m, float seconds)
{
    if (!steady->begun) {
        *steady = (struct steady){ .begun = 1, .place_m = raw_m, .raw_m = raw_m };
        return raw_m;
    }
    const vec3 speed_m_s = v3_scale(v3_sub(raw_m, steady->raw_m), 1.0f / seconds);
    steady->raw_m = raw_m;
    steady->speed_m_s =
        v3_lerp(steady->speed_m_s, speed_m_s, steady_share_of(STEADY_SPEED_HZ, seconds));
    const float corner_hz = STEADY_REST_HZ + STEADY_HZ_PER_M_S * v3_length(steady->speed_m_s);
    steady->place_m = v3_lerp(steady->place_m, raw_m, steady_share_of(corner_hz, seconds));
    return steady->place_m;
}
