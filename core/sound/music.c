/* music.c -- implements the player of the festival music; see music.h. */
#include "core/sound/music.h"

#include "core/base/mem.h"
#include "core/base/panic.h"

/* ---- Score ---------------------------------------------------------------------------------- */

/* clang-format off */
#define THEME                                                                                      \
    { "E2G1E2D1b3D2b1a2b1D2b1a6", "E5D1E3G3A2G1E2D1b6", "A6G2E1D3E2D1b2a1b6",                      \
      "E2D1E2G1E3D2b1a3b2D1E3D3" }
#define THEME_CLOSE                                                                                \
    { "E2G1E2D1b3D2b1a2g1a2b1e6", "a2b1D2E1D2b1a2g1eC", "D2E1D2b1a3g2a1b3a9" }
#define CHORUS                                                                                     \
    { "A9G2E1A6G2E1D3", "B3A2G1A3G2E1G2E1D2b1E6", "E1G1A1B3A2G1E3G2E1D2b1a6",                      \
      "E3E2E1G2E1D3b2D1E2D1b2a1e3" }
#define CHORUS_CLOSE                                                                               \
    { "A3G2E1D3E2D1b2a1g2a1b6", "B6A2G1E3D2b1a2b1a6", "E2G1A2G1E2D1b3a9-3" }
#define CALM { "EC" "F3E9", "b6c3b3aC", "a3b3c6b3a3f6", "E6c3b3c6b6" }
#define CALM_CLOSE { "a6f6eC", "c3b3a3f3e9-3" }
#define SILENCE { "-C-C" }
#define CALLS { "-C-6A3G2E1", "-CE3D2b1a6", "-6A6-6E6" }

/* The ground of the small drum is "ten-teke ten-tsuku", and that of the bell is "chan-chiki". */
#define GROUND                                                                                     \
    { { "D.....D..d..", "T.tT.tT.tTtt", "C..c.cC..c.c" },                                          \
      { "D..d..D.....", "T.tT.tTttT.t", "C..c.cC.cc.c" },                                          \
      { "D.....D.dD..", "T..T.tT.tT.t", "C.cc.cC..c.c" },                                          \
      { "D..D..d..D.d", "TttT.tTttT.t", "C..c.cC..ccc" } }
#define GROUND_FILL { "D.dD.dD.DD.D", "TttTttTttRRR", "C.cC.cC.cC.c" }
#define DIALOG                                                                                     \
    { { "D..D.dD.....", "......R.tT.t", "C.....c..c.c" },                                          \
      { "D.dD.dD.d...", ".........TTT", "C.....C....." },                                          \
      { "D..K.KD..K.K", "T..t.tT..t.t", "C..c..C..c.." } }
#define DIALOG_FILL { "D..D..D..DDD", "RRRRRRRRRTTT", "C..C..C..CCC" }
#define CALM_BARS                                                                                  \
    { { "D...........", "......t..t..", "C.....c....." },                                          \
      { "......d.....", "T.....t..t.t", "......C....." },                                          \
      { "D........d..", "......t.....", "C........c.." } }
#define CALM_FILL { "D.....d..d.d", "T..t..t.tRRR", "C.....C..c.c" }

#define PART_THEME                                                                                 \
    { .phrases = 4, .beats_per_min = 134, .melody_count = 4, .close_count = 3, .bar_count = 4,     \
      .scale = SCALE_YO, .melody = THEME, .close = THEME_CLOSE, .bar = GROUND,                     \
      .fill = GROUND_FILL }
#define PART_CHORUS                                                                                \
    { .phrases = 4, .beats_per_min = 138, .melody_count = 4, .close_count = 3, .bar_count = 4,     \
      .scale = SCALE_YO, .melody = CHORUS, .close = CHORUS_CLOSE, .bar = GROUND,                   \
      .fill = GROUND_FILL }

const struct score_part score_parts[SCORE_PARTS] = {
    /* The drums alone open the music. */
    { .phrases = 1, .beats_per_min = 128, .melody_count = 1, .close_count = 1, .bar_count = 3,
      .scale = SCALE_YO, .melody = SILENCE, .close = SILENCE, .bar = DIALOG, .fill = DIALOG_FILL },
    PART_THEME,
    PART_CHORUS,
    PART_THEME,
    { .phrases = 4, .beats_per_min = 108, .melody_count = 4, .close_count = 2, .bar_count = 3,
      .scale = SCALE_MIYAKO_BUSHI, .melody = CALM, .close = CALM_CLOSE, .bar = CALM_BARS,
      .fill = CALM_FILL },
    { .phrases = 2, .beats_per_min = 138, .melody_count = 3, .close_count = 3, .bar_count = 3,
      .scale = SCALE_YO, .melody = CALLS, .close = CALLS, .bar = DIALOG, .fill = DIALOG_FILL },
    PART_CHORUS,
    PART_THEME,
};
/* clang-format on */

