/* ui_players.c -- draws the player numbers, the foul lamps, and the plates of several players. */
#include <math.h>

#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

/* Distance from the centre of a poi's ring to the player's number on the handle. The unit is the
 * inner radius of the ring. */
#define HANDLE_AT 2.3f
#define PLATE_WIDTH 200.0f
#define PLATE_WIDTH_MIN 152.0f
/* Width in layout units from which a plate has room for the picture of the player's level. */
#define PLATE_WIDTH_LEVEL 180.0f

uint32_t ui_player_count(const struct scene *scene)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        count += scene->player[i].plays != 0;
    }
    return count;
}

uint32_t ui_bowl_count(const struct scene *scene)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        count += scene->player[i].plays || scene->bowl[i].present;
    }
    return count;
}

uint32_t ui_first_player(const struct scene *scene)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->player[i].plays) {
            return i;
        }
    }
    return 0;
}

void ui_player_mark(const struct ui_frame *frame, float x, float y, float radius, uint32_t player)
{
    CORE_ASSERT(player < POI_MAX);
    const struct ui_text digit = {
        .font = FONT_STALL, .size_px = 1.35f * radius, .align = 0.5f, .fill = 0x14101cffu
    };
    ui_disc(frame, x, y, radius, 0.13f * radius, ui_player_colours[player], 0xfff8eaffu);
    ui_number_at(frame, digit, x, y, player + 1u);
}

void ui_foul_lamps(const struct ui_frame *frame, float x, float y, float radius, float step,
                   uint32_t fouls)
{
    for (uint32_t i = 0; i < FOUL_MAX; i++) {
        const float at = x + step * (float)i;
        const bool is_lit = i < fouls;
        if (is_lit) {
            ui_glow(frame, ui_around(at, y, 2.2f * radius), 0xff5a30a0u);
        }
        ui_disc(frame, at, y, radius, 0.2f * radius, is_lit ? 0xff5236ffu : 0x120c18c0u,
                is_lit ? 0xffd9a0ffu : 0xe8b85ca0u);
    }
}

/* Draws the plate of a player. Returns the place of the counter, to which tags fly. */
static struct ui_point plate(const struct ui_frame *frame, uint32_t player, struct ui_box box)
{
    CORE_ASSERT(player < POI_MAX);
    const float u = frame->unit;
    const bool counts_fouls = rules_of(frame->scene->mode)->counts_fouls;
    const bool shows_level =
        rules_of(frame->scene->mode)->has_levels && box.width >= PLATE_WIDTH_LEVEL * u;
    const float y = box.y + (counts_fouls ? 27.0f * u : 0.5f * box.height);
    ui_plate(frame, box);
    const struct ui_box band = { box.x + 4.0f * u, box.y + 10.0f * u, 5.0f * u,
                                 box.height - 20.0f * u };
    ui_panel(frame, UI_PANEL, band, 2.5f * u, 0.0f, ui_player_colours[player], 0);
    ui_player_mark(frame, box.x + 32.0f * u, y, 17.0f * u, player);
    ui_number_at(frame,
                 ui_style(frame, FONT_STALL, 38.0f + 8.0f * ui_catch_pop(frame, player), 0.0f,
                          0xfff8eaffu, box.width - (shows_level ? 147.0f : 112.0f) * u),
                 box.x + 58.0f * u, y, ui_catch_shown(frame, player));
    /* The right part of the plate shows either the player's paper or the reason why the player does
     * not play. `out` is set for a player who is out of the round, also if the reason is that the
     * wait for the player's lost controller has ended. */
    const struct scene_player *const state = &frame->scene->player[player];
    const float state_x = box.x + box.width - 30.0f * u, state_y = 0.5f * (y + box.y) + 16.0f * u;
    if (state->out) {
        ui_text_at(frame, ui_style(frame, FONT_STALL, 28.0f, 0.5f, 0xff9a80ffu, 46.0f * u), state_x,
                   state_y, ui_words(frame, TEXT_OUT));
    } else if (state->lost) {
        const uint32_t colour = ui_fade(0xff9a80ffu, 0.4f + 0.6f * ui_pulse(frame->time_s, 1.0f));
        ui_text_at(frame, ui_style(frame, FONT_STALL, 40.0f, 0.5f, colour, 0.0f), state_x, state_y,
                   "?");
    } else {
        ui_poi_sign(frame, state_x, state_y - 5.0f * u, 14.0f * u,
                    frame->scene->poi[player].paper_left, ui_player_colours[player]);
    }
    if (shows_level) {
        ui_level_tag(frame,
                     (struct ui_box){ box.x + box.width - 85.0f * u, box.y + 6.0f * u, 34.0f * u,
                                      box.height - 12.0f * u },
                     state->level);
    }
    if (counts_fouls) {
        ui_foul_lamps(frame, box.x + 28.0f * u, box.y + box.height - 15.0f * u, 7.0f * u, 20.0f * u,
                      state->fouls);
    }
    return (struct ui_point){ .x = box.x + 76.0f * u, .y = y };
}

