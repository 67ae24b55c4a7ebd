/* morph_sheet.c -- writes pictures of a growing fish: the contact sheet of its life, and
 * sequences of single frames. */
#include "platform/ctl/morph/morph_export.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/caption.h"
#include "platform/os/file.h"

#define PAGE_WIDTH 2400.0f
#define MARGIN 48.0f
#define HEAD_HEIGHT 132.0f
/* Share of the width of a cell that the fish fills at its greatest extent. */
#define CELL_FILL 0.86f
#define GAP 14.0f /* Space above and below a fish in pixels. */
/* Maximum number of keys in a row. Further keys are drawn in further rows, so that each key is
 * large enough to be examined. */
#define KEY_COLUMNS_MAX 4u
#define KEY_WORDS_PX 24.0f
#define BETWEEN_WORDS_PX 15.0f

#define PAPER 0xf2f1ecu
/* Background colours at the top and at the bottom of a picture. The colours are dark enough to show
 * transparent larvae and light enough to show black eels. */
#define WATER_ABOVE 0xa7c4cbu
#define WATER_BELOW 0x6d94a1u

/* Fish that is being drawn. The variable is static because it is too large for a stack. */
static struct fish_preview portrait;

/* Layout of all cells that have the same width. */
struct layout {
    uint32_t columns;
    float cell_width, scale_px, words_px;
    float band_height[VIEW_COUNT], water_height, height;
};

struct page {
    const struct morph_options *pick;
    struct canvas canvas;
    struct fish_preview_bounds bounds[VIEW_COUNT]; /* Bounds of the fish in each view, over all
                                                      stages. */
    struct layout keys, betweens;
    bool failed;
};

/* ---- Parts that sheets and frames share ------------------------------------------------------ */

#define MEASURE_STEPS 20u /* Number of steps over the life at which the bounds are measured. */

static const char command[] = "export";

static enum exit_code sheet_no_memory(void)
{
    return morph_fail(EXIT_IO, command, "%s", strerror(ENOMEM));
}

static void sheet_measure(const struct morph_options *pick,
                          struct fish_preview_bounds bounds[VIEW_COUNT])
{
    for (uint32_t view = 0; view < VIEW_COUNT; view++) {
        bounds[view] = fish_preview_nowhere;
    }
    for (uint32_t i = 0; i <= MEASURE_STEPS; i++) {
        fish_preview_pose(&portrait, pick->fish, &pick->rig, (float)i / (float)MEASURE_STEPS);
        for (uint32_t view = 0; view < VIEW_COUNT; view++) {
            fish_preview_measure(&portrait, (enum fish_preview_view)view, &bounds[view]);
        }
    }
}

/* Draws the portrait into `raster`. The middle of the bounds is at the middle of the raster. */
static void draw_portrait(enum fish_preview_view view, const struct fish_preview_bounds *b,
                          float scale_px, struct raster *raster)
{
    fish_preview_draw(&portrait, view, 0.5f * (b->left + b->right), 0.5f * (b->low + b->high),
                      scale_px, raster);
}

/* ---- Layout of the page ---------------------------------------------------------------------- */

static struct layout plan_sheet_layout(const struct page *page, uint32_t columns, float words_px)
{
    struct layout layout = { .columns = columns,
                             .cell_width = (PAGE_WIDTH - 2.0f * MARGIN) / (float)columns,
                             .words_px = words_px };
    /* `most` becomes the greatest extent of the fish in all views. The height is included, because
     * an imported fish may be higher than it is long. */
    float most = 0.0f;
    for (uint32_t view = 0; view < VIEW_COUNT; view++) {
        const struct fish_preview_bounds *b = &page->bounds[view];
        most = f_max(most, f_max(b->right - b->left, b->high - b->low));
    }
    layout.scale_px = layout.cell_width * CELL_FILL / most;
    for (uint32_t view = 0; view < VIEW_COUNT; view++) {
        layout.band_height[view] =
            (page->bounds[view].high - page->bounds[view].low) * layout.scale_px + 2.0f * GAP;
        layout.water_height += layout.band_height[view];
    }
    layout.height = layout.water_height + 6.2f * words_px + GAP;
    return layout;
}