float music_hz(char pitch)
{
    switch (pitch) {
    case 'd':
        return 587.33f;
    case 'e':
        return 659.26f;
    case 'f':
        return 698.46f;
    case 'g':
        return 783.99f;
    case 'a':
        return 880.0f;
    case 'b':
        return 987.77f;
    case 'c':
        return 1046.5f;
    case 'D':
        return 1174.66f;
    case 'E':
        return 1318.51f;
    case 'F':
        return 1396.91f;
    case 'G':
        return 1567.98f;
    case 'A':
        return 1760.0f;
    case 'B':
        return 1975.53f;
    default:
        CORE_ASSERT(pitch == '-');
        return 0.0f;
    }
}

float music_neighbor_hz(const char *scale, char pitch, bool is_higher)
{
    uint32_t at = 0;
    while (scale[at] != pitch) {
        CORE_ASSERT(scale[at] != '\0');
        at++;
    }
    if (is_higher) {
        at += scale[at + 1u] != '\0';
    } else {
        at -= at > 0;
    }
    return music_hz(scale[at]);
}

/* ---- Player --------------------------------------------------------------------------------- */

/* Blocks (14 ms) by which the second flute follows, and its tuning. */
#define LATE_BLOCKS 21u
#define SECOND_CENTS -7.0f
/* Largest random delay of a stroke in blocks (4 ms). */
#define LOOSE_BLOCKS 6u
/* Levels of the instruments. */
#define FLUTE_LEVEL 0.23f
#define SECOND_LEVEL 0.12f
#define LONG_STEPS 5u /* A note of at least this length can be shaken. */

/* Uses of a random number. The number depends on the use and on the position in the music only. */
enum music_choice {
    CHOICE_MELODY = 1,
    CHOICE_BAR,
    CHOICE_ORNAMENT,
    CHOICE_STROKE,
};

/* Returns a random number for a use at the present position. */
static uint32_t choose(const struct music *music, enum music_choice use, uint32_t which)
{
    return tone_scramble(music->seed ^ (music->bars * 0x9e3779b9u) ^ ((uint32_t)use * 0x85ebca6bu) ^
                         (which * 0xc2b2ae35u));
}

static const struct score_part *part_now(const struct music *music)
{
    return &score_parts[music->part % SCORE_PARTS];
}

static float step_blocks(const struct music *music)
{
    return SOUND_BLOCKS_PER_S * 60.0f / (3.0f * (float)part_now(music)->beats_per_min);
}

void music_init(struct music *music, uint32_t seed)
{
    memset(music, 0, sizeof *music);
    music->seed = seed;
    music->drums.noise = seed + 1u;
    music->flute[0].noise = seed + 2u;
    music->flute[1].noise = seed + 3u;
    music->flute[1].cents = SECOND_CENTS;
}

/* ---- Melody --------------------------------------------------------------------------------- */

static void begin_phrase(struct music *music)
{
    const struct score_part *part = part_now(music);
    const bool is_last = music->phrase + 1u == part->phrases;
    const uint32_t count = is_last ? part->close_count : part->melody_count;
    CORE_ASSERT(count > 0 && count <= SCORE_VARIANTS_MAX);
    const uint32_t variant = choose(music, CHOICE_MELODY, 0) % count;
    music->melody = is_last ? part->close[variant] : part->melody[variant];
    music->note_steps = 0;
}

/* Returns the ornament of a note of `steps` steps. */
static uint8_t ornament_of(const struct music *music, uint32_t steps)
{
    const uint32_t chance = choose(music, CHOICE_ORNAMENT, music->step) % 100u;
    if (steps >= LONG_STEPS) {
        return chance < 40u ? FLUTE_SHAKE : chance < 65u ? FLUTE_FALL : FLUTE_GRACE;
    }
    if (steps >= 2u) {
        return chance < 28u ? FLUTE_GRACE : chance < 48u ? FLUTE_TAP : FLUTE_PLAIN;
    }
    return FLUTE_PLAIN;
}

static uint32_t digit(char hex)
{
    CORE_ASSERT((hex >= '1' && hex <= '9') || (hex >= 'A' && hex <= 'C'));
    return (uint32_t)(hex <= '9' ? hex - '0' : hex - 'A' + 10);
}

