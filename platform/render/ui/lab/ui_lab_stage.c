/* ui_lab_stage.c -- draws the aquarium of the growth lab (the stage): the fish at the selected age,
 * its ruler, a comparison fish, and the trajectories of points of the fish. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/render/ui/lab/ui_lab.h"

#define TAU 6.28318531f
#define BEAT_HZ 1.1f
/* Maximum number of marks on the ruler. In practice a ruler has about 110 marks, because marks are
 * at least 7 px apart. */
#define RULE_MARKS_MAX 260u
/* Length on the screen of the newly hatched fish, as a fraction of the adult's length on the
 * screen. The value is below 1 so that growth is visible. */
#define YOUNG_SIZE 0.74f
#define WAY_GOLD 0xffd24affu
#define WAY_PINK 0xff8fb0ffu
#define CHORD 0xffffff90u
/* Margin above the fish in canvas units. The margin is needed because the fish turns a little while
 * it swims. */
#define TOP 40.0f
#define TOP_CAPTION 62.0f /* Margin above the fish in canvas units if a caption is shown. */
#define FOOT 12.0f        /* Margin above the ruler in canvas units. */
/* Minimum length in pixels of a trajectory from which its dots have their full size. */
#define DOT_WAY 120.0f

/* ---- Area of a fish ------------------------------------------------------------------------- */

/* Area of one fish on the screen. The area is the whole stage, or half of the stage if a comparison
 * fish is shown. */
struct tank_room {
    struct ui_box box;
    float ruler_y;
};

static struct tank_room room_of(const struct lab_page *page, uint32_t half)
{
    CORE_ASSERT(half < 2u);
    const float u = page->frame.unit;
    struct ui_box box = lab_place(page, LAB_STAGE);
    if (page->lab->compare && page->lab->upright) {
        box.height *= 0.5f;
        box.y += (float)half * box.height;
    } else if (page->lab->compare) {
        box.width *= 0.5f;
        box.x += (float)half * box.width;
    }
    return (struct tank_room){ .box = box, .ruler_y = box.y + box.height - 40.0f * u };
}

/* Vertical range in pixels that the fish occupies. */
struct span_px {
    float top, foot;
};

static struct span_px free_span(const struct lab_page *page, const struct tank_room *room)
{
    const float u = page->frame.unit;
    return (struct span_px){ room->box.y + (page->lab->compare ? TOP_CAPTION : TOP) * u,
                             room->ruler_y - FOOT * u };
}

/* Returns the fish's length in pixels. The fish fits on the stage at every age, and is drawn
 * shorter while it is young. */
static float stage_fish_length_px(const struct lab_page *page, const struct tank_room *room)
{
    const struct ui_lab_preview *bench = page->bench;
    const struct specimen_bounds *reach = &bench->bounds;
    const float u = page->frame.unit;
    const float wide = (room->box.width - 64.0f * u) / fmaxf(reach->left + reach->right, 0.1f);
    const struct span_px span = free_span(page, room);
    const float high = (span.foot - span.top) / fmaxf(reach->up + reach->down, 0.1f);
    const float grown = YOUNG_SIZE + (1.0f - YOUNG_SIZE) * page->lab->progress;
    return fminf(wide, high) * grown;
}

