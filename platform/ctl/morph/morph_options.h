/* morph_options.h -- parses the options that select a fish: a built-in species or a file, the
 * curves of its growth, and the moment of its life.
 *
 * Every subcommand of `kingyoctl morph` uses this parser. Therefore SPECIES|FILE, --template,
 * --thesis, --progress, --age-days and --length-mm have the same meaning and the same error
 * messages in all subcommands. */
#pragma once

#include <stdint.h>

#include "core/morph/morph.h"
#include "platform/ctl/morph/morph.h"
#include "platform/species/pack.h"

enum morph_requirement {
    MORPH_REQUIRES_FISH = 0,   /* The subcommand accepts only SPECIES|FILE. */
    MORPH_REQUIRES_CURVES = 1, /* The subcommand accepts SPECIES|FILE, --template and --thesis. */
    /* The subcommand accepts SPECIES|FILE, --template, --thesis, and one of --progress, --age-days
     * and --length-mm. */
    MORPH_REQUIRES_PLACE = 2,
};

struct morph_options {
    /* Argument SPECIES|FILE as the user wrote it: the name of a built-in species or the path of a
     * species file. */
    const char *word;
    /* Species as its author drew it, with all keys (growth stages), parts and anchors. */
    const struct species *drawn;
    /* Species after --thesis and --template ordinary were applied to `drawn`. */
    const struct species *fish;
    /* Animation rig of `fish`: the weights of the keys over its life. */
    struct morph_rig rig;
    /* Template of the deformation graph, as --template selects it (enum graph_template).
     * TEMPLATE_OWN if the option is absent. */
    uint8_t template_id;
    bool thesis;
    /* True if --progress, --age-days or --length-mm was given. False means that progress is 0. */
    bool has_place;
    double place[3]; /* Values of --progress, --age-days and --length-mm. NaN means absent. */
    float progress;  /* Progress of the fish's life, from 0 (first key) to 1 (last key). */
};

/* Returns the name of a template, as --template accepts it. */
const char *morph_template_name(enum graph_template template_id);

/* The table of the options that all subcommands share. The groups of the options are enum
 * morph_requirement. A subcommand with further options has struct morph_options as the first member
 * of its own structure, and this table as the base of its own table. */
extern const struct option_table morph_options_table;

/* Pointer to a table of the array `rows` whose base is the table of the shared options. */
#define MORPH_OPTION_TABLE(rows)                                                                   \
    &(const struct option_table)                                                                   \
    {                                                                                              \
        rows, sizeof rows / sizeof rows[0], &morph_options_table                                   \
    }

/* Parses the arguments of the subcommand `command` with `table`, for example "weights". The
 * arguments are one SPECIES|FILE and options in any order. `groups` are the groups of options that
 * the subcommand accepts (enum morph_requirement). Returns EXIT_OK, or prints one line to
 * standard error and returns another exit code.
 *
 * An age or a length outside the drawn life is an error, and the message contains the allowed
 * range. The objects to which `pick` points are static, so only one fish is valid at a time. */
enum exit_code morph_options_read(struct morph_options *pick, const char *command, uint32_t groups,
                                  const struct option_table *table, int argc,
                                  const char *const *argv);

/* Reads a species file into `slot`. A file NAME.kfish is read as a packed species. Any other file
 * is read as a species text, from which the mesh is lofted. Returns EXIT_OK, or prints one line to
 * standard error and returns another exit code. */
enum exit_code morph_options_file(const char *path, const char *command, struct species_slot *slot);

/* Sets `pick->drawn` to the built-in species or to the species file that `pick->word` names.
 * Returns EXIT_OK, or prints one line to standard error and returns another exit code. */
enum exit_code morph_options_open(struct morph_options *pick, const char *command);

/* Returns `pick->fish` reduced to ordinary morphing (2005 thesis, eq. 3.1), with only the first and
 * the last key and linear weights. Also initializes `rig`. The returned object is static. */
const struct species *morph_options_ordinary(const struct morph_options *pick,
                                             struct morph_rig *rig);

/* Computes the least and the greatest length of the drawn life, in metres. At the greatest length,
 * the growth scale is 1. */
void morph_options_lengths(const struct species_card *card, float *min, float *max);

/* Sets `*curve` to the index of the curve `curve_name` of the deformation graph, as --curve
 * gives the name. A curve states how the weights of the key shapes change during a fish's life.
 * Null selects the curve of the whole fish. Returns EXIT_OK. If the curve does not exist, prints
 * one line and returns EXIT_USAGE. */
enum exit_code morph_curve_find(const struct species_card *card, const char *command,
                                const char *curve_name, uint32_t *curve);
