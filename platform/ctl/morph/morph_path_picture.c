/* morph_path_picture.c -- draws the path of a part (2005 thesis, figures 3.2 to 3.5 and 4.15).
 *
 * The first window shows the outlines of all keys with the path across them. The second window
 * shows the path enlarged. */
#include <errno.h>
#include <math.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_path.h"

#define SVG_WAY "#c8371f"
/* Distance from the chord, in body lengths, below which a path counts as straight. The value is
 * less than three quantization steps of the mesh tables. */
#define STRAIGHT_LENGTHS 1e-4f

static void draw_way(struct picture *picture, const struct window *window, const vec3 *way,
                     const char *colour, double width, const char *dashes)
{
    svg_begin_line(&picture->svg);
    for (uint32_t i = 0; i <= MORPH_PATH_SAMPLES; i++) {
        double x, y;
        morph_path_place(window, way[i], &x, &y);
        svg_point(&picture->svg, x, y);
    }
    svg_end_line(&picture->svg, colour, width, dashes);
}

/* Draws the region that a blend of three keys can reach. The region is the triangle between the
 * positions in the three solved shapes. */
static void draw_reach(struct picture *picture, const struct window *window)
{
    if (!picture->plan->pick.rig.curves[0].solved ||
        picture->plan->pick.fish->lod[0].anchor_count > 0) {
        return;
    }
    svg_put(&picture->svg,
            "<polygon fill=\"#8a8580\" fill-opacity=\"0.22\" stroke=\"%s\" "
            "points=\"",
            SVG_GREY);
    for (uint32_t key = 0; key < picture->keys.key_count; key++) {
        double x, y;
        morph_path_place(window, morph_path_solved(picture, key), &x, &y);
        svg_point(&picture->svg, x, y);
    }
    svg_put(&picture->svg, "\"/>\n");
}

struct label {
    /* `x` and `y` are the left end of the label's baseline, and `width` is the width of its text.
     * All values are in pixels. */
    double x, y, width;
};

/* Returns a position for a label beside a dot at (`x`, `y`), where the label overlaps no other
 * label. Positions to the right of the dot are tried before positions to the left. */
static struct label free_label(const struct label *taken, uint32_t count, double x, double y,
                               double width)
{
    CORE_ASSERT(count < MORPH_KEY_MAX);
    CORE_ASSERT(width >= 0.0);
    static const double above[6] = { -10.0, 22.0, -10.0, 22.0, -28.0, 40.0 };
    struct label label = { 0 };
    for (uint32_t i = 0; i < 6; i++) {
        bool is_free = true;
        const bool to_left = i == 2 || i == 3;
        label = (struct label){ to_left ? x - 12.0 - width : x + 12.0, y + above[i], width };
        for (uint32_t j = 0; j < count; j++) {
            is_free = is_free && !(fabs(label.y - taken[j].y) < 17.0 &&
                                   label.x < taken[j].x + taken[j].width + 6.0 &&
                                   taken[j].x < label.x + label.width + 6.0);
        }
        if (is_free) {
            break;
        }
    }
    return label;
}

/* Draws a line from the farthest point of the path to the nearest point of the chord, with its
 * length. */
static void draw_bend(struct picture *picture, const struct window *window)
{
    CORE_ASSERT(picture->farthest_lengths >= STRAIGHT_LENGTHS);
    const struct morph_path_plan *plan = picture->plan;
    const vec3 along = v3_sub(plan->chord.to, plan->chord.from);
    const float length = v3_dot(along, along);
    const vec3 there = v3_sub(picture->farthest, plan->chord.from);
    const float share = length > 0.0f ? v3_dot(there, along) / length : 0.0f;
    double x0, y0, x1, y1;
    morph_path_place(window, picture->farthest, &x0, &y0);
    morph_path_place(window, v3_muladd(plan->chord.from, along, share), &x1, &y1);
    svg_line(&picture->svg, x0, y0, x1, y1, SVG_INK, 1.2, NULL);
    svg_text(&picture->svg, x1 + 10.0, y1 + 5.0, 14.0, "start", SVG_INK, "%.4f",
             (double)picture->farthest_lengths);
}

/* Draws a scale bar with a label. The length of the bar is a round share of the body's length. */
static void draw_ruler(struct picture *picture, const struct window *window)
{
    double lengths = 1.0;
    while (lengths * window->length_px > 0.4 * window->width) {
        lengths *= 0.1;
    }
    const double x = window->x + 16.0, y = window->y + window->height - 16.0;
    svg_line(&picture->svg, x, y, x + lengths * window->length_px, y, SVG_INK, 2.0, NULL);
    svg_text(&picture->svg, x, y - 8.0, 13.0, "start", SVG_INK, "%g body length%s", lengths,
             lengths < 1.0 ? "s" : "");
}