static void draw_words(struct page *page, const struct layout *layout, float x, float y,
                       const char *title, float progress)
{
    const struct species_card *card = &page->pick->fish->card;
    const float length_m = life_length_m(card, progress), size = layout->words_px;
    char name[CAPTION_WORDS_SIZE], age[CAPTION_WORDS_SIZE], length[CAPTION_WORDS_SIZE];
    char words[2 * CAPTION_WORDS_SIZE + 8];
    float weights[MORPH_KEY_MAX];
    graph_weights(&page->pick->rig.curves[0], card->key_count, progress, weights);
    caption_weights(&page->canvas,
                    (struct canvas_box){ x - 0.43f * layout->cell_width, y + 0.5f * size,
                                         0.86f * layout->cell_width, 0.3f * size },
                    card->key_count, weights);
    caption_bar(&page->canvas, x, y + 1.6f * size, 0.4f * layout->cell_width,
                layout->scale_px / length_m, size);
    caption_age(age, life_age_days(card, progress));
    caption_length(length, length_m);
    caption_name(name, title);
    snprintf(words, sizeof words, "%s%s%s", name, title[0] ? ": " : "", age);
    canvas_words(&page->canvas, x, y + 4.3f * size, size, ALIGN_CENTRE, CAPTION_INK, words);
    snprintf(words, sizeof words, "%s %s", caption_measure(card), length);
    canvas_words(&page->canvas, x, y + 5.6f * size, size, ALIGN_CENTRE, CAPTION_SOFT_INK, words);
}

/* Draws one column of the sheet, which shows one stage of the growth. The three views of the fish
 * are drawn over the painted water, and the texts are drawn under the water's lower edge. */
static void draw_stage(struct page *page, const struct layout *layout, uint32_t column, float top,
                       const char *title, float progress)
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    const float left = MARGIN + (float)column * layout->cell_width;
    float y = top;
    fish_preview_pose(&portrait, page->pick->fish, &page->pick->rig, progress);
    for (uint32_t view = 0; view < VIEW_COUNT; view++) {
        /* A raster starts at a whole pixel, so the remaining fraction of a pixel is applied inside
         * the raster. */
        struct raster raster;
        if (!raster_open(&raster, (uint32_t)layout->cell_width,
                         (uint32_t)layout->band_height[view])) {
            page->failed = true;
        } else {
            draw_portrait((enum fish_preview_view)view, &page->bounds[view], layout->scale_px,
                          &raster);
            page->failed |= !raster_finish(&raster, &page->canvas, (uint32_t)left, (uint32_t)y);
        }
        raster_close(&raster);
        y += layout->band_height[view];
    }
    draw_words(page, layout, left + 0.5f * layout->cell_width, top + layout->water_height, title,
               progress);
}

static void draw_water(struct page *page, const struct layout *layout, float top, uint32_t columns)
{
    const struct canvas_box water = { MARGIN, top, (float)columns * layout->cell_width,
                                      layout->water_height };
    canvas_fill(&page->canvas, water, WATER_ABOVE, WATER_BELOW);
}

static void draw_head(struct page *page)
{
    const struct species_card *card = &page->pick->fish->card;
    char from[CAPTION_WORDS_SIZE], to[CAPTION_WORDS_SIZE], words[256];
    caption_name(words, card->id);
    canvas_words(&page->canvas, MARGIN, 70.0f, 54.0f, ALIGN_LEFT, CAPTION_INK, words);
    caption_length(from, card->key_length_m[0]);
    caption_length(to, card->key_length_m[card->key_count - 1u]);
    snprintf(words, sizeof words, "%u keys, %s %s to %s, curves: %s%s", card->key_count,
             caption_measure(card), from, to, morph_template_name(page->pick->template_id),
             page->pick->thesis ? ", the 2005 thesis' own method" : "");
    canvas_words(&page->canvas, MARGIN, 108.0f, 24.0f, ALIGN_LEFT, CAPTION_SOFT_INK, words);
    canvas_words(&page->canvas, PAGE_WIDTH - MARGIN, 108.0f, 20.0f, ALIGN_RIGHT, CAPTION_SOFT_INK,
                 "from its left, from above, aslant");
}

