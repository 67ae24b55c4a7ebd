/* synth.c -- implements the synthesiser of the effects; see synth.h. A voice plays one sound, which
 * consists of sine waves, filtered noise and at most one plucked string. */
#include "core/sound/synth.h"

#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/sound/recipe.h"

#define BLOCKS_PER_MS (SOUND_BLOCKS_PER_S / 1000.0f)
/* Number of blocks (10 ms) over which a voice fades out at its end, to avoid a click. */
#define FADE_BLOCKS 15u
/* Level below which a layer is skipped. */
#define SILENT 1e-5f
#define CALL_LEVEL 0.5f /* Level of a call beside the layers of its sound. */
/* Factor on the pitch of a sound that varies, for the weakest sound. A strong splash is deeper than
 * a weak splash. */
#define WEAK_SHARP 1.12f
#define STRONG_SHARP 0.94f

static uint32_t blocks_of(float ms)
{
    return (uint32_t)(int32_t)(ms * BLOCKS_PER_MS + 0.5f);
}

/* ---- Layers (tones and noise) --------------------------------------------------------------- */

/* Starts a layer. `sharp` is a factor on its frequencies. */
static void layer_start(struct synth_layer *state, const struct layer_recipe *recipe, float sharp)
{
    CORE_ASSERT(recipe->attack_ms > 0.0f && recipe->decay_ms > 0.0f);
    *state = (struct synth_layer){
        .delay_blocks = blocks_of(recipe->delay_ms),
        .attack_per_frame = 1000.0f / (recipe->attack_ms * (float)SOUND_RATE_HZ),
        .hz = sharp * recipe->hz_from,
        .hz_to = sharp * recipe->hz_to,
        .glide = recipe->glide_ms > 0.0f ? tone_share(recipe->glide_ms) : 0.0f,
        .level = recipe->gain,
        .keep = tone_keep(recipe->decay_ms),
        .wave = { 1.0f, 0.0f },
    };
    state->turn = tone_turn(state->hz, 1.0f);
    tone_filter_tune(&state->filter, state->hz, recipe->damping);
}

/* Advances the frequency of a layer by one block. Returns the random level of a rough noise. */
static float layer_control(struct synth_layer *state, const struct layer_recipe *recipe,
                           uint32_t *noise)
{
    if (state->glide > 0.0f) {
        state->hz += (state->hz_to - state->hz) * state->glide;
        state->turn = tone_turn(state->hz, 1.0f);
        tone_filter_tune(&state->filter, state->hz, recipe->damping);
    }
    state->wave = tone_unit(state->wave);
    return recipe->roughness > 0.0f ? 1.0f - recipe->roughness * f_abs(tone_noise(noise)) : 1.0f;
}

/* Adds a block of a layer to `wave`. */
static void layer_render(struct synth_layer *state, const struct layer_recipe *recipe,
                         uint32_t *noise, float wave[SOUND_BLOCK])
{
    if (state->delay_blocks > 0) {
        state->delay_blocks--;
        return;
    }
    if (state->level < SILENT) {
        return;
    }
    const float gate = layer_control(state, recipe, noise);
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        state->level *= state->rise >= 1.0f ? state->keep : 1.0f;
        const float gain = gate * state->level * state->rise;
        state->rise = f_min(state->rise + state->attack_per_frame, 1.0f);
        if (recipe->kind == LAYER_TONE) {
            state->wave = tone_next(state->wave, state->turn);
            wave[i] += state->wave.y * gain;
        } else {
            wave[i] += tone_filter_band(&state->filter, tone_noise(noise)) * gain;
        }
    }
}

/* ---- Plucked string ------------------------------------------------------------------------- */

/* Adds a block of a plucked string by the Karplus-Strong algorithm: a noise burst circulates in a
 * delay line and loses high frequencies in each pass. */
static void string_render(struct synth_voice *voice, const struct sound_recipe *recipe,
                          float wave[SOUND_BLOCK])
{
    if (voice->string_count == 0) {
        return;
    }
    if (voice->string_delay_blocks > 0) {
        voice->string_delay_blocks--;
        return;
    }
    CORE_ASSERT(voice->string_count <= SYNTH_PLUCK_MAX);
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        const uint32_t at = voice->string_at;
        const uint32_t next = at + 1u < voice->string_count ? at + 1u : 0u;
        const float old = voice->string[at];
        voice->string[at] = recipe->string_keep * 0.5f * (old + voice->string[next]);
        voice->string_at = next;
        wave[i] += old * recipe->string_gain;
    }
}

/* Fills the delay line of the string with noise, smoothed to imitate a soft fingertip. The mean of
 * the noise is subtracted, because it would be audible as a thump when the sound ends. */
static void string_pluck(struct synth_voice *voice, const struct sound_recipe *recipe)
{
    CORE_ASSERT(recipe->string_hz > 0.0f);
    float mean = 0.0f;
    float smooth = 0.0f;
    /* The string averages two adjacent samples, which adds a delay of half a frame. To compensate
     * for this delay, the length of the delay line is rounded down. */
    voice->string_count = (uint32_t)(int32_t)((float)SOUND_RATE_HZ / recipe->string_hz);
    voice->string_delay_blocks = blocks_of(recipe->string_delay_ms);
    CORE_ASSERT(voice->string_count <= SYNTH_PLUCK_MAX);
    for (uint32_t i = 0; i < voice->string_count; i++) {
        smooth += 0.5f * (tone_noise(&voice->noise) - smooth);
        voice->string[i] = smooth;
        mean += smooth / (float)voice->string_count;
    }
    for (uint32_t i = 0; i < voice->string_count; i++) {
        voice->string[i] -= mean;
    }
}

