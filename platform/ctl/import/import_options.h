/* import_options.h -- the user's options for the import of meshes, and the functions that perform
 * the steps of the import. */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_OPTIONS_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_OPTIONS_H

#include "platform/ctl/import/import_mesh.h"
#include "platform/species/pack.h"

enum import_axis { AXIS_X, AXIS_Y, AXIS_Z, AXIS_MINUS_X, AXIS_MINUS_Y, AXIS_MINUS_Z, AXIS_NONE };

/* Options of the import. Each field *_count is the number of valid values in an array. A count of 0
 * means that the option is absent. */
struct import_options {
    const char *id;
    uint8_t front, up;             /* Directions of the snout (`front`) and of the back (`up`) in
                                      the file (enum import_axis). If `front` is AXIS_NONE, the
                                      direction is detected. */
    uint8_t measure, motion, form; /* Values as in struct species_card. 255 selects the value of the
                                      species `like`, or the default if `like` is null. */
    uint8_t template_id;           /* Template of the deformation graph (enum graph_template).
                                      TEMPLATE_OWN selects the graph of the file. */
    uint32_t name_count, length_count, age_count, growth_count, colour_count;
    char names[MORPH_KEY_MAX][SPECIES_NAME_SIZE];
    double lengths_mm[MORPH_KEY_MAX], ages_days[MORPH_KEY_MAX];
    double growth[5];           /* Parameters of the growth curve in the order LENGTH_INF_MM, K, T0,
                                   HATCH_MM, FADE_YEAR. */
    uint32_t colours[5];        /* Colours of the back, the flank, the belly, the fins and the iris,
                                   as 0xRRGGBB. */
    double unit_m;              /* Length of one unit of the file in metres. */
    const struct species *like; /* Species from which life data, colours and curves are taken if the
                                   file and the options do not contain them. May be null. */
};

/* Results of the import that kingyoctl prints, for example "front -x, 426 vertices, ...". */
struct import_report {
    uint8_t front;
    float size[MORPH_KEY_MAX]; /* Size of each key shape in the unit of the file. */
    uint32_t joined_count;     /* Number of vertices that were merged with other vertices. */
    float graph_error;         /* Greatest difference between the weights of the deformation graph
                                  and the animation of the file. */
    uint32_t knot_count;       /* Number of knots of the deformation graph that approximate the
                                  animation of the file. 0 means that the file has no animation. */
};

/* Rotates `mesh` to the axes of Kingyo (snout to -z, back to +y), and scales each key shape to
 * the size 1 in the length measure of the options. Returns EXIT_OK. If the orientation or the
 * size cannot be detected, writes the reason to `why`, without the file name, and returns
 * EXIT_BAD_DATA. */
enum exit_code import_orient(struct import_mesh *mesh, const struct import_options *plan,
                             struct import_report *report, char why[IMPORT_WHY_SIZE]);

/* Builds the near and the far body mesh of a species from an oriented mesh. Does not validate the
 * species. Returns EXIT_OK. After an error, writes the reason to `why` and returns another exit
 * code. */
enum exit_code import_build(const struct import_mesh *mesh, struct species_slot *slot,
                            struct import_report *report, char why[IMPORT_WHY_SIZE]);

/* Fills the species card and the colours of the species in `slot`. Returns EXIT_OK. After an error,
 * writes the reason to `why` and returns EXIT_BAD_DATA. */
enum exit_code import_life(const struct import_mesh *mesh, const struct import_options *plan,
                           struct species_slot *slot, struct import_report *report,
                           char why[IMPORT_WHY_SIZE]);

/* Applies the options to `card`, the species card of a template that was fitted to meshes. The
 * options set the id, names, lengths, ages and growth. Returns EXIT_OK. After an error, writes the
 * reason to `why` and returns EXIT_BAD_DATA. */
enum exit_code import_fitted_life(const struct import_options *plan, struct species_card *card,
                                  char why[IMPORT_WHY_SIZE]);

/* Returns the part of the fish to which a group of triangles belongs, as detected from words in the
 * group's name. For example, "Fin_dorsal.L" is the dorsal fin. A name without a known word is the
 * body. */
enum species_part import_part(const char *group);

extern const char *const import_axis_names[AXIS_NONE];

#endif
