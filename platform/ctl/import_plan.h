/* import_plan.h -- what a maker says about meshes that say too little themselves. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_PLAN_H
#define KINGYO_PLATFORM_CTL_IMPORT_PLAN_H

#include "platform/ctl/import_mesh.h"
#include "platform/species/pack.h"

enum import_axis { AXIS_X, AXIS_Y, AXIS_Z, AXIS_MINUS_X, AXIS_MINUS_Y, AXIS_MINUS_Z, AXIS_NONE };

struct import_plan {
    const char *id;
    uint8_t front, up;              /* enum import_axis; `front` may be AXIS_NONE: found out. */
    uint8_t measure, motion, form;  /* As struct species_card; 255: `like`'s, else a usual one. */
    uint8_t template;               /* enum graph_template; TEMPLATE_OWN: the file's own. */
    uint32_t name_count, length_count, age_count, growth_count, colour_count;
    char names[MORPH_KEY_MAX][SPECIES_NAME_SIZE];
    double lengths_mm[MORPH_KEY_MAX], ages_days[MORPH_KEY_MAX];
    double growth[5];               /* LENGTH_INF_MM, K, T0, HATCH_MM, FADE_YEAR */
    uint32_t colours[5];            /* Back, flank, belly, fin, iris. */
    double unit_m;                  /* What the file's 1 is worth, in metres. */
    const struct species *like;     /* Whose life, colours and curves it has, or null. */
};

/* What was found out and is worth telling: "front -x, 426 vertices, ..." */
struct import_report {
    uint8_t front;
    float size[MORPH_KEY_MAX];      /* Of each key in the file, in its unit. */
    uint32_t joined_count;          /* Vertices that were one with others. */
    float graph_error;              /* Greatest difference of the graph to the file's animation. */
    uint32_t knot_count;            /* Of the file's animation, kept; 0: there was none. */
};

/* Turns `mesh` to our axes (snout to -z, back to +y) and each key to size 1 in the plan's measure.
 * EXIT_BAD_DATA with `why`, without the file's name, where that cannot be found out. */
enum exit_code import_orient(struct import_mesh *mesh, const struct import_plan *plan,
                             struct import_report *report, char why[IMPORT_WHY_SIZE]);

/* Makes the body tables of an oriented mesh, near and far, and vets nothing yet. */
enum exit_code import_build(const struct import_mesh *mesh, struct species_slot *slot,
                            struct import_report *report, char why[IMPORT_WHY_SIZE]);

/* Fills card and coats. */
enum exit_code import_life(const struct import_mesh *mesh, const struct import_plan *plan,
                           struct species_slot *slot, struct import_report *report,
                           char why[IMPORT_WHY_SIZE]);

/* Of a template that was fitted, `card` its own: what the plan says of its id, names, lengths, ages
 * and growth. */
enum exit_code import_fitted_life(const struct import_plan *plan, struct species_card *card,
                                  char why[IMPORT_WHY_SIZE]);

/* Which part a group of that name is of, by words in it ("Fin_dorsal.L" is the dorsal fin). */
enum species_part import_part(const char *group);

extern const char *const import_axis_names[AXIS_NONE];

#endif
