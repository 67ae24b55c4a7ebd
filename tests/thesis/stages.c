/* stages.c -- draws the fish pictures of the 2005 thesis with Kingyo's shapes and light.
 *
 * Usage: stages growth|models|sizes|ways SPECIES|FILE OUT.png
 *
 * `growth` draws every key shape and marks the start of its dorsal fin, as figure 3.3 of the
 * thesis.
 *
 * `models` draws the three key shapes of chapter 4 from two sides, as figures 4.1, 4.5, 4.8 and
 * 4.12.
 *
 * `sizes` draws these three shapes at one scale, in the sizes of the real fish that were caught, as
 * figures 4.4 and 4.11.
 *
 * `ways` draws nine stages of growth by three methods (the ordinary morph, the thesis' morph and
 * Kingyo's morph), as figure 4.14. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "platform/ctl/lib/caption.h"
#include "platform/ctl/lib/fish_preview.h"
#include "platform/ctl/morph/morph_options.h"
#include "platform/key_colour.h"
#include "platform/species/part.h"

#define WIDTH 1920.0f
#define MARGIN 40.0f
#define HEAD 96.0f
#define PAPER 0xf2f1ecu
#define WATER_ABOVE 0xd3e4e6u
#define WATER_BELOW 0x9fbfc6u
#define COLUMNS 9u /* Number of growth stages that the command `ways` draws. */
/* Length of the head as a fraction of the body's length. The close views show only the head. */
#define HEAD_SHARE 0.26f

static const char name[] = "stages";

/* A fish in the picture and the box in which the fish is drawn. */
struct spot {
    const struct species *fish;
    const struct morph_rig *rig;
    float progress;
    enum fish_preview_view view;
    struct canvas_box box;
    /* Number of pixels per unit of the fish's shape. The value is equal for all fish of the
     * picture. */
    float scale_px;
};

static struct canvas canvas;
static struct fish_preview portrait;
static bool failed;

/* Draws the fish of `portrait` in the middle of the box, with `scale_px` pixels per unit of its
 * shape. */
static void draw_portrait(enum fish_preview_view view, struct canvas_box box, float scale_px)
{
    struct fish_preview_bounds b = fish_preview_nowhere;
    struct raster raster;
    fish_preview_measure(&portrait, view, &b);
    if (!raster_open(&raster, (uint32_t)box.width, (uint32_t)box.height)) {
        failed = true;
        return;
    }
    fish_preview_draw(&portrait, view, 0.5f * (b.left + b.right), 0.5f * (b.low + b.high), scale_px,
                      &raster);
    failed |= !raster_finish(&raster, &canvas, (uint32_t)box.left, (uint32_t)box.top);
    raster_close(&raster);
}

static void draw_spot(const struct spot *spot)
{
    fish_preview_pose(&portrait, spot->fish, spot->rig, spot->progress);
    draw_portrait(spot->view, spot->box, spot->scale_px);
}

static void fill(float left, float top, float width, float height, uint32_t above, uint32_t below)
{
    canvas_fill(&canvas, (struct canvas_box){ left, top, width, height }, above, below);
}

static bool begin(float height, const char *title, const char *subtitle)
{
    if (!canvas_open(&canvas, (uint32_t)WIDTH, (uint32_t)height)) {
        return false;
    }
    fill(0.0f, 0.0f, WIDTH, height, PAPER, PAPER);
    canvas_words(&canvas, MARGIN, 50.0f, 38.0f, ALIGN_LEFT, CAPTION_INK, title);
    canvas_words(&canvas, MARGIN, 80.0f, 20.0f, ALIGN_LEFT, CAPTION_SOFT_INK, subtitle);
    return true;
}

static void key_words(const struct species_card *card, uint32_t key, float x, float y)
{
    char age[CAPTION_WORDS_SIZE], length[CAPTION_WORDS_SIZE], words[3 * CAPTION_WORDS_SIZE];
    caption_age(age, card->key_age_days[key]);
    snprintf(length, sizeof length, "%.4g mm", 1e3 * (double)card->key_length_m[key]);
    canvas_words(&canvas, x, y, 26.0f, ALIGN_CENTRE, key_colour(card->key_count, key),
                 card->key_names[key]);
    snprintf(words, sizeof words, "%s, %s %s", age, caption_measure(card), length);
    canvas_words(&canvas, x, y + 28.0f, 20.0f, ALIGN_CENTRE, CAPTION_SOFT_INK, words);
}

