/* ui_lab_stage.c -- draws the aquarium of the growth lab (the stage): the fish at the selected age,
 * its ruler, a comparison fish, and the trajectories of points of the fish. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/render/ui/lab/ui_lab.h"

#define TAU 6.28318531f
#define BEAT_HZ 1.1f
/* Maximum number of marks on the ruler. A ruler usually has about 110 marks, because marks are at
 * least 7 px apart. */
#define RULE_MARKS_MAX 260u
/* Length on the screen of the newly hatched fish, as a fraction of the adult's length on the
 * screen. A fraction below 1 makes growth visible. */
#define YOUNG_SIZE 0.74f
#define WAY_GOLD 0xffd24affu
#define WAY_PINK 0xff8fb0ffu
#define CHORD 0xffffff90u
/* Margin above the fish in canvas units. The margin is needed because the fish turns a little while
 * it swims. */
#define TOP 40.0f
/* Margin above the fish in canvas units while a comparison fish is shown, because a caption is then
 * drawn above each of the two fish. */
#define TOP_CAPTION 62.0f
#define FOOT 12.0f /* Margin above the ruler in canvas units. */
/* Length of a trajectory, in layout units, from which its dots have their full size. Shorter
 * trajectories have smaller dots. */
#define DOT_WAY 120.0f

/* ---- Area of a fish ------------------------------------------------------------------------- */

/* Area of one fish on the screen. The area is the whole stage, or half of the stage if a comparison
 * fish is shown. */
struct tank_room {
    struct ui_box box;
    float ruler_y;
};

static struct tank_room room_of(const struct ui_frame *frame, uint32_t half)
{
    CORE_ASSERT(half < 2u);
    struct ui_box box = lab_place(frame, LAB_STAGE);
    if (frame->scene->lab.compare && frame->is_upright) {
        box.height *= 0.5f;
        box.y += (float)half * box.height;
    } else if (frame->scene->lab.compare) {
        box.width *= 0.5f;
        box.x += (float)half * box.width;
    }
    return (struct tank_room){ .box = box, .ruler_y = box.y + box.height - 40.0f * frame->unit };
}

/* Returns the previewed fish. The fish fits into its area at every age, and is drawn shorter while
 * it is young. */
static struct specimen fish_in(const struct ui_frame *frame, const struct tank_room *room)
{
    const struct scene_lab *const lab = &frame->scene->lab;
    const struct ui_box *const box = &room->box;
    const float u = frame->unit, time_s = frame->time_s;
    const float top = box->y + (lab->compare ? TOP_CAPTION : TOP) * u;
    const float foot = room->ruler_y - FOOT * u;
    struct specimen fish = lab_fish(frame, lab->progress, box->x + 0.5f * box->width,
                                    0.5f * (top + foot), box->width - 64.0f * u, foot - top,
                                    YOUNG_SIZE + (1.0f - YOUNG_SIZE) * lab->progress);
    fish.rig = &frame->memory->bench.rig;
    fish.shadow = 0.35f;
    if (!lab->path) { /* The fish swims only while no trajectories are drawn. */
        fish.yaw_rad += 0.16f * sinf(0.5f * time_s);
        fish.pitch_rad += 0.05f * sinf(0.37f * time_s + 1.0f);
        fish.phase_rad = fmodf(TAU * BEAT_HZ * time_s, TAU);
        fish.amplitude = 0.8f;
    }
    return fish;
}

/* ---- Ruler ---------------------------------------------------------------------------------- */

/* Returns the distance in metres between two marks of the ruler. The distance is 1, 2 or 5 times a
 * power of ten, and at least `least_px` pixels on the screen. */
static float ruler_step_m(float px_per_m, float least_px)
{
    CORE_ASSERT(px_per_m > 0.0f);
    static const float steps[3] = { 1.0f, 2.0f, 5.0f };
    float power = 1e-5f;
    for (uint32_t i = 0; i < 24u; i++) {
        const float step = steps[i % 3u] * power;
        if (step * px_per_m >= least_px) {
            return step;
        }
        power *= i % 3u == 2u ? 10.0f : 1.0f;
    }
    return power;
}