enum exit_code morph_sheet_write(const struct morph_options *pick, const char *path)
{
    CORE_ASSERT(pick->fish->card.key_count >= 2);
    struct page page = { .pick = pick };
    const struct species_card *card = &pick->fish->card;
    const uint32_t strips = card->key_count - 1u;
    const uint32_t rows = (card->key_count + KEY_COLUMNS_MAX - 1u) / KEY_COLUMNS_MAX;
    sheet_measure(pick, page.bounds);
    page.keys = plan_sheet_layout(&page, (card->key_count + rows - 1u) / rows, KEY_WORDS_PX);
    page.betweens = plan_sheet_layout(&page, MORPH_SHEET_BETWEEN, BETWEEN_WORDS_PX);
    const float height = HEAD_HEIGHT + (float)rows * page.keys.height +
                         (float)strips * (page.betweens.height + MARGIN) + MARGIN;
    if (!canvas_open(&page.canvas, (uint32_t)PAGE_WIDTH, (uint32_t)height)) {
        return sheet_no_memory();
    }
    const struct canvas_box paper = { 0.0f, 0.0f, (float)page.canvas.width,
                                      (float)page.canvas.height };
    float top = HEAD_HEIGHT;
    canvas_fill(&page.canvas, paper, PAPER, PAPER);
    draw_head(&page);
    for (uint32_t i = 0; i < card->key_count; i++) {
        const float down = (float)(i / page.keys.columns) * page.keys.height;
        const uint32_t left = card->key_count - i;
        if (i % page.keys.columns == 0) {
            draw_water(&page, &page.keys, top + down,
                       left < page.keys.columns ? left : page.keys.columns);
        }
        draw_stage(&page, &page.keys, i % page.keys.columns, top + down, card->key_names[i],
                   (float)i / (float)(card->key_count - 1u));
    }
    top += (float)rows * page.keys.height + MARGIN;
    for (uint32_t i = 0; i < strips; i++) {
        const float steps = (float)(MORPH_SHEET_BETWEEN + 1u);
        char first[CAPTION_WORDS_SIZE], second[CAPTION_WORDS_SIZE],
            words[2 * CAPTION_WORDS_SIZE + 8];
        caption_name(first, card->key_names[i]);
        caption_name(second, card->key_names[i + 1u]);
        snprintf(words, sizeof words, "%s to %s", first, second);
        canvas_words(&page.canvas, MARGIN, top - 8.0f, 20.0f, ALIGN_LEFT, CAPTION_INK, words);
        draw_water(&page, &page.betweens, top, MORPH_SHEET_BETWEEN);
        for (uint32_t stage = 0; stage < MORPH_SHEET_BETWEEN; stage++) {
            const float at = (float)i + (float)(stage + 1u) / steps;
            draw_stage(&page, &page.betweens, stage, top, "", at / (float)(card->key_count - 1u));
        }
        top += page.betweens.height + MARGIN;
    }
    const enum exit_code code =
        page.failed ? sheet_no_memory()
                    : morph_written(command, path, canvas_write_png(&page.canvas, path));
    canvas_close(&page.canvas);
    return code;
}

/* ---- Frames of a growing fish ---------------------------------------------------------------- */

/* This section writes the frames of a growing fish, one picture for each moment. The fish has
 * the same scale and position in each picture. */

#define FRAME_MARGIN 48.0f

static bool draw_frame(const struct morph_options *pick, struct canvas *canvas,
                       struct raster *raster, enum fish_preview_view view,
                       const struct fish_preview_bounds *b, float progress)
{
    const struct species_card *card = &pick->fish->card;
    const float width = (float)FRAME_WIDTH, height = (float)FRAME_HEIGHT;
    const float scale_px =
        f_min(0.9f * width / (b->right - b->left), 0.72f * height / (b->high - b->low));
    const float length_m = life_length_m(card, progress);
    char name[CAPTION_WORDS_SIZE], age[CAPTION_WORDS_SIZE], length[CAPTION_WORDS_SIZE];
    char words[4 * CAPTION_WORDS_SIZE];
    fish_preview_pose(&portrait, pick->fish, &pick->rig, progress);
    canvas_fill(canvas, (struct canvas_box){ 0.0f, 0.0f, width, height }, WATER_ABOVE, WATER_BELOW);
    draw_portrait(view, b, scale_px, raster);
    const bool whole = raster_finish(raster, canvas, 0, 0);
    caption_age(age, life_age_days(card, progress));
    caption_length(length, length_m);
    caption_name(name, card->id);
    snprintf(words, sizeof words, "%s, %s, %s %s", name, age, caption_measure(card), length);
    canvas_words(canvas, FRAME_MARGIN, height - 36.0f, 30.0f, ALIGN_LEFT, CAPTION_INK, words);
    caption_bar(canvas, 0.82f * width, height - 62.0f, 0.25f * width, scale_px / length_m, 26.0f);
    return whole;
}

enum exit_code morph_frames_write(const struct morph_options *pick, enum fish_preview_view view,
                                  uint32_t count, const char *folder)
{
    CORE_ASSERT(count >= 2);
    CORE_ASSERT(view < VIEW_COUNT);
    struct fish_preview_bounds bounds[VIEW_COUNT];
    struct canvas canvas = { 0 };
    struct raster raster = { 0 };
    const int error = file_make_folder(folder);
    if (error) {
        return morph_written(command, folder, error);
    }
    sheet_measure(pick, bounds);
    enum exit_code code = EXIT_OK;
    if (!canvas_open(&canvas, FRAME_WIDTH, FRAME_HEIGHT) ||
        !raster_open(&raster, FRAME_WIDTH, FRAME_HEIGHT)) {
        code = sheet_no_memory();
    }
    for (uint32_t i = 0; code == EXIT_OK && i < count; i++) {
        const float progress = (float)i / (float)(count - 1u);
        const bool whole = draw_frame(pick, &canvas, &raster, view, &bounds[view], progress);
        char path[FILE_FOLDER_MAX + 64];
        snprintf(path, sizeof path, "%s/%s_%04u.png", folder, pick->fish->card.id, i);
        code = whole ? morph_written(command, path, canvas_write_png(&canvas, path))
                     : sheet_no_memory();
    }
    raster_close(&raster);
    canvas_close(&canvas);
    return code;
}