/* ---- Growth ---------------------------------------------------------------------------------- */

/* Draws a key shape and a vertical line at the start of its dorsal fin. */
static void draw_root(const struct morph_options *pick, uint32_t key, float left, float column,
                      float height)
{
    const struct species_card *card = &pick->drawn->card;
    const struct species_mesh *mesh = &pick->drawn->lod[0];
    const uint32_t root = part_vertex_range(mesh, PART_DORSAL, SIDE_MIDDLE);
    const float scale_px = 0.74f * column;
    struct fish_preview_bounds b = fish_preview_nowhere;
    char words[64];
    portrait = (struct fish_preview){ .species = pick->drawn, .mesh = mesh };
    morph_key_pose(mesh, card->key_count, key, &portrait.pose);
    morph_shape(mesh, card->key_count, &portrait.pose, portrait.positions, portrait.normals);
    fish_preview_measure(&portrait, VIEW_SIDE, &b);
    draw_portrait(VIEW_SIDE, (struct canvas_box){ left, HEAD, column, height }, scale_px);
    key_words(card, key, left + 0.5f * column, HEAD + height + 40.0f);
    if (root == mesh->vertex_count) {
        return;
    }
    const vec3 p = portrait.positions[root];
    const float x = left + 0.5f * column + (p.z - 0.5f * (b.left + b.right)) * scale_px;
    const float y = HEAD + 0.5f * height - (p.y - 0.5f * (b.low + b.high)) * scale_px;
    fill(x - 1.5f, HEAD + 34.0f, 3.0f, y - HEAD - 34.0f, 0xc8371fu, 0xc8371fu);
    fill(x - 5.0f, y - 5.0f, 10.0f, 10.0f, 0xc8371fu, 0xc8371fu);
    snprintf(words, sizeof words, "%.0f %%", 100.0 * (double)(p.z + 0.5f));
    canvas_words(&canvas, x, HEAD + 26.0f, 20.0f, ALIGN_CENTRE, CAPTION_INK, words);
}

static enum exit_code draw_growth(const struct morph_options *pick)
{
    const uint32_t count = pick->drawn->card.key_count;
    const float column = (WIDTH - 2.0f * MARGIN) / (float)count, height = 0.62f * column + 60.0f;
    if (!begin(HEAD + height + 100.0f, pick->drawn->card.id,
               "where the dorsal fin begins, from the snout, in shapes of one size")) {
        return EXIT_IO;
    }
    fill(MARGIN, HEAD, WIDTH - 2.0f * MARGIN, height, WATER_ABOVE, WATER_BELOW);
    for (uint32_t key = 0; key < count; key++) {
        draw_root(pick, key, MARGIN + (float)key * column, column, height);
    }
    return EXIT_OK;
}

/* ---- Input models ---------------------------------------------------------------------------- */

/* Sets `portrait` to the shape that the game blends for key `key`. If the blend weight of the key
 * reaches 1, this is the shape of the species text (the maker's file that describes a species).
 * Otherwise graph_solve() computed an exaggerated shape to compensate for the smaller weight. */
static void take_model(const struct morph_options *pick, uint32_t key)
{
    const struct species_mesh *mesh = &pick->fish->lod[0];
    portrait = (struct fish_preview){ .species = pick->fish, .mesh = mesh };
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        memcpy(portrait.pose.weight[curve], pick->rig.solution[0][key],
               sizeof portrait.pose.weight[curve]);
    }
    morph_shape(mesh, pick->fish->card.key_count, &portrait.pose, portrait.positions,
                portrait.normals);
}