/* Draws a bamboo ruler below the fish. The zero of the ruler is at the fish's snout. A bracket on
 * the ruler marks the length that is usually measured for the species, for example with or without
 * the tail fin. */
static void ruler(const struct ui_frame *frame, const struct tank_room *room,
                  const struct specimen *fish)
{
    const struct scene_lab *const lab = &frame->scene->lab;
    const float u = frame->unit;
    const struct ui_box rule = { room->box.x + 14.0f * u, room->ruler_y,
                                 room->box.width - 28.0f * u, 32.0f * u };
    const float px_per_m = fish->length_px / fmaxf(lab->length_m, 1e-5f);
    const float zero = fish->x_px - 0.5f * fish->length_px;
    const float fine = ruler_step_m(px_per_m, 7.0f * u), coarse = ruler_step_m(px_per_m, 74.0f * u);
    const bool in_cm = coarse >= 0.0099f;
    ui_panel(frame, UI_WOOD, rule, 5.0f * u, 1.5f * u, 0xe2bf82ffu, 0x6a4a22ffu);
    const float end = rule.x + rule.width - 6.0f * u;
    for (uint32_t i = 0; i < RULE_MARKS_MAX; i++) {
        const float x = zero + (float)i * fine * px_per_m;
        const float turns = (float)i * fine / coarse;
        const bool is_coarse = fabsf(turns - roundf(turns)) < 0.01f;
        if (x > end) {
            break;
        }
        if (x < rule.x + 6.0f * u) {
            continue;
        }
        const float from[2] = { x, rule.y + 2.5f * u };
        const float to[2] = { x, rule.y + (is_coarse ? 14.0f : 8.0f) * u };
        ui_segment(frame->batch, from, to, (is_coarse ? 1.8f : 1.1f) * u, 0x4a3018ffu);
        if (is_coarse && x < end - 34.0f * u) {
            /* Only the first number of the ruler is followed by the unit of length. */
            const float length_m = (float)i * fine;
            const bool is_first = length_m <= 0.0f;
            char number[24];
            snprintf(number, sizeof number, "%g%s",
                     (double)roundf(length_m * (in_cm ? 1e4f : 1e5f)) / 100.0,
                     is_first ? (in_cm ? " cm" : " mm") : "");
            ui_text(frame->batch,
                    ui_style(frame, FONT_BODY, 15.5f, is_first ? 0.0f : 0.5f, 0x3a2410ffu, 0.0f),
                    x - (is_first ? 3.0f * u : 0.0f), rule.y + 28.0f * u, number);
        }
    }
    if (lab->card.measure == MEASURE_DISC) {
        /* The bracket is omitted for a disc-shaped body, which is measured by its width, because a
         * ruler below the fish cannot show a width. */
        return;
    }
    /* A bracket marks the measured length of the fish on the ruler. */
    const float left[2] = { zero, rule.y + 1.5f * u };
    const float right[2] = { zero + fish->length_px, rule.y + 1.5f * u };
    ui_segment(frame->batch, left, right, 4.0f * u, LAB_PURPLE);
    for (uint32_t i = 0; i < 2u; i++) {
        const float *foot = i == 0 ? left : right;
        const float tick[2] = { foot[0], foot[1] - 12.0f * u };
        ui_segment(frame->batch, tick, foot, 2.4f * u, LAB_PURPLE);
    }
}

/* ---- Texts on the stage --------------------------------------------------------------------- */

/* Returns the style of a text that is drawn on the water. */
static struct ui_text on_water(struct ui_text style)
{
    return ui_outlined(style, 0.04f, 0.10f, 0x02141ec0u);
}

/* Draws the fish's age and length at the top of the stage. If a comparison fish is shown, also
 * draws the name of the fish's morph (text `key`), because the two fish have the same age and
 * length and a player could confuse them. */