static struct specimen fish_in(const struct lab_page *page, const struct tank_room *room)
{
    const struct ui_lab_preview *bench = page->bench;
    const struct specimen_bounds *reach = &bench->bounds;
    const struct span_px span = free_span(page, room);
    const float time_s = page->frame.time_s;
    struct specimen fish = { .species = bench->species,
                             .edition = bench->edition,
                             .rig = &bench->rig,
                             .progress = page->lab->progress,
                             .length_px = stage_fish_length_px(page, room),
                             .shadow = 0.35f };
    specimen_portrait(&fish);
    fish.x_px =
        room->box.x + 0.5f * room->box.width + 0.5f * (reach->left - reach->right) * fish.length_px;
    fish.y_px = 0.5f * (span.top + span.foot) + 0.5f * (reach->up - reach->down) * fish.length_px;
    if (!page->lab->path) { /* The fish swims only while no trajectories are drawn. */
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

/* Draws a bamboo ruler from the fish's snout to the right. The ruler shows the length that is
 * usually measured for the species, for example with or without the tail fin. */
static void ruler(const struct lab_page *page, const struct tank_room *room,
                  const struct specimen *fish)
{
    const float u = page->frame.unit;
    const struct ui_box rule = { room->box.x + 14.0f * u, room->ruler_y,
                                 room->box.width - 28.0f * u, 32.0f * u };
    const float px_per_m = fish->length_px / fmaxf(page->lab->length_m, 1e-5f);
    const float zero = fish->x_px - 0.5f * fish->length_px;
    const float fine = ruler_step_m(px_per_m, 7.0f * u), coarse = ruler_step_m(px_per_m, 74.0f * u);
    const int in_cm = coarse >= 0.0099f;
    ui_panel(&page->frame, UI_WOOD, rule, 5.0f * u, 1.5f * u, 0xe2bf82ffu, 0x6a4a22ffu);
    const float end = rule.x + rule.width - 6.0f * u;
    for (uint32_t i = 0; i < RULE_MARKS_MAX; i++) {
        const float x = zero + (float)i * fine * px_per_m;
        const float turns = (float)i * fine / coarse;
        const int is_coarse = fabsf(turns - roundf(turns)) < 0.01f;
        if (x > end) {
            break;
        }
        if (x >= rule.x + 6.0f * u) {
            const float mark_from[2] = { x, rule.y + 2.5f * u };
            const float mark_to[2] = { x, rule.y + (is_coarse ? 14.0f : 8.0f) * u };
            ui_segment(page->frame.batch, mark_from, mark_to, (is_coarse ? 1.8f : 1.1f) * u,
                       0x4a3018ffu);
        }
        if (x >= rule.x + 6.0f * u && is_coarse && x < end - 34.0f * u) {
            /* Only the first number of the ruler is followed by the unit of length. */
            const float length_m = (float)i * fine;
            const int is_first = length_m <= 0.0f;
            char number[24];
            snprintf(number, sizeof number, "%g%s",
                     (double)roundf(length_m * (in_cm ? 1e4f : 1e5f)) / 100.0,
                     is_first ? (in_cm ? " cm" : " mm") : "");
            struct ui_text style = lab_text(page, 15.5f, 0x3a2410ffu);
            style.align = is_first ? 0.0f : 0.5f;
            ui_text(page->frame.batch, &style, x - (is_first ? 3.0f * u : 0.0f), rule.y + 28.0f * u,
                    number);
        }
    }
    if (page->lab->card.measure == MEASURE_DISC) {
        return; /* A disc-shaped body is measured by its width, which a ruler below the fish cannot
                   show. */
    }
    /* A bracket marks the measured length of the fish on the ruler. */
    const float left[2] = { zero, rule.y + 1.5f * u };
    const float right[2] = { zero + fish->length_px, rule.y + 1.5f * u };
    ui_segment(page->frame.batch, left, right, 4.0f * u, LAB_PURPLE);
    for (uint32_t i = 0; i < 2u; i++) {
        const float *foot = i == 0 ? left : right;
        const float tick[2] = { foot[0], foot[1] - 12.0f * u };
        ui_segment(page->frame.batch, tick, foot, 2.4f * u, LAB_PURPLE);
    }
}

/* ---- Texts on the stage --------------------------------------------------------------------- */

static void ui_lab_stage_draw_words(const struct lab_page *page, const struct tank_room *room)
{
    const float u = page->frame.unit;
    const struct scene_lab *lab = page->lab;
    char age[TEXT_LINE_MAX], length[32], line[2u * TEXT_LINE_MAX];
    static const enum text_key measures[] = { TEXT_TOTAL_LENGTH, TEXT_STANDARD_LENGTH,
                                              TEXT_FORK_LENGTH, TEXT_DISC_WIDTH };
    lab_age_words(page->frame.language, lab->age_days, age, sizeof age);
    lab_length_words(lab->length_m, length, sizeof length);
    snprintf(line, sizeof line, "%s %s", ui_words(&page->frame, measures[lab->card.measure & 3u]),
             length);
    const struct ui_text big = { .font = FONT_STALL,
                                 .size_px = 40.0f * u,
                                 .fill = 0xffffffffu,
                                 .outline_em = 0.03f,
                                 .soft_em = 0.10f,
                                 .line = 0x02141ec0u,
                                 .fit_px = 0.5f * room->box.width };
    struct ui_text small = lab_text(page, 25.0f, LAB_MIST);
    small.align = 1.0f;
    small.outline_em = 0.04f;
    small.soft_em = 0.10f;
    small.line = 0x02141ec0u;
    small.fit_px = 0.46f * room->box.width;
    ui_text(page->frame.batch, &big, room->box.x + 20.0f * u, room->box.y + 48.0f * u, age);
    ui_text(page->frame.batch, &small, room->box.x + room->box.width - 20.0f * u,
            room->box.y + 44.0f * u, line);
}

/* Draws a caption that names the fish's morph. Without the captions, a player could confuse the two
 * fish, because they have the same age and length. */
static void caption(const struct lab_page *page, const struct tank_room *room, enum text_key key)
{
    const float u = page->frame.unit;
    char words[3u * TEXT_LINE_MAX];
    char age[TEXT_LINE_MAX], length[32];
    lab_age_words(page->frame.language, page->lab->age_days, age, sizeof age);
    lab_length_words(page->lab->length_m, length, sizeof length);
    snprintf(words, sizeof words, "%s   %s  %s", ui_words(&page->frame, key), age, length);
    const struct ui_ribbon ribbon = { .x = room->box.x + 0.5f * room->box.width,
                                      .y = room->box.y + 26.0f * u,
                                      .size_px = 21.0f * u,
                                      .font = FONT_BODY,
                                      .fill = 0x06222ec0u,
                                      .line = 0x9fd6d080u,
                                      .ink = LAB_MIST,
                                      .room_px = room->box.width - 24.0f * u };
    ui_ribbon(&page->frame, &ribbon, words);
}

/* ---- Trajectories of points of the fish ----------------------------------------------------- */

static void ui_lab_stage_put(const struct specimen *fish, vec3 point, float out[2])
{
    specimen_project(fish, point, &out[0], &out[1]);
}

static void way_line(const struct lab_page *page, const struct specimen *fish,
                     const vec3 at[LAB_PREVIEW_STEPS + 1u], float width, uint32_t colour)
{
    for (uint32_t i = 0; i < LAB_PREVIEW_STEPS; i++) {
        float from[2], to[2];
        ui_lab_stage_put(fish, at[i], from);
        ui_lab_stage_put(fish, at[i + 1u], to);
        ui_segment(page->frame.batch, from, to, width * page->frame.unit, colour);
    }
}

static void way_dot(const struct lab_page *page, const struct specimen *fish, vec3 at, float radius,
                    uint32_t fill, uint32_t line)
{
    float middle[2];
    const float r = radius * page->frame.unit;
    ui_lab_stage_put(fish, at, middle);
    ui_disc(&page->frame, middle[0], middle[1], r, fminf(2.0f * page->frame.unit, 0.35f * r), fill,
            line);
}

/* Draws the trajectory of a point (2005 thesis, figures 3.4 and 3.5) and the straight line of the
 * ordinary morph (2005 thesis, figure 3.2). A dot marks each key, and a ring marks the current
 * position. */
static void one_way(const struct lab_page *page, const struct specimen *fish,
                    const struct lab_preview_path *way, uint32_t colour)
{
    const uint32_t keys = page->lab->card.key_count;
    const uint32_t now = (uint32_t)(page->lab->progress * (float)LAB_PREVIEW_STEPS + 0.5f);
    if (!way->is_there) {
        return;
    }
    /* The dots are smaller on a short trajectory, for example on an eye's trajectory of about 20
     * px. */
    float length_px = 0.0f;
    for (uint32_t i = 0; i < LAB_PREVIEW_STEPS; i++) {
        float from[2], to[2];
        ui_lab_stage_put(fish, way->at[i], from);
        ui_lab_stage_put(fish, way->at[i + 1u], to);
        length_px += hypotf(to[0] - from[0], to[1] - from[1]);
    }
    const float share = length_px / (page->frame.unit * DOT_WAY);
    const float size = fminf(fmaxf(share, 0.4f), 1.0f);
    way_line(page, fish, way->ordinary, 2.0f, CHORD);
    way_line(page, fish, way->at, 1.5f + 2.5f * size, colour);
    for (uint32_t key = 0; key < keys; key++) {
        const uint32_t step =
            (uint32_t)((float)key / (float)(keys - 1u) * (float)LAB_PREVIEW_STEPS + 0.5f);
        way_dot(page, fish, way->at[step], 6.5f * size, lab_key_colour(keys, key), 0xffffffffu);
    }
    /* The ring at the current position is so large that the fish's eye is visible inside the
     * ring. */
    way_dot(page, fish, way->at[now], 12.0f, 0x00000000u, colour);
}

static void draw_vertex_paths(const struct lab_page *page, const struct specimen *fish)
{
    one_way(page, fish, &page->bench->ways[LAB_PREVIEW_DORSAL], WAY_GOLD);
    one_way(page, fish, &page->bench->ways[LAB_PREVIEW_EYE], WAY_PINK);
}

/* ---- Whole stage ---------------------------------------------------------------------------- */

/* Draws the comparison fish, which shows the ordinary morph (2005 thesis, eq. 3.1) from the first
 * key to the last key (modelled growth stage). */
static void rival(const struct lab_page *page)
{
    const struct tank_room room = room_of(page, 1);
    struct specimen fish = fish_in(page, &room);
    fish.species = &page->bench->ordinary;
    fish.rig = &page->bench->ordinary_rig;
    ui_specimen(page->frame.batch, &fish);
    ruler(page, &room, &fish);
    caption(page, &room, TEXT_LAB_THE_ORDINARY);
    const struct ui_box stage = lab_place(page, LAB_STAGE);
    const int across = page->lab->upright;
    const float from[2] = { across ? stage.x : room.box.x, across ? room.box.y : stage.y };
    const float to[2] = { across ? stage.x + stage.width : room.box.x,
                          across ? room.box.y : stage.y + stage.height };
    ui_segment(page->frame.batch, from, to, 2.0f * page->frame.unit, UI_GOLD_DIM);
}

static void fish_and_figures(const struct lab_page *page)
{
    const struct tank_room room = room_of(page, 0);
    const struct specimen fish = fish_in(page, &room);
    ui_specimen(page->frame.batch, &fish);
    ruler(page, &room, &fish);
    if (page->lab->compare) {
        rival(page);
        caption(page, &room, TEXT_LAB_OURS);
    } else {
        ui_lab_stage_draw_words(page, &room);
    }
    if (page->lab->path) {
        draw_vertex_paths(page, &fish);
        /* The legend is in the free area above the fish's snout. For each trajectory, the legend
         * shows the largest distance from the straight line, in per cent of a body length. */
        static const uint32_t colours[LAB_PREVIEW_POINT_COUNT] = { WAY_GOLD, WAY_PINK };
        const float u = page->frame.unit;
        float y = room.box.y + (page->lab->compare ? 74.0f : 88.0f) * u;
        for (uint32_t i = 0; i < LAB_PREVIEW_POINT_COUNT; i++) {
            const struct lab_preview_path *way = &page->bench->ways[i];
            char words[TEXT_LINE_MAX];
            if (!way->is_there) {
                continue;
            }
            /* For a stingray, the traced point is the sting instead of the dorsal fin. */
            const int stings = page->lab->card.motion == MOTION_WING;
            snprintf(words, sizeof words, "%s  %.1f %%",
                     ui_words(&page->frame, i == LAB_PREVIEW_EYE ? TEXT_LAB_EYE
                                            : stings             ? TEXT_LAB_STING
                                                                 : TEXT_LAB_DORSAL),
                     (double)(100.0f * way->bow));
            const float from[2] = { room.box.x + 20.0f * u, y - 7.0f * u };
            const float to[2] = { from[0] + 26.0f * u, from[1] };
            ui_segment(page->frame.batch, from, to, 4.5f * u, colours[i]);
            struct ui_text style = lab_text(page, 20.0f, LAB_MIST);
            style.outline_em = 0.04f;
            style.soft_em = 0.1f;
            style.line = 0x02141ec0u;
            ui_text(page->frame.batch, &style, to[0] + 12.0f * u, y, words);
            y += 28.0f * u;
        }
    }
}

void lab_stage(const struct lab_page *page)
{
    const float u = page->frame.unit;
    const struct ui_box box = lab_place(page, LAB_STAGE);
    ui_shape(page->frame.batch,
             &(struct ui_shape){ .box = box,
                                 .kind = UI_WATER,
                                 .fill = 0x1d7a86ffu,
                                 .line = 0x06243cffu,
                                 .shape = { 0, 0, 16.0f * u, page->frame.time_s } });
    if (page->bench != NULL) {
        fish_and_figures(page);
    }
    ui_panel(&page->frame, UI_PANEL, box, 16.0f * u, 2.0f * u, 0, UI_GOLD_DIM);
}
