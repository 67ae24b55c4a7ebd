/* output_devices.c -- plays sounds, sets output lines and dims the picture; see
 * output_devices.h. */
#include "platform/kiosk/output_devices.h"

#include "core/base/panic.h"

#define NS_PER_S 1000000000ull
#define RETRY_NS NS_PER_S /* Interval between two searches for a sound card. */

static void look_for_card(struct output_audio *voice, const struct hal_audio *audio,
                          uint64_t now_ns)
{
    voice->retry_ns = audio->ops->open(audio->self) == HAL_OK ? 0 : now_ns + RETRY_NS;
}

void output_audio_open(struct output_audio *voice, const struct hal_audio *audio, uint64_t now_ns)
{
    CORE_ASSERT(audio->ops);
    look_for_card(voice, audio, now_ns);
}

float output_audio_gain(const struct settings *settings)
{
    CORE_ASSERT(settings->value[SET_VOLUME] >= 0);
    const float share = 0.01f * (float)settings->value[SET_VOLUME];
    return share * share;
}

int output_audio_is_audible(const struct settings *settings, uint64_t attract_s)
{
    const uint64_t every = (uint64_t)settings->value[SET_ATTRACT_SOUND];
    return every > 0 && attract_s / OUTPUT_AUDIO_SHOW_S % every == 0;
}

static int is_silent(struct output_audio *voice, const struct settings *settings, int is_attract,
                     uint64_t now_ns)
{
    if (!is_attract) {
        voice->attract_ns = 0;
        return 0;
    }
    if (voice->attract_ns == 0) {
        voice->attract_ns = now_ns;
    }
    return !output_audio_is_audible(settings, (now_ns - voice->attract_ns) / NS_PER_S);
}

uint32_t output_audio_play(struct output_audio *voice, const struct hal_audio *audio,
                           const struct output *output, const struct settings *settings,
                           int is_attract, uint64_t now_ns)
{
    CORE_ASSERT(audio->ops);
    CORE_ASSERT(output->sound_count <= OUTPUT_SOUND_MAX);
    const float gain = output_audio_gain(settings);
    uint32_t faults = 0;
    if (voice->retry_ns > 0 && now_ns >= voice->retry_ns) {
        look_for_card(voice, audio, now_ns);
    }
    if (is_silent(voice, settings, is_attract, now_ns) || gain <= 0.0f) {
        return 0;
    }
    for (uint32_t i = 0; i < output->sound_count && voice->retry_ns == 0; i++) {
        struct sound_event event = output->sounds[i];
        event.gain *= gain;
        const int result = audio->ops->play(audio->self, &event);
        faults += (uint32_t)hal_is_fault(result);
        if (result == HAL_ERR_GONE) { /* The loss of the sound card counts as one fault. The
                                         remaining sounds of the frame are dropped. */
            voice->retry_ns = now_ns + RETRY_NS;
        }
    }
    return faults;
}

/* ---- Lamp, lockout, counter and tickets ---------------------------------------------------- */

/* Sends changed outputs to the driver. A request that a busy driver did not accept is sent again in
 * the next frame. A request that failed is sent again after one second. An output that the cabinet
 * does not have counts as set. */

/* Returns 1 if the driver accepted the request or has no such output, otherwise 0. After a fault,
 * delays the next attempt. */
static int is_settled(struct output_lines *switches, enum hal_switch which, int result,
                      uint64_t now_ns)
{
    CORE_ASSERT(which < HAL_SWITCH_COUNT);
    if (hal_is_fault(result)) {
        switches->retry_ns[which] = now_ns + RETRY_NS;
    }
    return result >= 0 || result == HAL_ERR_ABSENT;
}

static uint32_t output_lines_set(struct output_lines *switches, const struct hal_switches *device,
                                 enum hal_switch which, uint8_t active, uint64_t now_ns)
{
    CORE_ASSERT(active <= 1u);
    const uint32_t bit = 1u << which;
    if (!(switches->active & bit) == !active || now_ns < switches->retry_ns[which]) {
        return 0;
    }
    const int result = device->ops->set(device->self, which, active != 0);
    if (is_settled(switches, which, result, now_ns)) {
        switches->active ^= bit;
    }
    return (uint32_t)hal_is_fault(result);
}

/* Sends one pulse for each increase of `wanted` by 1 since the last accepted request. Returns 1 on
 * a fault, otherwise 0. */
static uint32_t send_new_pulses(struct output_lines *switches, const struct hal_switches *device,
                                enum hal_switch which, uint32_t wanted, uint64_t now_ns)
{
    const uint32_t count = wanted - switches->given[which];
    if (count == 0 || now_ns < switches->retry_ns[which]) {
        return 0;
    }
    const int result = device->ops->pulse(device->self, which, count);
    if (is_settled(switches, which, result, now_ns)) {
        switches->given[which] = wanted;
    }
    return (uint32_t)hal_is_fault(result);
}