static void caption(const struct ui_frame *frame, const struct tank_room *room, enum text_key key)
{
    static const enum text_key measures[] = { TEXT_TOTAL_LENGTH, TEXT_STANDARD_LENGTH,
                                              TEXT_FORK_LENGTH, TEXT_DISC_WIDTH };
    const struct scene_lab *const lab = &frame->scene->lab;
    const struct ui_box box = room->box;
    const float u = frame->unit;
    char age[TEXT_LINE_MAX], length[32], words[3u * TEXT_LINE_MAX];
    lab_age_words(frame->language, lab->age_days, age, sizeof age);
    lab_length_words(lab->length_m, length, sizeof length);
    if (lab->compare) {
        snprintf(words, sizeof words, "%s   %s  %s", ui_words(frame, key), age, length);
        ui_ribbon_at(frame, (struct ui_ribbon){ FONT_BODY, 0x06222ec0u, 0x9fd6d080u, LAB_MIST },
                     box.x + 0.5f * box.width, box.y + 26.0f * u, 21.0f * u, box.width - 24.0f * u,
                     words);
        return;
    }
    snprintf(words, sizeof words, "%s %s", ui_words(frame, measures[lab->card.measure & 3u]),
             length);
    const struct ui_text big =
        ui_style(frame, FONT_STALL, 40.0f, 0.0f, 0xffffffffu, 0.5f * box.width);
    const struct ui_text small =
        ui_style(frame, FONT_BODY, 25.0f, 1.0f, LAB_MIST, 0.46f * box.width);
    ui_text(frame->batch, ui_outlined(big, 0.03f, 0.10f, 0x02141ec0u), box.x + 20.0f * u,
            box.y + 48.0f * u, age);
    ui_text(frame->batch, on_water(small), box.x + box.width - 20.0f * u, box.y + 44.0f * u, words);
}

/* ---- Trajectories of points of the fish ----------------------------------------------------- */

/* Draws a trajectory as a line of `width` units and returns its length in pixels. Draws nothing if
 * `width` is 0. */
static float way_line(const struct ui_frame *frame, const struct specimen *fish,
                      const vec3 at[LAB_PREVIEW_STEPS + 1u], float width, uint32_t colour)
{
    float length_px = 0.0f;
    for (uint32_t i = 0; i < LAB_PREVIEW_STEPS; i++) {
        float from[2], to[2];
        specimen_project(fish, at[i], from);
        specimen_project(fish, at[i + 1u], to);
        length_px += hypotf(to[0] - from[0], to[1] - from[1]);
        if (width > 0.0f) {
            ui_segment(frame->batch, from, to, width * frame->unit, colour);
        }
    }
    return length_px;
}

static void way_dot(const struct ui_frame *frame, const struct specimen *fish, vec3 at,
                    float radius, uint32_t fill, uint32_t line)
{
    float middle[2];
    const float r = radius * frame->unit;
    specimen_project(fish, at, middle);
    ui_disc(frame, middle[0], middle[1], r, fminf(2.0f * frame->unit, 0.35f * r), fill, line);
}

/* Draws the trajectory of a point (2005 thesis, figures 3.4 and 3.5) and the straight line of the
 * ordinary morph (2005 thesis, figure 3.2). A dot marks each key, and a ring marks the current
 * position. */
static void one_way(const struct ui_frame *frame, const struct specimen *fish,
                    const struct lab_preview_path *way, uint32_t colour)
{
    const struct scene_lab *const lab = &frame->scene->lab;
    const uint32_t keys = lab->card.key_count;
    const uint32_t now = (uint32_t)(lab->progress * (float)LAB_PREVIEW_STEPS + 0.5f);
    /* The dots are smaller on a short trajectory, for example on an eye's trajectory of about 20
     * px. */
    const float share = way_line(frame, fish, way->at, 0.0f, 0) / (frame->unit * DOT_WAY);
    const float size = f_clamp(share, 0.4f, 1.0f);
    way_line(frame, fish, way->ordinary, 2.0f, CHORD);
    way_line(frame, fish, way->at, 1.5f + 2.5f * size, colour);
    for (uint32_t key = 0; key < keys; key++) {
        const uint32_t step =
            (uint32_t)((float)key / (float)(keys - 1u) * (float)LAB_PREVIEW_STEPS + 0.5f);
        way_dot(frame, fish, way->at[step], 6.5f * size, lab_key_colour(keys, key), 0xffffffffu);
    }
    /* The ring at the current position is so large that the fish's eye is visible inside the
     * ring. */
    way_dot(frame, fish, way->at[now], 12.0f, 0x00000000u, colour);
}