static void next_note(struct music *music)
{
    const char pitch = music->melody[0];
    const float hz = music_hz(pitch);
    const uint32_t steps = digit(music->melody[1]);
    music->melody += 2;
    music->note_steps = steps;
    if (hz <= 0.0f) {
        return;
    }
    /* A long note ends one third of a step early, because the player takes breath. */
    const float blocks = step_blocks(music) * ((float)steps - (steps >= LONG_STEPS ? 0.5f : 0.12f));
    const float accent = music->step % 3u == 0 ? 1.0f : 0.82f;
    music->late.hz = hz;
    music->late.level = SECOND_LEVEL * accent;
    music->late.length_blocks = (uint32_t)(int32_t)blocks;
    music->late.ornament = FLUTE_PLAIN;
    music->late_blocks = LATE_BLOCKS;
    const uint8_t ornament = ornament_of(music, steps);
    flute_play(&music->flute[0], hz, FLUTE_LEVEL * accent, music->late.length_blocks, ornament,
               music_neighbor_hz(part_now(music)->scale, pitch, ornament == FLUTE_GRACE));
}

/* ---- Drums ---------------------------------------------------------------------------------- */

/* Strikes one instrument: `loud` for the character `loud_mark`, `soft` for `soft_mark`. */
static void strike(struct music *music, uint8_t kind, float strength, uint32_t which)
{
    const uint32_t random = choose(music, CHOICE_STROKE, 4u * music->step + which);
    const float human = 0.86f + 0.14f * (float)(random % 64u) / 64.0f;
    drum_strike(&music->drums, kind, strength * human, (random >> 8) % LOOSE_BLOCKS);
}

static void strike_taiko(struct music *music, char mark)
{
    if (mark == 'D' || mark == 'd') {
        strike(music, DRUM_TAIKO, mark == 'D' ? 0.62f : 0.34f, 0);
    } else if (mark == 'K') {
        strike(music, DRUM_RIM, 0.5f, 0);
    }
}

static void strike_shime(struct music *music, char mark)
{
    if (mark == 'T' || mark == 'R') {
        strike(music, DRUM_SHIME, 0.46f, 1);
    } else if (mark == 't') {
        strike(music, DRUM_SHIME_LO, 0.38f, 1);
    }
    if (mark == 'R') {
        const uint32_t half = (uint32_t)(int32_t)(0.5f * step_blocks(music));
        drum_strike(&music->drums, DRUM_SHIME_LO, 0.42f, half);
    }
}

static void strike_bell(struct music *music, char mark)
{
    if (mark == 'C' || mark == 'c') {
        strike(music, mark == 'C' ? DRUM_BELL : DRUM_BELL_LO, mark == 'C' ? 0.34f : 0.30f, 2);
    }
}

static void play_drums(struct music *music)
{
    const struct score_part *part = part_now(music);
    const bool is_fill = music->phrase + 1u == part->phrases && music->step >= SCORE_STEPS_PER_BAR;
    const struct score_bar *bar =
        is_fill ? &part->fill : &part->bar[choose(music, CHOICE_BAR, 0) % part->bar_count];
    const uint32_t at = music->step % SCORE_STEPS_PER_BAR;
    strike_taiko(music, bar->taiko[at]);
    strike_shime(music, bar->shime[at]);
    strike_bell(music, bar->bell[at]);
}

/* ---- Time ----------------------------------------------------------------------------------- */

static void play_step(struct music *music)
{
    if (music->step == 0) {
        begin_phrase(music);
    }
    if (music->note_steps == 0) {
        next_note(music);
    }
    music->note_steps--;
    play_drums(music);
    music->step++;
    music->bars += music->step % SCORE_STEPS_PER_BAR == 0;
    if (music->step == SCORE_STEPS_PER_PHRASE) {
        music->step = 0;
        music->phrase++;
        if (music->phrase == part_now(music)->phrases) {
            music->phrase = 0;
            music->part++;
        }
    }
}

void music_render(struct music *music, float *mix)
{
    if (music->wait <= 0.0f) {
        music->wait += step_blocks(music);
        play_step(music);
    }
    music->wait -= 1.0f;
    const bool is_late_due = music->late_blocks == 1u;
    music->late_blocks -= music->late_blocks > 0;
    if (is_late_due) {
        flute_play(&music->flute[1], music->late.hz, music->late.level, music->late.length_blocks,
                   music->late.ornament, music->late.hz);
    }
    flute_render(&music->flute[0], tone_pan(-0.25f), mix);
    flute_render(&music->flute[1], tone_pan(0.35f), mix);
    drum_render(&music->drums, mix);
}
