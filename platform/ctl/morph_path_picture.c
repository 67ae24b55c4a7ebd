/* morph_path_picture.c -- a part's way as a picture (2005 thesis, figures 3.2 to 3.5 and 4.15): the
 * keys' outlines over each other with the way across them, and the way again, enlarged. */
#include <errno.h>
#include <math.h>
#include <string.h>

#include "platform/ctl/morph_outline.h"
#include "platform/ctl/morph_path.h"

#define WIDTH 1280.0
#define HEIGHT 640.0
#define SAMPLES 200u
#define LENS 500.0 /* The enlarged square's side. */

/* A frame of the paper, and what of the fish it shows. */
struct window {
    double x, y, width, height; /* Of the frame. */
    double length_px;
    vec3 middle;                /* What is in its middle. */
    enum outline_view view;
};

struct picture {
    const struct path_plan *plan;
    struct svg svg;
    struct morph_rig keys;     /* That reaches every key whole. */
    vec3 way[SAMPLES + 1u];    /* The part's, ... */
    vec3 drawn[SAMPLES + 1u];  /* ... and with --thesis what our own method makes of it. */
    vec3 farthest;             /* From the chord. */
    float farthest_progress, farthest_lengths;
};

/* ---- What is drawn -------------------------------------------------------------------------- */

/* The whole species' progress where the thesis' method has `progress`. */
static float drawn_progress(const struct species_card *drawn, float progress)
{
    const float place = progress * 2.0f;
    const uint32_t i = place < 1.0f ? 0u : 1u;
    const float from = (float)drawn->thesis_key[i], to = (float)drawn->thesis_key[i + 1u];
    return (from + (to - from) * (place - (float)i)) / (float)(drawn->key_count - 1u);
}

static void walk(struct picture *picture)
{
    const struct path_plan *plan = picture->plan;
    const struct morph_pick *pick = &plan->pick;
    struct morph_rig own;
    morph_rig_init(&own, &pick->drawn->card, TEMPLATE_OWN);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        const float progress = (float)i / (float)SAMPLES;
        picture->way[i] = morph_part_place(pick->fish, &pick->rig, plan->vertex, progress);
        if (pick->thesis) {
            picture->drawn[i] = morph_part_place(pick->drawn, &own, plan->vertex,
                                                 drawn_progress(&pick->drawn->card, progress));
        }
        const float far = path_from_chord(plan, picture->way[i]);
        if (far > picture->farthest_lengths) {
            picture->farthest = picture->way[i];
            picture->farthest_lengths = far;
            picture->farthest_progress = progress;
        }
    }
}

static vec3 key_place(const struct picture *picture, uint32_t key)
{
    const struct species *fish = picture->plan->pick.fish;
    return morph_part_place(fish, &picture->keys, picture->plan->vertex,
                            (float)key / (float)(fish->card.key_count - 1u));
}

/* Where the shape solved for `key` has it: beyond the drawing, so that the way passes through the
 * drawing (section 4.2). */
static vec3 solved_place(const struct picture *picture, uint32_t key)
{
    vec3 sum = { 0.0f, 0.0f, 0.0f };
    for (uint32_t j = 0; j < picture->keys.key_count; j++) {
        sum = v3_mad(sum, key_place(picture, j), picture->plan->pick.rig.solution[0][key][j]);
    }
    return sum;
}

/* ---- Where ---------------------------------------------------------------------------------- */

static struct outline outline_in(const struct window *window)
{
    struct outline outline = { .view = window->view, .length_px = window->length_px };
    double x, y;
    outline_project(&outline, window->middle, &x, &y);
    outline.x = window->x + 0.5 * window->width - x;
    outline.y = window->y + 0.5 * window->height - y;
    return outline;
}

static void place_in(const struct window *window, vec3 p, double *x, double *y)
{
    const struct outline outline = outline_in(window);
    outline_project(&outline, p, x, y);
}

/* How far a view shows the way leave its chord. */
static double bend_in(const struct picture *picture, enum outline_view view)
{
    const struct window window = { .length_px = 1.0, .view = view };
    double x0, y0, x1, y1, most = 0.0;
    place_in(&window, picture->plan->from, &x0, &y0);
    place_in(&window, picture->plan->to, &x1, &y1);
    const double length = fmax(hypot(x1 - x0, y1 - y0), 1e-9);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        double x, y;
        place_in(&window, picture->way[i], &x, &y);
        most = fmax(most, fabs((x - x0) * (y1 - y0) - (y - y0) * (x1 - x0)) / length);
    }
    return most;
}

