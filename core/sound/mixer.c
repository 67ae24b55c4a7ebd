/* mixer.c -- implements the mixer; see mixer.h. */
#include "core/sound/mixer.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

/* Levels of the three sources, which give about -18 LUFS in a round. */
#define EFFECTS_GAIN 1.30f
#define MUSIC_GAIN 0.50f
#define AMBIENCE_GAIN 0.95f
/* Peak of the effects at which music and surroundings are lowered most, and factor on them. */
#define DUCK_FULL 0.30f
#define DUCK_MUSIC 0.50f
/* Time constants in milliseconds of the ducking and of the levels. */
#define DUCK_DOWN_MS 12.0f
#define DUCK_UP_MS 320.0f
#define LEVEL_MS 60.0f
/* Largest true peak: -2 dB of full scale, which leaves 1 dB for the error of the short filter
 * and for the change of the gain within a block. */
#define CEILING 0.794f
/* Sample peak below which no true peak reaches the ceiling. */
#define SAFE 0.45f
#define RELEASE_PER_BLOCK 0.004f
#define FULL_SCALE 32767.0f
/* Level below which a source is not rendered. */
#define SILENT 1e-4f

#define PHASES 3u
#define TAPS (MIXER_HISTORY + 1u)
/* Sine cardinal with a Hann window, a quarter, a half and three quarters between two samples. */
static const float between[PHASES][TAPS] = {
    { -0.01237f, 0.05003f, -0.14793f, 0.89363f, 0.28005f, -0.08632f, 0.02693f, -0.00402f },
    { -0.01063f, 0.05258f, -0.15908f, 0.61713f, 0.61713f, -0.15908f, 0.05258f, -0.01063f },
    { -0.00402f, 0.02693f, -0.08632f, 0.28005f, 0.89363f, -0.14793f, 0.05003f, -0.01237f },
};

void mixer_init(struct mixer *mixer, uint32_t seed)
{
    memset(mixer, 0, sizeof *mixer);
    synth_init(&mixer->synth);
    music_init(&mixer->music, seed);
    ambience_init(&mixer->ambience, seed);
    mixer->levels = mixer->now = (struct sound_levels){ .effects = 1.0f };
    mixer->duck = mixer->gain = mixer->need = 1.0f;
    mixer->taken = SOUND_BLOCK;
}

void mixer_set_levels(struct mixer *mixer, const struct sound_levels *levels)
{
    if (levels->song != mixer->levels.song) {
        music_init(&mixer->music, levels->song);
    }
    mixer->levels = (struct sound_levels){
        .effects = f_clamp(levels->effects, 0.0f, 1.0f),
        .music = f_clamp(levels->music, 0.0f, 1.0f),
        .ambience = f_clamp(levels->ambience, 0.0f, 1.0f),
        .song = levels->song,
        .has_pump = levels->has_pump,
        .is_stone_right = levels->is_stone_right,
    };
}

void mixer_play(struct mixer *mixer, const struct sound_event *event)
{
    synth_play(&mixer->synth, event);
}

/* ---- Mix ------------------------------------------------------------------------------------ */

static float peak_of(const float mix[2u * SOUND_BLOCK])
{
    float peak = 0.0f;
    for (uint32_t i = 0; i < 2u * SOUND_BLOCK; i++) {
        peak = f_max(peak, f_abs(mix[i]));
    }
    return peak;
}

/* Adds `part` to `mix` with a gain that changes linearly from `from` to `to`. */
static void add_part(float *mix, const float *part, float from, float to)
{
    const float step = (to - from) / (float)SOUND_BLOCK;
    for (uint32_t i = 0; i < 2u * SOUND_BLOCK; i++) {
        mix[i] += part[i] * (from + step * (float)(i / 2u));
    }
}

/* Moves the present levels toward the requested levels by one block. */
static void approach_levels(struct mixer *mixer)
{
    const float share = tone_share(LEVEL_MS);
    mixer->now.effects += (mixer->levels.effects - mixer->now.effects) * share;
    mixer->now.music += (mixer->levels.music - mixer->now.music) * share;
    mixer->now.ambience += (mixer->levels.ambience - mixer->now.ambience) * share;
    mixer->now.has_pump = mixer->levels.has_pump;
    mixer->ambience.is_stone_right = mixer->levels.is_stone_right;
}