static void draw_window(struct picture *picture, const struct window *window, bool enlarged)
{
    const char *id = enlarged ? "lens" : "whole";
    svg_put(&picture->svg,
            "<clipPath id=\"%s\"><rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\"/></clipPath>\n"
            "<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"#ffffff\" stroke=\"%s\"/>\n"
            "<g clip-path=\"url(#%s)\">\n",
            id, window->x, window->y, window->width, window->height, window->x, window->y,
            window->width, window->height, SVG_FAINT, id);
    const struct species *fish = picture->plan->pick.fish;
    for (uint32_t key = 0; key < fish->card.key_count; key++) {
        struct morph_outline outline = morph_path_outline(window);
        outline.species = fish;
        outline.rig = &picture->keys;
        outline.progress = (float)key / (float)(fish->card.key_count - 1u);
        outline.colour = morph_outline_key_colour(&fish->card, key);
        outline.opacity = enlarged ? 0.035 : 0.05;
        outline.line_px = 1.0;
        morph_outline_draw(&picture->svg, &outline);
    }
    draw_reach(picture, window);
    double x0, y0, x1, y1;
    morph_path_place(window, picture->plan->chord.from, &x0, &y0);
    morph_path_place(window, picture->plan->chord.to, &x1, &y1);
    svg_line(&picture->svg, x0, y0, x1, y1, SVG_GREY, 2.0, "7 6");
    if (picture->plan->pick.thesis) {
        draw_way(picture, window, picture->drawn, SVG_INK, 2.0, "1 6");
    }
    draw_way(picture, window, picture->way, SVG_WAY, enlarged ? 4.5 : 2.8, NULL);
    const struct species_card *card = &picture->plan->pick.fish->card;
    for (uint32_t key = 0; key < picture->keys.key_count; key++) {
        double x, y;
        morph_path_place(window, morph_path_key(picture, key), &x, &y);
        svg_dot(&picture->svg, x, y, enlarged ? 7.0 : 4.0, morph_outline_key_colour(card, key),
                SVG_PAPER);
    }
    if (enlarged) {
        struct label taken[MORPH_KEY_MAX];
        char words[SPECIES_NAME_SIZE];
        for (uint32_t key = 0; key < card->key_count; key++) {
            double x, y;
            morph_path_place(window, morph_path_key(picture, key), &x, &y);
            morph_outline_words(words, card->key_names[key]);
            taken[key] = free_label(taken, key, x, y, 8.4 * (double)strlen(words));
            svg_text(&picture->svg, taken[key].x, taken[key].y, 14.0, "start",
                     morph_outline_key_colour(card, key), "%s", words);
        }
    }
    if (enlarged && picture->farthest_lengths >= STRAIGHT_LENGTHS) {
        draw_bend(picture, window);
    }
    if (enlarged) {
        draw_ruler(picture, window);
    }
    svg_put(&picture->svg, "</g>\n");
}

static void draw_words(struct picture *picture, enum morph_outline_view view)
{
    static const char *const seen[] = { "from its left", "from ahead", "from above" };
    const struct morph_path_plan *plan = picture->plan;
    struct svg *svg = &picture->svg;
    char title[SPECIES_NAME_SIZE];
    morph_outline_title(title, plan->pick.fish->card.id);
    svg_text(svg, 50.0, 46.0, 26.0, "start", SVG_INK, "%s: %s", title, plan->part);
    if (picture->farthest_lengths < STRAIGHT_LENGTHS) {
        svg_text(svg, 50.0, 72.0, 14.0, "start", SVG_GREY,
                 "its way as the fish grows, %s: straight", seen[view]);
    } else {
        svg_text(svg, 50.0, 72.0, 14.0, "start", SVG_GREY,
                 "its way as the fish grows, %s; farthest from the straight line at progress %.2f",
                 seen[view], (double)picture->farthest_progress);
    }
    svg_text(svg, 50.0, MORPH_PATH_HEIGHT - 22.0, 13.0, "start", SVG_GREY,
             "Red: its way. Dashed: the ordinary morph's.%s%s",
             plan->pick.thesis ? " Dotted: our own method's." : "",
             plan->pick.rig.curves[0].solved && plan->pick.fish->lod[0].anchor_count == 0
                 ? " Grey: what weights from 0 to 1 can reach."
                 : "");
}

enum exit_code morph_path_picture(const struct morph_path_plan *plan, const char *command)
{
    static struct picture picture;
    picture = (struct picture){ .plan = plan };
    if (plan->view && strcmp(plan->view, "side") != 0 && strcmp(plan->view, "front") != 0 &&
        strcmp(plan->view, "top") != 0) {
        return morph_usage(command, "--view: '%.40s' is not side, front or top", plan->view);
    }
    morph_rig_init(&picture.keys, &plan->pick.fish->card, TEMPLATE_PAIRWISE);
    morph_path_walk(&picture);
    if (!svg_open(&picture.svg, plan->svg, MORPH_PATH_WIDTH, MORPH_PATH_HEIGHT,
                  "The way of a part")) {
        return morph_fail(EXIT_IO, command, "%.200s: %s", plan->svg, strerror(errno));
    }
    static const char *const views[] = { "side", "front", "top" };
    enum morph_outline_view view = morph_path_best_view(&picture);
    for (int i = MORPH_OUTLINE_SIDE; picture.plan->view && i <= MORPH_OUTLINE_TOP; i++) {
        if (strcmp(picture.plan->view, views[i]) == 0) {
            view = (enum morph_outline_view)i;
        }
    }
    const struct window whole = morph_path_whole(&picture, view),
                        lens = morph_path_lens(&picture, view);
    draw_words(&picture, view);
    draw_window(&picture, &whole, false);
    draw_window(&picture, &lens, true);
    if (!svg_close(&picture.svg)) {
        return morph_fail(EXIT_IO, command, "%.200s: %s", plan->svg, strerror(errno));
    }
    return EXIT_OK;
}