/* From the side, unless another view shows a bend that the side hides. */
static enum outline_view best_view(const struct picture *picture)
{
    const double side = bend_in(picture, OUTLINE_SIDE), front = bend_in(picture, OUTLINE_FRONT);
    const double top = bend_in(picture, OUTLINE_TOP);
    if (side >= 0.6 * fmax(front, top)) {
        return OUTLINE_SIDE;
    }
    return front >= top ? OUTLINE_FRONT : OUTLINE_TOP;
}

/* The window that holds the way, its keys and the solved ones with a margin. */
static struct window lens_on(const struct picture *picture, enum outline_view view)
{
    const struct window flat = { .length_px = 1.0, .view = view };
    const uint32_t keys = picture->keys.key_count;
    double low[2] = { 1e9, 1e9 }, high[2] = { -1e9, -1e9 };
    vec3 least = { 1e9f, 1e9f, 1e9f }, most = { -1e9f, -1e9f, -1e9f };
    for (uint32_t i = 0; i <= SAMPLES + 2u * keys; i++) {
        const vec3 p = i <= SAMPLES           ? picture->way[i]
                       : i <= SAMPLES + keys ? key_place(picture, i - SAMPLES - 1u)
                                             : solved_place(picture, i - SAMPLES - keys - 1u);
        double at[2];
        place_in(&flat, p, &at[0], &at[1]);
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = fmin(low[axis], at[axis]);
            high[axis] = fmax(high[axis], at[axis]);
        }
        least = v3(f_min(least.x, p.x), f_min(least.y, p.y), f_min(least.z, p.z));
        most = v3(f_max(most.x, p.x), f_max(most.y, p.y), f_max(most.z, p.z));
    }
    const double span = fmax(fmax(high[0] - low[0], high[1] - low[1]), 0.01);
    return (struct window){ .x = WIDTH - LENS - 50.0, .y = 90.0, .width = LENS, .height = LENS,
                            .length_px = LENS / (1.45 * span),
                            .middle = v3_scale(v3_add(least, most), 0.5f), .view = view };
}

/* ---- Drawing -------------------------------------------------------------------------------- */

static void draw_fish(struct picture *picture, const struct window *window, double opacity)
{
    const struct species *fish = picture->plan->pick.fish;
    for (uint32_t key = 0; key < fish->card.key_count; key++) {
        struct outline outline = outline_in(window);
        outline.species = fish;
        outline.rig = &picture->keys;
        outline.progress = (float)key / (float)(fish->card.key_count - 1u);
        outline.colour = morph_key_colours[key];
        outline.opacity = opacity;
        outline_draw(&picture->svg, &outline);
    }
}

static void draw_way(struct picture *picture, const struct window *window, const vec3 *way,
                     const char *colour, double width, const char *dashes)
{
    svg_begin_line(&picture->svg);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        double x, y;
        place_in(window, way[i], &x, &y);
        svg_point(&picture->svg, x, y);
    }
    svg_end_line(&picture->svg, colour, width, dashes);
}

static void draw_chord(struct picture *picture, const struct window *window)
{
    double x0, y0, x1, y1;
    place_in(window, picture->plan->from, &x0, &y0);
    place_in(window, picture->plan->to, &x1, &y1);
    svg_line(&picture->svg, x0, y0, x1, y1, SVG_GREY, 2.0, "7 6");
}

/* What three keys can reach: the triangle between their (solved) shapes. */
static void draw_reach(struct picture *picture, const struct window *window)
{
    if (!picture->plan->pick.rig.curves[0].solved ||
        picture->plan->pick.fish->lod[0].anchor_count > 0) {
        return;
    }
    svg_put(&picture->svg, "<polygon fill=\"#8a8580\" fill-opacity=\"0.22\" stroke=\"%s\" "
                           "points=\"", SVG_GREY);
    for (uint32_t key = 0; key < picture->keys.key_count; key++) {
        double x, y;
        place_in(window, solved_place(picture, key), &x, &y);
        svg_point(&picture->svg, x, y);
    }
    svg_put(&picture->svg, "\"/>\n");
}

static void draw_keys(struct picture *picture, const struct window *window, double radius,
                      bool named)
{
    const struct species_card *card = &picture->plan->pick.fish->card;
    for (uint32_t key = 0; key < card->key_count; key++) {
        double x, y;
        place_in(window, key_place(picture, key), &x, &y);
        svg_dot(&picture->svg, x, y, radius, morph_key_colours[key], SVG_PAPER);
        if (named) {
            svg_text(&picture->svg, x + 12.0, y - 10.0, 14.0, "start", morph_key_colours[key],
                     "%s", card->key_names[key]);
        }
    }
}