/* Renders the next block of all sources to `mix`. */
static void mix_block(struct mixer *mixer, float mix[2u * SOUND_BLOCK])
{
    const struct sound_levels from = mixer->now;
    const float duck_from = mixer->duck;
    float part[2u * SOUND_BLOCK] = { 0 };
    approach_levels(mixer);
    synth_render(&mixer->synth, part);
    const float loud = f_min(mixer->now.effects * peak_of(part) / DUCK_FULL, 1.0f);
    const float goal = f_lerp(1.0f, DUCK_MUSIC, loud);
    mixer->duck += (goal - duck_from) * tone_share(goal < duck_from ? DUCK_DOWN_MS : DUCK_UP_MS);
    add_part(mix, part, EFFECTS_GAIN * from.effects, EFFECTS_GAIN * mixer->now.effects);
    if (from.music > SILENT || mixer->levels.music > 0.0f) {
        memset(part, 0, sizeof part);
        music_render(&mixer->music, part);
        add_part(mix, part, MUSIC_GAIN * from.music * duck_from,
                 MUSIC_GAIN * mixer->now.music * mixer->duck);
    }
    if (from.ambience > SILENT || mixer->levels.ambience > 0.0f) {
        memset(part, 0, sizeof part);
        ambience_render(&mixer->ambience, mixer->now.has_pump, part);
        add_part(mix, part, AMBIENCE_GAIN * from.ambience * duck_from,
                 AMBIENCE_GAIN * mixer->now.ambience * mixer->duck);
    }
}

/* ---- Limiter -------------------------------------------------------------------------------- */

/* Returns the largest value of a channel's block between its samples, and stores the end of the
 * block for the next call. */
static float true_peak(float history[MIXER_HISTORY], const float *mix)
{
    float row[MIXER_HISTORY + SOUND_BLOCK], peak = 0.0f;
    for (uint32_t i = 0; i < MIXER_HISTORY; i++) {
        row[i] = history[i];
    }
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        row[MIXER_HISTORY + i] = mix[2u * i];
        peak = f_max(peak, f_abs(mix[2u * i]));
    }
    for (uint32_t i = 0; i < MIXER_HISTORY; i++) {
        history[i] = row[SOUND_BLOCK + i];
    }
    if (peak < SAFE) {
        return peak;
    }
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        for (uint32_t p = 0; p < PHASES; p++) {
            float sum = 0.0f;
            for (uint32_t k = 0; k < TAPS; k++) {
                sum += between[p][k] * row[i + k];
            }
            peak = f_max(peak, f_abs(sum));
        }
    }
    return peak;
}

/* Limits the block that waits, writes its samples to `ready`, and lets the block `mix` wait. The
 * gain at the border of two blocks suits both blocks, so that the gain never jumps. */
static void limit_block(struct mixer *mixer, const float mix[2u * SOUND_BLOCK])
{
    const float peak =
        f_max(true_peak(mixer->history[0], mix), true_peak(mixer->history[1], mix + 1));
    const float need = peak > CEILING ? CEILING / peak : 1.0f;
    const float from = mixer->gain;
    const float to = f_min(f_min(need, mixer->need), from + RELEASE_PER_BLOCK);
    const float step = (to - from) / (float)SOUND_BLOCK;
    for (uint32_t i = 0; i < 2u * SOUND_BLOCK; i++) {
        const float gain = from + step * (float)(i / 2u);
        const float sample = f_clamp(mixer->waiting[i] * gain, -1.0f, 1.0f) * FULL_SCALE;
        /* The conversion rounds to the nearest integer. */
        mixer->ready[i] = (int16_t)((int32_t)(sample + 32768.5f) - 32768);
        mixer->waiting[i] = mix[i];
    }
    mixer->need = need;
    mixer->gain = to;
}

void mixer_render(struct mixer *mixer, int16_t *stereo, uint32_t frame_count)
{
    CORE_ASSERT(mixer && (stereo || frame_count == 0));
    for (uint32_t i = 0; i < frame_count; i++) {
        if (mixer->taken == SOUND_BLOCK) {
            float mix[2u * SOUND_BLOCK] = { 0 };
            mix_block(mixer, mix);
            limit_block(mixer, mix);
            mixer->taken = 0;
        }
        stereo[2u * i] = mixer->ready[2u * mixer->taken];
        stereo[2u * i + 1u] = mixer->ready[2u * mixer->taken + 1u];
        mixer->taken++;
    }
}