static enum exit_code draw_models(const struct morph_options *pick)
{
    const struct species_card *card = &pick->fish->card;
    const float column = (WIDTH - 2.0f * MARGIN) / 3.0f, scale_px = 0.72f * column;
    const bool solved = pick->rig.curves[0].solved;
    struct fish_preview_bounds b[2] = { fish_preview_nowhere, fish_preview_nowhere };
    for (uint32_t key = 0; key < 3; key++) {
        take_model(pick, key);
        fish_preview_measure(&portrait, VIEW_SIDE, &b[0]);
        fish_preview_measure(&portrait, VIEW_ABOVE, &b[1]);
    }
    const float side = floorf((b[0].high - b[0].low) * scale_px + 60.0f);
    const float above = floorf((b[1].high - b[1].low) * scale_px + 50.0f);
    if (!begin(HEAD + side + above + 110.0f, card->id,
               solved ? "the three input models of chapter 4; the middle one is exaggerated, since "
                        "it never counts for more than 70 %"
                      : "the three input models of chapter 4")) {
        return EXIT_IO;
    }
    fill(MARGIN, HEAD, WIDTH - 2.0f * MARGIN, side + above, WATER_ABOVE, WATER_BELOW);
    for (uint32_t key = 0; key < 3; key++) {
        const float left = MARGIN + (float)key * column;
        take_model(pick, key);
        draw_portrait(VIEW_SIDE, (struct canvas_box){ left, HEAD, column, side }, scale_px);
        draw_portrait(VIEW_ABOVE, (struct canvas_box){ left, HEAD + side, column, above },
                      scale_px);
        key_words(card, key, left + 0.5f * column, HEAD + side + above + 40.0f);
    }
    return EXIT_OK;
}

/* ---- True sizes ------------------------------------------------------------------------------ */

static enum exit_code draw_sizes(const struct morph_options *pick)
{
    const struct species_card *card = &pick->fish->card;
    const float *length_m = card->key_length_m;
    const float sum_m = length_m[0] + length_m[1] + length_m[2];
    const float gap = 70.0f, room = WIDTH - 2.0f * MARGIN - 4.0f * gap;
    /* Leaves 22 % of the width for the tails, because tails extend beyond the standard length. */
    const float px_per_m = 0.78f * room / sum_m;
    const float height = 0.62f * px_per_m * fmaxf(fmaxf(length_m[0], length_m[1]), length_m[2]);
    float left = MARGIN + gap;
    if (!begin(HEAD + height + 130.0f, card->id, "the same three at one scale")) {
        return EXIT_IO;
    }
    fill(MARGIN, HEAD, WIDTH - 2.0f * MARGIN, height, WATER_ABOVE, WATER_BELOW);
    for (uint32_t key = 0; key < 3; key++) {
        const float width = room * length_m[key] / sum_m;
        const struct spot spot = { .fish = pick->fish,
                                   .rig = &pick->rig,
                                   .progress = 0.5f * (float)key,
                                   .view = VIEW_SIDE,
                                   .box = { left, HEAD, width, height },
                                   .scale_px = px_per_m * length_m[key] };
        draw_spot(&spot);
        key_words(card, key, left + 0.5f * width, HEAD + height + 40.0f);
        left += width + gap;
    }
    caption_bar(&canvas, WIDTH - MARGIN - 150.0f, 60.0f, 260.0f, px_per_m, 20.0f);
    return EXIT_OK;
}

/* ---- Three morph methods -------------------------------------------------------------------- */

/* Converts a progress of the thesis' method, which has three keys, to the progress of the complete
 * species, which has more keys. */
static float drawn_progress(const struct species_card *drawn, float progress)
{
    const float place = progress * 2.0f;
    const uint32_t i = place < 1.0f ? 0u : 1u;
    const float from = (float)drawn->thesis_key[i], to = (float)drawn->thesis_key[i + 1u];
    return (from + (to - from) * (place - (float)i)) / (float)(drawn->key_count - 1u);
}

/* Draws the fish so large that its head fills the box. The bounds contain only the head, so the
 * rest of the fish is cut off. */
static void draw_head(const struct spot *spot)
{
    static struct fish_preview head;
    struct fish_preview_bounds b = fish_preview_nowhere;
    struct raster raster;
    fish_preview_pose(&portrait, spot->fish, spot->rig, spot->progress);
    head = portrait;
    for (uint32_t i = 0; i < head.mesh->vertex_count; i++) {
        const struct species_vertex *at = &head.mesh->vertices[i];
        if (at->part != PART_BODY || at->u > HEAD_SHARE) {
            head.positions[i] = v3(0.0f, 0.0f, HEAD_SHARE / 2.0f - 0.5f);
        }
    }
    fish_preview_measure(&head, spot->view, &b);
    if (!raster_open(&raster, (uint32_t)spot->box.width, (uint32_t)spot->box.height)) {
        failed = true;
        return;
    }
    fish_preview_draw(&portrait, spot->view, 0.5f * (b.left + b.right), 0.5f * (b.low + b.high),
                      spot->scale_px, &raster);
    failed |= !raster_finish(&raster, &canvas, (uint32_t)spot->box.left, (uint32_t)spot->box.top);
    raster_close(&raster);
}

