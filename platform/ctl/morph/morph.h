/* morph.h -- the subcommands of `kingyoctl morph`. Each subcommand has its own file and one row in
 * the table of morph.c. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_H

#include "platform/ctl/lib/ctl.h"

struct morph_command {
    const char *name; /* Subcommand name, for example "weights". */
    /* Arguments as the usage line shows them, for example "SPECIES|FILE [--steps N]". */
    const char *words;
    const char *summary; /* Summary in one line. */
    const char *usage;   /* Further text that `kingyoctl morph NAME --help` prints. */
    /* Runs the subcommand. argv[0] is the first word after the subcommand's name. The caller has
     * already handled --help. */
    enum exit_code (*run)(int argc, const char *const *argv);
};

extern const struct morph_command ctl_morph_check;
extern const struct morph_command ctl_morph_export;
extern const struct morph_command ctl_morph_graph;
extern const struct morph_command ctl_morph_growth;
extern const struct morph_command ctl_morph_import;
extern const struct morph_command ctl_morph_list;
extern const struct morph_command ctl_morph_path;
extern const struct morph_command ctl_morph_weights;

/* Prints one line, "kingyoctl morph COMMAND: ...", to standard error and returns EXIT_USAGE. */
__attribute__((format(printf, 2, 3))) enum exit_code morph_usage(const char *command,
                                                                 const char *format, ...);

/* Prints one line, "kingyoctl morph COMMAND: ...", to standard error and returns `code`. Use this
 * function for errors of a file, a disk or the data. */
__attribute__((format(printf, 3, 4))) enum exit_code
morph_fail(enum exit_code code, const char *command, const char *format, ...);

#endif