/* ---- Voices and calls ----------------------------------------------------------------------- */

static void add(float *mix, const float wave[SOUND_BLOCK], float left, float right)
{
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        mix[2u * i] += wave[i] * left;
        mix[2u * i + 1u] += wave[i] * right;
    }
}

static void voice_render(struct synth_voice *voice, float *mix)
{
    CORE_ASSERT(voice->sound < SOUND_COUNT && voice->age_blocks < voice->length_blocks);
    const struct sound_recipe *recipe = &sound_recipes[voice->sound];
    const uint32_t left_blocks = voice->length_blocks - voice->age_blocks;
    float wave[SOUND_BLOCK] = { 0 };
    string_render(voice, recipe, wave);
    for (uint32_t k = 0; k < SYNTH_LAYER_MAX && recipe->layer[k].kind != LAYER_NONE; k++) {
        layer_render(&voice->layer[k], &recipe->layer[k], &voice->noise, wave);
    }
    if (left_blocks <= FADE_BLOCKS) {
        const float step = 1.0f / (float)(FADE_BLOCKS * SOUND_BLOCK);
        for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
            wave[i] *= step * (float)(left_blocks * SOUND_BLOCK - i);
        }
    }
    add(mix, wave, voice->left, voice->right);
    voice->age_blocks++;
    if (left_blocks == 1u) {
        voice->sound = SOUND_NONE;
    }
}

static void call_render(struct synth_call *call, float *mix)
{
    float wave[SOUND_BLOCK] = { 0 };
    const struct vocal_phone *phone = vocal_phone_at(call->call, call->age_blocks++);
    if (!phone) {
        call->call = VOCAL_NONE;
        return;
    }
    vocal_render(&call->vocal, phone, wave);
    add(mix, wave, CALL_LEVEL * call->left, CALL_LEVEL * call->right);
}

/* ---- Interface of the synthesiser ----------------------------------------------------------- */

void synth_init(struct synth *synth)
{
    memset(synth, 0, sizeof *synth);
}

/* Returns a free voice, or the oldest voice if no voice is free. */
static struct synth_voice *find_voice(struct synth *synth)
{
    struct synth_voice *voice = &synth->voice[0];
    for (uint32_t i = 0; i < SYNTH_VOICE_MAX && voice->sound != SOUND_NONE; i++) {
        struct synth_voice *other = &synth->voice[i];
        if (other->sound == SOUND_NONE || other->age_blocks > voice->age_blocks) {
            voice = other;
        }
    }
    return voice;
}

/* Starts a call. A call replaces the older of two calls. */
static void call_start(struct synth *synth, uint8_t call, struct tone side)
{
    struct synth_call *slot = &synth->call[0];
    const struct synth_call *other = &synth->call[1];
    if (slot->call != VOCAL_NONE &&
        (other->call == VOCAL_NONE || other->age_blocks > slot->age_blocks)) {
        slot = &synth->call[1];
    }
    *slot = (struct synth_call){ .call = call, .left = side.x, .right = side.y };
    slot->vocal.random = synth->played;
    vocal_begin(&slot->vocal, &vocal_calls[call][0]);
}

void synth_play(struct synth *synth, const struct sound_event *event)
{
    CORE_ASSERT(synth && event);
    if (event->sound == SOUND_NONE || event->sound >= SOUND_COUNT) {
        return;
    }
    const struct sound_recipe *recipe = &sound_recipes[event->sound];
    const uint32_t started = synth->started[event->sound];
    if (started > 0 && synth->blocks + 1u - started < blocks_of(recipe->apart_ms)) {
        return;
    }
    synth->started[event->sound] = synth->blocks + 1u;
    const float gain = f_clamp(event->gain, 0.0f, 1.0f);
    const struct tone pan = tone_pan(event->pan);
    const struct tone side = { gain * pan.x, gain * pan.y };
    struct synth_voice *voice = find_voice(synth);
    /* The numbers of the sounds are scrambled. The first random number, which changes the pitch,
     * would otherwise rise steadily from sound to sound. */
    *voice = (struct synth_voice){ .sound = event->sound, .noise = tone_scramble(++synth->played) };
    voice->length_blocks = blocks_of(recipe->length_ms);
    voice->left = side.x;
    voice->right = side.y;
    float sharp = 1.0f;
    if (recipe->vary > 0.0f) {
        sharp = f_lerp(WEAK_SHARP, STRONG_SHARP, gain) *
                (1.0f + recipe->vary * tone_noise(&voice->noise));
    }
    for (uint32_t i = 0; i < SYNTH_LAYER_MAX && recipe->layer[i].kind != LAYER_NONE; i++) {
        layer_start(&voice->layer[i], &recipe->layer[i], sharp);
    }
    if (recipe->string_hz > 0.0f) {
        string_pluck(voice, recipe);
    }
    if (recipe->call != VOCAL_NONE) {
        call_start(synth, recipe->call, side);
    }
}

void synth_render(struct synth *synth, float *mix)
{
    CORE_ASSERT(synth && mix);
    for (uint32_t v = 0; v < SYNTH_VOICE_MAX; v++) {
        if (synth->voice[v].sound != SOUND_NONE) {
            voice_render(&synth->voice[v], mix);
        }
    }
    for (uint32_t c = 0; c < SYNTH_CALL_MAX; c++) {
        if (synth->call[c].call != VOCAL_NONE) {
            call_render(&synth->call[c], mix);
        }
    }
    synth->blocks++;
}