uint32_t output_lines_put(struct output_lines *switches, const struct hal_switches *device,
                          const struct output *output, uint64_t now_ns)
{
    CORE_ASSERT(device->ops);
    return output_lines_set(switches, device, HAL_START_LAMP, output->start_lamp, now_ns) +
           output_lines_set(switches, device, HAL_COIN_LOCKOUT, output->coin_lockout, now_ns) +
           send_new_pulses(switches, device, HAL_COIN_COUNTER, output->coins_counted, now_ns) +
           send_new_pulses(switches, device, HAL_TICKET, output->tickets, now_ns);
}

uint32_t output_lines_are_done(const struct output_lines *switches,
                               const struct hal_switches *device, enum hal_switch which)
{
    CORE_ASSERT(which < HAL_SWITCH_COUNT);
    return switches->given[which] - device->ops->pending(device->self, which);
}

/* ---- Brightness and position of the picture ------------------------------------------------ */

#define NS_PER_MS 1000000ull
/* Duration of dimming in seconds. Dimming is slow so that players do not notice the change. */
#define FADE_DOWN_S 4.0f
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

/* ---- Detection of players ------------------------------------------------------------------ */

void output_dimmer_notice(struct output_dimmer *dimmer, const struct input *input, int is_attract)
{
    if (input->pressed != 0 || input_coin_pulses(input) > 0 || !is_attract) {
        dimmer->was_stirred = 1;
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

/* Returns the target brightness after `idle_s` seconds without input, as a fraction of the
 * brightness that the operator has set. */
static float light_wanted(const int32_t *value, const struct input *input, uint64_t idle_s)
{
    const uint64_t dim_s = 60u * (uint64_t)value[SET_DIM_AFTER_MIN];
    if (is_night(value, input) && idle_s >= DIMMER_NIGHT_IDLE_S) {
        return 0.0f;
    }
    return dim_s > 0 && idle_s >= dim_s ? 0.01f * (float)value[SET_DIM] : 1.0f;
}

/* ---- Position of the picture --------------------------------------------------------------- */

static float dimmer_shift_at(uint32_t ms, uint32_t period_ms)
{
    return DIMMER_SHIFT * f_sin(F_TAU * (float)(ms % period_ms) / (float)period_ms);
}

struct display_settings output_dimmer_step(struct output_dimmer *dimmer,
                                           const struct settings *settings,
                                           const struct input *input, int is_attract,
                                           uint64_t now_ns)
{
    CORE_ASSERT(dimmer->wander_ms < WANDER_MS);
    const int32_t *value = settings->value;
    const int is_first = dimmer->seen_ns == 0;
    const uint64_t since_ns = dimmer->seen_ns > 0 ? now_ns - dimmer->seen_ns : 0;
    const uint64_t elapsed = since_ns / NS_PER_MS;
    dimmer->seen_ns = dimmer->seen_ns > 0 ? dimmer->seen_ns + elapsed * NS_PER_MS : now_ns;
    const uint32_t ms = elapsed < STEP_MS_MAX ? (uint32_t)elapsed : STEP_MS_MAX;
    /* Detects pois that have moved. Positions are not validated because a non-finite position does
     * not count as a movement. */
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const vec3 at_m = input->poi[i].target.position_m;
        const float moved_m = v3_length(v3_sub(at_m, dimmer->hand_m[i]));
        const int is_hand = input->poi[i].link == POI_SOURCE_LIVE && f_is_finite(moved_m);
        if (is_hand && moved_m > DIMMER_STIR_M) {
            dimmer->hand_m[i] = at_m;
            dimmer->was_stirred = 1;
        }
    }
    if (is_first || dimmer->was_stirred) {
        dimmer->touched_ns = now_ns;
        dimmer->was_stirred = 0;
    }
    const uint64_t idle_s = (now_ns - dimmer->touched_ns) / NS_PER_S;
    const float share = 1e-3f * (float)ms, wanted = light_wanted(value, input, idle_s);
    dimmer->light =
        is_first ? wanted
                 : (dimmer->light > wanted ? f_max(dimmer->light - (share / FADE_DOWN_S), wanted)
                                           : f_min(dimmer->light + (share / FADE_UP_S), wanted));
    if (is_attract) { /* The picture is not moved during a game, because the players aim at objects
                         in the picture. */
        dimmer->wander_ms = (dimmer->wander_ms + ms) % WANDER_MS;
    }
    return (struct display_settings){
        .rotation = (uint32_t)value[SET_ROTATION],
        .inset_x = 1e-3f * (float)value[SET_OVERSCAN_X],
        .inset_y = 1e-3f * (float)value[SET_OVERSCAN_Y],
        .shift_x = dimmer_shift_at(dimmer->wander_ms, WANDER_X_MS),
        .shift_y = dimmer_shift_at(dimmer->wander_ms, WANDER_Y_MS),
        .light = dimmer->light * 0.01f * (float)value[SET_BRIGHTNESS],
    };
}
