/* ui_level.c -- draws the pictures of the levels: a child, an adult and a champion with a headband,
 * each with a poi (paper scoop). The pictures let players choose a level without reading. */
#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

#define SKIN 0xf4cfa4ffu
#define CHEEK 0xf09a80ffu
#define HAIR 0x2a1c1effu
#define INK 0x3a2218ffu
#define WHITE 0xfdf6e8ffu
#define RED 0xc8301effu
#define YELLOW 0xf2b23cffu
#define OCHRE 0xd8902cffu
#define BLUE 0x3a5ab0ffu
#define BLUE_DIM 0x2f4a96ffu
#define BLUE_DARK 0x22376effu
#define TROUSERS 0x2a2a3cffu

/* A line with round ends. A line of length 0 is a disc. Coordinates are shares of an adult's
 * height, with x to the right from the middle of the figure and y up from the feet. */
struct stroke {
    float from_x, from_y, to_x, to_y, width;
    uint32_t colour;
    /* True if the stroke is also drawn mirrored on the other side of the figure. */
    bool is_pair;
};

#define POI_SIZE 0.085f /* Radius of the poi as a share of an adult's height. */
#define FIGURE_STROKES_MAX 21u

struct figure {
    float poi_x, poi_y;
    /* Strokes of the figure in the order of drawing. Unused strokes have the width 0. */
    struct stroke strokes[FIGURE_STROKES_MAX];
};

/* clang-format off */
static const struct figure figures[LEVEL_COUNT] = {
    /* A child: a large head and a short body in a yellow jinbei, a summer suit. */
    [LEVEL_EASY] = { 0.27f, 0.40f, {
        { 0.070f, 0.120f, 0.080f, 0.020f, 0.075f, SKIN, 1 },
        { 0.100f, 0.015f, 0.080f, 0.015f, 0.050f, RED, 1 },
        { 0.060f, 0.150f, 0.070f, 0.120f, 0.120f, OCHRE, 1 },
        { -0.12f, 0.300f, -0.19f, 0.200f, 0.070f, SKIN, 0 },
        { 0.120f, 0.300f, 0.220f, 0.320f, 0.070f, SKIN, 0 },
        { -0.11f, 0.310f, -0.15f, 0.260f, 0.100f, YELLOW, 0 },
        { 0.110f, 0.310f, 0.160f, 0.310f, 0.100f, YELLOW, 0 },
        { 0.040f, 0.290f, 0.040f, 0.200f, 0.190f, YELLOW, 1 },
        { 0.050f, 0.360f, -0.01f, 0.260f, 0.030f, WHITE, 1 },
        { -0.11f, 0.185f, 0.110f, 0.185f, 0.035f, RED, 0 },
        { 0.000f, 0.545f, 0.000f, 0.545f, 0.370f, HAIR, 0 },
        { 0.155f, 0.490f, 0.155f, 0.490f, 0.070f, SKIN, 1 },
        { -0.03f, 0.495f, 0.030f, 0.495f, 0.270f, SKIN, 0 },
        { -0.10f, 0.615f, 0.100f, 0.615f, 0.090f, HAIR, 0 },
        { 0.065f, 0.500f, 0.065f, 0.485f, 0.036f, INK, 1 },
        { 0.115f, 0.445f, 0.105f, 0.445f, 0.040f, CHEEK, 1 },
        { 0.035f, 0.425f, 0.000f, 0.412f, 0.018f, RED, 1 },
    } },
    /* An adult in an indigo yukata with a white belt. */
    [LEVEL_NORMAL] = { 0.30f, 0.56f, {
        { 0.060f, 0.060f, 0.070f, 0.020f, 0.060f, SKIN, 1 },
        { 0.090f, 0.012f, 0.060f, 0.012f, 0.040f, INK, 1 },
        { -0.16f, 0.550f, -0.20f, 0.420f, 0.060f, SKIN, 0 },
        { 0.160f, 0.570f, 0.260f, 0.490f, 0.060f, SKIN, 0 },
        { -0.14f, 0.620f, -0.18f, 0.490f, 0.110f, BLUE_DIM, 0 },
        { 0.140f, 0.620f, 0.200f, 0.540f, 0.110f, BLUE_DIM, 0 },
        { 0.050f, 0.360f, 0.060f, 0.110f, 0.150f, BLUE_DIM, 1 },
        { 0.000f, 0.360f, 0.000f, 0.110f, 0.150f, BLUE_DIM, 0 },
        { 0.070f, 0.620f, 0.040f, 0.400f, 0.180f, BLUE, 1 },
        { 0.000f, 0.740f, 0.000f, 0.680f, 0.090f, SKIN, 0 },
        { 0.060f, 0.700f, -0.02f, 0.530f, 0.030f, WHITE, 1 },
        { -0.10f, 0.430f, 0.100f, 0.430f, 0.065f, WHITE, 0 },
        { 0.030f, 0.360f, 0.035f, 0.090f, 0.012f, BLUE_DARK, 0 },
        { 0.000f, 0.875f, 0.000f, 0.875f, 0.235f, HAIR, 0 },
        { 0.105f, 0.835f, 0.105f, 0.835f, 0.050f, SKIN, 1 },
        { 0.000f, 0.845f, 0.000f, 0.830f, 0.185f, SKIN, 0 },
        { -0.06f, 0.925f, 0.070f, 0.915f, 0.065f, HAIR, 0 },
        { 0.040f, 0.845f, 0.040f, 0.838f, 0.024f, INK, 1 },
        { 0.025f, 0.790f, 0.000f, 0.782f, 0.014f, RED, 1 },
    } },
    /* A champion in a red happi coat with a tied white headband, and the poi held high. */
    [LEVEL_MASTER] = { 0.31f, 0.90f, {
        { 0.075f, 0.300f, 0.100f, 0.040f, 0.100f, TROUSERS, 1 },
        { 0.140f, 0.015f, 0.090f, 0.015f, 0.045f, WHITE, 1 },
        { -0.19f, 0.600f, -0.13f, 0.450f, 0.065f, SKIN, 0 },
        { 0.180f, 0.660f, 0.260f, 0.800f, 0.065f, SKIN, 0 },
        { -0.15f, 0.630f, -0.21f, 0.560f, 0.120f, RED, 0 },
        { 0.140f, 0.630f, 0.200f, 0.700f, 0.120f, RED, 0 },
        { 0.080f, 0.620f, 0.085f, 0.360f, 0.190f, RED, 1 },
        { 0.000f, 0.620f, 0.000f, 0.360f, 0.100f, WHITE, 0 },
        { 0.000f, 0.740f, 0.000f, 0.660f, 0.090f, SKIN, 0 },
        { 0.055f, 0.690f, 0.045f, 0.330f, 0.036f, INK, 1 },
        { -0.13f, 0.430f, 0.130f, 0.430f, 0.055f, UI_GOLD, 0 },
        { 0.000f, 0.875f, 0.000f, 0.875f, 0.235f, HAIR, 0 },
        { 0.105f, 0.835f, 0.105f, 0.835f, 0.050f, SKIN, 1 },
        { 0.000f, 0.845f, 0.000f, 0.830f, 0.185f, SKIN, 0 },
        { -0.12f, 0.905f, -0.21f, 0.960f, 0.035f, WHITE, 0 },
        { -0.12f, 0.905f, -0.22f, 0.870f, 0.035f, WHITE, 0 },
        { -0.09f, 0.905f, 0.090f, 0.905f, 0.060f, WHITE, 0 },
        { 0.000f, 0.905f, 0.000f, 0.905f, 0.050f, RED, 0 },
        { 0.065f, 0.868f, 0.025f, 0.858f, 0.016f, INK, 1 },
        { 0.042f, 0.838f, 0.042f, 0.834f, 0.024f, INK, 1 },
        { -0.03f, 0.785f, 0.025f, 0.790f, 0.016f, RED, 0 },
    } },
};
/* clang-format on */

