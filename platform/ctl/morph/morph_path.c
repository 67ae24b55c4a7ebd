/* morph_path.c -- `kingyoctl morph path`, which measures the path of a part while the fish grows.
 *
 * The path is compared with the straight line of ordinary morphing (2005 thesis, figures 3.2 to
 * 3.5). */
#include <stdio.h>
#include <string.h>

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

static void print_row(const struct morph_path_plan *plan, float progress)
{
    const struct species_card *card = &plan->pick.fish->card;
    const vec3 p = part_of_place(plan->pick.fish, &plan->pick.rig, plan->vertex, progress);
    const vec3 o = part_of_place(plan->ordinary, &plan->ordinary_rig, plan->vertex, progress);
    printf("%.6f,%.3f,%.4f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f\n", (double)progress,
           (double)life_age_days(card, progress), 1e3 * (double)life_length_m(card, progress),
           (double)p.x, (double)p.y, (double)p.z,
           (double)v3_from_line(p, plan->chord.from, plan->chord.to), (double)o.x, (double)o.y,
           (double)o.z,
           (double)v3_from_line(o, plan->ordinary_chord.from, plan->ordinary_chord.to));
}

static enum exit_code print_table(const struct morph_path_plan *plan)
{
    puts("progress,age_days,length_mm,x,y,z,from_chord,ordinary_x,ordinary_y,ordinary_z,"
         "ordinary_from_chord");
    for (uint32_t i = 0; i <= plan->steps; i++) {
        print_row(plan, (float)i / (float)plan->steps);
    }
    return EXIT_OK;
}

static enum exit_code morph_path_run(int argc, const char *const *argv)
{
    static struct morph_path_plan plan;
    plan = (struct morph_path_plan){ .steps = 100 };
    const struct morph_option options[] = {
        { .name = "--part", .text = &plan.part },
        { .name = "--side", .text = &plan.side },
        { .name = "--svg", .text = &plan.svg },
        { .name = "--view", .text = &plan.view },
        { .name = "--steps", .count = &plan.steps, .min = 1, .max = 100000 },
    };
    enum exit_code code = morph_options_read(&plan.pick, name, MORPH_REQUIRES_CURVES, options,
                                             sizeof options / sizeof options[0], argc, argv);
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
    return plan.svg ? morph_path_picture(&plan, name) : print_table(&plan);
}

const struct morph_command ctl_morph_path = {
    .name = name,
    .words = "SPECIES|FILE --part PART [--side right|left] [--template T] [--thesis] "
             "[--steps N] [--svg FILE]",
    .summary = "where a part goes as its fish grows, as CSV, the ordinary morph's way beside it",
    .usage =
        "progress,age_days,length_mm,x,y,z,from_chord,ordinary_x,ordinary_y,ordinary_z,\n"
        "ordinary_from_chord\n\n"
        "  --part PART   body (its back at its deepest), eye (the pupil), tail (the tip of the\n"
        "                upper lobe), dorsal, anal, pectoral, pelvic, dorsal2, finlets_upper,\n"
        "                finlets_lower (where the leading ray is rooted)\n"
        "  --side S      right or left of a pair; right otherwise\n"
        "  --steps N     rows but one, 1 to 100000; 100 otherwise\n"
        "  --svg FILE    a picture instead of the table, [--view side|front|top]: the keys'\n"
        "                outlines with the way across them, the straight line dashed\n"
        "\nPlaces and distances are in body lengths, whatever size the fish has: x to its right,\n"
        "y up, z backward, the snout at z = -0.5. from_chord is the distance from the straight\n"
        "line between its first place and its last, which the ordinary morph never leaves.\n",
    .run = morph_path_run,
};
