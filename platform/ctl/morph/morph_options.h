/* morph_options.h -- selects the fish of a `kingyoctl morph` subcommand: a built-in species or a
 * maker's file, the curves, and the moment of its life.
 *
 * Every subcommand parses its arguments with this module. Therefore SPECIES|FILE, --template,
 * --thesis, --progress, --age-days and --length-mm have the same meaning and the same errors in all
 * subcommands. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_OPTIONS_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_OPTIONS_H

#include <stddef.h>

#include "core/morph/morph.h"
#include "platform/ctl/morph/morph.h"
#include "platform/species/pack.h"

/* An option of one subcommand. Exactly one of the pointers is not null and receives the value. The
 * target keeps its value if the option is absent. */
struct morph_option {
    const char *name; /* Name of the option, for example "--steps". */
    bool *flag;
    const char **text; /* Receives a text that is not empty. */
    uint32_t *count;   /* Receives a whole number in [min, max]. */
    double *number;    /* Receives a decimal number in [min, max]. */
    double min, max;
};

enum morph_requirement {
    MORPH_REQUIRES_FISH = 0,   /* The subcommand takes only SPECIES|FILE. */
    MORPH_REQUIRES_CURVES = 1, /* The subcommand also takes --template and --thesis. */
    /* The subcommand also takes --template, --thesis, and one of --progress, --age-days and
     * --length-mm. */
    MORPH_REQUIRES_PLACE = 2,
};

struct morph_options {
    const char *word;            /* SPECIES|FILE as the user wrote it. */
    const struct species *drawn; /* Species with all its keys, parts and anchors. */
    const struct species *fish;  /* Species after --thesis and --template ordinary were applied. */
    struct morph_rig rig;        /* Rig of `fish`. */
    /* Template of the graph. TEMPLATE_OWN unless --template selects another. */
    enum graph_template template_id;
    bool thesis;
    /* True if --progress, --age-days or --length-mm was given. Otherwise progress is 0. */
    bool has_place;
    float progress; /* Progress of the fish's life, in [0, 1]. */
};

/* Returns a template's name as --template expects it. */
const char *morph_template_name(enum graph_template template_id);

/* Parses the arguments of the subcommand `command` (for example "weights"): one SPECIES|FILE and
 * options in any order. Returns EXIT_OK, or prints one line to standard error and returns another
 * code. An age or a length outside the drawn life is rejected with its range. The objects that
 * `pick` points to are static, so only one fish is valid at a time. */
enum exit_code morph_options_read(struct morph_options *pick, const char *command,
                                  enum morph_requirement asks, const struct morph_option *options,
                                  size_t option_count, int argc, const char *const *argv);

/* Reads a maker's file into `slot`. A file NAME.kfish is read as a packed species, and any other
 * file as a species text, which is lofted to a mesh. Returns EXIT_OK, or prints one line to
 * standard error and returns another code. */
enum exit_code morph_options_file(const char *path, const char *command, struct species_slot *slot);

/* Sets `pick->drawn` to the built-in species or the file that `pick->word` names. Returns EXIT_OK,
 * or prints one line to standard error and returns another code. */
enum exit_code morph_options_open(struct morph_options *pick, const char *command);

/* Prints that `word` is not a species, with the list of species. Returns EXIT_USAGE. */
enum exit_code morph_options_unknown(const char *command, const char *word);

/* Returns `fish` under ordinary morphing (eq. 3.1), with only its first and last keys and linear
 * weights. The returned object is static. */
const struct species *morph_options_ordinary(const struct morph_options *pick,
                                             struct morph_rig *rig);

/* Computes the least and the greatest length of the drawn life, in metres. The greatest length
 * corresponds to a growth scale of 1. */
void morph_options_lengths(const struct species_card *card, float *min, float *max);

#endif
