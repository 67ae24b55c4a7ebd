/* ambience.c -- implements the sounds around the stall; see ambience.h. */
#include "core/sound/ambience.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

/* Levels of the sources. */
#define TALKER_LEVEL 0.085f
#define CICADA_LEVEL 0.020f
#define TRILL_LEVEL 0.022f
#define BUBBLE_LEVEL 0.075f
#define RIM_LEVEL 0.060f
#define BUBBLES_PER_S 24.0f
#define SILENT 1e-4f
#define CICADA_HZ 4150.0f
#define CICADA_SONG_S 3.4f
/* Rate of the beats at the begin and at the end of a cicada's song. */
#define CICADA_BEAT_HZ 9.5f
#define CICADA_BEAT_END_HZ 6.0f
#define TRILL_HZ 5400.0f /* Centre frequency and rate of the distant large brown cicadas. */
#define TRILL_BEAT_HZ 27.0f
#define STONE_PAN 0.55f /* Place of the air stone, on the left or on the right. */
#define VOWELS 5u

void ambience_init(struct ambience *ambience, uint32_t seed)
{
    memset(ambience, 0, sizeof *ambience);
    ambience->random = seed;
    for (uint32_t i = 0; i < AMBIENCE_TALKERS; i++) {
        struct ambience_talker *talker = &ambience->talker[i];
        talker->pan = tone_pan(-0.9f + 1.8f * (float)i / (float)(AMBIENCE_TALKERS - 1u));
        talker->vocal.random = seed + i;
        talker->phone = (struct vocal_phone){
            .ms = 1.0f, .hz = { 500.0f, 1500.0f, 2500.0f }, .pitch_hz = 150.0f, .noise_hz = 2500.0f
        };
        vocal_begin(&talker->vocal, &talker->phone);
    }
    for (uint32_t i = 0; i < AMBIENCE_CICADAS; i++) {
        ambience->cicada[i].wait_blocks =
            (uint32_t)(int32_t)((1.5f + 5.0f * (float)i) * SOUND_BLOCKS_PER_S);
    }
    tone_filter_tune(&ambience->trill, TRILL_HZ, 0.10f);
}

/* Adds a mono block to `mix`. */
static void add(float *mix, const float wave[SOUND_BLOCK], float gain, struct tone pan)
{
    const float left = gain * pan.x, right = gain * pan.y;
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        mix[2u * i] += wave[i] * left;
        mix[2u * i + 1u] += wave[i] * right;
    }
}

/* ---- Crowd ---------------------------------------------------------------------------------- */

/* Chooses the next sound of a talker: a vowel, a consonant before a vowel, or a pause. */
static void next_phone(struct ambience_talker *talker, uint32_t index, uint32_t *random)
{
    static const float vowels[VOWELS][2] = {
        { 720.0f, 1250.0f }, { 330.0f, 2150.0f }, { 370.0f, 1250.0f },
        { 500.0f, 1850.0f }, { 480.0f, 900.0f },
    };
    struct vocal_phone *phone = &talker->phone;
    float ms = 90.0f + 110.0f * tone_random(random);
    if (talker->syllables == 0) {
        talker->syllables = 3u + (uint32_t)(int32_t)(8.0f * tone_random(random));
        ms = 150.0f + 900.0f * tone_random(random) * tone_random(random);
        phone->buzz = phone->noise = 0.0f;
    } else {
        talker->syllables--;
        const uint32_t vowel = (uint32_t)(int32_t)((float)VOWELS * tone_random(random));
        CORE_ASSERT(vowel < VOWELS);
        phone->hz[0] = vowels[vowel][0];
        phone->hz[1] = vowels[vowel][1];
        /* Every second talker has a high voice. The pitch falls within a word. */
        const float low_hz = index % 2u == 0 ? 115.0f : 205.0f;
        phone->pitch_hz =
            low_hz * (1.0f + 0.25f * tone_random(random) + 0.02f * (float)talker->syllables);
        phone->buzz = 0.55f + 0.45f * tone_random(random);
        phone->noise = tone_random(random) < 0.3f ? 0.10f : 0.0f;
    }
    talker->left_blocks = (uint32_t)(int32_t)(0.001f * ms * SOUND_BLOCKS_PER_S);
}

static void render_crowd(struct ambience *ambience, float *mix)
{
    for (uint32_t i = 0; i < AMBIENCE_TALKERS; i++) {
        struct ambience_talker *talker = &ambience->talker[i];
        float wave[SOUND_BLOCK] = { 0 };
        if (talker->left_blocks == 0) {
            next_phone(talker, i, &ambience->random);
        } else {
            talker->left_blocks--;
        }
        vocal_render(&talker->vocal, &talker->phone, wave);
        add(mix, wave, TALKER_LEVEL, talker->pan);
    }
}

/* ---- Cicadas -------------------------------------------------------------------------------- */

