/* morph_path_view.c -- samples the path of a part and fits the picture's windows to the path. */
#include "platform/ctl/morph_path_view.h"

#include <math.h>

/* ---- Sampling ------------------------------------------------------------------------------- */

/* Converts a progress of the thesis' method to the progress of the whole species. */
static float drawn_progress(const struct species_card *drawn, float progress)
{
    const float place = progress * 2.0f;
    const uint32_t i = place < 1.0f ? 0u : 1u;
    const float from = (float)drawn->thesis_key[i], to = (float)drawn->thesis_key[i + 1u];
    return (from + (to - from) * (place - (float)i)) / (float)(drawn->key_count - 1u);
}

void path_walk(struct picture *picture)
{
    const struct path_plan *plan = picture->plan;
    const struct morph_pick *pick = &plan->pick;
    struct morph_rig own;
    morph_rig_init(&own, &pick->drawn->card, TEMPLATE_OWN);
    for (uint32_t i = 0; i <= PATH_SAMPLES; i++) {
        const float progress = (float)i / (float)PATH_SAMPLES;
        picture->way[i] = morph_part_place(pick->fish, &pick->rig, plan->vertex, progress);
        if (pick->thesis) {
            picture->drawn[i] = morph_part_place(pick->drawn, &own, plan->vertex,
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

vec3 path_key(const struct picture *picture, uint32_t key)
{
    const struct species *fish = picture->plan->pick.fish;
    return morph_part_place(fish, &picture->keys, picture->plan->vertex,
                            (float)key / (float)(fish->card.key_count - 1u));
}

vec3 path_solved(const struct picture *picture, uint32_t key)
{
    vec3 sum = { 0.0f, 0.0f, 0.0f };
    for (uint32_t j = 0; j < picture->keys.key_count; j++) {
        sum = v3_mad(sum, path_key(picture, j), picture->plan->pick.rig.solution[0][key][j]);
    }
    return sum;
}

/* ---- Windows -------------------------------------------------------------------------------- */

struct outline path_outline(const struct window *window)
{
    struct outline outline = { .view = window->view, .length_px = window->length_px };
    double x, y;
    outline_project(&outline, window->middle, &x, &y);
    outline.x = window->x + 0.5 * window->width - x + window->shift_x;
    outline.y = window->y + 0.5 * window->height - y + window->shift_y;
    return outline;
}

void path_place(const struct window *window, vec3 p, double *x, double *y)
{
    const struct outline outline = path_outline(window);
    outline_project(&outline, p, x, y);
}

/* Returns the length of the path as seen in a view. */
static double way_in(const struct picture *picture, enum outline_view view)
{
    const struct window flat = { .length_px = 1.0, .view = view };
    double x0, y0, length = 0.0;
    path_place(&flat, picture->way[0], &x0, &y0);
    for (uint32_t i = 1; i <= PATH_SAMPLES; i++) {
        double x, y;
        path_place(&flat, picture->way[i], &x, &y);
        length += hypot(x - x0, y - y0);
        x0 = x;
        y0 = y;
    }
    return length;
}

enum outline_view path_best_view(const struct picture *picture)
{
    const double side = way_in(picture, OUTLINE_SIDE), front = way_in(picture, OUTLINE_FRONT);
    const double top = way_in(picture, OUTLINE_TOP);
    if (side >= 0.9 * fmax(front, top)) {
        return OUTLINE_SIDE;
    }
    return front >= top ? OUTLINE_FRONT : OUTLINE_TOP;
}

struct window path_lens(const struct picture *picture, enum outline_view view)
{
    const struct window flat = { .length_px = 1.0, .view = view };
    const uint32_t keys = picture->keys.key_count;
    double low[2] = { 1e9, 1e9 }, high[2] = { -1e9, -1e9 };
    vec3 least = { 1e9f, 1e9f, 1e9f }, most = { -1e9f, -1e9f, -1e9f };
    for (uint32_t i = 0; i <= PATH_SAMPLES + 2u * keys; i++) {
        const vec3 p = i <= PATH_SAMPLES ? picture->way[i]
                       : i <= PATH_SAMPLES + keys
                           ? path_key(picture, i - PATH_SAMPLES - 1u)
                           : path_solved(picture, i - PATH_SAMPLES - keys - 1u);
        double at[2];
        path_place(&flat, p, &at[0], &at[1]);
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = fmin(low[axis], at[axis]);
            high[axis] = fmax(high[axis], at[axis]);
        }
        least = v3(f_min(least.x, p.x), f_min(least.y, p.y), f_min(least.z, p.z));
        most = v3(f_max(most.x, p.x), f_max(most.y, p.y), f_max(most.z, p.z));
    }
    const double span = fmax(fmax(high[0] - low[0], high[1] - low[1]), 0.01);
    return (struct window){ .x = PATH_WIDTH - PATH_LENS - 50.0,
                            .y = 90.0,
                            .width = PATH_LENS,
                            .height = PATH_LENS,
                            .length_px = PATH_LENS / (1.45 * span),
                            .middle = v3_scale(v3_add(least, most), 0.5f),
                            .view = view };
}

struct window path_whole(const struct picture *picture, enum outline_view view)
{
    struct window window = {
        .x = 50.0, .y = 90.0, .width = 660.0, .height = PATH_LENS, .length_px = 1.0, .view = view
    };
    double low[2] = { 1e9, 1e9 }, high[2] = { -1e9, -1e9 };
    for (uint32_t key = 0; key < picture->keys.key_count; key++) {
        const struct outline outline = {
            .species = picture->plan->pick.fish,
            .rig = &picture->keys,
            .view = view,
            .progress = (float)key / (float)(picture->keys.key_count - 1u),
            .length_px = 1.0,
        };
        outline_measure(&outline, low, high);
    }
    window.length_px =
        fmin(0.92 * window.width / (high[0] - low[0]), 0.92 * window.height / (high[1] - low[1]));
    window.shift_x = -0.5 * (low[0] + high[0]) * window.length_px;
    window.shift_y = -0.5 * (low[1] + high[1]) * window.length_px;
    return window;
}
