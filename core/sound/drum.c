/* drum.c -- implements the percussion; see drum.h. */
#include "core/sound/drum.h"

#include "core/base/panic.h"

/* Frequencies of the modes of a round membrane divided by that of its lowest mode (the zeros of the
 * Bessel functions). */
#define SKIN_MODES { 1.0f, 1.594f, 2.136f, 2.296f, 2.653f, 2.918f, 3.156f, 3.501f }
/* Level below which a mode is set to 0, and below which a stroke ends. The limit also keeps the
 * modes above the denormal numbers, which are slow. */
#define SILENT 1e-5f

struct drum_recipe {
    float hz;                /* Frequency of the lowest mode. */
    float ratio[DRUM_MODES]; /* Frequency of each mode divided by `hz`. */
    float level[DRUM_MODES]; /* Level of each mode. */
    float decay_ms;          /* Time in which the lowest mode decays to 1/e. */
    float damping;           /* Exponent by which higher modes decay faster. */
    float bend;              /* Share by which a hard stroke raises the pitch at its start. */
    float tap, tap_ms;       /* Level and decay time of the noise of the stick. */
    float tap_hz;            /* Centre frequency of this noise. */
    float pan;               /* Position from -1 (left) to 1 (right). */
};

/* Time constant in milliseconds with which the raised pitch of a skin returns to its tuning. */
#define BEND_MS 28.0f

/* clang-format off */
static const struct drum_recipe recipes[DRUM_KIND_COUNT] = {
    [DRUM_TAIKO] = { .hz = 92.0f, .ratio = SKIN_MODES,
        .level = { 0.50f, 0.42f, 0.30f, 0.26f, 0.20f, 0.14f, 0.10f, 0.08f }, .decay_ms = 210.0f,
        .damping = 0.9f, .bend = 0.16f, .tap = 0.50f, .tap_ms = 9.0f, .tap_hz = 1100.0f,
        .pan = -0.15f },
    [DRUM_RIM] = { .hz = 640.0f, .ratio = { 1.0f, 1.71f, 2.43f, 3.32f, 4.1f, 5.2f, 6.1f, 7.3f },
        .level = { 0.30f, 0.34f, 0.26f, 0.20f, 0.12f, 0.08f, 0.05f, 0.03f }, .decay_ms = 24.0f,
        .damping = 0.5f, .tap = 0.40f, .tap_ms = 3.0f, .tap_hz = 3200.0f, .pan = -0.15f },
    [DRUM_SHIME] = { .hz = 415.0f, .ratio = SKIN_MODES,
        .level = { 0.38f, 0.36f, 0.28f, 0.26f, 0.22f, 0.18f, 0.14f, 0.10f }, .decay_ms = 78.0f,
        .damping = 0.6f, .bend = 0.05f, .tap = 0.62f, .tap_ms = 5.0f, .tap_hz = 3600.0f,
        .pan = 0.25f },
    [DRUM_SHIME_LO] = { .hz = 408.0f, .ratio = SKIN_MODES,
        .level = { 0.26f, 0.20f, 0.14f, 0.10f, 0.08f, 0.06f, 0.04f, 0.03f }, .decay_ms = 52.0f,
        .damping = 0.7f, .tap = 0.30f, .tap_ms = 4.0f, .tap_hz = 3000.0f, .pan = 0.25f },
    [DRUM_BELL] = { .hz = 1890.0f,
        .ratio = { 1.0f, 1.013f, 1.472f, 2.09f, 2.56f, 3.07f, 3.62f, 4.31f },
        .level = { 0.20f, 0.16f, 0.24f, 0.16f, 0.12f, 0.08f, 0.06f, 0.04f }, .decay_ms = 260.0f,
        .damping = 0.8f, .tap = 0.20f, .tap_ms = 2.0f, .tap_hz = 6000.0f, .pan = 0.45f },
    [DRUM_BELL_LO] = { .hz = 1910.0f,
        .ratio = { 1.0f, 1.472f, 2.09f, 2.56f, 3.07f, 3.62f, 4.31f, 5.0f },
        .level = { 0.12f, 0.17f, 0.14f, 0.11f, 0.07f, 0.05f, 0.03f, 0.02f }, .decay_ms = 30.0f,
        .damping = 0.4f, .tap = 0.22f, .tap_ms = 2.0f, .tap_hz = 6500.0f, .pan = 0.45f },
};
/* clang-format on */