float ui_player_plates(const struct ui_frame *frame, float right_px)
{
    const struct scene *const scene = frame->scene;
    const float gap = 8.0f * frame->unit, edge = 18.0f * frame->unit;
    const float count = (float)ui_player_count(scene);
    const float beside = frame->width - 2.0f * edge - right_px - gap;
    const bool fits = count * (PLATE_WIDTH_MIN * frame->unit + gap) <= beside;
    const float room = (fits ? beside : frame->width - 2.0f * edge) / count - gap;
    /* If the row has free space, the plates are enlarged, at most to the size of a single player's
     * plate. */
    struct ui_frame larger = *frame;
    larger.unit *= fminf(fmaxf(room / (PLATE_WIDTH * frame->unit), 1.0f), fits ? 1.2f : 1.0f);
    struct ui_box box = { edge, (fits ? 16.0f : 110.0f) * frame->unit,
                          fminf(room, PLATE_WIDTH * larger.unit),
                          (rules_of(scene->mode)->counts_fouls ? 74.0f : 58.0f) * larger.unit };
    struct ui_point counters[POI_MAX] = { 0 };
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->player[i].plays) {
            counters[i] = plate(&larger, i, box);
            box.x += box.width + gap;
        }
    }
    for (uint32_t i = 0; i < POI_MAX; i++) { /* Tags fly in front of all plates. */
        ui_catch_flights(&larger, i, counters[i]);
    }
    return box.y + box.height;
}

void ui_bowl_marks(const struct ui_frame *frame, float alpha)
{
    const struct scene *const scene = frame->scene;
    const float radius = 24.0f * frame->unit, edge = radius + 4.0f * frame->unit;
    for (uint32_t i = 0; i < POI_MAX && ui_bowl_count(scene) > 1u; i++) {
        const bool is_wanted = scene->phase == PHASE_READY || scene->player[i].plays;
        if (is_wanted && scene->bowl[i].present) {
            const struct ui_point at = ui_project(frame, scene->bowl[i].position_m);
            frame->batch->opacity = alpha;
            ui_player_mark(frame, fminf(fmaxf(at.x, edge), frame->width - edge),
                           fminf(fmaxf(at.y, edge), frame->height - edge), radius, i);
        }
    }
    frame->batch->opacity = 1.0f;
}

void ui_handle_marks(const struct ui_frame *frame)
{
    const float radius = 16.5f * frame->unit, edge = radius + 2.0f * frame->unit;
    for (uint32_t i = 0; i < POI_MAX && ui_player_count(frame->scene) > 1u; i++) {
        const struct scene_poi *const poi = &frame->scene->poi[i];
        if (frame->scene->player[i].plays && poi->present) {
            const struct basis axes = scene_handle_axes(poi);
            const struct ui_point at = ui_project(
                frame, v3_muladd(poi->position_m, axes.back, HANDLE_AT * poi->ring_radius_m));
            ui_player_mark(frame, fminf(fmaxf(at.x, edge), frame->width - edge),
                           fminf(fmaxf(at.y, edge), frame->height - edge), radius, i);
        }
    }
}
