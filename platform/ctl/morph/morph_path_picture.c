/* morph_path_picture.c -- draws the path of a part (2005 thesis, figures 3.2 to 3.5 and 4.15).
 *
 * The first window shows the outlines of all keys with the path across them. The second window
 * shows the path enlarged. */
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/caption.h"
#include "platform/ctl/morph/morph_outline.h"
#include "platform/species/part.h"

#define SVG_WAY "#c8371f"
/* Distance from the chord, in body lengths, below which a path counts as straight. The value is
 * less than three quantization steps of the mesh tables. */
#define STRAIGHT_LENGTHS 1e-4f

#define WIDTH 1280.0
#define HEIGHT 640.0
#define SAMPLES 200u
/* Side in pixels of the square window that shows the path enlarged. */
#define LENS 500.0

/* A window of the picture, and the region of the fish that the window shows. */
struct window {
    double x, y, width, height; /* Position and size of the window's frame in pixels. */
    /* View, scale and position of the fish in the window. */
    struct morph_outline outline;
};

static struct picture {
    const struct morph_path_plan *plan;
    struct svg svg;
    struct morph_rig
        /* Weights of the keys over the life in which exactly one key has the weight 1 at the
         * progress of that key. */
        keys;
    vec3 key[MORPH_KEY_MAX];    /* Position of the part's vertex in the drawn shape of each key. */
    vec3 solved[MORPH_KEY_MAX]; /* Position of the part's vertex in the solved shape of each key.
                                  The solved shape exaggerates the drawn shape so that the path
                                  passes through the drawn shape (2005 thesis, section 4.2). */
    vec3 way[SAMPLES + 1u];     /* Sampled path of the part, in body coordinates. */
    vec3 drawn[SAMPLES + 1u];   /* Path of the part by Kingyo's own method, for comparison. Used
                                  only with --thesis. */
    vec3 farthest;              /* Point of the path with the greatest distance from the chord. */
    float farthest_progress, farthest_lengths;
} picture;

static struct svg *const svg = &picture.svg;

/* Returns the progress at which the fish has the shape of key `key`. */
static float key_progress(uint32_t key)
{
    return (float)key / (float)(picture.keys.key_count - 1u);
}

/* Computes the points and the paths of the picture. */
static void sample_path(void)
{
    const struct morph_path_plan *plan = picture.plan;
    const struct morph_options *pick = &plan->pick;
    const uint32_t keys = picture.keys.key_count;
    struct morph_rig own;
    morph_rig_init(&own, &pick->drawn->card, TEMPLATE_OWN);
    for (uint32_t key = 0; key < keys; key++) {
        picture.key[key] =
            part_of_place(pick->fish, &picture.keys, plan->vertex, key_progress(key));
    }
    for (uint32_t key = 0; key < keys; key++) {
        for (uint32_t j = 0; j < keys; j++) {
            picture.solved[key] =
                v3_muladd(picture.solved[key], picture.key[j], pick->rig.solution[0][key][j]);
        }
    }
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        const float progress = (float)i / (float)SAMPLES;
        picture.way[i] = part_of_place(pick->fish, &pick->rig, plan->vertex, progress);
        if (pick->thesis) {
            /* The method of the 2005 thesis uses only three keys. Its progress is converted to a
             * progress of the whole species. */
            const struct species_card *drawn = &pick->drawn->card;
            const float place = progress * 2.0f;
            const uint32_t k = place < 1.0f ? 0u : 1u;
            const float from = (float)drawn->thesis_key[k], to = (float)drawn->thesis_key[k + 1u];
            picture.drawn[i] = part_of_place(pick->drawn, &own, plan->vertex,
                                             (from + (to - from) * (place - (float)k)) /
                                                 (float)(drawn->key_count - 1u));
        }
        const float far = v3_from_line(picture.way[i], plan->chord.from, plan->chord.to);
        if (far > picture.farthest_lengths) {
            picture.farthest = picture.way[i];
            picture.farthest_lengths = far;
            picture.farthest_progress = progress;
        }
    }
}

/* ---- Windows of the picture ------------------------------------------------------------------ */

