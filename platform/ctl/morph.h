/* morph.h -- the subcommands of `kingyoctl morph`. One file per subcommand, one line in the table
 * of morph.c. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_H
#define KINGYO_PLATFORM_CTL_MORPH_H

#include "platform/ctl/ctl.h"

struct morph_command {
    const char *name;    /* "weights" */
    const char *words;   /* What stands behind the name: "SPECIES|FILE [--steps N]" */
    const char *summary; /* One line. */
    const char *usage;   /* What `kingyoctl morph NAME --help` prints further. */
    /* argv[0] is the first word behind the subcommand's name; --help was already answered. */
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

/* One line on standard error, "kingyoctl morph COMMAND: ...", and EXIT_USAGE. */
__attribute__((format(printf, 2, 3)))
enum exit_code morph_usage(const char *command, const char *format, ...);

/* The same for what a file, a disk or the data is to blame for; answers `code`. */
__attribute__((format(printf, 3, 4)))
enum exit_code morph_fail(enum exit_code code, const char *command, const char *format, ...);

#endif