/* The farthest point's distance from the chord, as a line to where it is nearest. */
static void draw_bend(struct picture *picture, const struct window *window)
{
    const struct path_plan *plan = picture->plan;
    const vec3 along = v3_sub(plan->to, plan->from);
    const float length = v3_dot(along, along);
    const vec3 there = v3_sub(picture->farthest, plan->from);
    const float share = length > 0.0f ? v3_dot(there, along) / length : 0.0f;
    double x0, y0, x1, y1;
    place_in(window, picture->farthest, &x0, &y0);
    place_in(window, v3_mad(plan->from, along, share), &x1, &y1);
    svg_line(&picture->svg, x0, y0, x1, y1, SVG_INK, 1.2, NULL);
    svg_text(&picture->svg, x1 + 10.0, y1 + 5.0, 14.0, "start", SVG_INK,
             "%.4f", (double)picture->farthest_lengths);
}

static void draw_frame(struct picture *picture, const struct window *window, const char *id)
{
    svg_put(&picture->svg,
            "<clipPath id=\"%s\"><rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\"/></clipPath>\n"
            "<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"#ffffff\" stroke=\"%s\"/>\n"
            "<g clip-path=\"url(#%s)\">\n",
            id, window->x, window->y, window->width, window->height, window->x, window->y,
            window->width, window->height, SVG_FAINT, id);
}

/* A round share of the body's length, drawn beside how long it is. */
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
    draw_frame(picture, window, enlarged ? "lens" : "whole");
    draw_fish(picture, window, enlarged ? 0.12 : 0.16);
    draw_reach(picture, window);
    draw_chord(picture, window);
    if (picture->plan->pick.thesis) {
        draw_way(picture, window, picture->drawn, SVG_INK, 2.0, "1 6");
    }
    draw_way(picture, window, picture->way, "#d7382b", enlarged ? 4.0 : 2.5, NULL);
    draw_keys(picture, window, enlarged ? 7.0 : 4.0, enlarged);
    if (enlarged) {
        draw_bend(picture, window);
        draw_ruler(picture, window);
    }
    svg_put(&picture->svg, "</g>\n");
}

static void draw_words(struct picture *picture, enum outline_view view)
{
    static const char *const seen[] = { "from its left", "from ahead", "from above" };
    const struct path_plan *plan = picture->plan;
    const char *id = plan->pick.fish->card.id;
    struct svg *svg = &picture->svg;
    svg_text(svg, 50.0, 46.0, 26.0, "start", SVG_INK, "%c%s: %s", id[0] - 32, id + 1, plan->part);
    svg_text(svg, 50.0, 72.0, 14.0, "start", SVG_GREY,
             "its way as the fish grows, %s; farthest from the straight line at progress %.2f",
             seen[view], (double)picture->farthest_progress);
    svg_text(svg, 50.0, HEIGHT - 22.0, 13.0, "start", SVG_GREY,
             "Red: its way. Dashed: the ordinary morph's.%s%s",
             plan->pick.thesis ? " Dotted: our own method's." : "",
             plan->pick.rig.curves[0].solved && plan->pick.fish->lod[0].anchor_count == 0
                 ? " Grey: what weights from 0 to 1 can reach."
                 : "");
}

static void draw(struct picture *picture)
{
    static const char *const views[] = { "side", "front", "top" };
    enum outline_view view = best_view(picture);
    for (int i = OUTLINE_SIDE; picture->plan->view && i <= OUTLINE_TOP; i++) {
        if (strcmp(picture->plan->view, views[i]) == 0) {
            view = (enum outline_view)i;
        }
    }
    const struct window whole = { .x = 50.0, .y = 90.0, .width = 660.0, .height = LENS,
                                  .length_px = view == OUTLINE_FRONT ? 900.0 : 590.0,
                                  .view = view };
    const struct window lens = lens_on(picture, view);
    draw_words(picture, view);
    draw_window(picture, &whole, false);
    draw_window(picture, &lens, true);
}

enum exit_code path_picture(const struct path_plan *plan, const char *command)
{
    static struct picture picture;
    picture = (struct picture){ .plan = plan };
    if (plan->view && strcmp(plan->view, "side") != 0 && strcmp(plan->view, "front") != 0 &&
        strcmp(plan->view, "top") != 0) {
        return morph_usage(command, "--view: '%.40s' is not side, front or top", plan->view);
    }
    morph_rig_init(&picture.keys, &plan->pick.fish->card, TEMPLATE_PAIRWISE);
    walk(&picture);
    if (!svg_open(&picture.svg, plan->svg, WIDTH, HEIGHT, "The way of a part")) {
        return morph_fail(EXIT_IO, command, "%.200s: %s", plan->svg, strerror(errno));
    }
    draw(&picture);
    if (!svg_close(&picture.svg)) {
        return morph_fail(EXIT_IO, command, "%.200s: %s", plan->svg, strerror(errno));
    }
    return EXIT_OK;
}
