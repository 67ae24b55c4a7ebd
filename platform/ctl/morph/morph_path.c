/* morph_path.c -- `kingyoctl morph path`, which measures the path of a part while the fish grows.
 *
 * The path is compared with the straight line of ordinary morphing (2005 thesis, figures 3.2 to
 * 3.5). */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_path.h"

static const char name[] = "path";

static enum exit_code find_vertex(struct morph_path_plan *plan)
{
    const struct species_mesh *mesh = &plan->pick.fish->lod[0];
    const enum species_part part = plan->part ? part_of_vertex(plan->part) : PART_COUNT;
    const bool left = plan->side && strcmp(plan->side, "left") == 0;
    if (plan->side && !left && strcmp(plan->side, "right") != 0) {
        return morph_usage(name, "--side: '%.40s' is not right or left", plan->side);
    }
    if (!plan->part) {
        return morph_usage(name, "--part is missing; --help lists them");
    }
    if (part == PART_COUNT) {
        return morph_usage(name, "--part: '%.40s' is no part; --help lists them", plan->part);
    }
    plan->vertex = part_vertex_range(mesh, part, left ? SIDE_LEFT : SIDE_RIGHT);
    if (plan->vertex == mesh->vertex_count) {
        return morph_usage(name, "--part: %s has no %s", plan->pick.fish->card.id, plan->part);
    }
    return EXIT_OK;
}

static struct chord chord_of(const struct species *fish, const struct morph_rig *rig,
                             uint32_t vertex)
{
    return (struct chord){ part_of_place(fish, rig, vertex, 0.0f),
                           part_of_place(fish, rig, vertex, 1.0f) };
}

#define AT(member) .offset = offsetof(struct morph_path_plan, member)

static const struct option options[] = {
    { "part", "PART",
      "body (its back at the deepest point), eye (the pupil), tail (the tip of the upper lobe), or "
      "the root of the leading ray of dorsal, anal, pectoral, pelvic, dorsal2, finlets_upper or "
      "finlets_lower",
      OPTION_TEXT, AT(part), .expects = "the name of a part" },
    { "side", "right|left", "side of a paired part; the default is right", OPTION_TEXT, AT(side),
      .expects = "right or left" },
    { "steps", "N", "number of rows minus one", OPTION_WHOLE, AT(steps), 1, 100000,
      .initial = "100" },
    { "svg", "FILE",
      "write a picture instead of the table: the outlines of the keys with the path across them, "
      "and the straight line dashed",
      OPTION_TEXT, AT(svg) },
    { "view", "VIEW", "view of the picture: side, front or top", OPTION_TEXT, AT(view),
      .expects = "side, front or top" },
};

static const struct option_table table = { options, sizeof options / sizeof options[0],
                                           &morph_options_table };

static enum exit_code morph_path_run(int argc, const char *const *argv)
{
    static struct morph_path_plan plan;
    plan = (struct morph_path_plan){ .steps = 0 };
    enum exit_code code =
        morph_options_read(&plan.pick, name, MORPH_REQUIRES_CURVES, &table, argc, argv);
    if (code == EXIT_OK) {
        code = find_vertex(&plan);
    }
    if (code != EXIT_OK) {
        return code;
    }
    plan.ordinary = morph_options_ordinary(&plan.pick, &plan.ordinary_rig);
    plan.chord = chord_of(plan.pick.fish, &plan.pick.rig, plan.vertex);
    plan.ordinary_chord = chord_of(plan.ordinary, &plan.ordinary_rig, plan.vertex);
    if (plan.view && !plan.svg) {
        return morph_usage(name, "--view goes with --svg");
    }
    if (plan.svg) {
        return morph_path_picture(&plan, name);
    }
    puts("progress,age_days,length_mm,x,y,z,from_chord,ordinary_x,ordinary_y,ordinary_z,"
         "ordinary_from_chord");
    for (uint32_t i = 0; i <= plan.steps; i++) {
        const float progress = (float)i / (float)plan.steps;
        const struct species_card *card = &plan.pick.fish->card;
        const vec3 p = part_of_place(plan.pick.fish, &plan.pick.rig, plan.vertex, progress);
        const vec3 o = part_of_place(plan.ordinary, &plan.ordinary_rig, plan.vertex, progress);
        printf("%.6f,%.3f,%.4f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f\n", (double)progress,
               (double)life_age_days(card, progress), 1e3 * (double)life_length_m(card, progress),
               (double)p.x, (double)p.y, (double)p.z,
               (double)v3_from_line(p, plan.chord.from, plan.chord.to), (double)o.x, (double)o.y,
               (double)o.z,
               (double)v3_from_line(o, plan.ordinary_chord.from, plan.ordinary_chord.to));
    }
    return EXIT_OK;
}

const struct morph_command ctl_morph_path = {
    .name = name,
    .options = &table,
    .groups = MORPH_REQUIRES_CURVES,
    .words = "SPECIES|FILE --part PART [--side right|left] [--template T] [--thesis] "
             "[--steps N] [--svg FILE]",
    .summary = "where a part goes as its fish grows, as CSV, the ordinary morph's way beside it",
    .usage =
        "progress,age_days,length_mm,x,y,z,from_chord,ordinary_x,ordinary_y,ordinary_z,\n"
        "ordinary_from_chord\n\n"
        "Places and distances are in body lengths, whatever size the fish has: x to its right,\n"
        "y up, z backward, the snout at z = -0.5. from_chord is the distance from the straight\n"
        "line between its first place and its last, which the ordinary morph never leaves.\n",
    .run = morph_path_run,
};

/* ---- View of the path ------------------------------------------------------------------------ */

/* This section samples the path of a part, and chooses windows of the picture that contain the
 * path. */

/* ---- Sampling the path ----------------------------------------------------------------------- */

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
            /* The method of the 2005 thesis uses only three keys. Its progress is converted to a
             * progress of the whole species. */
            const struct species_card *drawn = &pick->drawn->card;
            const float place = progress * 2.0f;
            const uint32_t k = place < 1.0f ? 0u : 1u;
            const float from = (float)drawn->thesis_key[k], to = (float)drawn->thesis_key[k + 1u];
            picture->drawn[i] = part_of_place(pick->drawn, &own, plan->vertex,
                                              (from + (to - from) * (place - (float)k)) /
                                                  (float)(drawn->key_count - 1u));
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
    CORE_ASSERT(key < picture->keys.key_count);
    const struct species *fish = picture->plan->pick.fish;
    return part_of_place(fish, &picture->keys, picture->plan->vertex,
                         (float)key / (float)(fish->card.key_count - 1u));
}

vec3 morph_path_solved(const struct picture *picture, uint32_t key)
{
    CORE_ASSERT(key < picture->keys.key_count);
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
    CORE_ASSERT(window->length_px > 0.0);
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
