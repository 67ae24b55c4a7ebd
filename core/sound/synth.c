/* synth.c -- implements the synthesiser. A voice plays one sound, which consists of sine waves,
 * filtered noise and at most one plucked string.
 *
 * A control step of a voice is CONTROL_FRAMES frames, counted from the start of its sound. The
 * pitch, the filter and the roughness change only between control steps. Therefore the output does
 * not depend on the number of frames per call. */
#include "core/sound/synth.h"

#include "core/base/fmath.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/sound/recipe.h"

/* Length of a control step in frames (0.67 ms). Changes of the pitch in such small steps are
 * inaudible. */
#define CONTROL_FRAMES 32u
#define FRAMES_PER_MS ((float)SYNTH_RATE_HZ / 1000.0f)
#define FULL_SCALE 32000.0f
/* Number of frames (10 ms) over which a voice fades out at its end, to avoid a click. */
#define FADE_FRAMES 480.0f

/* Returns white noise in [-1, 1) from a linear congruential generator. The high bits of the
 * generator are sufficiently random for the sounds of water and paper. */
static float noise_next(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (float)(int32_t)(*state >> 8) * (2.0f / 16777216.0f) - 1.0f;
}

static uint32_t frames_of(float ms)
{
    return (uint32_t)(int32_t)(ms * FRAMES_PER_MS);
}

/* ---- Layers (tones and noise) --------------------------------------------------------------- */

/* Returns the next sample of a layer. The layer must not be of the kind LAYER_NONE. */
static float layer_next(struct synth_layer *state, const struct layer_recipe *recipe,
                        uint32_t age_frames, uint32_t *noise)
{
    if (age_frames < state->delay_frames) {
        return 0.0f;
    }
    const float rise = (float)(age_frames - state->delay_frames) * state->attack_per_frame;
    CORE_ASSERT(rise >= 0.0f);
    if (rise >= 1.0f) {
        state->level *= state->decay;
    }
    const float gain = f_min(rise, 1.0f);
    if (recipe->kind == LAYER_TONE) {
        state->phase += state->hz / (float)SYNTH_RATE_HZ;
        state->phase -= f_floor(state->phase);
        return f_sin(F_TAU * state->phase) * state->level * gain;
    }
    state->low += state->cutoff * state->band;
    const float high = noise_next(noise) - state->low - recipe->damping * state->band;
    state->band += state->cutoff * high;
    return state->band * state->gate * state->level * gain;
}

/* ---- Plucked string ------------------------------------------------------------------------- */

/* Returns the next sample of a plucked string by the Karplus-Strong algorithm: a noise burst
 * circulates in a delay line and loses high frequencies in each pass. */
static float string_next(struct synth_voice *voice, const struct sound_recipe *recipe)
{
    if (voice->string_count == 0 || voice->age_frames < frames_of(recipe->string_delay_ms)) {
        return 0.0f;
    }
    const uint32_t at = voice->string_at;
    CORE_ASSERT(at < voice->string_count && voice->string_count <= SYNTH_PLUCK_MAX);
    const uint32_t next = at + 1u < voice->string_count ? at + 1u : 0u;
    const float wave = voice->string[at];
    voice->string[at] = recipe->string_keep * 0.5f * (wave + voice->string[next]);
    voice->string_at = next;
    return wave * recipe->string_gain;
}

/* Fills the delay line of the string with noise, smoothed to imitate a soft fingertip. The mean of
 * the noise is subtracted, because it would be audible as a thump when the sound ends. */
static void string_pluck(struct synth_voice *voice, float hz)
{
    CORE_ASSERT(hz > 0.0f);
    float mean = 0.0f;
    float smooth = 0.0f;
    /* string_next() averages two adjacent samples, which adds a delay of half a frame. To
     * compensate for this delay, the length of the delay line is rounded down. */
    voice->string_count = (uint32_t)(int32_t)((float)SYNTH_RATE_HZ / hz);
    CORE_ASSERT(voice->string_count <= SYNTH_PLUCK_MAX);
    for (uint32_t i = 0; i < voice->string_count; i++) {
        smooth += 0.5f * (noise_next(&voice->noise) - smooth);
        voice->string[i] = smooth;
        mean += smooth / (float)voice->string_count;
    }
    for (uint32_t i = 0; i < voice->string_count; i++) {
        voice->string[i] -= mean;
    }
}

/* ---- Rendering of voices -------------------------------------------------------------------- */

/* Begins a control step of a layer: advances the glide of the frequency, and computes the members
 * `decay`, `cutoff` and `gate`, which stay constant for CONTROL_FRAMES frames. */
static void layer_control(struct synth_layer *state, const struct layer_recipe *layer,
                          uint32_t *noise)
{
    if (layer->glide_ms > 0.0f) {
        const float glide_frames = layer->glide_ms * FRAMES_PER_MS;
        const float share = 1.0f - f_exp(-(float)CONTROL_FRAMES / glide_frames);
        state->hz += (layer->hz_to - state->hz) * share;
    }
    state->decay = f_exp(-1.0f / (layer->decay_ms * FRAMES_PER_MS));
    state->cutoff = 2.0f * f_sin(F_PI * state->hz / (float)SYNTH_RATE_HZ);
    state->gate = 1.0f - layer->roughness * f_abs(noise_next(noise));
}

