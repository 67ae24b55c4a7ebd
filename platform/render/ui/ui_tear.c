/* ui_tear.c -- draws why the paper tore: the slow motion of the first tear with the load of the
 * paper as colour, a picture of the cause, and the cause in words. */
#include <math.h>

#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

/* Time in seconds for which the tear of one player is shown before the tear of the next player. */
#define SLOT_S 3.0f
#define RADIUS 80.0f /* Inner radius of the drawn ring in layout units. */
/* Inner radius, in metres, of a real ring. The picture shows this length as RADIUS layout units. */
#define RADIUS_M 0.040f
#define RIM_SIDES 28u    /* Number of straight segments of the drawn ring. */
#define VIEW_DOWN 0.57f  /* Sine of the angle by which the picture looks down on the water. */
#define VIEW_LEVEL 0.82f /* Cosine of the angle by which the picture looks down on the water. */
/* Time in seconds that gives the length of the arrow of the poi's motion: the arrow is as long as
 * the poi's way in this time. */
#define ARROW_S 0.25f
#define ARROW_MAX 78.0f /* Maximum length, in layout units, of the arrow of the poi's motion. */
#define MOVES_M_S 0.03f /* Minimum speed, in m/s, of a poi whose motion is shown by an arrow. */
#define CELLS 16u
_Static_assert(CELLS == TEAR_SIDE, "one segment for each cell");

uint32_t ui_torn_player(const struct scene *scene)
{
    uint32_t torn[POI_MAX], count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->player[i].plays && scene->tear[i].cause != TEAR_NONE) {
            torn[count++] = i;
        }
    }
    return count == 0 ? POI_MAX : torn[(uint32_t)(scene->phase_s / SLOT_S) % count];
}

/* ---- Slow motion ----------------------------------------------------------------------------- */

/* Point or vector in pixels. */
struct spot {
    float x, y;
};

/* Projects the vector `v` of the world's coordinate system onto the picture. One unit of `v` is
 * `scale` pixels long. */
static struct spot project(vec3 v, float scale)
{
    return (struct spot){ scale * v.x, scale * (VIEW_DOWN * v.z - VIEW_LEVEL * v.y) };
}

/* Draws a line from the point `from` + `start` to the point `from` + `end`. */
static void stroke(const struct ui_frame *frame, struct spot from, struct spot start,
                   struct spot end, float width, uint32_t colour)
{
    ui_segment(frame->batch, (const float[2]){ from.x + start.x, from.y + start.y },
               (const float[2]){ from.x + end.x, from.y + end.y }, width, colour);
}

/* Returns the colour of the paper's load: from the colour of paper (no load) over amber and red to
 * dark red (a load that tears the paper). Brightness falls over the whole range, so that viewers
 * with any colour vision can read it. poi_paper.frag.glsl has the same red and dark red, and a
 * paler amber that begins at a higher load. The square root makes differences between low loads
 * visible, because most loads are low. */
static uint32_t load_colour(uint8_t load)
{
    static const struct {
        float from, to;    /* Range of the load's square root in which the colour changes. */
        uint8_t colour[3]; /* Red, green and blue at the end of the range. */
    } ramp[] = {
        { 0.05f, 0.40f, { 250, 168, 41 } },
        { 0.36f, 0.70f, { 209, 43, 23 } },
        { 0.70f, 1.0f, { 61, 5, 20 } },
    };
    static const uint8_t none[3] = { 255, 242, 217 };
    const float share = sqrtf(f_clamp(((float)load - 17.0f) / 238.0f, 0.0f, 1.0f));
    uint32_t colour = 0;
    for (uint32_t i = 0; i < 3u; i++) {
        float level = none[i];
        for (uint32_t k = 0; k < 3u; k++) {
            level = f_lerp(level, ramp[k].colour[i], f_smoothstep(ramp[k].from, ramp[k].to, share));
        }
        colour = colour << 8 | (uint32_t)level;
    }
    return colour << 8 | 0xffu;
}

/* Draws each cell of the paper as a short line. The line is parallel to that axis of the poi (`x`
 * or `z`) which is longer in the picture. `x` and `z` are the projected axes, one inner radius
 * long. */
