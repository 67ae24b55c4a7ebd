/* dimmer.c -- computes the brightness and the position of the picture; see dimmer.h. */
#include "platform/kiosk/dimmer.h"

#define NS_PER_S 1000000000ull
#define NS_PER_MS 1000000ull
#define FADE_DOWN_S 4.0f /* Duration of dimming in seconds, slow enough to be unnoticed. */
/* Duration of brightening in seconds. Brightening is fast because an arriving player needs
 * light. */
#define FADE_UP_S 0.3f
/* Maximum time step in milliseconds. Limits the change of brightness after a delayed frame. */
#define STEP_MS_MAX 100u

/* Periods of the horizontal and vertical movement in milliseconds. The numbers of minutes (37 and
 * 23) have no common divisor. Therefore the picture reaches every position in its range within a
 * day. The picture moves by one pixel every few minutes. */
#define WANDER_X_MS (37u * 60000u)
#define WANDER_Y_MS (23u * 60000u)
#define WANDER_MS (37u * WANDER_Y_MS)

static uint32_t elapsed_ms(struct dimmer *dimmer, uint64_t now_ns)
{
    const uint64_t since_ns = dimmer->seen_ns > 0 ? now_ns - dimmer->seen_ns : 0;
    const uint64_t ms = since_ns / NS_PER_MS;
    dimmer->seen_ns = dimmer->seen_ns > 0 ? dimmer->seen_ns + ms * NS_PER_MS : now_ns;
    return ms < STEP_MS_MAX ? (uint32_t)ms : STEP_MS_MAX;
}

/* ---- Detection of players ------------------------------------------------------------------ */

void dimmer_notice(struct dimmer *dimmer, const struct input *input, int is_attract)
{
    if (input->pressed != 0 || input_coin_pulses(input) > 0 || !is_attract) {
        dimmer->was_stirred = 1;
    }
}

/* Detects pois that have moved. Positions are not validated here. A non-finite position does not
 * count as a movement. */
static void watch_hands(struct dimmer *dimmer, const struct input *input)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const vec3 at_m = input->poi[i].target.position_m;
        const float moved_m = v3_length(v3_sub(at_m, dimmer->hand_m[i]));
        const int is_hand = input->poi[i].link == POI_SOURCE_LIVE && f_is_finite(moved_m);
        if (is_hand && moved_m > DIMMER_STIR_M) {
            dimmer->hand_m[i] = at_m;
            dimmer->was_stirred = 1;
        }
    }
}

/* ---- Brightness ---------------------------------------------------------------------------- */

static int is_night(const int32_t *value, const struct input *input)
{
    const int32_t from = value[SET_NIGHT_FROM_MIN], to = value[SET_NIGHT_TO_MIN];
    const int32_t minute = input->minute;
    if (input->day == 0 || from == to) {
        return 0;
    }
    return from < to ? minute >= from && minute < to : minute >= from || minute < to;
}

/* Returns the target brightness after `idle_s` seconds without input, as a share of the operator's
 * brightness. */
static float light_wanted(const int32_t *value, const struct input *input, uint64_t idle_s)
{
    const uint64_t dim_s = 60u * (uint64_t)value[SET_DIM_AFTER_MIN];
    if (is_night(value, input) && idle_s >= DIMMER_NIGHT_IDLE_S) {
        return 0.0f;
    }
    return dim_s > 0 && idle_s >= dim_s ? 0.01f * (float)value[SET_DIM] : 1.0f;
}

static float toward(float from, float to, float step_down, float step_up)
{
    return from > to ? f_max(from - step_down, to) : f_min(from + step_up, to);
}

/* ---- Position of the picture --------------------------------------------------------------- */

static float swing(uint32_t ms, uint32_t period_ms)
{
    return DIMMER_SHIFT * f_sin(F_TAU * (float)(ms % period_ms) / (float)period_ms);
}

struct display_settings dimmer_step(struct dimmer *dimmer, const struct settings *settings,
                                    const struct input *input, int is_attract, uint64_t now_ns)
{
    const int32_t *value = settings->value;
    const int is_first = dimmer->seen_ns == 0;
    const uint32_t ms = elapsed_ms(dimmer, now_ns);
    watch_hands(dimmer, input);
    if (is_first || dimmer->was_stirred) {
        dimmer->touched_ns = now_ns;
        dimmer->was_stirred = 0;
    }
    const uint64_t idle_s = (now_ns - dimmer->touched_ns) / NS_PER_S;
    const float share = 1e-3f * (float)ms, wanted = light_wanted(value, input, idle_s);
    dimmer->light =
        is_first ? wanted : toward(dimmer->light, wanted, share / FADE_DOWN_S, share / FADE_UP_S);
    if (is_attract) { /* The picture does not move during a game because players aim at it. */
        dimmer->wander_ms = (dimmer->wander_ms + ms) % WANDER_MS;
    }
    return (struct display_settings){
        .rotation = (uint32_t)value[SET_ROTATION],
        .inset_x = 1e-3f * (float)value[SET_OVERSCAN_X],
        .inset_y = 1e-3f * (float)value[SET_OVERSCAN_Y],
        .shift_x = swing(dimmer->wander_ms, WANDER_X_MS),
        .shift_y = swing(dimmer->wander_ms, WANDER_Y_MS),
        .light = dimmer->light * 0.01f * (float)value[SET_BRIGHTNESS],
    };
}
