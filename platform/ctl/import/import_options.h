/* import_options.h -- the user's options for imported meshes, and the steps of the import. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_OPTIONS_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_OPTIONS_H

#include "platform/ctl/import/import_mesh.h"
#include "platform/species/pack.h"

enum import_axis { AXIS_X, AXIS_Y, AXIS_Z, AXIS_MINUS_X, AXIS_MINUS_Y, AXIS_MINUS_Z, AXIS_NONE };

/* Options of the import. Each *_count is the number of valid values in its array, and 0 means
 * that the option is absent. */
struct import_options {
    const char *id;
    uint8_t front, up;             /* Axes of the snout and of the back (enum import_axis).
                                      `front` may be AXIS_NONE, and then it is detected. */
    uint8_t measure, motion, form; /* Values as in struct species_card. 255 selects the value of
                                      `like`, or the default without `like`. */
    uint8_t template_id;           /* Graph template (enum graph_template). TEMPLATE_OWN selects
                                      the graph of the file. */
    uint32_t name_count, length_count, age_count, growth_count, colour_count;
    char names[MORPH_KEY_MAX][SPECIES_NAME_SIZE];
    double lengths_mm[MORPH_KEY_MAX], ages_days[MORPH_KEY_MAX];
    double growth[5];           /* Growth parameters in the order LENGTH_INF_MM, K, T0, HATCH_MM,
                                   FADE_YEAR. */
    uint32_t colours[5];        /* Colours of back, flank, belly, fin and iris. */
    double unit_m;              /* Length of one file unit, in metres. */
    const struct species *like; /* Species that provides life data, colours and curves, or null. */
};

/* Results of the import that kingyoctl prints: "front -x, 426 vertices, ..." */
struct import_report {
    uint8_t front;
    float size[MORPH_KEY_MAX]; /* Size of each key shape in the file, in the file's unit. */
    uint32_t joined_count;     /* Number of vertices that were merged with others. */
    float graph_error;         /* Greatest difference between the graph and the animation of the
                                  file. */
    uint32_t knot_count;       /* Number of knots that approximate the animation of the file. 0
                                  means that the file has no animation. */
};

/* Rotates `mesh` to our axes (snout to -z, back to +y) and scales each key shape to size 1 in the
 * plan's measure. Returns EXIT_OK, or EXIT_BAD_DATA with `why`, without the file name, if the
 * orientation or the size cannot be detected. */
enum exit_code import_orient(struct import_mesh *mesh, const struct import_options *plan,
                             struct import_report *report, char why[IMPORT_WHY_SIZE]);

/* Builds the body tables of an oriented mesh for near and far views. Does not validate the species.
 * Returns EXIT_OK, or another exit code with `why`. */
enum exit_code import_build(const struct import_mesh *mesh, struct species_slot *slot,
                            struct import_report *report, char why[IMPORT_WHY_SIZE]);

/* Fills the species card and the colours. Returns EXIT_OK, or EXIT_BAD_DATA with `why`. */
enum exit_code import_life(const struct import_mesh *mesh, const struct import_options *plan,
                           struct species_slot *slot, struct import_report *report,
                           char why[IMPORT_WHY_SIZE]);

/* Applies the plan to `card`, the card of a fitted template: id, names, lengths, ages and growth.
 * Returns EXIT_OK, or EXIT_BAD_DATA with `why`. */
enum exit_code import_fitted_life(const struct import_options *plan, struct species_card *card,
                                  char why[IMPORT_WHY_SIZE]);

/* Returns the part of a group by words in the group's name. For example, "Fin_dorsal.L" is the
 * dorsal fin. The default is the body. */
enum species_part import_part(const char *group);

extern const char *const import_axis_names[AXIS_NONE];

#endif
