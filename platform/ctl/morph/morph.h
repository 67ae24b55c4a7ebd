/* morph.h -- the subcommands of `kingyoctl morph`, which show and convert fish of any age.
 *
 * Each subcommand has one row in the table of morph.c. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_H

#include "platform/ctl/lib/ctl.h"

struct morph_command {
    const char *name; /* Name of the subcommand, for example "weights". */
    /* Arguments in the form of the usage line, for example "SPECIES|FILE [--steps N]". */
    const char *words;
    const char *summary;                /* Summary of the subcommand in one line. */
    const struct option_table *options; /* Options that --help lists, or null. */
    uint32_t groups;                    /* Groups of options that the subcommand accepts (enum
                                           morph_requirement). */
    const char *usage;                  /* Further text that --help prints after the options. */
    /* Runs the subcommand. argv[0] is the first argument after the subcommand's name. The caller of
     * `run` has already handled --help. */
    enum exit_code (*run)(int argc, const char *const *argv);
};

extern const struct morph_command ctl_morph_check;
extern const struct morph_command ctl_morph_export;
extern const struct morph_command ctl_morph_graph;
extern const struct morph_command ctl_morph_growth;
extern const struct morph_command ctl_morph_import;
extern const struct morph_command ctl_morph_list;
extern const struct morph_command ctl_morph_path;
extern const struct morph_command ctl_morph_refit; /* The subcommand `kingyoctl morph refit`, which
                                                      is defined in platform/ctl/import. */
extern const struct morph_command ctl_morph_weights;

/* Prints one line, "kingyoctl morph COMMAND: ...", to standard error and returns EXIT_USAGE. */
__attribute__((format(printf, 2, 3))) enum exit_code morph_usage(const char *command,
                                                                 const char *format, ...);

/* Prints one line, "kingyoctl morph COMMAND: ...", to standard error and returns `code`. Used for
 * errors of a file, of memory or of the data. */
__attribute__((format(printf, 3, 4))) enum exit_code
morph_fail(enum exit_code code, const char *command, const char *format, ...);

#endif