/* Adds a part of a voice to `mix`. The part ends with the present control step, but has at most
 * `frame_count` frames. Returns the number of frames of the part, even if the sound ends
 * earlier. */
static uint32_t voice_step(struct synth_voice *voice, float *mix, uint32_t frame_count)
{
    CORE_ASSERT(voice->sound != SOUND_NONE && voice->sound < SOUND_COUNT);
    const struct sound_recipe *recipe = &sound_recipes[voice->sound];
    const uint32_t length = frames_of(recipe->length_ms);
    const uint32_t step = CONTROL_FRAMES - voice->age_frames % CONTROL_FRAMES;
    const uint32_t count = step < frame_count ? step : frame_count;
    uint32_t layer_count = 0; /* Counts the layers of the sound. The first layer of the kind
                                 LAYER_NONE ends the list. */
    while (layer_count < SYNTH_LAYER_MAX && recipe->layer[layer_count].kind != LAYER_NONE) {
        if (step == CONTROL_FRAMES) {
            layer_control(&voice->layer[layer_count], &recipe->layer[layer_count], &voice->noise);
        }
        layer_count++;
    }
    for (uint32_t i = 0; i < count; i++) {
        const float fade = f_min((float)(length - voice->age_frames) / FADE_FRAMES, 1.0f);
        float wave = string_next(voice, recipe);
        for (uint32_t k = 0; k < layer_count; k++) {
            wave +=
                layer_next(&voice->layer[k], &recipe->layer[k], voice->age_frames, &voice->noise);
        }
        mix[2u * i] += wave * fade * voice->left;
        mix[2u * i + 1u] += wave * fade * voice->right;
        voice->age_frames++;
        if (voice->age_frames >= length) {
            voice->sound = SOUND_NONE;
            break;
        }
    }
    return count;
}

/* ---- Interface of the synthesiser ----------------------------------------------------------- */

void synth_init(struct synth *synth)
{
    memset(synth, 0, sizeof *synth);
}

void synth_play(struct synth *synth, const struct sound_event *event)
{
    CORE_ASSERT(synth && event);
    if (event->sound == SOUND_NONE || event->sound >= SOUND_COUNT) {
        return;
    }
    const struct sound_recipe *recipe = &sound_recipes[event->sound];
    const float gain = f_clamp(event->gain, 0.0f, 1.0f);
    const float pan = f_clamp(event->pan, -1.0f, 1.0f);
    /* The loop selects a free voice, or the oldest voice if no voice is free. */
    struct synth_voice *voice = &synth->voice[0];
    for (uint32_t i = 0; i < SYNTH_VOICE_MAX && voice->sound != SOUND_NONE; i++) {
        struct synth_voice *other = &synth->voice[i];
        if (other->sound == SOUND_NONE || other->age_frames > voice->age_frames) {
            voice = other;
        }
    }
    *voice = (struct synth_voice){ .sound = event->sound, .noise = ++synth->played * 2654435761u };
    voice->left = gain * f_sqrt(0.5f * (1.0f - pan)); /* The sum of the squares of the left gain and
                                                         the right gain is the same for every pan,
                                                         so that the total power is constant. */
    voice->right = gain * f_sqrt(0.5f * (1.0f + pan));
    for (uint32_t i = 0; i < SYNTH_LAYER_MAX && recipe->layer[i].kind != LAYER_NONE; i++) {
        const struct layer_recipe *layer = &recipe->layer[i];
        CORE_ASSERT(layer->attack_ms > 0.0f && layer->decay_ms > 0.0f);
        voice->layer[i] = (struct synth_layer){
            .delay_frames = frames_of(layer->delay_ms),
            .attack_per_frame = 1.0f / (layer->attack_ms * FRAMES_PER_MS),
            .hz = layer->hz_from,
            .level = layer->gain,
        };
    }
    if (recipe->string_hz > 0.0f) {
        string_pluck(voice, recipe->string_hz);
    }
}

void synth_render(struct synth *synth, int16_t *stereo, uint32_t frame_count)
{
    CORE_ASSERT(synth && (stereo || frame_count == 0));
    while (frame_count > 0) {
        float mix[2u * CONTROL_FRAMES] = { 0 };
        const uint32_t block = frame_count < CONTROL_FRAMES ? frame_count : CONTROL_FRAMES;
        for (uint32_t v = 0; v < SYNTH_VOICE_MAX; v++) {
            uint32_t done = 0;
            while (done < block && synth->voice[v].sound != SOUND_NONE) {
                done += voice_step(&synth->voice[v], mix + 2u * done, block - done);
            }
        }
        for (uint32_t i = 0; i < 2u * block; i++) {
            /* Soft clipping is linear at low levels and becomes flat near full scale, so that many
             * simultaneous sounds fit the sample format. */
            const float c = f_clamp(mix[i], -3.0f, 3.0f);
            const float bent = c * (27.0f + c * c) / (27.0f + 9.0f * c * c);
            stereo[i] = (int16_t)(int32_t)(bent * FULL_SCALE);
        }
        stereo += 2u * block;
        frame_count -= block;
    }
}