/* Returns the length of the path as it appears in a view, in body lengths. */
static double way_in(enum morph_outline_view view)
{
    const struct morph_outline flat = { .length_px = 1.0, .view = view };
    struct outline_point before = morph_outline_project(&flat, picture.way[0]);
    double length = 0.0;
    for (uint32_t i = 1; i <= SAMPLES; i++) {
        const struct outline_point at = morph_outline_project(&flat, picture.way[i]);
        length += hypot(at.x - before.x, at.y - before.y);
        before = at;
    }
    return length;
}

/* Returns the window that shows the path and its drawn and solved keys enlarged. */
static struct window enlarged_window(enum morph_outline_view view)
{
    const struct morph_outline flat = { .length_px = 1.0, .view = view };
    const uint32_t keys = picture.keys.key_count;
    struct outline_point low = { 1e9, 1e9 }, high = { -1e9, -1e9 }, at;
    vec3 least = { 1e9f, 1e9f, 1e9f }, most = { -1e9f, -1e9f, -1e9f };
    for (uint32_t i = 0; i <= SAMPLES + 2u * keys; i++) {
        const vec3 p = i <= SAMPLES          ? picture.way[i]
                       : i <= SAMPLES + keys ? picture.key[i - SAMPLES - 1u]
                                             : picture.solved[i - SAMPLES - keys - 1u];
        at = morph_outline_project(&flat, p);
        low = (struct outline_point){ fmin(low.x, at.x), fmin(low.y, at.y) };
        high = (struct outline_point){ fmax(high.x, at.x), fmax(high.y, at.y) };
        least = v3(f_min(least.x, p.x), f_min(least.y, p.y), f_min(least.z, p.z));
        most = v3(f_max(most.x, p.x), f_max(most.y, p.y), f_max(most.z, p.z));
    }
    const double span = fmax(fmax(high.x - low.x, high.y - low.y), 0.01);
    struct window window = {
        WIDTH - LENS - 50.0, 90.0, LENS, LENS, { .length_px = LENS / (1.45 * span), .view = view }
    };
    /* Moves the fish so that the middle of the path is at the middle of the window. */
    at = morph_outline_project(&window.outline, v3_scale(v3_add(least, most), 0.5f));
    window.outline.x = window.x + 0.5 * window.width - at.x;
    window.outline.y = window.y + 0.5 * window.height - at.y;
    return window;
}

/* Returns the window that shows the whole fish at all keys. */
static struct window whole_window(enum morph_outline_view view)
{
    struct window window = { 50.0, 90.0, 660.0, LENS, { .view = view } };
    double low[2] = { 1e9, 1e9 }, high[2] = { -1e9, -1e9 };
    for (uint32_t key = 0; key < picture.keys.key_count; key++) {
        const struct morph_outline outline = {
            .species = picture.plan->pick.fish,
            .rig = &picture.keys,
            .view = view,
            .progress = key_progress(key),
            .length_px = 1.0,
        };
        morph_outline_measure(&outline, low, high);
    }
    const double scale =
        fmin(0.92 * window.width / (high[0] - low[0]), 0.92 * window.height / (high[1] - low[1]));
    window.outline.length_px = scale;
    window.outline.x = window.x + 0.5 * window.width - 0.5 * (low[0] + high[0]) * scale;
    window.outline.y = window.y + 0.5 * window.height - 0.5 * (low[1] + high[1]) * scale;
    return window;
}

/* ---- Contents of a window -------------------------------------------------------------------- */

static void draw_way(const struct window *window, const vec3 *way, const char *colour, double width,
                     const char *dashes)
{
    svg_begin_line(svg);
    for (uint32_t i = 0; i <= SAMPLES; i++) {
        morph_outline_point(svg, &window->outline, way[i]);
    }
    svg_end_line(svg, colour, width, dashes);
}

/* Draws the region that a blend of three keys can reach. The region is the triangle between the
 * positions in the three solved shapes. */