static void draw_way(const struct species *fish, const struct morph_rig *rig,
                     const struct species_card *drawn, float top, float height, const char *title)
{
    const float column = (WIDTH - 2.0f * MARGIN) / (float)COLUMNS;
    canvas_words(&canvas, MARGIN, top - 10.0f, 24.0f, ALIGN_LEFT, CAPTION_INK, title);
    fill(MARGIN, top, WIDTH - 2.0f * MARGIN, 3.0f * height, WATER_ABOVE, WATER_BELOW);
    for (uint32_t i = 0; i < COLUMNS; i++) {
        const float progress = (float)i / (float)(COLUMNS - 1u);
        struct spot spot = { .fish = fish,
                             .rig = rig,
                             .view = VIEW_SIDE,
                             .progress = drawn ? drawn_progress(drawn, progress) : progress,
                             .box = { MARGIN + (float)i * column, top, column, height },
                             .scale_px = 0.78f * column };
        draw_spot(&spot);
        spot.scale_px *= 2.4f;
        spot.view = VIEW_ASLANT;
        spot.box.top += height;
        draw_head(&spot);
        spot.view = VIEW_ABOVE;
        spot.box.top += height;
        draw_head(&spot);
    }
}

static enum exit_code draw_ways(const struct morph_options *pick)
{
    const struct species_card *card = &pick->fish->card;
    const float height = 132.0f, row = 3.0f * height + 60.0f;
    struct morph_rig own, ordinary;
    char subtitle[192];
    snprintf(subtitle, sizeof subtitle,
             "from %s over %s to %s: from its left, and its head from aslant and from above",
             card->key_names[0], card->key_names[1], card->key_names[2]);
    if (!begin(HEAD + 3.0f * row + 40.0f, card->id, subtitle)) {
        return EXIT_IO;
    }
    const struct species *straight = morph_options_ordinary(pick, &ordinary);
    morph_rig_init(&own, &pick->drawn->card, TEMPLATE_OWN);
    draw_way(straight, &ordinary, NULL, HEAD + 40.0f, height,
             "the ordinary morph: the first shape to the last, straight (equation 3.1)");
    draw_way(pick->fish, &pick->rig, NULL, HEAD + 40.0f + row, height,
             "the 2005 thesis: three shapes at once, the middle one exaggerated (equation 3.2)");
    draw_way(pick->drawn, &own, &pick->drawn->card, HEAD + 40.0f + 2.0f * row, height,
             "ours: parts with curves of their own that ride on the skin");
    return EXIT_OK;
}

int main(int argc, char **argv)
{
    static struct morph_options pick;
    static const struct {
        const char *word;
        enum exit_code (*draw)(const struct morph_options *pick);
    } kinds[] = { { "growth", draw_growth },
                  { "models", draw_models },
                  { "sizes", draw_sizes },
                  { "ways", draw_ways } };
    if (argc != 4) {
        fputs("usage: stages growth|models|sizes|ways SPECIES|FILE OUT.png\n", stderr);
        return EXIT_USAGE;
    }
    const char *const words[] = { argv[2], "--thesis" };
    enum exit_code code =
        morph_options_read(&pick, name, MORPH_REQUIRES_CURVES, &morph_options_table, 2, words);
    for (size_t i = 0; code == EXIT_OK && i < sizeof kinds / sizeof kinds[0]; i++) {
        if (strcmp(argv[1], kinds[i].word) == 0) {
            code = kinds[i].draw(&pick);
        }
    }
    if (code == EXIT_OK && (failed || canvas_write_png(&canvas, argv[3]) != 0)) {
        fprintf(stderr, "stages: %s cannot be written\n", argv[3]);
        code = EXIT_IO;
    }
    canvas_close(&canvas);
    return (int)code;
}