/* Draws the trajectories of all traced points. The legend is in the free area above the fish's
 * snout. For each trajectory, the legend shows the largest distance from the straight line, in per
 * cent of a body length. */
static void draw_vertex_paths(const struct ui_frame *frame, const struct specimen *fish,
                              const struct ui_box *box)
{
    static const uint32_t colours[LAB_PREVIEW_POINT_COUNT] = { WAY_GOLD, WAY_PINK };
    const struct scene_lab *const lab = &frame->scene->lab;
    const struct lab_preview_path *const ways = frame->memory->bench.ways;
    const float u = frame->unit;
    /* For a stingray, the traced point is the sting instead of the dorsal fin. */
    const enum text_key names[LAB_PREVIEW_POINT_COUNT] = {
        [LAB_PREVIEW_DORSAL] = lab->card.motion == MOTION_WING ? TEXT_LAB_STING : TEXT_LAB_DORSAL,
        [LAB_PREVIEW_EYE] = TEXT_LAB_EYE,
    };
    for (uint32_t i = 0; i < LAB_PREVIEW_POINT_COUNT; i++) {
        if (ways[i].is_there) {
            one_way(frame, fish, &ways[i], colours[i]);
        }
    }
    float y = box->y + (lab->compare ? 74.0f : 88.0f) * u;
    for (uint32_t i = 0; i < LAB_PREVIEW_POINT_COUNT; i++) {
        if (!ways[i].is_there) {
            continue;
        }
        char words[TEXT_LINE_MAX];
        snprintf(words, sizeof words, "%s  %.1f %%", ui_words(frame, names[i]),
                 (double)(100.0f * ways[i].bow));
        const float from[2] = { box->x + 20.0f * u, y - 7.0f * u };
        const float to[2] = { from[0] + 26.0f * u, from[1] };
        ui_segment(frame->batch, from, to, 4.5f * u, colours[i]);
        ui_text(frame->batch, on_water(ui_body(frame, 20.0f, LAB_MIST)), to[0] + 12.0f * u, y,
                words);
        y += 28.0f * u;
    }
}

/* ---- Whole stage ---------------------------------------------------------------------------- */

void lab_stage(const struct ui_frame *frame)
{
    const struct ui_lab_preview *const bench = &frame->memory->bench;
    const struct scene_lab *const lab = &frame->scene->lab;
    const float u = frame->unit;
    const struct ui_box box = lab_place(frame, LAB_STAGE);
    ui_water(frame, box, 16.0f * u, frame->time_s, 0x06243cffu);
    if (bench->is_shown) {
        const struct tank_room room = room_of(frame, 0);
        const struct specimen fish = fish_in(frame, &room);
        ui_specimen(frame->batch, &fish);
        ruler(frame, &room, &fish);
        if (lab->compare) {
            /* The comparison fish shows the ordinary morph (2005 thesis, eq. 3.1) from the first
             * key to the last key (modelled growth stage). */
            const struct tank_room other_room = room_of(frame, 1);
            struct specimen other = fish_in(frame, &other_room);
            other.species = &bench->ordinary;
            other.rig = &bench->ordinary_rig;
            ui_specimen(frame->batch, &other);
            ruler(frame, &other_room, &other);
            caption(frame, &other_room, TEXT_LAB_THE_ORDINARY);
            const float from[2] = { other_room.box.x, other_room.box.y };
            const float to[2] = { frame->is_upright ? box.x + box.width : from[0],
                                  frame->is_upright ? from[1] : box.y + box.height };
            ui_segment(frame->batch, from, to, 2.0f * u, UI_GOLD_DIM);
        }
        caption(frame, &room, TEXT_LAB_OURS);
        if (lab->path) {
            draw_vertex_paths(frame, &fish, &room.box);
        }
    }
    ui_panel(frame, UI_PANEL, box, 16.0f * u, 2.0f * u, 0, UI_GOLD_DIM);
}