const char *ui_level_name(uint8_t language, uint8_t level)
{
    static const uint16_t names[LEVEL_COUNT] = {
        [LEVEL_MASTER] = TEXT_LEVEL_MASTER,
        [LEVEL_NORMAL] = TEXT_LEVEL_NORMAL,
        [LEVEL_EASY] = TEXT_LEVEL_EASY,
    };
    CORE_ASSERT(level < LEVEL_COUNT);
    return text_words(language, (enum text_key)names[level]);
}

void ui_level_figure(const struct ui_frame *frame, float x, float y, float height, uint8_t level)
{
    CORE_ASSERT(level < LEVEL_COUNT && height > 0.0f);
    const struct figure *figure = &figures[level];
    ui_poi_sign(frame, x + figure->poi_x * height, y - figure->poi_y * height, POI_SIZE * height,
                1.0f, RED);
    for (uint32_t i = 0; i < FIGURE_STROKES_MAX && figure->strokes[i].width > 0.0f; i++) {
        const struct stroke *stroke = &figure->strokes[i];
        for (uint32_t k = 0; k < (stroke->is_pair ? 2u : 1u); k++) {
            const float side = k == 0 ? height : -height;
            const float from[2] = { x + stroke->from_x * side, y - stroke->from_y * height };
            const float to[2] = { x + stroke->to_x * side, y - stroke->to_y * height };
            ui_segment(frame->batch, from, to, stroke->width * height, stroke->colour);
        }
    }
}

void ui_level_tag(const struct ui_frame *frame, struct ui_box box, uint8_t level)
{
    const float u = frame->unit;
    ui_panel(frame, UI_WOOD, box, 6.0f * u, 2.0f * u, UI_CEDAR, 0x5a3a20ffu);
    ui_level_figure(frame, box.x + 0.47f * box.width, box.y + 0.95f * box.height,
                    0.90f * box.height, level);
}
