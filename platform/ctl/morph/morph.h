/* morph.h -- the subcommands of `kingyoctl morph`, which show and convert fish of any age.
 *
 * Each subcommand has one row in the table of morph.c. */
#pragma once

#include "platform/ctl/lib/ctl.h"

struct morph_options;

struct morph_command {
    const char *name; /* Name of the subcommand, for example "weights". */
    /* Arguments in the form of the usage line, for example "SPECIES|FILE [--steps N]". */
    const char *words;
    const char *summary;                /* Summary of the subcommand in one line. */
    const struct option_table *options; /* Options that --help lists, or null. */
    /* Groups of options that the subcommand accepts (enum morph_requirement). */
    uint32_t groups;
    const char *usage; /* Further text that --help prints after the options. */
    /* Target of the options, whose first member is the structure. morph.c parses the options before
     * it calls `run_fish`. Null if `run` parses its own options. */
    struct morph_options *plan;
    enum exit_code (*run_fish)(void);
    /* Runs a subcommand without `plan`. argv[0] is the first argument after the subcommand's name.
     * The caller of `run` has already handled --help. */
    enum exit_code (*run)(int argc, const char *const *argv);
};

extern const struct morph_command ctl_morph_check, ctl_morph_export, ctl_morph_graph,
    ctl_morph_growth, ctl_morph_import, ctl_morph_list, ctl_morph_path, ctl_morph_weights;
/* The subcommand `kingyoctl morph refit`, which is defined in platform/ctl/import. */
extern const struct morph_command ctl_morph_refit;

/* Prints one line, "kingyoctl morph COMMAND: ...", to standard error and returns `code`. */
__attribute__((format(printf, 3, 4))) enum exit_code
morph_fail(enum exit_code code, const char *command, const char *format, ...);

/* Prints an error in the arguments of `command` as morph_fail() does. Returns EXIT_USAGE. */
#define morph_usage(command, ...) morph_fail(EXIT_USAGE, command, __VA_ARGS__)

/* Reports that `path` was written. `error` is 0 or a negative errno. Returns EXIT_OK if `error` is
 * 0. Otherwise prints one line with the path and the reason, and returns EXIT_IO. */
enum exit_code morph_written(const char *command, const char *path, int error);
