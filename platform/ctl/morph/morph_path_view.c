/* morph_path_view.c -- samples the path of a part, and chooses windows of the picture that contain
 * the path. */
#include "platform/ctl/morph/morph_path_view.h"

#include <math.h>

/* ---- Sampling the path ----------------------------------------------------------------------- */

/* Converts a progress of the 2005 thesis' method to a progress of the whole species. The method of
 * the thesis uses only three keys of the species. */
static float drawn_progress(const struct species_card *drawn, float progress)
{
    const float place = progress * 2.0f;
    const uint32_t i = place < 1.0f ? 0u : 1u;
    const float from = (float)drawn->thesis_key[i], to = (float)drawn->thesis_key[i + 1u];
    return (from + (to - from) * (place - (float)i)) / (float)(drawn->key_count - 1u);
}

void morph_path_walk(struct picture *picture)
{
    const struct morph_path_plan *plan = picture->plan;
    const struct morph_options *pick = &plan->pick;
    struct morph_rig own;
    morph_rig_init(&own, &pick->drawn->card, TEMPLATE_OWN);
    for (uint32_t i = 0; i <= MORPH_PATH_SAMPLES; i++) {
        const float progress = (float)i / (float)MORPH_PATH_SAMPLES;
        picture->way[i] = part_of_place(pick->fish, &pick->rig, plan->vertex, progress);
        if (pick->thesis) {
            picture->drawn[i] = part_of_place(pick->drawn, &own, plan->vertex,
                                              drawn_progress(&pick->drawn->card, progress));
        }
        const float far = v3_from_line(picture->way[i], plan->chord.from, plan->chord.to);
        if (far > picture->farthest_lengths) {
            picture->farthest = picture->way[i];
            picture->farthest_lengths = far;
            picture->farthest_progress = progress;
        }
    }
}

vec3 morph_path_key(const struct picture *picture, uint32_t key)
{
    const struct species *fish = picture->plan->pick.fish;
    return part_of_place(fish, &picture->keys, picture->plan->vertex,
                         (float)key / (float)(fish->card.key_count - 1u));
}

vec3 morph_path_solved(const struct picture *picture, uint32_t key)
{
    vec3 sum = { 0.0f, 0.0f, 0.0f };
    for (uint32_t j = 0; j < picture->keys.key_count; j++) {
        sum =
            v3_muladd(sum, morph_path_key(picture, j), picture->plan->pick.rig.solution[0][key][j]);
    }
    return sum;
}

/* ---- Windows of the picture ------------------------------------------------------------------ */

struct morph_outline morph_path_outline(const struct window *window)
{
    struct morph_outline outline = { .view = window->view, .length_px = window->length_px };
    double x, y;
    morph_outline_project(&outline, window->middle, &x, &y);
    outline.x = window->x + 0.5 * window->width - x + window->shift_x;
    outline.y = window->y + 0.5 * window->height - y + window->shift_y;
    return outline;
}

void morph_path_place(const struct window *window, vec3 p, double *x, double *y)
{
    const struct morph_outline outline = morph_path_outline(window);
    morph_outline_project(&outline, p, x, y);
}

/* Returns the length of the path as it appears in a view, in body lengths. */
static double way_in(const struct picture *picture, enum morph_outline_view view)
{
    const struct window flat = { .length_px = 1.0, .view = view };
    double x0, y0, length = 0.0;
    morph_path_place(&flat, picture->way[0], &x0, &y0);
    for (uint32_t i = 1; i <= MORPH_PATH_SAMPLES; i++) {
        double x, y;
        morph_path_place(&flat, picture->way[i], &x, &y);
        length += hypot(x - x0, y - y0);
        x0 = x;
        y0 = y;
    }
    return length;
}

enum morph_outline_view morph_path_best_view(const struct picture *picture)
{
    const double side = way_in(picture, MORPH_OUTLINE_SIDE),
                 front = way_in(picture, MORPH_OUTLINE_FRONT);
    const double top = way_in(picture, MORPH_OUTLINE_TOP);
    if (side >= 0.9 * fmax(front, top)) {
        return MORPH_OUTLINE_SIDE;
    }
    return front >= top ? MORPH_OUTLINE_FRONT : MORPH_OUTLINE_TOP;
}

struct window morph_path_lens(const struct picture *picture, enum morph_outline_view view)
{
    const struct window flat = { .length_px = 1.0, .view = view };
    const uint32_t keys = picture->keys.key_count;
    double low[2] = { 1e9, 1e9 }, high[2] = { -1e9, -1e9 };
    vec3 least = { 1e9f, 1e9f, 1e9f }, most = { -1e9f, -1e9f, -1e9f };
    for (uint32_t i = 0; i <= MORPH_PATH_SAMPLES + 2u * keys; i++) {
        const vec3 p = i <= MORPH_PATH_SAMPLES ? picture->way[i]
                       : i <= MORPH_PATH_SAMPLES + keys
                           ? morph_path_key(picture, i - MORPH_PATH_SAMPLES - 1u)
                           : morph_path_solved(picture, i - MORPH_PATH_SAMPLES - keys - 1u);
        double at[2];
        morph_path_place(&flat, p, &at[0], &at[1]);
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = fmin(low[axis], at[axis]);
            high[axis] = fmax(high[axis], at[axis]);
        }
        least = v3(f_min(least.x, p.x), f_min(least.y, p.y), f_min(least.z, p.z));
        most = v3(f_max(most.x, p.x), f_max(most.y, p.y), f_max(most.z, p.z));
    }
    const double span = fmax(fmax(high[0] - low[0], high[1] - low[1]), 0.01);
    return (struct window){ .x = MORPH_PATH_WIDTH - MORPH_PATH_LENS - 50.0,
                            .y = 90.0,
                            .width = MORPH_PATH_LENS,
                            .height = MORPH_PATH_LENS,
                            .length_px = MORPH_PATH_LENS / (1.45 * span),
                            .middle = v3_scale(v3_add(least, most), 0.5f),
                            .view = view };
}

struct window morph_path_whole(const struct picture *picture, enum morph_outline_view view)
{
    struct window window = { .x = 50.0,
                             .y = 90.0,
                             .width = 660.0,
                             .height = MORPH_PATH_LENS,
                             .length_px = 1.0,
                             .view = view };
    double low[2] = { 1e9, 1e9 }, high[2] = { -1e9, -1e9 };
    for (uint32_t key = 0; key < picture->keys.key_count; key++) {
        const struct morph_outline outline = {
            .species = picture->plan->pick.fish,
            .rig = &picture->keys,
            .view = view,
            .progress = (float)key / (float)(picture->keys.key_count - 1u),
            .length_px = 1.0,
        };
        morph_outline_measure(&outline, low, high);
    }
    window.length_px =
        fmin(0.92 * window.width / (high[0] - low[0]), 0.92 * window.height / (high[1] - low[1]));
    window.shift_x = -0.5 * (low[0] + high[0]) * window.length_px;
    window.shift_y = -0.5 * (low[1] + high[1]) * window.length_px;
    return window;
}
