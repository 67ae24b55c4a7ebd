/* score.c -- the festival music; see score.h. */
#include "core/sound/score.h"

#include "core/base/panic.h"

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
      .melody = THEME, .close = THEME_CLOSE, .bar = GROUND, .fill = GROUND_FILL }
#define PART_CHORUS                                                                                \
    { .phrases = 4, .beats_per_min = 138, .melody_count = 4, .close_count = 3, .bar_count = 4,     \
      .melody = CHORUS, .close = CHORUS_CLOSE, .bar = GROUND, .fill = GROUND_FILL }

const struct score_part score_parts[SCORE_PARTS] = {
    /* The drums alone open the music. */
    { .phrases = 1, .beats_per_min = 128, .melody_count = 1, .close_count = 1, .bar_count = 3,
      .melody = SILENCE, .close = SILENCE, .bar = DIALOG, .fill = DIALOG_FILL },
    PART_THEME,
    PART_CHORUS,
    PART_THEME,
    { .phrases = 4, .beats_per_min = 108, .melody_count = 4, .close_count = 2, .bar_count = 3,
      .melody = CALM, .close = CALM_CLOSE, .bar = CALM_BARS, .fill = CALM_FILL },
    { .phrases = 2, .beats_per_min = 138, .melody_count = 3, .close_count = 3, .bar_count = 3,
      .melody = CALLS, .close = CALLS, .bar = DIALOG, .fill = DIALOG_FILL },
    PART_CHORUS,
    PART_THEME,
};
/* clang-format on */

float score_hz(char pitch)
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