static void draw_cells(const struct ui_frame *frame, const uint8_t *load, struct spot middle,
                       struct spot x, struct spot z)
{
    const float cell = 2.0f / (float)CELLS;
    const bool is_across = hypotf(x.x, x.y) >= hypotf(z.x, z.y);
    const struct spot along = is_across ? x : z;
    const float pitch = cell * fabsf(x.x * z.y - x.y * z.x) / fmaxf(hypotf(along.x, along.y), 1.0f);
    const float width = fmaxf(1.2f * pitch, 1.5f * frame->unit);
    const struct spot half = { 0.4f * cell * along.x, 0.4f * cell * along.y };
    for (uint32_t i = 0; i < CELLS * CELLS; i++) {
        const float column = cell * ((float)(i % CELLS) + 0.5f) - 1.0f;
        const float row = cell * ((float)(i / CELLS) + 0.5f) - 1.0f;
        const struct spot at = { middle.x + column * x.x + row * z.x,
                                 middle.y + column * x.y + row * z.y };
        if (load[i] != 0) {
            stroke(frame, at, (struct spot){ -half.x, -half.y }, half, width, load_colour(load[i]));
        }
    }
}

/* Draws one frame of the slow motion into `box`: the poi in the middle, the water around the poi,
 * and a bar with the progress of the slow motion. A mark on the bar shows the time of the tear. */
static void draw_motion(const struct ui_frame *frame, uint32_t player, struct ui_box box)
{
    const struct scene_tear *const tear = &frame->scene->tear[player];
    const float u = frame->unit, px_per_m = RADIUS * u / RADIUS_M;
    const struct basis axes = vec_basis_from_angles(tear->angles);
    const struct spot x = project(axes.right, RADIUS * u), z = project(axes.back, RADIUS * u);
    const struct spot middle = { box.x + 0.5f * box.width, box.y + 0.5f * box.height - 6.0f * u };
    ui_panel(frame, UI_PANEL, box, 8.0f * u, 2.0f * u, 0x1b2452ffu, UI_GOLD_DIM);
    const float foot = box.y + box.height - 3.0f * u;
    const float level =
        f_clamp(middle.y + VIEW_LEVEL * px_per_m * tear->position_m.y, box.y + 3.0f * u, foot);
    const struct ui_box water = { box.x + 3.0f * u, level, box.width - 6.0f * u, foot - level };
    ui_fill(frame, water, 0x2f86c4ffu);
    draw_cells(frame, tear->load, middle, x, z);
    stroke(frame, middle, (struct spot){ 1.1f * z.x, 1.1f * z.y },
           (struct spot){ 1.55f * z.x, 1.55f * z.y }, 9.0f * u, ui_player_colours[player]);
    for (uint32_t i = 0; i < RIM_SIDES; i++) {
        const float a = F_TAU * (float)i / (float)RIM_SIDES;
        const float b = F_TAU * (float)(i + 1u) / (float)RIM_SIDES, r = 1.06f;
        stroke(frame, middle,
               (struct spot){ r * (cosf(a) * x.x + sinf(a) * z.x),
                              r * (cosf(a) * x.y + sinf(a) * z.y) },
               (struct spot){ r * (cosf(b) * x.x + sinf(b) * z.x),
                              r * (cosf(b) * x.y + sinf(b) * z.y) },
               5.0f * u, ui_player_colours[player]);
    }
    /* This translucent fill tints the part of the poi that is under water. */
    ui_fill(frame, water, 0x3aa0d830u);
    ui_fill(frame, (struct ui_box){ water.x, level, water.width, 2.0f * u }, 0xd8f4ffb0u);
    const float speed_m_s = v3_length(tear->velocity_m_s);
    if (speed_m_s > MOVES_M_S) {
        const float reach = fminf(ARROW_S * px_per_m * speed_m_s, ARROW_MAX * u);
        const struct spot to = project(tear->velocity_m_s, reach / speed_m_s);
        ui_arrow(frame, middle.x, middle.y, to.x, to.y, UI_CREAM);
    }
    /* The slow motion lasts from 0.75 s before the tear to 0.25 s after the tear. */
    struct ui_box bar = { box.x, box.y + box.height + 5.0f * u, box.width, 6.0f * u };
    ui_fill(frame, bar, 0xd9c8a0ffu);
    ui_fill(frame,
            (struct ui_box){ bar.x, bar.y, bar.width * f_clamp(0.75f + tear->time_s, 0.0f, 1.0f),
                             bar.height },
            UI_VERMILION);
    ui_disc(frame, bar.x + 0.75f * bar.width, bar.y + 0.5f * bar.height, 6.0f * u, 2.0f * u,
            tear->time_s >= 0.0f ? UI_VERMILION : UI_CREAM, UI_VERMILION);
}

/* ---- Picture of the cause -------------------------------------------------------------------- */

/* Draws the picture of the cause of a tear, centred at `at`. The picture is 120 layout units wide
 * and 60 layout units high. In most pictures, a dark line is the paper seen from the side. */
