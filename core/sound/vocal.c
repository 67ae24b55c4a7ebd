/* vocal.c -- implements the voice of formant tones; see vocal.h. */
#include "core/sound/vocal.h"

#include <stddef.h>

#include "core/base/panic.h"

/* Time constants in milliseconds with which the mouth, the pitch and the levels change. */
#define MOUTH_MS 22.0f
#define PITCH_MS 60.0f
#define LEVEL_MS 9.0f
/* Level of each formant, and its damping (bandwidth divided by frequency). */
static const float formant_level[VOCAL_FORMANTS] = { 0.22f, 0.12f, 0.06f };
static const float formant_damping[VOCAL_FORMANTS] = { 0.16f, 0.09f, 0.07f };

/* clang-format off */
#define VOWEL_A { 760.0f, 1280.0f, 2550.0f }
#define VOWEL_I { 320.0f, 2250.0f, 3000.0f }
#define VOWEL_O { 460.0f, 860.0f, 2450.0f }
const struct vocal_phone vocal_calls[VOCAL_CALL_COUNT][VOCAL_PHONES_MAX] = {
    [VOCAL_WELCOME] = {
        { 35.0f, { 380.0f, 1450.0f, 2100.0f }, 205.0f, 0.35f, 0.0f, 3000.0f },
        { 130.0f, VOWEL_A, 225.0f, 1.0f, 0.0f, 3000.0f },
        { 130.0f, VOWEL_I, 235.0f, 0.0f, 0.30f, 3300.0f },
        { 190.0f, VOWEL_A, 265.0f, 1.0f, 0.0f, 3000.0f },
        { 330.0f, VOWEL_I, 190.0f, 0.8f, 0.0f, 3000.0f },
        { 60.0f, VOWEL_I, 170.0f, 0.0f, 0.0f, 3000.0f },
    },
    [VOCAL_PITY] = {
        { 190.0f, VOWEL_O, 300.0f, 1.0f, 0.0f, 3000.0f },
        { 100.0f, VOWEL_I, 310.0f, 0.0f, 0.30f, 3500.0f },
        { 200.0f, VOWEL_I, 345.0f, 1.0f, 0.0f, 3000.0f },
        { 260.0f, VOWEL_I, 215.0f, 0.7f, 0.0f, 3000.0f },
        { 60.0f, VOWEL_I, 200.0f, 0.0f, 0.0f, 3000.0f },
    },
    [VOCAL_BRAVO] = {
        { 60.0f, VOWEL_I, 270.0f, 0.7f, 0.0f, 3000.0f },
        { 140.0f, VOWEL_A, 345.0f, 1.0f, 0.0f, 3000.0f },
        { 80.0f, VOWEL_A, 330.0f, 0.0f, 0.0f, 4600.0f },
        { 22.0f, VOWEL_A, 330.0f, 0.0f, 0.45f, 4600.0f },
        { 180.0f, VOWEL_A, 350.0f, 1.0f, 0.0f, 3000.0f },
        { 220.0f, VOWEL_A, 235.0f, 0.8f, 0.0f, 3000.0f },
        { 60.0f, VOWEL_A, 220.0f, 0.0f, 0.0f, 3000.0f },
    },
};
/* clang-format on */

const struct vocal_phone *vocal_phone_at(uint32_t call, uint32_t age_blocks)
{
    CORE_ASSERT(call < VOCAL_CALL_COUNT);
    const float ms = 1000.0f * (float)age_blocks / SOUND_BLOCKS_PER_S;
    float end_ms = 0.0f;
    for (uint32_t i = 0; i < VOCAL_PHONES_MAX && vocal_calls[call][i].ms > 0.0f; i++) {
        end_ms += vocal_calls[call][i].ms;
        if (ms < end_ms) {
            return &vocal_calls[call][i];
        }
    }
    return NULL;
}

void vocal_begin(struct vocal *vocal, const struct vocal_phone *phone)
{
    CORE_ASSERT(phone->pitch_hz > 0.0f);
    vocal->pitch_hz = 0.92f * phone->pitch_hz;
    for (uint32_t i = 0; i < VOCAL_FORMANTS; i++) {
        vocal->hz[i] = phone->hz[i];
    }
}

void vocal_render(struct vocal *vocal, const struct vocal_phone *phone, float wave[SOUND_BLOCK])
{
    const float mouth = tone_share(MOUTH_MS), level = tone_share(LEVEL_MS);
    vocal->pitch_hz += (phone->pitch_hz - vocal->pitch_hz) * tone_share(PITCH_MS);
    vocal->buzz += (phone->buzz - vocal->buzz) * level;
    vocal->noise += (phone->noise - vocal->noise) * level;
    for (uint32_t i = 0; i < VOCAL_FORMANTS; i++) {
        vocal->hz[i] += (phone->hz[i] - vocal->hz[i]) * mouth;
        tone_filter_tune(&vocal->formant[i], vocal->hz[i], formant_damping[i]);
    }
    tone_filter_tune(&vocal->breath, phone->noise_hz, 0.4f);
    const float turn = vocal->pitch_hz / (float)SOUND_RATE_HZ;
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        vocal->phase += turn;
        vocal->phase -= vocal->phase >= 1.0f ? 1.0f : 0.0f;
        const float air = tone_noise(&vocal->random);
        const float source = (1.0f - 2.0f * vocal->phase + 0.06f * air) * vocal->buzz;
        float sum = tone_filter_band(&vocal->breath, air) * vocal->noise;
        for (uint32_t k = 0; k < VOCAL_FORMANTS; k++) {
            /* Neighbouring formants have opposite signs, so that they do not cancel each other
             * between their frequencies. */
            const float band = formant_level[k] * tone_filter_band(&vocal->formant[k], source);
            sum += k % 2u == 0 ? band : -band;
        }
        wave[i] += sum;
    }
}