static void render_cicada(struct ambience_cicada *cicada, float pan, uint32_t *random, float *mix)
{
    if (cicada->wait_blocks > 0) {
        cicada->wait_blocks--;
        cicada->age_blocks = 0;
        cicada->wave = (struct tone){ 1.0f, 0.0f };
        return;
    }
    const float share = (float)cicada->age_blocks / (CICADA_SONG_S * SOUND_BLOCKS_PER_S);
    const float fade = f_min(4.0f * share, 1.0f) * f_min(2.5f * (1.0f - share), 1.0f);
    const float beat_hz = f_lerp(CICADA_BEAT_HZ, CICADA_BEAT_END_HZ, share);
    cicada->phase += beat_hz / SOUND_BLOCKS_PER_S;
    cicada->phase -= f_floor(cicada->phase);
    const float beat = 0.5f - 0.5f * f_cos(F_TAU * cicada->phase);
    /* The pitch rises in each beat and falls along the song. */
    const struct tone turn = tone_turn(CICADA_HZ * (1.04f - 0.08f * share + 0.02f * beat), 1.0f);
    float wave[SOUND_BLOCK];
    cicada->wave = tone_unit(cicada->wave);
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        cicada->wave = tone_next(cicada->wave, turn);
        wave[i] = cicada->wave.y;
    }
    add(mix, wave, CICADA_LEVEL * fade * beat * beat, tone_pan(pan));
    cicada->age_blocks++;
    if (share >= 1.0f) {
        cicada->wait_blocks =
            (uint32_t)(int32_t)((3.0f + 9.0f * tone_random(random)) * SOUND_BLOCKS_PER_S);
    }
}

/* Renders the trill of distant cicadas, which swells slowly. */
static void render_trill(struct ambience *ambience, float *mix)
{
    const float turn = (float)(ambience->blocks % 30000u) / 30000.0f; /* A period of 20 s. */
    const float swell = 0.55f + 0.45f * f_sin(F_TAU * turn);
    ambience->trill_phase += TRILL_BEAT_HZ / SOUND_BLOCKS_PER_S;
    ambience->trill_phase -= f_floor(ambience->trill_phase);
    const float beat = 0.65f + 0.35f * f_sin(F_TAU * ambience->trill_phase);
    float wave[SOUND_BLOCK];
    for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
        wave[i] = tone_filter_band(&ambience->trill, tone_noise(&ambience->random));
    }
    add(mix, wave, TRILL_LEVEL * swell * beat, tone_pan(0.4f));
}

/* ---- Water ---------------------------------------------------------------------------------- */

static void start_bubble(struct ambience *ambience)
{
    struct ambience_bubble *bubble = &ambience->bubble[ambience->blocks % AMBIENCE_BUBBLES];
    const float size = tone_random(&ambience->random);
    const float level = BUBBLE_LEVEL * (0.3f + 0.7f * size * size);
    const float stone_pan = ambience->is_stone_right ? STONE_PAN : -STONE_PAN;
    *bubble = (struct ambience_bubble){
        .wave = { 0.0f, level },
        .hz = 2300.0f - 1750.0f * size,
        .keep = tone_keep(5.0f + 13.0f * size),
        .pan = tone_pan(stone_pan + 0.35f * (tone_random(&ambience->random) - 0.5f)),
    };
}

static void render_bubbles(struct ambience *ambience, bool has_pump, float *mix)
{
    if (has_pump && tone_random(&ambience->random) < BUBBLES_PER_S / SOUND_BLOCKS_PER_S) {
        start_bubble(ambience);
    }
    for (uint32_t b = 0; b < AMBIENCE_BUBBLES; b++) {
        struct ambience_bubble *bubble = &ambience->bubble[b];
        if (f_abs(bubble->wave.x) + f_abs(bubble->wave.y) < SILENT) {
            bubble->wave = (struct tone){ 0.0f, 0.0f };
            continue;
        }
        bubble->hz *= 1.012f; /* The pitch rises as the bubble comes to the surface. */
        const struct tone turn = tone_turn(bubble->hz, bubble->keep);
        float wave[SOUND_BLOCK];
        for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
            bubble->wave = tone_next(bubble->wave, turn);
            wave[i] = bubble->wave.x;
        }
        add(mix, wave, 1.0f, bubble->pan);
    }
}

/* Renders the water that laps at the rim: noise on both sides, whose levels and pitches swell
 * independently of each other. */
static void render_rim(struct ambience *ambience, float *mix)
{
    static const uint32_t period_blocks[2][2] = { { 2311, 5003 }, { 2903, 4217 } };
    for (uint32_t side = 0; side < 2; side++) {
        float swell = 1.0f;
        for (uint32_t k = 0; k < 2; k++) {
            const uint32_t period = period_blocks[side][k];
            const float turn = (float)(ambience->blocks % period) / (float)period;
            swell *= 0.5f + 0.5f * f_sin(F_TAU * turn);
        }
        tone_filter_tune(&ambience->rim[side], 420.0f + 520.0f * swell, 0.55f);
        const float gain = RIM_LEVEL * (0.25f + swell);
        for (uint32_t i = 0; i < SOUND_BLOCK; i++) {
            mix[2u * i + side] +=
                gain * tone_filter_band(&ambience->rim[side], tone_noise(&ambience->random));
        }
    }
}

void ambience_render(struct ambience *ambience, bool has_pump, float *mix)
{
    render_crowd(ambience, mix);
    for (uint32_t i = 0; i < AMBIENCE_CICADAS; i++) {
        render_cicada(&ambience->cicada[i], i == 0 ? -0.7f : 0.8f, &ambience->random, mix);
    }
    render_trill(ambience, mix);
    render_bubbles(ambience, has_pump, mix);
    render_rim(ambience, mix);
    ambience->blocks++;
}
