/* flute.c -- implements the flute; see flute.h. */
#include "core/sound/flute.h"

#include "core/base/panic.h"

#define VIBRATO_HZ 5.3f
/* Depth of the vibrato as a share of the pitch, for most notes and for FLUTE_SHAKE. */
#define VIBRATO 0.006f
#define VIBRATO_SHAKE 0.017f
/* Milliseconds after which the vibrato of a note begins, and in which it grows. */
#define VIBRATO_AFTER_MS 180.0f
#define VIBRATO_GROW_MS 250.0f
#define GRACE_MS 55.0f  /* Duration of the higher note of FLUTE_GRACE. */
#define TAP_MS 32.0f    /* Duration of the lower pitch of FLUTE_TAP. */
#define FALL 0.92f      /* Factor on the pitch at the end of FLUTE_FALL. */
#define GLIDE_MS 9.0f   /* Time constant with which the pitch approaches its goal. */
#define ATTACK_MS 16.0f /* Time constants of the level. */
#define RELEASE_MS 38.0f
#define SILENT 1e-4f
/* Levels of the harmonics, for a note of full strength. */
#define SECOND 0.42f
#define THIRD 0.30f
#define FOURTH 0.10f
#define FIFTH 0.07f
#define BREATH 0.16f /* Level of the noise around the pitch. */
#define HISS 0.012f  /* Level of the noise of the air at the mouth hole. */

void flute_play(struct flute *flute, float hz, float level, uint32_t length_blocks,
                uint8_t ornament, float other_hz)
{
    CORE_ASSERT(hz > 100.0f && hz < 3000.0f && length_blocks > 0);
    flute->goal_hz = hz * (1.0f + flute->cents * 0.000578f);
    flute->goal = level;
    flute->age_blocks = 0;
    flute->length_blocks = length_blocks;
    flute->ornament = ornament;
    flute->other = other_hz / hz;
    if (flute->level < SILENT) {
        flute->wave = (struct tone){ 1.0f, 0.0f };
        /* The pitch of a new breath begins slightly flat. */
        flute->hz = 0.97f * flute->goal_hz;
    }
}

/* Returns the factor on the pitch of the note that its ornament and the vibrato make now. */
static float ornament_now(const struct flute *flute, float ms, float left_ms)
{
    float factor = 1.0f;
    if (flute->ornament == FLUTE_GRACE && ms < GRACE_MS) {
        factor = flute->other;
    } else if (flute->ornament == FLUTE_TAP) {
        const float middle_ms = 0.5f * (ms + left_ms);
        factor = ms > middle_ms && ms < middle_ms + TAP_MS ? flute->other : 1.0f;
    } else if (flute->ornament == FLUTE_FALL && left_ms < 120.0f) {
        factor = f_lerp(FALL, 1.0f, f_max(left_ms, 0.0f) / 120.0f);
    }
    const float depth = flute->ornament == FLUTE_SHAKE ? VIBRATO_SHAKE : VIBRATO;
    const float grown = f_clamp((ms - VIBRATO_AFTER_MS) / VIBRATO_GROW_MS, 0.0f, 1.0f);
    const float turns = 0.001f * ms * VIBRATO_HZ;
    return factor * (1.0f + grown * depth * f_sin(F_TAU * (turns - f_floor(turns))));
}

/* Advances pitch and level by one block. Returns the rotation of the oscillator. */
static struct tone flute_control(struct flute *flute)
{
    const float per_block_ms = 1000.0f / SOUND_BLOCKS_PER_S;
    const float ms = (float)flute->age_blocks * per_block_ms;
    const float left_ms = (float)flute->length_blocks * per_block_ms - ms;
    if (flute->age_blocks >= flute->length_blocks) {
        flute->goal = 0.0f;
    } else {
        flute->age_blocks++;
    }
    const float hz = flute->goal_hz * ornament_now(flute, ms, left_ms);
    flute->hz += (hz - flute->hz) * tone_share(GLIDE_MS);
    flute->wave = tone_unit(flute->wave);
    tone_filter_tune(&flute->breath, flute->hz, 0.22f);
    return tone_turn(flute->hz, 1.0f);
}

void flute_render(struct flute *flute, struct tone pan, float *mix)
{
    if (flute->goal <= 0.0f && flute->level < SILENT) {
        flute->level = 0.0f;
        return;
    }
    const struct tone turn = flute_control(flute);
    const float from = flute->level;
    flute->level += (flute->goal - from) * tone_share(flute->goal > from ? ATTACK_MS : RELEASE_MS);
    const float step = (flute->level - from) / (float)SOUND_BLOCK;
    /* High harmonics become stronger with the level. */
    const float bright = f_clamp(1.6f * flute->level, 0.25f, 1.0f);
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        flute->wave = tone_next(flute->wave, turn);
        const float s = flute->wave.y, c = flute->wave.x;
        const float s2 = 2.0f * s * c, c2 = 1.0f - 2.0f * s * s, c4 = 2.0f * c2 * c2 - 1.0f;
        const float high = THIRD * s * (1.0f + 2.0f * c2) + FOURTH * 2.0f * s2 * c2 +
                           FIFTH * s * (1.0f + 2.0f * c2 + 2.0f * c4);
        const float air = tone_noise(&flute->noise);
        const float breath = BREATH * tone_filter_band(&flute->breath, air);
        const float level = from + step * (float)i;
        const float wave = (s + SECOND * s2 + bright * high + breath + HISS * air) * level;
        mix[2u * i] += wave * pan.x;
        mix[2u * i + 1u] += wave * pan.y;
    }
}