static void draw_reach(const struct window *window)
{
    if (!picture.plan->pick.rig.curves[0].solved ||
        picture.plan->pick.fish->lod[0].anchor_count > 0) {
        return;
    }
    svg_put(svg,
            "<polygon fill=\"#8a8580\" fill-opacity=\"0.22\" stroke=\"%s\" "
            "points=\"",
            SVG_GREY);
    for (uint32_t key = 0; key < picture.keys.key_count; key++) {
        morph_outline_point(svg, &window->outline, picture.solved[key]);
    }
    svg_put(svg, "\"/>\n");
}

struct label {
    /* `x` and `y` are the left end of the label's baseline, and `width` is the width of its text.
     * All values are in pixels. */
    double x, y, width;
};

/* Returns a position for a label beside `dot`, where the label overlaps no other label. Positions
 * to the right of the dot are tried before positions to the left. */
static struct label free_label(const struct label *taken, uint32_t count, struct outline_point dot,
                               double width)
{
    CORE_ASSERT(count < MORPH_KEY_MAX);
    CORE_ASSERT(width >= 0.0);
    static const double above[6] = { -10.0, 22.0, -10.0, 22.0, -28.0, 40.0 };
    struct label label = { 0 };
    for (uint32_t i = 0; i < 6; i++) {
        bool is_free = true;
        const bool to_left = i == 2 || i == 3;
        label = (struct label){ to_left ? dot.x - 12.0 - width : dot.x + 12.0, dot.y + above[i],
                                width };
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
static void draw_bend(const struct window *window)
{
    CORE_ASSERT(picture.farthest_lengths >= STRAIGHT_LENGTHS);
    const struct morph_path_plan *plan = picture.plan;
    const vec3 along = v3_sub(plan->chord.to, plan->chord.from);
    const float length = v3_dot(along, along);
    const vec3 there = v3_sub(picture.farthest, plan->chord.from);
    const float share = length > 0.0f ? v3_dot(there, along) / length : 0.0f;
    const struct outline_point from = morph_outline_project(&window->outline, picture.farthest);
    const struct outline_point to =
        morph_outline_project(&window->outline, v3_muladd(plan->chord.from, along, share));
    svg_line(svg, from.x, from.y, to.x, to.y, SVG_INK, 1.2, NULL);
    svg_text(svg, to.x + 10.0, to.y + 5.0, 14.0, "start", SVG_INK, "%.4f",
             (double)picture.farthest_lengths);
}

/* Draws a scale bar with a label. The length of the bar is a round share of the body's length. */
static void draw_ruler(const struct window *window)
{
    double lengths = 1.0;
    while (lengths * window->outline.length_px > 0.4 * window->width) {
        lengths *= 0.1;
    }
    const double x = window->x + 16.0, y = window->y + window->height - 16.0;
    svg_line(svg, x, y, x + lengths * window->outline.length_px, y, SVG_INK, 2.0, NULL);
    svg_text(svg, x, y - 8.0, 13.0, "start", SVG_INK, "%g body length%s", lengths,
             lengths < 1.0 ? "s" : "");
}

static void draw_window(const struct window *window, bool enlarged)
{
    const char *id = enlarged ? "lens" : "whole";
    svg_put(svg,
            "<clipPath id=\"%s\"><rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\"/></clipPath>\n"
            "<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" fill=\"#ffffff\" stroke=\"%s\"/>\n"
            "<g clip-path=\"url(#%s)\">\n",
            id, window->x, window->y, window->width, window->height, window->x, window->y,
            window->width, window->height, SVG_FAINT, id);
    const struct species *fish = picture.plan->pick.fish;
    const struct species_card *card = &fish->card;
    for (uint32_t key = 0; key < card->key_count; key++) {
        struct morph_outline outline = window->outline;
        outline.species = fish;
        outline.rig = &picture.keys;
        outline.progress = key_progress(key);
        outline.colour = morph_outline_key_colour(card, key);
        outline.opacity = enlarged ? 0.035 : 0.05;
        outline.line_px = 1.0;
        morph_outline_draw(svg, &outline);
    }
    draw_reach(window);
    svg_begin_line(svg);
    morph_outline_point(svg, &window->outline, picture.plan->chord.from);
    morph_outline_point(svg, &window->outline, picture.plan->chord.to);
    svg_end_line(svg, SVG_GREY, 2.0, "7 6");
    if (picture.plan->pick.thesis) {
        draw_way(window, picture.drawn, SVG_INK, 2.0, "1 6");
    }
    draw_way(window, picture.way, SVG_WAY, enlarged ? 4.5 : 2.8, NULL);
    for (uint32_t key = 0; key < picture.keys.key_count; key++) {
        const struct outline_point at = morph_outline_project(&window->outline, picture.key[key]);
        svg_dot(svg, at.x, at.y, enlarged ? 7.0 : 4.0, morph_outline_key_colour(card, key),
                SVG_PAPER);
    }
    if (enlarged) {
        struct label taken[MORPH_KEY_MAX];
        char words[CAPTION_WORDS_SIZE];
        for (uint32_t key = 0; key < card->key_count; key++) {
            caption_name(words, card->key_names[key]);
            taken[key] =
                free_label(taken, key, morph_outline_project(&window->outline, picture.key[key]),
                           8.4 * (double)strlen(words));
            svg_text(svg, taken[key].x, taken[key].y, 14.0, "start",
                     morph_outline_key_colour(card, key), "%s", words);
        }
        if (picture.farthest_lengths >= STRAIGHT_LENGTHS) {
            draw_bend(window);
        }
        draw_ruler(window);
    }
    svg_put(svg, "</g>\n");
}

static void draw_words(enum morph_outline_view view)
{
    static const char *const seen[] = { "from its left", "from ahead", "from above" };
    const struct morph_path_plan *plan = picture.plan;
    char title[CAPTION_WORDS_SIZE];
    caption_name(title, plan->pick.fish->card.id);
    title[0] = (char)toupper((unsigned char)title[0]);
    svg_text(svg, 50.0, 46.0, 26.0, "start", SVG_INK, "%s: %s", title, plan->part);
    if (picture.farthest_lengths < STRAIGHT_LENGTHS) {
        svg_text(svg, 50.0, 72.0, 14.0, "start", SVG_GREY,
                 "its way as the fish grows, %s: straight", seen[view]);
    } else {
        svg_text(svg, 50.0, 72.0, 14.0, "start", SVG_GREY,
                 "its way as the fish grows, %s; farthest from the straight line at progress %.2f",
                 seen[view], (double)picture.farthest_progress);
    }
    svg_text(svg, 50.0, HEIGHT - 22.0, 13.0, "start", SVG_GREY,
             "Red: its way. Dashed: the ordinary morph's.%s%s",
             plan->pick.thesis ? " Dotted: our own method's." : "",
             plan->pick.rig.curves[0].solved && plan->pick.fish->lod[0].anchor_count == 0
                 ? " Grey: what weights from 0 to 1 can reach."
                 : "");
}

enum exit_code morph_path_picture(const struct morph_path_plan *plan, const char *command)
{
    picture = (struct picture){ .plan = plan };
    enum morph_outline_view view = (enum morph_outline_view)plan->view;
    morph_rig_init(&picture.keys, &plan->pick.fish->card, TEMPLATE_PAIRWISE);
    sample_path();
    if (!svg_open(svg, plan->svg, WIDTH, HEIGHT, "The way of a part")) {
        return morph_written(command, plan->svg, -errno);
    }
    if (view == MORPH_OUTLINE_COUNT) {
        /* Selects the view in which the path is longest. The side view has preference. */
        const double front = way_in(MORPH_OUTLINE_FRONT), top = way_in(MORPH_OUTLINE_TOP);
        view = way_in(MORPH_OUTLINE_SIDE) >= 0.9 * fmax(front, top) ? MORPH_OUTLINE_SIDE
               : front >= top                                       ? MORPH_OUTLINE_FRONT
                                                                    : MORPH_OUTLINE_TOP;
    }
    const struct window whole = whole_window(view), enlarged = enlarged_window(view);
    draw_words(view);
    draw_window(&whole, false);
    draw_window(&enlarged, true);
    return morph_written(command, plan->svg, svg_close(svg) ? 0 : -errno);
}