static void draw_cause(const struct ui_frame *frame, uint8_t cause, struct spot at)
{
    const float u = frame->unit;
    const struct spot left = { -46.0f * u, 18.0f * u }, right = { 46.0f * u, 18.0f * u };
    const struct spot sag = { 0.0f, cause == TEAR_WEIGHT ? 30.0f * u : 18.0f * u };
    if (cause == TEAR_FAST) {
        for (uint32_t i = 0; i < 3u; i++) {
            const float y = (14.0f * (float)i - 14.0f) * u;
            stroke(frame, at, (struct spot){ -58.0f * u, y }, (struct spot){ -22.0f * u, y },
                   4.0f * u, UI_INK_SOFT);
        }
        ui_poi_sign(frame, at.x + 22.0f * u, at.y, 24.0f * u, 0.6f, UI_VERMILION);
        return;
    }
    if (cause == TEAR_SOAKED) {
        ui_water(frame, (struct ui_box){ at.x - 58.0f * u, at.y - 2.0f * u, 76.0f * u, 32.0f * u },
                 6.0f * u, frame->time_s, 0x1c6ea4ffu);
        stroke(frame, at, (struct spot){ -50.0f * u, 14.0f * u },
               (struct spot){ 10.0f * u, 14.0f * u }, 5.0f * u, UI_CREAM);
        ui_ring(frame, at.x + 42.0f * u, at.y, 20.0f * u, 5.0f * u, 0.8f, UI_VERMILION,
                0xd9c8a0ffu);
        stroke(frame, (struct spot){ at.x + 42.0f * u, at.y }, (struct spot){ 0.0f, 0.0f },
               (struct spot){ 0.0f, -12.0f * u }, 3.0f * u, UI_INK);
        return;
    }
    stroke(frame, at, left, sag, 5.0f * u, UI_INK);
    stroke(frame, at, sag, right, 5.0f * u, UI_INK);
    if (cause == TEAR_FLAT) {
        for (int i = -1; i <= 1; i++) {
            const float x = at.x + 28.0f * (float)i * u;
            ui_arrow(frame, x, at.y - 20.0f * u, 0.0f, 26.0f * u, UI_VERMILION);
        }
    } else {
        ui_fish_sign(frame, at.x, at.y + (cause == TEAR_WEIGHT ? 2.0f : -8.0f) * u, 66.0f * u);
    }
    if (cause == TEAR_SLAP) { /* Three short lines show the blow of the tail on the paper. */
        for (int i = -1; i <= 1; i++) {
            const float lean = (float)i;
            stroke(frame, (struct spot){ at.x + 36.0f * u, at.y + 8.0f * u },
                   (struct spot){ 6.0f * lean * u, -6.0f * u },
                   (struct spot){ 16.0f * lean * u, -18.0f * u }, 4.0f * u, UI_VERMILION);
        }
    }
}

void ui_tear(const struct ui_frame *frame, uint32_t player, struct ui_box box)
{
    static const uint16_t words[TEAR_CAUSE_COUNT] = {
        [TEAR_NONE] = TEXT_TEAR_FAST,     [TEAR_FAST] = TEXT_TEAR_FAST,
        [TEAR_FLAT] = TEXT_TEAR_FLAT,     [TEAR_SLAP] = TEXT_TEAR_SLAP,
        [TEAR_SOAKED] = TEXT_TEAR_SOAKED, [TEAR_WEIGHT] = TEXT_TEAR_WEIGHT,
    };
    CORE_ASSERT(player < POI_MAX && frame->scene->tear[player].cause < TEAR_CAUSE_COUNT);
    const float u = frame->unit;
    const bool is_wide = box.width > box.height;
    const uint8_t cause = frame->scene->tear[player].cause;
    const struct ui_box picture = { box.x + 14.0f * u, box.y + (is_wide ? 14.0f : 62.0f) * u,
                                    is_wide ? 250.0f * u : box.width - 28.0f * u,
                                    (is_wide ? 150.0f : 206.0f) * u };
    const float x =
        is_wide ? 0.5f * (picture.x + picture.width + box.x + box.width) : box.x + 0.5f * box.width;
    const float room = is_wide ? box.width - 310.0f * u : box.width - 44.0f * u;
    const float foot = box.y + box.height;
    ui_card(frame, box);
    draw_motion(frame, player, picture);
    ui_text_at(frame, ui_style(frame, FONT_STALL, 27.0f, 0.5f, UI_INK_SOFT, room), x,
               box.y + 36.0f * u, ui_words(frame, TEXT_TEAR));
    draw_cause(frame, cause, (struct spot){ x, foot - (is_wide ? 92.0f : 84.0f) * u });
    ui_text_at(frame, ui_style(frame, FONT_BODY, 27.0f, 0.5f, UI_INK, room), x, foot - 30.0f * u,
               ui_words(frame, (enum text_key)words[cause]));
    if (ui_player_count(frame->scene) > 1u) {
        ui_player_mark(frame, picture.x + 24.0f * u, picture.y + 24.0f * u, 17.0f * u, player);
    }
}
