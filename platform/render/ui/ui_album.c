/* ui_album.c -- draws the album of caught fish: a page of pictures. Each picture is a small
 * aquarium that shows how a fish grows up. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/render/textures.h"
#include "platform/render/ui/lab/ui_lab.h"
#include "platform/render/ui/ui_widgets.h"

#define TAU 6.28318531f
#define SEAL_SIZE 22.0f
/* Length on the screen of the newly hatched fish, as a fraction of the full-grown fish's length in
 * the picture. */
#define YOUNG_SIZE 0.40f

/* ---- Layout of the pictures ----------------------------------------------------------------- */

struct album_grid {
    uint32_t columns, rows;
    float left, top, width, height, gap;
};

static struct album_grid grid_of(const struct ui_frame *frame, uint32_t count)
{
    CORE_ASSERT(count > 0);
    const float u = frame->unit;
    const bool is_upright = frame->height > 1.2f * frame->width;
    struct album_grid grid = { .columns = is_upright   ? (count > 3u ? 2u : 1u)
                                          : count > 3u ? 3u
                                                       : count,
                               .gap = 18.0f * u };
    grid.rows = (count + grid.columns - 1u) / grid.columns;
    const float top = 118.0f * u, foot = 108.0f * u;
    const float wide = frame->width - 48.0f * u, high = frame->height - top - foot;
    grid.width = (wide - grid.gap * (float)(grid.columns - 1u)) / (float)grid.columns;
    grid.height = (high - grid.gap * (float)(grid.rows - 1u)) / (float)grid.rows;
    grid.width = fminf(grid.width, 1.9f * grid.height);
    grid.height = fminf(grid.height, 1.1f * grid.width);
    const float used = (float)grid.rows * (grid.height + grid.gap) - grid.gap;
    grid.top = top + 0.5f * (high - used);
    grid.left = 0.5f * (frame->width - ((float)grid.columns * (grid.width + grid.gap) - grid.gap));
    return grid;
}

/* ---- Picture of one fish -------------------------------------------------------------------- */

/* Draws the fish in its aquarium, at the age that the animation of its life has reached
 * (fish->progress). */
static void draw_album_fish(const struct ui_frame *frame, const struct scene_grown *fish, float t,
                            struct ui_box water)
{
    /* `whole` is the progress through life at which the fish's adult pattern is complete. Normally
     * the pattern is complete at the second to last key (modelled growth stage). If the fish was
     * caught at a younger age, the pattern is complete on the day of the catch. */
    const struct species_card *const card = &species_wakin.card;
    const float key = 1.0f / ((float)card->key_count - 1.0f);
    const float whole = fminf(1.0f - key, life_progress(card, fish->caught_age_days));
    struct specimen specimen = { .species = textures_variety(fish->look),
                                 .progress = fish->progress,
                                 .look = fish->look,
                                 .ripe = f_smoothstep(whole - key, whole, fish->progress),
                                 .maturity = fish->maturity };
    specimen_portrait(&specimen);
    const float high = water.height - 2.3f * SEAL_SIZE * frame->unit;
    specimen_fit(&specimen, water.x + 0.05f * water.width, water.y + 0.06f * high,
                 0.90f * water.width, 0.88f * high);
    specimen.length_px *= YOUNG_SIZE + (1.0f - YOUNG_SIZE) * fish->progress;
    specimen.y_px += 0.015f * high * sinf(0.9f * t);
    specimen.yaw_rad += 0.15f * sinf(0.6f * t);
    specimen.phase_rad = fmodf(TAU * 1.2f * t, TAU);
    specimen.amplitude = 0.8f;
    ui_specimen(frame->batch, &specimen);
}

/* Draws the sign of a present: a ribbon across the upper part of the picture, and a bow. */
static void draw_album_bow(const struct ui_frame *frame, struct ui_box box)
{
    const float width = fminf(0.24f * box.width, 0.30f * box.height);
    const struct ui_box band = { box.x, box.y + 0.24f * width, box.width, 0.16f * width };
    ui_panel(frame, UI_PANEL, band, 0.0f, 0.02f * width, UI_VERMILION, UI_WASHI_WHITE);
    ui_bow(frame, box.x + 0.86f * box.width, band.y + 0.5f * band.height, width);
}

