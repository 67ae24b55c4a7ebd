/* morph_frames.c -- writes the frames of a growing fish, one picture for each moment. The fish has
 * the same scale and position in each picture. */
#include <stdio.h>
#include <string.h>

#include "platform/ctl/lib/caption.h"
#include "platform/ctl/morph/morph_sheet.h"
#include "platform/ctl/morph/morph_sheet_internal.h"
#include "platform/os/file.h"

#define FRAME_MARGIN 48.0f

/* Fish that is being drawn. The variable is static because it is too large for a stack. */
static struct fish_preview portrait;

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
    canvas_fill(canvas, (struct canvas_box){ 0.0f, 0.0f, width, height }, MORPH_SHEET_WATER_ABOVE,
                MORPH_SHEET_WATER_BELOW);
    fish_preview_draw(&portrait, view, morph_sheet_middle(b->left, b->right),
                      morph_sheet_middle(b->low, b->high), scale_px, raster);
    const bool whole = raster_finish(raster, canvas, 0, 0);
    caption_age(age, life_age_days(card, progress));
    caption_length(length, length_m);
    caption_name(name, card->id);
    snprintf(words, sizeof words, "%s, %s, %s %s", name, age, caption_measure(card), length);
    canvas_words(canvas, FRAME_MARGIN, height - 36.0f, 30.0f, ALIGN_LEFT, CAPTION_INK, words);
    caption_bar(canvas, 0.82f * width, height - 62.0f, 0.25f * width, scale_px / length_m, 26.0f);
    return whole;
}

static enum exit_code write_frame(const struct canvas *canvas, const struct morph_options *pick,
                                  const char *folder, uint32_t index)
{
    char path[FILE_FOLDER_MAX + 64];
    snprintf(path, sizeof path, "%s/%s_%04u.png", folder, pick->fish->card.id, index);
    return morph_sheet_write_picture(canvas, path);
}

enum exit_code morph_frames_write(const struct morph_options *pick, enum fish_preview_view view,
                                  uint32_t count, const char *folder)
{
    struct fish_preview_bounds bounds[VIEW_COUNT];
    struct canvas canvas = { 0 };
    struct raster raster = { 0 };
    const int error = file_make_folder(folder);
    if (error) {
        return morph_fail(EXIT_IO, "export", "%.900s: %s", folder, strerror(-error));
    }
    morph_sheet_measure(&portrait, pick, bounds);
    enum exit_code code = EXIT_OK;
    if (!canvas_open(&canvas, FRAME_WIDTH, FRAME_HEIGHT) ||
        !raster_open(&raster, FRAME_WIDTH, FRAME_HEIGHT)) {
        code = morph_sheet_no_memory();
    }
    for (uint32_t i = 0; code == EXIT_OK && i < count; i++) {
        const float progress = (float)i / (float)(count - 1u);
        const bool whole = draw_frame(pick, &canvas, &raster, view, &bounds[view], progress);
        code = whole ? write_frame(&canvas, pick, folder, i) : morph_sheet_no_memory();
    }
    raster_close(&raster);
    canvas_close(&canvas);
    return code;
}