/* Sets the rotation of each mode. `sharp` is the factor on the tuning of the skin. */
static void tune(struct drum_stroke *stroke, const struct drum_recipe *recipe, float sharp)
{
    for (uint32_t m = 0; m < DRUM_MODES; m++) {
        const float decay_ms = recipe->decay_ms * f_exp(-recipe->damping * f_log(recipe->ratio[m]));
        const struct tone turn =
            tone_turn(recipe->hz * recipe->ratio[m] * sharp, tone_keep(decay_ms));
        stroke->turn_x[m] = turn.x;
        stroke->turn_y[m] = turn.y;
    }
}

void drum_strike(struct drums *drums, uint8_t kind, float strength, uint32_t delay_blocks)
{
    CORE_ASSERT(kind > DRUM_NONE && kind < DRUM_KIND_COUNT);
    CORE_ASSERT(strength > 0.0f && strength <= 1.0f);
    const struct drum_recipe *recipe = &recipes[kind];
    struct drum_stroke *stroke = &drums->stroke[0];
    for (uint32_t i = 0; i < DRUM_STROKES && stroke->kind != DRUM_NONE; i++) {
        struct drum_stroke *other = &drums->stroke[i];
        if (other->kind == DRUM_NONE || other->age_blocks > stroke->age_blocks) {
            stroke = other;
        }
    }
    const struct tone pan = tone_pan(recipe->pan);
    *stroke = (struct drum_stroke){
        .kind = kind, .delay_blocks = delay_blocks, .left = pan.x, .right = pan.y
    };
    for (uint32_t m = 0; m < DRUM_MODES; m++) {
        /* A harder stroke excites the high modes more. */
        const float bright = m < 3u ? 1.0f : 0.5f + 0.5f * strength;
        stroke->x[m] = 0.0f;
        stroke->y[m] = recipe->level[m] * strength * bright;
    }
    stroke->tap = recipe->tap * strength * strength;
    stroke->tap_keep = tone_keep(recipe->tap_ms);
    tone_filter_tune(&stroke->skin, recipe->tap_hz, 0.9f);
    tune(stroke, recipe, 1.0f + recipe->bend * strength);
}

/* Adds a block of one stroke to `wave`, and ends the stroke when it is inaudible. The modes are
 * added in pairs, in a fixed order, so that the sum does not depend on the compiler. */
static void stroke_render(struct drum_stroke *stroke, uint32_t *noise, float wave[SOUND_BLOCK])
{
    float *x = stroke->x, *y = stroke->y;
    const float *turn_x = stroke->turn_x, *turn_y = stroke->turn_y;
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        for (uint32_t m = 0; m < DRUM_MODES; m++) {
            const float next = x[m] * turn_x[m] - y[m] * turn_y[m];
            y[m] = y[m] * turn_x[m] + x[m] * turn_y[m];
            x[m] = next;
        }
        wave[i] = ((x[0] + x[4]) + (x[1] + x[5])) + ((x[2] + x[6]) + (x[3] + x[7]));
    }
    if (stroke->tap > SILENT) {
        for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
            wave[i] += tone_filter_band(&stroke->skin, tone_noise(noise)) * stroke->tap;
            stroke->tap *= stroke->tap_keep;
        }
    }
    float loudest = stroke->tap;
    for (uint32_t m = 0; m < DRUM_MODES; m++) {
        const float level = f_abs(x[m]) + f_abs(y[m]);
        x[m] = level > SILENT ? x[m] : 0.0f;
        y[m] = level > SILENT ? y[m] : 0.0f;
        loudest = f_max(loudest, level);
    }
    if (loudest < 4.0f * SILENT) {
        stroke->kind = DRUM_NONE;
    }
}

void drum_render(struct drums *drums, float *mix)
{
    for (uint32_t s = 0; s < DRUM_STROKES; s++) {
        struct drum_stroke *stroke = &drums->stroke[s];
        if (stroke->kind == DRUM_NONE) {
            continue;
        }
        if (stroke->delay_blocks > 0) {
            stroke->delay_blocks--;
            continue;
        }
        const struct drum_recipe *recipe = &recipes[stroke->kind];
        float wave[SOUND_BLOCK];
        /* The pitch of a skin falls quickly after a stroke, which stretches the skin. */
        const float ms = 1000.0f * (float)stroke->age_blocks / SOUND_BLOCKS_PER_S;
        if (recipe->bend > 0.0f && stroke->age_blocks > 0 && ms < 4.0f * BEND_MS &&
            stroke->age_blocks % 4u == 0) {
            tune(stroke, recipe, 1.0f + recipe->bend * f_exp(-ms / BEND_MS));
        }
        stroke->age_blocks++;
        const float left = stroke->left, right = stroke->right;
        stroke_render(stroke, &drums->noise, wave);
        for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
            mix[2u * i] += wave[i] * left;
            mix[2u * i + 1u] += wave[i] * right;
        }
    }
}