static void draw_album_picture(const struct ui_frame *frame, uint32_t index, struct ui_box box)
{
    CORE_ASSERT(index < frame->scene->album.fish_count);
    const float u = frame->unit;
    const struct scene_grown *const fish = &frame->scene->album.fish[index];
    char age[TEXT_LINE_MAX], length[32], words[3u * TEXT_LINE_MAX];
    const struct ui_box shade = { box.x + 3.0f * u, box.y + 6.0f * u, box.width, box.height };
    const struct ui_box water = { box.x + 10.0f * u, box.y + 10.0f * u, box.width - 20.0f * u,
                                  box.height - 82.0f * u };
    ui_panel(frame, UI_PANEL, shade, 10.0f * u, 0.0f, 0x04061880u, 0);
    ui_panel(frame, UI_WASHI, box, 10.0f * u, 2.0f * u, LAB_PAPER, LAB_PAPER_LINE);
    ui_water(frame, water, 6.0f * u, frame->time_s + (float)index, 0x06243cffu);
    draw_album_fish(frame, fish, frame->time_s + 0.7f * (float)index, water);
    if (fish->is_caught) {
        /* The ribbon with the age and length at the catch appears when the animation of the fish's
         * life reaches the day of the catch. */
        const float size = SEAL_SIZE * u;
        lab_age_words(frame->language, fish->caught_age_days, age, sizeof age);
        lab_length_words(fish->caught_length_m, length, sizeof length);
        snprintf(words, sizeof words, "%s %s  %s",
                 ui_words(frame, fish->is_present ? TEXT_ALBUM_GIVEN : TEXT_ALBUM_MET), age,
                 length);
        const uint32_t fill = fish->is_present ? 0x17754ee8u : 0xc92c1ce8u;
        ui_ribbon_at(frame, (struct ui_ribbon){ FONT_BODY, fill, 0xfff1ddb0u, 0xfff1ddffu },
                     water.x + 0.5f * water.width, water.y + water.height - 1.15f * size, size,
                     box.width - 8.0f * u, words);
    }
    if (fish->is_present) {
        draw_album_bow(frame, box);
    }
    lab_age_words(frame->language, fish->age_days, age, sizeof age);
    lab_length_words(fish->length_m, length, sizeof length);
    snprintf(words, sizeof words, "%s   %s", age, length);
    ui_text(frame->batch, ui_style(frame, FONT_STALL, 27.0f, 0.5f, LAB_INK, box.width - 28.0f * u),
            box.x + 0.5f * box.width, box.y + box.height - 40.0f * u, words);
    /* Draws the fish's lifeline, an axis of its progress through life, with a mark at the day of
     * the catch. */
    const struct ui_box line = { box.x + 22.0f * u, box.y + box.height - 28.0f * u,
                                 box.width - 44.0f * u, 14.0f * u };
    const float met = life_progress(&species_wakin.card, fish->caught_age_days);
    const float y = line.y + 0.5f * line.height;
    const float start[2] = { line.x, y }, end[2] = { line.x + line.width, y };
    const float now[2] = { line.x + line.width * fish->progress, y };
    ui_segment(frame->batch, start, end, 5.0f * u, 0xd9c8a0ffu);
    ui_segment(frame->batch, start, now, 5.0f * u, UI_VERMILION);
    ui_disc(frame, line.x + line.width * met, y, 8.0f * u, 2.5f * u,
            fish->is_caught ? 0xc92c1cffu : UI_CREAM, 0xc92c1cffu);
    if (ui_player_count(frame->scene) > 1u) {
        ui_player_mark(frame, box.x + 32.0f * u, box.y + 32.0f * u, 17.0f * u, fish->owner);
    }
}

/* ---- Whole page of the album ---------------------------------------------------------------- */

void ui_album(const struct ui_frame *frame)
{
    const struct scene_album *const album = &frame->scene->album;
    const struct album_grid grid = grid_of(frame, album->fish_count > 0 ? album->fish_count : 1u);
    const float u = frame->unit, middle = 0.5f * frame->width, room = frame->width - 60.0f * u;
    uint32_t presents = 0;
    for (uint32_t i = 0; i < album->fish_count; i++) {
        presents += album->fish[i].is_present;
    }
    const bool shows_all = album->caught + presents <= album->fish_count;
    char words[TEXT_LINE_MAX];
    ui_veil(frame, 0x171d42ffu);
    ui_panel(frame, UI_WAVES, (struct ui_box){ 0.0f, 0.0f, frame->width, frame->height }, 36.0f * u,
             0.0f, 0x141a3cffu, 0);
    const struct ui_text title = ui_style(frame, FONT_STALL, 42.0f, 0.5f, UI_CREAM, room);
    ui_text_at(frame, ui_outlined(title, 0.03f, 0.1f, 0x0a0c24e0u), middle, 48.0f * u,
               ui_words(frame, TEXT_ALBUM));
    const enum text_key title_key = presents == album->fish_count ? TEXT_PRESENT
                                    : shows_all                   ? TEXT_ALBUM_ALL
                                                                  : TEXT_ALBUM_FIRST;
    text_number(words, sizeof words, ui_words(frame, title_key),
                shows_all ? album->caught : album->fish_count - presents);
    ui_text_at(frame, ui_style(frame, FONT_BODY, 22.0f, 0.5f, 0xd6dcf2ffu, room), middle, 92.0f * u,
               words);
    for (uint32_t i = 0; i < album->fish_count; i++) {
        const float start_s = 0.15f * (float)i;
        const float in = f_smoothstep(start_s, start_s + 0.4f, frame->scene->phase_s);
        /* If the last row of pictures is not full, the row is centred. */
        const uint32_t row = i / grid.columns, column = i % grid.columns;
        const uint32_t in_row =
            row + 1u < grid.rows ? grid.columns : album->fish_count - row * grid.columns;
        const float shift = 0.5f * (float)(grid.columns - in_row) * (grid.width + grid.gap);
        struct ui_box box = { grid.left + shift + (float)column * (grid.width + grid.gap),
                              grid.top + (float)row * (grid.height + grid.gap), grid.width,
                              grid.height };
        box.y += 30.0f * u * (1.0f - in);
        frame->batch->opacity = in;
        draw_album_picture(frame, i, box);
        frame->batch->opacity = 1.0f;
    }
    ui_start_ribbon(frame, frame->height - 56.0f * u, TEXT_AGAIN);
}
