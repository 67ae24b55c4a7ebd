/* morph_pick.h -- which fish a subcommand of `kingyoctl morph` is about: a built-in species or a
 * maker's file, by whose curves, and at which moment of its life.
 *
 * Every subcommand reads its words through here, so that SPECIES|FILE, --template, --thesis and
 * --progress, --age-days and --length-mm mean the same to all of them and are refused alike. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_PICK_H
#define KINGYO_PLATFORM_CTL_MORPH_PICK_H

#include <stddef.h>

#include "core/morph/morph.h"
#include "platform/ctl/morph.h"
#include "platform/species/pack.h"

/* An option of a subcommand's own. Exactly one of the pointers is not null: what the option sets;
 * it keeps its value where the option is not given. */
struct morph_option {
    const char *name; /* "--steps" */
    bool *flag;
    const char **text; /* Not empty. */
    uint32_t *count;   /* A whole number in [min, max]. */
    double *number;    /* A decimal in [min, max]. */
    double min, max;
};

enum morph_asks {
    MORPH_ASKS_FISH = 0,   /* SPECIES|FILE alone. */
    MORPH_ASKS_CURVES = 1, /* And --template and --thesis ... */
    MORPH_ASKS_PLACE = 2,  /* ... and --progress, --age-days or --length-mm. */
};

struct morph_pick {
    const char *word;             /* SPECIES|FILE as it was written. */
    const struct species *drawn;  /* With all its keys, parts and anchors. */
    const struct species *fish;   /* What --thesis and --template ordinary leave of it. */
    struct morph_rig rig;         /* Of `fish`. */
    enum graph_template template; /* TEMPLATE_OWN unless --template says otherwise. */
    bool thesis;
    bool has_place; /* One of the three was given; else progress is 0. */
    float progress; /* [0, 1] */
};

/* How --template's words are written. */
const char *morph_template_name(enum graph_template template);

/* Reads the words of `command` ("weights"): one SPECIES|FILE and, in any order, options. EXIT_OK,
 * or another code, told in one line: an age or a length that the drawn life does not have is
 * refused with its range. What `pick` points to is static here: one fish at a time. */
enum exit_code morph_pick_read(struct morph_pick *pick, const char *command, enum morph_asks asks,
                               const struct morph_option *options, size_t option_count, int argc,
                               const char *const *argv);

/* Reads a maker's file into `slot`: NAME.kfish as packed, anything else as text, lofted. EXIT_OK,
 * or another code, told in one line. */
enum exit_code morph_pick_file(const char *path, const char *command, struct species_slot *slot);

/* Sets what `pick->word` draws: a built-in species, or a file's. EXIT_OK, or another code, told. */
enum exit_code morph_pick_open(struct morph_pick *pick, const char *command);

/* That `word` names no species, with those that there are; EXIT_USAGE. */
enum exit_code morph_pick_unknown(const char *command, const char *word);

/* `fish` as the ordinary morph would have it (eq. 3.1): its first and its last key, straight. The
 * answer is static. */
const struct species *morph_pick_ordinary(const struct morph_pick *pick, struct morph_rig *rig);

/* The least and the greatest length of its drawn life, m; the latter is what a scale of 1 is. */
void morph_pick_lengths(const struct species_card *card, float *min, float *max);

#endif
